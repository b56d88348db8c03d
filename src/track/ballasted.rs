//! Ballasted tracks: rails, pads, sleepers and ballast, per metre of whole track (both rails), or of one rail and its share.

use super::link::Spring;
use super::section::{Rail, RailKeys, Rails};
use super::{Ballast, Link, Member, Stack, TrackError};
use crate::quantity::not_negative;
use schemars::JsonSchema;
use serde::Deserialize;

/// A ballasted track. Source: appendix A.2 (corrected) and A.3.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Ballasted {
    /// How many rails all numbers stand for; the whole track by default, and to be said of a section.
    pub rails: Option<Rails>,
    /// All of them.
    #[schemars(with = "RailKeys")]
    pub rail: Rail,
    /// Their pads.
    #[schemars(with = "Spring")]
    pub pad: Link,
    /// Sleepers.
    pub sleeper: Sleeper,
    /// Ballast.
    pub ballast: Ballast,
}

/// Sleepers as a continuous mass.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Sleeper {
    /// [kg/m]
    pub mass: f64,
}

impl Ballasted {
    /// The stack rail – pads – sleepers – ballast – base; bars are as wide as the contact with the ground, 2 × `half_width` [m].
    ///
    /// # Errors
    /// A quantity out of its range; bars without a width, without a wave speed, or with two; a section without the number of rails.
    pub fn stack(&self, half_width: Option<f64>) -> Result<Stack, TrackError> {
        let sleepers = Member::mass(not_negative("sleeper.mass", self.sleeper.mass, "kg/m")?)?;
        let mut members = vec![self.rail.member(self.rails)?, sleepers];
        members.extend(self.ballast.foot()?);
        Ok(Stack::new(members, vec![self.pad, self.ballast.link(half_width)?]))
    }
}
