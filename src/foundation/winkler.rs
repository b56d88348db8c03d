//! Winkler's foundation: independent springs.

use crate::track::{Link, Member, Spring, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k(1 + iη sgn ω) + iωc at every β. Source: Eqs (2), (19), (23).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Winkler {
    /// k and its losses, or another element
    #[serde(rename = "$rest:stiffness")]
    #[schemars(flatten, with = "Spring")]
    pub springs: Link,
}

impl Winkler {
    /// Springs under nothing.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        Ok(Stack::new(vec![Member::mass(0.0)?], vec![self.springs]))
    }
}
