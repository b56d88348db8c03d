//! What lies along the track: beams, strings and continuous masses.

use super::TrackError;
use crate::math::complex::sign;
use crate::quantity::{not_negative, positive};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;

/// A member per metre of track that resists bending, as an Euler–Bernoulli beam, or a difference of slope, as a string or a shear
/// layer does, or both; with neither a plain continuous mass (sleepers).
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(try_from = "Beam")]
pub struct Member {
    bending_stiffness: f64,
    tension: f64,
    mass: f64,
    loss_factor: f64,
}

/// A beam along the track, as a case file says it.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Beam {
    /// EI [N m²]
    bending_stiffness: f64,
    /// [kg/m]
    mass: f64,
    /// η of EI
    #[serde(default)]
    loss_factor: f64,
}

impl TryFrom<Beam> for Member {
    type Error = TrackError;

    fn try_from(beam: Beam) -> Result<Self, TrackError> {
        // a member without is a mass, a beam must bend
        positive("bending_stiffness", beam.bending_stiffness, "N m²")?;
        Self::beam(beam.bending_stiffness, beam.mass, beam.loss_factor)
    }
}

impl Member {
    /// A beam of bending stiffness EI [N m²], `mass` [kg/m] and loss factor η of EI.
    ///
    /// # Errors
    /// Anything negative or not finite.
    pub fn beam(bending_stiffness: f64, mass: f64, loss_factor: f64) -> Result<Self, TrackError> {
        Ok(Self {
            bending_stiffness: not_negative("bending_stiffness", bending_stiffness, "N m²")?,
            tension: 0.0,
            mass: not_negative("mass", mass, "kg/m")?,
            loss_factor: not_negative("loss_factor", loss_factor, "")?,
        })
    }

    /// A string under `tension` N [N], or a layer of shear stiffness N that cannot bend, with `mass` [kg/m].
    ///
    /// # Errors
    /// Anything negative or not finite.
    pub fn string(tension: f64, mass: f64) -> Result<Self, TrackError> {
        let tension = not_negative("tension", tension, "N")?;
        Ok(Self { tension, ..Self::mass(mass)? })
    }

    /// A continuous `mass` [kg/m] that neither bends nor shears.
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

    /// Neither bends nor shears: a mass.
    pub(super) fn is_mass(&self) -> bool {
        self.bending_stiffness == 0.0 && self.tension == 0.0
    }

    /// EI(1 + iη sgn ω)β⁴ + Nβ² − ω²m [N/m²] at `beta2` = β² [rad²/m²], which may be complex. Source: Eqs (3), (13), (23).
    #[inline]
    pub fn stiffness(&self, beta2: Complex64, omega: f64) -> Complex64 {
        let bending = self.bending_stiffness * Complex64::new(1.0, self.loss_factor * sign(omega));
        (bending * beta2 + self.tension) * beta2 - omega * omega * self.mass
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_roots_in_complex_beta() {
        // (EI β² + N) β² = ω²m: one wave travels, the other decays; measured 1e-16
        let (ei, n, m, omega) = (1.3e7, 2e6, 120.0, 90.0f64);
        let prestressed = Member { tension: n, ..Member::beam(ei, m, 0.0).unwrap() };
        let root = (n * n + 4.0 * ei * m * omega * omega).sqrt();
        for beta2 in [(root - n) / (2.0 * ei), -(root + n) / (2.0 * ei)] {
            let rest = prestressed.stiffness(beta2.into(), omega);
            assert!(rest.norm() < 1e-14 * omega * omega * m, "{rest}");
        }
        // c = √(N/m) on a string, at any β
        let string = Member::string(n, m).unwrap();
        let beta = omega / (n / m).sqrt();
        assert!(string.stiffness((beta * beta).into(), omega).norm() < 1e-14 * omega * omega * m);
        // β² = −i: β⁴ = −1
        let at = Member::beam(ei, 0.0, 0.1).unwrap().stiffness(Complex64::new(0.0, -1.0), omega);
        assert!((at + ei * Complex64::new(1.0, 0.1)).norm() < 1e-15 * ei);
        assert!(Member::string(-1.0, 0.0).is_err() && Member::string(1.0, f64::NAN).is_err());
    }
}
