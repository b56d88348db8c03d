//! Forces of wheels on a rough rail for any wavelength of it, from a table of the rail's receptances.

use super::{InteractionError, WheelRail};
use crate::math::interpolation::cubic_weights;
use crate::progress::Observer;
use nalgebra::DMatrix;
use num_complex::Complex64;
use rayon::prelude::*;

/// Driving frequencies at which the rail is asked, per factor e.
const PER_UNIT: f64 = 20.0;

/// α of all wheels against ln ω̃, and what stands on them.
pub struct ContactForces<'a> {
    wheels: &'a WheelRail<'a>,
    /// ln Ω of the first entry but one, and the step.
    low: f64,
    step: f64,
    table: Vec<DMatrix<Complex64>>,
    /// False where a receptance missed its accuracy.
    pub converged: bool,
}

impl<'a> ContactForces<'a> {
    /// For wavenumbers Ω between `range` (lowest, highest) [rad/m], both above zero.
    ///
    /// Accuracy: 2 % of the force near the resonance of the wheel on the track, 0.4 % elsewhere (test
    /// `cross_solver::free_field::forces_of_the_study`).
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn new(
        wheels: &'a WheelRail<'a>,
        range: (f64, f64),
        observer: &dyn Observer,
    ) -> Result<Self, InteractionError> {
        let (low, high) = (range.0.ln(), range.1.ln());
        // α is smooth in ln ω̃; one point more on either side for the cubic
        let count = ((high - low) * PER_UNIT).ceil().max(1.0) as usize + 1;
        let step = ((high - low) / (count - 1) as f64).max(1e-3);
        observer.begin("contact forces", count as u64 + 2);
        let table: Vec<(DMatrix<Complex64>, bool)> = (0..count + 2)
            .into_par_iter()
            .map(|i| {
                let answer = wheels.rail((low + step * (i as f64 - 1.0)).exp() * wheels.speed);
                observer.advance();
                answer
            })
            .collect::<Result<_, _>>()?;
        observer.end();
        let converged = table.iter().all(|t| t.1);
        Ok(Self { wheels, low, step, table: table.into_iter().map(|t| t.0).collect(), converged })
    }

    /// p_i = P_i e^{iΩa_i} [N per metre of a profile e^{iΩx}], Ω = `wavenumber` [rad/m] within the range: each force against the
    /// profile under its own wheel, so that p is smooth in Ω, however long the train.
    pub fn at(&self, wavenumber: f64) -> Vec<Complex64> {
        let place = (wavenumber.ln() - self.low) / self.step;
        let i = (place.floor().max(0.0) as usize).min(self.table.len() - 4);
        let weights = cubic_weights(place - i as f64);
        let mut alpha = &self.table[i] * Complex64::from(weights[0]);
        for (m, weight) in weights.iter().enumerate().skip(1) {
            alpha += &self.table[i + m] * Complex64::from(*weight);
        }
        let forces = self.wheels.forces(&alpha, wavenumber * self.wheels.speed);
        let axles = self.wheels.bodies.axles();
        forces.iter().zip(axles).map(|(p, a)| p * Complex64::cis(wavenumber * a.position)).collect()
    }
}
