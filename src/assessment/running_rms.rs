//! Running r.m.s. with exponential averaging.

use crate::signal::History;

/// Time constant of the exponential average.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Averaging {
    /// τ = 0.125 s
    Fast,
    /// τ = 1 s
    Slow,
}

impl Averaging {
    /// τ [s]
    pub fn time_constant(self) -> f64 {
        match self {
            Self::Fast => 0.125,
            Self::Slow => 1.0,
        }
    }

    /// `FAST` or `SLOW`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "FAST",
            Self::Slow => "SLOW",
        }
    }
}

/// v_rms(t) = √( (1/τ) ∫₀ᵗ v²(ξ) e^{−(t−ξ)/τ} dξ ), in the unit of the history; zero at its first sample.
///
/// v² counts as linear between samples, under which the recursion is exact.
///
/// Accuracy: 4e-14 for a step (`step_response`). A sine settles to its r.m.s. whatever the sampling; the ripple about it is
/// short by (2πfΔt)²/3 of itself (`sine_settles`).
///
/// Source: IEC 61672-1 (FAST, SLOW); DIN 45669-1 for KB_F.
pub fn running_rms(history: &History, averaging: Averaging) -> History {
    let ratio = history.step() / averaging.time_constant();
    let kept = (-ratio).exp();
    // (1/τ) ∫₀^Δt e^{−(Δt−ξ)/τ} (1 − ξ/Δt, ξ/Δt) dξ
    let mean = -(-ratio).exp_m1() / ratio;
    let (of_last, of_this) = (mean - kept, 1.0 - mean);
    let (mut square, mut last) = (0.0, None);
    let values = history.values().iter().map(|v| {
        let this = v * v;
        if let Some(last) = last {
            square = kept * square + of_last * last + of_this * this;
        }
        last = Some(this);
        square.sqrt()
    });
    history.with_values(values.collect())
}

/// max v_rms(t), in the unit of the history.
pub fn maximum_running_rms(history: &History, averaging: Averaging) -> f64 {
    running_rms(history, averaging).peak()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn step_response() {
        // v = 3 from t = 0: v_rms = 3 √(1 − e^{−t/τ}); measured 4e-14, rounding over 2000 steps
        for averaging in [Averaging::Fast, Averaging::Slow] {
            for step in [1e-3, 0.05, 0.5] {
                let history = History::new(step, vec![3.0; 2000]).unwrap();
                let rms = running_rms(&history, averaging);
                for (j, v) in rms.values().iter().enumerate() {
                    let exact = 3.0 * (-(-step * j as f64 / averaging.time_constant()).exp_m1()).sqrt();
                    assert!((v - exact).abs() < 1e-13, "{j}: {v} {exact}");
                }
            }
        }
    }

    #[test]
    fn sine_settles() {
        // v_rms² = A²/2 (1 ± r), r = 1/√(1 + (2ωτ)²), straight lines between samples of v² taking (2πfΔt)²/3 off r
        let f = 16.0;
        for per_period in [8, 64] {
            let phase = TAU / f64::from(per_period);
            let values = (0..200 * per_period).map(|j| (phase * f64::from(j)).sin());
            let history = History::new(1.0 / (f * f64::from(per_period)), values.collect()).unwrap();
            let rms = running_rms(&history, Averaging::Fast);
            let end = &rms.values()[100 * per_period as usize..];
            let mean = end.iter().map(|v| v * v).sum::<f64>() / end.len() as f64;
            // measured 3e-16
            assert!((mean - 0.5).abs() < 1e-13, "{mean}");
            let ripple = end.iter().fold(0.0f64, |r, v| r.max((2.0 * v * v - 1.0).abs()));
            let exact = (1.0 - phase * phase / 3.0) / (1.0 + (2.0 * TAU * f * 0.125).powi(2)).sqrt();
            // measured 1.2e-2 and 8e-4: the ripple is that of the lowest order in 2πfΔt
            assert!((ripple / exact - 1.0).abs() < 0.02, "{ripple} {exact}");
            let maximum = maximum_running_rms(&history, Averaging::Fast);
            assert!((maximum - (0.5 * (1.0 + ripple)).sqrt()).abs() < 1e-9);
        }
    }
}
