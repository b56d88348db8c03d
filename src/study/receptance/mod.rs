//! How much do rail and ground move under a standing harmonic load?

mod map;
mod map_shown;
mod shown;

pub use map::{ReceptanceMap, Surface};

use super::{Beside, Outcome, StudyError, known};
use crate::progress::Observer;
use crate::rail::{Answer as RailAnswer, Landmark, Method};
use crate::railway::{Railway, RailwayError};
use crate::track::{Layout, Supports};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Accuracy of G for receivers.
const GROUND_ACCURACY: f64 = 1e-5;
/// Wavenumbers thin layers must resolve [rad/m]: what is shorter than the track's width does not reach receivers.
const K_MAX: f64 = 100.0;

/// Accuracy of the rail that is no concern, relative to its answer under the force.
const RAIL_ACCURACY: f64 = 1e-4;

/// Receptance of the rail and of the ground beside the track.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Receptance {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// Where the force stands [m], from a support, or from the first change of section.
    pub from: f64,
    /// Where the rail answers [m], from the same; None: under the force alone.
    pub x: Option<Vec<f64>>,
    /// How the rail is asked; by default the best for its track.
    pub method: Option<Method>,
    /// Another way, to be compared.
    pub verify: Option<Method>,
    /// Distances from the centre line of the track [m]; may be empty.
    pub receivers: Vec<f64>,
    /// The surface around the force, if wanted.
    pub map: Option<ReceptanceMap>,
    /// Moduli [m/N] over frequency to compare with.
    pub beside: Vec<Beside>,
}

/// Displacements per unit force e^{iωt} on the rail, positive down.
#[derive(Clone, Debug)]
pub struct Receptances {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// Where the force stands [m].
    pub from: f64,
    /// Where the rail answers [m]; None: under the force alone.
    pub x: Option<Vec<f64>>,
    /// Distances from the centre line of the track [m].
    pub receivers: Vec<f64>,
    /// Of the rail [m/N], frequencies × x.
    pub rail: Array2<Complex64>,
    /// Of the ground abreast of the force [m/N], receivers × frequencies.
    pub ground: Array2<Complex64>,
    /// Frequencies [Hz] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
    /// Of the surface around the force.
    pub map: Option<Surface>,
    /// How the rail was asked.
    pub method: Method,
    /// Frequencies of the track without loss that explain the curve.
    pub landmarks: Vec<(Landmark, f64)>,
    /// The rail on supports of its own.
    pub on_supports: Option<Supports>,
}

/// Rail at every x, every receiver, error over what was allowed.
type Row = (Vec<Complex64>, Vec<Complex64>, f64);

impl Receptance {
    /// What `railway` lacks for an answer.
    pub(super) fn lacks(&self, railway: &Railway) -> Option<RailwayError> {
        // the ground beside the track is that of continuous ones
        let beside = !self.receivers.is_empty() || self.map.is_some();
        let track = if beside { railway.track().err() } else { None };
        track.or(known(railway, self.method, self.verify).err())
    }

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
    /// Accuracy: 2.3e-4 of the rail on layered ground and 2.3e-5 of the ground itself (test `cross_solver::receptance`); on springs that
    /// of the method.
    ///
    /// # Errors
    /// No track, receivers or a map without layered ground, undamped waves, a method that does not know the track.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<Receptances, StudyError> {
        let method = railway.method(self.method)?;
        let rail = railway.receptance(method)?;
        let x = self.x.clone().unwrap_or_else(|| vec![self.from]);
        observer.begin("receptance", self.frequencies.len() as u64);
        let rows: Vec<Row> = self
            .frequencies
            .par_iter()
            .map(|frequency| {
                let omega = TAU * frequency;
                let answers = rail.at(&x, self.from, omega)?;
                let (ground, ground_missed) = self.beside(railway, omega)?;
                observer.done()?;
                Ok((answers.iter().map(|a| a.value).collect(), ground, missed(&answers).max(ground_missed)))
            })
            .collect::<Result<_, StudyError>>()?;
        observer.end();
        let shape = (self.receivers.len(), self.frequencies.len());
        let worst = self.frequencies.iter().zip(&rows).map(|(f, row)| (*f, row.2));
        Ok(Receptances {
            frequencies: self.frequencies.clone(),
            from: self.from,
            x: self.x.clone(),
            receivers: self.receivers.clone(),
            rail: Array2::from_shape_fn((rows.len(), x.len()), |(f, i)| rows[f].0[i]),
            ground: Array2::from_shape_fn(shape, |(r, f)| rows[f].1[r]),
            missed: worst.filter(|(_, factor)| *factor > 1.0).collect(),
            map: self.map.as_ref().map(|map| map.solve(railway, observer)).transpose()?,
            method,
            on_supports: match railway.layout() {
                Layout::Discrete(supports) => Some(supports.clone()),
                _ => None,
            },
            landmarks: railway.landmarks(self.frequencies.last().copied().unwrap_or_default()),
        })
    }

    /// The ground at the receivers, and its error over what was allowed.
    fn beside(&self, railway: &Railway, omega: f64) -> Result<(Vec<Complex64>, f64), StudyError> {
        if self.receivers.is_empty() {
            return Ok((Vec::new(), 0.0));
        }
        let ground = railway.ground()?;
        let prepared = ground.solver.prepare_many(&ground.profile, omega, K_MAX, GROUND_ACCURACY)?;
        Ok(railway.track()?.ground(omega, prepared.as_ref(), ground.strip()?, &self.receivers)?)
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown(&self.beside))
    }
}

/// Error of the worst of `answers` over what is no concern.
fn missed(answers: &[RailAnswer]) -> f64 {
    let largest = answers.iter().map(|a| a.value.norm()).fold(0.0, f64::max);
    answers.iter().map(|a| a.error / (RAIL_ACCURACY * largest)).fold(0.0, f64::max)
}
