//! A track on a foundation under a harmonic load that stands or moves, seen from the load.
//!
//! A force e^{iω̃t} at x = vt makes ω = ω̃ − βv, and the rail at x′ from it moves by α(x′) e^{iω̃t},
//!
//! ```text
//! α(x′; ω̃) = (1/2π) ∫ ũ_r(β, ω̃ − βv) e^{iβx′} dβ
//! ```
//!
//! The integral is done once by adaptive panels; the same nodes serve every x′.
//!
//! Source: Lamprea-Pineda et al. 2022, Eqs 85–87 and application 3.

use super::{InteractionError, TrackOnFoundation};
use crate::math::quadrature::{Adaptive, Tolerance};
use crate::soil::strip::sinc;
use crate::soil::{PreparedGround, Strip};
use num_complex::Complex64;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

/// Wanted error of the integral relative to the receptance under the load.
const ACCURACY: f64 = 1e-4;
/// A point load whose spectrum has not faded here [rad/m] stands on nothing that spreads it.
const BETA_CAP: f64 = 400.0;
/// Evaluations of the track allowed.
const MAX_COUNT: usize = 100_000;

/// Response to a unit harmonic load as a quadrature rule over β.
#[derive(Clone, Debug)]
pub struct HarmonicLoad {
    /// Nodes, both signs, ascending [rad/m].
    pub beta: Vec<f64>,
    /// ũ_r times weight/2π [m/N].
    pub rail: Vec<Complex64>,
    /// False where the accuracy was missed.
    pub converged: bool,
}

impl HarmonicLoad {
    /// α(x′) [m/N] at `x` = x′ [m], positive ahead of the load.
    pub fn rail(&self, x: f64) -> Complex64 {
        self.beta.iter().zip(&self.rail).map(|(beta, u)| u * Complex64::cis(beta * x)).sum()
    }
}

impl TrackOnFoundation<'_> {
    /// The response to a unit force e^{iω̃t}, ω̃ = `omega` ≥ 0 [rad/s], moving at `speed` [m/s] (0: standing), for |x′| ≤ `reach`
    /// [m].
    ///
    /// Accuracy: 1e-4 of the receptance under the load (test `cross_solver::receptance`).
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn harmonic(&self, omega: f64, speed: f64, reach: f64) -> Result<HarmonicLoad, InteractionError> {
        // the first foundation that cannot answer; nothing is computed after it
        let failure = RefCell::new(None);
        let last = Cell::new(Complex64::new(1e8, 0.0));
        let converged = Cell::new(true);
        let kept = RefCell::new(HashMap::new());
        let respond = |beta: f64| {
            if let Some(known) = kept.borrow().get(&beta.to_bits()) {
                return *known;
            }
            let omega = omega - beta * speed;
            let unfelt = |k: Complex64| {
                let (once, twice) =
                    (self.stack.respond(beta, omega, k).rail, self.stack.respond(beta, omega, 2.0 * k).rail);
                (once - twice).norm() < 0.1 * ACCURACY * once.norm()
            };
            // where the rail does not feel the foundation any stiffness of its size will do
            if failure.borrow().is_none() && !unfelt(last.get()) {
                // at β = 0 the strip on a half-space has no static stiffness
                match self.foundation.stiffness_to(beta.abs().max(1e-6), omega, 0.1 * ACCURACY) {
                    Ok(k) => {
                        last.set(k.value);
                        converged.set(converged.get() && (k.converged || k.relative_error < ACCURACY));
                    }
                    Err(error) => {
                        failure.replace(Some(error));
                    }
                }
            }
            let u = self.stack.respond(beta, omega, last.get());
            let load = sinc(beta * self.half_length);
            let result = u.rail * load;
            kept.borrow_mut().insert(beta.to_bits(), result);
            result
        };
        let mut rail = |beta: f64| respond(beta);
        // panels: from the origin outward, finer than fifteen nodes can follow e^{iβx′}
        let widest = 14.0 / reach.max(1.0);
        let mut integral = Adaptive::new();
        let turn = if speed == 0.0 { None } else { Some(omega / speed) };
        let sides: &[f64] = if speed == 0.0 { &[1.0] } else { &[1.0, -1.0] };
        let enough = if self.half_length > 0.0 { 60.0 / self.half_length } else { BETA_CAP };
        for &side in sides {
            let (mut from, mut step) = (0.0, 0.01f64);
            loop {
                let mut to = from + step.min(widest);
                // damping changes its sign with ω
                if let Some(turn) = turn.filter(|t| side * t > from * (1.0 + 1e-12) && side * t < to) {
                    to = side * turn;
                }
                let ends = if side > 0.0 { [from, to] } else { [-to, -from] };
                integral.add(&mut rail, &ends);
                (from, step) = (to, 1.5 * step);
                let rest = rail(side * from).norm() * from / 3.0;
                let faded = rest < 0.3 * ACCURACY * integral.value().norm();
                if from > enough && !faded && self.half_length == 0.0 {
                    converged.set(false);
                }
                if faded || from > enough || failure.borrow().is_some() {
                    break;
                }
            }
        }
        // long trains begin with many panels
        let max_count = MAX_COUNT + 3 * kept.borrow().len();
        let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count };
        let estimate = integral.refine(&mut rail, Complex64::ZERO, tolerance);
        if let Some(error) = failure.borrow_mut().take() {
            return Err(error.into());
        }
        let error = estimate.error / estimate.value.norm();
        if !estimate.converged && (error.is_nan() || error > 1e-2) {
            return Err(InteractionError::Diverges { speed, error });
        }
        let mut load = HarmonicLoad {
            beta: Vec::new(),
            rail: Vec::new(),
            converged: estimate.converged && converged.get(),
        };
        for panel in integral.into_panels() {
            for i in 0..15 {
                load.beta.push(panel.x[i]);
                load.rail.push(panel.f[i] * (panel.w[i] / TAU));
            }
        }
        if speed == 0.0 {
            // even in β
            let mirror = |v: &[Complex64]| -> Vec<Complex64> { v.iter().rev().chain(v).copied().collect() };
            load.beta = load.beta.iter().rev().map(|b| -b).chain(load.beta.iter().copied()).collect();
            load.rail = mirror(&load.rail);
        }
        Ok(load)
    }

    /// Displacement of the ground's surface [m/N] at distances `receivers` [m] from the centre line, abreast of a standing unit
    /// force e^{iωt}: (1/π) ∫₀^∞ k_eq ũ_base R(β; y) dβ, R the receiver integral of `ground`, prepared at `omega` ≠ 0.
    ///
    /// Accuracy: 1e-4 of each (test `cross_solver::receptance`).
    ///
    /// # Errors
    /// An integral that diverges.
    pub fn ground(
        &self,
        omega: f64,
        ground: &dyn PreparedGround,
        strip: Strip,
        receivers: &[f64],
    ) -> Result<Vec<Complex64>, InteractionError> {
        let kept = RefCell::new(HashMap::new());
        let force = |beta: f64| {
            *kept.borrow_mut().entry(beta.to_bits()).or_insert_with(|| {
                let stiffness = 1.0 / ground.strip(beta, strip, 0.1 * ACCURACY).value;
                let u = self.stack.respond(beta, omega, stiffness);
                u.base * stiffness * sinc(beta * self.half_length)
            })
        };
        let waves = &ground.outline().wavenumbers;
        let slowest = waves.last().copied().unwrap_or(0.0);
        receivers
            .iter()
            .map(|&y| {
                let mut integrand = |beta: f64| {
                    force(beta)
                        * ground
                            .receiver(beta, strip.half_width, y, receiver_accuracy(beta, slowest, y))
                            .value
                };
                let mut points = vec![0.0];
                points.extend(waves.iter().copied());
                let mut integral = Adaptive::new();
                integral.add(&mut integrand, &points);
                // beyond the slowest wave the field decays
                let mut top = points[points.len() - 1];
                loop {
                    let next = 1.3 * top + 0.2;
                    integral.add(&mut integrand, &[top, next]);
                    top = next;
                    let rest = integrand(top).norm() * top / 3.0;
                    if rest < 0.3 * ACCURACY * integral.value().norm() || top > BETA_CAP {
                        break;
                    }
                }
                let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count: MAX_COUNT };
                let estimate = integral.refine(&mut integrand, Complex64::ZERO, tolerance);
                let error = estimate.error / estimate.value.norm();
                if !estimate.converged && (error.is_nan() || error > 1e-2) {
                    return Err(InteractionError::Diverges { speed: 0.0, error });
                }
                Ok(estimate.value / PI)
            })
            .collect()
    }
}

/// Relative accuracy of R(β; y) worth having: what decays like e^{−√(β² − k²)y} beside waves of wavenumber k = `slowest` is
/// wanted relative to them, not to itself.
fn receiver_accuracy(beta: f64, slowest: f64, y: f64) -> f64 {
    let decay = (beta * beta - slowest * slowest).max(0.0).sqrt() * y;
    (0.1 * ACCURACY * decay.exp()).min(0.1)
}
