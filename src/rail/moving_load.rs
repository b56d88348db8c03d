//! A track on a foundation under a constant load at constant speed, seen from the load.
//!
//! ```text
//! w(x′) = (1/2π) ∫ ũ(β, −βv) e^{iβx′} dβ = (1/π) Re ∫₀^∞ ũ(β, −βv) e^{iβx′} dβ
//! ```
//!
//! The integral is done once by adaptive panels; the same nodes then serve every x′, every member and, by
//! superposition, every axle. There is no period and no wrap-around.

use super::drive::Line;
use super::tail::Tail;
use super::track_on_foundation::{BETA_MIN, InteractionError, TrackOnFoundation};
use super::waves::Waves;
use crate::math::quadrature::{Adaptive, Rule, Tolerance};
use crate::soil::strip::sinc;
use crate::track::{Displacements, Stack};
use num_complex::Complex64;
use std::f64::consts::PI;

/// Evaluations of the track allowed (the foundation is interpolated).
const MAX_COUNT: usize = 600_000;

/// The response to a unit load at one speed, ready for any position.
#[derive(Clone, Debug)]
pub struct MovingLoad {
    /// v [m/s]
    pub speed: f64,
    rail: RailWaves,
    /// ũ/π of the base [m/N].
    base: Waves,
    /// Error over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
    /// Evaluations of the ground, bounded however little it damps: where that cut the work short, `worst` is above 1.
    pub count: usize,
}

/// The rail alone under a unit load at one speed.
#[derive(Clone, Debug)]
pub struct RailLoad {
    waves: RailWaves,
    /// As of a [`MovingLoad`].
    pub worst: f64,
    /// Of the table of the ground.
    pieces: Vec<f64>,
}

/// The rail under loads P_j that stand a_j behind the first, w(x′) = Σ P_j w₁(x′ + a_j).
#[derive(Clone, Debug)]
pub struct RailWaves {
    /// ũ/π Σ P_j e^{iβa_j} [m]
    waves: Waves,
    /// What of a unit load is not in its waves.
    tail: Tail,
    /// a_j [m], P_j [N]
    loads: Vec<(f64, f64)>,
}

/// Displacements of rail and base at uniform positions, per unit load [m/N].
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// First position x′ [m]; positive ahead of the load.
    pub from: f64,
    /// Spacing [m].
    pub step: f64,
    /// Rail, positive down.
    pub rail: Vec<f64>,
    /// Base of the track, positive down.
    pub base: Vec<f64>,
}

/// Panel ends up to `beta_max` [rad/m]: growing from the logarithm at 0, then no wider than fifteen nodes can follow e^{iβx′} for
/// |x′| ≤ `reach` [m].
pub(crate) fn panels(beta_max: f64, reach: f64) -> Vec<f64> {
    let widest = 14.0 / reach.max(1.0);
    let mut points = vec![0.0, BETA_MIN];
    let mut beta = BETA_MIN;
    while beta < beta_max {
        beta = (beta + (3.0 * beta).min(widest)).min(beta_max);
        points.push(beta);
    }
    points
}

impl TrackOnFoundation<'_> {
    /// The spectrum of a unit load at `speed` [m/s], with the foundation interpolated as finely as the rail feels it.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn spectrum(&self, speed: f64) -> Result<MovingSpectrum<'_>, InteractionError> {
        self.spectrum_near(speed, None, true)
    }

    fn spectrum_near(
        &self,
        speed: f64,
        near: Option<&RailLoad>,
        base: bool,
    ) -> Result<MovingSpectrum<'_>, InteractionError> {
        self.check(0.0, speed)?;
        let extent = self.extent(speed, base)?;
        let mut line = self.constant_line(speed, &extent, near.map(|near| near.pieces.as_slice()))?;
        if !extent.bounded {
            line.worst = f64::INFINITY;
        }
        Ok(MovingSpectrum {
            stack: self.stack,
            half_length: self.half_length,
            accuracy: self.accuracy,
            line,
            speed,
            beta_max: extent.end,
        })
    }

    /// The response to a unit load at `speed` [m/s] for positions with |x′| ≤ `reach` [m].
    ///
    /// Accuracy: 1e-5 of the deflection under the load (tests `analytic::beam`, `cross_solver::critical_speed`).
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn moving(&self, speed: f64, reach: f64) -> Result<MovingLoad, InteractionError> {
        let spectrum = self.spectrum(speed)?;
        let tail = self.tail(0.0, speed);
        let (rule, missed) = spectrum.rail(&tail, reach)?;
        Ok(MovingLoad {
            speed,
            rail: RailWaves::of_one(&rule, tail),
            base: Waves::new(&rule, 1.0 / PI, |beta, _| spectrum.at(beta).base),
            worst: missed,
            count: spectrum.line.count,
        })
    }

    /// The rail alone, begun where that of a speed `near` by ended: a quarter of the ground's values less.
    ///
    /// # Errors
    /// As `moving`.
    pub fn rail_near(
        &self,
        speed: f64,
        reach: f64,
        near: Option<&RailLoad>,
    ) -> Result<RailLoad, InteractionError> {
        let spectrum = self.spectrum_near(speed, near, false)?;
        let tail = self.tail(0.0, speed);
        let (rule, worst) = spectrum.rail(&tail, reach)?;
        let pieces = spectrum.line.pieces().to_vec();
        Ok(RailLoad { waves: RailWaves::of_one(&rule, tail), worst, pieces })
    }
}

/// Spectra of a unit load moving over a track on a foundation, at ω = −βv.
pub struct MovingSpectrum<'a> {
    stack: &'a Stack,
    half_length: f64,
    accuracy: f64,
    line: Line<'a>,
    /// v [m/s]
    pub speed: f64,
    /// Beyond it [rad/m] nothing matters.
    pub beta_max: f64,
}

impl MovingSpectrum<'_> {
    /// The integral of what the rail does beside its `tail`, for positions with |x′| ≤ `reach` [m], and by what the accuracy was missed.
    fn rail(&self, tail: &Tail, reach: f64) -> Result<(Rule, f64), InteractionError> {
        let mut integral = Adaptive::new();
        let mut integrand = |beta: f64| self.at(beta).rail - tail.of(beta);
        integral.add(&mut integrand, &panels(self.beta_max, reach));
        let tolerance = Tolerance { relative: self.accuracy, absolute: 0.0, max_count: MAX_COUNT };
        let estimate = integral.refine(&mut integrand, PI * tail.at(0.0), tolerance);
        let error = estimate.error / (estimate.value + PI * tail.at(0.0)).norm();
        if !estimate.converged && (error.is_nan() || error > 1e-3) {
            return Err(InteractionError::Diverges { speed: self.speed, error });
        }
        Ok((integral.into_rule(), self.worst().max(estimate.miss(self.accuracy))))
    }

    /// Displacements per unit load [m per N/m], and the force handed down [1], at `beta` ≥ 0 [rad/m].
    pub fn at(&self, beta: f64) -> Displacements {
        let stiffness = self.line.stiffness(beta.max(BETA_MIN));
        let load = sinc(beta * self.half_length);
        let u = self.stack.respond(beta, -beta * self.speed, stiffness);
        Displacements { rail: u.rail * load, base: u.base * load, force: u.force * load }
    }

    /// q̃ = k_eq ũ_base: force handed to the ground per unit load [1], at `beta` ≥ 0 [rad/m]; 1 at β = 0.
    pub fn force(&self, beta: f64) -> Complex64 {
        self.at(beta).force
    }

    /// The wavenumber [rad/m] beyond which less than 1e-3 of the load reaches the ground: the track spreads it.
    pub fn force_extent(&self) -> f64 {
        let mut beta = self.beta_max;
        while beta > 0.1 && self.force(beta).norm() < 1e-3 {
            beta *= 0.95;
        }
        beta
    }

    /// The wavenumber [rad/m] around which the base responds most, ∫ |ũ_base| d ln β counted.
    pub fn dominant_wavenumber(&self) -> f64 {
        let steps = 400;
        let at = |i: i32| 0.01 * (self.beta_max / 0.01).powf(f64::from(i) / f64::from(steps));
        (0..=steps)
            .map(at)
            .max_by(|a, b| (a * self.at(*a).base.norm()).total_cmp(&(b * self.at(*b).base.norm())))
            .unwrap_or(1.0)
    }

    /// Error of the foundation over what was allowed, where it is largest: at most 1 where its accuracy was reached.
    pub fn worst(&self) -> f64 {
        self.line.worst
    }
}

impl MovingLoad {
    /// Whether the accuracy was reached.
    pub fn converged(&self) -> bool {
        self.worst <= 1.0
    }

    /// Rail displacement per unit load at `x` = x′ [m], positive ahead of the load [m/N].
    pub fn rail(&self, x: f64) -> f64 {
        self.rail.waves.at(x).re + self.rail.tail.at(x).re
    }

    /// Rail and base at `count` positions from `from` in steps of `step` [m].
    pub fn shape(&self, from: f64, step: f64, count: usize) -> Shape {
        Shape {
            from,
            step,
            rail: self.rail.shape(from, step, count),
            base: self.base.shape(from, step, count),
        }
    }
}

impl RailLoad {
    /// The same under `loads` P_j [N], each a_j [m] behind the first: (a_j, P_j).
    pub fn under(&self, loads: Vec<(f64, f64)>) -> RailWaves {
        RailWaves { waves: self.waves.waves.under(&loads), tail: self.waves.tail, loads }
    }
}

impl RailWaves {
    fn of_one(rule: &Rule, tail: Tail) -> Self {
        Self { waves: Waves::new(rule, 1.0 / PI, |_, rail| rail), tail, loads: vec![(0.0, 1.0)] }
    }

    /// Displacement [m] at `count` positions from `from` in steps of `step` [m] seen from the first load, positive down.
    pub fn shape(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        let mut shape = self.waves.shape(from, step, count);
        if self.tail.is_none() {
            return shape;
        }
        let reach = self.tail.reach();
        for (behind, load) in &self.loads {
            // |x′ + a| ≤ reach
            let place = |x: f64| ((x - behind - from) / step).ceil().clamp(0.0, count as f64) as usize;
            let (first, end) = (place(-reach), place(reach));
            for (i, w) in (first..).zip(&mut shape[first..end]) {
                *w += load * self.tail.at(from + step * i as f64 + behind).re;
            }
        }
        shape
    }
}
