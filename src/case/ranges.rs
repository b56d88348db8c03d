//! Ranges of a case file → their numbers, with every fault at its key.

use super::error::Finding;
use super::values::{Bands, Range};
use crate::assessment::Band;
use crate::math::decimal::arithmetic;

/// Most values a range may have.
pub const MOST: usize = 100_000;

/// The numbers of a range, each accepted by `accept`.
pub fn numbers(
    range: &Range<f64>,
    path: &str,
    unit: &str,
    accept: (fn(f64) -> bool, &str),
) -> Result<Vec<f64>, Finding> {
    let values = match *range {
        Range::List(ref list) => list.clone(),
        Range::Steps { from, to, bands: Some(Bands::ThirdOctave), step } => {
            if step.is_some() || unit != "Hz" {
                return Err(match step {
                    Some(_) => Finding::new(format!("{path}.step"), "step and bands are both given"),
                    None => Finding::new(format!("{path}.bands"), "bands are of frequencies"),
                }
                .help("remove one of them"));
            }
            let bands = Band::range(from, to).map_err(|error| Finding::new(path, error))?;
            bands.into_iter().map(Band::centre).collect()
        }
        Range::Steps { from, to, step, bands: None } => steps((from, to), step, path, unit)?,
    };
    if values.is_empty() {
        return Err(Finding::new(path, "the list is empty").help("give at least one value"));
    }
    for (i, value) in values.iter().enumerate() {
        if !(value.is_finite() && accept.0(*value)) {
            let path = if matches!(range, Range::List(_)) { format!("{path}[{i}]") } else { path.to_owned() };
            return Err(Finding::new(
                path,
                format!("found {value} {unit}: it must be finite and {}", accept.1),
            ));
        }
    }
    Ok(values)
}

pub const POSITIVE: (fn(f64) -> bool, &str) = (|v| v > 0.0, "above zero");
pub const NOT_NEGATIVE: (fn(f64) -> bool, &str) = (|v| v >= 0.0, "not negative");

pub fn speeds(range: &Range<f64>, path: &str) -> Result<Vec<f64>, Finding> {
    numbers(range, path, "m/s", NOT_NEGATIVE)
}

/// The speed of a line [m/s], above zero and slower than sound.
pub fn line_speed(speed: Option<f64>, path: &str) -> Result<Option<f64>, Finding> {
    match speed {
        Some(v) if !(v > 0.0 && v < 340.0) => {
            let message = format!("{v} m/s: the speed of a line must lie above 0 and below 340 m/s");
            Err(Finding::new(path, message).help("write it as \"250 km/h\", or in m/s"))
        }
        speed => Ok(speed),
    }
}

/// from, from + step, … up to `to`.
fn steps((from, to): (f64, f64), step: Option<f64>, path: &str, unit: &str) -> Result<Vec<f64>, Finding> {
    let Some(step) = step else {
        return Err(Finding::new(path, "missing key `step`").help("give step, or a list [a, b, …]"));
    };
    if !(from.is_finite() && to.is_finite() && step.is_finite()) {
        return Err(Finding::new(path, format!("range from {from} to {to} step {step}: all must be finite")));
    }
    if step <= 0.0 {
        return Err(Finding::new(
            format!("{path}.step"),
            format!("step is {step} {unit}: it must be above zero"),
        ));
    }
    if to < from {
        return Err(Finding::new(path, format!("the range is reversed: from {from} to {to} {unit}"))
            .help("swap from and to"));
    }
    let count = ((to - from) / step + 1e-9).floor();
    if count >= MOST as f64 {
        return Err(Finding::new(path, format!("the range has {count:.0} values, more than {MOST}"))
            .help("use a larger step"));
    }
    Ok(arithmetic(from, step, count as usize + 1))
}
