//! A rail end that lies lower or higher than the one before.

use super::IrregularityError;
use crate::quantity::{finite, keyed, positive};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// A square edge at x = 0 of height h, over which a wheel of radius R rolls: up, its centre rises along a circle about the edge over
/// the last √(2Rh − h²) before it; down, it falls along one over as much behind it.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "Step")]
pub struct Step {
    /// R of the wheels [m].
    radius: f64,
    /// ±h [m]: positive where the rail goes on lower, negative where it goes on higher.
    depth: f64,
}

impl<'de> Deserialize<'de> for Step {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { radius, depth } = Self::deserialize(deserializer)?;
        Self::new(radius, depth).map_err(|error| match error {
            IrregularityError::Step { .. } => D::Error::custom(keyed("depth", error)),
            error => D::Error::custom(error),
        })
    }
}

impl Step {
    /// A step of `depth` under wheels of `radius` [m].
    ///
    /// # Errors
    /// A radius that is not positive; a depth that is zero or not finite, or a step as high as the radius.
    pub fn new(radius: f64, depth: f64) -> Result<Self, IrregularityError> {
        let (radius, depth) = (positive("radius", radius, "m")?, finite("depth", depth, "m")?);
        if depth == 0.0 || depth.abs() >= radius {
            return Err(IrregularityError::Step { depth, radius });
        }
        Ok(Self { radius, depth })
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        let Self { radius, depth } = *self;
        // R − √(R² − x²), how far the centre has come down the circle from above the edge
        let fallen = x * x / (radius + (radius * radius - x * x).max(0.0).sqrt());
        match (depth > 0.0, x < 0.0) {
            (true, true) => 0.0,
            (true, false) => fallen.min(depth),
            (false, false) => depth,
            (false, true) => (depth + fallen).min(0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wheel_rolls_over_the_edge() {
        let (radius, height) = (0.46f64, 0.5e-3f64);
        let reach = (2.0 * radius * height - height * height).sqrt();
        let (up, down) = (Step::new(radius, -height).unwrap(), Step::new(radius, height).unwrap());
        assert!((reach - 0.021_441_8).abs() < 1e-7);
        for x in [-3.0, -0.47, -1.001 * reach] {
            assert_eq!((up.at(x), down.at(-x)), (0.0, height));
        }
        for x in [0.0, 0.2, 5.0] {
            assert_eq!((up.at(x), down.at(-1e-9 - x)), (-height, 0.0));
        }
        for i in 0..=100 {
            let x = reach * f64::from(i) / 100.0;
            // the way down is the way up backwards, seen from the upper rail; the centre stays R from the edge; rounding of R
            assert!((up.at(-x) - (down.at(x) - height)).abs() < 1e-15);
            let centre = radius - down.at(x);
            assert!((x.hypot(centre) / radius - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn is_lower_than_the_wheel() {
        let error = Step::new(0.46, -0.5).unwrap_err().to_string();
        assert_eq!(
            error,
            "depth is -0.5 m: a wheel of radius 0.46 m rolls over steps between 0 and 0.46 m, up or down"
        );
        assert!(Step::new(0.46, 0.0).is_err() && Step::new(-1.0, 1e-3).is_err());
    }
}
