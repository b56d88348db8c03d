//! The ground across the track at one ω: h(β; y) of [`Transfer`] for any β, as tables.

use super::Channel;
use super::transfer::Transfer;
use crate::math::interpolation::Interpolant;
use crate::math::quadrature::Estimate;
use crate::soil::{Motion, PreparedGround, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

/// Error of h relative to its largest value; of its factors; of what lifted paths say of receivers, and of tables, of that.
const ACCURACY: f64 = 1e-3;
const WANTED: f64 = 0.1 * ACCURACY;
const ON_PATH: f64 = 0.3 * ACCURACY;
const IN_TABLES: f64 = 0.5 * ACCURACY;

/// h at one ω for some channels.
pub struct Section {
    /// Of each channel h(β ≥ 0), the largest β that reaches it [rad/m] and its motion.
    channels: Vec<Heard>,
    /// Error of a table or an integral over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
    /// Whether it was found on lifted paths.
    pub lifted: bool,
}

/// h of one channel.
#[derive(Debug)]
pub(super) struct Heard {
    pub table: Interpolant,
    pub reach: f64,
    pub motion: Motion,
}

impl Heard {
    /// At one β.
    fn at(&self, beta: f64) -> Complex64 {
        if beta.abs() > self.reach {
            return Complex64::ZERO;
        }
        let h = self.table.at(beta.abs());
        if beta < 0.0 { self.motion.mirrored(h) } else { h }
    }

    /// At many β.
    pub fn at_many(&self, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
        let signed: Vec<f64> = beta.collect();
        let beta: Vec<f64> = signed.iter().map(|beta| beta.abs()).collect();
        let mut values = self.table.at_many(&beta);
        for (value, beta) in values.iter_mut().zip(signed) {
            if beta.abs() > self.reach {
                *value = Complex64::ZERO;
            } else if beta < 0.0 {
                *value = self.motion.mirrored(*value);
            }
        }
        values
    }
}

impl Section {
    /// `stack` on `ground`, prepared at `omega` > 0, with `channels` all beyond the strip: on paths lifted off the poles where they may be
    /// taken, else as the ground answers strips and receivers. Horizontal motions are then those of `exact`, the ground by an exact solver.
    ///
    /// Accuracy: 1e-3 of the largest value (tests `cross_solver::free_field`, `cross_solver::horizontal`).
    pub fn new(
        stack: &Stack,
        (ground, exact): (&dyn PreparedGround, &dyn PreparedGround),
        strip: Strip,
        omega: f64,
        channels: &[Channel],
    ) -> Self {
        Self::lifted(stack, ground, strip, omega, channels).unwrap_or_else(|| {
            let transfer = Transfer::new(stack, ground, strip, omega);
            let horizontal = Transfer::new(stack, exact, strip, omega);
            let beside = |beta: f64, c: usize| {
                let of = if channels[c].motion == Motion::Vertical { &transfer } else { &horizontal };
                of.receiver(beta, channels[c], WANTED)
            };
            Self::of(&transfer, channels, |beta| transfer.compliance(beta, WANTED), beside)
        })
    }

    /// The same on lifted paths alone; None where they may not be taken.
    pub fn lifted(
        stack: &Stack,
        ground: &dyn PreparedGround,
        strip: Strip,
        omega: f64,
        channels: &[Channel],
    ) -> Option<Self> {
        let receivers: Vec<(f64, Motion)> = channels.iter().map(|c| (c.y, c.motion)).collect();
        let on_path =
            ground.lifts(strip).then(|| ground.receivers_lifted(strip.half_width, &receivers, ON_PATH));
        let on_path = on_path.flatten()?;
        let transfer = Transfer::new(stack, ground, strip, omega);
        // one β serves all receivers
        let known: RefCell<HashMap<u64, Option<Vec<Estimate>>>> = RefCell::default();
        let beside = |beta: f64, c: usize| {
            let mut known = known.borrow_mut();
            match known.entry(beta.to_bits()).or_insert_with(|| on_path.at(beta)) {
                Some(all) => (all[c].value, 0.0),
                None => transfer.receiver(beta, channels[c], WANTED),
            }
        };
        let compliance = |beta: f64| ground.strip_lifted(beta, strip, WANTED);
        Some(Self { lifted: true, ..Self::of(&transfer, channels, compliance, beside) })
    }

    /// From 1/k_eq(β), and what arrives `beside` the track of β at a channel by its number, with its error over what was allowed.
    fn of(
        transfer: &Transfer,
        channels: &[Channel],
        compliance: impl Fn(f64) -> Estimate,
        beside: impl Fn(f64, usize) -> (Complex64, f64),
    ) -> Self {
        let slowest = transfer.slowest;
        let widest = channels.iter().map(|c| transfer.reach(c.y)).fold(0.0, f64::max);
        let points = first_points(transfer, channels.iter().map(|c| c.y).fold(0.0, f64::max), widest);
        let worst = Cell::new(0.0f64);
        let forces: RefCell<HashMap<u64, Complex64>> = RefCell::default();
        let force = |beta: f64| {
            *forces.borrow_mut().entry(beta.to_bits()).or_insert_with(|| {
                let estimate = compliance(beta);
                worst.set(worst.get().max(estimate.miss(ACCURACY)));
                transfer.force(beta, estimate.value)
            })
        };
        let heard = |(c, &Channel { y, motion }): (usize, &Channel)| {
            let h = |beta: f64| {
                let (receiver, miss) = beside(beta, c);
                worst.set(worst.get().max(miss));
                force(beta) * receiver
            };
            let largest = (0..=12).map(|i| h(slowest * f64::from(i) / 12.0).norm()).fold(0.0, f64::max);
            let table = Interpolant::new(|nodes| nodes.map(h), &points, |_, _| IN_TABLES * largest);
            Heard { table, reach: transfer.reach(y), motion }
        };
        let channels: Vec<Heard> = channels.iter().enumerate().map(heard).collect();
        let worst = channels.iter().map(|heard| heard.table.worst).fold(worst.get(), f64::max);
        Self { channels, worst, lifted: false }
    }

    /// h(β) of channel number `channel` [m per N/m]; 0 where β is too short a wave to arrive.
    pub fn transfer(&self, channel: usize, beta: f64) -> Complex64 {
        self.channels[channel].at(beta)
    }

    /// The same at many `beta`.
    pub(super) fn transfers(&self, channel: usize, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
        self.channels[channel].at_many(beta)
    }

    /// `h`(β ≥ 0) of channel number `channel`, known at every β of another ω = `stretch` times this one's, as a table of its own.
    pub(super) fn alike(
        &self,
        channel: usize,
        stretch: f64,
        h: impl FnOnce(&[f64]) -> Vec<Complex64>,
    ) -> Interpolant {
        self.channels[channel].table.alike(stretch, h)
    }

    /// Largest β that reaches channel number `channel` [rad/m].
    pub fn reach(&self, channel: usize) -> f64 {
        self.channels[channel].reach
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
