//! Independent springs.

use super::{Foundation, FoundationError, Moving, Stiffness};
use crate::math::complex::sign;
use crate::quantity::{not_negative, positive};
use num_complex::Complex64;

/// k(1 + iη sgn ω) + iωc, the same for every β. Source: Eq. (2), (19), (23).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winkler {
    stiffness: f64,
    damping: f64,
    loss_factor: f64,
}

impl Winkler {
    /// Springs of `stiffness` k [N/m²], viscous `damping` c [N s/m²] and `loss_factor` η.
    ///
    /// # Errors
    /// A stiffness that is not positive, negative damping.
    pub fn new(stiffness: f64, damping: f64, loss_factor: f64) -> Result<Self, FoundationError> {
        Ok(Self {
            stiffness: positive("stiffness", stiffness, "N/m²")?,
            damping: not_negative("damping", damping, "N s/m²")?,
            loss_factor: not_negative("loss_factor", loss_factor, "")?,
        })
    }

    fn at(&self, omega: f64) -> Complex64 {
        Complex64::new(self.stiffness, self.stiffness * self.loss_factor * sign(omega) + omega * self.damping)
    }
}

impl Foundation for Winkler {
    fn stiffness_to(&self, _beta: f64, omega: f64, _relative: f64) -> Result<Stiffness, FoundationError> {
        Ok(Stiffness { value: self.at(omega), relative_error: 0.0, converged: true, count: 0 })
    }

    fn moving(
        &self,
        speed: f64,
        _from: f64,
        _to: f64,
        _allowed: &dyn Fn(f64, Complex64) -> f64,
    ) -> Result<Moving<'_>, FoundationError> {
        Ok(Moving {
            stiffness: Box::new(move |beta| self.at(-beta * speed)),
            converged: true,
            worst: 0.0,
            count: 0,
        })
    }
}
