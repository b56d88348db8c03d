//! A uniform track on its foundation, and what methods may ask of it.

use crate::foundation::Foundation;
use crate::rail::{Drive, RailError};
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

    /// Refuses `omega` [rad/s] at which an element is no spring.
    ///
    /// # Errors
    /// As [`Stack::check`].
    pub(super) fn check(&self, omega: f64) -> Result<(), RailError> {
        self.stack.check(omega).map_err(crate::foundation::FoundationError::from)?;
        Ok(self.on.check(omega)?)
    }

    /// The same along a moving load: a constant one asks at ω = 0, and any that moves passes it on the way.
    ///
    /// # Errors
    /// As [`Stack::check`].
    pub(super) fn check_drive(&self, drive: Drive) -> Result<(), RailError> {
        // elements that creep bear a load that oscillates; causal hysteresis is no spring around ω = 0
        match self.check(0.0) {
            Err(error) if drive.omega == 0.0 || (drive.speed != 0.0 && error.pushes()) => Err(error),
            _ => self.check(drive.omega),
        }
    }
}
