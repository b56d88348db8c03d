//! Slab track: rails on pads on a slab that lies on the ground, per metre of whole track.

use super::link::Spring;
use super::member::Beam;
use super::section::{Rail, RailKeys, Rails};
use super::{Link, Member, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// A slab track. Source: appendix A.4 (corrected).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Slab {
    /// How many rails all numbers stand for; the whole track by default, and to be said of a section.
    pub rails: Option<Rails>,
    /// All of them.
    #[schemars(with = "RailKeys")]
    pub rail: Rail,
    /// Their pads.
    #[schemars(with = "Spring")]
    pub pad: Link,
    /// The slab.
    #[schemars(with = "Beam")]
    pub slab: Member,
}

impl Slab {
    /// The stack rail – pads – slab.
    ///
    /// # Errors
    /// A section without the number of rails.
    pub fn stack(&self) -> Result<Stack, TrackError> {
        Ok(Stack::new(vec![self.rail.member(self.rails)?, self.slab], vec![self.pad]))
    }
}
