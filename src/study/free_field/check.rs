//! The quasi-static part is known twice: its bands from h along β = ω/v, its history from an integral over β. They must agree.

use super::components::words;
use super::{PassVelocities, StudyError};
use crate::assessment::{Band, rms};
use crate::concern::Concern;
use crate::signal::{EnergySpectrum, History};
use ndarray::Array2;
use std::f64::consts::PI;

/// Difference of both r.m.s. velocities of a band that is too much, beside what leaks where the history is cut off: relative,
/// measured 3e-4 under two axles at 67 m/s 2 to 16 m away, 2e-2 at 64 m, and 2.7e-2 under eight ICE 3, whose lines are narrow; and as a
/// share of the peak, measured 1e-4.
const APART: f64 = 0.1;
const OF_PEAK: f64 = 1e-3;
/// The same for all bands together, whose lines and cuts average: relative, measured 7.5e-4 at 4 to 20 m, 1.3e-2 under eight ICE 3; and as
/// a share of the peak.
const APART_TOGETHER: f64 = 0.03;
const TOGETHER_OF_PEAK: f64 = 3e-3;
/// Share of the time before the train comes over which the history fades in, and out when it has gone.
const FADING: f64 = 0.5;

/// Whether r.m.s. velocities of the bands and of the history between the same frequencies, of which `leak` is the cut's, may be one.
/// NaN agrees with nothing.
fn agree(bands: f64, history: f64, leak: f64, peak: f64) -> bool {
    (bands - history).abs() <= APART * history + leak + OF_PEAK * peak
}

/// Whether all `bands` with their `energy` together are those of the `history`, r.m.s. over `time` [s]; both r.m.s.
fn together(
    history: &History,
    bands: &[Band],
    energy: f64,
    time: f64,
) -> Result<(bool, f64, f64), StudyError> {
    let (Some(first), Some(last)) = (bands.first(), bands.last()) else { return Ok((true, 0.0, 0.0)) };
    let heard = rms(EnergySpectrum::of(history).between(first.lower(), last.upper())?, time)?;
    let told = rms(energy, time)?;
    // a step J at an end has the density 2 (J/2πf)² [unit² s/Hz]
    let ends = [history.values().first(), history.values().last()];
    let steps: f64 = ends.iter().flatten().map(|v| v.powi(2)).sum();
    let leak = rms(steps / (2.0 * PI * PI * first.lower()), time)?;
    let bound = APART_TOGETHER * heard + leak + TOGETHER_OF_PEAK * history.peak();
    Ok(((told - heard).abs() <= bound, told, heard))
}

/// A history that is not cut off but fades over `ramp` [s] at both ends, and its largest value J there.
///
/// The tails of a load slower than the waves are smooth: what the ramp takes of them holds long waves alone. With half a cosine as
/// ramp the ends have no more than the density 2 (J/πf)²/((2fτ)² − 1)² [unit² s/Hz], J and τ of both; a cut (τ = 0) that of two steps.
struct Faded {
    spectrum: EnergySpectrum,
    peak: f64,
    end: f64,
    ramp: f64,
}

impl Faded {
    fn new(history: &History, ramp: f64) -> Result<Self, StudyError> {
        let mut values = history.values().to_vec();
        let samples = ((ramp / history.step()) as usize).min(values.len() / 2);
        let ends = samples.max(1).min(values.len());
        let end = values
            .iter()
            .take(ends)
            .chain(values.iter().rev().take(ends))
            .fold(0.0f64, |m, v| m.max(v.abs()));
        let last = values.len().saturating_sub(1);
        for i in 0..samples {
            let weight = 0.5 - 0.5 * (PI * (i as f64 + 0.5) / samples as f64).cos();
            values[i] *= weight;
            values[last - i] *= weight;
        }
        let spectrum = EnergySpectrum::of(&History::new(history.step(), values)?);
        Ok(Self { spectrum, peak: history.peak(), end, ramp })
    }

    /// Number of the first band whose energy of `energies` contradicts the history, r.m.s. over `time` [s]; its r.m.s. and the history's.
    fn contradicts(
        &self,
        bands: &[Band],
        energies: impl Iterator<Item = f64>,
        time: f64,
    ) -> Result<Option<(usize, f64, f64)>, StudyError> {
        for (b, (band, energy)) in bands.iter().zip(energies).enumerate() {
            let (lower, width) = (band.lower(), band.upper() - band.lower());
            let smooth = ((2.0 * lower * self.ramp).powi(2) - 1.0).max(1.0);
            let leak = rms(2.0 * width * (self.end / (PI * lower * smooth)).powi(2), time)?;
            let (told, heard) = (rms(energy, time)?, rms(self.spectrum.between(lower, band.upper())?, time)?);
            if !agree(told, heard, leak, self.peak) {
                return Ok(Some((b, told, heard)));
            }
        }
        Ok(None)
    }
}

impl PassVelocities<'_> {
    /// Receivers with a quasi-static band that contradicts the history.
    ///
    /// # Errors
    /// Velocities that are not numbers; a passage time that is not positive.
    pub(super) fn contradictions(&self) -> Result<Vec<Concern>, StudyError> {
        let (study, time) = (self.study, self.passage_time);
        let slowest = self.railway.ground()?.profile.slowest_rayleigh_speed();
        // waves of a fast load come late: they are left as they are
        let ramp = if study.speed < slowest { FADING * -self.times.first } else { 0.0 };
        let horizontal = self.three.iter().flat_map(|three| &three.horizontal).map(|h| &h.component);
        let components: Vec<(&Array2<f64>, &Array2<f64>, &str)> =
            std::iter::once((&self.quasi_static, &self.energies.quasi_static, "vertically"))
                .chain(horizontal.map(|c| (&c.quasi_static, &c.energies.quasi_static, words(c.motion).1)))
                .collect();
        let all = study.receivers.iter().enumerate();
        let all = all.flat_map(|receiver| components.iter().map(move |component| (receiver, component)));
        let mut concerns = Vec::new();
        for ((r, y), (history, energies, direction)) in all {
            let history = History::new(self.times.step, history.row(r).to_vec())?;
            let energies = energies.row(r);
            let wrong =
                Faded::new(&history, ramp)?.contradicts(&study.bands, energies.iter().copied(), time)?;
            let (whole, all_told, all_heard) = together(&history, &study.bands, energies.sum(), time)?;
            let which = match wrong {
                Some((b, told, heard)) => {
                    Some((format!("band at {} Hz", study.bands[b].label()), told, heard))
                }
                None if !whole => Some(("sum of all bands".to_owned(), all_told, all_heard)),
                None => None,
            };
            if let Some((which, told, heard)) = which {
                concerns.push(Concern::new(
                    "quasi-static-bands",
                    format!(
                        "at {y} m, {direction}, the {which} of the moving axle loads holds {told:.2e} m/s (r.m.s. over {time:.2} s), their history \
                         {heard:.2e} m/s between the same frequencies (peak {:.2e} m/s): one of them is wrong",
                        history.peak()
                    ),
                    "do not use this result; try another soil.solver, and report the case",
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

    #[test]
    fn bands_that_are_wrong_together_are_told() {
        // one axle like 8 m away at 67 m/s: 9 % in all bands is within the limit of each of them, not of their sum
        let (a, step) = (8.0 / 67.0, 1.0 / 320.0);
        let times = (-720..720).map(|i| step * f64::from(i));
        let history =
            History::new(step, times.map(|t| -2.0 * a * a * t / (a * a + t * t).powi(2)).collect()).unwrap();
        let bands = Band::range(1.0, 20.0).unwrap();
        let (from, to) = (bands[0].lower(), bands[bands.len() - 1].upper());
        let energy = EnergySpectrum::of(&history).between(from, to).unwrap();
        assert!(together(&history, &bands, energy, 4.5).unwrap().0);
        assert!(!together(&history, &bands, 1.09f64.powi(2) * energy, 4.5).unwrap().0);
    }

    /// u = a²/(a² + t²), whose velocity has the spectrum 2πf πa e^{−2πfa}: as a load at 67 m/s passes 2 and 64 m away. The history ends
    /// where a receiver's does, and twice or half of any band that matters is told.
    #[test]
    fn a_wrong_band_is_told_near_and_far() {
        let bands = Band::range(1.0, 20.0).unwrap();
        for (distance, least) in [(2.0, 12), (64.0, 1)] {
            let (a, before): (f64, f64) = (distance / 67.0, f64::max(150.0, 4.0 * distance) / 67.0);
            let step = 1.0 / 320.0;
            let times = (0..(2.0 * before / step) as usize).map(|i| step * i as f64 - before);
            let values = times.map(|t| -2.0 * a * a * t / (a * a + t * t).powi(2)).collect();
            let history = History::new(step, values).unwrap();
            let density = |f: f64| 2.0 * (2.0 * PI * f * PI * a * (-2.0 * PI * f * a).exp()).powi(2);
            let energy = |band: &Band| {
                let df = (band.upper() - band.lower()) / 200.0;
                (0..200).map(|i| df * density(band.lower() + df * (f64::from(i) + 0.5))).sum::<f64>()
            };
            let energies: Vec<f64> = bands.iter().map(energy).collect();
            let time = 2.0 * before;
            let faded = Faded::new(&history, FADING * before).unwrap();
            let told = |energies: &[f64]| {
                let wrong = faded.contradicts(&bands, energies.iter().copied(), time).unwrap();
                wrong.map(|(b, _, _)| b)
            };
            assert_eq!(told(&energies), None, "{distance} m");
            // bands above 1 % of the peak matter
            let matter: Vec<usize> = (0..bands.len())
                .filter(|b| rms(energies[*b], time).unwrap() > 0.01 * history.peak())
                .collect();
            assert!(matter.len() >= least, "{distance} m: {matter:?}");
            for b in matter {
                for factor in [0.25, 4.0] {
                    let mut wrong = energies.clone();
                    wrong[b] *= factor;
                    assert_eq!(told(&wrong), Some(b), "{distance} m, {} Hz, {factor}", bands[b].label());
                }
            }
        }
    }
}
