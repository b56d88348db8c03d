//! Tables that ask for the rail → studies, with every fault at its key.

use super::checks::{FARTHEST, ascending, distinct, receivers, span, window};
use super::error::Finding;
use super::ranges::{MOST, POSITIVE, line_speed, numbers, speeds};
use super::schema::{
    BesideInput, DecayRateInput, MeasuredInput, ReceptanceInput, TrackResponseInput, TransitionInput,
};
use super::values::Range;
use crate::columns::{self, Columns};
use crate::quantity::positive;
use crate::rail::Method;
use crate::study::{
    Beside, DecayRate, Receptance, ReceptanceMap, Record, TrackResponse, Transition, same_speed, tag,
};

/// Two columns of the CSV `file` that the key at `at` names.
fn columns_of(
    file: &str,
    at: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
    wanted: &str,
) -> Result<Columns, Finding> {
    let text = files(file).map_err(|reason| {
        Finding::new(at, format!("cannot read \"{file}\": {reason}"))
            .help("the path is relative to the case file")
    })?;
    let wanted = format!("a header line, then {wanted}");
    let columns =
        columns::read(&text).map_err(|e| Finding::new(at, format!("{file}, {e}")).help(wanted.as_str()))?;
    if columns.x.is_empty() {
        return Err(Finding::new(at, format!("{file} has no numbers")).help(wanted));
    }
    Ok(columns)
}

/// A record's CSV: x′ and deflection.
fn record(
    input: &MeasuredInput,
    path: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Record, Finding> {
    let at = format!("{path}.file");
    let Columns { x, values: deflection, .. } =
        columns_of(&input.file, &at, files, "x′ [m], deflection [m]")?;
    Ok(Record { speed: input.speed, label: input.label.clone(), x, deflection })
}

pub fn track_response(
    input: &TrackResponseInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<TrackResponse, Finding> {
    let x = input.x.map(|x| span(x, "track_response.x")).transpose()?;
    let records = input
        .measured
        .iter()
        .enumerate()
        .map(|(i, m)| record(m, &format!("track_response.measured[{i}]"), files))
        .collect::<Result<_, _>>()?;
    let spacing = input.spacing.map(|spacing| positive("spacing", spacing, "m")).transpose();
    let spacing = spacing.map_err(|e| Finding::out_of_range("track_response", e))?;
    let length = x.map_or(1000.0, |(from, to)| to - from);
    if let Some(spacing) = spacing
        && length / spacing >= MOST as f64
    {
        let found =
            format!("a spacing of {spacing} m makes {:.0} positions, more than {MOST}", length / spacing);
        return Err(Finding::new("track_response.spacing", found).help("use a larger spacing"));
    }
    let mut speeds = speeds(&input.speeds, "track_response.speeds")?;
    distinct(&speeds, "track_response.speeds", "m/s")?;
    let line_speed = line_speed(input.line_speed, "track_response.line_speed")?;
    speeds.extend(line_speed.filter(|line| !speeds.iter().any(|v| tag(*v) == tag(*line))));
    for (i, measured) in input.measured.iter().enumerate() {
        if !speeds.iter().any(|v| same_speed(*v, measured.speed)) {
            let message = format!("the record is for {} m/s, which is not among the speeds", measured.speed);
            return Err(Finding::new(format!("track_response.measured[{i}].speed"), message)
                .help("add the speed to track_response.speeds"));
        }
    }
    let frequencies = input.frequencies.as_ref().map(|frequencies| {
        let path = "track_response.frequencies";
        let frequencies = numbers(frequencies, path, "Hz", POSITIVE)?;
        ascending(&frequencies, path)?;
        Ok(frequencies)
    });
    if let Some(harmonic) = input.harmonic {
        positive("harmonic", harmonic, "Hz").map_err(|e| Finding::out_of_range("track_response", e))?;
    }
    let spectra = beside(&input.spectra, "track_response.spectra", files)?;
    let at = if input.at.is_empty() { Vec::new() } else { places(&input.at, "track_response.at")? };
    Ok(TrackResponse {
        speeds,
        line_speed,
        x,
        spacing,
        records,
        at,
        harmonic: input.harmonic,
        frequencies: frequencies.transpose()?.unwrap_or_default(),
        beside: spectra,
        method: input.method,
        verify: input.verify,
    })
}

/// Curves to draw beside the computed ones, of the list at `path`.
fn beside(
    input: &[BesideInput],
    path: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Vec<Beside>, Finding> {
    let one = |(i, beside): (usize, &BesideInput)| {
        let at = format!("{path}[{i}].file");
        let Columns { x, values, .. } = columns_of(&beside.file, &at, files, "frequency [Hz], value")?;
        Ok(Beside { label: beside.label.clone(), x, values })
    };
    input.iter().enumerate().map(one).collect()
}

/// A second method that is another one.
fn another(method: Option<Method>, verify: Option<Method>, path: &str) -> Result<(), Finding> {
    if verify.is_some() && method == verify {
        return Err(Finding::new(format!("{path}.verify"), "it is the method itself")
            .help("name another method, or remove it"));
    }
    Ok(())
}

/// A place along the rail.
///
/// # Errors
/// One that is not finite, or too far.
pub fn place(x: f64, path: &str) -> Result<f64, Finding> {
    if x.abs() <= FARTHEST {
        return Ok(x);
    }
    Err(Finding::new(path, format!("found {x} m: it must be finite and within 10 km")))
}

/// Places along the rail.
fn places(x: &[f64], path: &str) -> Result<Vec<f64>, Finding> {
    let finite = |v: f64| v.abs() <= FARTHEST;
    let x = numbers(&Range::List(x.to_vec()), path, "m", (finite, "within 10 km"))?;
    distinct(&x, path, "m")?;
    Ok(x)
}

pub fn receptance(
    input: &ReceptanceInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Receptance, Finding> {
    let frequencies = numbers(&input.frequencies, "receptance.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "receptance.frequencies")?;
    let receivers = receivers(&input.receivers, "receptance.receivers")?;
    let map = input.map.as_ref().map(|map| {
        let path = "receptance.map.frequencies";
        let frequencies = numbers(&map.frequencies, path, "Hz", POSITIVE)?;
        ascending(&frequencies, path)?;
        distinct(&frequencies, path, "Hz")?;
        let window = window(map.x, map.y, map.spacing, "receptance.map")?;
        Ok(ReceptanceMap { frequencies, window })
    });
    another(input.method, input.verify, "receptance")?;
    let from = place(input.from.unwrap_or(0.0), "receptance.from")?;
    Ok(Receptance {
        frequencies,
        from,
        x: input.x.as_ref().map(|x| places(x, "receptance.x")).transpose()?,
        method: input.method,
        verify: input.verify,
        receivers,
        map: map.transpose()?,
        beside: beside(&input.measured, "receptance.measured", files)?,
    })
}

pub fn decay_rate(
    input: &DecayRateInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<DecayRate, Finding> {
    let frequencies = numbers(&input.frequencies, "decay_rate.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "decay_rate.frequencies")?;
    another(input.rail, input.verify, "decay_rate")?;
    let from = input.from.map(|x| place(x, "decay_rate.from")).transpose()?;
    Ok(DecayRate {
        frequencies,
        definition: input.method.unwrap_or_default(),
        from,
        rail: input.rail,
        verify: input.verify,
        beside: beside(&input.measured, "decay_rate.measured", files)?,
    })
}

pub fn transition(input: &TransitionInput) -> Result<Transition, Finding> {
    let frequencies = numbers(&input.frequencies, "transition.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "transition.frequencies")?;
    let along = input.along.as_ref().map(|along| {
        let along = numbers(&Range::List(along.clone()), "transition.along", "Hz", POSITIVE)?;
        distinct(&along, "transition.along", "Hz")?;
        Ok(along)
    });
    let x = input.x.map(|x| span(x, "transition.x")).transpose()?.unwrap_or((-15.0, 15.0));
    let spacing = positive("spacing", input.spacing.unwrap_or(0.05), "m")
        .map_err(|e| Finding::out_of_range("transition", e))?;
    if (x.1 - x.0) / spacing >= MOST as f64 {
        let message = format!(
            "a spacing of {spacing} m makes {:.0} positions, more than {MOST}",
            (x.1 - x.0) / spacing
        );
        return Err(Finding::new("transition.spacing", message).help("use a larger spacing"));
    }
    let from = input.from.unwrap_or(-0.5);
    place(from, "transition.from")?;
    let along = along.transpose()?.unwrap_or_default();
    if input.verify.is_some() && along.is_empty() {
        return Err(Finding::new(
            "transition.verify",
            "it is the receptances along the rail that are verified",
        )
        .help("add transition.along = [frequencies], or remove it"));
    }
    Ok(Transition { frequencies, along, from, x, spacing, method: input.method, verify: input.verify })
}
