//! Sums of waves of any wavenumbers at many uniform positions by one fast transform: each wave is spread over a fine grid of
//! wavenumbers by a Gaussian, whose transform is then divided out.
//!
//! ```text
//! e^{ikθ} ≈ e^{τk²}/√(4πτ) · Δφ Σ_m e^{−(φ_m − θ)²/4τ} e^{ikφ_m},  φ_m = mΔφ, Δφ = 2π/M
//! ```
//!
//! Source: Greengard & Lee 2004, SIAM Review 46(3), with twice as many points as positions.

use super::fourier::{fast_size, from_harmonics};
use super::lanes::{LANES, exp, sin_cos};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Points of the grid to which one wave is spread: three times eight.
pub(crate) const SPREAD: usize = 24;
/// (φ_m − θ)²/4τ over the square of the distance in points, where τ = 4π · 12/(3 M²) balances what is cut off against what wraps.
const DECAY: f64 = 1.5 * PI / SPREAD as f64;

/// Re Σ u e^{iβx} over `waves` (β, u) at `count` positions from `from` in steps of `step`.
///
/// Accuracy: 1e-10 of Σ |u| (test `equals_the_sum`).
pub(crate) fn sum_of_waves(
    waves: impl Iterator<Item = (f64, Complex64)> + Clone,
    from: f64,
    step: f64,
    count: usize,
) -> Vec<f64> {
    let points = fast_size(2 * count.max(SPREAD));
    let middle = count / 2;
    let grid = dispatch!(Level::new(), simd => spread(simd, waves.clone(), from + step * middle as f64, step, points));
    let sums = from_harmonics(grid);
    // e^{τk²} Δφ/√(4πτ), 4τ = Δφ²/DECAY
    let spacing = TAU / points as f64;
    let (tau, scale) = (0.25 * spacing * spacing / DECAY, (DECAY / PI).sqrt());
    let position = |i: usize| {
        let k = i as f64 - middle as f64;
        sums[(i + points - middle) % points].re * scale * (tau * k * k).exp()
    };
    (0..count).map(position).collect()
}

/// The `waves`, each with its phase at `centre`, on the grid.
#[inline(always)]
fn spread<S: Simd>(
    simd: S,
    mut waves: impl Iterator<Item = (f64, Complex64)>,
    centre: f64,
    step: f64,
    points: usize,
) -> Vec<Complex64> {
    // what is spread beyond the end is folded back
    let (mut re, mut im) = (vec![0.0; points + SPREAD], vec![0.0; points + SPREAD]);
    let per_radian = step * points as f64 / TAU;
    loop {
        let eight: [Option<(f64, Complex64)>; LANES] = std::array::from_fn(|_| waves.next());
        let (sin, cos) = sin_cos(f64x8::from_fn(simd, |i| eight[i].map_or(0.0, |(beta, _)| beta * centre)));
        for (i, wave) in eight.iter().enumerate() {
            let Some((beta, u)) = wave else { break };
            let u = u * Complex64::new(cos[i], sin[i]);
            let place = (beta * per_radian).rem_euclid(points as f64);
            let below = place.floor();
            let first = below as usize % points;
            for part in 0..SPREAD / LANES {
                let nearest = place - below + (SPREAD / 2 - 1) as f64 - (LANES * part) as f64;
                let distance = f64x8::from_fn(simd, |i| i as f64) - nearest;
                let weight = exp(distance * distance * -DECAY);
                let range = first + LANES * part..first + LANES * (part + 1);
                let (re, im) = (&mut re[range.clone()], &mut im[range]);
                (f64x8::from_slice(simd, re) + weight * u.re).store_slice(re);
                (f64x8::from_slice(simd, im) + weight * u.im).store_slice(im);
            }
        }
        if eight[LANES - 1].is_none() {
            break;
        }
    }
    // the first point of the arrays is SPREAD/2 − 1 below that of the grid
    let mut grid = vec![Complex64::ZERO; points];
    for (i, (re, im)) in re.into_iter().zip(im).enumerate() {
        grid[(i + points - (SPREAD / 2 - 1)) % points] += Complex64::new(re, im);
    }
    grid
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_the_sum() {
        // wavenumbers of both signs, beyond π/step too, where they alias alike
        let wave = |i: i32| {
            let t = f64::from(i);
            (-50.0 + 100.0 * (1.7 * t).sin().powi(3), Complex64::new((2.3 * t).cos(), (0.7 * t).sin()))
        };
        let waves: Vec<_> = (0..501).map(wave).chain([(0.0, Complex64::ONE)]).collect();
        let total: f64 = waves.iter().map(|(_, u)| u.norm()).sum();
        for (from, step, count) in [(-60.0, 0.1, 901), (3.0, 0.05, 64), (-2.0, 0.3, 7), (0.0, 1.0, 1)] {
            let found = sum_of_waves(waves.iter().copied(), from, step, count);
            assert_eq!(found.len(), count);
            for (i, found) in found.iter().enumerate() {
                let x = from + step * i as f64;
                let sum: Complex64 = waves.iter().map(|(beta, u)| u * Complex64::cis(beta * x)).sum();
                // measured 2e-11
                assert!((found - sum.re).abs() < 1e-10 * total, "{i}: {found} {}", sum.re);
            }
        }
    }
}
