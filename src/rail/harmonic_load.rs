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
use super::waves::Waves;
use super::{Drive, InteractionError, TrackOnFoundation};
use crate::math::quadrature::{Adaptive, Estimate, Tolerance};
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
    /// False where the accuracy was missed.
    pub converged: bool,
}

impl HarmonicLoad {
    /// α(x′) [m/N] at `x` = x′ [m], positive ahead of the load.
    pub fn rail(&self, x: f64) -> Complex64 {
        self.waves.at(x)
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
        let mut rail = |beta: f64| {
            let u = self.stack.respond(beta, drive.at(beta), line.stiffness(beta));
            u.rail * sinc(beta * self.half_length)
        };
        // panels: from the origin outward, finer than fifteen nodes can follow e^{iβx′}
        let widest = 14.0 / reach.max(1.0);
        let mut integral = Adaptive::new();
        let mut faded = true;
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
                if rest < 0.3 * ACCURACY * integral.value().norm() {
                    break;
                }
                if from > self.enough() {
                    faded &= self.half_length > 0.0;
                    break;
                }
            }
        }
        let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count: MAX_COUNT };
        let estimate = integral.refine(&mut rail, Complex64::ZERO, tolerance);
        let error = estimate.error / estimate.value.norm();
        if !estimate.converged && (error.is_nan() || error > 1e-2) {
            return Err(InteractionError::Diverges { speed, error });
        }
        let waves = Waves::new(&integral.into_rule(), 1.0 / TAU, |_, rail| rail);
        Ok(HarmonicLoad {
            // standing, it is even in β
            waves: if speed == 0.0 { waves.mirrored() } else { waves },
            converged: estimate.converged && faded && line.worst <= 1.0,
        })
    }
}

/// True if an integral that was asked for more has at least `relative` accuracy.
pub(crate) fn within(estimate: &Estimate, relative: f64) -> bool {
    estimate.converged || estimate.error <= relative * estimate.value.norm()
}

/// Nepers beyond which nobody asks how exact a wave is: 1e-11 of it arrives.
pub(crate) const NEGLIGIBLE: f64 = 25.0;

/// √(β² − k²) d: nepers by which waves slower than k = `slowest` decay over a `distance` d [m] from the edge of the strip.
pub(crate) fn decay(beta: f64, slowest: f64, distance: f64) -> f64 {
    (beta * beta - slowest * slowest).max(0.0).sqrt() * distance
}
