//! Every support a force on the bare rail, Eqs (50)–(55), corrected.

use super::cell::{Cell, Support, phases};
use super::span::Span;
use crate::foundation::Foundation;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::Supports;
use num_complex::Complex64;
use std::f64::consts::TAU;

pub(super) const NAME: &str = "point-source";
/// Supports on either side of the force and the farthest place, at first and at most.
const FIRST: usize = 40;
const MOST: usize = 2560;
/// A change by one doubling of the field at the force, after which truncation is over.
const SETTLED: f64 = 1e-10;

/// A rail on equal supports by the forces f_m of so many of them, a symmetric Toeplitz system:
///
///   Σ_n [F_{m−n} + g(x_m − x_n)] f_n = g(x_m − x₀),   u(x) = g(x − x₀) − Σ_n g(x − x_n) f_n,   g = Σ_j a_j e^{−iγ_j|x|}
///
/// F the compliance of supports: 1/D each for itself, or where links or the ground join them (1/2π) ∫ e^{inθ}/D(θ) dθ.
///
/// Accuracy: 1e-9 of the field at the force, once the supports absorb the waves that run into them; it doubles their number up to
/// 2560 on a side, enough from 0.1 dB/m on, and refuses what needs more (test `cross_solver::periodic`).
/// Source: Eqs (50)–(55) with errata.
#[derive(Clone, Copy)]
pub struct PointSource<'a> {
    cell: Cell<'a>,
}

impl<'a> PointSource<'a> {
    /// `supports` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Ground that joins the supports under sleepers without a width; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        Ok(Self { cell: Cell::new(supports, on)? })
    }
}

/// Answers by ever more supports: `fields`(side) [m/N] at the places asked and, last, at the force, doubled from `first` up to `most` on a
/// side until one doubling changes them by less than `settled` of the field at the force.
///
/// # Errors
/// As `fields`; what does not settle at `omega` [rad/s], with its `remedy`.
pub(super) fn doubled(
    fields: impl Fn(usize) -> Result<Option<Vec<Complex64>>, RailError>,
    (first, most): (usize, usize),
    settled: f64,
    omega: f64,
    remedy: &'static str,
) -> Result<Vec<Answer>, RailError> {
    let unsettled = |error| RailError::Unsettled { method: NAME, frequency: omega / TAU, error, remedy };
    let solved = |side| fields(side)?.ok_or(unsettled(f64::INFINITY));
    let mut side = first;
    let mut less = solved(side)?;
    loop {
        side *= 2;
        let mut more = solved(side)?;
        let own = more.last().map_or(f64::NAN, |own| own.norm());
        let change = more.iter().zip(&less).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / own;
        if change < settled {
            more.pop();
            let error = own * (1e-11 + change);
            return Ok(more.into_iter().map(|value| Answer { value, error }).collect());
        }
        if 2 * side > most || change.is_nan() {
            return Err(unsettled(change));
        }
        less = more;
    }
}

/// F_n, n = 0 … `count` − 1 [m/N].
fn compliances(support: &Support, joined: bool, count: usize) -> Vec<Complex64> {
    if !joined {
        let mut alone = vec![Complex64::ZERO; count];
        alone[0] = support.compliance(0.0);
        return alone;
    }
    // even in θ: cosines over half the zone, the images 4 count apart
    let samples = 4 * count.max(512);
    let values: Vec<Complex64> =
        phases(2 * samples).skip(samples).map(|theta| support.compliance(theta)).collect();
    let turns: Vec<f64> = (0..4 * samples).map(|i| (TAU * i as f64 / (4 * samples) as f64).cos()).collect();
    // θ_i = π(i + ½)/samples, nθ_i = 2π n(2i + 1)/(4 samples)
    let mean = |n: usize| {
        let terms =
            values.iter().enumerate().map(|(i, value)| value * turns[n * (2 * i + 1) % (4 * samples)]);
        terms.sum::<Complex64>() / samples as f64
    };
    (0..count).map(mean).collect()
}

/// Solves Σ_n t_{|m−n|} x_n = y_m by Levinson's recursion.
///
/// Source: Golub & Van Loan, Matrix Computations, algorithm 4.7.2.
fn toeplitz(t: &[Complex64], y: &[Complex64]) -> Vec<Complex64> {
    let n = y.len();
    // t₀ = 1
    let r: Vec<Complex64> = t[1..].iter().map(|value| value / t[0]).collect();
    let mut x = vec![y[0] / t[0]];
    let mut b = if n > 1 { vec![-r[0]] } else { vec![] };
    let (mut beta, mut alpha) = (Complex64::ONE, -r.first().copied().unwrap_or_default());
    for k in 1..n {
        beta *= 1.0 - alpha * alpha;
        let known: Complex64 = x.iter().rev().zip(&r).map(|(x, r)| x * r).sum();
        let mu = (y[k] / t[0] - known) / beta;
        (0..k).for_each(|i| x[i] += mu * b[k - 1 - i]);
        x.push(mu);
        if k + 1 < n {
            let known: Complex64 = b.iter().rev().zip(&r).map(|(b, r)| b * r).sum();
            alpha = -(r[k] + known) / beta;
            let turned: Vec<Complex64> = b.iter().rev().map(|b| alpha * b).collect();
            b.iter_mut().zip(turned).for_each(|(b, t)| *b += t);
            b.push(alpha);
        }
    }
    x
}

impl PointSource<'_> {
    /// Fields at `x` of a unit force at `from` with `side` supports beyond all of them; the last one that at the force.
    fn fields(
        &self,
        span: &Span,
        support: &Support,
        (x, from): (&[f64], f64),
        side: usize,
    ) -> Vec<Complex64> {
        let length = self.cell.spacing();
        let ends = x.iter().chain([&from]).fold((from, from), |(low, high), x| (low.min(*x), high.max(*x)));
        let first = (ends.0 / length).floor() as i64 - side as i64;
        let count = ((ends.1 / length).ceil() as i64 + side as i64 - first + 1) as usize;
        let at = |m: usize| (first + m as i64) as f64 * length;
        let matrix: Vec<Complex64> = compliances(support, self.cell.joined(), count)
            .iter()
            .enumerate()
            .map(|(n, own)| own + span.waves.at(n as f64 * length))
            .collect();
        let driven: Vec<Complex64> = (0..count).map(|m| span.waves.at(at(m) - from)).collect();
        let forces = toeplitz(&matrix, &driven);
        let field = |x: &f64| {
            let held: Complex64 = forces.iter().enumerate().map(|(m, f)| f * span.waves.at(x - at(m))).sum();
            span.waves.at(x - from) - held
        };
        x.iter().chain([&from]).map(field).collect()
    }
}

impl Receptance for PointSource<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let span = Span::new(self.cell.rail(), self.cell.spacing(), omega);
        let support = self.cell.support(omega)?;
        let fields = |side| Ok(Some(self.fields(&span, &support, (x, from), side)));
        let remedy = "waves decay too little for so many supports: ask \"floquet\", or \"dirac-comb\" on ground that joins the supports";
        doubled(fields, (FIRST, MOST), SETTLED, omega, remedy)
    }

    fn period(&self) -> Option<f64> {
        Some(self.cell.spacing())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn toeplitz_systems_are_solved() {
        let t: Vec<Complex64> = (0..40)
            .map(|n| {
                Complex64::from_polar(0.8f64.powi(n), -0.7 * f64::from(n)) + if n == 0 { 0.5 } else { 0.0 }
            })
            .collect();
        let y: Vec<Complex64> =
            (0..40).map(|n| Complex64::new(1.0 / f64::from(n + 1), 0.1 * f64::from(n))).collect();
        let x = toeplitz(&t, &y);
        for m in 0..40usize {
            let sum: Complex64 = (0..40usize).map(|n| t[m.abs_diff(n)] * x[n]).sum();
            // measured 5e-15
            assert!((sum - y[m]).norm() < 1e-12, "{m}: {sum} {}", y[m]);
        }
        assert_eq!(toeplitz(&t[..1], &y[..1]), [y[0] / t[0]]);
    }
}
