//! Fourier transforms from wavenumbers to positions, and of histories: the only file that knows signs, scales and wrap.
//!
//! u(x, y) = (1/4π²) ∬ ũ(β_x, β_y) e^{i(β_x x + β_y y)} dβ_x dβ_y, sampled at β = nΔβ, Δβ = 2π/L: the field comes out
//! periodic with periods L_x, L_y and band-limited to |β| ≤ π/spacing.

use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftDirection, FftPlanner};
use std::cell::RefCell;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Lines that are transformed side by side.
const ABREAST: usize = 8;

/// A uniform axis of positions with the wavenumbers of its transform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// First position [m].
    pub from: f64,
    /// Spacing [m].
    pub step: f64,
    /// Samples in one period; even, with small prime factors.
    pub period_count: usize,
}

impl Axis {
    /// An axis of positions from `from` with spacing `step`, whose period is at least `period` [m].
    pub fn new(from: f64, step: f64, period: f64) -> Self {
        Self { from, step, period_count: fast_size((period / step).ceil().max(2.0) as usize) }
    }

    /// The same period with `finer` samples to one of these.
    pub fn refined(self, finer: usize) -> Self {
        Self { step: self.step / finer as f64, period_count: self.period_count * finer, ..self }
    }

    /// L [m]
    pub fn period(&self) -> f64 {
        self.step * self.period_count as f64
    }

    /// Δβ = 2π/L [rad/m]
    pub fn beta_step(&self) -> f64 {
        TAU / self.period()
    }

    /// Wavenumber number `n` of the full transform, negative in its upper half [rad/m].
    pub fn beta(&self, n: usize) -> f64 {
        let signed = if n <= self.period_count / 2 { n as f64 } else { n as f64 - self.period_count as f64 };
        signed * self.beta_step()
    }

    /// π/step [rad/m]: the largest wavenumber.
    pub fn beta_max(&self) -> f64 {
        PI / self.step
    }

    /// e^{iβ·from}: shifts the first sample to `from`.
    fn shift(&self, n: usize) -> Complex64 {
        Complex64::cis(self.beta(n) * self.from)
    }
}

/// The smallest even number ≥ `least` of the form 2ᵃ3ᵇ5ᶜ.
pub fn fast_size(least: usize) -> usize {
    let least = least.max(2);
    let mut best = least.checked_next_power_of_two().unwrap_or(usize::MAX - 1);
    // every 3ᵇ5ᶜ with the smallest power of two that reaches `least`
    let mut fives = 1usize;
    while fives <= best {
        let mut odd = fives;
        while odd <= best {
            let twos = least.div_ceil(odd).max(2).next_power_of_two();
            best = best.min(odd.saturating_mul(twos));
            let Some(next) = odd.checked_mul(3) else { break };
            odd = next;
        }
        let Some(next) = fives.checked_mul(5) else { break };
        fives = next;
    }
    best
}

/// The positions of a field that are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// Every so-manieth position of the axes (y, x), which their `period_count` is a multiple of.
    pub thinning: (usize, usize),
    /// Which of these y, in any order.
    pub lines: &'a [usize],
}

/// Real fields u(y, x), one for each of the spectra that `row` fills, at the `wanted` y and all x that the thinning leaves.
///
/// `row(n, out)` writes ũ(β_x, β_y) of β_x number `n` (0 ≤ n < `rows`) into `out[field]`, over all β_y numbers, whatever
/// stands there; rows from `rows` on are zero, and negative β_x follow from ũ(−β_x, −β_y) = conj ũ. Rows are filled in parallel; memory
/// is fields × lines × (rows complex + x real).
///
/// # Errors
/// The first one of `row`.
pub fn inverse_2d<E: Send>(
    x: Axis,
    y: Axis,
    rows: usize,
    fields: usize,
    wanted: Wanted,
    row: impl Fn(usize, &mut [Vec<Complex64>]) -> Result<(), E> + Sync,
) -> Result<Vec<Array2<f64>>, E> {
    let n_y = y.period_count;
    let rows = rows.min(x.period_count / 2 + 1);
    // of every m-th position the spectra N/m apart are one: Σ_q ũ(n + qN/m)
    let (less_y, n_x) = (n_y / wanted.thinning.0, x.period_count / wanted.thinning.1);
    let along_y = plan(less_y, FftDirection::Inverse);
    let scale = x.beta_step() * y.beta_step() / (4.0 * PI * PI);
    let shift_y: Vec<Complex64> = (0..n_y).map(|n| y.shift(n)).collect();
    let buffers = || vec![vec![Complex64::ZERO; n_y]; fields];
    // one β_x after another in parallel: ũ(β_x, β_y) → (β_x, y), the wanted y only
    let half: Vec<Vec<Vec<Complex64>>> = (0..rows)
        .into_par_iter()
        .map_init(buffers, |out, n| {
            row(n, out)?;
            let shift_x = x.shift(n) * scale;
            let transform = |spectrum: &mut Vec<Complex64>| {
                for (value, shift) in spectrum.iter_mut().zip(&shift_y) {
                    *value *= shift * shift_x;
                }
                let (folded, beyond) = spectrum.split_at_mut(less_y);
                for alias in beyond.chunks(less_y) {
                    folded.iter_mut().zip(alias).for_each(|(sum, value)| *sum += value);
                }
                along_y.process(folded);
                wanted.lines.iter().map(|line| folded[*line]).collect()
            };
            Ok(out.iter_mut().map(transform).collect())
        })
        .collect::<Result<_, E>>()?;
    let lines = wanted.lines.len();
    Ok((0..fields).map(|field| real_lines(&half, field, (lines, n_x), x.period_count)).collect())
}

/// (β_x, y) → (x, y) of one `field`: so many lines × every so-manieth x, `count` (lines, x), of a period of `whole` samples, from the `half`
/// spectra, β_x × fields × lines.
fn real_lines(
    half: &[Vec<Vec<Complex64>>],
    field: usize,
    count: (usize, usize),
    whole: usize,
) -> Array2<f64> {
    let n_x = count.1;
    let along_x = plan_real(n_x).1;
    let mut result = Array2::zeros(count);
    // a few lines at once: their values stand side by side in every row
    result.as_slice_mut().unwrap_or(&mut []).par_chunks_mut(ABREAST * n_x).enumerate().for_each_init(
        || (vec![along_x.make_input_vec(); ABREAST], along_x.make_scratch_vec()),
        |(spectra, scratch), (block, targets)| {
            spectra.iter_mut().for_each(|spectrum| spectrum.fill(Complex64::ZERO));
            for (n, row) in half.iter().enumerate() {
                let place = n % n_x;
                // its partner −β_x, where that folds into the half that is kept
                let partner = (n_x - place) % n_x;
                let folds = partner <= n_x / 2 && n > 0 && 2 * n != whole;
                for (spectrum, value) in spectra.iter_mut().zip(&row[field][ABREAST * block..]) {
                    if place <= n_x / 2 {
                        spectrum[place] += value;
                    }
                    if folds {
                        spectrum[partner] += value.conj();
                    }
                }
            }
            for (spectrum, target) in spectra.iter_mut().zip(targets.chunks_mut(n_x)) {
                // a real field has real ends of its half-spectrum
                spectrum[0].im = 0.0;
                spectrum[n_x / 2].im = 0.0;
                // never fails: the lengths are those of the plan
                let _ = along_x.process_with_scratch(spectrum, target, scratch);
            }
        },
    );
    result
}

/// Harmonics g_n = (1/N) Σ g(θ_i) e^{−inθ_i} of N samples at θ_i = 2π(i + ½)/N: n = 0, 1, … and, from the end, n = −1, −2, …
///
/// The half step keeps samples off θ = 0 and ±π/2 (N a multiple of 4).
pub fn harmonics(mut samples: Vec<Complex64>) -> Vec<Complex64> {
    let count = samples.len();
    plan(count, FftDirection::Forward).process(&mut samples);
    for (i, value) in samples.iter_mut().enumerate() {
        let n = if i <= count / 2 { i as f64 } else { i as f64 - count as f64 };
        *value *= Complex64::cis(-PI * n / count as f64) / count as f64;
    }
    samples
}

/// Σ g_n e^{inφ_i} at φ_i = 2πi/N from N harmonics in the order of [`harmonics`].
pub fn from_harmonics(mut harmonics: Vec<Complex64>) -> Vec<Complex64> {
    plan(harmonics.len(), FftDirection::Inverse).process(&mut harmonics);
    harmonics
}

/// A transform of `size` numbers, from a planner that keeps the factors of every size it has seen: they cost more than the transform.
fn plan(size: usize, direction: FftDirection) -> Arc<dyn Fft<f64>> {
    thread_local! {
        static PLANS: RefCell<FftPlanner<f64>> = RefCell::new(FftPlanner::new());
    }
    PLANS.with_borrow_mut(|plans| plans.plan_fft(size, direction))
}

/// The same of `size` real numbers, to and from half a spectrum.
fn plan_real(size: usize) -> (Arc<dyn RealToComplex<f64>>, Arc<dyn ComplexToReal<f64>>) {
    thread_local! {
        static PLANS: RefCell<RealFftPlanner<f64>> = RefCell::new(RealFftPlanner::new());
    }
    PLANS.with_borrow_mut(|plans| (plans.plan_fft_forward(size), plans.plan_fft_inverse(size)))
}

/// Σ_j u_j e^{−2πi n j/N}, n = 0 … N/2, of `values` times `scale`, continued by zeros to N = `count`.
fn forward(values: &[f64], scale: f64, count: usize) -> Vec<Complex64> {
    let transform = plan_real(count).0;
    let mut samples: Vec<f64> = values.iter().map(|u| u * scale).collect();
    samples.resize(count, 0.0);
    let mut spectrum = transform.make_output_vec();
    // never fails: the lengths are those of the plan
    let _ = transform.process(&mut samples, &mut spectrum);
    spectrum
}

/// Σ_n û_n e^{2πi n j/N} of all n, j = 0 … N − 1, N = `count`, from those of n = 0 … N/2, whose ends are taken as real.
fn inverse(mut spectrum: Vec<Complex64>, count: usize) -> Vec<f64> {
    let transform = plan_real(count).1;
    // a real history has real ends of its half-spectrum
    for end in [0, count / 2] {
        spectrum[end].im = 0.0;
    }
    let mut values = transform.make_output_vec();
    // never fails: the lengths are those of the plan
    let _ = transform.process(&mut spectrum, &mut values);
    values
}

/// û(f_n) = Δt Σ_j u_j e^{−2πi n j/N}, f_n = n/(N Δt), n = 0 … N/2, of samples `values` at t_j = j Δt, Δt = `step` [s],
/// continued by zeros to N = `period_count` samples (even, at least as many as there are): ∫ u e^{−iωt} dt of the history.
pub fn half_spectrum(values: &[f64], step: f64, period_count: usize) -> Vec<Complex64> {
    forward(values, step, period_count)
}

/// The reverse: u(t_j) = ∫ û e^{2πift} df at t_j = j Δt, Δt = `step` [s], j = 0 … N − 1, N = `period_count` (even), from û(f_n),
/// n = 0 … N/2, or fewer: the rest is zero. The history repeats after N Δt.
pub fn from_half_spectrum(spectrum: &[Complex64], step: f64, period_count: usize) -> Vec<f64> {
    let scale = 1.0 / (step * period_count as f64);
    let mut half: Vec<Complex64> = spectrum.iter().map(|u| u * scale).collect();
    half.resize(period_count / 2 + 1, Complex64::ZERO);
    inverse(half, period_count)
}

/// ∫ û(f) H(f) e^{2πift} df: `values` sampled at `step` [s], continued by zeros to `period_count` samples (even), through the
/// filter `transfer` H(f), f ≥ 0 [Hz]; H(−f) = conj H(f). As many samples come back as went in.
///
/// What H remembers for longer than the zeros last comes back at the beginning.
pub fn filter(
    values: &[f64],
    step: f64,
    period_count: usize,
    transfer: impl Fn(f64) -> Complex64,
) -> Vec<f64> {
    let mut spectrum = forward(values, 1.0 / period_count as f64, period_count);
    let df = 1.0 / (period_count as f64 * step);
    for (n, value) in spectrum.iter_mut().enumerate() {
        *value *= transfer(n as f64 * df);
    }
    let mut filtered = inverse(spectrum, period_count);
    filtered.truncate(values.len());
    filtered
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_spectrum_of_a_decay() {
        // u = e^{−pt} from t = 0, û = 1/(p + iω), with half the first sample: the sum is off by |p + iω| Δt²/12,
        // met within 1.5e-5
        let (p, step) = (10.0, 1e-3);
        let mut values: Vec<f64> = (0..4000).map(|j| (-p * step * f64::from(j)).exp()).collect();
        values[0] *= 0.5;
        let spectrum = half_spectrum(&values, step, 8000);
        assert_eq!(spectrum.len(), 4001);
        for n in [0, 1, 8, 40] {
            let s = Complex64::new(p, TAU * n as f64 / 8.0);
            let error = (spectrum[n] - 1.0 / s).norm();
            assert!((error / (s.norm() * step * step / 12.0) - 1.0).abs() < 1e-3, "{n}: {error:e}");
        }
    }

    #[test]
    fn half_spectrum_and_back() {
        let values: Vec<f64> = (0..40).map(|j| (0.3 * f64::from(j * j)).sin()).collect();
        let back = from_half_spectrum(&half_spectrum(&values, 0.01, 40), 0.01, 40);
        for (a, b) in back.iter().zip(&values) {
            // rounding
            assert!((a - b).abs() < 1e-14);
        }
    }

    #[test]
    fn filter_delays_a_pulse() {
        // H = e^{−2πif·0.25}: a smooth pulse comes 0.25 s later; measured 1.4e-15
        let pulse = |t: f64| (-0.5 * ((t - 1.0) / 0.05).powi(2)).exp();
        let values: Vec<f64> = (0..200).map(|j| pulse(0.01 * f64::from(j))).collect();
        let later = filter(&values, 0.01, 400, |f| Complex64::cis(-TAU * f * 0.25));
        for (j, u) in later.iter().enumerate() {
            assert!((u - pulse(0.01 * j as f64 - 0.25)).abs() < 1e-14, "{j}");
        }
    }

    #[test]
    fn gaussian_comes_back_at_its_place() {
        // u = e^{−(x−1)²/2 − y²}, ũ = 2π/√2 · e^{−iβ_x} e^{−β_x²/2 − β_y²/4}; measured 3e-15
        let x = Axis::new(-5.0, 0.25, 30.0);
        let y = Axis::new(-3.0, 0.2, 20.0);
        for (thinning, lines) in [((1, 1), vec![0, 10, 15, 30]), ((2, 3), vec![9, 0, 1, 2, 3, 4, 5, 6, 7, 8])]
        {
            let wanted = Wanted { thinning, lines: &lines };
            let fields = inverse_2d(x, y, usize::MAX, 1, wanted, |n, out| {
                let beta_x = x.beta(n);
                for (m, value) in out[0].iter_mut().enumerate() {
                    let beta_y = y.beta(m);
                    *value = Complex64::cis(-beta_x)
                        * (PI * 2.0f64.sqrt() * (-0.5 * beta_x * beta_x - 0.25 * beta_y * beta_y).exp());
                }
                Ok::<(), ()>(())
            })
            .unwrap();
            assert_eq!(fields[0].dim(), (lines.len(), 120 / thinning.1));
            for ((j, i), value) in fields[0].indexed_iter() {
                let x = -5.0 + 0.25 * (i * thinning.1) as f64;
                let y = -3.0 + 0.2 * (lines[j] * thinning.0) as f64;
                // of the period that begins at −5 all but the last metres, where the next one begins
                if x < 20.0 {
                    assert!((value - (-0.5 * (x - 1.0).powi(2) - y * y).exp()).abs() < 1e-13, "{x} {y}");
                }
            }
        }
    }

    #[test]
    fn harmonics_of_a_cosine() {
        // g = 3 + 2 cos 5θ + i sin θ: g_0 = 3, g_±5 = 1, g_±1 = ±½
        let samples = (0..64)
            .map(|i| {
                let theta = TAU * (f64::from(i) + 0.5) / 64.0;
                Complex64::new(3.0 + 2.0 * (5.0 * theta).cos(), theta.sin())
            })
            .collect();
        let g = harmonics(samples);
        for (n, expected) in [(0, 3.0), (5, 1.0), (59, 1.0), (1, 0.5), (63, -0.5), (2, 0.0)] {
            assert!((g[n] - expected).norm() < 1e-14, "{n}: {}", g[n]);
        }
        assert!((from_harmonics(g)[0] - 5.0).norm() < 1e-13);
    }

    #[test]
    fn sizes_are_even_and_smooth() {
        assert_eq!([fast_size(7), fast_size(17), fast_size(1024), fast_size(1025)], [8, 18, 1024, 1080]);
        for least in 1..3000 {
            let mut rest = fast_size(least);
            assert!(rest >= least && rest.is_multiple_of(2));
            for factor in [2, 3, 5] {
                while rest.is_multiple_of(factor) {
                    rest /= factor;
                }
            }
            assert_eq!(rest, 1);
        }
        // at once, however large
        assert!(fast_size(60_000_000_001) >= 60_000_000_001);
    }
}
