//! The ground across the track at one ω: what a force on the rail does to receivers, for any β.
//!
//! ```text
//! h(β, ω; y) = k_eq ũ_base R(β, ω; y)
//! ```
//!
//! is the displacement at y [m per N/m] of a unit force per metre e^{i(ωt + βx)} on the rail, R the receiver integral. It is even in β.
//! A force P e^{iω̃t} moving at v passes a receiver at x = 0 as the spectrum û(ω) = (P/v) h((ω̃ − ω)/v, ω).

use crate::math::interpolation::Interpolant;
use crate::rail::{NEGLIGIBLE, decay, within};
use crate::soil::{PreparedGround, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use std::cell::Cell;

/// Error of h relative to its largest value.
const ACCURACY: f64 = 1e-3;

/// h(β) at one receiver itself, without a table: [m per N/m] to 1e-5, and whether at least 1e-3 was reached. None where waves decay by
/// more than 25 Np on the way: what little arrives is rounding of the integral, and no number is made of it.
pub fn transfer(
    stack: &Stack,
    ground: &dyn PreparedGround,
    strip: Strip,
    (beta, omega): (f64, f64),
    y: f64,
) -> Option<(Complex64, bool)> {
    const EXACT: f64 = 1e-5;
    let slowest = ground.outline().wavenumbers.last().copied().unwrap_or(0.0);
    if decay(beta, slowest, y - strip.half_width) > NEGLIGIBLE {
        return None;
    }
    let under = ground.strip(beta, strip, EXACT);
    let beside = ground.receiver(beta, strip.half_width, y, EXACT);
    let stiffness = 1.0 / under.value;
    let force = stack.respond(beta, omega, stiffness).base * stiffness;
    Some((force * beside.value, within(&under, ACCURACY) && within(&beside, ACCURACY)))
}

/// h at one ω for some receivers.
pub struct Section {
    transfers: Vec<Interpolant>,
    /// Largest β that reaches a receiver [rad/m].
    reach: Vec<f64>,
    converged: bool,
}

impl Section {
    /// `stack` on `ground`, prepared at `omega` > 0, with receivers at distances `receivers` [m], all beyond the strip.
    ///
    /// Accuracy: 1e-3 of the largest value (test `cross_solver::free_field`).
    pub fn new(
        stack: &Stack,
        ground: &dyn PreparedGround,
        strip: Strip,
        omega: f64,
        receivers: &[f64],
    ) -> Self {
        let waves = &ground.outline().wavenumbers;
        let slowest = waves.last().copied().unwrap_or(0.0);
        // waves decay from the edge of the strip; nearer to it than its half-width the track's own bending fades them first
        let distance = |y: f64| (y - strip.half_width).max(0.5 * strip.half_width);
        let beta_max = |y: f64| slowest.hypot((1e4f64.ln() + 2.0) / distance(y));
        let points = |top: f64| {
            let mut points = vec![0.0];
            points.extend(waves.iter().copied().filter(|k| *k < 0.999 * top));
            points.dedup_by(|a, b| *a - *b < 1e-6 * *a);
            points.push(top);
            points
        };
        // 1/k_eq is smooth beside h: one table serves all receivers
        let converged = Cell::new(true);
        let widest = receivers.iter().map(|&y| beta_max(y)).fold(0.0, f64::max);
        let compliance = Interpolant::new(
            |nodes| {
                nodes.map(|beta| {
                    let estimate = ground.strip(beta, strip, 0.1 * ACCURACY);
                    converged.set(converged.get() && within(&estimate, ACCURACY));
                    estimate.value
                })
            },
            &points(widest),
            |_, value| 0.1 * ACCURACY * value.norm(),
        );
        let force = |beta: f64| {
            let stiffness = 1.0 / compliance.at(beta);
            stack.respond(beta, omega, stiffness).base * stiffness
        };
        let (mut transfers, mut reach) = (Vec::new(), Vec::new());
        for &y in receivers {
            let top = beta_max(y);
            let h = |beta: f64| {
                let relative = (0.1 * ACCURACY * decay(beta, slowest, y - strip.half_width).exp()).min(0.1);
                let estimate = ground.receiver(beta, strip.half_width, y, relative);
                converged.set(converged.get() && within(&estimate, 10.0 * relative));
                force(beta) * estimate.value
            };
            let largest = (0..=12).map(|i| h(slowest * f64::from(i) / 12.0).norm()).fold(0.0, f64::max);
            let table = Interpolant::new(|nodes| nodes.map(h), &points(top), |_, _| 0.3 * ACCURACY * largest);
            transfers.push(table);
            reach.push(top);
        }
        let tables = compliance.converged() && transfers.iter().all(Interpolant::converged);
        Self { transfers, reach, converged: tables && converged.get() }
    }

    /// h(β) at receiver number `receiver` [m per N/m]; 0 where β is too short a wave to arrive.
    pub fn transfer(&self, receiver: usize, beta: f64) -> Complex64 {
        let beta = beta.abs();
        if beta > self.reach[receiver] { Complex64::ZERO } else { self.transfers[receiver].at(beta) }
    }

    /// Largest β that reaches receiver number `receiver` [rad/m].
    pub fn reach(&self, receiver: usize) -> f64 {
        self.reach[receiver]
    }

    /// False where a table or an integral was accepted without meeting its tolerance.
    pub fn converged(&self) -> bool {
        self.converged
    }
}
