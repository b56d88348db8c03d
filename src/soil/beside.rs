//! Displacement beside a strip on a path lifted off the poles: the values of G at one β serve all receivers.
//!
//! ```text
//! q = t + i d tanh(t/d) e^{−(t/t₁)⁴},  t = H asinh((s/H) sinh u),  d = min(0.7/b, 12/y):
//! R(β; y) = (1/π) ∫₀^∞ G(√(β² + q²)) sinc(q b) cos(q y) w(t) (dq/du) du,   w = ½ erfc((t − t₂)/Δ)
//! ```
//!
//! and horizontally G_xz/(ik) in place of G, across the track q sin(q y) in place of cos(q y), as [`Motion`] has it.
//!
//! The path is lifted as that of `lifted` and never higher, while waves are below it, and comes back to the axis beyond them. Its steps
//! grow from s, the scale on which waves change G, to H. A trapezoidal rule of step Δq confuses y with 2π/Δq − y, of which the path
//! leaves e^{−d(2π/Δq − 2y)}: H is chosen for that. Beyond the waves G is smooth beside the kernel, so that a window as smooth leaves
//! e^{−(Δ(y−b)/2)²} of what it takes away. Points, kernels and window do not depend on β but for s, a power of four: they are kept, and a
//! further receiver costs its sums alone. Every sixteenth β is compared with closer steps and a wider window.

use super::Motion;
use super::batch::{XZ, ZZ};
use super::lifted::{Integral, LIFT, sinc};
use super::strip::{self, Compliances};
use crate::math::error_function::erfc;
use crate::math::lanes::{LANES, Lanes, exp, sin_cos};
use crate::math::quadrature::Estimate;
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::rc::Rc;

/// Nepers by which the kernel may grow on the path, of the digits of G.
const GROWTH: f64 = 12.0;
/// Step of the first rule in u, and what it may confuse.
const STEP: f64 = 0.25;
const CONFUSED: f64 = 1e-8;
/// Δ times the nearest receiver's distance from the strip; t₂ behind the slowest wave, and the last point behind t₂, over Δ; how much more
/// a finer rule has of these.
const SMOOTH: f64 = 6.5;
const BEHIND: f64 = 2.9;
const LAST: f64 = 2.5;
const MORE: f64 = 0.4;
/// How many times wider the window is, and how many times smaller the steps are, with which a rule is compared.
const WIDER: f64 = 1.25;
const CLOSER: f64 = 0.7;
/// How often a rule may be refined so, and the farthest of its points over H.
const REFINED: i32 = 5;
const FARTHEST: f64 = 600.0;
/// Of so many β with the same points one is compared.
const CHECKED: usize = 16;

/// Motions of receivers beside a strip at one ω ≠ 0.
pub struct Receivers<'a> {
    integral: Integral<'a>,
    half_width: f64,
    /// Distance from the centre line [m] and motion of each.
    receivers: Vec<(f64, Motion)>,
    /// Error that is allowed for each [m²/N].
    allowed: Vec<f64>,
    /// Slowest wave [rad/m].
    slowest: f64,
    /// By the power of four that is s.
    rules: RefCell<HashMap<i32, Rule>>,
}

/// The rule for one s.
#[derive(Clone, Default)]
struct Rule {
    refined: i32,
    asked: usize,
    /// Its points, and those of the next one.
    points: Option<Rc<[Points; 2]>>,
    /// Its error where it was compared, receiver by receiver [m²/N].
    error: Vec<f64>,
}

/// Points of a rule, in eights, and what each receiver makes of them.
struct Points {
    q2: (Vec<f64>, Vec<f64>),
    /// sinc(q b) cos(q y) w (dq/du) Δu/π, across with q sin(q y), receiver by receiver.
    weights: Vec<(Vec<f64>, Vec<f64>)>,
}

impl<'a> Receivers<'a> {
    /// Motions at distances [m] beyond a strip of `half_width` [m], to a `relative` accuracy of the largest R of each; None where that does
    /// not settle.
    pub(super) fn new(
        integral: Integral<'a>,
        half_width: f64,
        receivers: &[(f64, Motion)],
        relative: f64,
    ) -> Option<Self> {
        let slowest = integral.outline.wavenumbers.last().copied().unwrap_or(0.0);
        let (allowed, rules) = (vec![f64::INFINITY; receivers.len()], RefCell::default());
        let mut largest = vec![0.0f64; receivers.len()];
        let receivers = receivers.to_vec();
        let mut receivers = Self { integral, half_width, receivers, allowed, slowest, rules };
        for share in [0.0, 0.3, 0.6, 0.9] {
            for (largest, estimate) in largest.iter_mut().zip(receivers.at(share * slowest)?) {
                *largest = largest.max(estimate.value.norm());
            }
        }
        receivers.allowed = largest.iter().map(|r| relative * r).collect();
        // compared once more, now with what is allowed
        receivers.rules.borrow_mut().values_mut().for_each(|rule| rule.asked = 0);
        Some(receivers)
    }

    /// Whether no pole stands between the real axis and the path, at any β: at β = 0 both agree for the vertical motion of the nearest
    /// receiver and of the farthest. All motions have the same poles.
    pub(super) fn are_clear(&self, u_zz: Compliances) -> bool {
        let Some(lifted) = self.at(0.0) else { return false };
        let alike = |((y, allowed), lifted): ((f64, &f64), &Estimate)| {
            let (outline, relative) = (self.integral.outline, 0.5 * allowed / lifted.value.norm());
            let real = strip::receiver_quadrature(u_zz, outline, 0.0, self.half_width, y, relative);
            real.converged && (lifted.value - real.value).norm() <= 2.0 * allowed
        };
        let all = self.receivers.iter().zip(&self.allowed).zip(&lifted);
        let vertical = all.filter(|((receiver, _), _)| receiver.1 == Motion::Vertical);
        let mut both = vertical.map(|((receiver, allowed), lifted)| ((receiver.0, allowed), lifted));
        both.next().is_none_or(alike) && both.next_back().is_none_or(alike)
    }

    /// R(β; y) [m²/N] of each, at |`beta`| [rad/m]; None where it does not settle.
    ///
    /// Accuracy: 2e-4 of the largest value of each where 1e-4 is asked (test `cross_solver::beside`).
    pub fn at(&self, beta: f64) -> Option<Vec<Estimate>> {
        let beta = beta.abs();
        let waves = &self.integral.outline.wavenumbers;
        let near = waves.iter().map(|k| (k * k - beta * beta).abs()).fold(f64::INFINITY, f64::min);
        let s = near.sqrt().max(0.05 * beta).min(self.longest());
        let scale = (0.5 * s.log2()).floor() as i32;
        let mut rule = self.rules.borrow_mut().remove(&scale).unwrap_or_default();
        let found = self.by_rule(beta, scale, &mut rule);
        self.rules.borrow_mut().insert(scale, rule);
        found
    }

    fn by_rule(&self, beta: f64, scale: i32, rule: &mut Rule) -> Option<Vec<Estimate>> {
        loop {
            let kept = match &rule.points {
                Some(points) => points.clone(),
                None => Rc::new([self.points(scale, rule.refined)?, self.points(scale, rule.refined + 1)?]),
            };
            rule.points = Some(kept.clone());
            let [points, finer] = &*kept;
            let mut values = self.sums(beta, points)?;
            let mut count = points.q2.0.len();
            if rule.asked.is_multiple_of(CHECKED) {
                let better = self.sums(beta, finer)?;
                count += finer.q2.0.len();
                rule.error.resize(self.receivers.len(), 0.0);
                for ((worst, a), b) in rule.error.iter_mut().zip(&values).zip(&better) {
                    *worst = worst.max((a - b).norm());
                }
                values = better;
            }
            if rule.error.iter().zip(&self.allowed).all(|(error, most)| error <= most) {
                rule.asked += 1;
                // u(−ω, β) = conj u(ω, −β)
                let signed = |z: Complex64, motion: Motion| {
                    if self.integral.negative { motion.mirrored(z.conj()) } else { z }
                };
                let one = |((z, error), (_, motion)): ((Complex64, &f64), &(f64, Motion))| Estimate {
                    value: signed(z, *motion),
                    error: *error,
                    count,
                    converged: true,
                };
                return Some(values.into_iter().zip(&rule.error).zip(&self.receivers).map(one).collect());
            }
            if rule.refined >= REFINED {
                return None;
            }
            *rule = Rule { refined: rule.refined + 1, ..Rule::default() };
        }
    }

    /// d
    fn lift(&self) -> f64 {
        (LIFT / self.half_width).min(GROWTH / self.farthest())
    }

    fn farthest(&self) -> f64 {
        self.receivers.iter().map(|receiver| receiver.0).fold(0.0, f64::max) + self.half_width
    }

    /// H
    fn longest(&self) -> f64 {
        TAU / (2.0 * self.farthest() + CONFUSED.recip().ln() / self.lift()) / STEP
    }

    /// Points and weights with s = 4^`scale`, `refined` so often; None where they are too many.
    fn points(&self, scale: i32, refined: i32) -> Option<Points> {
        let (d, longest, s) = (self.lift(), self.longest(), 4f64.powi(scale));
        let back = (1.5 * self.slowest).max(3.0 * d);
        let nearest = self.receivers.iter().map(|receiver| receiver.0);
        let nearest = nearest.fold(f64::INFINITY, f64::min) - self.half_width;
        let width = SMOOTH / nearest * WIDER.powi(refined);
        let more = MORE * f64::from(refined);
        let middle = (self.slowest + (BEHIND + more) * width).max(1.2 * back);
        let top = middle + (LAST + more) * width;
        if top > FARTHEST * longest {
            return None;
        }
        // sinh u = (H/s) sinh(t/H)
        let end = (longest / s * (top / longest).sinh()).asinh();
        let step = STEP * CLOSER.powi(refined);
        let count = (end / step / LANES as f64).ceil() as usize * LANES;
        let mut points = Points { q2: <_>::default(), weights: Vec::new() };
        let (mut path, mut shares) = (Vec::new(), Vec::new());
        for i in 0..count {
            let u = i as f64 * step;
            let x = s / longest * u.sinh();
            let t = longest * x.asinh();
            let slope = s * u.cosh() / x.hypot(1.0);
            let (tanh, fade) = ((t / d).tanh(), (-(t / back).powi(4)).exp());
            let rise = fade * (1.0 - tanh * tanh - 4.0 * d * tanh * t.powi(3) / back.powi(4));
            let q = Complex64::new(t, d * tanh * fade);
            let window = 0.5 * erfc((t - middle) / width);
            let share = if i == 0 { 0.5 } else { 1.0 } * window * step * slope / PI;
            shares.push(Complex64::new(share, share * rise));
            path.push(q);
            points.q2.0.push((q * q).re);
            points.q2.1.push((q * q).im);
        }
        points.weights = dispatch!(Level::new(), simd => self.weights_in_lanes(simd, &path, &shares));
        Some(points)
    }

    /// sinc(q b) cos(q y), or q sin(q y), times the `shares` of the points of the `path`, receiver by receiver.
    #[inline(always)]
    fn weights_in_lanes<S: Simd>(
        &self,
        simd: S,
        path: &[Complex64],
        shares: &[Complex64],
    ) -> Vec<(Vec<f64>, Vec<f64>)> {
        let load = |z: &[Complex64]| Lanes {
            re: f64x8::from_fn(simd, |i| z[i].re),
            im: f64x8::from_fn(simd, |i| z[i].im),
        };
        let none = (Vec::with_capacity(path.len()), Vec::with_capacity(path.len()));
        let mut weights = vec![none; self.receivers.len()];
        for (q, share) in path.chunks_exact(LANES).zip(shares.chunks_exact(LANES)) {
            let q = load(q);
            let share = load(share) * sinc(q.times(self.half_width));
            for ((re, im), (y, motion)) in weights.iter_mut().zip(&self.receivers) {
                // cos z = cos x cosh y − i sin x sinh y, sin z = sin x cosh y + i cos x sinh y
                let ((sin, cos), up) = (sin_cos(q.re * *y), exp(q.im * *y));
                let down = 1.0 / up;
                let (cosh, sinh) = ((up + down) * 0.5, (up - down) * 0.5);
                let weight = match motion {
                    Motion::Across => share * q * Lanes { re: sin * cosh, im: cos * sinh },
                    _ => share * Lanes { re: cos * cosh, im: -sin * sinh },
                };
                re.extend((0..LANES).map(|i| weight.re[i]));
                im.extend((0..LANES).map(|i| weight.im[i]));
            }
        }
        weights
    }

    /// Σ G times the weights of each receiver; None where G has lost too many digits.
    fn sums(&self, beta: f64, points: &Points) -> Option<Vec<Complex64>> {
        dispatch!(Level::new(), simd => self.sums_in_lanes(simd, beta, points))
    }

    #[inline(always)]
    fn sums_in_lanes<S: Simd>(&self, simd: S, beta: f64, points: &Points) -> Option<Vec<Complex64>> {
        let mut sums = vec![Lanes::real(simd, 0.0); self.receivers.len()];
        let horizontal = self.receivers.iter().any(|receiver| receiver.1 != Motion::Vertical);
        for from in (0..points.q2.0.len()).step_by(LANES) {
            let eight = from..from + LANES;
            let re = f64x8::from_slice(simd, &points.q2.0[eight.clone()]) + beta * beta;
            let k2 = Lanes { re, im: f64x8::from_slice(simd, &points.q2.1[eight.clone()]) };
            let k = k2.sqrt_decaying();
            let found = self.integral.batch.in_plane(simd, k, k2);
            if !found.cost.simd_lt(self.integral.most).all_true() {
                return None;
            }
            // g/k
            let beside = if horizontal { found.compliance[XZ] * k.inv() } else { k };
            for ((sum, (re, im)), (_, motion)) in sums.iter_mut().zip(&points.weights).zip(&self.receivers) {
                let re = f64x8::from_slice(simd, &re[eight.clone()]);
                let im = f64x8::from_slice(simd, &im[eight.clone()]);
                let compliance = if *motion == Motion::Vertical { found.compliance[ZZ] } else { beside };
                *sum = *sum + compliance * Lanes { re, im };
            }
        }
        let sum = |(sum, (_, motion)): (&Lanes<S>, &(f64, Motion))| {
            motion.displacement(beta, Complex64::new(sum.re.reduce_sum(), sum.im.reduce_sum()))
        };
        Some(sums.iter().zip(&self.receivers).map(sum).collect())
    }
}
