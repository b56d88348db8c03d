//! A smooth dip or hump.

use super::{IrregularityError, depth};
use crate::quantity::positive;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::TAU;

/// r = D/2 (1 − cos 2πx/l), 0 ≤ x ≤ l.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "Dip")]
pub struct Dip {
    /// D [m], negative for a hump.
    depth: f64,
    /// l [m]
    length: f64,
}

impl<'de> Deserialize<'de> for Dip {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { depth, length } = Self::deserialize(deserializer)?;
        Self::new(depth, length).map_err(D::Error::custom)
    }
}

impl Dip {
    /// A dip of depth `d` D and `length` l [m].
    ///
    /// # Errors
    /// A depth that is not finite; a length that is not positive.
    pub fn new(d: f64, length: f64) -> Result<Self, IrregularityError> {
        Ok(Self { depth: depth(d)?, length: positive("length", length, "m")? })
    }

    /// l [m]
    pub fn length(&self) -> f64 {
        self.length
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        if !(0.0..=self.length).contains(&x) {
            return 0.0;
        }
        0.5 * self.depth * (1.0 - (TAU * x / self.length).cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_deepest_in_its_middle() {
        let dip = Dip::new(0.003, 3.0).unwrap();
        assert_eq!([-0.1, 0.0, 1.5, 3.1].map(|x| dip.at(x)), [0.0, 0.0, 0.003, 0.0]);
        // rounding of the cosine
        assert!((dip.at(0.75) - 0.0015).abs() < 1e-18 && dip.at(3.0).abs() < 1e-18);
        assert!(Dip::new(f64::INFINITY, 1.0).is_err() && Dip::new(0.003, -1.0).is_err());
    }
}
