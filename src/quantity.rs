//! Numbers that must lie in their range, called by their keys in case files, so that a fault finds its line by itself.

use std::fmt;
use thiserror::Error;

/// What is asked of a number besides being finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// Nothing more.
    Finite,
    /// Above zero.
    Positive,
    /// Zero or above.
    NotNegative,
    /// Above the first and below the second.
    Between(f64, f64),
    /// Between the first and the second, or one of them.
    Within(f64, f64),
}

impl Bound {
    fn holds(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Finite => true,
                Self::Positive => value > 0.0,
                Self::NotNegative => value >= 0.0,
                Self::Between(low, high) => value > low && value < high,
                Self::Within(low, high) => value >= low && value <= high,
            }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Finite => f.write_str("be finite"),
            Self::Positive => f.write_str("be finite and above zero"),
            Self::NotNegative => f.write_str("be finite and not negative"),
            Self::Between(low, high) => write!(f, "lie above {low} and below {high}"),
            Self::Within(low, high) => write!(f, "lie between {low} and {high}"),
        }
    }
}

/// Ends the key that `{:#}` puts in front of what a constructor refuses, so that a reader of files finds its place.
pub const KEY_ENDS: char = '\u{1f}';

/// `error`, about the value at `key` of the table that is read.
pub fn keyed(key: &str, error: impl fmt::Display) -> String {
    format!("{key}{KEY_ENDS}{error}")
}

/// A number out of its range. Its `{:#}` is that of [`keyed`].
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub struct OutOfRange {
    /// What it is, as a case file spells it within the table of the one who refuses it: `bending_stiffness`, `body.mass`.
    pub key: &'static str,
    /// What was given.
    pub value: f64,
    /// Its unit, empty for a bare number.
    pub unit: &'static str,
    /// What it must be.
    pub bound: Bound,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { key, value, unit, bound } = self;
        if f.alternate() {
            write!(f, "{key}{KEY_ENDS}")?;
        }
        let gap = if unit.is_empty() { "" } else { " " };
        write!(f, "{key} is {value}{gap}{unit}: it must {bound}")
    }
}

fn within(key: &'static str, value: f64, unit: &'static str, bound: Bound) -> Result<f64, OutOfRange> {
    if bound.holds(value) { Ok(value) } else { Err(OutOfRange { key, value, unit, bound }) }
}

/// `value` if finite.
///
/// # Errors
/// [`OutOfRange`] otherwise.
pub fn finite(key: &'static str, value: f64, unit: &'static str) -> Result<f64, OutOfRange> {
    within(key, value, unit, Bound::Finite)
}

/// `value` if finite and above zero.
///
/// # Errors
/// [`OutOfRange`] otherwise.
pub fn positive(key: &'static str, value: f64, unit: &'static str) -> Result<f64, OutOfRange> {
    within(key, value, unit, Bound::Positive)
}

/// `value` if finite and not negative.
///
/// # Errors
/// [`OutOfRange`] otherwise.
pub fn not_negative(key: &'static str, value: f64, unit: &'static str) -> Result<f64, OutOfRange> {
    within(key, value, unit, Bound::NotNegative)
}

/// `value` if above `range.0` and below `range.1`.
///
/// # Errors
/// [`OutOfRange`] otherwise.
pub fn between(
    key: &'static str,
    value: f64,
    unit: &'static str,
    range: (f64, f64),
) -> Result<f64, OutOfRange> {
    within(key, value, unit, Bound::Between(range.0, range.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_lies_in_its_range_passes() {
        for nonsense in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(finite("x", nonsense, "").is_err() && positive("x", nonsense, "").is_err());
            assert!(not_negative("x", nonsense, "").is_err());
            assert!(between("x", nonsense, "", (f64::NEG_INFINITY, f64::INFINITY)).is_err());
        }
        assert_eq!(finite("x", -1.0, ""), Ok(-1.0));
        assert!(positive("x", 0.0, "").is_err() && positive("x", 1e-300, "").is_ok());
        assert!(not_negative("x", 0.0, "").is_ok() && not_negative("x", -1e-300, "").is_err());
        let poisson = |nu| between("poisson", nu, "", (-1.0, 0.5));
        assert!(poisson(0.499).is_ok() && poisson(0.5).is_err() && poisson(-1.0).is_err());
    }

    #[test]
    fn messages_name_key_value_and_unit() {
        let text = |result: Result<f64, OutOfRange>| result.unwrap_err().to_string();
        assert_eq!(
            text(positive("bending_stiffness", -1.0, "N m²")),
            "bending_stiffness is -1 N m²: it must be finite and above zero"
        );
        assert_eq!(
            text(not_negative("loss_factor", -0.1, "")),
            "loss_factor is -0.1: it must be finite and not negative"
        );
        assert_eq!(text(finite("phase", f64::NAN, "rad")), "phase is NaN rad: it must be finite");
        assert_eq!(
            text(between("poisson", 0.5, "", (-1.0, 0.5))),
            "poisson is 0.5: it must lie above -1 and below 0.5"
        );
    }
}
