//! Filonenko-Borodich's foundation: springs under a stretched membrane.

use crate::track::{Link, Member, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// k + Tβ² with k(1 + iη sgn ω) + iωc. Source: Eq. (3).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct FilonenkoBorodich {
    /// k [N/m²]
    pub stiffness: f64,
    /// c [N s/m²]
    #[serde(default)]
    pub damping: f64,
    /// η of the springs
    #[serde(default)]
    pub loss_factor: f64,
    /// T [N]
    pub tension: f64,
}

impl FilonenkoBorodich {
    /// Membrane – springs.
    pub(super) fn stack(&self) -> Result<Stack, TrackError> {
        let springs = Link::spring(self.stiffness, self.damping, self.loss_factor)?;
        Ok(Stack::new(vec![Member::string(self.tension, 0.0)?], vec![springs]))
    }
}
