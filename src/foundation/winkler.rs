//! Winkler's foundation: independent springs.

use crate::track::{Link, Member, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k(1 + iη sgn ω) + iωc at every β. Source: Eqs (2), (19), (23).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Winkler {
    /// k [N/m²]
    pub stiffness: f64,
    /// c [N s/m²]
    #[serde(default)]
    pub damping: f64,
    /// η
    #[serde(default)]
    pub loss_factor: f64,
}

impl Winkler {
    /// Springs under nothing.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        let springs = Link::spring(self.stiffness, self.damping, self.loss_factor)?;
        Ok(Stack::new(vec![Member::mass(0.0)?], vec![springs]))
    }
}
