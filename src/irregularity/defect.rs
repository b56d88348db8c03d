//! Defects of rails and wheels, each by its formula: evaluated at any x, never between samples, where corners would be impacts.

use super::{Dip, DippedJoint, FreshFlat, IrregularityError, Ramp, RoundedFlat, Step};
use crate::quantity::finite;
use schemars::JsonSchema;
use serde::Deserialize;

/// One defect, its x = 0 where its formula has it.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum Defect {
    /// A flat with rounded edges, which belongs to wheels.
    RoundedFlat(RoundedFlat),
    /// A fresh flat, which belongs to wheels.
    FreshFlat(FreshFlat),
    /// A joint to which both rails come down.
    DippedJoint(DippedJoint),
    /// A square edge.
    Step(Step),
    /// A slope from one level to another.
    Ramp(Ramp),
    /// A smooth dip or hump.
    Dip(Dip),
}

impl Defect {
    /// r [m, positive down] at `x` [m].
    pub fn at(&self, x: f64) -> f64 {
        match self {
            Self::RoundedFlat(d) => d.at(x),
            Self::FreshFlat(d) => d.at(x),
            Self::DippedJoint(d) => d.at(x),
            Self::Step(d) => d.at(x),
            Self::Ramp(d) => d.at(x),
            Self::Dip(d) => d.at(x),
        }
    }

    /// What it is, in a word or two.
    pub fn name(&self) -> &'static str {
        match self {
            Self::RoundedFlat(_) | Self::FreshFlat(_) => "flat",
            Self::DippedJoint(_) => "joint",
            Self::Step(_) => "step",
            Self::Ramp(_) => "ramp",
            Self::Dip(_) => "dip",
        }
    }

    /// Whether it turns with a wheel instead of lying in the rail.
    pub fn of_wheel(&self) -> bool {
        matches!(self, Self::RoundedFlat(_) | Self::FreshFlat(_))
    }
}

/// A depth `d` [m] of either sign.
pub(super) fn depth(d: f64) -> Result<f64, IrregularityError> {
    Ok(finite("depth", d, "m")?)
}
