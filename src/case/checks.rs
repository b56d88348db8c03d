//! Checks of single numbers, shared by the tables of a case.

use super::error::Finding;
use super::schema::SpanInput;

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
