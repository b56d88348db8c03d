//! Compliance of a loaded strip of ground: Eq. 80, corrected (THEORY 3), by adaptive quadrature.
//!
//! ```text
//! 1/k_eq(β, ω) = (1/π) ∫₀^∞ G_zz(√(β² + y²), ω) C(y b) dy
//! C = sinc (centre line)  or  sinc² (mean over the strip),  sinc x = sin x / x
//! ```
//!
//! The slow tail G ≈ A/k + C/k³ of the top layer is removed as A/κ + B/κ³, κ² = k² + 1/b², whose strip integrals
//! are known; what remains falls like k⁻⁵ and is integrated until its envelope is below the tolerance.

mod receiver;

pub(super) use receiver::receiver_tail_integrals;
pub use receiver::{horizontal_quadrature, receiver_quadrature, receivers_quadrature};

use super::{Profile, half_space};
use crate::math::bessel::modified_bessel;
use crate::math::quadrature::{Adaptive, Estimate, Together, Tolerance, subdivided};
use crate::quantity::positive;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::PI;

/// G_zz [m/Pa] of many wavenumbers [rad/m].
pub type Compliances<'a> = &'a dyn Fn(&[f64]) -> Vec<Complex64>;

/// Evaluations of G allowed for one strip integral.
const MAX_COUNT: usize = 60_000;

/// Which displacement of the strip the track follows; the load is uniform either way.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Compatibility {
    /// Under the centre line: sinc.
    Centre,
    /// Mean over the strip: sinc².
    Mean,
}

/// A uniformly loaded strip along x.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "Strip")]
pub struct Strip {
    /// b [m], half of the contact width.
    pub half_width: f64,
    /// Displacement the track follows.
    pub compatibility: Compatibility,
}

impl<'de> Deserialize<'de> for Strip {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let strip = Self::deserialize(deserializer)?;
        positive("half_width", strip.half_width, "m").map_err(D::Error::custom)?;
        Ok(strip)
    }
}

impl Strip {
    /// C(β_y b): 1 at 0.
    #[inline]
    pub fn kernel(&self, beta_y: f64) -> f64 {
        let sinc = sinc(beta_y * self.half_width);
        match self.compatibility {
            Compatibility::Centre => sinc,
            Compatibility::Mean => sinc * sinc,
        }
    }
}

/// sin x / x
#[inline]
pub fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-4 { 1.0 - x * x / 6.0 } else { x.sin() / x }
}

/// Where G(k) of a profile changes, and how it ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// G_zz ≈ A/k + C/k³ of the top material: (A, C).
    pub tail: (Complex64, Complex64),
    /// G_xz ≈ i γA/k: γA.
    pub horizontal_tail: Complex64,
    /// ω/c_p, ω/c_s and ω/c_R of every material, ascending [rad/m].
    pub wavenumbers: Vec<f64>,
    /// Thickness of the top material [m]; None on a half-space.
    pub top_thickness: Option<f64>,
}

impl Outline {
    /// Outline of `profile` at `omega` [rad/s].
    pub fn new(profile: &Profile, omega: f64) -> Self {
        let mut wavenumbers: Vec<f64> = profile
            .materials()
            .flat_map(|m| [m.c_p(), m.c_s(), m.rayleigh_speed()])
            .map(|c| omega.abs() / c)
            .collect();
        wavenumbers.sort_by(f64::total_cmp);
        wavenumbers.dedup();
        Self {
            tail: half_space::static_tail(profile.top(), omega),
            horizontal_tail: half_space::horizontal_tail(profile.top(), omega),
            wavenumbers,
            top_thickness: profile.top_thickness(),
        }
    }

    /// Panel ends for ∫₀^top G(√(β² + y²)) dy: where waves and layers change G, doubling in between.
    pub fn breakpoints(&self, beta: f64, top: f64) -> Vec<f64> {
        let mut points: Vec<f64> = self
            .wavenumbers
            .iter()
            .filter(|&&k| k > beta * (1.0 + 1e-9))
            .map(|k| (k * k - beta * beta).sqrt())
            .collect();
        // the smallest scale on which G(√(β² + y²)) starts to vary with y
        let slowest = self.wavenumbers.first().copied().unwrap_or(0.0);
        let mut y = beta.max(slowest).max(1e-12 * top);
        while y < top {
            points.push(y);
            y *= 3.0;
        }
        points.push(0.0);
        points.push(top);
        points.retain(|&p| p <= top);
        points.sort_by(f64::total_cmp);
        points.dedup_by(|a, b| *a - *b < 1e-3 * *a);
        points
    }
}

/// The strip integrals of 1/κ and 1/κ³, κ² = β_c² + y², over (1/π)∫₀^∞ … C(yb) dy.
///
/// From ∫₀^∞ cos(yx)/κ dy = K₀(β_c x) and ∫₀^∞ cos(yx)/κ³ dy = (x/β_c) K₁(β_c x), averaged over the strip
/// (centre: x from 0 to b; mean: (2b − x) over 0 to 2b). Test: `tests::tail_integrals`.
pub(super) fn tail_integrals(beta_c: f64, strip: Strip) -> (f64, f64) {
    let b = strip.half_width;
    match strip.compatibility {
        Compatibility::Centre => {
            let x = beta_c * b;
            let m = modified_bessel(x);
            let first = m.integral_k0 / (PI * x);
            // ∫₀ˣ t K₁ dt = ∫₀ˣ K₀ − x K₀
            let third = (m.integral_k0 - x * m.k0) / (PI * x * beta_c * beta_c);
            (first, third)
        }
        Compatibility::Mean => {
            let x = 2.0 * beta_c * b;
            let m = modified_bessel(x);
            // ∫₀ˣ (x − t) K₀ dt, ∫₀ˣ t K₀ = 1 − x K₁
            let first = 2.0 * (x * m.integral_k0 - (1.0 - x * m.k1)) / (PI * x * x);
            // ∫₀ˣ (x − t) t K₁ dt, ∫₀ˣ t² K₁ = 2 − x² K₂, K₂ = K₀ + 2K₁/x
            let moment = x * (m.integral_k0 - x * m.k0) - (2.0 - x * x * m.k0 - 2.0 * x * m.k1);
            (first, 2.0 * moment / (PI * x * x * beta_c * beta_c))
        }
    }
}

/// What of C(q) the quadrature must know.
struct Kernel<'a> {
    /// g C(q) of q and g
    times: &'a dyn Fn(f64, Complex64) -> Complex64,
    /// Bound of |C| for large q.
    envelope: &'a dyn Fn(f64) -> f64,
    /// Shortest period of C [rad/m].
    period: f64,
    /// κ₀ of the tail [rad/m].
    kappa0: f64,
    /// The tail at k.
    tail: &'a dyn Fn(f64) -> Complex64,
    /// (1/π)∫₀^∞ tail C(q) dq
    known: Complex64,
}

/// The tail A/κ + B/κ³, κ² = k² + κ₀², whose integrals are known: (A, B).
///
/// A/k + C/k³ = A/κ + (C + A κ₀²/2)/κ³ + O(k⁻⁵)
pub(super) fn tail(outline: &Outline, kappa0: f64) -> (Complex64, Complex64) {
    let (a, c) = outline.tail;
    (a, c + 0.5 * a * kappa0 * kappa0)
}

/// A/κ + B/κ³ at k.
pub(super) fn tail_at((a, third): (Complex64, Complex64), kappa0: f64, k: f64) -> Complex64 {
    let kappa2 = k * k + kappa0 * kappa0;
    (a + third / kappa2) / kappa2.sqrt()
}

/// The tail's integral from those of its two terms.
pub(super) fn known(tail: (Complex64, Complex64), integrals: (f64, f64)) -> Complex64 {
    tail.0 * integrals.0 + tail.1 * integrals.1
}

/// 1/k_eq(β, ω) [m²/N] for ground whose G_zz is `u_zz`, to `relative` of its modulus.
///
/// Arguments: `beta` [rad/m], any sign; not zero where ω = 0 on a half-space (there the value is infinite).
/// Accuracy: 1e-9 against `reference/k_eq.csv` at `relative` = 1e-9 (test `cross_solver::k_eq`); finds poles as
/// close to the axis as η = 1e-4 (test `cross_solver::light_damping`); `converged` says when it cannot.
/// Source: Eq. 80 with THEORY 3.
pub fn quadrature(u_zz: Compliances, outline: &Outline, beta: f64, strip: Strip, relative: f64) -> Estimate {
    let b = strip.half_width;
    let kappa0 = 1.0 / b;
    let coefficients = tail(outline, kappa0);
    let kernel = Kernel {
        times: &|q, g| g * strip.kernel(q),
        envelope: &|q| match strip.compatibility {
            Compatibility::Centre => 1.0 / (q * b).max(1.0),
            Compatibility::Mean => 1.0 / (q * b).max(1.0).powi(2),
        },
        period: 2.0 * PI / b,
        kappa0,
        tail: &|k| tail_at(coefficients, kappa0, k),
        known: known(coefficients, tail_integrals(beta.hypot(kappa0), strip)),
    };
    integral(u_zz, outline, beta, &kernel, relative).0
}

/// Where the integral is first cut off [rad/m]: beyond every wave, and where the tail holds.
fn first_top(outline: &Outline, beta: f64, kernel: &Kernel) -> f64 {
    let highest = outline.wavenumbers.last().copied().unwrap_or(0.0);
    let mut top = (2.0 * highest).max(2.0 * beta).max(4.0 * kernel.kappa0);
    if let Some(thickness) = outline.top_thickness {
        // e^{−2kh} falls to 2 % at 2/h; below that the tail does not hold
        top = top.max(2.0 / thickness);
    }
    // whole periods of the kernel; beyond two thousand of them the integral gives up and says so
    let period = kernel.period;
    top.min((2.0 * highest).max(2.0 * beta).max(2000.0 * period)).min(4000.0 * period)
}

/// (1/π) ∫₀^∞ G(√(β² + q²)) C(q) dq of the `compliances`, and the part of it that was integrated.
fn integral(
    compliances: Compliances,
    outline: &Outline,
    beta: f64,
    kernel: &Kernel,
    relative: f64,
) -> (Estimate, Adaptive) {
    let beta = beta.abs();
    let mut integrand = Together(|y: &[f64; 15]| {
        let k = y.map(|y| (beta * beta + y * y).sqrt());
        let g = compliances(&k);
        std::array::from_fn(|i| (kernel.times)(y[i], g[i] - (kernel.tail)(k[i])))
    });
    let known = kernel.known * PI;

    // no more than a period and a half of the kernel in a panel
    let (period, widest) = (kernel.period, 1.5 * kernel.period);
    let points = outline.breakpoints(beta, first_top(outline, beta, kernel));
    let mut top = points.last().copied().unwrap_or(0.0);

    let mut integral = Adaptive::new();
    integral.add(&mut integrand, &subdivided(&points, widest));
    // beyond so many periods of the kernel the integral gives up and says so
    let farthest = 3000.0 * period;
    // beyond the top: one period at a time until the envelope |G − tail|·|C|·y/5 is negligible
    let tolerance = Tolerance { relative: 0.7 * relative, absolute: 0.0, max_count: MAX_COUNT };
    let mut estimate;
    let mut cut;
    loop {
        loop {
            let envelope = (kernel.envelope)(top);
            let k = (beta * beta + top * top).sqrt();
            cut = (compliances(&[k])[0] - (kernel.tail)(k)).norm() * envelope * top / 5.0;
            let goal = 0.3 * relative * (integral.value() + known).norm();
            if cut <= goal || top > farthest {
                break;
            }
            let next = top + period.max(0.25 * top).min(8.0 * period);
            integral.add(&mut integrand, &subdivided(&[top, next], widest));
            top = next;
        }
        estimate = integral.refine(&mut integrand, known, tolerance);
        // refined, the integral may be smaller than it seemed and what was cut off too large for it
        if !estimate.converged || cut <= 0.3 * relative * (estimate.value + known).norm() || top > farthest {
            break;
        }
    }
    let value = (estimate.value + known) / PI;
    let error = (estimate.error + cut) / PI;
    let estimate = Estimate {
        value,
        error,
        count: estimate.count,
        converged: estimate.converged && value.is_finite() && error <= 1.01 * relative * value.norm(),
    };
    (estimate, integral)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::quadrature::integrate;

    #[test]
    fn tail_integrals_by_quadrature() {
        // to y = 4000/b the rest of 1/κ · sinc is 1/(y² b) = 6e-8; measured 4e-8 and 2e-12
        for compatibility in [Compatibility::Centre, Compatibility::Mean] {
            let strip = Strip { half_width: 1.25, compatibility };
            for beta_c in [0.8, 2.0, 5.0] {
                let (first, third) = tail_integrals(beta_c, strip);
                let points: Vec<f64> = (0..=3000).map(f64::from).collect();
                let tolerance = Tolerance { relative: 1e-12, absolute: 0.0, max_count: 1_000_000 };
                let by_quadrature = |power: i32| {
                    let f = |y: f64| {
                        Complex64::from(strip.kernel(y) / (beta_c * beta_c + y * y).sqrt().powi(power))
                    };
                    integrate(f, &points, tolerance).value.re / PI
                };
                assert!((first / by_quadrature(1) - 1.0).abs() < 3e-7, "{first}");
                assert!((third / by_quadrature(3) - 1.0).abs() < 1e-10, "{third}");
            }
        }
    }
}
