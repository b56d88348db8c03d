//! The ground's surface around a standing harmonic load on the rail.
//!
//! ```text
//! u_z(x, y) = (1/π) ∫₀^∞ h(β, ω; y) cos(βx) dβ,   h = k_eq ũ_base R(β, ω; y)
//! R(β, ω; y) = (1/π) ∫₀^∞ G_zz(√(β² + q²), ω) sinc(qb) cos(qy) dq
//! ```
//!
//! Both integrals are done by adaptive panels, once for the nearest and the farthest point, fine enough to follow cos(βx) and
//! cos(qy) everywhere between; the same nodes then serve all points. There is no period, hence no wrap-around however light
//! the damping. The field is even in x and in y.

use super::mirrored::Mirrored;
use super::transfer::Transfer;
use crate::math::complex::I;
use crate::math::interpolation::Interpolant;
use crate::math::quadrature::{Adaptive, Node, Tolerance, subdivided};
use crate::rail::{InteractionError, TrackOnFoundation};
use crate::soil::strip::sinc;
use crate::soil::{PreparedGround, Strip};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Wanted error relative to the value abreast of the load, of the nearest row and of the farthest.
const ACCURACY: f64 = 1e-4;
/// Evaluations of the nearest and the farthest row allowed.
const MAX_COUNT: usize = 200_000;
/// Far rows of less than this share of the nearest are not followed to ACCURACY of themselves.
const LEAST_SHARE: f64 = 0.1;

/// u_z around a unit harmonic force at x = 0.
#[derive(Clone, Debug)]
pub struct StandingField {
    /// One value for each (y, x) [m/N], positive down, phases of e^{iωt}.
    pub values: Array2<Complex64>,
    /// Estimated error of the integrals relative to the largest value.
    pub error: f64,
}

/// How far h reaches in β.
struct Reach {
    /// The wavenumber beyond which the nearest row is negligible, or the last one looked at [rad/m].
    top: f64,
    /// ∫ |h| dβ of the nearest row beyond it.
    rest: f64,
    /// The largest |h| of the nearest and of the farthest row.
    largest: [f64; 2],
}

/// h beside a standing load.
struct Beside<'a> {
    track: &'a TrackOnFoundation<'a>,
    transfer: Transfer<'a>,
}

impl Beside<'_> {
    /// 1/k_eq [m²/N]
    fn compliance(&self, beta: f64) -> Complex64 {
        self.transfer.compliance(beta, 0.1 * ACCURACY).value
    }

    /// h(β; y) for `y`, nearest first, of a load at a point of the rail, and its error.
    fn at(&self, beta: f64, compliance: Complex64, y: &[f64]) -> (Vec<Complex64>, f64) {
        let force = self.transfer.force(beta, compliance);
        // wanted relative to the waves beside which it decays, not to itself
        let decay = |y: f64| self.transfer.nepers(beta, y).max(0.0).exp();
        let relative = (0.03 * ACCURACY * decay(y[0])).min(0.1);
        let reached = y.partition_point(|y| 0.01 * ACCURACY * decay(*y) < 1.0).max(1);
        let answers = self.transfer.receivers(beta, &y[..reached], relative);
        let error = answers.iter().map(|r| r.error).fold(0.0, f64::max) * force.norm();
        let mut h: Vec<Complex64> = answers.iter().map(|r| force * r.value).collect();
        h.resize(y.len(), Complex64::ZERO);
        (h, error)
    }

    /// sinc(βa) of a load spread over 2a along the track.
    fn spread(&self, beta: f64) -> f64 {
        sinc(beta * self.track.half_length)
    }

    /// Where the integral over β may end, for the nearest and the farthest row.
    fn reach(&self, y: &[f64; 2]) -> Reach {
        const STEPS: u32 = 12;
        let a = self.track.half_length;
        // of a load spread over 2a sixty radians leave 1/60² of the integral, as in the rail's
        let enough = self.track.enough();
        let (mut sum, mut largest) = (0.0, [0.0f64; 2]);
        let mut size = |beta: f64, width: f64| {
            let h = self.at(beta, self.compliance(beta), y).0;
            // the envelope of the load's spectrum, not its zeros
            let size = [0, 1].map(|row| h[row].norm() / 1f64.hypot(beta * a));
            largest = [0, 1].map(|row| largest[row].max(size[row]));
            sum += size[0] * width;
            (size[0], sum)
        };
        let step = self.transfer.slowest / f64::from(STEPS);
        for i in 0..STEPS {
            size(step * (f64::from(i) + 0.5), step);
        }
        let mut top = self.transfer.slowest;
        loop {
            let next = 1.3 * top + 0.2;
            let (last, sum) = size(next, next - top);
            top = next;
            // ∫ |h| dβ ≈ |h|β/3 of what falls like β⁻⁴, |h|/a of what changes its sign with sinc βa
            let rest = last * if a > 0.0 { (top / 3.0).min(1.0 / a) } else { top / 3.0 };
            // waves that cancel leave less than the sum of |h|
            if rest < 0.1 * ACCURACY * sum || top > enough {
                return Reach { top, rest, largest };
            }
        }
    }
}

/// Σ h cos(βx) over the `nodes` with their `rows` h(β; y), for every y.
fn column(nodes: &[Node], rows: &[(Vec<Complex64>, f64)], x: f64) -> Vec<Complex64> {
    let mut column = vec![Complex64::ZERO; rows.first().map_or(0, |row| row.0.len())];
    for (node, (h, _)) in nodes.iter().zip(rows) {
        let cos = (node.x * x).cos();
        column.iter_mut().zip(h).for_each(|(sum, h)| *sum += h * cos);
    }
    column
}

impl TrackOnFoundation<'_> {
    /// Displacement of the ground's surface [m/N] at the positions `x` × `y` [m] around a standing unit force e^{iωt} on the rail
    /// at x = 0, y from the centre line of the track; under the track too. `ground` is prepared at `omega` ≠ 0; neither `x`
    /// nor `y` is empty.
    ///
    /// Accuracy: 1e-4 of the largest value (test `cross_solver::standing_field`). The cost grows with the farthest x times the
    /// farthest y.
    ///
    /// # Errors
    /// An integral that diverges.
    pub fn standing_field(
        &self,
        omega: f64,
        ground: &dyn PreparedGround,
        strip: Strip,
        (x, y): (&[f64], &[f64]),
    ) -> Result<StandingField, InteractionError> {
        let (along, across) = (Mirrored::new(x), Mirrored::new(y));
        let ends = |all: &[f64]| [all[0], all[all.len() - 1]];
        let (x_ends, y_ends) = (ends(&along.distances), ends(&across.distances));
        let waves = &ground.outline().wavenumbers;
        let beside = Beside { track: self, transfer: Transfer::new(self.stack, ground, strip, omega) };

        let Reach { top, rest, largest: [near, far] } = beside.reach(&y_ends);
        let far = far.max(LEAST_SHARE * near);
        let mut points = vec![0.0];
        points.extend(waves.iter().copied().filter(|k| *k > 0.0 && *k < 0.999 * top));
        points.dedup_by(|a, b| *a - *b < 1e-6 * *a);
        points.push(top);
        let compliance = Interpolant::new(
            |nodes| nodes.map(|beta| beside.compliance(beta)),
            &points,
            |_, value| 0.1 * ACCURACY * value.norm(),
        );
        // panels no wider than fifteen nodes can follow cos βx and the phase √(k² − β²) y
        let widest = 14.0 / (x_ends[1] + y_ends[1]).max(1.0);
        let fine = subdivided(&points, widest);
        // two real measures of scale, one complex integrand: neither row hides the other
        let mut integrand = |beta: f64| {
            let (h, _) = beside.at(beta, compliance.at(beta), &y_ends);
            (h[0] / near + I * h[1] / far) * beside.spread(beta)
        };
        let mut integral = Adaptive::new();
        integral.add(&mut integrand, &fine);
        let max_count = MAX_COUNT + 30 * fine.len();
        let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count };
        let estimate = integral.refine(&mut integrand, Complex64::ZERO, tolerance);
        // all rows at every node, times weight/π
        let nodes = integral.into_rule().0;
        let rows: Vec<(Vec<Complex64>, f64)> = nodes
            .par_iter()
            .map(|&Node { x: beta, weight, .. }| {
                let (mut h, error) = beside.at(beta, compliance.at(beta), &across.distances);
                let weight = weight / PI * beside.spread(beta);
                h.iter_mut().for_each(|h| *h *= weight);
                (h, error * weight.abs())
            })
            .collect();
        let columns: Vec<Vec<Complex64>> =
            along.distances.par_iter().map(|x| column(&nodes, &rows, *x)).collect();
        let values =
            Array2::from_shape_fn((y.len(), x.len()), |(j, i)| columns[along.places[i]][across.places[j]]);
        let largest = values.iter().map(|u| u.norm()).fold(0.0, f64::max);
        let within: f64 = rows.iter().map(|row| row.1).sum();
        let error = ((estimate.error * near.max(far) + rest) / PI + within) / largest;
        if error.is_nan() || error > 1e-2 {
            return Err(InteractionError::Diverges { speed: 0.0, error });
        }
        Ok(StandingField { values, error })
    }
}
