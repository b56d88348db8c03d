//! A track on a foundation under a harmonic load that stands or moves, seen from the load.
//!
//! A force e^{iω̃t} at x = vt makes ω = ω̃ − βv, and the rail at x′ from it moves by α(x′) e^{iω̃t},
//!
//! ```text
//! α(x′; ω̃) = (1/2π) ∫ ũ_r(β, ω̃ − βv) e^{iβx′} dβ
//! ```
//!
//! The integral is done once by adaptive panels, over a foundation interpolated along the line as finely as the rail feels it; the
//! same nodes serve every x′.
//!
//! Source: Lamprea-Pineda et al. 2022, Eqs 85–87 and application 3.

use super::drive::HARMONIC_ACCURACY as ACCURACY;
use super::tail::Tail;
use super::waves::Waves;
use super::{Answer, Drive, InteractionError, RailError, Receptance, TrackOnFoundation};
use crate::math::quadrature::{Adaptive, Tolerance, miss};
use crate::soil::strip::sinc;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Evaluations of the track allowed (the foundation is interpolated).
const MAX_COUNT: usize = 600_000;

/// Response to a unit harmonic load as waves of both signs of β.
#[derive(Clone, Debug)]
pub struct HarmonicLoad {
    /// ũ_r/2π [m/N]
    waves: Waves,
    /// What is not in them.
    tail: Tail,
    /// Error over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
}

impl HarmonicLoad {
    /// α(x′) [m/N] at `x` = x′ [m], positive ahead of the load.
    pub fn rail(&self, x: f64) -> Complex64 {
        self.waves.at(x) + self.tail.at(x)
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
        let drive = Drive { omega, speed };
        let line = self.harmonic_line(drive)?;
        let tail = self.tail(drive);
        // of one side, of both
        let near = TAU * tail.at(0.0) * if speed == 0.0 { 0.5 } else { 1.0 };
        let mut rail = |beta: f64| {
            let u = self.stack.respond(beta, drive.at(beta), line.stiffness(beta));
            u.rail * sinc(beta * self.half_length) - tail.of(beta)
        };
        // panels: from the origin outward, finer than fifteen nodes can follow e^{iβx′}
        let widest = 14.0 / reach.max(1.0);
        let mut integral = Adaptive::new();
        // what is left beyond the panels
        let mut left = 0.0f64;
        let turn = if speed == 0.0 { None } else { Some(omega / speed) };
        let sides: &[f64] = if speed == 0.0 { &[1.0] } else { &[1.0, -1.0] };
        for &side in sides {
            let (mut from, mut step) = (0.0, 0.01f64);
            loop {
                let mut to = from + step.min(widest);
                if let Some(turn) = turn.filter(|t| side * t > from * (1.0 + 1e-12) && side * t < to) {
                    to = side * turn;
                }
                let ends = if side > 0.0 { [from, to] } else { [-to, -from] };
                integral.add(&mut rail, &ends);
                (from, step) = (to, 1.5 * step);
                let rest = rail(side * from).norm() * from / 3.0;
                let allowed = 0.3 * ACCURACY * (integral.value() + near).norm();
                if rest < allowed {
                    break;
                }
                if from > self.enough() {
                    // the spectrum of a load that is spread changes its sign
                    left = left.max(if self.half_length > 0.0 { 0.0 } else { miss(rest, allowed) });
                    break;
                }
            }
        }
        let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count: MAX_COUNT };
        let estimate = integral.refine(&mut rail, near, tolerance);
        let error = estimate.error / (estimate.value + near).norm();
        if !estimate.converged && (error.is_nan() || error > 1e-2) {
            return Err(InteractionError::Diverges { speed, error });
        }
        let waves = Waves::new(&integral.into_rule(), 1.0 / TAU, |_, rail| rail);
        Ok(HarmonicLoad {
            // standing, it is even in β
            waves: if speed == 0.0 { waves.mirrored() } else { waves },
            tail,
            worst: estimate.miss(0.5 * ACCURACY).max(left).max(line.worst),
        })
    }
}

impl Receptance for TrackOnFoundation<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let reach = x.iter().map(|x| (x - from).abs()).fold(0.0, f64::max);
        let load = self.harmonic(omega, 0.0, reach)?;
        let error = ACCURACY * load.worst * load.rail(0.0).norm();
        Ok(x.iter().map(|x| Answer { value: load.rail(x - from), error }).collect())
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}

/// Nepers beyond which nobody asks how exact a wave is: 1e-11 of it arrives.
pub(crate) const NEGLIGIBLE: f64 = 25.0;

/// √(β² − k²) d: nepers by which waves slower than k = `slowest` decay over a `distance` d [m] from the edge of the strip.
pub(crate) fn decay(beta: f64, slowest: f64, distance: f64) -> f64 {
    (beta * beta - slowest * slowest).max(0.0).sqrt() * distance
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foundation::Springs;
    use crate::track::{Member, Stack};

    #[test]
    fn what_is_left_beyond_the_panels_is_a_number() {
        // a wire on springs, bending so little that a point load never fades: ũ = 1/k throughout, of which the last third over the
        // 0.3e-4 of the whole that are allowed is 1/(0.9e-4)
        let springs = Springs::winkler(1e8, 0.0, 0.0).unwrap();
        let stack = Stack::new(vec![Member::beam(1e-6, 1.0, 0.0).unwrap()], vec![]);
        let load = TrackOnFoundation::new(&stack, &springs, 0.0).harmonic(1.0, 0.0, 0.0).unwrap();
        // EIβ⁴/k is 3e-4 at 414 rad/m, where the panels end
        assert!((load.worst * 0.9e-4 - 1.0).abs() < 1e-3, "{}", load.worst);
        let stack = Stack::new(vec![Member::beam(1e6, 60.0, 0.0).unwrap()], vec![]);
        let load = TrackOnFoundation::new(&stack, &springs, 0.0).harmonic(1.0, 0.0, 0.0).unwrap();
        assert!(load.worst <= 1.0, "{}", load.worst);
    }
}
