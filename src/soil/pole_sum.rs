//! G_zz as a sum over poles, and what it answers in closed form (THEORY 2).
//!
//! ```text
//! G_zz(k) = Σ r_j/(k² − κ_j),   (1/2π) ∫ G(√(β² + q²)) e^{iqy} dq = Σ r_j e^{−a_j|y|}/(2a_j),   a_j = √(β² − κ_j), Re a_j > 0
//! ```

use super::strip::{Compatibility, Strip};
use crate::math::lanes::{LANES, Lanes};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;

/// κ_j and r_j.
#[derive(Clone, Debug, Default)]
pub(super) struct PoleSum {
    pub kappa: Vec<Complex64>,
    pub residue: Vec<Complex64>,
}

/// The kernel of an integral, given what e^{−a|y|} becomes under it.
#[derive(Clone, Copy)]
enum Kernel {
    Strip(Strip),
    /// Half-width b, distance y ≥ 0.
    Receiver(f64, f64),
}

impl PoleSum {
    /// Σ r_j/(k² − κ_j)
    #[inline]
    pub fn at(&self, k: f64) -> Complex64 {
        let kappa = Complex64::from(k * k);
        self.residue.iter().zip(&self.kappa).map(|(r, pole)| r / (kappa - pole)).sum()
    }

    /// 1/k_eq(β) [m²/N] of a strip.
    ///
    /// Centre: Σ r_j (1 − e^{−a b})/(2a² b). Mean: Σ r_j/(2a) · [1/(ab) − (1 − e^{−2ab})/(2a²b²)].
    pub fn strip(&self, beta: f64, strip: Strip) -> Complex64 {
        dispatch!(Level::new(), simd => self.sums(simd, beta, &[Kernel::Strip(strip)]))[0]
    }

    /// Displacement [m²/N] at distances `y` from the centre line of a strip of half-width `b`; a line where b = 0.
    ///
    /// y ≥ b: Σ r_j e^{−ay} sinh(ab)/(2a · ab); y < b: Σ r_j (1 − e^{−ab} cosh(ay))/(2a · ab); line: Σ r_j e^{−ay}/(2a).
    pub fn receivers(&self, beta: f64, b: f64, y: &[f64]) -> Vec<Complex64> {
        let kernels: Vec<Kernel> = y.iter().map(|y| Kernel::Receiver(b, y.abs())).collect();
        dispatch!(Level::new(), simd => self.sums(simd, beta, &kernels))
    }

    /// Σ r_j/(2a_j) of each kernel, eight poles at a time.
    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, beta: f64, kernels: &[Kernel]) -> Vec<Complex64> {
        let mut sums = vec![Complex64::ZERO; kernels.len()];
        for (kappa, residue) in self.kappa.chunks(LANES).zip(self.residue.chunks(LANES)) {
            // the last poles are filled up with such as weigh nothing
            let part = |of: &[Complex64], other: f64, part: fn(&Complex64) -> f64| {
                f64x8::from_fn(simd, |i| of.get(i).map_or(other, part))
            };
            let a = Lanes { re: beta * beta - part(kappa, -1.0, |z| z.re), im: -part(kappa, 0.0, |z| z.im) };
            let a = a.sqrt_decaying();
            let weight = Lanes { re: part(residue, 0.0, |z| z.re), im: part(residue, 0.0, |z| z.im) };
            let weight = weight * a.times(2.0).inv();
            for (sum, kernel) in sums.iter_mut().zip(kernels) {
                let term = weight * kernel.of(simd, a);
                *sum += Complex64::new(term.re.reduce_sum(), term.im.reduce_sum());
            }
        }
        sums
    }
}

impl Kernel {
    /// What e^{−a|y|} becomes.
    #[inline(always)]
    fn of<S: Simd>(self, simd: S, a: Lanes<S>) -> Lanes<S> {
        match self {
            Self::Strip(Strip { half_width: b, compatibility: Compatibility::Centre }) => mean(a.times(b)),
            Self::Strip(Strip { half_width: b, compatibility: Compatibility::Mean }) => {
                let z = a.times(2.0 * b);
                let plain = mean(z).one_minus().times(2.0) * z.inv();
                // 2(1 − (1 − e^{−z})/z)/z
                let small = z.norm_sqr().simd_lt(1e-4);
                let mut series = Lanes::real(simd, 1.0);
                for n in [6.0, 5.0, 4.0, 3.0] {
                    series = (series * z).times(1.0 / n).one_minus();
                }
                series.or(plain, small)
            }
            Self::Receiver(0.0, y) => a.times(y).exp_minus(),
            // ½ ∫ over both sides of y
            Self::Receiver(b, y) if y < b => {
                mean(a.times(b + y)).times(0.5 * (b + y) / b) + mean(a.times(b - y)).times(0.5 * (b - y) / b)
            }
            // sinh(ab) e^{−ay}/(ab) = e^{−a(y−b)} (1 − e^{−2ab})/(2ab)
            Self::Receiver(b, y) => a.times(y - b).exp_minus() * mean(a.times(2.0 * b)),
        }
    }
}

/// (1 − e^{−z})/z
#[inline(always)]
fn mean<S: Simd>(z: Lanes<S>) -> Lanes<S> {
    z.one_minus_exp_over(z.exp_minus())
}
