//! The band limitation that KB and the weightings share: second-order Butterworth on both sides.

use num_complex::Complex64;

/// H(f) = s²/(s² + √2 ω₁ s + ω₁²) · ω₂²/(s² + √2 ω₂ s + ω₂²), s = 2πif, of the corners `lower` and `upper` [Hz].
///
/// It forgets as e^{−√2 π lower t}.
pub(super) fn band_limit(frequency: f64, lower: f64, upper: f64) -> Complex64 {
    let side = |ratio: f64| Complex64::new(1.0 - ratio * ratio, std::f64::consts::SQRT_2 * ratio);
    let (below, above) = (frequency / lower, frequency / upper);
    -below * below / side(below) / side(above)
}

/// Seconds until a corner at `lower` [Hz] has forgotten all but 4e-16: √2 π lower T = 35.5.
pub(super) fn memory(lower: f64) -> f64 {
    8.0 / lower
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_power_at_the_corners() {
        // |H|² = 1/(1 + (f₁/f)⁴) · 1/(1 + (f/f₂)⁴); measured 4e-16
        for f in [0.1, 0.8, 5.6, 100.0, 400.0f64] {
            let exact = 1.0 / (1.0 + (0.8 / f).powi(4)) / (1.0 + (f / 100.0).powi(4));
            assert!((band_limit(f, 0.8, 100.0).norm_sqr() / exact - 1.0).abs() < 1e-14, "{f}");
        }
        assert_eq!(band_limit(0.0, 0.8, 100.0).norm(), 0.0);
        assert!((-std::f64::consts::SQRT_2 * std::f64::consts::PI * memory(1.0)).exp() < 4e-16);
    }
}
