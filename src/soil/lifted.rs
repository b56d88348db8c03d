//! 1/k_eq on a path lifted off the poles: few points, and the fewer the waves are damped the more they save.
//!
//! ```text
//! y = t + i d tanh(t/d),  t = s sinh u,  d = 0.7/b:   1/k_eq = (1/π) ∫₀^∞ G(√(β² + y²)) C(y b) (dy/du) du
//! ```
//!
//! For e^{iωt} waves whose energy runs as their crests do are poles below the real axis, of undamped ground on it (limiting absorption);
//! the branch cuts of √(k² − k_j²) end at the same places and are not met. Backward waves, and waves of layers on rock that decay as
//! they turn, stand above the axis: where one of them is below the path, it must not be taken. A pole κ = k² has y = √(κ − β²), whose
//! Im y only grows with β: what is clear at β = 0 is clear at all ([`Integral::is_clear`]).
//! The integrand is analytic and even in u, so the trapezoidal rule converges geometrically, and its points nest: halved steps add
//! midpoints. Its tail is that of `strip`.

use super::batch::Batch;
use super::strip::{self, Compatibility, Compliances, Outline, Strip, tail, tail_integrals};
use crate::math::lanes::{LANES, Lanes, exp, sin_cos};
use crate::math::quadrature::Estimate;
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;
use std::f64::consts::PI;

/// Height of the path times b: the kernel grows by cosh 0.7 on it.
pub(super) const LIFT: f64 = 0.7;
/// β b from which, beyond all waves, the real axis is as good: it meets no pole, and the kernel turns faster than G changes.
const SHORT: f64 = 16.0;
/// Points of the first rule, and the most.
const FIRST: usize = 16;
const MOST_POINTS: usize = 512;
/// Error of the mean of two rules over the square of the relative error of one of them.
const SQUARED: f64 = 300.0;
/// Largest cut-off tried, of its first value.
const FARTHEST: f64 = 30.0;

/// What is integrated.
pub(super) struct Integral<'a> {
    /// The ground at |ω|.
    pub batch: Batch<'a>,
    /// Its tail and waves at ω.
    pub outline: &'a Outline,
    /// ω < 0: G(−ω) = conj G(ω).
    pub negative: bool,
    /// What a value of G may cost where it is wanted to 1e-9; where less is wanted it may cost more.
    pub most: f64,
}

/// Accuracy of both integrals that are compared, and what a pole between them may add, relative.
const COMPARED: f64 = 1e-6;
const ALIKE: f64 = 3e-6;

impl Integral<'_> {
    /// Whether no pole of G stands between the real axis and the path, at any β: both integrals agree at β = 0. False as well where
    /// the one on the axis does not settle, as that of undamped ground.
    pub fn is_clear(&self, u_zz: Compliances, strip: Strip) -> bool {
        let Some(lifted) = self.compliance(0.0, strip, COMPARED) else { return false };
        let real = strip::quadrature(u_zz, self.outline, 0.0, strip, COMPARED);
        real.converged && (lifted.value - real.value).norm() <= ALIKE * real.value.norm()
    }

    /// 1/k_eq(β, ω) [m²/N] to `relative` of its modulus; None where the path does not settle, G has lost too many digits or the real
    /// axis is as good.
    pub fn compliance(&self, beta: f64, strip: Strip, relative: f64) -> Option<Estimate> {
        let estimate = self.on_path(beta.abs(), strip, relative)?;
        Some(if self.negative { Estimate { value: estimate.value.conj(), ..estimate } } else { estimate })
    }

    fn on_path(&self, beta: f64, strip: Strip, relative: f64) -> Option<Estimate> {
        let kappa0 = 1.0 / strip.half_width;
        if beta > SHORT * kappa0 && beta > 2.0 * self.outline.wavenumbers.last().copied().unwrap_or(0.0) {
            return None;
        }
        let (a, third) = tail(self.outline, kappa0);
        let coefficients = if self.negative { (a.conj(), third.conj()) } else { (a, third) };
        let (first, third) = tail_integrals(beta.hypot(kappa0), strip);
        let known = coefficients.0 * first + coefficients.1 * third;
        let most = self.most * (1e8 * relative).max(1.0);
        let mut count = 0;
        // G − tail falls like k⁻⁵, the kernel like 1/k or 1/k²
        let mut stretch = (2e-4 / relative).powf(1.0 / 6.0).max(0.75) * 4.0;
        loop {
            let mut path = Path::new(self.outline, beta, strip, coefficients, stretch);
            let (mut sum, _) = self.sum(&path, 0.0, most)?;
            loop {
                let (middle, cut) = self.sum(&path, 0.5, most)?;
                count += 2 * path.points;
                let value = 0.5 * (sum + middle) / PI + known;
                // T and M are wrong by as much to either side, their mean by the square of it
                let differ = 0.5 * (sum - middle).norm() / PI / value.norm();
                let error = differ.min(SQUARED * differ * differ) * value.norm() + cut / PI;
                if error <= relative * value.norm() {
                    return Some(Estimate { value, error, count, converged: true });
                }
                if cut / PI > 0.5 * relative * value.norm() && differ < 0.1 {
                    break;
                }
                path.halve();
                sum = 0.5 * (sum + middle);
                if path.points > MOST_POINTS {
                    return None;
                }
            }
            stretch *= 1.5;
            if stretch > FARTHEST * 4.0 {
                return None;
            }
        }
    }

    /// h Σ f(u_j), u_j = (j + `offset`) h, the first one halved where it stands at 0; and what is left beyond the last one.
    fn sum(&self, path: &Path, offset: f64, most: f64) -> Option<(Complex64, f64)> {
        dispatch!(Level::new(), simd => self.sum_in_lanes(simd, path, offset, most))
    }

    #[inline(always)]
    fn sum_in_lanes<S: Simd>(
        &self,
        simd: S,
        path: &Path,
        offset: f64,
        most: f64,
    ) -> Option<(Complex64, f64)> {
        let mut sum = Lanes::real(simd, 0.0);
        let mut left = 0.0;
        for first in (0..path.points).step_by(LANES) {
            let u = f64x8::from_fn(simd, |i| ((first + i) as f64 + offset) * path.step);
            let Point { k, k2, rest, weight, t } = path.point(simd, u);
            let found = self.batch.in_plane(simd, k, k2);
            if !found.cost.simd_lt(most).all_true() {
                return None;
            }
            let difference = found.compliance[2] - rest;
            let mut term = difference * weight;
            if first == 0 && offset == 0.0 {
                term.re[0] *= 0.5;
                term.im[0] *= 0.5;
            }
            sum = sum + term;
            let last = LANES - 1;
            left = difference.lane(last).norm() * path.envelope(t[last]) * t[last] / 5.0;
        }
        Some((Complex64::new(sum.re.reduce_sum(), sum.im.reduce_sum()) * path.step, left))
    }
}

/// A path and its rule.
struct Path {
    beta: f64,
    strip: Strip,
    /// A and B of the tail A/κ + B/κ³.
    tail: (Complex64, Complex64),
    /// s [rad/m]
    scale: f64,
    /// In u.
    step: f64,
    points: usize,
}

/// Eight points of it.
struct Point<S: Simd> {
    k: Lanes<S>,
    k2: Lanes<S>,
    /// A/κ + B/κ³
    rest: Lanes<S>,
    /// C(y b) dy/du
    weight: Lanes<S>,
    t: f64x8<S>,
}

impl Path {
    fn new(outline: &Outline, beta: f64, strip: Strip, tail: (Complex64, Complex64), stretch: f64) -> Self {
        let slowest = outline.wavenumbers.last().copied().unwrap_or(0.0);
        let thin = outline.top_thickness.map_or(0.0, |h| 1.0 / h);
        let top = stretch * slowest.max(beta).max(1.0 / strip.half_width).max(thin);
        let near =
            outline.wavenumbers.iter().map(|k| (k * k - beta * beta).abs()).fold(f64::INFINITY, f64::min);
        let scale = near.sqrt().max(0.25 * beta).min(1.5 / strip.half_width).min(top / 3.0);
        Self { beta, strip, tail, scale, step: (top / scale).asinh() / FIRST as f64, points: FIRST }
    }

    fn halve(&mut self) {
        self.step *= 0.5;
        self.points *= 2;
    }

    /// Bound of |C| at large t.
    fn envelope(&self, t: f64) -> f64 {
        let decay = 1.0 / (t * self.strip.half_width).max(1.0);
        match self.strip.compatibility {
            Compatibility::Centre => 1.3 * decay,
            Compatibility::Mean => 1.6 * decay * decay,
        }
    }

    #[inline(always)]
    fn point<S: Simd>(&self, simd: S, u: f64x8<S>) -> Point<S> {
        let b = self.strip.half_width;
        let d = LIFT / b;
        let up = exp(u);
        let down = 1.0 / up;
        let (t, slope) = ((up - down) * (0.5 * self.scale), (up + down) * (0.5 * self.scale));
        let e = exp(t * (-2.0 / d));
        let tanh = (1.0 - e) / (1.0 + e);
        let y = Lanes { re: t, im: tanh * d };
        let dy = Lanes { re: slope, im: (1.0 - tanh * tanh) * slope };
        let y2 = y * y;
        let k2 = Lanes { re: y2.re + self.beta * self.beta, im: y2.im };
        let inverse = Lanes { re: k2.re + 1.0 / (b * b), im: k2.im }.inv();
        let (a, third) = (Lanes::all(simd, self.tail.0), Lanes::all(simd, self.tail.1));
        let rest = (a + third * inverse) * inverse.sqrt_decaying();
        let sinc = sinc(y.times(b));
        let kernel = match self.strip.compatibility {
            Compatibility::Centre => sinc,
            Compatibility::Mean => sinc * sinc,
        };
        Point { k: k2.sqrt_decaying(), k2, rest, weight: kernel * dy, t }
    }
}

/// sin z/z for |Im z| ≤ 0.7.
#[inline(always)]
pub(super) fn sinc<S: Simd>(z: Lanes<S>) -> Lanes<S> {
    let (sin, cos) = sin_cos(z.re);
    let up = exp(z.im);
    let down = 1.0 / up;
    let sine = Lanes { re: sin * (up + down) * 0.5, im: cos * (up - down) * 0.5 };
    let small = z.norm_sqr().simd_le(1e-8);
    let plain = sine * z.inv();
    if small.any_true() { (z * z).times(1.0 / 6.0).one_minus().or(plain, small) } else { plain }
}
