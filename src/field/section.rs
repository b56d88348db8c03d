//! The ground across the track at one ω: h(β; y) of [`Transfer`] for any β, as tables.

use super::transfer::Transfer;
use crate::math::interpolation::Interpolant;
use crate::soil::{PreparedGround, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use std::cell::Cell;

/// Error of h relative to its largest value.
const ACCURACY: f64 = 1e-3;

/// h at one ω for some receivers.
pub struct Section {
    transfers: Vec<Interpolant>,
    /// Largest β that reaches a receiver [rad/m].
    reach: Vec<f64>,
    /// Error of a table or an integral over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
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
        let transfer = Transfer::new(stack, ground, strip, omega);
        let slowest = transfer.slowest;
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
        let worst = Cell::new(0.0f64);
        let widest = receivers.iter().map(|&y| beta_max(y)).fold(0.0, f64::max);
        let compliance = Interpolant::new(
            |nodes| {
                nodes.map(|beta| {
                    let estimate = transfer.compliance(beta, 0.1 * ACCURACY);
                    worst.set(worst.get().max(estimate.miss(ACCURACY)));
                    estimate.value
                })
            },
            &points(widest),
            |_, value| 0.1 * ACCURACY * value.norm(),
        );
        let (mut transfers, mut reach) = (Vec::new(), Vec::new());
        for &y in receivers {
            let top = beta_max(y);
            let h = |beta: f64| {
                let (receiver, miss) = transfer.receiver(beta, y, 0.1 * ACCURACY);
                worst.set(worst.get().max(miss));
                transfer.force(beta, compliance.at(beta)) * receiver
            };
            let largest = (0..=12).map(|i| h(slowest * f64::from(i) / 12.0).norm()).fold(0.0, f64::max);
            let table = Interpolant::new(|nodes| nodes.map(h), &points(top), |_, _| 0.3 * ACCURACY * largest);
            transfers.push(table);
            reach.push(top);
        }
        let worst =
            transfers.iter().map(|table| table.worst).fold(worst.get().max(compliance.worst), f64::max);
        Self { transfers, reach, worst }
    }

    /// h(β) at receiver number `receiver` [m per N/m]; 0 where β is too short a wave to arrive.
    pub fn transfer(&self, receiver: usize, beta: f64) -> Complex64 {
        let beta = beta.abs();
        if beta > self.reach[receiver] { Complex64::ZERO } else { self.transfers[receiver].at(beta) }
    }

    /// `h`(β) at receiver number `receiver`, known at every β of another ω = `stretch` times this one's, as a table of its own.
    pub(super) fn alike(&self, receiver: usize, stretch: f64, h: impl Fn(f64) -> Complex64) -> Interpolant {
        self.transfers[receiver].alike(stretch, h)
    }

    /// Largest β that reaches receiver number `receiver` [rad/m].
    pub fn reach(&self, receiver: usize) -> f64 {
        self.reach[receiver]
    }
}
