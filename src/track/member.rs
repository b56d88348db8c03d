//! What lies along the track: beams and continuous masses.

use super::TrackError;
use crate::math::complex::sign;
use crate::quantity::not_negative;
use num_complex::Complex64;

/// An Euler–Bernoulli beam per metre of track; without bending stiffness a plain continuous mass (sleepers).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    bending_stiffness: f64,
    mass: f64,
    loss_factor: f64,
}

impl Member {
    /// A beam of bending stiffness EI [N m²], `mass` [kg/m] and loss factor η of EI.
    ///
    /// # Errors
    /// Anything negative or not finite.
    pub fn beam(bending_stiffness: f64, mass: f64, loss_factor: f64) -> Result<Self, TrackError> {
        Ok(Self {
            bending_stiffness: not_negative("bending_stiffness", bending_stiffness, "N m²")?,
            mass: not_negative("mass", mass, "kg/m")?,
            loss_factor: not_negative("loss_factor", loss_factor, "")?,
        })
    }

    /// A continuous `mass` [kg/m] without bending stiffness.
    ///
    /// # Errors
    /// A negative or non-finite mass.
    pub fn mass(mass: f64) -> Result<Self, TrackError> {
        Self::beam(0.0, mass, 0.0)
    }

    /// The same member without dissipation.
    pub fn undamped(self) -> Self {
        Self { loss_factor: 0.0, ..self }
    }

    /// Without bending stiffness: a mass.
    pub(super) fn is_mass(&self) -> bool {
        self.bending_stiffness == 0.0
    }

    /// EI(1 + iη sgn ω)β⁴ − ω²m [N/m²]. Source: Eqs (13), (23).
    #[inline]
    pub fn stiffness(&self, beta: f64, omega: f64) -> Complex64 {
        let beta2 = beta * beta;
        self.bending_stiffness * Complex64::new(1.0, self.loss_factor * sign(omega)) * (beta2 * beta2)
            - omega * omega * self.mass
    }
}
