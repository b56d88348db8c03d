//! Displacement beside a strip that is loaded by something slower than every wave: all of it fades, and the path of integration may be lifted
//! as far as it fades, whatever the damping.
//!
//! ```text
//! R(β; y) = (1/2π) ∫_{−∞}^{∞} G(√(β² + q²)) sinc(qb) e^{iqy} w(t) dq,   κ² = β² − k², k the slowest wave
//! q = iσ + t,  σ = κ − s,  s = κ/4,  t = H asinh((s/H) sinh u),  w = ½ erfc((|t| − t₂)/Δ)
//! ```
//!
//! for y > b; horizontally as [`Motion`] has it. On the real axis e^{−κ(y−b)} is what oscillations leave of one another; on this path
//! e^{−σ(y−b)} is a factor. No pole and no branch point lies below iκ. In u all lies farther than π/2 from the path, so that trapezoidal rules
//! of step h err by e^{−π²/h}, less what H y takes of it; two of them, half a step apart, tell their error, and a narrower window its own.

use super::Motion;
use super::lifted::Integral;
use crate::math::complex::I;
use crate::math::error_function::erfc;
use crate::math::quadrature::Estimate;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// κ over the slowest wave from which on the path is better than the real axis.
const LEAST: f64 = 0.2;
/// s/κ
const SHARE: f64 = 0.25;
/// H y h over 2π: what of the digits of a rule the receiver's distance may take.
const ROOM: f64 = 0.35;
/// ln of how much smaller the result may be than its terms, besides what fades.
const SMALLER: f64 = 4.0;
/// Of the strip in u, π/2, what errors are estimated with.
const DEPTH: f64 = 1.2;
/// The narrower window over the other.
const NARROWER: f64 = 0.85;
/// Error of the mean of two rules over the square of the relative error of one of them.
const SQUARED: f64 = 30.0;
/// How often a rule may be refined, and its most points.
const REFINED: u32 = 4;
const MOST_POINTS: usize = 2000;

/// A rule for one β and one receiver.
struct Rule {
    sigma: f64,
    /// s
    scale: f64,
    /// H
    longest: f64,
    step: f64,
    /// t₂ and Δ.
    window: (f64, f64),
    /// Points on one side.
    count: usize,
}

impl Rule {
    /// For a receiver from `near` to `far` [m] from the edges of the strip, whose field fades by κ, to e^{−`digits`}.
    fn new(kappa: f64, (near, far): (f64, f64), digits: f64, refined: u32) -> Self {
        let scale = SHARE * kappa;
        let digits = digits + 2.0 * f64::from(refined);
        // of one rule: half the digits, those by which its error is squared, and what the result lacks beside its terms
        let of_one = 0.5 * digits + 0.5 * SQUARED.ln() + scale * near + SMALLER;
        let step = (1.0 - ROOM) * TAU * DEPTH / of_one;
        let longest = ROOM * TAU / step / far;
        let width = 2.0 * (digits + scale * near).sqrt() / near;
        let deep = digits.sqrt() + 0.3;
        let top = 2.0 * deep * width;
        let count = ((longest / scale * (top / longest).sinh()).asinh() / step).ceil() as usize;
        Self { sigma: kappa - scale, scale, longest, step, window: (deep * width, width), count }
    }

    /// q, dq/du and both windows at a point of number `place`.
    fn point(&self, place: f64) -> (Complex64, f64, [f64; 2]) {
        let u = place * self.step;
        let x = self.scale / self.longest * u.sinh();
        let t = self.longest * x.asinh();
        let slope = self.scale * u.cosh() / x.hypot(1.0);
        let (middle, width) = self.window;
        let window = |part: f64| 0.5 * erfc((t.abs() - part * middle) / (part * width));
        (Complex64::new(t, self.sigma), slope, [window(1.0), window(NARROWER)])
    }
}

/// sin(qb)/(qb)
fn sinc(z: Complex64) -> Complex64 {
    if z.norm() < 1e-4 { 1.0 - z * z / 6.0 } else { z.sin() / z }
}

/// Displacement [m²/N] of one `motion` at distance `y` [m] beyond a strip of `half_width` [m] to a `relative` accuracy of itself; None where the
/// path is no better than the axis, does not settle or G has lost too many digits.
///
/// Accuracy: 1e-6 where 1e-5 is asked (test `cross_solver::beside::what_fades_is_known_as_well`).
pub(super) fn receiver(
    integral: &Integral,
    beta: f64,
    half_width: f64,
    (y, motion): (f64, Motion),
    relative: f64,
) -> Option<Estimate> {
    let beta = beta.abs();
    let slowest = integral.outline.wavenumbers.last().copied().unwrap_or(0.0);
    let kappa = (beta * beta - slowest * slowest).max(0.0).sqrt();
    if kappa < LEAST * slowest || kappa == 0.0 || y <= half_width {
        return None;
    }
    let mut count = 0;
    for refined in 0..REFINED {
        let digits = (1.0 / relative).ln() + 1.0;
        let rule = Rule::new(kappa, (y - half_width, y + half_width), digits, refined);
        if rule.count > MOST_POINTS {
            return None;
        }
        // points of one rule, then of the other, half a step on
        let last = rule.count as i32;
        let places = |offset: f64| (-last..=last).map(move |j| f64::from(j) + offset);
        let points: Vec<_> = places(0.0).chain(places(0.5)).map(|place| rule.point(place)).collect();
        let k2: Vec<Complex64> = points.iter().map(|(q, ..)| beta * beta + q * q).collect();
        let g = integral.batch.at_squares(&k2, integral.most * (1e8 * relative).max(1.0))?;
        count += points.len();
        // both rules with both windows
        let mut sums = [[Complex64::ZERO; 2]; 2];
        for (number, ((q, slope, windows), (g_xz_over_k, g_zz))) in points.iter().zip(&g).enumerate() {
            let compliance = match motion {
                Motion::Vertical => *g_zz,
                Motion::Along => *g_xz_over_k,
                Motion::Across => -I * q * g_xz_over_k,
            };
            let term = compliance * sinc(q * half_width) * (I * q * y).exp() * (slope * rule.step / TAU);
            for (sum, window) in sums[number / (points.len() / 2)].iter_mut().zip(windows) {
                *sum += term * window;
            }
        }
        let value = 0.5 * (sums[0][0] + sums[1][0]);
        let differ = 0.5 * (sums[0][0] - sums[1][0]).norm() / value.norm();
        let narrower = 0.5 * (sums[0][1] + sums[1][1]);
        let error = differ.min(SQUARED * differ * differ) * value.norm() + (value - narrower).norm();
        if error <= relative * value.norm() {
            let scale = if motion == Motion::Along { beta } else { 1.0 };
            let value = motion.displacement(beta, if integral.negative { value.conj() } else { value });
            return Some(Estimate { value, error: scale * error, count, converged: true });
        }
    }
    None
}
