//! Checks of numbers, spans and places, shared by the tables of a case.

use super::error::Finding;
use super::ranges::{POSITIVE, numbers};
use super::values::Range;
use super::values::SpanInput;
use crate::field::Window;
use crate::quantity::positive;
use crate::study::tag;

/// Farthest position a case may ask for [m].
pub const FARTHEST: f64 = 10_000.0;

/// The two ends [m] of `input`, the second above the first; `path` is the key.
///
/// # Errors
/// Ends that are not finite, in the wrong order, or too far.
pub fn span(input: SpanInput, path: &str) -> Result<(f64, f64), Finding> {
    if !(input.from.is_finite() && input.to.is_finite()) {
        return Err(Finding::new(
            path,
            format!("from {} to {} m: both must be finite", input.from, input.to),
        ));
    }
    if input.to <= input.from {
        return Err(Finding::new(
            path,
            format!("from {} to {} m: `to` must lie above `from`", input.from, input.to),
        ));
    }
    if input.from.abs().max(input.to.abs()) > FARTHEST {
        let message = format!("from {} to {} m: farther than {FARTHEST} m", input.from, input.to);
        return Err(Finding::new(path, message).help("positions are in metres"));
    }
    Ok((input.from, input.to))
}

/// Refuses speeds or frequencies that files and keys, which name them to 0.01 `unit`, could not tell apart.
///
/// # Errors
/// The second of such a pair.
pub fn distinct(values: &[f64], path: &str, unit: &str) -> Result<(), Finding> {
    for (i, value) in values.iter().enumerate() {
        if values[..i].iter().any(|other| tag(*other) == tag(*value)) {
            return Err(Finding::new(
                format!("{path}[{i}]"),
                format!("{value} {unit} stands there twice, to 0.01 {unit}"),
            )
            .help("give each value once"));
        }
    }
    Ok(())
}

/// Refuses values that do not ascend.
///
/// # Errors
/// The first that does not.
pub fn ascending(values: &[f64], path: &str) -> Result<(), Finding> {
    match values.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(i) => Err(Finding::new(
            format!("{path}[{}]", i + 1),
            format!("{} follows {}: the values must ascend", values[i + 1], values[i]),
        )
        .help("sort the list, each value once")),
        None => Ok(()),
    }
}

/// The part of the surface to map, of the study `path`.
pub fn window(x: SpanInput, y: SpanInput, spacing: f64, path: &str) -> Result<Window, Finding> {
    let (x, y) = (span(x, &format!("{path}.x"))?, span(y, &format!("{path}.y"))?);
    let spacing = positive("spacing", spacing, "m").map_err(|e| Finding::out_of_range(path, e))?;
    let least = (x.1 - x.0).min(y.1 - y.0);
    if spacing > least {
        let message = format!("spacing is {spacing} m, wider than the window of {least} m");
        return Err(
            Finding::new(format!("{path}.spacing"), message).help("a map has two points each way at least")
        );
    }
    Ok(Window { x, y, spacing })
}

/// Distances from the centre line, ascending.
pub fn receivers(values: &[f64], path: &str) -> Result<Vec<f64>, Finding> {
    if values.is_empty() {
        return Ok(Vec::new());
    }
    let values = numbers(&Range::List(values.to_vec()), path, "m", POSITIVE)?;
    ascending(&values, path)?;
    match values.iter().position(|y| *y > FARTHEST) {
        Some(i) => {
            let message = format!("{} m: farther than {FARTHEST} m", values[i]);
            Err(Finding::new(format!("{path}[{i}]"), message))
        }
        None => Ok(values),
    }
}
