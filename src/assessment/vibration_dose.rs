//! Vibration dose value.

use crate::signal::History;

/// VDV = (∫ a_w⁴ dt)^{1/4} [m/s^1.75] of a weighted acceleration [m/s²].
///
/// Accuracy: the integral is Δt Σ a_j⁴, exact for what contains nothing at or above a quarter of the sampling rate; 7e-16
/// for a burst of whole periods (`sine_burst`).
///
/// Source: BS 6472-1:2008, with W_b vertically and W_d horizontally.
pub fn vibration_dose(weighted: &History) -> f64 {
    (weighted.step() * weighted.values().iter().map(|a| a.powi(4)).sum::<f64>()).powf(0.25)
}

/// VDV = (Σ n_i VDV_i⁴)^{1/4} [m/s^1.75] of events, each with its dose [m/s^1.75] and how often it occurs.
///
/// Source: BS 6472-1:2008.
pub fn combined_dose(events: &[(f64, f64)]) -> f64 {
    events.iter().map(|(dose, count)| count * dose.powi(4)).sum::<f64>().powf(0.25)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn sine_burst() {
        // A sin ωt over whole periods of length T, then nothing: VDV = A (3T/8)^{1/4}; measured 7e-16
        let (amplitude, step) = (0.02, 1e-3);
        let values = (0..5000).map(|j| {
            let t = step * f64::from(j);
            if j < 3000 { amplitude * (TAU * 16.0 * t).sin() } else { 0.0 }
        });
        let dose = vibration_dose(&History::new(step, values.collect()).unwrap());
        let exact = amplitude * (3.0 * 3.0 / 8.0f64).powf(0.25);
        assert!((dose / exact - 1.0).abs() < 1e-13, "{dose} {exact}");
        // sixteen of them: twice the dose; as long as sixteen bursts in a row
        assert!((combined_dose(&[(dose, 16.0)]) / (2.0 * exact) - 1.0).abs() < 1e-13);
        assert!((combined_dose(&[(dose, 10.0), (dose, 6.0)]) / (2.0 * exact) - 1.0).abs() < 1e-13);
        assert_eq!(combined_dose(&[]), 0.0);
    }
}
