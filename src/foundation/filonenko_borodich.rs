//! Filonenko-Borodich's foundation: springs under a stretched membrane.

use crate::track::{Link, Member, Spring, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k + Tβ² with k(1 + iη sgn ω) + iωc. Source: Eq. (3).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct FilonenkoBorodich {
    /// k and its losses, or another element
    #[serde(rename = "$rest:stiffness")]
    #[schemars(flatten, with = "Spring")]
    pub springs: Link,
    /// T [N]
    pub tension: f64,
}

impl FilonenkoBorodich {
    /// Membrane – springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        Ok(Stack::new(vec![Member::string(self.tension, 0.0)?], vec![self.springs]))
    }
}
