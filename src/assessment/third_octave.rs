//! Third-octave bands, exact to base ten.

use super::AssessmentError;
use crate::signal::EnergySpectrum;

/// The third-octave band number n: centre f_m = 10^{n/10} Hz, edges f_m 10^{±1/20}.
///
/// Source: IEC 61260-1 (base ten), with its band numbers counted from 1 Hz.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Band {
    /// n; 0 is the band at 1 Hz, 10 at 10 Hz, 15 at 31.5 Hz, 19 at 80 Hz.
    pub number: i32,
}

impl Band {
    /// The band that contains `frequency` [Hz]: for a nominal centre, as 31.5, the band of that name.
    ///
    /// # Errors
    /// A frequency that is not positive and finite.
    pub fn containing(frequency: f64) -> Result<Self, AssessmentError> {
        if frequency > 0.0 && frequency.is_finite() {
            Ok(Self { number: (10.0 * frequency.log10()).round() as i32 })
        } else {
            Err(AssessmentError::Frequency { frequency })
        }
    }

    /// All bands from the one that contains `from` to the one that contains `to` [Hz], rising.
    ///
    /// # Errors
    /// Frequencies that are not positive and finite; `to` in a lower band than `from`.
    pub fn range(from: f64, to: f64) -> Result<Vec<Self>, AssessmentError> {
        let (first, last) = (Self::containing(from)?.number, Self::containing(to)?.number);
        if last < first {
            return Err(AssessmentError::Range { from, to });
        }
        Ok((first..=last).map(|number| Self { number }).collect())
    }

    /// f_m = 10^{n/10} [Hz]
    pub fn centre(self) -> f64 {
        10f64.powf(f64::from(self.number) / 10.0)
    }

    /// f_m 10^{−1/20} [Hz]; to the last bit the upper edge of the band below.
    pub fn lower(self) -> f64 {
        10f64.powf((2.0 * f64::from(self.number) - 1.0) / 20.0)
    }

    /// f_m 10^{1/20} [Hz]
    pub fn upper(self) -> f64 {
        10f64.powf((2.0 * f64::from(self.number) + 1.0) / 20.0)
    }

    /// The nominal centre in Hz, as on an axis: `1.6`, `31.5`, `80`, `125`.
    pub fn label(self) -> String {
        const NOMINAL: [&str; 10] = ["1", "1.25", "1.6", "2", "2.5", "3.15", "4", "5", "6.3", "8"];
        let nominal = NOMINAL[self.number.rem_euclid(10) as usize];
        let decade = self.number.div_euclid(10);
        if decade == 0 {
            return nominal.to_owned();
        }
        // shift the decimal point by whole decades
        let digits = nominal.replace('.', "");
        if decade < 0 {
            return format!("0.{}{digits}", "0".repeat((-decade - 1) as usize));
        }
        let point = 1 + decade as usize;
        if digits.len() <= point {
            format!("{digits:0<point$}")
        } else {
            format!("{}.{}", &digits[..point], &digits[point..])
        }
    }

    /// E = ∫ S df over the band [unit² s]; [`rms`] makes an r.m.s. of it.
    ///
    /// The density is linear between the frequencies of the spectrum and the edges of the band are met exactly: energies
    /// of neighbouring bands add up to that of their range (`bands_add_up`). A history goes through [`EnergySpectrum::of`],
    /// whose bands then depend by 1e-4 of the largest on how many zeros follow the history (`bands_do_not_depend_on_padding`).
    ///
    /// # Errors
    /// A band that the spectrum does not cover.
    pub fn energy(self, spectrum: &EnergySpectrum) -> Result<f64, AssessmentError> {
        Ok(spectrum.between(self.lower(), self.upper())?)
    }
}

/// v_rms = √(E/T) of an `energy` E [unit² s] in the passage time T [s], in the unit of the history.
///
/// # Errors
/// A passage time that is not positive and finite.
pub fn rms(energy: f64, passage_time: f64) -> Result<f64, AssessmentError> {
    if passage_time > 0.0 && passage_time.is_finite() {
        Ok((energy / passage_time).sqrt())
    } else {
        Err(AssessmentError::PassageTime { passage_time })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::History;
    use std::f64::consts::TAU;

    /// Four axles: tones of 4, 8, 20 and 50 Hz under smooth envelopes, one second each.
    fn pass() -> History {
        let values = (0..8192).map(|j| {
            let t = f64::from(j) / 1024.0;
            [(2.0, 4.0, 1e-3), (3.0, 8.0, 5e-4), (4.0, 20.0, 2e-4), (5.0, 50.0, 1e-4)]
                .iter()
                .map(|(at, f, v)| v * (-0.5 * ((t - at) / 0.4).powi(2)).exp() * (TAU * f * t).sin())
                .sum()
        });
        History::new(1.0 / 1024.0, values.collect()).unwrap()
    }

    #[test]
    fn bands_add_up() {
        let (history, spectrum) = (pass(), EnergySpectrum::of(&pass()));
        let bands = Band::range(0.5, 160.0).unwrap();
        let sum: f64 = bands.iter().map(|b| b.energy(&spectrum).unwrap()).sum();
        // the range of the bands: measured 7e-15
        let range = spectrum.between(bands[0].lower(), bands[bands.len() - 1].upper()).unwrap();
        assert!((sum / range - 1.0).abs() < 1e-13);
        // Parseval: all the energy lies between 0.5 and 160 Hz; measured 2e-14
        assert!((sum / history.energy() - 1.0).abs() < 1e-12, "{}", sum / history.energy() - 1.0);
    }

    #[test]
    fn bands_do_not_depend_on_padding() {
        // a history continued by zeros has the same bands: the error of the straight lines between the lines of the
        // spectrum; measured 1e-4 of the largest band
        let history = pass();
        let mut longer = history.values().to_vec();
        longer.resize(8 * longer.len(), 0.0);
        let longer = History::new(history.step(), longer).unwrap();
        let (coarse, fine) = (EnergySpectrum::of(&history), EnergySpectrum::of(&longer));
        let bands = Band::range(1.0, 80.0).unwrap();
        let energies =
            |s: &EnergySpectrum| -> Vec<f64> { bands.iter().map(|b| b.energy(s).unwrap()).collect() };
        let (coarse, fine) = (energies(&coarse), energies(&fine));
        let largest = fine.iter().copied().fold(0.0, f64::max);
        let worst = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs() / largest).fold(0.0, f64::max);
        assert!(worst < 2e-4, "{worst}");
    }

    #[test]
    fn a_tone_lies_in_its_band() {
        // v = A sin ωt for T: v_rms = A/√2; what leaks out of the band falls as 1/T; measured 9e-4 short at 16 s
        let values = (0..16000).map(|j| 1e-3 * (TAU * 31.5 * f64::from(j) / 1000.0).sin());
        let history = History::new(1e-3, values.collect()).unwrap();
        let spectrum = EnergySpectrum::of(&history);
        let band = Band::containing(31.5).unwrap();
        let v = rms(band.energy(&spectrum).unwrap(), history.duration()).unwrap();
        assert!((v / (1e-3 / 2f64.sqrt()) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn centres_edges_and_names() {
        let band = Band::containing(31.5).unwrap();
        assert_eq!(band.number, 15);
        assert!((band.centre() - 31.6228).abs() < 1e-4);
        assert!((band.lower() - 28.1838).abs() < 1e-4 && (band.upper() - 35.4813).abs() < 1e-4);
        assert_eq!(band.upper(), Band { number: 16 }.lower());
        let labels: Vec<String> = Band::range(1.0, 80.0).unwrap().iter().map(|b| b.label()).collect();
        let expected = "1 1.25 1.6 2 2.5 3.15 4 5 6.3 8 10 12.5 16 20 25 31.5 40 50 63 80";
        assert_eq!(labels.join(" "), expected);
        for (number, label) in
            [(-10, "0.1"), (-9, "0.125"), (-15, "0.0315"), (21, "125"), (25, "315"), (31, "1250")]
        {
            assert_eq!(Band { number }.label(), label);
        }
        // every name leads to its band
        for number in -20..40 {
            let band = Band { number };
            assert_eq!(Band::containing(band.label().parse().unwrap()).unwrap(), band);
        }
    }

    #[test]
    fn refusals() {
        for f in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(Band::containing(f), Err(AssessmentError::Frequency { .. })));
        }
        assert!(matches!(Band::range(80.0, 1.0), Err(AssessmentError::Range { .. })));
        assert!(matches!(rms(1.0, 0.0), Err(AssessmentError::PassageTime { .. })));
        let narrow = EnergySpectrum::new(vec![1.0, 2.0], vec![1.0, 1.0]).unwrap();
        assert!(matches!(Band { number: 10 }.energy(&narrow), Err(AssessmentError::Signal(_))));
    }
}
