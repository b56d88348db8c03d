//! Peak particle velocity of one component.

use crate::signal::History;

/// PPV = max |v(t)| [m/s] of one component of the velocity, unweighted.
///
/// Accuracy: the largest sample; of a sine of frequency f it is at worst cos(πf Δt) of the peak, 0.95 at ten samples per
/// period (`largest_sample`).
///
/// Source: DIN 4150-3, |v|_i,max.
pub fn peak_velocity(velocity: &History) -> f64 {
    velocity.peak()
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
}
