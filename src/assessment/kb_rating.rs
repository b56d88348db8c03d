//! KB over passages and the time of assessment: clock maxima, KB_FTm, KB_FTr.

use super::guide::Period;
use crate::signal::History;

/// A clock interval [s].
pub const CLOCK: f64 = 30.0;
/// Clock maxima up to this one count as zero.
const UNFELT: f64 = 0.1;
/// Weight of squares in the hours of rest.
const REST: f64 = 2.0;

/// KB_FTi of the intervals of 30 s that a passage occupies, one interval centred on its largest KB_F; those not above 0.1 are zero.
///
/// `kb_f` is KB_F(t), as of [`super::kb_f`]. Intervals before the first and after the last that is not zero are not occupied; the
/// one in the middle always is.
///
/// Source: DIN 4150-2:1999, 3.5.3, 3.6 and Annex A.
pub fn clock_maxima(kb_f: &History) -> Vec<f64> {
    let values = kb_f.values();
    let middle = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    let clock = (CLOCK / kb_f.step()).round().max(1.0) as usize;
    // the first interval may begin before the history does
    let skipped = (middle as isize - clock as isize / 2).rem_euclid(clock as isize) as usize;
    let felt = |part: &[f64]| {
        let most = part.iter().copied().fold(0.0, f64::max);
        if most > UNFELT { most } else { 0.0 }
    };
    let (head, rest) = values.split_at(skipped.min(values.len()));
    let mut maxima: Vec<f64> = Some(head).filter(|head| !head.is_empty()).into_iter().map(felt).collect();
    maxima.extend(rest.chunks(clock).map(felt));
    let Some(first) = maxima.iter().position(|kb| *kb > 0.0) else { return vec![0.0] };
    let last = maxima.iter().rposition(|kb| *kb > 0.0).unwrap_or(first);
    maxima[first..=last].to_vec()
}

/// KB_FTm = √( (1/N) Σ KB²_FTi ) of N clock maxima; zero of none.
///
/// Source: DIN 4150-2:1999, Formula (3); of a class of trains over the intervals they occupy, Formula (A.1).
pub fn clock_maximum_rms(maxima: &[f64]) -> f64 {
    (maxima.iter().map(|kb| kb * kb).sum::<f64>() / maxima.len().max(1) as f64).sqrt()
}

/// Vibration of one kind during part of a day or night.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// KB_FTm
    pub kb_ftm: f64,
    /// T_e [s]; of n passages in m intervals each, 30 s × n m.
    pub time: f64,
    /// In the hours of rest, where squares count twice: not asked of railways and roads (6.5.2, 6.5.3).
    pub at_rest: bool,
}

/// KB_FTr = √( (1/T_r) Σ w_j T_e,j KB²_FTm,j ), w = 2 in the hours of rest and 1 elsewhere; a pure number.
///
/// Source: DIN 4150-2:1999, Formulae (4a), (4b), (5); with times in intervals of 30 s (A.3).
pub fn kb_rating(exposures: &[Exposure], period: Period) -> f64 {
    let weight = |e: &Exposure| if e.at_rest { REST } else { 1.0 };
    let sum: f64 = exposures.iter().map(|e| weight(e) * e.time * e.kb_ftm * e.kb_ftm).sum();
    (sum / period.duration()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOUR: f64 = 3600.0;

    /// DIN 4150-2:1999, Annex C, as quoted with its results in the library phonometry; worked again here by hand.
    #[test]
    fn examples_of_the_standard() {
        let exposure = |kb_ftm, time, at_rest| Exposure { kb_ftm, time, at_rest };
        // Example 4: 6 h of 0.16 and 1.5 h of 0.39 in 16 h: (6 · 0.0256 + 1.5 · 0.1521)/16 = (0.1536 + 0.22815)/16 = 0.023859; √ = 0.15446
        let hammers = [exposure(0.16, 6.0 * HOUR, false), exposure(0.39, 1.5 * HOUR, false)];
        assert!((kb_rating(&hammers, Period::Day) - 0.154_465).abs() < 1e-6);
        // Example 5: the second in the evening: (0.1536 + 2 · 0.22815)/16 = 0.0381188; √ = 0.19524, printed 0.20
        let evening = [hammers[0], Exposure { at_rest: true, ..hammers[1] }];
        assert!((kb_rating(&evening, Period::Day) - 0.195_240).abs() < 1e-6);
        // Example 6: 0.16 all day, 4 h of them at rest: 0.0256 (12 + 2 · 4)/16 = 0.032; √ = 0.17889, printed 0.18
        let whole = [exposure(0.16, 12.0 * HOUR, false), exposure(0.16, 4.0 * HOUR, true)];
        assert!((kb_rating(&whole, Period::Day) - 0.178_885).abs() < 1e-6);
    }

    /// Example 8: trains of two classes, 288 and 192 intervals of 1920 by day.
    #[test]
    fn a_day_of_trains() {
        // class 1: (0.92² + 0.6² + 0.9²)/3 = (0.8464 + 0.36 + 0.81)/3 = 0.672133, √ = 0.81984, printed 0.82
        let first = clock_maximum_rms(&[0.92, 0.6, 0.9]);
        assert!((first - 0.819_837).abs() < 1e-6);
        // class 2: (0.04 + 0.0576)/2 = 0.0488, √ = 0.22091, printed 0.22
        let second = clock_maximum_rms(&[0.2, 0.24]);
        assert!((second - 0.220_907).abs() < 1e-6);
        // (288 · 0.672133 + 192 · 0.0488)/1920 = (193.5744 + 9.3696)/1920 = 0.1057; √ = 0.32512, printed 0.325
        let class = |kb_ftm, clocks| Exposure { kb_ftm, time: CLOCK * clocks, at_rest: false };
        let day = kb_rating(&[class(first, 288.0), class(second, 192.0)], Period::Day);
        assert!((day - 0.325_115).abs() < 1e-6);
        // Annex D: at 0.2 some seven trains an hour keep to 0.05 by night: 120 (0.05/0.2)² = 7.5, 8 h of them
        assert!((kb_rating(&[class(0.2, 7.5 * 8.0)], Period::Night) - 0.05).abs() < 1e-12);
    }

    #[test]
    fn intervals_of_a_passage() {
        let hat = |width: usize, top: f64, at: usize| {
            let mut values = vec![0.0; 1200];
            values[at - width / 2..at + width / 2].fill(top);
            values[at] = 1.01 * top;
            History::new(0.1, values).unwrap()
        };
        // 20 s of it lie in one interval of 30 s wherever they stand, 50 s in three, 10 s on each side
        for at in [150, 400, 613] {
            assert_eq!(clock_maxima(&hat(200, 0.4, at)), [0.404], "{at}");
        }
        assert_eq!(clock_maxima(&hat(500, 0.4, 613)), [0.4, 0.404, 0.4]);
        // not felt: one interval of zero
        assert_eq!(clock_maxima(&hat(500, 0.09, 613)), [0.0]);
        assert_eq!(clock_maximum_rms(&[]), 0.0);
    }
}
