//! Slab track: rails on pads on a slab that lies on the ground, per metre of whole track.

use super::link::Spring;
use super::member::Beam;
use super::{Link, Member, Stack};
use schemars::JsonSchema;
use serde::Deserialize;

/// A slab track. Source: appendix A.4 (corrected).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Slab {
    /// Both rails.
    #[schemars(with = "Beam")]
    pub rail: Member,
    /// Pads of both rails.
    #[schemars(with = "Spring")]
    pub pad: Link,
    /// The slab.
    #[schemars(with = "Beam")]
    pub slab: Member,
}

impl Slab {
    /// The stack rail – pads – slab.
    pub fn stack(&self) -> Stack {
        Stack::new(vec![self.rail, self.slab], vec![self.pad])
    }
}
