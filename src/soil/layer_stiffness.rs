//! Exact stiffness matrices of a layer and of a half-space at (k, ω), without loss of digits at any kh or ω.
//!
//! Unknowns: u_x = i u and u_z = w, tractions τ_xz = iτ and σ_zz = σ, so that the undamped matrices are real.
//! A layer of half-thickness a = h/2 is split into motions even and odd about its mid-plane. With
//!
//! ```text
//! f(x) = tanh(xa)/x,  F = (f(p) − f(s))/(p² − s²),  γ = k_p²/k_s²
//! D₊ = γ f(p) − (1 − γ) k² F        D₋ = f(s) + (1 − γ) k² F
//!
//! K₊ = μ | p² f(p) f(s)/D₊    k(2 − f(s)/D₊) |     u even, w odd
//!        | k(2 − f(s)/D₊)     1/D₊           |
//! K₋ = μ | 1/D₋               k(2 − f(p)/D₋) |     u odd, w even
//!        | k(2 − f(p)/D₋)     s² f(p) f(s)/D₋|
//! ```
//!
//! Both follow from Kausel & Roësset (1981) after dividing their determinants, which vanish like k_s² as P and S
//! waves merge, by k_s² in closed form: f and F are regular at ω = 0, where p = s = k, so no switch is needed.
//! The matrices of top and bottom face are sums and differences; the difference, e^{−kh} small, has its own
//! closed form (`cross`). Test: every entry of `reference/surface_compliance.csv`.

use super::wave::Wave;
use crate::math::complex::{one_minus_exp_over, one_minus_exp_series, sqrt_decaying};
use nalgebra::{Matrix1, Matrix2, SMatrix};
use num_complex::Complex64;

/// Stiffness of a layer for N displacements per face: interface tractions =
/// [[M·direct·M, M·cross], [cross·M, direct]] · (top, bottom) displacements, M = diag(1, −1, …) turning the layer
/// upside down. N = 2 in plane (u, w), N = 1 anti-plane (u_y).
#[derive(Clone, Copy, Debug)]
pub(super) struct LayerStiffness<const N: usize> {
    /// Bottom traction per bottom displacement; (K₊ + K₋)/2 in plane.
    pub direct: SMatrix<Complex64, N, N>,
    /// Bottom traction per (turned) top displacement; (K₊ − K₋)/2 in plane.
    pub cross: SMatrix<Complex64, N, N>,
}

impl LayerStiffness<2> {
    /// In-plane stiffness of a layer of `thickness` [m]; one formula, and therefore one long function.
    pub fn layer(wave: &Wave, thickness: f64, k: f64) -> Self {
        let Wave { mu, ks2, kp2, gamma, inv_difference } = *wave;
        let (p, s) = wave.vertical(k);
        let h = thickness;
        let (p2, s2) = (k * k - kp2, k * k - ks2);
        let (e_p, e_s) = ((-p * h).exp(), (-s * h).exp());
        let (inv_p, inv_s) = ((1.0 + e_p).inv(), (1.0 + e_s).inv());
        // f(x) = tanh(xa)/x = (1 − e^{−xh})/(x (1 + e^{−xh}))
        let f_p = h * one_minus_exp_over(p * h, e_p) * inv_p;
        let f_s = h * one_minus_exp_over(s * h, e_s) * inv_s;
        // sech²(xa) = 4 e^{−xh}/(1 + e^{−xh})²
        let sech_p = 4.0 * e_p * inv_p * inv_p;
        let sech_s = 4.0 * e_s * inv_s * inv_s;

        let sum = p + s;
        // at k = ω = 0 both p + s and p − s vanish
        let inv_sum = if sum == Complex64::ZERO { sum } else { sum.inv() };
        let difference = ks2 - kp2; // p² − s², exact
        let x = difference * inv_sum * h; // (p − s)h, free of cancellation
        // (e^{−sh} − e^{−ph})/(p − s)
        let q = if x.norm_sqr() > 0.04 {
            (e_s - e_p) * (sum * inv_difference)
        } else {
            e_s * h * one_minus_exp_series(x)
        };
        let inv_w = inv_p * inv_s;
        // F: plain difference where p² and s² are well apart, else tanh a − tanh b = sinh(a − b)/(cosh a cosh b);
        // −a³/3 at k = ω = 0
        let f = if sum == Complex64::ZERO {
            Complex64::from(-h * h * h / 24.0)
        } else if difference.norm_sqr() > 0.0625 * p2.norm_sqr() {
            (f_p - f_s) * inv_difference
        } else {
            (2.0 * s * q * inv_w - s * f_s) / (p * s * sum)
        };
        // divided difference of sech²(xa) over (p², s²); (1 − e^{−(p+s)h})/(p + s) as a series where it is small
        let both = sum * h;
        let ratio =
            if both.norm_sqr() > 0.04 { (1.0 - e_p * e_s) * inv_sum } else { h * one_minus_exp_series(both) };
        let sech = -4.0 * q * inv_w * inv_w * ratio;

        let rest = (1.0 - gamma) * (k * k);
        let d_even = gamma * f_p - rest * f;
        let d_odd = f_s + rest * f;
        let inv_both = (d_even * d_odd).inv();
        let (inv_even, inv_odd) = (d_odd * inv_both, d_even * inv_both);
        let ff = f_p * f_s;
        let half = 0.5 * mu;
        let off = half * k * (4.0 - f_s * inv_even - f_p * inv_odd);
        let direct = Matrix2::new(
            half * (p2 * ff * inv_even + inv_odd),
            off,
            off,
            half * (inv_even + s2 * ff * inv_odd),
        );
        // K₊ − K₋, every term with its e^{−xh} in front
        let scale = half * inv_both;
        // divided difference of sinh(xh)/(2x), times sech²(pa) sech²(sa)
        let g = rest * (sech_p * f - f_p * sech);
        let off = scale * k * (1.0 - gamma) * sech;
        let cross = Matrix2::new(scale * (g - gamma * f_p * sech_s), off, off, scale * (g + f_s * sech_p));
        Self { direct, cross }
    }

    /// Stiffness at the surface of a half-space: R = (k² − ps)/k_s² = (p + γs)/(p + s),
    /// K = μ [[p/R, k(1/R − 2)], [k(1/R − 2), s/R]].
    pub fn half_space(wave: &Wave, k: f64) -> Matrix2<Complex64> {
        Self::half_space_at(wave, Complex64::from(k))
    }

    /// The same at a complex wavenumber, on the sheet Re p, Re s ≥ 0.
    pub fn half_space_at(wave: &Wave, k: Complex64) -> Matrix2<Complex64> {
        let (p, s) = (sqrt_decaying(k * k - wave.kp2), sqrt_decaying(k * k - wave.ks2));
        let inv_r = (p + s) / (p + wave.gamma * s);
        let off = wave.mu * k * (inv_r - 2.0);
        Matrix2::new(wave.mu * p * inv_r, off, off, wave.mu * s * inv_r)
    }
}

impl LayerStiffness<1> {
    /// Anti-plane (SH) stiffness: μs coth(sh) on the diagonal, −μs/sinh(sh) beside it.
    pub fn layer(wave: &Wave, thickness: f64, k: f64) -> Self {
        let (_, s) = wave.vertical(k);
        let e = (-s * thickness).exp();
        // s/(1 − e^{−2sh}) = 1/(h · (1 − e^{−sh})/(sh) · (1 + e^{−sh}))
        let scale = wave.mu / (thickness * one_minus_exp_over(s * thickness, e) * (1.0 + e));
        Self { direct: Matrix1::new(scale * (1.0 + e * e)), cross: Matrix1::new(-2.0 * scale * e) }
    }

    /// μs
    pub fn half_space(wave: &Wave, k: f64) -> Matrix1<Complex64> {
        Matrix1::new(wave.mu * wave.vertical(k).1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Elastic, Material};
    use super::*;

    fn wave(omega: f64) -> Wave {
        let m =
            Material::new(Elastic::YoungPoisson { young: 60e6, poisson: 0.35 }, 1500.0, 0.04, 0.04).unwrap();
        Wave::new(&m, omega)
    }

    /// Two halves condensed must be the whole: both `direct` and `cross`, over regimes of k and ω.
    #[test]
    fn two_halves_make_a_whole() {
        // measured: 4e-13 at k = 0.01 (the 1/(kh) of thin layers), 5e-15 elsewhere
        let m = Matrix2::new(Complex64::ONE, Complex64::ZERO, Complex64::ZERO, -Complex64::ONE);
        for omega in [0.0, 0.1, 30.0, 300.0, 1200.0] {
            for k in [0.01, 0.3, 2.0, 20.0] {
                let wave = wave(omega);
                let half = LayerStiffness::<2>::layer(&wave, 1.0, k);
                let whole = LayerStiffness::<2>::layer(&wave, 2.0, k);
                let middle = (half.direct + m * half.direct * m).try_inverse().unwrap();
                // bottom traction per bottom displacement, and per top displacement
                let direct = half.direct - half.cross * m * middle * m * half.cross;
                let cross_m = -half.cross * m * middle * half.cross * m;
                let scale = whole.direct.norm();
                assert!((direct - whole.direct).norm() < 1e-11 * scale, "{omega} {k}");
                assert!(
                    (cross_m - whole.cross * m).norm() < 1e-11 * scale.min(whole.cross.norm() * 1e6),
                    "{omega} {k}"
                );
            }
        }
    }

    #[test]
    fn exponentially_small_coupling_keeps_its_digits() {
        // through 40 m at k = 5: e^{−200}; two halves of 20 m multiply. Measured 2e-13
        let wave = wave(50.0);
        let m = Matrix2::new(Complex64::ONE, Complex64::ZERO, Complex64::ZERO, -Complex64::ONE);
        let half = LayerStiffness::<2>::layer(&wave, 20.0, 5.0);
        let whole = LayerStiffness::<2>::layer(&wave, 40.0, 5.0);
        let middle = (half.direct + m * half.direct * m).try_inverse().unwrap();
        let cross = -half.cross * m * middle * half.cross;
        assert!((cross - whole.cross).norm() < 1e-11 * whole.cross.norm());
        assert!(whole.cross.norm() < 1e-75 * whole.direct.norm());
    }
}
