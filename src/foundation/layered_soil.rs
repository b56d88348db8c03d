//! Layered ground under a strip: k_eq(β, ω) of Eq. 80, corrected.

use super::{Foundation, FoundationError, Moving, Stiffness};
use crate::math::interpolation::Interpolant;
use crate::soil::{GroundSolver, PreparedGround, Profile, SoilError, Solver, Strip};
use num_complex::Complex64;
use std::cell::RefCell;

/// A profile loaded over a strip.
#[derive(Clone, Debug)]
pub struct LayeredSoil {
    profile: Profile,
    solver: Solver,
    strip: Strip,
}

impl LayeredSoil {
    /// `profile` under a `strip`.
    ///
    /// # Errors
    /// A half-width that is not finite and positive.
    pub fn new(profile: Profile, solver: Solver, strip: Strip) -> Result<Self, FoundationError> {
        let value = strip.half_width;
        if !(value.is_finite() && value > 0.0) {
            return Err(FoundationError::NotPositive { quantity: "contact half-width", value, unit: "m" });
        }
        Ok(Self { profile, solver, strip })
    }

    /// The ground.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The loaded strip.
    pub fn strip(&self) -> Strip {
        self.strip
    }

    /// The solver of the ground.
    pub fn solver(&self) -> Solver {
        self.solver
    }

    fn prepare(&self, omega: f64) -> Result<Box<dyn PreparedGround>, SoilError> {
        self.solver.prepare(&self.profile, omega, &[])
    }

    /// Refuses phase speeds at which undamped ground has a real pole.
    fn check(&self, phase_speed: f64) -> Result<(), FoundationError> {
        if !self.profile.is_undamped() {
            return Ok(());
        }
        let slowest = self.profile.slowest_rayleigh_speed();
        if phase_speed >= slowest {
            return Err(FoundationError::Undamped { phase_speed, slowest });
        }
        Ok(())
    }
}

impl Foundation for LayeredSoil {
    fn stiffness_to(&self, beta: f64, omega: f64, relative: f64) -> Result<Stiffness, FoundationError> {
        self.check(if omega == 0.0 { 0.0 } else { (omega / beta).abs() })?;
        let estimate = self.prepare(omega)?.strip(beta, self.strip, relative);
        Ok(Stiffness {
            value: 1.0 / estimate.value,
            relative_error: estimate.error / estimate.value.norm(),
            converged: estimate.converged,
        })
    }

    /// Interpolates 1/k_eq piecewise in ln β, on which wave and layer features have even widths; its logarithmic
    /// growth as β → 0 is nearly a straight line there.
    fn moving(
        &self,
        speed: f64,
        from: f64,
        to: f64,
        allowed: &dyn Fn(f64, Complex64) -> f64,
    ) -> Result<Moving<'_>, FoundationError> {
        self.check(speed.abs())?;
        let mut converged = true;
        // each integral as well as its neighbour needed it: a tenth of the error allowed there
        let mut relative = 1e-6;
        // the first ground that cannot answer; nothing is computed after it
        let failure: RefCell<Option<SoilError>> = RefCell::default();
        let compliance = |log_beta: f64| {
            let beta = log_beta.exp();
            if failure.borrow().is_some() {
                return Complex64::ONE;
            }
            let ground = match self.prepare(-beta * speed) {
                Ok(ground) => ground,
                Err(error) => {
                    failure.replace(Some(error));
                    return Complex64::ONE;
                }
            };
            let estimate = ground.strip(beta, self.strip, relative);
            converged &= estimate.converged;
            let bearable = allowed(beta, 1.0 / estimate.value) / estimate.value.norm();
            relative = (0.1 * bearable).clamp(1e-8, 1e-3);
            estimate.value
        };
        // four pieces to start with: static far field, layers, contact width, beyond
        let (low, high) = (from.ln(), to.ln());
        let mut points = vec![low];
        points
            .extend([0.01f64, 0.1, 1.0].iter().map(|b| b.ln()).filter(|b| *b > low + 0.5 && *b < high - 0.5));
        points.push(high);
        let interpolant = Interpolant::new(compliance, &points, |log_beta, value| {
            if failure.borrow().is_some() { f64::INFINITY } else { allowed(log_beta.exp(), 1.0 / value) }
        });
        if let Some(error) = failure.into_inner() {
            return Err(error.into());
        }
        converged &= interpolant.converged;
        let stiffness = move |beta: f64| -> Complex64 { 1.0 / interpolant.at(beta.ln()) };
        Ok(Moving { stiffness: Box::new(stiffness), converged })
    }
}
