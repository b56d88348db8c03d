//! k along the line ω = ω̃ − βv of a harmonic load, interpolated: the panels of the integral then cost no ground.

use super::TrackOnFoundation;
use super::harmonic_load::ACCURACY;
use super::track_on_foundation::{BETA_MIN, Quiet};
use crate::foundation::FoundationError;
use crate::math::complex::reciprocal;
use crate::math::interpolation::{Interpolant, NODES};
use num_complex::Complex64;

/// Speeds [m/s] at which waves of soils may meet the line: ends of the first pieces, which are halved where needed. They save a
/// quarter of the values and change nothing else.
const MEETING: [f64; 7] = [450.0, 300.0, 220.0, 170.0, 120.0, 60.0, 0.0];

/// k(β, ω̃ − βv), where the rail feels it.
pub(super) struct DrivenLine {
    /// 1/k [m²/N] over x = asinh(β/unit).
    compliance: Interpolant,
    unit: f64,
    /// False where an integral or the table missed its accuracy.
    pub(super) converged: bool,
}

impl DrivenLine {
    /// k [N/m²] at `beta` [rad/m]; beyond the table its last value, of which the rail feels nothing.
    pub(super) fn stiffness(&self, beta: f64) -> Complex64 {
        reciprocal(self.compliance.at((beta / self.unit).asinh()))
    }
}

impl TrackOnFoundation<'_> {
    /// k for a load of `omega` ≥ 0 [rad/s] at `speed` ≥ 0 [m/s], as finely as the rail feels it: 300 to 400 values where
    /// the integral for wheels 50 m apart has 3500 nodes.
    ///
    /// Accuracy: the table's error is at most `ACCURACY` of ∫ |ũ_r| dβ for moving loads, a tenth of it for standing ones.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub(super) fn driven_line(&self, omega: f64, speed: f64) -> Result<DrivenLine, FoundationError> {
        // receptances are wanted for themselves; moving loads are asked at hundreds of frequencies, for forces
        let (accuracy, table) = if speed == 0.0 { (0.1, 0.1) } else { (0.5, 1.0) };
        let (accuracy, table) = (accuracy * ACCURACY, table * ACCURACY);
        let (high, mut sum) = self.felt_extent(omega, speed, accuracy)?;
        let mut low = 0.0;
        if speed != 0.0 {
            // β < 0 is β > 0 of a load that runs the other way
            let (extent, more) = self.felt_extent(omega, -speed, accuracy)?;
            (low, sum) = (-extent, sum + more);
        }
        // even in β where waves meet the line, in ln β beyond
        let unit = (omega / (speed + MEETING[2])).max(1e-3);
        // where waves of speed c meet the line, ahead of the load and behind it; damping changes its sign where c = 0
        let mut points = vec![low, 0.0, high];
        points.extend(MEETING.iter().map(|c| omega / (speed + c)).filter(|beta| *beta < high));
        points.extend(MEETING.iter().map(|c| omega / (speed - c)).filter(|beta| low < *beta && *beta < 0.0));
        points.sort_by(f64::total_cmp);
        points.dedup_by(|a, b| *a - *b < 1e-6 * unit);
        let points: Vec<f64> = points.iter().map(|beta| (beta / unit).asinh()).collect();
        let mut failure = None;
        let mut converged = true;
        let compliances = |nodes: &[f64; NODES]| {
            nodes.map(|x| {
                let beta = unit * x.sinh();
                // nothing is computed after the first failure
                match failure.is_none().then(|| self.felt(beta, omega - beta * speed, accuracy)) {
                    Some(Ok((stiffness, good))) => {
                        converged &= good;
                        reciprocal(stiffness)
                    }
                    Some(Err(error)) => {
                        failure = Some(error);
                        Complex64::ONE
                    }
                    None => Complex64::ONE,
                }
            })
        };
        // reciprocity: δu_rail = q² δ(1/k), q the force handed down; its share of the integral is ∝ |β| in ln |β|
        let compliance = Interpolant::new(compliances, &points, |x, compliance| {
            let (beta, stiffness) = (unit * x.sinh(), reciprocal(compliance));
            let q = self.stack.respond(beta, omega - beta * speed, stiffness).force;
            table * sum / (q.norm_sqr() * beta.abs()).max(f64::MIN_POSITIVE)
        });
        match failure {
            Some(error) => Err(error),
            None => Ok(DrivenLine { converged: converged && compliance.converged(), compliance, unit }),
        }
    }

    /// How far from β = 0 upward the rail feels the foundation [rad/m], and ∫ |ũ_r| dβ on the way.
    fn felt_extent(&self, omega: f64, speed: f64, accuracy: f64) -> Result<(f64, f64), FoundationError> {
        const RATIO: f64 = 1.5;
        let enough = self.enough();
        let (mut beta, mut extent, mut sum) = (0.01, 0.01, 0.0);
        let (mut last, mut faded) = (None, Quiet::default());
        loop {
            let at = omega - beta * speed;
            let stiffness = match last {
                Some(stiffness) => stiffness,
                None => self.felt(beta, at, accuracy)?.0,
            };
            let u = self.stack.respond(beta, at, stiffness);
            sum += u.rail.norm() * beta * RATIO.ln();
            // what the foundation adds to the rail's deflection, q²/k: while it counts the foundation is asked again
            let counts = u.force.norm_sqr() / stiffness.norm() * beta > 0.1 * ACCURACY * sum;
            last = if counts { None } else { Some(stiffness) };
            if counts {
                extent = RATIO * beta;
            }
            faded.step(beta, u.rail.norm() * beta < ACCURACY * sum);
            if beta > enough || faded.since().is_some() {
                return Ok((extent, sum));
            }
            beta *= RATIO;
        }
    }

    /// k at (`beta`, `omega`) to `accuracy`, and whether it is good.
    fn felt(&self, beta: f64, omega: f64, accuracy: f64) -> Result<(Complex64, bool), FoundationError> {
        // at β = 0 the strip on a half-space has no static stiffness
        let k = self.foundation.stiffness_to(beta.abs().max(BETA_MIN), omega, accuracy)?;
        Ok((k.value, k.converged || k.relative_error < ACCURACY))
    }
}
