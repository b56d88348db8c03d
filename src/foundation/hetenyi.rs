//! Hetényi's foundation: springs under a plate that bends.

use crate::track::{Link, Member, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k + Dβ⁴ with k(1 + iη sgn ω) + iωc: under a beam it only adds to its EI. Source: Eq. (4).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Hetenyi {
    /// k [N/m²]
    pub stiffness: f64,
    /// c [N s/m²]
    #[serde(default)]
    pub damping: f64,
    /// η of the springs
    #[serde(default)]
    pub loss_factor: f64,
    /// D [N m²]
    pub bending_stiffness: f64,
}

impl Hetenyi {
    /// Plate – springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        let springs = Link::spring(self.stiffness, self.damping, self.loss_factor)?;
        Ok(Stack::new(vec![Member::beam(self.bending_stiffness, 0.0, 0.0)?], vec![springs]))
    }
}
