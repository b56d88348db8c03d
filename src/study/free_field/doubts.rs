//! What the free field may be doubted for.

use super::components::missing;
use super::metrics::significant;
use super::{Carrier, Driven, FreeField, Irregularity, PassVelocities};
use crate::concern::Concern;
use crate::irregularity::Spectrum;
use crate::railway::{Ground, Railway};
use crate::study::doubts::outruns_waves;
use crate::study::doubts::sinks_as_no_track_does;
use crate::study::speed_text;
use ndarray::Array2;
use std::f64::consts::TAU;

/// Share of the peak velocity at the ends of a history that counts as motion not died away.
const LEFT: f64 = 0.05;

impl PassVelocities<'_> {
    /// What the histories may be doubted for.
    pub(super) fn concerns(&self) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let left = |history: &Array2<f64>| {
            let rows = history.rows().into_iter().map(|row| {
                let end = (row.len() / 50).max(1);
                let size =
                    |values: &mut dyn Iterator<Item = &f64>| values.fold(0.0f64, |m, v| m.max(v.abs()));
                let ends = size(&mut row.iter().take(end)).max(size(&mut row.iter().rev().take(end)));
                ends / size(&mut row.iter()).max(f64::MIN_POSITIVE)
            });
            rows.fold(0.0, f64::max)
        };
        let left = self.histories.iter().map(left).fold(0.0, f64::max);
        if left > LEFT && self.study.roughness.is_some() {
            concerns.push(Concern::new(
                "history-ends",
                format!(
                    "{:.0} % of the peak velocity are left at the ends of a history: as much of what comes earlier or later is folded into it",
                    100.0 * left
                ),
                "waves fade slowly there (light damping, far receivers); bands of a spectrum's expected value are free of it",
            ));
        }
        if let Some(Irregularity::Given { profile, carrier, .. }) =
            self.study.roughness.as_ref().map(|r| &r.irregularity)
        {
            let way = self.study.speed * self.times.period() + self.pass.train.length();
            // what repeats by itself, as a wheel and a sinusoid do, may
            if *carrier == Carrier::Rail && profile.components().len() > 1 && profile.repeat_length() < way {
                concerns.push(Concern::new(
                    "profile-repeats",
                    format!(
                        "the profile is {:.0} m long and repeats; the train runs {way:.0} m in the histories",
                        profile.repeat_length()
                    ),
                    "measure a longer profile; the middle of it lies abreast of the receivers, where it matters most",
                ));
            }
        }
        concerns.extend(self.lifts());
        concerns
    }

    /// A concern where the leading wheelset would lift: its dynamic force is above its static load.
    fn lifts(&self) -> Option<Concern> {
        let roughness = self.study.roughness.as_ref()?;
        let load = self.pass.train.axles()[0].load;
        let random = matches!(roughness.irregularity, Irregularity::Random { .. });
        let force = largest_force(&self.driven, random);
        (force > load).then(|| {
            Concern::new(
                "wheel-lifts",
                format!(
                    "the dynamic force of the leading wheelset reaches {:.3e} kN, its static load is {:.3e} kN: the wheel would lift, and \
                     the linear contact then pulls at the rail",
                    1e-3 * force,
                    1e-3 * load
                ),
                "check the units: heights of profiles and amplitudes in m, loads in N, masses in kg; otherwise the dynamic part tells no more than its order of size",
            )
        })
    }
}

/// The force [N] that the `driven` components of a profile reach: three standard deviations, or all amplitudes together where that
/// is less. A `random` profile is known by densities at frequencies in equal steps of ln f.
fn largest_force(driven: &[Driven], random: bool) -> f64 {
    let square = |d: &Driven| d.force * d.force;
    if !random {
        let together: f64 = driven.iter().map(|d| d.force).sum();
        return together.min(3.0 * (0.5 * driven.iter().map(square).sum::<f64>()).sqrt());
    }
    let [first, second, ..] = driven else { return 0.0 };
    // σ² = ∫ S df = ∫ S f d ln f
    let step = (second.frequency / first.frequency).ln();
    3.0 * (step * driven.iter().map(|d| square(d) * d.frequency).sum::<f64>()).sqrt()
}

/// Share of σ² between the wavelengths `asked` [m] that lies outside those of `published` [m].
fn energy_beyond(spectrum: &Spectrum, asked: (f64, f64), published: (f64, f64)) -> f64 {
    let (from, to) = (asked.0.max(published.0), asked.1.min(published.1));
    let whole = spectrum.band_rms(asked.0, asked.1).powi(2);
    let inside = if from < to { spectrum.band_rms(from, to).powi(2) } else { 0.0 };
    (1.0 - inside / whole).max(0.0)
}

impl FreeField {
    /// Speeds and wavelengths the result may be doubted for.
    pub(super) fn concerns(&self, railway: &Railway) -> Vec<Concern> {
        let mut concerns: Vec<Concern> = outruns_waves(railway, self.speed).into_iter().collect();
        concerns.extend(sinks_as_no_track_does(railway));
        if let Ok(Ground { profile, .. }) = railway.ground() {
            let slowest = profile.slowest_rayleigh_speed();
            if self.speed >= slowest {
                concerns.push(Concern::new(
                    "faster-than-rayleigh",
                    format!(
                        "{} is not below the slowest Rayleigh wave of the ground ({slowest:.1} m/s): the axle loads alone radiate",
                        speed_text(self.speed)
                    ),
                    "see the critical speed of this train and track with [critical_speed]",
                ));
            }
        }
        concerns.extend(missing(self.components, &self.assessment.guides));
        let Some(roughness) = &self.roughness else { return concerns };
        let (low, high) = roughness.irregularity.wavenumbers();
        let (shortest, longest) = (TAU / high, TAU / low);
        if let Irregularity::Random { spectrum, .. } = &roughness.irregularity
            && let Some((least, most)) = spectrum.valid()
            && (shortest < 0.999 * least || longest > 1.001 * most)
        {
            let share = 100.0 * energy_beyond(spectrum, (shortest, longest), (least, most));
            concerns.push(Concern::new(
                "spectrum-range",
                format!(
                    "wavelengths {} to {} m go beyond those for which the spectrum is published, {} to {} m: \
                     {share:.3} % of the energy σ² of the profile lies out there",
                    significant(shortest),
                    significant(longest),
                    significant(least),
                    significant(most)
                ),
                "narrow irregularity.wavelengths, or read the bands driven by them as extrapolated",
            ));
        }
        let (low, high) = (self.speed / longest, self.speed / shortest);
        // a given profile drives what it drives
        if matches!(roughness.irregularity, Irregularity::Random { .. })
            && let (Some(first), Some(last)) = (self.bands.first(), self.bands.last())
            && (first.lower() < low || last.upper() > high)
        {
            concerns.push(Concern::new(
                "bands-without-drive",
                format!(
                    "at {} the profile drives {low:.2} to {high:.1} Hz, the bands reach from {:.2} to {:.1} Hz",
                    speed_text(self.speed),
                    first.lower(),
                    last.upper()
                ),
                "widen irregularity.wavelengths, or narrow free_field.frequencies; outside, the dynamic part is too small",
            ));
        }
        concerns
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::{BandLevels, TableSpectrum};

    #[test]
    fn energy_beyond_what_is_published() {
        // levels of 20, 10, 0 dB in bands at 0.4, 0.315, 0.25 m: without the last one 1/111 of the energy
        let levels = BandLevels::new(&[0.4, 0.315, 0.25], &[20.0, 10.0, 0.0], &[]).unwrap();
        let spectrum = Spectrum::Table(TableSpectrum::of_levels(levels, "x".into()));
        let (shortest, longest) = spectrum.valid().unwrap();
        let edge = 10f64.powf(-0.55);
        let beyond = energy_beyond(&spectrum, (shortest, longest), (edge, longest));
        assert!((beyond - 1.0 / 111.0).abs() < 1e-9, "{beyond}");
        assert_eq!(energy_beyond(&spectrum, (shortest, longest), (10.0, 20.0)), 1.0);
        assert!(energy_beyond(&spectrum, (shortest, longest), (shortest, longest)) < 1e-12);
    }

    #[test]
    fn forces_of_profiles_by_three_deviations_or_their_sum() {
        let driven = |force: &dyn Fn(f64) -> f64, count: usize| -> Vec<Driven> {
            let at = |i: usize| (1e-3 * (i as f64 + 0.5) * 100f64.ln()).exp();
            (0..count).map(|i| Driven { frequency: at(i), force: force(at(i)) }).collect()
        };
        // one wave reaches its amplitude, a thousand of 1 N reach 3 √(1000/2)
        assert_eq!(largest_force(&driven(&|_| 7.0, 1), false), 7.0);
        assert!((largest_force(&driven(&|_| 1.0, 1000), false) - 3.0 * 500f64.sqrt()).abs() < 1e-9);
        // white between 1 and 100 Hz: σ² = 99 S; the midpoint rule errs by 1e-6
        assert!(
            (largest_force(&driven(&|_| 2.0, 1000), true) / (3.0 * (4.0 * 99f64).sqrt()) - 1.0).abs() < 1e-5
        );
        assert_eq!(largest_force(&[], true), 0.0);
    }
}
