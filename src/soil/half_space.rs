//! The homogeneous half-space in closed form: the oracle of every solver.

use super::wave::Wave;
use super::{Material, SurfaceCompliance};
use crate::math::complex::I;
use num_complex::Complex64;

/// Surface compliance of a half-space at radial wavenumber `k` > 0 [rad/m] and `omega` [rad/s].
///
/// G_zz = p k_s² / (μ (4k² p s − (2k² − k_s²)²)), and (1 − ν)/(μk) at ω = 0. The textbook form on purpose: it
/// loses (k c_s/ω)² digits as ω → 0, so it is a witness for ω/(k c_s) ≳ 1e-3 and at ω = 0 only.
/// Source: THEORY 2; Kausel 2006, table 10.2.
pub fn surface_compliance(material: &Material, k: f64, omega: f64) -> SurfaceCompliance {
    let wave = Wave::new(material, omega);
    let mu = wave.mu;
    let (p, s) = wave.vertical(k);
    if omega == 0.0 {
        // γ = (1 − 2ν)/(2(1 − ν)): 1 − ν = 1/(2(1 − γ))
        let nu1 = 0.5 / (1.0 - wave.gamma);
        let u_zz = nu1 / (mu * k);
        // (1 − 2ν)/(2μk) = γ/(2(1 − γ)μk)
        let u_xz = I * (0.5 * wave.gamma / (1.0 - wave.gamma)) / (mu * k);
        return SurfaceCompliance { u_zz, u_xx: u_zz, u_xz, u_yy: 1.0 / (mu * k) };
    }
    let q = 2.0 * k * k - wave.ks2;
    let rayleigh = mu * (4.0 * k * k * p * s - q * q);
    SurfaceCompliance {
        u_zz: p * wave.ks2 / rayleigh,
        u_xx: s * wave.ks2 / rayleigh,
        u_xz: I * (k * (q - 2.0 * p * s)) / rayleigh,
        u_yy: 1.0 / (mu * s),
    }
}

/// Vertical surface displacement [m] at distance `r` [m] of a constant point load `force` [N] moving at `speed` v < c_R on
/// an undamped half-space, in the moving frame; `theta` [rad] is the angle of the receiver from the direction of travel.
///
/// u_z = F/(2πμr) · m²√(1−κ²m²) / (4√(1−κ²m²)√(1−m²) − (2−m²)²), m = v|sin θ|/c_s, κ = c_s/c_p;
/// (1 − ν)F/(2πμr) (Boussinesq) where m → 0.
/// Accuracy: loses digits like 1e-16/m²; the static form is used below m = 1e-4, where it is exact to 1e-8.
/// Source: THEORY 2.
pub fn moving_point_load(material: &Material, force: f64, speed: f64, r: f64, theta: f64) -> f64 {
    let m = speed * theta.sin().abs() / material.c_s();
    let kappa = material.c_s() / material.c_p();
    let shape = if m < 1e-4 {
        1.0 - material.poisson()
    } else {
        let (alpha, beta) = ((1.0 - (kappa * m).powi(2)).sqrt(), (1.0 - m * m).sqrt());
        m * m * alpha / (4.0 * alpha * beta - (2.0 - m * m).powi(2))
    };
    force * shape / (2.0 * std::f64::consts::PI * material.shear_modulus() * r)
}

/// The two leading terms of G_zz for k → ∞: G_zz ≈ A/k + C/k³, with A = (1 − ν*)/μ*.
///
/// From the expansion of the closed form in e = k_s²/k²: C = A k_s² [ (2 + (1−γ)²)/(4(1−γ)) − γ/2 ].
/// A layered profile differs from its top material only by e^{−2kh}. Next term O(k⁻⁵).
pub fn static_tail(material: &Material, omega: f64) -> (Complex64, Complex64) {
    let wave = Wave::new(material, omega);
    let one_minus = 1.0 - wave.gamma;
    let a = 0.5 / (wave.mu * one_minus);
    let c = a * wave.ks2 * ((2.0 + one_minus * one_minus) / (4.0 * one_minus) - 0.5 * wave.gamma);
    (a, c)
}

/// G_xz ≈ i γA/k for k → ∞: γA = γ/(2μ*(1 − γ)).
pub fn horizontal_tail(material: &Material, omega: f64) -> Complex64 {
    let wave = Wave::new(material, omega);
    0.5 * wave.gamma / (wave.mu * (1.0 - wave.gamma))
}

#[cfg(test)]
mod tests {
    use super::super::Elastic;
    use super::*;

    #[test]
    fn static_tail_has_order_five() {
        let material =
            Material::new(Elastic::YoungPoisson { young: 60e6, poisson: 0.35 }, 1500.0, 0.06, 0.06).unwrap();
        let omega = 100.0;
        let (a, c) = static_tail(&material, omega);
        let rest = |k: f64| (surface_compliance(&material, k, omega).u_zz - a / k - c / k.powi(3)).norm();
        let order = (rest(8.0) / rest(16.0)).log2();
        // measured 5.05
        assert!((order - 5.0).abs() < 0.1, "{order}");
    }
}
