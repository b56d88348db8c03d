//! Peak particle velocity of one component.

use super::band_limit::{band_limit, memory};
use crate::signal::History;

/// Working range of a vibration meter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkingRange {
    /// 1 to 80 Hz: buildings.
    To80,
    /// 1 to 315 Hz: blasting, structure-borne sound.
    To315,
}

impl WorkingRange {
    /// f_u and f_o [Hz].
    pub fn limits(self) -> (f64, f64) {
        match self {
            Self::To80 => (1.0, 80.0),
            Self::To315 => (1.0, 315.0),
        }
    }

    /// `velocity` within the range: second-order Butterworth at 0.8 f_u and f_o/0.8, in the unit of the history.
    ///
    /// Accuracy: see [`History::filtered`].
    ///
    /// Source: DIN 45669-1:2010, 5.2.3.2, Formula (3), by way of the library phonometry (github.com/jmrplens/phonometry,
    /// `docs/vibration/immission/vibration-meter.md`).
    pub fn of(self, velocity: &History) -> History {
        let (from, to) = self.limits();
        velocity.filtered(memory(0.8 * from), |f| band_limit(f, 0.8 * from, to / 0.8))
    }
}

/// PPV = max |v(t)| [m/s] of one component of the velocity, unweighted.
///
/// Accuracy: the largest sample; of a sine of frequency f it is at worst cos(πf Δt) of the peak, 0.95 at ten samples per
/// period (`largest_sample`).
///
/// Source: DIN 4150-3, |v|_i,max.
pub fn peak_velocity(velocity: &History) -> f64 {
    velocity.peak()
}

/// PPV = max |v(t)| [m/s] of one component within the `range` of a meter.
///
/// Accuracy: as [`peak_velocity`].
///
/// Source: DIN 4150-3 and DIN 45669-1.
pub fn peak_velocity_within(velocity: &History, range: WorkingRange) -> f64 {
    range.of(velocity).peak()
}

/// Guide value [m/s] of the largest of three components at the foundation, for a dominant `frequency` [Hz], of commercial buildings,
/// dwellings and buildings worth preserving: straight lines between 1, 10, 50 and 100 Hz.
///
/// Source: DIN 4150-3:1999, Table 1 and Figure 1 (short-term vibration), by way of the library phonometry
/// (`vibration/structural/building_damage.py`); the table also in geothermie.de, "Schadensgrenze (Erschütterungen)".
pub fn foundation_guide_values(frequency: f64) -> [f64; 3] {
    let at = frequency.clamp(1.0, 100.0);
    [[20.0, 20.0, 40.0, 50.0], [5.0, 5.0, 15.0, 20.0], [3.0, 3.0, 8.0, 10.0]].map(|values: [f64; 4]| {
        let (from, part) = match at {
            f if f <= 10.0 => (0, (f - 1.0) / 9.0),
            f if f <= 50.0 => (1, (f - 10.0) / 40.0),
            f => (2, (f - 50.0) / 50.0),
        };
        1e-3 * (values[from] + part * (values[from + 1] - values[from]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn largest_sample() {
        // ten samples per period that miss the peaks by half a step: cos(π/10) = 0.951
        let values = (0..100).map(|j| -2.0 * (TAU * (f64::from(j) + 0.5) / 10.0).cos()).collect();
        let peak = peak_velocity(&History::new(0.01, values).unwrap());
        assert!((peak - 2.0 * (PI / 10.0).cos()).abs() < 1e-14);
    }

    #[test]
    fn peaks_within_the_range() {
        // a settled sine keeps |H|: 1/√(1 + (f₁/f)⁴)/√(1 + (f/f₂)⁴); 16 samples per period at 200 Hz miss no peak
        // by more than 2 %; the ends of the sine ring, so the middle is looked at
        for (frequency, range, corners) in [
            (200.0, WorkingRange::To80, (0.8f64, 100.0f64)),
            (200.0, WorkingRange::To315, (0.8, 393.75)),
            (16.0, WorkingRange::To80, (0.8, 100.0)),
        ] {
            let step = 1.0 / 3200.0;
            let sine = (0..32_000).map(|j| (TAU * frequency * step * f64::from(j)).sin()).collect();
            let within = range.of(&History::new(step, sine).unwrap());
            let peak = within.values()[12_000..20_000].iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let exact = 1.0
                / ((1.0 + (corners.0 / frequency).powi(4)) * (1.0 + (frequency / corners.1).powi(4))).sqrt();
            assert!((peak / exact - 1.0).abs() < 0.02, "{frequency} Hz: {peak} {exact}");
        }
    }

    #[test]
    fn guide_values_rise_with_frequency() {
        let close = |f: f64, mm: [f64; 3]| {
            foundation_guide_values(f).iter().zip(mm).all(|(found, mm)| (1e3 * found - mm).abs() < 1e-12)
        };
        assert!(close(0.5, [20.0, 5.0, 3.0]) && close(10.0, [20.0, 5.0, 3.0]));
        // halfway between 10 and 50 Hz: 20 + 20/2, 5 + 10/2, 3 + 5/2
        assert!(close(30.0, [30.0, 10.0, 5.5]) && close(50.0, [40.0, 15.0, 8.0]));
        assert!(close(75.0, [45.0, 17.5, 9.0]) && close(250.0, [50.0, 20.0, 10.0]));
    }
}
