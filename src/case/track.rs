//! `[track]` → stack and contact, with every fault at its key.

use super::error::Finding;
use super::schema::{LoadInput, TrackInput};
use crate::quantity::positive;
use crate::railway::Contact;
use crate::soil::Strip;
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
        TrackError::RailsMissing => Finding::new(path, error)
            .help("add rails = 1 for one rail and its share of the track, or rails = 2 for the whole track"),
        TrackError::Rails { .. } => Finding::new(at("rails"), error),
        // of one frequency, of modes
        TrackError::NoStatics { .. } | TrackError::Pushes { .. } | TrackError::Modes { .. } => {
            Finding::new(path, error)
        }
    }
}

/// Stack of `[track]` and its contact with the ground; `path` is where the table stands; on ground a
/// contact is needed.
pub fn track(input: &TrackInput, path: &str, on_ground: bool) -> Result<(Stack, Option<Contact>), Finding> {
    let at = |rest: &str| if path.is_empty() { rest.to_owned() } else { format!("{path}.{rest}") };
    let stack = |strip: Option<Strip>| {
        input.track.stack(strip.map(|s| s.half_width)).map_err(|error| fault(error, path, at))
    };
    if input.track == Track::None {
        if !on_ground {
            return Err(Finding::new(at("kind"), "springs need a track on them")
                .help("allowed with [foundation]: ballasted, slab, beam"));
        }
        let contact = match (input.load, input.contact) {
            (Some(input), None) => load(input, &at("load"))?,
            (None, Some(strip)) => Contact::Strip(strip),
            (Some(_), Some(_)) => {
                return Err(Finding::new(at("contact"), "load and contact are both given").help(
                    "load is how each axle presses on the ground, contact the strip of [equivalent_stiffness] alone: remove one of them",
                ));
            }
            (None, None) => {
                return Err(Finding::new(path, "a track of kind = \"none\" needs `load`").help(
                    "add load.kind = \"point\" or \"patch\", or contact for [equivalent_stiffness] alone; without [track] the ground \
                     is alone",
                ));
            }
        };
        return Ok((stack(None)?, Some(contact)));
    }
    if input.load.is_some() {
        return Err(Finding::new(at("load"), "only a track of kind = \"none\" has a `load`")
            .help("axles press on the rail: remove it, or the track"));
    }
    if input.contact.is_none() && on_ground {
        return Err(Finding::new(path, "missing key `contact`: how the track touches the ground")
            .help("add contact.half_width = … [m] and contact.compatibility = \"centre\" or \"mean\""));
    }
    Ok((stack(input.contact)?, input.contact.map(Contact::Strip)))
}
