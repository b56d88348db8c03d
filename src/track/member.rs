//! What lies along the track: beams, strings and continuous masses.

use super::{Element, Rayleigh, TrackError};
use crate::math::complex::{I, sign};
use crate::quantity::{not_negative, positive};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;

/// A member per metre of track that resists bending, as an Euler–Bernoulli or a Timoshenko beam, or a difference of displacement, as
/// a string or a shear layer does, or both; with neither a plain continuous mass (sleepers).
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(try_from = "Beam")]
pub struct Member {
    /// EI [N m²]
    pub(crate) bending_stiffness: f64,
    /// 1/κGA [1/N]; 0 for Euler–Bernoulli beams.
    pub(crate) shear_compliance: f64,
    /// ρI [kg m]
    pub(crate) rotary_inertia: f64,
    /// N(ω) [N]
    pub(crate) tension: Option<Element>,
    pub(crate) mass: f64,
    /// η of EI and κGA.
    pub(crate) loss_factor: f64,
    pub(crate) rayleigh: Rayleigh,
}

/// A beam along the track, as a case file says it.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beam {
    /// EI [N m²]
    pub bending_stiffness: f64,
    /// [kg/m]
    pub mass: f64,
    /// κGA [N]; with it a Timoshenko beam
    pub shear_stiffness: Option<f64>,
    /// ρI [kg m]
    #[serde(default)]
    pub rotary_inertia: f64,
    /// η of EI and κGA
    #[serde(default)]
    pub loss_factor: f64,
}

impl TryFrom<Beam> for Member {
    type Error = TrackError;

    fn try_from(beam: Beam) -> Result<Self, TrackError> {
        // a member without is a mass, a beam must bend
        positive("bending_stiffness", beam.bending_stiffness, "N m²")?;
        let Beam { bending_stiffness, mass, shear_stiffness, rotary_inertia, loss_factor } = beam;
        match shear_stiffness {
            Some(shear) => Self::timoshenko(bending_stiffness, mass, shear, rotary_inertia, loss_factor),
            None => {
                let rotary_inertia = not_negative("rotary_inertia", rotary_inertia, "kg m")?;
                Ok(Self { rotary_inertia, ..Self::beam(bending_stiffness, mass, loss_factor)? })
            }
        }
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
            shear_compliance: 0.0,
            rotary_inertia: 0.0,
            tension: None,
            mass: not_negative("mass", mass, "kg/m")?,
            loss_factor: not_negative("loss_factor", loss_factor, "")?,
            rayleigh: Rayleigh::default(),
        })
    }

    /// A Timoshenko beam: as [`Self::beam`], with κGA = `shear_stiffness` [N], to which η belongs too, and ρI = `rotary_inertia`
    /// [kg m].
    ///
    /// # Errors
    /// Anything negative or not finite, no shear stiffness.
    pub fn timoshenko(
        bending_stiffness: f64,
        mass: f64,
        shear_stiffness: f64,
        rotary_inertia: f64,
        loss_factor: f64,
    ) -> Result<Self, TrackError> {
        Ok(Self {
            shear_compliance: 1.0 / positive("shear_stiffness", shear_stiffness, "N")?,
            rotary_inertia: not_negative("rotary_inertia", rotary_inertia, "kg m")?,
            ..Self::beam(bending_stiffness, mass, loss_factor)?
        })
    }

    /// A string under `tension` N [N], or a layer of shear stiffness N that cannot bend, with `mass` [kg/m]. Of masses in a row,
    /// each joined to the next by a spring, it is the spring [N/m], β² then 2(1 − cos βL).
    ///
    /// # Errors
    /// Anything negative or not finite.
    pub fn string(tension: f64, mass: f64) -> Result<Self, TrackError> {
        let tension = not_negative("tension", tension, "N")?;
        let element = Element::Spring { stiffness: tension, damping: 0.0, loss_factor: 0.0 };
        Ok(if tension > 0.0 { Self::mass(mass)?.joined(element) } else { Self::mass(mass)? })
    }

    /// The same member under the tension of `element` [N].
    pub fn joined(self, element: Element) -> Self {
        Self { tension: Some(element), ..self }
    }

    /// The same member with damping α₁ of its mass and inertia and α₂ of its EI and κGA, besides its loss factor; springs under it
    /// have their own, c = α₂k.
    pub fn damped(self, rayleigh: Rayleigh) -> Self {
        Self { rayleigh, ..self }
    }

    /// A continuous `mass` [kg/m] that neither bends nor shears.
    ///
    /// # Errors
    /// A negative or non-finite mass.
    pub fn mass(mass: f64) -> Result<Self, TrackError> {
        Self::beam(0.0, mass, 0.0)
    }

    /// `count` such members side by side.
    pub fn times(self, count: f64) -> Self {
        Self {
            bending_stiffness: count * self.bending_stiffness,
            shear_compliance: self.shear_compliance / count,
            rotary_inertia: count * self.rotary_inertia,
            tension: self.tension.map(|tension| tension.times(count)),
            mass: count * self.mass,
            ..self
        }
    }

    /// Refuses `omega` [rad/s] at which its tension is no spring.
    ///
    /// # Errors
    /// As [`Element::check`].
    pub fn check(&self, omega: f64) -> Result<(), TrackError> {
        self.tension.map_or(Ok(()), |tension| tension.check(omega))
    }

    /// The same member without dissipation.
    pub fn undamped(self) -> Self {
        let rayleigh = Rayleigh::default();
        Self { loss_factor: 0.0, rayleigh, tension: self.tension.map(Element::undamped), ..self }
    }

    /// Neither bends nor shears: a mass.
    pub(crate) fn is_mass(&self) -> bool {
        self.bending_stiffness == 0.0 && self.tension.is_none()
    }

    /// Whether bending it costs energy.
    pub fn loses(&self) -> bool {
        self.loss_factor > 0.0
    }

    /// Whether neighbours feel one another through it: β² matters.
    pub fn joins(&self) -> bool {
        !self.is_mass()
    }

    /// 1 + iη sgn ω + iωα₂
    pub(crate) fn loss(&self, omega: f64) -> Complex64 {
        Complex64::new(1.0, self.loss_factor * sign(omega) + omega * self.rayleigh.of_stiffness)
    }

    /// lim β²ũ [m/N] = 1/(κGA − mv²), and √(κGA/EI) [rad/m], of a beam that shears under a load of `omega` [rad/s] at `speed` v [m/s],
    /// with its loss where that stands; None of others.
    pub fn at_short_waves(&self, omega: f64, speed: f64) -> Option<(Complex64, f64)> {
        let loss = if speed == 0.0 { self.loss(omega) } else { Complex64::ONE };
        let shear = 1.0 / self.shear_compliance;
        let limit = 1.0 / (shear * loss - self.mass * speed * speed);
        self.shears().then(|| (limit, (shear / self.bending_stiffness).sqrt()))
    }

    /// d of ũ = 1/d(X), X = β², of a beam that bends without shear on springs of `stiffness` k [N/m²], under a load of `omega` [rad/s]
    /// at `speed` v [m/s]: (EI − ρIv²) X² + (N − mv² − ρIω²) X + k − mω², with its loss where the load stands; None of
    /// others.
    pub fn on_springs(&self, stiffness: f64, omega: f64, speed: f64) -> Option<[Complex64; 3]> {
        let loss = if speed == 0.0 { self.loss(omega) } else { Complex64::ONE };
        let (inertia, mass) = (self.rotary_inertia, self.mass);
        let tension = self.tension(0.0) - mass * speed * speed - inertia * omega * omega;
        let bending = self.bending_stiffness * loss - inertia * speed * speed;
        (self.bends() && !self.shears())
            .then(|| [(stiffness - mass * omega * omega).into(), tension, bending])
    }

    /// Resists bending.
    pub fn bends(&self) -> bool {
        self.bending_stiffness > 0.0
    }

    /// Shears where it bends: a Timoshenko beam.
    pub fn shears(&self) -> bool {
        self.bends() && self.shear_compliance > 0.0
    }

    /// EI(1 + iη sgn ω + iωα₂) [N m²] and 1/κGA(1 + iη sgn ω + iωα₂) [1/N].
    fn moduli(&self, omega: f64) -> (Complex64, Complex64) {
        let loss = self.loss(omega);
        (self.bending_stiffness * loss, self.shear_compliance / loss)
    }

    /// ω² − iωα₁ [1/s²], which times a mass is its inertia
    pub(crate) fn inertia(&self, omega: f64) -> Complex64 {
        Complex64::new(omega * omega, -omega * self.rayleigh.of_mass)
    }

    pub(crate) fn tension(&self, omega: f64) -> Complex64 {
        self.tension.map_or(Complex64::ZERO, |tension| tension.stiffness(omega))
    }

    /// bβ²/(1 + b/κGA) + Nβ² − ω²m [N/m²], b = EIβ² − ρIω², at `beta2` = β² [rad²/m²], which may be complex: EIβ⁴ + Nβ² − ω²m of
    /// an Euler–Bernoulli beam. Source: Eqs (3), (13), (16) corrected, (23), (91).
    #[inline]
    pub fn stiffness(&self, beta2: Complex64, omega: f64) -> Complex64 {
        let (bending, shear) = self.moduli(omega);
        let inertia = self.inertia(omega);
        let b = bending * beta2 - inertia * self.rotary_inertia;
        (b / (1.0 + b * shear) + self.tension(omega)) * beta2 - inertia * self.mass
    }

    /// Numerator n₀ + n₁X and denominator d₀ + d₁X + d₂X² in X = β² of ũ = 1/(`stiffness` + K) on springs of K = `support` [N/m²].
    ///
    /// n = 1 + b/κGA, d = (NX + K − ω²m) n + bX, b = EI X − ρIω².
    pub fn rational(&self, omega: f64, support: Complex64) -> ([Complex64; 2], [Complex64; 3]) {
        let (bending, shear) = self.moduli(omega);
        let (inertia, tension) = (self.inertia(omega) * self.rotary_inertia, self.tension(omega));
        let n = [1.0 - shear * inertia, shear * bending];
        let rest = support - self.inertia(omega) * self.mass;
        (n, [rest * n[0], rest * n[1] + tension * n[0] - inertia, tension * n[1] + bending])
    }

    /// What a wave e^{iβx} of unit displacement carries at `beta` [rad/m], which may be complex: rotation φ [rad/m], force −Q [N/m] and
    /// moment −M [N] of the left part on the right one.
    ///
    /// φ = iβ/(1 + b/κGA), −Q = −iβ b/(1 + b/κGA) (and −iβN), −M = −EI iβφ, b = EIβ² − ρIω².
    pub fn carried(&self, beta: Complex64, omega: f64) -> [Complex64; 3] {
        let (bending, shear) = self.moduli(omega);
        let b = bending * beta * beta - self.inertia(omega) * self.rotary_inertia;
        let slope = I * beta;
        let rotation = slope / (1.0 + b * shear);
        [rotation, -(rotation * b + slope * self.tension(omega)), -bending * slope * rotation]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_roots_in_complex_beta() {
        // (EI β² + N) β² = ω²m: one wave travels, the other decays; measured 1e-16
        let (ei, n, m, omega) = (1.3e7, 2e6, 120.0, 90.0f64);
        let prestressed = Member::beam(ei, m, 0.0).unwrap().joined(Element::spring(n, 0.0, 0.0).unwrap());
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
