//! ∫ f g over a panel, f known at its fifteen Kronrod nodes, g a sum of oscillations known everywhere.
//!
//! ```text
//! ∫ f g dx ≈ Σ_i W_i f(x_i)        W_i = Σ_m w_m ℓ_i(ξ_m) g(ξ_m)
//! ```
//!
//! ℓ_i are Lagrange's polynomials of the nodes, ξ_m and w_m the Kronrod rule on as many parts of the panel as g needs: f is asked
//! no more often for g oscillating faster.

use super::quadrature::kronrod;
use num_complex::Complex64;
use std::ops::Range;

/// Radians of g on one part: fifteen nodes integrate them to 1e-13.
const TURN: f64 = 14.0;

/// A panel with the nodes ξ_m for what oscillates on it.
pub struct Oscillating {
    /// ξ_m
    pub nodes: Vec<f64>,
    /// w_m ℓ_i(ξ_m), i along each row.
    weights: Vec<[f64; 15]>,
}

impl Oscillating {
    /// The panel between `ends`, for g of at most `rate` radians per unit of x.
    pub fn new(ends: Range<f64>, rate: f64) -> Self {
        let width = ends.end - ends.start;
        let parts = (width * rate / TURN).ceil().max(1.0);
        let (x, _) = kronrod(ends.start, ends.end);
        let of = |i: usize| (0..15).filter(move |j| *j != i);
        // over the width, or the products leave the range of numbers
        let scale: [f64; 15] = std::array::from_fn(|i| of(i).map(|j| width / (x[i] - x[j])).product::<f64>());
        let lagrange =
            |xi: f64| std::array::from_fn(|i| scale[i] * of(i).map(|j| (xi - x[j]) / width).product::<f64>());
        let (mut nodes, mut weights) = (Vec::new(), Vec::new());
        for part in 0..parts as usize {
            let at = |part: f64| ends.start + width * part / parts;
            let (xi, w) = kronrod(at(part as f64), at(part as f64 + 1.0));
            nodes.extend(xi);
            let rows = xi.iter().zip(w).map(|(&xi, w)| {
                let row: [f64; 15] = lagrange(xi);
                row.map(|l| w * l)
            });
            weights.extend(rows);
        }
        Self { nodes, weights }
    }

    /// W_i of g with the values `g` at the nodes.
    pub fn weights(&self, g: impl Iterator<Item = Complex64>) -> [Complex64; 15] {
        let mut sums = [Complex64::ZERO; 15];
        for (g, row) in g.zip(&self.weights) {
            sums.iter_mut().zip(row).for_each(|(sum, weight)| *sum += g * weight);
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_times_fast_oscillations_are_exact() {
        // ∫₋₁³ (1 + x)¹⁴ e^{iωx} dx by parts, ω = 200: 57 parts
        let omega = 200.0;
        let exact = |x: f64| {
            let (mut term, mut sum) =
                (Complex64::cis(omega * x) / Complex64::new(0.0, omega), Complex64::ZERO);
            for n in 0..=14 {
                sum += term * (1.0 + x).powi(14 - n);
                term *= -f64::from(14 - n) / Complex64::new(0.0, omega);
            }
            sum
        };
        let panel = Oscillating::new(-1.0..3.0, omega);
        assert_eq!(panel.nodes.len(), 58 * 15);
        let weights = panel.weights(panel.nodes.iter().map(|x| Complex64::cis(omega * x)));
        let (x, _) = kronrod(-1.0, 3.0);
        let found: Complex64 = weights.iter().zip(x).map(|(w, x)| w * (1.0 + x).powi(14)).sum();
        let exact = exact(3.0) - exact(-1.0);
        // measured 1.5e-12: rounding of ℓ_i times values of 4¹⁴
        assert!((found - exact).norm() < 2e-11 * exact.norm(), "{:e}", (found - exact).norm() / exact.norm());
    }
}
