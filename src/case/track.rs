//! `[track]` → stack and contact, with every fault at its key.

use super::error::Finding;
use super::schema::{CompatibilityInput, ContactInput, LoadInput, LoadKind, TrackInput};
use crate::quantity::positive;
use crate::soil::{Compatibility, Strip};
use crate::study::Contact;
use crate::track::{Stack, Track, TrackError};

/// The value of a key that this kind of track needs.
fn need<'a, T>(value: &'a Option<T>, path: &str, key: &str, kind: &str) -> Result<&'a T, Finding> {
    value.as_ref().ok_or_else(|| {
        Finding::new(path, format!("missing key `{key}`, needed by kind = \"{kind}\""))
            .help(format!("add `{key} = …`"))
    })
}

fn compatibility(input: CompatibilityInput) -> Compatibility {
    match input {
        CompatibilityInput::Centre => Compatibility::Centre,
        CompatibilityInput::Mean => Compatibility::Mean,
    }
}

fn length(key: &'static str, value: f64, path: &str) -> Result<f64, Finding> {
    positive(key, value, "m").map_err(|e| Finding::out_of_range(path, e))
}

fn contact(input: &ContactInput, path: &str) -> Result<Strip, Finding> {
    Ok(Strip {
        half_width: length("half_width", input.half_width, path)?,
        compatibility: compatibility(input.compatibility),
    })
}

fn load(input: &LoadInput, path: &str) -> Result<Contact, Finding> {
    match input.kind {
        LoadKind::Point => match (input.half_length, input.half_width, input.compatibility) {
            (None, None, None) => Ok(Contact::Point),
            _ => Err(Finding::new(path, "a point load has no size")
                .help("remove its size, or say kind = \"patch\"")),
        },
        LoadKind::Patch => {
            let half_length = *need(&input.half_length, path, "half_length", "patch")?;
            let half_width = *need(&input.half_width, path, "half_width", "patch")?;
            let compatible = *need(&input.compatibility, path, "compatibility", "patch")?;
            Ok(Contact::Patch {
                half_length: length("half_length", half_length, path)?,
                strip: Strip {
                    half_width: length("half_width", half_width, path)?,
                    compatibility: compatibility(compatible),
                },
            })
        }
    }
}

/// Why a track cannot be built, at its key; `at` is the path of a key of the table.
fn fault(error: TrackError, path: &str, at: impl Fn(&str) -> String) -> Finding {
    const SPEEDS: &str = "give wave_speed, or density (with poisson for the constrained modulus)";
    match error {
        TrackError::OutOfRange(error) => Finding::out_of_range(path, error),
        TrackError::ContactWidth => Finding::new(at("ballast"), error).help("add track.contact.half_width"),
        TrackError::WaveSpeedMissing => Finding::new(at("ballast"), error).help(SPEEDS),
        TrackError::WaveSpeedTwice => Finding::new(at("ballast.wave_speed"), error).help(SPEEDS),
    }
}

/// Stack and contact of `[track]`; `path` is where the table stands; on ground a contact is needed, on springs refused.
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
                .help("its keys: load"));
        }
        let load_input = need(&input.load, path, "load", "none")?;
        return Ok((stack(None)?, load(load_input, &at("load"))?));
    }
    if input.load.is_some() {
        return Err(Finding::new(at("load"), "only a track of kind = \"none\" has a `load`")
            .help("axles press on the rail: remove it, or the track"));
    }
    let strip = match (&input.contact, on_ground) {
        (Some(input), _) => Some(contact(input, &at("contact"))?),
        (None, true) => {
            return Err(Finding::new(path, "missing key `contact`: how the track touches the ground")
                .help("add contact.half_width = … [m] and contact.compatibility = \"centre\" or \"mean\""));
        }
        (None, false) => None,
    };
    // on springs the contact width means nothing; a strip keeps the type simple
    let made_up = Strip { half_width: 1.0, compatibility: Compatibility::Centre };
    Ok((stack(strip)?, Contact::Strip(strip.unwrap_or(made_up))))
}
