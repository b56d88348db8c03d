//! The rail the wheels roll over, as pictures: a stretch of its profile, and its third octaves over wavelength.

use super::pictures::figure;
use super::{Carrier, Irregularity, PassVelocities};
use crate::figure::{Figure, Series, Stroke};
use crate::irregularity::Spectrum;
use std::f64::consts::TAU;

/// Most points of a stretch.
const POINTS: usize = 1500;
/// Longest stretch that is drawn [m].
const STRETCH: f64 = 200.0;
/// r₀ of levels [m].
const REFERENCE: f64 = 1e-6;

/// A third octave of wavelengths: 10^{n/10} waves a metre, from edge to edge.
fn edges(n: i32) -> (f64, f64) {
    let edge = |half: f64| 10f64.powf(-(f64::from(n) + half) / 10.0);
    (edge(0.5), edge(-0.5))
}

/// Levels [dB re 1 µm] of the bands between `shortest` and `longest` [m] as steps, by the r.m.s. from edge to edge of a band.
fn levels(
    name: &str,
    (shortest, longest): (f64, f64),
    rms: &dyn Fn(f64, f64) -> f64,
    stroke: Stroke,
) -> Series {
    let number = |wavelength: f64| (-10.0 * wavelength.log10()).round() as i32;
    let (mut x, mut y) = (Vec::new(), Vec::new());
    // a band on the edge of the range holds a rounding of it
    for n in number(longest * 0.9999)..=number(shortest * 1.0001) {
        let (from, to) = edges(n);
        let level = 20.0 * (rms(from, to) / REFERENCE).log10();
        x.extend([to, from]);
        y.extend([level, level]);
    }
    let gaps = y.into_iter().map(|level| if level.is_finite() { level } else { f64::NAN }).collect();
    Series { name: name.into(), x, y: gaps, stroke }
}

impl Irregularity {
    /// R.m.s. of its waves between two wavelengths [m].
    fn rms_between(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Random { spectrum, .. } => spectrum.band_rms(from, to),
            Self::Given { profile, .. } => profile.between(from, to).rms(),
        }
    }
}

impl PassVelocities<'_> {
    /// A stretch of the first profile abreast of the receivers, and the spectrum of the rail beside the limit of ISO 3095.
    pub(super) fn profile_figures(&self) -> Vec<(Figure, String)> {
        let Some(roughness) = &self.study.roughness else { return Vec::new() };
        let irregularity = &roughness.irregularity;
        let (low, high) = irregularity.wavenumbers();
        let range = (TAU / high, TAU / low);
        let mut figures = Vec::new();
        if let Ok(profiles) = irregularity.profiles(&self.pass, range.0, self.times.period())
            && let Some(profile) = profiles.first()
        {
            let half = (0.5 * STRETCH).min(0.5 * profile.repeat_length());
            let step = 2.0 * half / POINTS as f64;
            let x = (0..=POINTS).map(|i| step * i as f64 - half).collect();
            let y = profile.stretch(-half, step, POINTS + 1).iter().map(|r| 1e3 * r).collect();
            let carrier = match irregularity {
                Irregularity::Given { carrier: Carrier::Wheels { .. }, .. } => "around a wheel",
                _ => "of the rail",
            };
            let labels = ("x [m], receivers at x = 0", "r [mm], positive down");
            let mut picture =
                figure("irregularity_profile".into(), format!("Profile {carrier}"), labels, false);
            picture.y_down = true;
            picture.series = vec![Series { name: "profile".into(), x, y, stroke: Stroke::Solid }];
            figures.push((Figure::Lines(picture), self.which()));
        }
        let labels = ("wavelength [m]", "third-octave level [dB re 1 µm]");
        let mut picture =
            figure("irregularity_spectrum".into(), "Roughness over wavelength".into(), labels, true);
        picture.log_y = false;
        // a band on the edge of the range holds what lies within it
        let own = |from: f64, to: f64| irregularity.rms_between(from.max(range.0), to.min(range.1));
        picture.series.push(levels("this rail", range, &own, Stroke::Solid));
        let limit = Spectrum::Iso3095;
        let both = limit.valid().map_or(range, |(a, b)| (a.max(range.0), b.min(range.1)));
        if both.0 < both.1
            && !matches!(irregularity, Irregularity::Random { spectrum: Spectrum::Iso3095, .. })
        {
            let rms = |from: f64, to: f64| limit.band_rms(from, to);
            picture.series.push(levels("limit of ISO 3095:2013", both, &rms, Stroke::Dashed));
        }
        let caption = format!("R.m.s. of each third octave of wavelengths; {}.", irregularity.text());
        figures.push((Figure::Lines(picture), caption));
        figures
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_those_of_the_standard() {
        let limit = Spectrum::Iso3095;
        let rms = |from: f64, to: f64| limit.band_rms(from, to);
        let (shortest, longest) = limit.valid().unwrap();
        let line = levels("limit", (shortest, longest), &rms, Stroke::Solid);
        // 29 bands of two corners, the first at 2 m with 17.1 dB, the last at 3.15 mm with −11 dB
        assert_eq!(line.x.len(), 58);
        assert!((line.x[0] / longest - 1.0).abs() < 1e-9 && (line.y[0] - 17.1).abs() < 1e-9);
        assert!((line.y[57] + 11.0).abs() < 1e-9);
        assert_eq!(edges(0), (10f64.powf(-0.05), 10f64.powf(0.05)));
    }
}
