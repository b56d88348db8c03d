//! What a constant load passing at constant speed does to a channel of a receiver: the quasi-static history, without period or wrap-around.
//!
//! ```text
//! w(x′; y) = (1/π) Re ∫₀^∞ q̃(β) R(β, −βv; y) e^{iβx′} dβ,   u(t) = w(−vt),   q̃ = k_eq ũ_base
//! ```
//!
//! with R the receiver integral of the ground. It is the line at y through the contour around the load.

use super::Channel;
use crate::foundation::FoundationError;
use crate::math::complex::I;
use crate::math::interpolation::{Interpolant, NODES};
use crate::math::quadrature::{Adaptive, Tolerance};
use crate::rail::{BETA_MIN, InteractionError, MovingSpectrum, Waves, panels};
use crate::soil::{GroundSolver, Profile, Solver, Strip};
use crate::vehicle::Axle;
use num_complex::Complex64;
use std::cell::Cell;
use std::f64::consts::PI;

/// Wanted error relative to the largest displacement.
const ACCURACY: f64 = 1e-5;

/// The history at one receiver of a unit load, or of a train.
#[derive(Clone, Debug)]
pub struct Passage {
    speed: f64,
    /// q̃R/π
    waves: Waves,
    /// Error over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
}

impl Passage {
    /// Displacement [m/N] `time` [s] after the load was abreast.
    pub fn displacement(&self, time: f64) -> f64 {
        let x = -self.speed * time;
        self.waves.at(x).re
    }

    /// Velocity ∂u/∂t [m/s per N] at `count` times from `first` on, every `step` [s].
    ///
    /// Accuracy: 1e-10 of what all waves together could make.
    pub fn velocities(&self, first: f64, step: f64, count: usize) -> Vec<f64> {
        // ∂/∂t = −v ∂/∂x′; time runs against x′
        let moving = self.waves.times(|beta| -I * beta * self.speed);
        let last = first + step * (count.max(1) - 1) as f64;
        let mut velocities = moving.shape(-self.speed * last, self.speed * step, count);
        velocities.reverse();
        velocities
    }

    /// The history of all `axles`, whose leading one is abreast at t = 0.
    pub fn of_train(&self, axles: &[Axle]) -> Self {
        let lead = axles.first().map_or(0.0, |a| a.position);
        // axle i is where the leading one was: e^{iβ(x′ + a_i)}
        let train = |beta: f64| -> Complex64 {
            axles.iter().map(|a| a.load * Complex64::cis(beta * (a.position - lead))).sum()
        };
        Self { waves: self.waves.times(train), ..self.clone() }
    }
}

impl MovingSpectrum<'_> {
    /// This load passing a `channel`, `ground` with its exact solver under the track's `strip`; for
    /// times up to `reach` [m] over its speed, which is above zero.
    ///
    /// Accuracy: 1e-3 of the largest velocity of the contour (test `cross_solver::passage`).
    ///
    /// # Errors
    /// A ground that cannot answer; a response that diverges.
    pub fn passage(
        &self,
        ground: (&Profile, Solver),
        strip: Strip,
        channel: Channel,
        reach: f64,
    ) -> Result<Passage, InteractionError> {
        let Channel { y, motion } = channel;
        let speed = self.speed;
        let (profile, solver) = ground;
        let slowest = profile.slowest_rayleigh_speed();
        // waves of the slowest material decay like e^{−√(1 − v²/c²)βy}; faster loads reach as far as the track lets them
        let evanescent = (1.0 - (speed / slowest).powi(2)).max(0.0).sqrt() * (y - strip.half_width);
        let beta_max = ((1.0 / ACCURACY).ln() + 3.0) / evanescent.max(1e-9);
        let beta_max = beta_max.min(self.force_extent());
        let relative = |beta: f64| (0.3 * ACCURACY * (beta * evanescent).exp()).min(0.1);
        let worst = Cell::new(self.worst());
        let response = |beta: f64| -> Result<Complex64, FoundationError> {
            let ground = solver.prepare(profile, -beta * speed, &[])?;
            let wanted = relative(beta);
            let estimate = ground.beside(beta, strip.half_width, y, motion, wanted);
            worst.set(worst.get().max(estimate.miss(10.0 * wanted)));
            Ok(estimate.value)
        };
        // in ln β, where layers and waves have even widths; errors count against what is felt near the layers' wavenumbers
        let size = response(0.3 * beta_max.min(1.0))?.norm();
        let ends: Vec<f64> =
            [BETA_MIN, 1e-3, 0.03, 0.3, 3.0].iter().copied().filter(|b| *b < 0.9 * beta_max).collect();
        let ends: Vec<f64> = ends.into_iter().chain([beta_max]).map(f64::ln).collect();
        let responses = |nodes: &[f64; NODES]| -> Result<_, FoundationError> {
            let mut values = [Complex64::ZERO; NODES];
            for (x, value) in nodes.iter().zip(&mut values) {
                *value = response(x.exp())?;
            }
            Ok(values)
        };
        let allowed = |_, value: Complex64| ACCURACY * size.max(value.norm());
        let table = Interpolant::bounded(responses, &ends, allowed, || true)?;
        let mut integrand = |beta: f64| self.force(beta) * table.at(beta.max(BETA_MIN).ln());
        let points = panels(beta_max, reach);
        let mut integral = Adaptive::new();
        integral.add(&mut integrand, &points);
        let tolerance = Tolerance { relative: ACCURACY, absolute: 0.0, max_count: 200_000 };
        let estimate = integral.refine(&mut integrand, Complex64::ZERO, tolerance);
        Ok(Passage {
            speed,
            waves: Waves::new(&integral.into_rule(), 1.0 / PI, |_, u| u),
            worst: worst.get().max(table.worst).max(estimate.miss(ACCURACY)),
        })
    }
}
