//! Checks of single numbers, shared by the tables of a case.

use super::error::Finding;
use super::schema::SpanInput;
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
