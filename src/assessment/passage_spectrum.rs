//! Third octaves of a passage: the mean over it, and the largest value of each band.

use super::running_rms::{Averaging, running_rms};
use super::third_octave::Band;
use crate::signal::History;
use num_complex::Complex64;
use rayon::prelude::*;

/// Share of the largest running r.m.s. at which the passage begins and ends.
const EDGE: f64 = 0.25;

/// Third octaves of one passage [m/s], band by band.
#[derive(Clone, Debug, PartialEq)]
pub struct PassageSpectrum {
    /// First and last moment of the passage T₂, after the beginning of the history [s].
    pub passage: (f64, f64),
    /// R.m.s. of the running r.m.s. FAST during T₂.
    pub interval: Vec<f64>,
    /// The largest running r.m.s. FAST of the whole history: "max hold".
    pub max_hold: Vec<f64>,
}

impl Band {
    /// H(f) = 1/((1 + p)(1 + p + p²)), p = i (f/f_m − f_m/f) f_m/(f₂ − f₁), f in Hz: Butterworth of third order in the band, 3 dB down
    /// at its edges.
    ///
    /// Source: IEC 61260-1 leaves the filter open; this is the usual one.
    pub fn filter(self, frequency: f64) -> Complex64 {
        if frequency == 0.0 {
            return Complex64::ZERO;
        }
        let (centre, width) = (self.centre(), self.upper() - self.lower());
        let p = Complex64::new(0.0, (frequency / centre - centre / frequency) * centre / width);
        1.0 / ((1.0 + p) * (1.0 + p + p * p))
    }

    /// Seconds until the filter has forgotten all but 4e-16: its slowest pole decays with π (f₂ − f₁)/2 to first order, hence
    /// T = 35.5/(0.5 π · 0.2316 f_m), and a tenth more.
    fn memory(self) -> f64 {
        107.0 / self.centre()
    }
}

/// Interval and max-hold third octaves of a `velocity` [m/s] of one passage.
///
/// T₂ lasts from where the running r.m.s. of the whole signal first reaches a quarter of its largest value to where it last does.
/// The standard takes a quarter of the most frequent maxima, judged by eye.
///
/// Accuracy: a tone in the middle of its band to 1e-3 once settled (`a_tone_in_its_band`). Narrow bands answer slowly: that at 1 Hz
/// takes 4 s, and one axle group reads lower in it than its energy says.
///
/// Source: DIN 45672-2:1995, Formulae (1), (6), (7) and clause 5, by way of the library phonometry.
pub fn passage_spectrum(velocity: &History, bands: &[Band]) -> PassageSpectrum {
    let whole = running_rms(velocity, Averaging::Fast);
    let edge = EDGE * whole.peak();
    let first = whole.values().iter().position(|v| *v >= edge).unwrap_or(0);
    let last = whole.values().iter().rposition(|v| *v >= edge).unwrap_or(0).max(first);
    let of = |band: &Band| {
        let part = velocity.filtered(band.memory(), |f| band.filter(f));
        let running = running_rms(&part, Averaging::Fast);
        let passage = &running.values()[first..=last];
        let interval = (passage.iter().map(|v| v * v).sum::<f64>() / passage.len() as f64).sqrt();
        (interval, running.peak())
    };
    let (interval, max_hold) = bands.par_iter().map(of).unzip();
    let at = |i: usize| i as f64 * velocity.step();
    PassageSpectrum { passage: (at(first), at(last)), interval, max_hold }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn three_decibels_at_the_edges() {
        for band in Band::range(1.0, 80.0).unwrap() {
            assert!((band.filter(band.centre()).norm() - 1.0).abs() < 1e-12);
            for edge in [band.lower(), band.upper()] {
                // |p| = 1 at both edges: f₁ f₂ = f_m²
                assert!((band.filter(edge).norm_sqr() - 0.5).abs() < 1e-12, "{}", band.label());
            }
            // an octave away: below the limits of IEC 61260-1, class 1, of some −40 dB
            assert!(band.filter(2.0 * band.centre()).norm() < 0.005);
        }
    }

    #[test]
    fn a_tone_in_its_band() {
        // 1 mm/s at the centre of 16 Hz from 5 to 25 s: both are 1/√2 mm/s but for rise and ripple, measured −1.4 %
        // (interval, which has the rise in it) and +3e-4 (max hold)
        let band = Band::containing(16.0).unwrap();
        let values = (0..15_000).map(|j| {
            let t = 2e-3 * f64::from(j);
            if (5.0..25.0).contains(&t) { 1e-3 * (TAU * band.centre() * t).sin() } else { 0.0 }
        });
        let velocity = History::new(2e-3, values.collect()).unwrap();
        let found = passage_spectrum(&velocity, &[band, Band { number: band.number + 3 }]);
        let rms = 1e-3 / 2f64.sqrt();
        println!("{:?} {} {}", found.passage, found.interval[0] / rms - 1.0, found.max_hold[0] / rms - 1.0);
        assert!((found.interval[0] / rms - 1.0).abs() < 0.03);
        assert!((found.max_hold[0] / rms - 1.0).abs() < 0.06);
        assert!((found.passage.0 - 5.0).abs() < 0.1 && (found.passage.1 - 25.3).abs() < 0.2);
        // an octave above almost nothing of it but the ends
        assert!(found.interval[1] < 0.02 * rms);
    }
}
