//! Flats of wheels, rounded and fresh: they come round again with every turn.

use super::IrregularityError;
use crate::quantity::{keyed, positive};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::TAU;

/// r = D/2 (1 − cos 2πx/l), 0 ≤ x ≤ l: a flat whose edges are rolled round.
///
/// The depth D is an input: D = l²/(16R) is usual, others take the depth l²/(8R) of a fresh one.
/// Source: Newton & Clark 1979, J. Mech. Eng. Sci. 21(4), as usually quoted.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "RoundedFlat")]
pub struct RoundedFlat {
    /// R of the wheel [m].
    radius: f64,
    /// l [m]
    length: f64,
    /// D [m]
    depth: f64,
}

/// r = y²/(2R), y to the nearer end, 0 ≤ x ≤ l: the centre of a wheel that rolls over a fresh chord, l²/(8R) deep.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "FreshFlat")]
pub struct FreshFlat {
    /// R of the wheel [m].
    radius: f64,
    /// l [m]
    length: f64,
}

/// Radius and length [m] of a flat, which is a chord of its wheel.
fn chord(radius: f64, length: f64) -> Result<(f64, f64), IrregularityError> {
    let (radius, length) = (positive("radius", radius, "m")?, positive("length", length, "m")?);
    if length < 2.0 * radius { Ok((radius, length)) } else { Err(IrregularityError::Flat { length, radius }) }
}

/// Where in the flat a wheel of `radius` stands that first came to its beginning at x = 0 [m]; `None` elsewhere.
fn within(x: f64, radius: f64, length: f64) -> Option<f64> {
    let turned = x % (TAU * radius);
    (0.0..=length).contains(&turned).then_some(turned)
}

impl RoundedFlat {
    /// A flat of `length` and `depth` on a wheel of `radius` [m].
    ///
    /// # Errors
    /// A quantity that is not positive; a flat as long as the wheel is wide.
    pub fn new(radius: f64, length: f64, depth: f64) -> Result<Self, IrregularityError> {
        let (radius, length) = chord(radius, length)?;
        Ok(Self { radius, length, depth: positive("depth", depth, "m")? })
    }

    /// D, and that of a fresh flat as long, l²/(8R) [m].
    pub fn depths(&self) -> (f64, f64) {
        (self.depth, self.length * self.length / (8.0 * self.radius))
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        let r = |x: f64| 0.5 * self.depth * (1.0 - (TAU * x / self.length).cos());
        within(x, self.radius, self.length).map_or(0.0, r)
    }
}

impl FreshFlat {
    /// A flat of `length` on a wheel of `radius` [m].
    ///
    /// # Errors
    /// See [`RoundedFlat::new`].
    pub fn new(radius: f64, length: f64) -> Result<Self, IrregularityError> {
        let (radius, length) = chord(radius, length)?;
        Ok(Self { radius, length })
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        let r = |x: f64| x.min(self.length - x).powi(2) / (2.0 * self.radius);
        within(x, self.radius, self.length).map_or(0.0, r)
    }
}

/// A fault at the key that is wrong; [`crate::quantity::OutOfRange`] names its own.
fn refused<E: Error>(error: IrregularityError) -> E {
    match error {
        IrregularityError::Flat { .. } => E::custom(keyed("length", error)),
        error => E::custom(error),
    }
}

impl<'de> Deserialize<'de> for RoundedFlat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { radius, length, depth } = Self::deserialize(deserializer)?;
        Self::new(radius, length, depth).map_err(refused)
    }
}

impl<'de> Deserialize<'de> for FreshFlat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { radius, length } = Self::deserialize(deserializer)?;
        Self::new(radius, length).map_err(refused)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn returns_with_every_turn() {
        let (radius, length) = (0.46, 0.05);
        let depth = length * length / (16.0 * radius);
        let (rounded, fresh) =
            (RoundedFlat::new(radius, length, depth).unwrap(), FreshFlat::new(radius, length).unwrap());
        // in the middle of the flat: D, and l²/(8R) = 0.679 mm
        assert!((rounded.at(0.025) / depth - 1.0).abs() < 1e-15);
        assert!((fresh.at(0.025) / (length * length / (8.0 * radius)) - 1.0).abs() < 1e-15);
        assert!((rounded.at(0.0125) / (0.5 * depth) - 1.0).abs() < 1e-15);
        assert!((fresh.at(0.04) - 0.01 * 0.01 / 0.92).abs() < 1e-18);
        for flat in [&(|x| rounded.at(x)) as &dyn Fn(f64) -> f64, &|x| fresh.at(x)] {
            // not before its first touch, nor between
            assert_eq!([-0.01, 0.0, 0.06, 2.89].map(flat), [0.0; 4]);
            // rounding of the argument of 290 m against slopes of up to 0.11
            assert!((flat(0.02 + 100.0 * TAU * radius) - flat(0.02)).abs() < 1e-14);
        }
        assert!((rounded.depths().1 / rounded.depths().0 - 2.0).abs() < 1e-15);
    }

    #[test]
    fn is_shorter_than_its_wheel() {
        let error = FreshFlat::new(0.46, 0.92).unwrap_err().to_string();
        assert_eq!(
            error,
            "length is 0.92 m: a flat of a wheel of radius 0.46 m is a chord of it, shorter than 0.92 m"
        );
        assert!(RoundedFlat::new(0.46, 0.05, 0.0).is_err() && FreshFlat::new(0.0, 0.05).is_err());
    }
}
