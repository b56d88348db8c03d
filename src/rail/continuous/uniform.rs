//! A uniform track on its foundation, and what methods may ask of it.

use crate::foundation::Foundation;
use crate::rail::{Drive, RailError, TrackOnFoundation};
use crate::track::{Stack, Tower};

/// A uniform track on its foundation.
pub struct Uniform<'a> {
    pub(super) stack: &'a Stack,
    pub(super) on: &'a dyn Foundation,
    /// Down to rock, if it stands on springs.
    tower: Option<Tower>,
}

impl<'a> Uniform<'a> {
    /// `stack` on the foundation `on`.
    pub fn new(stack: &'a Stack, on: &'a dyn Foundation) -> Self {
        let tower = on.springs().and_then(|springs| Tower::new(stack, springs.stack()));
        Self { stack, on, tower }
    }

    /// The chain down to rock, for the `method` that needs it.
    ///
    /// # Errors
    /// Ground below, or rock under the lowest mass.
    pub(super) fn tower(&self, method: &'static str) -> Result<&Tower, RailError> {
        self.tower.as_ref().ok_or_else(|| self.unknown(method))
    }

    /// The chain down to rock, where there is one.
    pub(super) fn springs(&self) -> Option<&Tower> {
        self.tower.as_ref()
    }

    /// What a `method` says that needs springs.
    pub(super) fn unknown(&self, method: &'static str) -> RailError {
        RailError::Method { method, track: "a track on layered ground", able: "adaptive" }
    }

    /// Refuses loads under which an element is no spring.
    ///
    /// # Errors
    /// As [`Stack::check`].
    pub(super) fn check(&self, drive: Drive) -> Result<(), RailError> {
        Ok(TrackOnFoundation::new(self.stack, self.on, 0.0).check(drive.omega, drive.speed)?)
    }
}
