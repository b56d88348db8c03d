//! `[track]` → stack and contact, with every fault at its key.

use super::changed::overlay;
use super::error::Finding;
use super::loader::Resolved;
use super::read;
use super::schema::{LoadInput, SupportInput, TrackInput};
use super::units::METRE;
use crate::quantity::positive;
use crate::railway::Contact;
use crate::track::{Layout, Rails, Section, Stack, Supports, Track, TrackError};

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
fn fault(error: TrackError, path: &str, at: &dyn Fn(&str) -> String) -> Finding {
    const SPEEDS: &str = "give wave_speed, or density (with poisson for the constrained modulus)";
    match error {
        TrackError::OutOfRange(error) => Finding::out_of_range(path, error),
        TrackError::SubBallast(error) => {
            let table = at("sub_ballast");
            let mut finding = fault(*error, path, &at);
            finding.path = finding.path.replacen(&at("ballast"), &table, 1);
            finding
        }
        TrackError::SpacingMissing => Finding::new(path, error)
            .help("add sleeper.spacing or support.spacing, or spacing beside the piece [m]"),
        TrackError::ContactWidth => Finding::new(at("ballast"), error).help("add track.contact.half_width"),
        TrackError::WaveSpeedMissing => Finding::new(at("ballast"), error).help(SPEEDS),
        TrackError::WaveSpeedTwice => Finding::new(at("ballast.wave_speed"), error).help(SPEEDS),
        TrackError::RailsMissing => Finding::new(path, error)
            .help("add rails = 1 for one rail and its share of the track, or rails = 2 for the whole track"),
        TrackError::Rails { .. } => Finding::new(at("rails"), error),
        TrackError::NoRail => Finding::new(at("support"), error),
        TrackError::NothingToJoin => Finding::new(at("ballast.link"), error),
        // of one frequency, of modes
        TrackError::NoStatics { .. } | TrackError::Pushes { .. } | TrackError::Modes { .. } => {
            Finding::new(path, error)
        }
    }
}

/// Layout of `[track]` and its contact with what carries it, `on` ground or springs; on ground a contact is needed.
pub fn track(resolved: &Resolved<TrackInput>, on: Carried) -> Result<(Layout, Option<Contact>), Finding> {
    let Resolved { table: input, prefix: path, .. } = resolved;
    let on_ground = on == Carried::Ground;
    let at = |rest: &str| resolved.at(rest);
    if input.track == Track::None {
        if let Some(key) = [("support", input.support.is_some()), ("section", !input.section.is_empty())]
            .iter()
            .find_map(|(key, given)| given.then_some(key))
        {
            return Err(Finding::new(at(key), "without a track there are no supports")
                .help("remove it, or give the track"));
        }
        let contact = bare(input, path, on_ground)?;
        return Ok((Stack::default().into(), Some(contact)));
    }
    if input.load.is_some() {
        return Err(Finding::new(at("load"), "only a track of kind = \"none\" has a `load`")
            .help("axles press on the rail: remove it, or the track"));
    }
    if input.contact.is_none() && on_ground {
        return Err(Finding::new(path, "missing key `contact`: how the track touches the ground")
            .help("add contact.half_width = … [m] and contact.compatibility = \"centre\" or \"mean\""));
    }
    if on_ground && input.track.rails() == Rails::One {
        return Err(Finding::new(at("rails"), "the ground carries both rails").help(
            "give the numbers of the whole track, rails = 2: half of it on the whole ground would be neither",
        ));
    }
    let contact = input.contact.map(Contact::Strip);
    if input.section.is_empty() {
        return Ok((layout(input, path, on)?, contact));
    }
    Ok((Layout::Varying(sections(resolved, on)?), contact))
}

/// What loads the ground without a track.
fn bare(input: &TrackInput, path: &str, on_ground: bool) -> Result<Contact, Finding> {
    let at = |rest: &str| if path.is_empty() { rest.to_owned() } else { format!("{path}.{rest}") };
    if !on_ground {
        return Err(Finding::new(at("kind"), "springs need a track on them")
            .help("allowed with [foundation]: ballasted, slab, beam"));
    }
    match (input.load, input.contact) {
        (Some(input), None) => load(input, &at("load")),
        (None, Some(strip)) => Ok(Contact::Strip(strip)),
        (Some(_), Some(_)) => Err(Finding::new(at("contact"), "load and contact are both given").help(
            "load is how each axle presses on the ground, contact the strip of [equivalent_stiffness] alone: remove one of them",
        )),
        (None, None) => Err(Finding::new(path, "a track of kind = \"none\" needs `load`").help(
            "add load.kind = \"point\" or \"patch\", or contact for [equivalent_stiffness] alone; without [track] the ground \
             is alone",
        )),
    }
}

/// What carries a track.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Carried {
    /// Layered ground.
    Ground,
    /// Springs whose neighbours feel one another.
    Joined,
    /// Springs each for itself, or rock.
    Apart,
}

/// A track of one kind all along.
fn layout(input: &TrackInput, path: &str, on: Carried) -> Result<Layout, Finding> {
    let at = |rest: &str| if path.is_empty() { rest.to_owned() } else { format!("{path}.{rest}") };
    let half_width = input.contact.map(|strip| strip.half_width);
    let track = match (input.support, input.track.spacing()) {
        (Some(SupportInput { spacing, .. }), Some(own)) if own != spacing => {
            let message = format!("sleepers {own} m apart on supports {spacing} m apart");
            return Err(Finding::new(at("sleeper.spacing"), message).help("remove it: supports are sleepers"));
        }
        (Some(SupportInput { spacing, .. }), None) => input.track.spaced(spacing),
        _ => input.track,
    };
    let stack = track.stack(half_width).map_err(|error| fault(error, path, &at))?;
    let between = input.track.between();
    let Some(SupportInput { spacing, width }) = input.support else {
        return match between {
            Some(_) => Err(Finding::new(
                at("ballast.link"),
                "it joins the blocks under neighbouring supports",
            )
            .help(
                "add support.spacing; springs along a continuous track are those of a Pasternak foundation",
            )),
            None => Ok(stack.into()),
        };
    };
    if matches!(input.track, Track::Slab(_)) {
        return Err(Finding::new(at("support"), "supports stand apart under ballasted tracks and beams")
            .help("a slab carries its rails all along: remove it"));
    }
    match (on, width) {
        (Carried::Ground | Carried::Joined, None) => {
            return Err(Finding::new(
                at("support"),
                "missing key `width`: neighbouring supports feel one another through the ground",
            )
            .help("add support.width = … [m], the width of a sleeper along the track, such as 0.25"));
        }
        (Carried::Apart, Some(_)) => {
            return Err(Finding::new(at("support.width"), "every support has springs of its own").help(
                "remove it: [foundation] of this kind is per metre, and each support has spacing × that",
            ));
        }
        _ => {}
    }
    if width.is_some_and(|width| width > spacing) {
        return Err(Finding::new(
            at("support.width"),
            format!("found {} m, more than the spacing of {spacing} m", width.unwrap_or(f64::NAN)),
        )
        .help("sleepers do not overlap"));
    }
    Supports::new(&stack, spacing, width, between)
        .map(Layout::Discrete)
        .map_err(|error| fault(error, path, &at))
}

/// The sections of `[track]`: its own table with what each changes.
fn sections(resolved: &Resolved<TrackInput>, on: Carried) -> Result<Vec<Section>, Finding> {
    let changes = &resolved.table.section;
    if changes.len() < 2 {
        return Err(Finding::new(resolved.at("section"), "one section is no change").help(
            "give two or more [[track.section]], the first and the last without a length: they never end",
        ));
    }
    let unread = |error: &dyn std::fmt::Display| Finding::new(resolved.at(""), error);
    let document: toml::Table = resolved.read.parse().map_err(|error: toml::de::Error| unread(&error))?;
    let mut own = match resolved.prefix.as_str() {
        "" => document,
        prefix => match document.get(prefix) {
            Some(toml::Value::Table(own)) => own.clone(),
            _ => return Err(unread(&"sections need the keys of the track in a table")),
        },
    };
    own.remove("section");
    let all = changes.iter().enumerate();
    all.map(|(i, change)| {
        let path = resolved.at(&format!("section[{i}]"));
        section(&own, change, &path, (i == 0 || i + 1 == changes.len(), on))
    })
    .collect()
}

/// The length [m] that `value` says at `at`.
fn metres(value: &toml::Value, at: &str) -> Result<f64, Finding> {
    match value {
        toml::Value::Float(length) => Ok(*length),
        toml::Value::Integer(length) => Ok(*length as f64),
        toml::Value::String(text) => {
            METRE.read(text).map_err(|(message, help)| Finding::new(at, message).help(help))
        }
        other => Err(Finding::new(at, format!("found {other}, wanted a number"))),
    }
}

/// One section: the keys of `own` as `change`d, at `path`; `endless` ones have no length.
fn section(
    own: &toml::Table,
    change: &toml::Table,
    path: &str,
    (endless, on): (bool, Carried),
) -> Result<Section, Finding> {
    let mut change = change.clone();
    for key in ["section", "contact", "load", "title", "source"] {
        if change.contains_key(key) {
            return Err(
                Finding::new(format!("{path}.{key}"), "it is of the whole track").help("give it in [track]")
            );
        }
    }
    let length = change.remove("length");
    let mut table = own.clone();
    overlay(&mut table, change);
    let text = table.to_string();
    let below = |finding: Finding| finding.below(path);
    let document = toml::de::DeTable::parse(&text).map_err(|error| Finding::new(path, error))?.into_inner();
    let input: TrackInput = read::of_table(&document, "track").map_err(below)?;
    let supports = match layout(&input, "", on).map_err(below)? {
        Layout::Discrete(supports) => supports,
        _ => {
            return Err(
                Finding::new(path, "sections stand on supports").help("add support.spacing to [track]")
            );
        }
    };
    let at = format!("{path}.length");
    let length = length.map(|length| metres(&length, &at)).transpose()?;
    let bays = match (endless, length) {
        (true, None) => None,
        (true, Some(_)) => {
            return Err(Finding::new(at, "the first and the last section never end").help("remove it"));
        }
        (false, None) => {
            return Err(Finding::new(path, "missing key `length`")
                .help("only the first and the last section never end"));
        }
        (false, Some(length)) => {
            let bays = length / supports.spacing;
            // decimals of the file: 6 m are ten bays of 0.6 m
            if !(bays > 0.5 && (bays - bays.round()).abs() < 1e-6) {
                let message =
                    format!("found {length} m: it must be one or more whole bays of {} m", supports.spacing);
                return Err(Finding::new(at, message));
            }
            Some(bays.round() as usize)
        }
    };
    Ok(Section { bays, supports })
}
