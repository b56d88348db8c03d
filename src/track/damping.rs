//! Damping in proportion to mass and stiffness: that of Rayleigh, and that of Caughey for any number of modes.

use super::TrackError;
use crate::quantity::{not_negative, positive};
use nalgebra::DMatrix;

/// C = α₁M + α₂K: ζ(ω) = α₁/2ω + α₂ω/2. Source: Eq. (20), corrected.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh {
    /// α₁ [1/s]
    pub of_mass: f64,
    /// α₂ [s]
    pub of_stiffness: f64,
}

impl Rayleigh {
    /// `of_mass` α₁ [1/s] and `of_stiffness` α₂ [s].
    ///
    /// # Errors
    /// Negative ones.
    pub fn new(of_mass: f64, of_stiffness: f64) -> Result<Self, TrackError> {
        Ok(Self {
            of_mass: not_negative("of_mass", of_mass, "1/s")?,
            of_stiffness: not_negative("of_stiffness", of_stiffness, "s")?,
        })
    }

    /// The one that gives two modes, of `omega` ωᵢ and ωⱼ [rad/s], the same `ratio` ζ: α₁ = 2ζωᵢωⱼ/(ωᵢ + ωⱼ), α₂ = 2ζ/(ωᵢ + ωⱼ).
    ///
    /// # Errors
    /// Frequencies that are not positive, a negative ratio.
    pub fn of_modes(ratio: f64, omega: [f64; 2]) -> Result<Self, TrackError> {
        let [i, j] = [positive("omega", omega[0], "rad/s")?, positive("omega", omega[1], "rad/s")?];
        let twice = 2.0 * not_negative("damping_ratio", ratio, "")?;
        Self::new(twice * i * j / (i + j), twice / (i + j))
    }

    /// ζ of a mode of `omega` [rad/s].
    pub fn ratio(&self, omega: f64) -> f64 {
        0.5 * (self.of_mass / omega + self.of_stiffness * omega)
    }
}

/// C = M Σⱼ αⱼ(M⁻¹K)ʲ, j = 0 … N − 1, which gives N modes each its own ζ = ½ Σ αⱼω²ʲ⁻¹. Source: Eq. (21).
#[derive(Clone, Debug, PartialEq)]
pub struct Caughey {
    /// αⱼ [s^(2j − 1)]
    pub alpha: Vec<f64>,
}

impl Caughey {
    /// The one that gives modes of `omega` ωₙ [rad/s] the `ratios` ζₙ.
    ///
    /// With s = ω/r, r the geometric mean of all, aⱼ = αⱼr²ʲ⁻¹ is the polynomial Σ aⱼ(s²)ʲ = 2ζs through the modes: Newton's
    /// divided differences, then its monomials; unscaled, the powers ω⁻¹ … ω²ᴺ⁻³ leave no digits.
    ///
    /// Accuracy: 5e-13 of αⱼ for four modes within a fifth of an octave (test `analytic::springs`).
    ///
    /// # Errors
    /// Frequencies that are not positive or twice the same, a negative ratio, as many ratios as modes or none.
    pub fn of_modes(omega: &[f64], ratios: &[f64]) -> Result<Self, TrackError> {
        for &omega in omega {
            positive("omega", omega, "rad/s")?;
        }
        for &ratio in ratios {
            not_negative("damping_ratio", ratio, "")?;
        }
        let twice = |i: usize| omega[..i].contains(&omega[i]);
        if omega.is_empty() || omega.len() != ratios.len() || (0..omega.len()).any(twice) {
            return Err(TrackError::Modes { modes: omega.len(), ratios: ratios.len() });
        }
        let r = (omega.iter().map(|w| w.ln()).sum::<f64>() / omega.len() as f64).exp();
        let x: Vec<f64> = omega.iter().map(|w| (w / r).powi(2)).collect();
        let mut difference: Vec<f64> =
            omega.iter().zip(ratios).map(|(w, ratio)| 2.0 * ratio * w / r).collect();
        for order in 1..x.len() {
            for i in (order..x.len()).rev() {
                difference[i] = (difference[i] - difference[i - 1]) / (x[i] - x[i - order]);
            }
        }
        // Newton's form from its last term: a ← (X − xᵢ)a + dᵢ
        let mut a = vec![0.0; x.len()];
        for i in (0..x.len()).rev() {
            for j in (1..x.len()).rev() {
                a[j] = a[j - 1] - x[i] * a[j];
            }
            a[0] = difference[i] - x[i] * a[0];
        }
        let alpha = (0i32..).zip(&a).map(|(j, a)| a * r.powi(1 - 2 * j)).collect();
        Ok(Self { alpha })
    }

    /// ζ of a mode of `omega` [rad/s].
    pub fn ratio(&self, omega: f64) -> f64 {
        0.5 * self.alpha.iter().rev().fold(0.0, |sum, alpha| sum * omega * omega + alpha) / omega
    }

    /// C of the `mass` and `stiffness` matrices M and K, by Horner's scheme; None where M is singular.
    pub fn matrix(&self, mass: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let a = mass.clone().lu().solve(stiffness)?;
        let none = DMatrix::zeros(a.nrows(), a.ncols());
        let one = DMatrix::<f64>::identity(a.nrows(), a.ncols());
        Some(mass * self.alpha.iter().rev().fold(none, |sum, &alpha| sum * &a + &one * alpha))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_get_their_ratios() {
        let rayleigh = Rayleigh::of_modes(0.02, [300.0, 900.0]).unwrap();
        for omega in [300.0, 900.0] {
            assert!((rayleigh.ratio(omega) - 0.02).abs() < 1e-16);
        }
        let (omega, ratios) = ([3.0, 50.0, 900.0, 2e4], [0.02, 0.03, 0.015, 0.04]);
        let caughey = Caughey::of_modes(&omega, &ratios).unwrap();
        for (omega, ratio) in omega.iter().zip(ratios) {
            // over four decades the terms cancel; measured 5e-13
            assert!(
                (caughey.ratio(*omega) / ratio - 1.0).abs() < 1e-10,
                "{omega}: {}",
                caughey.ratio(*omega)
            );
        }
        assert!(Caughey::of_modes(&[1.0, 1.0], &[0.1, 0.2]).is_err());
        assert!(Caughey::of_modes(&[1.0, 2.0], &[0.1]).is_err() && Caughey::of_modes(&[], &[]).is_err());
        assert!(
            Rayleigh::of_modes(-0.1, [1.0, 2.0]).is_err() && Rayleigh::of_modes(0.1, [0.0, 2.0]).is_err()
        );
    }
}
