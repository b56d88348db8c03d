//! G(k, ω) of the surface as a table for researchers.

mod shown;

use super::doubts::deep_rock;
use super::{Outcome, StudyError};
use crate::progress::Observer;
use crate::railway::Ground;
use crate::soil::{GroundSolver, SurfaceCompliance};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Wavenumbers and frequencies of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceComplianceTable {
    /// k [rad/m], not negative; 0 is vertical incidence: the compliance of a column, u_zz of P, u_xx and u_yy of S waves.
    pub k: Vec<f64>,
    /// f [Hz]
    pub frequencies: Vec<f64>,
}

/// The compliances of a ground's surface.
#[derive(Clone, Debug)]
pub struct Compliances {
    /// k [rad/m]
    pub k: Vec<f64>,
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// G(k, ω) [m/Pa]: for each frequency those of all k.
    pub rows: Vec<Vec<SurfaceCompliance>>,
}

impl SurfaceComplianceTable {
    /// u_zz, u_xx, u_xz, u_yy (frequency, k).
    ///
    /// Accuracy: that of the solver (test `cross_solver::surface_compliance`).
    ///
    /// # Errors
    /// A ground that cannot answer.
    pub fn solve(&self, ground: &Ground, observer: &dyn Observer) -> Result<Compliances, StudyError> {
        let Ground { profile, solver, .. } = ground;
        observer.begin("surface compliance", self.frequencies.len() as u64);
        let rows = self
            .frequencies
            .par_iter()
            .map(|f| {
                let row = solver.prepare(profile, TAU * f, &[])?.batch(&self.k);
                observer.done()?;
                Ok(row)
            })
            .collect::<Result<Vec<_>, StudyError>>()?;
        observer.end();
        Ok(Compliances { k: self.k.clone(), frequencies: self.frequencies.clone(), rows })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, ground: &Ground, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let mut outcome = self.solve(ground, observer)?.shown();
        outcome.concerns.extend(deep_rock(&ground.profile, &self.frequencies));
        Ok(outcome)
    }
}
