//! |h|² along β = ω/v: what a constant load of speed v does to receivers, at any frequency.

use super::pass::{Pass, pointwise};
use super::{Sections, Transfer};
use crate::math::interpolation::cubic_weights;
use crate::soil::{GroundSolver, Profile, SoilError, Solver, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Error of h from which on it counts as missed.
const LEAST: f64 = 1e-3;
/// Error of h that is asked for.
const WANTED: f64 = 2e-4;

/// What knows h along β = ω/v.
pub enum ConstantLoad<'a> {
    /// Of a load slower than the waves: there h falls over tens of decades, where its logarithm is smooth.
    Slow(SlowLoad),
    /// Of a load that outruns a wave: tables of the ground across the track.
    Fast(&'a Sections),
}

/// ln |h|² at frequencies in equal steps of ln f.
pub struct SlowLoad {
    /// ln f of the first value and the step between them.
    low: f64,
    step: f64,
    /// ln |h|² of each frequency and channel; None where nothing arrives that the integral could tell from its rounding.
    logarithms: Vec<Vec<Option<f64>>>,
    /// Error of a value that matters over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
}

impl SlowLoad {
    /// Of `pass` over `stack` on the `strip` of a ground, four values per band: each β has its own ω.
    ///
    /// Accuracy: 1e-3 of the energy of the bands that are not negligible beside the largest (test `cross_solver::free_field`).
    ///
    /// # Errors
    /// A ground that cannot answer.
    pub fn new(
        pass: &Pass,
        stack: &Stack,
        (profile, solver): (&Profile, Solver),
        strip: Strip,
    ) -> Result<Self, SoilError> {
        let solver = pointwise(solver);
        let (low, high) = match (pass.bands.first(), pass.bands.last()) {
            (Some(first), Some(last)) => (first.lower().ln(), last.upper().ln()),
            _ => (0.0, 0.0),
        };
        let count = 4 * pass.bands.len().max(1) + 1;
        let step = (high - low) / (count - 1) as f64;
        let channels = pass.channels();
        let rows: Vec<Vec<Option<(Complex64, f64)>>> = (0..count)
            .into_par_iter()
            .map(|i| {
                let omega = TAU * (low + step * i as f64).exp();
                let ground = solver.prepare(profile, omega, &[])?;
                let transfer = Transfer::new(stack, ground.as_ref(), strip, omega);
                Ok(transfer.exact(omega / pass.speed, &channels, WANTED, LEAST))
            })
            .collect::<Result<_, SoilError>>()?;
        // velocities ω|h| of less than 1e-3 of a receiver's largest add 1e-6 of its energy: what is known of them does not count
        let velocity =
            |i: usize, r: usize| rows[i][r].map_or(0.0, |h| h.0.norm() * (low + step * i as f64).exp());
        let missed = (0..channels.len()).map(|r| {
            let largest = (0..count).map(|i| velocity(i, r)).fold(0.0, f64::max);
            let quiet = |i: usize| velocity(i, r) < 1e-3 * largest;
            (0..count).filter(|i| !quiet(*i)).filter_map(|i| rows[i][r].map(|h| h.1)).fold(0.0, f64::max)
        });
        let worst = missed.fold(0.0, f64::max);
        let logarithm = |h: Option<(Complex64, f64)>| h.map(|h| h.0.norm_sqr().ln());
        let logarithms = rows.into_iter().map(|row| row.into_iter().map(logarithm).collect()).collect();
        Ok(Self { low, step, logarithms, worst })
    }

    /// |h|² of channel number `channel` and `f` [Hz]: a cubic through four logarithms; 0 where one of them is not known.
    fn square(&self, channel: usize, f: f64) -> f64 {
        let place = (f.ln() - self.low) / self.step;
        let i = (place.floor() as isize).clamp(1, self.logarithms.len() as isize - 3) as usize;
        let weights = cubic_weights(place - i as f64);
        let sum: Option<f64> =
            (0..4).map(|m| self.logarithms[i + m - 1][channel].map(|l| weights[m] * l)).sum();
        sum.map_or(0.0, f64::exp)
    }
}

impl ConstantLoad<'_> {
    /// |h|² [m² per (N/m)²] of all channels of `pass` at `f` [Hz], within its bands.
    pub fn squares(&self, pass: &Pass, f: f64) -> Vec<f64> {
        let channels = 0..pass.channels().len();
        match self {
            Self::Slow(slow) => channels.map(|c| slow.square(c, f)).collect(),
            Self::Fast(sections) => {
                let ground = sections.at(TAU * f);
                channels.map(|c| ground.transfer(c, TAU * f / pass.speed).norm_sqr()).collect()
            }
        }
    }

    /// Error over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub fn worst(&self) -> f64 {
        match self {
            Self::Slow(slow) => slow.worst,
            Self::Fast(sections) => sections.worst,
        }
    }
}
