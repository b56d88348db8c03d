//! `[passage]` → a passage, with every fault at its key.

use super::checks::{FARTHEST, distinct, span};
use super::error::Finding;
use super::rail_studies::place;
use super::ranges::{NOT_NEGATIVE, POSITIVE, numbers, speeds};
use super::schema::{DefectInput, HangingInput, ModalInput, PassageInput};
use super::values::Range;
use super::vehicle::Wheels;
use crate::assessment::Band;
use crate::irregularity::Defect;
use crate::quantity::{not_negative, positive};
use crate::rail::fem::Ends;
use crate::study::{Irregularity, Passage, Running, Start, Step};
use crate::track::{Caughey, Rails};
use std::f64::consts::TAU;

/// Finest mesh a case may ask for [elements per bay].
const FINEST: usize = 64;
/// Most steps a case may ask for.
const MOST_STEPS: f64 = 2e7;
/// Farthest sleeper a case may name.
const FARTHEST_SLEEPER: i64 = 100_000;

/// From, to [m].
type Span = (f64, f64);
/// Number of a sleeper and the gap below it [m].
type Hanging = (i64, f64);

/// A key of `[passage]`.
fn at(key: &str) -> String {
    format!("passage.{key}")
}

fn above_zero(key: &'static str, value: f64, unit: &'static str) -> Result<f64, Finding> {
    positive(key, value, unit).map_err(|e| Finding::out_of_range("passage", e))
}

/// Speeds above zero, each once.
fn velocities(input: &PassageInput) -> Result<Vec<f64>, Finding> {
    let (path, list) = match (input.speed, &input.speeds) {
        (Some(speed), None) => ("speed", Range::List(vec![speed])),
        (None, Some(list)) => ("speeds", list.clone()),
        (Some(_), Some(_)) => {
            return Err(
                Finding::new(at("speeds"), "speed and speeds are both given").help("remove one of them")
            );
        }
        (None, None) => {
            return Err(
                Finding::new("passage", "missing key `speed`").help("add speed = … [m/s], or speeds = […]")
            );
        }
    };
    let path = at(path);
    let found = speeds(&list, &path)?;
    if let Some(i) = found.iter().position(|v| *v == 0.0) {
        let place = if input.speed.is_some() { path } else { format!("{path}[{i}]") };
        return Err(Finding::new(place, "found 0 m/s: a train that passes has a speed above zero"));
    }
    distinct(&found, &path, "m/s")?;
    Ok(found)
}

/// The way of the leading axle, and the track it needs.
fn way(input: &PassageInput, length: Option<f64>) -> Result<(Span, Option<Span>), Finding> {
    let run = (input.from, input.to);
    for (key, x) in [("from", run.0), ("to", run.1)] {
        place(x, &at(key))?;
    }
    if run.1 <= run.0 {
        let message = format!("from {} to {} m: `to` must lie above `from`", run.0, run.1);
        return Err(Finding::new(at("to"), message).help("trains run towards larger x"));
    }
    let track = input.track.map(|track| span(track, &at("track"))).transpose()?;
    if let (Some((first, last)), Some(length)) = (track, length) {
        let (rear, front) = (run.0 - length, run.1);
        if first > rear || last < front {
            let message =
                format!("from {first} to {last} m: the axles of the train run from {rear} to {front} m");
            return Err(Finding::new(at("track"), message).help(
                "a track longer by 18 m or more at both ends, or without it one as long as it must be",
            ));
        }
    }
    Ok((run, track))
}

fn step(input: &PassageInput) -> Result<Step, Finding> {
    match (input.step, input.step_length) {
        (None, None) => Ok(Step::Chosen),
        (Some(step), None) => Ok(Step::Time(above_zero("step", step, "s")?)),
        (None, Some(length)) => Ok(Step::Length(above_zero("step_length", length, "m")?)),
        (Some(_), Some(_)) => {
            Err(Finding::new(at("step_length"), "step and step_length are both given")
                .help("remove one of them"))
        }
    }
}

/// Refuses steps that would take hours.
fn bearable(step: Step, run: (f64, f64), speeds: &[f64]) -> Result<(), Finding> {
    let way = run.1 - run.0;
    let slowest = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let (key, count) = match step {
        Step::Time(step) => ("step", way / slowest / step),
        Step::Length(length) => ("step_length", way / length),
        Step::Chosen => return Ok(()),
    };
    if count > MOST_STEPS {
        return Err(Finding::new(at(key), format!("{count:.1e} steps, more than {MOST_STEPS:.0e}"))
            .help("use a longer step or a shorter way"));
    }
    Ok(())
}

/// Damping of modes, each with its ratio.
fn damping(input: &ModalInput) -> Result<Caughey, Finding> {
    let path = at("damping.frequencies");
    let frequencies = numbers(&Range::List(input.frequencies.clone()), &path, "Hz", POSITIVE)?;
    let path = at("damping.ratios");
    let ratios = numbers(&Range::List(input.ratios.clone()), &path, "", NOT_NEGATIVE)?;
    let omega: Vec<f64> = frequencies.iter().map(|f| TAU * f).collect();
    Caughey::of_modes(&omega, &ratios).map_err(|e| Finding::new(at("damping"), e))
}

/// Defects and where they lie, with the wheels (from 0) that have them.
fn defect((i, input): (usize, &DefectInput), wheels: usize) -> Result<(Defect, f64, Vec<usize>), Finding> {
    let path = format!("passage.defect[{i}]");
    place(input.at, &format!("{path}.at"))?;
    let own = match (&input.wheels, input.defect.of_wheel()) {
        (None, false) => Vec::new(),
        (Some(_), false) => {
            return Err(Finding::new(
                format!("{path}.wheels"),
                "it lies in the rail, and every wheel comes to it",
            )
            .help("remove wheels: flats belong to them"));
        }
        (None, true) => {
            return Err(Finding::new(path, "missing key `wheels`: which wheels have the flat")
                .help("add wheels = [1] for the leading one"));
        }
        (Some(own), true) => own.clone(),
    };
    for (j, wheel) in own.iter().enumerate() {
        if !(1..=wheels).contains(wheel) {
            let message = format!("found wheel {wheel}: the train has wheels 1 to {wheels}");
            return Err(Finding::new(format!("{path}.wheels[{j}]"), message));
        }
    }
    if own.is_empty() && input.defect.of_wheel() {
        return Err(
            Finding::new(format!("{path}.wheels"), "the list is empty").help("name at least one wheel")
        );
    }
    Ok((input.defect, input.at, own.iter().map(|wheel| wheel - 1).collect()))
}

/// Sleepers that hang or are missing, each once.
fn sleepers(input: &PassageInput) -> Result<(Vec<Hanging>, Vec<i64>), Finding> {
    let mut seen: Vec<i64> = Vec::new();
    let mut new = |sleeper: i64, path: String| {
        if sleeper.abs() > FARTHEST_SLEEPER {
            return Err(Finding::new(
                path,
                format!("found sleeper {sleeper}: more than {FARTHEST_SLEEPER} away"),
            ));
        }
        if seen.contains(&sleeper) {
            return Err(
                Finding::new(path, format!("sleeper {sleeper} stands there twice")).help("name each once")
            );
        }
        seen.push(sleeper);
        Ok(sleeper)
    };
    let missing = input.missing_sleepers.iter().enumerate();
    let missing =
        missing.map(|(i, &n)| new(n, format!("passage.missing_sleepers[{i}]"))).collect::<Result<_, _>>()?;
    let mut hanging = Vec::new();
    for (i, HangingInput { sleepers, gap }) in input.hanging_sleeper.iter().enumerate() {
        let path = format!("passage.hanging_sleeper[{i}]");
        let gap = not_negative("gap", *gap, "m").map_err(|e| Finding::out_of_range(&path, e))?;
        if sleepers.is_empty() {
            return Err(
                Finding::new(format!("{path}.sleepers"), "the list is empty").help("name at least one")
            );
        }
        for (j, &n) in sleepers.iter().enumerate() {
            hanging.push((new(n, format!("{path}.sleepers[{j}]"))?, gap));
        }
    }
    Ok((hanging, missing))
}

/// The wheels and what they roll over, or none for constant loads.
fn running(
    input: &PassageInput,
    wheels: Option<&Wheels>,
    irregularity: Option<Irregularity>,
) -> Result<Option<Running>, Finding> {
    const MASS: &str = "add unsprung_mass [kg per wheelset], or a vehicle with a model, and wheel_rail";
    // without a train there is more to say, and it is said by the study
    let Some(wheels) = wheels else { return Ok(None) };
    let Wheels { bodies: Some(bodies), contact, .. } = wheels else {
        let lacks = |key: String, what: &str| {
            Err(Finding::new(key, format!("{what}, and the loads of this train have no mass")).help(MASS))
        };
        return match (input.contact, &irregularity, input.defect.first()) {
            (Some(_), _, _) => lacks(at("contact"), "contact is of wheels"),
            (_, Some(_), _) => lacks("irregularity".into(), "a rough rail moves wheels"),
            (_, _, Some(_)) => lacks(at("defect[0]"), "defects move wheels"),
            _ => Ok(None),
        };
    };
    let Some(contact) = contact.clone() else {
        return Err(Finding::new("train", "the wheels have no contact with the rail")
            .help("add wheel_rail.stiffness [N/m per wheelset] or wheel_rail.radius [m]"));
    };
    let count = bodies.wheelset_count();
    let defects = input.defect.iter().enumerate().map(|d| defect(d, count)).collect::<Result<_, _>>()?;
    let law = input.contact.unwrap_or_default();
    Ok(Some(Running { bodies: bodies.clone(), contact, law, irregularity, defects }))
}

/// Places and frequencies of what is shown.
fn shown(input: &PassageInput) -> Result<(Vec<f64>, (f64, f64)), Finding> {
    let near = |x: f64| x.abs() <= FARTHEST;
    let places = match input.at.is_empty() {
        true => Vec::new(),
        false => numbers(&Range::List(input.at.clone()), "passage.at", "m", (near, "within 10 km"))?,
    };
    distinct(&places, "passage.at", "m")?;
    let (from, to) = input.frequencies.map_or((5.0, 500.0), |span| (span.from, span.to));
    Band::range(from, to).map_err(|e| Finding::new(at("frequencies"), e))?;
    Ok((places, (from, to)))
}

/// `[passage]`; `wheels` are None without a train, `rails` how many the numbers of the track stand for.
pub fn passage(
    input: &PassageInput,
    wheels: Option<&Wheels>,
    irregularity: Option<Irregularity>,
    rails: Rails,
) -> Result<Passage, Finding> {
    let speeds = velocities(input)?;
    let length = wheels.map(|wheels| wheels.length);
    let (run, track) = way(input, length)?;
    let elements_per_bay = input.elements_per_bay.unwrap_or(8);
    if !(1..=FINEST).contains(&elements_per_bay) {
        let message = format!("found {elements_per_bay}: it must lie between 1 and {FINEST}");
        return Err(Finding::new(at("elements_per_bay"), message));
    }
    let step = step(input)?;
    bearable(step, run, &speeds)?;
    let ramp = above_zero("ramp", input.ramp.unwrap_or(12.0), "m")?;
    if input.ramp.is_some() && input.start == Some(Start::Static) && irregularity.is_none() {
        return Err(Finding::new(at("ramp"), "a start \"static\" has no ramp")
            .help("remove it, or say start = \"ramp\""));
    }
    let alpha = input.alpha.unwrap_or(0.0);
    if !(-1.0 / 3.0..=0.0).contains(&alpha) {
        return Err(Finding::new(at("alpha"), format!("found {alpha}: it must lie between -1/3 and 0")));
    }
    let ends = input.ends.unwrap_or_default();
    if let Ends::Absorbing { length, damping } = ends {
        let refused = |e| Finding::out_of_range(&at("ends"), e);
        positive("length", length, "m").map_err(refused)?;
        positive("damping", damping, "N s/m²").map_err(refused)?;
    }
    let (hanging, missing) = sleepers(input)?;
    let (at, frequencies) = shown(input)?;
    Ok(Passage {
        speeds,
        run,
        track,
        elements_per_bay,
        step,
        start: input.start,
        ramp,
        ends,
        alpha,
        damping: input.damping.as_ref().map(damping).transpose()?,
        rails,
        running: running(input, wheels, irregularity)?,
        hanging,
        missing,
        at,
        frequencies,
    })
}
