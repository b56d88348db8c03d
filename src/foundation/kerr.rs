//! Kerr's foundation: springs on a layer that shears on springs.

use crate::quantity::{not_negative, positive};
use crate::track::{Link, Member, Spring, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k₁(k₂ + Gβ²)/(k₁ + k₂ + Gβ²) with k₂(1 + iη sgn ω) + iωc. Source: Eq. (6), whose k₁/k₂ is inverted as printed.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Kerr {
    /// k₂ of the lower springs and their losses, or another element
    #[serde(rename = "$rest:stiffness")]
    #[schemars(flatten, with = "Spring")]
    pub springs: Link,
    /// G [N]
    pub shear: f64,
    /// k₁ [N/m²], the upper springs, which lose nothing
    pub upper_stiffness: f64,
}

impl Kerr {
    /// Upper springs – shear layer – lower springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        let upper = Link::spring(positive("upper_stiffness", self.upper_stiffness, "N/m²")?, 0.0, 0.0)?;
        let layer = Member::string(not_negative("shear", self.shear, "N")?, 0.0)?;
        Ok(Stack::new(vec![Member::mass(0.0)?, layer], vec![upper, self.springs]))
    }
}
