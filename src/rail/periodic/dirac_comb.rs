//! Equal supports as a comb in the wavenumber: an integral over the zone of one bay, Eqs (57)–(61), corrected.

use super::cell::{Cell, Support, phases};
use super::floquet::ahead;
use super::span::{Pair, Span};
use crate::foundation::Foundation;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::Supports;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Phases of the zone to begin with, and at most. The fewest with a decay of 0.04 dB/m are 10⁴.
const FIRST: usize = 64;
const MOST: usize = 1 << 20;
/// A change by one doubling, of the field at the force, after which the next one, its square, is rounding.
const SETTLED: f64 = 1e-8;

/// A rail on equal supports by an integral over the zone of the phase θ = βL of a bay:
///
///   u = (1/2π) ∫ e^{inθ} N(θ)/R(θ) dθ,   N/R = S_β(x − x₀) − D S_β(x)S_β(−x₀)/(1 + D S_β(0)),   S_β(x) = (1/L) Σ_j e^{iβ_jx}/D_r(β_j),
///
/// the image sums in closed form, φ(x; e^{iβL}), over a common denominator in which the poles of the bare rail cancel. Ground may join
/// the supports.
///
/// Accuracy: 1e-9 of the field at the force wherever the track damps, the integrand being periodic and smooth: every doubling of
/// the phases squares the error (test `cross_solver::periodic`). Without damping it does not settle.
/// Source: Eqs (57)–(59) with errata.
#[derive(Clone, Copy)]
pub struct DiracComb<'a> {
    cell: Cell<'a>,
}

impl<'a> DiracComb<'a> {
    /// `supports` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Ground that joins the supports under sleepers without a width; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        Ok(Self { cell: Cell::new(supports, on)? })
    }

    /// The bay.
    pub fn cell(&self) -> &Cell<'a> {
        &self.cell
    }
}

/// Σ over `count` phases of the fields of all `pairs` (with their bays).
fn sum(span: &Span, support: &Support, pairs: &[(i64, Pair)], count: usize) -> Vec<Complex64> {
    let mut sums = vec![Complex64::ZERO; pairs.len()];
    for theta in phases(count) {
        let (lambda, delta, support) = (Complex64::cis(theta), span.delta_at(theta), support.at(theta));
        for (sum, (bays, pair)) in sums.iter_mut().zip(pairs) {
            let (numerator, denominator) = span.quotient(pair, lambda, support, delta);
            // the phase of far bays without the rounding of a power
            let turn = Complex64::cis((*bays as f64 * theta) % TAU);
            *sum += turn * numerator / denominator;
        }
    }
    sums
}

impl Receptance for DiracComb<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let spacing = self.cell.spacing();
        let span = Span::new(self.cell.rail(), spacing, omega);
        let support = self.cell.support(omega)?;
        // the field at the force comes first
        let places = std::iter::once(&from).chain(x).map(|x| {
            let (bays, high, low) = ahead(*x, from, spacing);
            (bays, span.pair(high, low))
        });
        let pairs: Vec<(i64, Pair)> = places.collect();
        let mut count = FIRST;
        let mut sums = sum(&span, &support, &pairs, count);
        loop {
            // 3N phases have the N among them, all from the middle of their step
            let finer = sum(&span, &support, &pairs, 3 * count);
            let mean = |sums: &[Complex64], count: usize, i: usize| sums[i] / count as f64;
            let own = mean(&finer, 3 * count, 0).norm();
            let changes =
                (0..pairs.len()).map(|i| (mean(&finer, 3 * count, i) - mean(&sums, count, i)).norm());
            let change = changes.fold(0.0, f64::max) / own;
            (count, sums) = (3 * count, finer);
            if change < SETTLED {
                let error = own * (1e-13 + change * change);
                let answer = |i: usize| Answer { value: mean(&sums, count, i), error };
                return Ok((1..pairs.len()).map(answer).collect());
            }
            if 3 * count > MOST || change.is_nan() {
                let remedy = "give the supports some damping, or ask \"floquet\", which needs none";
                let frequency = omega / TAU;
                return Err(RailError::Unsettled { method: "dirac-comb", frequency, error: change, remedy });
            }
        }
    }

    fn period(&self) -> Option<f64> {
        Some(self.cell.spacing())
    }
}
