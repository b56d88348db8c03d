//! What is a measured history of a passage to people and to standards?
//!
//! The same measures as of a computed free field, of the velocity in up to three directions.

mod read;
mod shown;

pub use read::RecordError;

use super::free_field::metrics::{Direction, measures};
use super::{Assessment, Outcome, StudyError};
use crate::assessment::{
    Band, PassageSpectrum, WorkingRange, foundation_guide_values, kb_f, passage_spectrum,
};
use crate::signal::{EnergySpectrum, History};

/// One direction of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of its column, less the unit.
    pub name: String,
    /// Vertical, or horizontal.
    pub direction: Direction,
    /// v(t) [m/s], less its mean.
    pub velocity: History,
}

/// A measured history.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredHistory {
    /// Time of the first sample [s].
    pub first: f64,
    /// Its directions, in the order of the columns.
    pub channels: Vec<Channel>,
    /// Whether velocities were integrated from accelerations.
    pub integrated: bool,
    /// What it is held against.
    pub assessment: Assessment,
}

/// What one direction comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// One for each of the measures.
    pub measures: Vec<f64>,
    /// KB_F(t)
    pub kb_f: History,
    /// Third octaves.
    pub spectrum: PassageSpectrum,
    /// Frequency at which the velocity from 1 to 315 Hz has most energy [Hz].
    pub dominant: f64,
}

impl MeasuredHistory {
    /// Third octaves from 1 Hz to a third of the sampling rate at most, and to 315 Hz.
    fn bands(&self) -> Result<Vec<Band>, StudyError> {
        let rate = 1.0 / self.channels[0].velocity.step();
        Ok(Band::range(1.0, (rate / 3.0).clamp(1.0, 315.0))?)
    }

    /// The measures of every direction.
    ///
    /// # Errors
    /// None for a record that was read.
    pub fn solve(&self) -> Result<Vec<Judged>, StudyError> {
        let bands = self.bands()?;
        let judged = self.channels.iter().map(|channel| {
            let Channel { velocity, direction, .. } = channel;
            Judged {
                measures: measures(velocity, *direction),
                kb_f: kb_f(velocity),
                spectrum: passage_spectrum(velocity, &bands),
                dominant: dominant(&WorkingRange::To315.of(velocity)),
            }
        });
        Ok(judged.collect())
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self) -> Result<Outcome, StudyError> {
        let (judged, bands) = (self.solve()?, self.bands()?);
        Ok(Outcome {
            group: self.group(&judged, &bands),
            figures: self.figures(&judged, &bands),
            answers: self.answers(&judged),
            concerns: self.concerns(),
        })
    }
}

/// The frequency with the largest energy density [Hz].
fn dominant(velocity: &History) -> f64 {
    let spectrum = EnergySpectrum::of(velocity);
    let most = (0..spectrum.density().len())
        .max_by(|&a, &b| spectrum.density()[a].total_cmp(&spectrum.density()[b]));
    most.map_or(0.0, |i| spectrum.frequencies()[i])
}

/// Guide values [m/s] at the frequency of the direction that comes closest to them, and its peak; of three directions at a foundation.
fn closest(peaks: &[(f64, f64)]) -> Option<(usize, [f64; 3])> {
    let of = |&(peak, frequency): &(f64, f64)| (peak, foundation_guide_values(frequency));
    let near = |i: &usize| {
        let (peak, guide) = of(&peaks[*i]);
        peak / guide[1]
    };
    let worst = (0..peaks.len()).max_by(|a, b| near(a).total_cmp(&near(b)))?;
    Some((worst, of(&peaks[worst]).1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::free_field::metrics::{KB_F_MAXIMUM, PEAK_VELOCITY};

    /// Ten seconds of 16 Hz under a bell of 1 mm/s in `v_x` and 2 mm/s in `v_z`.
    fn record() -> MeasuredHistory {
        let text = (0..5000).fold("t [s], v_x [mm/s], v_z [mm/s]\n".to_owned(), |text, i| {
            let t = 0.002 * f64::from(i);
            let v = (-(t - 5.0f64).powi(2)).exp() * (100.53 * t).sin();
            text + &format!("{t:.3}, {v:.6}, {:.6}\n", 2.0 * v)
        });
        MeasuredHistory::parse(&text, Assessment::default()).unwrap()
    }

    #[test]
    fn measures_are_those_of_the_histories() {
        let record = record();
        let [x, z] = &record.solve().unwrap()[..] else { panic!("two directions") };
        // the peak of the bell and a sample of 16 Hz beside it: 1 and 2 mm/s to 1 %
        assert!((x.measures[PEAK_VELOCITY] / 1e-3 - 1.0).abs() < 0.01);
        // twice the velocity, twice the measure, to the six digits of the file
        assert!((z.measures[KB_F_MAXIMUM] / x.measures[KB_F_MAXIMUM] - 2.0).abs() < 1e-4);
        // KB_F of a settled sine of 1 mm/s at 16 Hz has a mean of 0.667, and ripples up to √(1 + 1/√(1 + (4π 16 · 0.125)²)) = 1.02 of it;
        // under the bell a little less; measured 0.6705
        assert!((0.6..0.680).contains(&x.measures[KB_F_MAXIMUM]), "{}", x.measures[KB_F_MAXIMUM]);
        assert!((z.dominant - 16.0).abs() < 0.1, "{}", z.dominant);
        // at 16 Hz dwellings have 5 + 6/40 · 10 = 6.5 mm/s
        let (worst, guide) = closest(&[(1e-3, 16.0), (2e-3, 16.0)]).unwrap();
        assert!(worst == 1 && (guide[1] - 6.5e-3).abs() < 1e-12);
    }

    #[test]
    fn everything_is_shown() {
        let outcome = record().run().unwrap();
        assert!(outcome.answers.iter().any(|a| a.key == "kb_f_maximum_v_z"));
        assert!(outcome.answers.iter().any(|a| a.key == "peak_velocity_of_directions"));
        assert_eq!(outcome.figures.len(), 5);
        assert!(outcome.concerns.iter().any(|c| c.code == "directions"));
        assert!(outcome.group.get("v_max_hold").is_some());
    }
}
