//! From the ground to a foundation, a floor, and the noise of a room, by tables: estimates, as good as their table.

use super::AssessmentError;
use super::third_octave::Band;
use crate::signal::History;
use num_complex::Complex64;

/// What a building makes of the motion of its ground: a factor for each third octave.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    /// Number of the first band.
    first: i32,
    /// Factors, band after band.
    factors: Vec<f64>,
}

impl Transfer {
    /// The transfer with one of `factors` [1] at each of `frequencies` [Hz], the centres of third octaves one after another.
    ///
    /// # Errors
    /// No band; a frequency that is no band, stands in a band before the last one, or leaves bands out; a factor that is negative or
    /// not finite.
    pub fn new(frequencies: &[f64], factors: &[f64]) -> Result<Self, AssessmentError> {
        let mut bands: Vec<i32> = Vec::with_capacity(frequencies.len());
        for (index, frequency) in frequencies.iter().enumerate() {
            let band = Band::containing(*frequency)?;
            if let Some(last) = bands.last()
                && band.number != last + 1
            {
                let wanted = Band { number: last + 1 }.label();
                return Err(AssessmentError::Bands { index, frequency: *frequency, wanted });
            }
            bands.push(band.number);
        }
        let Some(first) = bands.first().copied().filter(|_| bands.len() == factors.len()) else {
            return Err(AssessmentError::Lengths { frequencies: bands.len(), factors: factors.len() });
        };
        if let Some(index) = factors.iter().position(|factor| !(*factor >= 0.0 && factor.is_finite())) {
            return Err(AssessmentError::Factor { frequency: frequencies[index], factor: factors[index] });
        }
        Ok(Self { first, factors: factors.to_vec() })
    }

    /// First and last band.
    pub fn range(&self) -> (Band, Band) {
        (Band { number: self.first }, Band { number: self.first + self.factors.len() as i32 - 1 })
    }

    /// Factor of a `band`; beyond the table that of its nearest band.
    pub fn factor(&self, band: Band) -> f64 {
        let at = (band.number - self.first).clamp(0, self.factors.len() as i32 - 1);
        self.factors[at as usize]
    }

    /// Factor at a frequency `f` [Hz]: geometric between the centres of neighbouring bands, straight where one is zero, constant beyond
    /// the table.
    pub fn at(&self, f: f64) -> f64 {
        let place = 10.0 * f.max(f64::MIN_POSITIVE).log10() - f64::from(self.first);
        let place = place.clamp(0.0, (self.factors.len() - 1) as f64);
        let below = (place as usize).min(self.factors.len().saturating_sub(2));
        let part = place - below as f64;
        let (a, b) = (self.factors[below], self.factors[(below + 1).min(self.factors.len() - 1)]);
        if a > 0.0 && b > 0.0 { a * (b / a).powf(part) } else { a + part * (b - a) }
    }

    /// The `velocity` behind the transfer, without a shift of phase, of which tables say nothing.
    ///
    /// Bands of the result differ from those of [`Self::factor`] as far as the factor changes across a band.
    pub fn of(&self, velocity: &History) -> History {
        let slowest = self.range().0.lower();
        velocity.filtered(8.0 / slowest, |f| Complex64::new(self.at(f), 0.0))
    }
}

/// A(f) [dB], the weighting of sound, 0 at 1 kHz.
///
/// Source: IEC 61672-1, Annex E, with its rounded corners 20.60, 107.7, 737.9 and 12194 Hz.
pub fn a_weighting(frequency: f64) -> f64 {
    let f = frequency * frequency;
    let gain = |f: f64| {
        12194f64.powi(2) * f * f
            / ((f + 20.6f64.powi(2))
                * ((f + 107.7f64.powi(2)) * (f + 737.9f64.powi(2))).sqrt()
                * (f + 12194f64.powi(2)))
    };
    20.0 * (gain(f) / gain(1e6)).log10()
}

/// L_pA = 10 lg Σ 10^{(L_p + A)/10} [dB] of third-octave `levels` [dB re 20 µPa] in `bands`; −∞ of none.
pub fn a_weighted_level(bands: &[Band], levels: &[f64]) -> f64 {
    let power = |(band, level): (&Band, &f64)| 10f64.powf(0.1 * (level + a_weighting(band.centre())));
    10.0 * bands.iter().zip(levels).map(power).sum::<f64>().log10()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_of_bands_and_between_them() {
        let table = Transfer::new(&[8.0, 10.0, 12.5], &[1.0, 4.0, 0.0]).unwrap();
        assert_eq!(table.range(), (Band { number: 9 }, Band { number: 11 }));
        let of = |f: f64| table.factor(Band::containing(f).unwrap());
        assert_eq!([4.0, 8.0, 10.0, 12.5, 80.0].map(of), [1.0, 1.0, 4.0, 0.0, 0.0]);
        // halfway between 8 and 10 Hz: √(1 · 4); between 10 and 12.5 Hz: (4 + 0)/2
        assert!((table.at(10f64.powf(0.95)) - 2.0).abs() < 1e-12);
        assert!((table.at(10f64.powf(1.05)) - 2.0).abs() < 1e-12);
        assert_eq!((table.at(0.0), table.at(500.0)), (1.0, 0.0));
    }

    #[test]
    fn unity_is_the_ground() {
        let unity = Transfer::new(&[1.0, 1.25, 1.6], &[1.0; 3]).unwrap();
        let ground = History::new(0.01, (0..500).map(|j| (0.07 * f64::from(j * j)).sin()).collect()).unwrap();
        // measured 2e-15: a transform there and back
        let there = unity.of(&ground);
        let worst = there.values().iter().zip(ground.values()).map(|(a, b)| (a - b).abs());
        assert!(worst.fold(0.0, f64::max) < 1e-13);
    }

    #[test]
    fn a_gap_and_a_step_back_are_told() {
        let why = |frequencies: &[f64]| {
            Transfer::new(frequencies, &vec![1.0; frequencies.len()]).unwrap_err().to_string()
        };
        assert!(why(&[8.0, 12.5]).contains("12.5 Hz stands where 10 Hz is wanted"));
        assert!(why(&[8.0, 6.3]).contains("6.3 Hz stands where 10 Hz is wanted"));
        assert!(why(&[8.0, -1.0]).contains("-1 Hz"));
        assert!(why(&[]).contains("0 frequencies and 0 factors"));
        assert!(Transfer::new(&[8.0], &[-1.0]).unwrap_err().to_string().contains("8 Hz is -1"));
    }

    #[test]
    fn a_weighting_of_the_standard() {
        // IEC 61672-1, Table 3, one decimal: 31.5 Hz −39.4, 63 Hz −26.2, 125 Hz −16.1, 1 kHz 0
        for (number, level) in [(15, -39.4), (18, -26.2), (21, -16.1), (30, 0.0)] {
            assert!((a_weighting(Band { number }.centre()) - level).abs() < 0.06, "{number}");
        }
        // two bands of 50 dB at 1 kHz are 53.01 dB(A)
        let bands = [Band { number: 30 }; 2];
        assert!((a_weighted_level(&bands, &[50.0, 50.0]) - 53.0103).abs() < 1e-4);
    }
}
