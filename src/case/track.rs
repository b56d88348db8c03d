//! `[track]` → stack and contact, with every fault at its key.

use super::error::Finding;
use super::schema::{LoadInput, TrackInput};
use crate::quantity::positive;
use crate::soil::{Compatibility, Strip};
use crate::study::Contact;
use crate::track::{Stack, Track, TrackError};

fn load(input: LoadInput, path: &str) -> Result<Contact, Finding> {
    match input {
        LoadInput::Point => Ok(Contact::Point),
        LoadInput::Patch { half_length, strip } => {
            let refused = |e| Finding::out_of_range(path, e);
            Ok(Contact::Patch {
                half_length: positive("half_length", half_length, "m").map_err(refused)?,
                strip,
            })
        }
    }
}

/// Why a track cannot be built, at its key; `at` is the path of a key of the table at `path`.
fn fault(error: TrackError, path: &str, at: impl Fn(&str) -> String) -> Finding {
    const SPEEDS: &str = "give wave_speed, or density (with poisson for the constrained modulus)";
    match error {
        TrackError::OutOfRange(error) => Finding::out_of_range(path, error),
        TrackError::ContactWidth => Finding::new(at("ballast"), error).help("add track.contact.half_width"),
        TrackError::WaveSpeedMissing => Finding::new(at("ballast"), error).help(SPEEDS),
        TrackError::WaveSpeedTwice => Finding::new(at("ballast.wave_speed"), error).help(SPEEDS),
    }
}

/// Stack and contact of `[track]`; `path` is where the table stands; on ground a contact is needed.
pub fn track(input: &TrackInput, path: &str, on_ground: bool) -> Result<(Stack, Contact), Finding> {
    let at = |rest: &str| if path.is_empty() { rest.to_owned() } else { format!("{path}.{rest}") };
    let stack = |strip: Option<Strip>| {
        input.track.stack(strip.map(|s| s.half_width)).map_err(|error| fault(error, path, at))
    };
    if input.track == Track::None {
        if !on_ground {
            return Err(Finding::new(at("kind"), "springs need a track on them")
                .help("allowed with [foundation]: ballasted, slab, beam"));
        }
        if input.contact.is_some() {
            return Err(Finding::new(at("contact"), "a track of kind = \"none\" has no `contact`")
                .help("its axles touch the ground: load.kind = \"point\" or \"patch\""));
        }
        let Some(input) = input.load else {
            return Err(Finding::new(path, "missing key `load`, needed by kind = \"none\"")
                .help("add load.kind = \"point\" or \"patch\""));
        };
        return Ok((stack(None)?, load(input, &at("load"))?));
    }
    if input.load.is_some() {
        return Err(Finding::new(at("load"), "only a track of kind = \"none\" has a `load`")
            .help("axles press on the rail: remove it, or the track"));
    }
    if input.contact.is_none() && on_ground {
        return Err(Finding::new(path, "missing key `contact`: how the track touches the ground")
            .help("add contact.half_width = … [m] and contact.compatibility = \"centre\" or \"mean\""));
    }
    // on springs the contact width means nothing; a strip keeps the type simple
    let made_up = Strip { half_width: 1.0, compatibility: Compatibility::Centre };
    Ok((stack(input.contact)?, Contact::Strip(input.contact.unwrap_or(made_up))))
}
