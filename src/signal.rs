//! Histories sampled in time, and how their energy spreads over frequency.

use crate::math::fourier::{fast_size, filter, half_spectrum};
use num_complex::Complex64;
use thiserror::Error;

/// Zeros continue a history to this many times its length before its spectrum is taken: samples between its lines.
const PADDING: usize = 8;

/// A quantity sampled at equal steps of time, zero before and after.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    step: f64,
    values: Vec<f64>,
}

impl History {
    /// A history from its sampling `step` [s] and its `values`.
    ///
    /// # Errors
    /// A step that is not positive and finite; no values; a value that is not finite.
    pub fn new(step: f64, values: Vec<f64>) -> Result<Self, SignalError> {
        if !(step > 0.0 && step.is_finite()) {
            return Err(SignalError::Step { step });
        }
        if values.is_empty() {
            return Err(SignalError::Empty);
        }
        if let Some(index) = values.iter().position(|v| !v.is_finite()) {
            return Err(SignalError::Value { index, value: values[index] });
        }
        Ok(Self { step, values })
    }

    /// Sampling step Δt [s].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The samples, the first at t = 0.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// N Δt [s]
    pub fn duration(&self) -> f64 {
        self.step * self.values.len() as f64
    }

    /// The value furthest from zero, as a positive number.
    pub fn peak(&self) -> f64 {
        self.values.iter().fold(0.0, |peak, v| v.abs().max(peak))
    }

    /// ∫ v² dt = Δt Σ v_j² [unit² s].
    ///
    /// Exact for what contains nothing at or above half the sampling rate.
    pub fn energy(&self) -> f64 {
        self.step * self.values.iter().map(|v| v * v).sum::<f64>()
    }

    /// The history through a linear filter `transfer` H(f) [f in Hz, f ≥ 0], for e^{+iωt}.
    ///
    /// H is applied in the frequency domain, so it is met exactly up to half the sampling rate, without the warping of a
    /// digital filter. `memory` [s]: how long H remembers; zeros of that length keep the end of the history from
    /// coming back at its beginning, which is then e^{−`memory`·decay} of it. The history counts as band-limited:
    /// a jump of it, also at its ends, rings at half the sampling rate, before and after.
    ///
    /// Accuracy: 1.4e-15 for the delay of a smooth pulse (`filter_delays_a_pulse`).
    pub fn filtered(&self, memory: f64, transfer: impl Fn(f64) -> Complex64) -> Self {
        let zeros = (memory.max(0.0) / self.step).ceil() as usize;
        let count = fast_size(self.values.len() + zeros);
        Self { step: self.step, values: filter(&self.values, self.step, count, transfer) }
    }

    /// Other finite values at the same times.
    pub(crate) fn with_values(&self, values: Vec<f64>) -> Self {
        Self { step: self.step, values }
    }
}

/// A one-sided energy spectral density S(f) [unit² s/Hz], linear between the samples of a grid of frequencies.
///
/// ∫ v² dt = ∫₀^∞ S df with S = 2 |v̂|², v̂ = ∫ v e^{−iωt} dt; in terms of ω, S df = (1/π) |v̂|² dω.
#[derive(Clone, Debug, PartialEq)]
pub struct EnergySpectrum {
    frequencies: Vec<f64>,
    density: Vec<f64>,
}

impl EnergySpectrum {
    /// A spectrum from increasing `frequencies` [Hz] and its `density` there [unit² s/Hz]; for a velocity spectrum v̂ [m],
    /// 2 |v̂|² [m²].
    ///
    /// # Errors
    /// Fewer than two frequencies, or not as many densities; frequencies that are negative, not finite or do not increase;
    /// a density that is negative or not finite.
    pub fn new(frequencies: Vec<f64>, density: Vec<f64>) -> Result<Self, SignalError> {
        if frequencies.len() < 2 || frequencies.len() != density.len() {
            return Err(SignalError::Lengths { frequencies: frequencies.len(), densities: density.len() });
        }
        let rises = |index: usize| match index {
            0 => frequencies[0] >= 0.0,
            _ => frequencies[index] > frequencies[index - 1],
        };
        let sound = |index: &usize| rises(*index) && frequencies[*index].is_finite();
        if let Some(index) = (0..frequencies.len()).find(|index| !sound(index)) {
            return Err(SignalError::Frequencies { index, frequency: frequencies[index] });
        }
        if let Some(index) = density.iter().position(|s| !(*s >= 0.0 && s.is_finite())) {
            return Err(SignalError::Density { frequency: frequencies[index], density: density[index] });
        }
        Ok(Self { frequencies, density })
    }

    /// The spectrum of a history: 2 |v̂(f_n)|² at f_n = n/(N Δt), N at least eight times its samples.
    ///
    /// Accuracy: the integral over all frequencies is [`History::energy`] within 2e-15 (`parseval`).
    pub fn of(history: &History) -> Self {
        let count = fast_size(PADDING * history.values.len());
        let df = 1.0 / (count as f64 * history.step);
        let spectrum = half_spectrum(&history.values, history.step, count);
        Self {
            frequencies: (0..spectrum.len()).map(|n| n as f64 * df).collect(),
            density: spectrum.iter().map(|v| 2.0 * v.norm_sqr()).collect(),
        }
    }

    /// The frequencies [Hz].
    pub fn frequencies(&self) -> &[f64] {
        &self.frequencies
    }

    /// The density at the frequencies [unit² s/Hz].
    pub fn density(&self) -> &[f64] {
        &self.density
    }

    /// ∫ S df from `lower` to `upper` [Hz], in unit² s; exact for the density linear between its samples, wherever the
    /// two limits fall.
    ///
    /// # Errors
    /// A limit outside the frequencies of the spectrum, or `upper` below `lower`.
    pub fn between(&self, lower: f64, upper: f64) -> Result<f64, SignalError> {
        let (from, to) = (self.frequencies[0], self.frequencies[self.frequencies.len() - 1]);
        if !(from <= lower && lower <= upper && upper <= to) {
            return Err(SignalError::Outside { lower, upper, from, to });
        }
        let first = self.frequencies.partition_point(|f| *f <= lower).saturating_sub(1);
        let pieces = self.frequencies.windows(2).zip(self.density.windows(2)).skip(first);
        Ok(pieces
            .take_while(|(f, _)| f[0] < upper)
            .map(|(f, s)| {
                let (a, b) = (f[0].max(lower), f[1].min(upper));
                // the mean of a straight line over [a, b] is its value in the middle
                let middle = (0.5 * (a + b) - f[0]) / (f[1] - f[0]);
                (b - a) * (s[0] + (s[1] - s[0]) * middle)
            })
            .sum())
    }

    /// ∫ S df over all frequencies of the spectrum [unit² s].
    pub fn total(&self) -> f64 {
        let pieces = self.frequencies.windows(2).zip(self.density.windows(2));
        pieces.map(|(f, s)| 0.5 * (f[1] - f[0]) * (s[0] + s[1])).sum()
    }
}

/// Why a history or a spectrum cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SignalError {
    /// The sampling step has no meaning.
    #[error("the sampling step is {step} s: it must be positive and finite")]
    Step {
        /// [s]
        step: f64,
    },
    /// Nothing was sampled.
    #[error("the history has no values: give at least one")]
    Empty,
    /// A value is not a number.
    #[error("value number {index} of the history is {value}: it must be finite")]
    Value {
        /// From 0.
        index: usize,
        /// As given.
        value: f64,
    },
    /// The lengths of a spectrum do not fit.
    #[error("the spectrum has {frequencies} frequencies and {densities} densities: give two or more of both")]
    Lengths {
        /// How many.
        frequencies: usize,
        /// How many.
        densities: usize,
    },
    /// The frequencies are no grid.
    #[error(
        "frequency number {index} of the spectrum is {frequency} Hz: frequencies must be finite, not negative and increase"
    )]
    Frequencies {
        /// From 0.
        index: usize,
        /// [Hz]
        frequency: f64,
    },
    /// A density has no meaning.
    #[error("the energy density at {frequency} Hz is {density}: it must be finite and not negative")]
    Density {
        /// [Hz]
        frequency: f64,
        /// [unit² s/Hz]
        density: f64,
    },
    /// The spectrum does not reach far enough.
    #[error(
        "the range {lower} to {upper} Hz is not within the spectrum, {from} to {to} Hz: widen the spectrum or leave out the range"
    )]
    Outside {
        /// [Hz]
        lower: f64,
        /// [Hz]
        upper: f64,
        /// First frequency of the spectrum [Hz].
        from: f64,
        /// Last frequency of the spectrum [Hz].
        to: f64,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parseval() {
        // any samples: energy in time = energy in frequency; measured 2e-15
        let values: Vec<f64> = (0..1001).map(|j| (0.3 * f64::from(j * j)).sin()).collect();
        let history = History::new(0.004, values).unwrap();
        let spectrum = EnergySpectrum::of(&history);
        assert!((spectrum.total() / history.energy() - 1.0).abs() < 1e-13);
    }

    #[test]
    fn limits_between_samples_are_exact() {
        // S = 3 + 2f on an uneven grid: ∫ = 3(b − a) + b² − a²
        let f = vec![0.0, 0.3, 1.0, 2.5, 4.0];
        let spectrum = EnergySpectrum::new(f.clone(), f.iter().map(|f| 3.0 + 2.0 * f).collect()).unwrap();
        for (a, b) in [(0.0, 4.0), (0.1, 0.2), (0.1, 3.9), (1.0, 2.5), (0.3, 0.3), (4.0, 4.0)] {
            let exact = 3.0 * (b - a) + b * b - a * a;
            assert!((spectrum.between(a, b).unwrap() - exact).abs() < 1e-14, "{a} {b}");
        }
        assert!((spectrum.total() - 28.0).abs() < 1e-14);
        assert!(matches!(spectrum.between(0.1, 4.1), Err(SignalError::Outside { .. })));
        assert!(matches!(spectrum.between(2.0, 1.0), Err(SignalError::Outside { .. })));
    }

    #[test]
    fn refusals() {
        assert!(matches!(History::new(0.0, vec![1.0]), Err(SignalError::Step { .. })));
        assert!(matches!(History::new(f64::NAN, vec![1.0]), Err(SignalError::Step { .. })));
        assert_eq!(History::new(1.0, vec![]), Err(SignalError::Empty));
        assert!(matches!(History::new(1.0, vec![0.0, f64::NAN]), Err(SignalError::Value { index: 1, .. })));
        let spectrum = |f: &[f64], s: &[f64]| EnergySpectrum::new(f.to_vec(), s.to_vec());
        assert!(spectrum(&[0.0, 1.0], &[0.0, 0.0]).is_ok());
        assert!(matches!(spectrum(&[0.0], &[0.0]), Err(SignalError::Lengths { .. })));
        for f in [[-1.0, 1.0], [1.0, 1.0], [0.0, f64::INFINITY], [f64::NAN, 1.0]] {
            assert!(matches!(spectrum(&f, &[0.0, 0.0]), Err(SignalError::Frequencies { .. })), "{f:?}");
        }
        assert!(matches!(spectrum(&[0.0, 1.0], &[0.0, -1.0]), Err(SignalError::Density { .. })));
    }
}
