//! The ground's surface around a standing harmonic load: part of the receptance.

use super::{GROUND_ACCURACY, K_MAX};
use crate::field::{StandingField, Window};
use crate::progress::Observer;
use crate::railway::{Ground, Railway};
use crate::study::StudyError;
use crate::study::contour::check_memory;
use std::f64::consts::TAU;

/// Maps of the ground's surface around the force.
#[derive(Clone, Debug, PartialEq)]
pub struct ReceptanceMap {
    /// f [Hz], above zero, ascending: a map each.
    pub frequencies: Vec<f64>,
    /// Where: x along the track from the force, y across it from its centre line.
    pub window: Window,
}

/// The ground's surface around the force.
#[derive(Clone, Debug)]
pub struct Surface {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// Along the track from the force [m].
    pub x: Vec<f64>,
    /// Across the track from its centre line [m].
    pub y: Vec<f64>,
    /// u_z(y, x) per unit force, a field for each frequency.
    pub fields: Vec<StandingField>,
}

impl ReceptanceMap {
    /// Refuses maps beyond the free memory.
    ///
    /// # Errors
    /// No ground, too large a map.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        railway.ground()?;
        let Window { x, y, spacing } = self.window;
        let count = |side: (f64, f64)| (side.1 - side.0) / spacing + 1.0;
        // the field, its parts and its pictures: eight numbers each
        let needed = 64.0 * count(x) * count(y) * self.frequencies.len() as f64;
        // a conversion from f64 stops at the largest whole number
        check_memory("receptance map", (count(x) as usize, count(y) as usize), needed as u64)
    }

    /// u_z(x, y) [m/N] of every frequency, positive down.
    ///
    /// Accuracy: 1e-4 of the largest value (test `cross_solver::standing_field`); the fields estimate it for the case at hand.
    ///
    /// # Errors
    /// No track, no ground, undamped waves.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<Surface, StudyError> {
        let track = railway.track()?;
        let ground = railway.ground()?;
        let (Ground { profile, solver, .. }, strip) = (ground, ground.strip()?);
        let (x, y) = (self.window.x_positions(), self.window.y_positions());
        observer.begin("receptance maps", self.frequencies.len() as u64);
        let fields = self
            .frequencies
            .iter()
            .map(|frequency| {
                let omega = TAU * frequency;
                let prepared = solver.prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)?;
                let field = track.standing_field(omega, prepared.as_ref(), strip, (&x, &y))?;
                observer.done()?;
                Ok(field)
            })
            .collect::<Result<Vec<StandingField>, StudyError>>()?;
        observer.end();
        Ok(Surface { frequencies: self.frequencies.clone(), x, y, fields })
    }
}
