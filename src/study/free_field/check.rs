//! The quasi-static part is known twice: its bands from h along β = ω/v, its history from an integral over β. They must agree.

use super::{Answered, StudyError};
use crate::assessment::rms;
use crate::concern::Concern;
use crate::signal::{EnergySpectrum, History};
use std::f64::consts::PI;

/// Difference of both r.m.s. velocities that is too much, beside what leaks where the history is cut off: relative, measured 7.5e-4
/// on axles at 17 to 67 m/s and receivers at 4 to 20 m (eight ICE 3: 1.3e-2 at 16 m; beyond, the leak decides), and as a share of the peak, to 1e-3 of which a history is known.
const APART: f64 = 0.03;
const OF_PEAK: f64 = 3e-3;

/// Whether r.m.s. velocities of the bands and of the history between the same frequencies, of which `leak` is the cut's, may be one.
/// NaN agrees with nothing.
fn agree(bands: f64, history: f64, leak: f64, peak: f64) -> bool {
    (bands - history).abs() <= APART * history + leak + OF_PEAK * peak
}

impl Answered<'_> {
    /// Receivers whose quasi-static bands contradict the history.
    ///
    /// # Errors
    /// Velocities that are not numbers; a passage time that is not positive.
    pub(super) fn contradictions(&self) -> Result<Vec<Concern>, StudyError> {
        let (study, time) = (self.pass.study, self.pass.passage_time);
        let (Some(first), Some(last)) = (study.bands.first(), study.bands.last()) else {
            return Ok(Vec::new());
        };
        let mut concerns = Vec::new();
        for (r, y) in study.receivers.iter().enumerate() {
            let history = History::new(self.times.step, self.quasi_static.velocity.row(r).to_vec())?;
            let heard = EnergySpectrum::of(&history).between(first.lower(), last.upper())?;
            let bands = rms(self.energies.quasi_static.row(r).sum(), time)?;
            let heard = rms(heard, time)?;
            // energy that the history does not hold at all
            let most = rms(history.energy(), time)?;
            // a step J at an end has the density 2 (J/2πf)² [unit² s/Hz]
            let ends = [history.values().first(), history.values().last()];
            let steps: f64 = ends.iter().flatten().map(|v| v.powi(2)).sum();
            let leak = rms(steps / (2.0 * PI * PI * first.lower()), time)?;
            if !agree(bands, heard, leak, history.peak()) {
                concerns.push(Concern::new(
                    "quasi-static-bands",
                    format!(
                        "at {y} m the bands of the moving axle loads hold {bands:.2e} m/s (r.m.s. over {time:.2} s), their history {heard:.2e} m/s \
                         between the same frequencies, {most:.2e} m/s in all (peak {:.2e} m/s): one of them is wrong",
                        history.peak()
                    ),
                    "do not use this result; try free_field.sections or another soil.solver, and report the case",
                ));
            }
        }
        Ok(concerns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_that_the_history_does_not_hold_are_told() {
        // an axle of 80 kN at 60 km/h, 8 m away: right on a layer and on a half-space; with cubics through logarithms of rounding
        assert!(agree(2.3986e-6, 2.3999e-6, 2.8e-8, 1.17e-5) && agree(5.2005e-6, 5.2030e-6, 5.5e-8, 2.32e-5));
        for (bands, history, peak) in [(3.6e5, 2.3999e-6, 1.17e-5), (8.9e-6, 5.203e-6, 2.32e-5)] {
            assert!(!agree(bands, history, 5.5e-8, peak));
        }
        assert!(!agree(f64::NAN, 1e-6, 0.0, 1e-5));
        // 32 m away nothing of it lies above 1 Hz, and the history's end leaks
        assert!(agree(1.0e-10, 1.29e-8, 1.30e-8, 7.37e-7));
    }
}
