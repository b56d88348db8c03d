//! How much do rail and ground move under a standing harmonic load?

mod map;
mod map_shown;
mod shown;

pub use map::{ReceptanceMap, Surface};

use super::{Outcome, StudyError};
use crate::progress::Observer;
use crate::railway::{Ground, Railway};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Accuracy of G for receivers.
const GROUND_ACCURACY: f64 = 1e-5;
/// Wavenumbers thin layers must resolve [rad/m]: what is shorter than the track's width does not reach receivers.
const K_MAX: f64 = 100.0;

/// Receptance of the rail and of the ground beside the track.
#[derive(Clone, Debug, PartialEq)]
pub struct Receptance {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// Distances from the centre line of the track [m]; may be empty.
    pub receivers: Vec<f64>,
    /// The surface around the force, if wanted.
    pub map: Option<ReceptanceMap>,
}

/// Displacements per unit force e^{iωt} on the rail, positive down.
#[derive(Clone, Debug)]
pub struct Receptances {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// Distances from the centre line of the track [m].
    pub receivers: Vec<f64>,
    /// Of the rail under the force [m/N].
    pub rail: Vec<Complex64>,
    /// Of the ground abreast of the force [m/N], receivers × frequencies.
    pub ground: Array2<Complex64>,
    /// Frequencies [Hz] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
    /// Of the surface around the force.
    pub map: Option<Surface>,
}

/// Rail, every receiver, error over what was allowed.
type Row = (Complex64, Vec<Complex64>, f64);

impl Receptance {
    /// Refuses receivers on the track and maps beyond the free memory.
    ///
    /// # Errors
    /// Either, and receivers or a map without layered ground.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        if !self.receivers.is_empty() {
            railway.check_receivers(&self.receivers)?;
        }
        self.map.as_ref().map_or(Ok(()), |map| map.check(railway))
    }

    /// Displacements of rail and ground per unit force e^{iωt} on the rail [m/N], positive down.
    ///
    /// Accuracy: 2.3e-4 of the rail, 2.3e-5 of the ground (test `cross_solver::receptance`).
    ///
    /// # Errors
    /// No track, receivers or a map without layered ground, undamped waves.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<Receptances, StudyError> {
        let track = railway.track()?;
        let ground = if self.receivers.is_empty() { None } else { Some(railway.ground()?) };
        observer.begin("receptance", self.frequencies.len() as u64);
        let rows: Vec<Row> = self
            .frequencies
            .par_iter()
            .map(|frequency| {
                let omega = TAU * frequency;
                let load = track.harmonic(omega, 0.0, 0.0)?;
                let (receivers, worst) = match ground {
                    Some(ground) => {
                        let Ground { profile, solver, .. } = ground;
                        let prepared = solver.prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)?;
                        track.ground(omega, prepared.as_ref(), ground.strip()?, &self.receivers)?
                    }
                    None => (Vec::new(), 0.0),
                };
                observer.advance();
                Ok((load.rail(0.0), receivers, load.worst.max(worst)))
            })
            .collect::<Result<_, StudyError>>()?;
        observer.end();
        let shape = (self.receivers.len(), self.frequencies.len());
        let missed = self.frequencies.iter().zip(&rows).map(|(f, row)| (*f, row.2));
        Ok(Receptances {
            frequencies: self.frequencies.clone(),
            receivers: self.receivers.clone(),
            rail: rows.iter().map(|row| row.0).collect(),
            ground: Array2::from_shape_fn(shape, |(r, f)| rows[f].1[r]),
            missed: missed.filter(|(_, worst)| *worst > 1.0).collect(),
            map: self.map.as_ref().map(|map| map.solve(railway, observer)).transpose()?,
        })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown())
    }
}
