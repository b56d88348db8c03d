//! k_eq(β, ω) as a table for researchers.

mod shown;

use super::doubts::deep_rock;
use super::{Outcome, StudyError};
use crate::foundation::{Foundation, Stiffness};
use crate::progress::Observer;
use crate::railway::Railway;
use ndarray::Array2;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Wavenumbers and frequencies of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct EquivalentStiffness {
    /// β [rad/m], above zero.
    pub beta: Vec<f64>,
    /// f [Hz]
    pub frequencies: Vec<f64>,
}

/// k_eq with its estimated error.
#[derive(Clone, Debug)]
pub struct StiffnessTable {
    /// β [rad/m]
    pub beta: Vec<f64>,
    /// ω [rad/s]
    pub omega: Vec<f64>,
    /// [N/m²], ω × β.
    pub k_eq: Array2<Stiffness>,
}

impl EquivalentStiffness {
    /// k_eq (omega, beta) with its estimated error.
    ///
    /// Accuracy: 5e-10 of 192 nine-digit values (test `cross_solver::k_eq`).
    ///
    /// # Errors
    /// Undamped ground where waves exist.
    pub fn solve(
        &self,
        foundation: &dyn Foundation,
        observer: &dyn Observer,
    ) -> Result<StiffnessTable, StudyError> {
        let omega: Vec<f64> = self.frequencies.iter().map(|f| TAU * f).collect();
        let shape = (omega.len(), self.beta.len());
        observer.begin("equivalent stiffness", (shape.0 * shape.1) as u64);
        let values = (0..shape.0 * shape.1)
            .into_par_iter()
            .map(|n| {
                let stiffness = foundation.stiffness(self.beta[n % shape.1], omega[n / shape.1])?;
                observer.done()?;
                Ok(stiffness)
            })
            .collect::<Result<Vec<_>, StudyError>>()?;
        observer.end();
        let k_eq = Array2::from_shape_fn(shape, |(i, j)| values[i * shape.1 + j]);
        Ok(StiffnessTable { beta: self.beta.clone(), omega, k_eq })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`; ground that nothing loads, or points, has no foundation.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let mut outcome = self.solve(railway.foundation()?, observer)?.shown();
        outcome
            .concerns
            .extend(railway.ground().ok().and_then(|ground| deep_rock(&ground.profile, &self.frequencies)));
        Ok(outcome)
    }
}
