//! `[track]` → stack and contact, with every fault at its key.

use super::error::Finding;
use super::schema::{BallastInput, BallastKind, BeamInput, LoadInput, SpringInput, TrackInput, TrackKind};
use crate::quantity::{between, positive};
use crate::railway::Contact;
use crate::soil::Strip;
use crate::track::{Ballast, Ballasted, Link, Member, Slab, Stack, TrackError};

/// The value of a key that this kind of track needs.
fn need<'a, T>(value: &'a Option<T>, path: &str, key: &str, kind: &str) -> Result<&'a T, Finding> {
    value.as_ref().ok_or_else(|| {
        Finding::new(path, format!("missing key `{key}`, needed by kind = \"{kind}\""))
            .help(format!("add `{key} = …`"))
    })
}

/// A fault of a constructor, in the table at `path`.
fn fault(path: &str) -> impl Fn(TrackError) -> Finding {
    |TrackError::OutOfRange(error)| Finding::out_of_range(path, error)
}

fn beam(input: &BeamInput, path: &str) -> Result<Member, Finding> {
    // a member without is a mass, a beam must bend
    positive("bending_stiffness", input.bending_stiffness, "N m²")
        .map_err(|e| Finding::out_of_range(path, e))?;
    Member::beam(input.bending_stiffness, input.mass, input.loss_factor).map_err(fault(path))
}

fn spring(input: &SpringInput, path: &str) -> Result<Link, Finding> {
    Link::spring(input.stiffness, input.damping, input.loss_factor).map_err(fault(path))
}

/// C_b: as given, or √(E/ρ), or √(M/ρ) with the constrained modulus M = E(1 − ν)/((1 + ν)(1 − 2ν)).
fn wave_speed(input: &BallastInput, young: f64, path: &str) -> Result<f64, Finding> {
    match (input.wave_speed, input.density, input.poisson) {
        (Some(speed), None, None) => Ok(speed),
        (None, Some(density), poisson) => {
            let refused = |e| Finding::out_of_range(path, e);
            let density = positive("density", density, "kg/m³").map_err(refused)?;
            let nu = between("poisson", poisson.unwrap_or(0.0), "", (-1.0, 0.5)).map_err(refused)?;
            Ok((young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) / density).sqrt())
        }
        (Some(_), _, _) => Err(Finding::new(format!("{path}.wave_speed"), "the wave speed is given twice")
            .help("give wave_speed, or density (with poisson for the constrained modulus)")),
        (None, None, _) => Err(Finding::new(path, "the wave speed of the ballast is missing")
            .help("give wave_speed, or density (with poisson for the constrained modulus)")),
    }
}

fn ballast(input: &BallastInput, strip: Option<Strip>, path: &str) -> Result<Ballast, Finding> {
    let foreign: &[(&str, bool)] = match input.kind {
        BallastKind::Bars => &[
            ("stiffness", input.stiffness.is_some()),
            ("mass", input.mass.is_some()),
            ("damping", input.damping.is_some()),
        ],
        BallastKind::ConsistentMass => &[
            ("young", input.young.is_some()),
            ("height", input.height.is_some()),
            ("alpha", input.alpha.is_some()),
            ("wave_speed", input.wave_speed.is_some()),
            ("density", input.density.is_some()),
            ("poisson", input.poisson.is_some()),
        ],
    };
    let (kind, keys) = match input.kind {
        BallastKind::Bars => {
            ("bars", "young, height, alpha, wave_speed or density (and poisson), loss_factor")
        }
        BallastKind::ConsistentMass => ("consistent-mass", "stiffness, mass, damping, loss_factor"),
    };
    if let Some((key, _)) = foreign.iter().find(|(_, given)| *given) {
        return Err(Finding::new(
            format!("{path}.{key}"),
            format!("ballast of kind = \"{kind}\" has no `{key}`"),
        )
        .help(format!("its keys: {keys}")));
    }
    match input.kind {
        BallastKind::Bars => {
            let young = *need(&input.young, path, "young", kind)?;
            let Some(strip) = strip else {
                return Err(Finding::new(path, "ballast bars need the contact width")
                    .help("add track.contact.half_width"));
            };
            Ok(Ballast::Bars {
                young,
                height: *need(&input.height, path, "height", kind)?,
                alpha: *need(&input.alpha, path, "alpha", kind)?,
                wave_speed: wave_speed(input, young, path)?,
                half_width: strip.half_width,
                loss_factor: input.loss_factor,
            })
        }
        BallastKind::ConsistentMass => Ok(Ballast::ConsistentMass {
            stiffness: *need(&input.stiffness, path, "stiffness", kind)?,
            damping: input.damping.unwrap_or(0.0),
            loss_factor: input.loss_factor,
            mass: *need(&input.mass, path, "mass", kind)?,
        }),
    }
}

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

/// Stack of `[track]` and its contact with the ground; `path` is where the table stands; on ground a contact is needed, on springs refused.
pub fn track(input: &TrackInput, path: &str, on_ground: bool) -> Result<(Stack, Option<Contact>), Finding> {
    let at = |rest: &str| if path.is_empty() { rest.to_owned() } else { format!("{path}.{rest}") };
    let (kind, keys): (&str, &[&str]) = match input.kind {
        TrackKind::Ballasted => ("ballasted", &["rail", "pad", "sleeper", "ballast", "contact"]),
        TrackKind::Slab => ("slab", &["rail", "pad", "slab", "contact"]),
        TrackKind::Beam => ("beam", &["beam", "contact"]),
        TrackKind::None => ("none", &["load", "contact"]),
    };
    let given = [
        ("rail", input.rail.is_some()),
        ("pad", input.pad.is_some()),
        ("sleeper", input.sleeper.is_some()),
        ("ballast", input.ballast.is_some()),
        ("slab", input.slab.is_some()),
        ("beam", input.beam.is_some()),
        ("contact", input.contact.is_some()),
        ("load", input.load.is_some()),
    ];
    if let Some((key, _)) = given.iter().find(|(key, given)| *given && !keys.contains(key)) {
        return Err(Finding::new(at(key), format!("a track of kind = \"{kind}\" has no `{key}`"))
            .help(format!("its keys: {}", keys.join(", "))));
    }
    if input.kind == TrackKind::None {
        if !on_ground {
            return Err(Finding::new(at("kind"), "springs need a track on them")
                .help("allowed with [foundation]: ballasted, slab, beam"));
        }
        let contact = match (&input.load, &input.contact) {
            (Some(input), None) => load(*input, &at("load"))?,
            (None, Some(strip)) => Contact::Strip(*strip),
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
        return Ok((Stack::default(), Some(contact)));
    }
    let strip = match (&input.contact, on_ground) {
        (Some(strip), _) => Some(*strip),
        (None, true) => {
            return Err(Finding::new(path, "missing key `contact`: how the track touches the ground")
                .help("add contact.half_width = … [m] and contact.compatibility = \"centre\" or \"mean\""));
        }
        (None, false) => None,
    };
    let rail = || beam(need(&input.rail, path, "rail", kind)?, &at("rail"));
    let pad = || spring(need(&input.pad, path, "pad", kind)?, &at("pad"));
    let stack = match input.kind {
        TrackKind::Ballasted => {
            let sleeper_mass = need(&input.sleeper, path, "sleeper", kind)?.mass;
            Member::mass(sleeper_mass).map_err(fault(&at("sleeper")))?;
            let ballast = ballast(need(&input.ballast, path, "ballast", kind)?, strip, &at("ballast"))?;
            Ballasted { rail: rail()?, pad: pad()?, sleeper_mass, ballast }
                .stack()
                .map_err(fault(&at("ballast")))?
        }
        TrackKind::Slab => {
            let slab = beam(need(&input.slab, path, "slab", kind)?, &at("slab"))?;
            Slab { rail: rail()?, pad: pad()?, slab }.stack()
        }
        TrackKind::Beam => {
            Stack::new(vec![beam(need(&input.beam, path, "beam", kind)?, &at("beam"))?], vec![])
        }
        TrackKind::None => Stack::default(),
    };
    Ok((stack, strip.map(Contact::Strip)))
}
