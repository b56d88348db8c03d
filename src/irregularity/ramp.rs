//! A rail that goes on lower or higher, with an even slope between.

use super::{IrregularityError, depth};
use crate::quantity::positive;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// r = h x/l, 0 ≤ x ≤ l; 0 before, h behind.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "Ramp")]
pub struct Ramp {
    /// h [m], positive where the rail goes on lower.
    depth: f64,
    /// l [m]
    length: f64,
}

impl<'de> Deserialize<'de> for Ramp {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { depth, length } = Self::deserialize(deserializer)?;
        Self::new(depth, length).map_err(D::Error::custom)
    }
}

impl Ramp {
    /// A ramp of `depth` h over `length` l [m].
    ///
    /// # Errors
    /// A depth that is not finite; a length that is not positive.
    pub fn new(h: f64, length: f64) -> Result<Self, IrregularityError> {
        Ok(Self { depth: depth(h)?, length: positive("length", length, "m")? })
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        self.depth * (x / self.length).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leads_from_one_level_to_the_other() {
        let ramp = Ramp::new(-0.01, 0.6).unwrap();
        assert_eq!([-1.0, 0.0, 0.3, 0.6, 9.0].map(|x| ramp.at(x)), [0.0, 0.0, -0.005, -0.01, -0.01]);
        assert!(Ramp::new(f64::NAN, 0.6).is_err() && Ramp::new(0.01, 0.0).is_err());
    }
}
