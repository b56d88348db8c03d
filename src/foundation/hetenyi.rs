//! Hetényi's foundation: springs under a plate that bends.

use crate::track::{Link, Member, Spring, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k + Dβ⁴ with k(1 + iη sgn ω) + iωc: under a beam it only adds to its EI. Source: Eq. (4).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Hetenyi {
    /// k and its losses, or another element
    #[serde(rename = "$rest:stiffness")]
    #[schemars(flatten, with = "Spring")]
    pub springs: Link,
    /// D [N m²]
    pub bending_stiffness: f64,
}

impl Hetenyi {
    /// Plate – springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        Ok(Stack::new(vec![Member::beam(self.bending_stiffness, 0.0, 0.0)?], vec![self.springs]))
    }
}
