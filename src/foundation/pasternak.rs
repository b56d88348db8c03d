//! Pasternak's foundation: springs under a layer that shears.

use crate::quantity::not_negative;
use crate::track::{Link, Member, Spring, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k + Gβ² with k(1 + iη sgn ω) + iωc. Source: Eq. (5).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Pasternak {
    /// k and its losses, or another element
    #[serde(rename = "$rest:stiffness")]
    #[schemars(flatten, with = "Spring")]
    pub springs: Link,
    /// G [N]
    pub shear: f64,
}

impl Pasternak {
    /// Shear layer – springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        let layer = Member::string(not_negative("shear", self.shear, "N")?, 0.0)?;
        Ok(Stack::new(vec![layer], vec![self.springs]))
    }
}
