//! Wavenumbers of plane P and S waves of one material at one frequency.

use super::Material;
use crate::math::complex::sqrt_decaying;
use num_complex::Complex64;

/// What a material says at one ω ≥ 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wave {
    /// μ* [Pa]
    pub mu: Complex64,
    /// k_s² = ω²ρ/μ* [rad²/m²]
    pub ks2: Complex64,
    /// k_p² = ω²ρ/(λ + 2μ)*
    pub kp2: Complex64,
    /// γ = μ*/(λ + 2μ)* = k_p²/k_s² = (1 − 2ν)/(2(1 − ν))
    pub gamma: Complex64,
    /// 1/(k_s² − k_p²) = 1/(p² − s²) [m²/rad²]; infinite at ω = 0.
    pub inv_difference: Complex64,
}

impl Wave {
    pub fn new(material: &Material, omega: f64) -> Self {
        let mu = material.complex_shear_modulus(omega);
        let gamma = mu / material.complex_p_modulus(omega);
        let ks2 = omega * omega * material.density() / mu;
        let kp2 = gamma * ks2;
        Self { mu, ks2, kp2, gamma, inv_difference: (ks2 - kp2).inv() }
    }

    /// p = √(k² − k_p²), s = √(k² − k_s²), Re ≥ 0 [rad/m]
    #[inline]
    pub fn vertical(&self, k: f64) -> (Complex64, Complex64) {
        (sqrt_decaying(k * k - self.kp2), sqrt_decaying(k * k - self.ks2))
    }
}
