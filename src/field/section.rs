//! The ground across the track at one ω: h(β; y) of [`Transfer`] for any β, as tables.

use super::transfer::Transfer;
use crate::math::interpolation::Interpolant;
use crate::math::quadrature::Estimate;
use crate::soil::{PreparedGround, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

/// Error of h relative to its largest value; of its factors; of what lifted paths say of receivers, and of tables, of that.
const ACCURACY: f64 = 1e-3;
const WANTED: f64 = 0.1 * ACCURACY;
const ON_PATH: f64 = 0.3 * ACCURACY;
const IN_TABLES: f64 = 0.5 * ACCURACY;

/// h at one ω for some receivers.
pub struct Section {
    transfers: Vec<Interpolant>,
    /// Largest β that reaches a receiver [rad/m].
    reach: Vec<f64>,
    /// Error of a table or an integral over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
    /// Whether it was found on lifted paths.
    pub lifted: bool,
}

impl Section {
    /// `stack` on `ground`, prepared at `omega` > 0, with receivers at distances `receivers` [m], all beyond the strip: on paths lifted off
    /// the poles where they may be taken, else as the ground answers strips and receivers.
    ///
    /// Accuracy: 1e-3 of the largest value (test `cross_solver::free_field`).
    pub fn new(
        stack: &Stack,
        ground: &dyn PreparedGround,
        strip: Strip,
        omega: f64,
        receivers: &[f64],
    ) -> Self {
        Self::lifted(stack, ground, strip, omega, receivers).unwrap_or_else(|| {
            let transfer = Transfer::new(stack, ground, strip, omega);
            let beside = |beta: f64, r: usize| transfer.receiver(beta, receivers[r], WANTED);
            Self::of(&transfer, receivers, |beta| transfer.compliance(beta, WANTED), beside)
        })
    }

    /// The same on lifted paths alone; None where they may not be taken.
    pub fn lifted(
        stack: &Stack,
        ground: &dyn PreparedGround,
        strip: Strip,
        omega: f64,
        receivers: &[f64],
    ) -> Option<Self> {
        let on_path =
            ground.lifts(strip).then(|| ground.receivers_lifted(strip.half_width, receivers, ON_PATH));
        let on_path = on_path.flatten()?;
        let transfer = Transfer::new(stack, ground, strip, omega);
        // one β serves all receivers
        let known: RefCell<HashMap<u64, Option<Vec<Estimate>>>> = RefCell::default();
        let beside = |beta: f64, r: usize| {
            let mut known = known.borrow_mut();
            match known.entry(beta.to_bits()).or_insert_with(|| on_path.at(beta)) {
                Some(all) => (all[r].value, 0.0),
                None => transfer.receiver(beta, receivers[r], WANTED),
            }
        };
        let compliance = |beta: f64| ground.strip_lifted(beta, strip, WANTED);
        Some(Self { lifted: true, ..Self::of(&transfer, receivers, compliance, beside) })
    }

    /// From 1/k_eq(β), and what arrives `beside` the track of β at a receiver by its number, with its error over what was allowed.
    fn of(
        transfer: &Transfer,
        receivers: &[f64],
        compliance: impl Fn(f64) -> Estimate,
        beside: impl Fn(f64, usize) -> (Complex64, f64),
    ) -> Self {
        let slowest = transfer.slowest;
        let reach: Vec<f64> = receivers.iter().map(|&y| transfer.reach(y)).collect();
        let widest = reach.iter().copied().fold(0.0, f64::max);
        let points = first_points(transfer, receivers.iter().copied().fold(0.0, f64::max), widest);
        let worst = Cell::new(0.0f64);
        let forces: RefCell<HashMap<u64, Complex64>> = RefCell::default();
        let force = |beta: f64| {
            *forces.borrow_mut().entry(beta.to_bits()).or_insert_with(|| {
                let estimate = compliance(beta);
                worst.set(worst.get().max(estimate.miss(ACCURACY)));
                transfer.force(beta, estimate.value)
            })
        };
        let table = |r: usize| {
            let h = |beta: f64| {
                let (receiver, miss) = beside(beta, r);
                worst.set(worst.get().max(miss));
                force(beta) * receiver
            };
            let largest = (0..=12).map(|i| h(slowest * f64::from(i) / 12.0).norm()).fold(0.0, f64::max);
            Interpolant::new(|nodes| nodes.map(h), &points, |_, _| IN_TABLES * largest)
        };
        let transfers: Vec<Interpolant> = (0..receivers.len()).map(table).collect();
        let worst = transfers.iter().map(|table| table.worst).fold(worst.get(), f64::max);
        Self { transfers, reach, worst, lifted: false }
    }

    /// h(β) at receiver number `receiver` [m per N/m]; 0 where β is too short a wave to arrive.
    pub fn transfer(&self, receiver: usize, beta: f64) -> Complex64 {
        let beta = beta.abs();
        if beta > self.reach[receiver] { Complex64::ZERO } else { self.transfers[receiver].at(beta) }
    }

    /// The same at many `beta`.
    pub(super) fn transfers(&self, receiver: usize, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
        cut_off(&self.transfers[receiver], self.reach[receiver], beta)
    }

    /// `h`(β) at receiver number `receiver`, known at every β of another ω = `stretch` times this one's, as a table of its own.
    pub(super) fn alike(
        &self,
        receiver: usize,
        stretch: f64,
        h: impl FnOnce(&[f64]) -> Vec<Complex64>,
    ) -> Interpolant {
        self.transfers[receiver].alike(stretch, h)
    }

    /// Largest β that reaches receiver number `receiver` [rad/m].
    pub fn reach(&self, receiver: usize) -> f64 {
        self.reach[receiver]
    }
}

/// Ends of the first pieces up to `widest`, the same for all receivers, so that they share their nodes: at the waves, as densely as
/// the waves at the `farthest` turn, and beyond them on the scale of β itself, on which h falls.
fn first_points(transfer: &Transfer, farthest: f64, widest: f64) -> Vec<f64> {
    // radians of y √(k² − β²) that a piece follows without being halved
    const TURNS: f64 = 7.0;
    let slowest = transfer.slowest;
    let turns = (1..).map(|i| slowest * slowest - (TURNS * f64::from(i) / farthest).powi(2));
    let mut points: Vec<f64> = turns.take_while(|square| *square > 0.0).map(f64::sqrt).collect();
    points.extend(transfer.waves().iter().copied().filter(|k| *k < 0.999 * widest));
    points.push(0.0);
    points.sort_by(f64::total_cmp);
    points.dedup_by(|a, b| *a - *b < 0.02 * *a);
    while let Some(last) = points.last().copied().filter(|k| *k > 0.0 && 4.0 * k < widest) {
        points.push(3.0 * last);
    }
    points.push(widest);
    points
}

/// A `table` at many |β|, and 0 beyond its `reach`.
pub(super) fn cut_off(table: &Interpolant, reach: f64, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
    let beta: Vec<f64> = beta.map(f64::abs).collect();
    let mut values = table.at_many(&beta);
    for (value, _) in values.iter_mut().zip(&beta).filter(|(_, beta)| **beta > reach) {
        *value = Complex64::ZERO;
    }
    values
}
