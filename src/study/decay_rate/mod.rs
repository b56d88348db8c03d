//! How fast does vibration die away along the rail?

mod shown;

use super::{Beside, Outcome, StudyError, known};
use crate::progress::Observer;
use crate::rail::{DecayRate as Definition, Landmark, Method, decay_rate};
use crate::railway::{Railway, RailwayError};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Bays of a track without supports, for the grid of EN 15461 [m].
const SPACING: f64 = 0.6;

/// Track decay rates over frequency.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DecayRate {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// Which decay rate.
    pub definition: Definition,
    /// Where the force stands [m] from a support; by default in the middle of a bay, as EN 15461 has it. The free wave does not ask.
    pub from: Option<f64>,
    /// How the rail is asked for its receptances; by default the best for its track.
    pub rail: Option<Method>,
    /// Another way, to be compared.
    pub verify: Option<Method>,
    /// Rates [dB/m] over frequency to compare with.
    pub beside: Vec<Beside>,
}

/// Track decay rates.
#[derive(Clone, Debug, PartialEq)]
pub struct DecayRates {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// Δ [dB/m]
    pub decay: Vec<f64>,
    /// Which decay rate.
    pub definition: Definition,
    /// How the rail was asked.
    pub rail: Method,
    /// Frequencies of the track without loss that explain the curve.
    pub landmarks: Vec<(Landmark, f64)>,
    /// Ranges [Hz] in which no wave travels without loss.
    pub stop_bands: Vec<(f64, f64)>,
}

impl DecayRate {
    /// What `railway` lacks for an answer.
    pub(super) fn lacks(&self, railway: &Railway) -> Option<RailwayError> {
        let known = known(railway, self.rail, self.verify).err();
        let omega = self.frequencies.first().map_or(TAU, |frequency| TAU * frequency);
        // not every method that knows the rail knows its free waves
        let free = |method| railway.free_decay(method, omega).err();
        let second = || self.verify.and_then(|second| free(Some(second)));
        match self.definition {
            Definition::Floquet => known.or_else(|| free(self.rail)).or_else(second),
            _ => known,
        }
    }

    /// Δ [dB/m] at every frequency.
    ///
    /// Accuracy: that of the receptances; of the free wave rounding (tests `analytic::periodic::decay_rates_as_measured`, `analytic::continuous`).
    ///
    /// # Errors
    /// No track; ground that joins the supports where the free wave is asked for, sections, a method that does not know the track.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<DecayRates, StudyError> {
        let method = railway.method(self.rail)?;
        let rail = railway.receptance(method)?;
        let spacing = rail.period().filter(|period| *period > 0.0).unwrap_or(SPACING);
        let from = self.from.unwrap_or(0.5 * spacing);
        observer.begin("decay rate", self.frequencies.len() as u64);
        let rate = |frequency: &f64| -> Result<f64, StudyError> {
            let omega = TAU * frequency;
            let rate = match self.definition {
                Definition::Floquet => railway.free_decay(self.rail, omega)?,
                Definition::ExactReceptance => decay_rate::exact(rail.as_ref(), spacing, from, omega)?,
                Definition::En15461 => decay_rate::en15461(rail.as_ref(), spacing, from, omega)?,
            };
            observer.done()?;
            Ok(rate)
        };
        let decay = self.frequencies.par_iter().map(rate).collect::<Result<_, _>>()?;
        observer.end();
        let highest = self.frequencies.last().copied().unwrap_or_default();
        Ok(DecayRates {
            frequencies: self.frequencies.clone(),
            decay,
            definition: self.definition,
            rail: method,
            landmarks: railway.landmarks(highest),
            stop_bands: railway.stop_bands(highest),
        })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown(&self.beside))
    }
}
