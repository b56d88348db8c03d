//! Integrals of many functions by one rule: adaptive panels that serve them all.
//!
//! Each function counts by its own scale s_i, the integral of its modulus, and with a phase of its own, so that none hides another:
//!
//! ```text
//! F(x) = Σ_i e^{iφ_i} f_i(x)/s_i          φ_i = 2π i/φ, φ the golden ratio
//! ```
//!
//! is refined until ∫ F is known; its nodes then serve every f_i.

use super::quadrature::{Adaptive, Node, Together, Tolerance};
use num_complex::Complex64;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// The golden ratio: phases in steps of it never meet.
const GOLDEN: f64 = 1.618_033_988_749_895;
/// Functions smaller than this share of the largest are nothing.
const NOTHING: f64 = 1e-100;

/// A rule with the values of every function at its nodes.
#[derive(Clone, Debug)]
pub struct Many {
    /// Abscissa, weight and values of each node, fifteen a panel, ascending.
    pub nodes: Vec<(f64, f64, Vec<Complex64>)>,
    /// Where each panel begins.
    pub from: Vec<f64>,
    /// Estimated error of an integral over the integral of its modulus.
    pub error: f64,
    /// Whether that was as wanted.
    pub converged: bool,
}

/// ∫ f over consecutive `breakpoints`, f the values of all functions at the fifteen nodes of a panel, to `relative` of the integral
/// of each one's modulus, within `max_count` evaluations.
pub fn integrate(
    f: impl Fn(&[f64; 15]) -> [Vec<Complex64>; 15],
    breakpoints: &[f64],
    relative: f64,
    max_count: usize,
) -> Many {
    let kept: RefCell<HashMap<u64, Vec<Complex64>>> = RefCell::new(HashMap::new());
    let mut scales: Vec<f64> = Vec::new();
    // the first panels, for the scales; their values are kept
    let mut first = Together(|x: &[f64; 15]| {
        let values = f(x);
        let spacing = (x[14] - x[0]) / 15.0;
        for value in &values {
            scales.resize(value.len(), 0.0);
            scales.iter_mut().zip(value).for_each(|(sum, v)| *sum += v.norm() * spacing);
        }
        kept.borrow_mut().extend(x.map(f64::to_bits).into_iter().zip(values));
        [Complex64::ZERO; 15]
    });
    Adaptive::new().add(&mut first, breakpoints);
    let least = NOTHING * scales.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let factors: Vec<Complex64> = (0u32..)
        .zip(&scales)
        .map(
            |(i, &s)| {
                if s > least { Complex64::cis(TAU * f64::from(i) / GOLDEN) / s } else { Complex64::ZERO }
            },
        )
        .collect();

    let mut sum = Together(|x: &[f64; 15]| {
        let mut kept = kept.borrow_mut();
        if x.iter().any(|x| !kept.contains_key(&x.to_bits())) {
            kept.extend(x.map(f64::to_bits).into_iter().zip(f(x)));
        }
        x.map(|x| kept[&x.to_bits()].iter().zip(&factors).map(|(v, factor)| v * factor).sum())
    });
    let mut integral = Adaptive::new();
    integral.add(&mut sum, breakpoints);
    // errors of n functions with phases of their own add up like √n
    let most = relative * (scales.len() as f64).sqrt();
    let tolerance = Tolerance { relative: 0.0, absolute: most, max_count };
    let estimate = integral.refine(&mut sum, Complex64::ZERO, tolerance);
    let mut kept = kept.into_inner();
    let from = integral.starts();
    let nodes = integral.into_rule().0.into_iter();
    let nodes =
        nodes.map(|Node { x, weight, .. }| (x, weight, kept.remove(&x.to_bits()).unwrap_or_default()));
    let error = estimate.error / (scales.len() as f64).sqrt();
    Many { nodes: nodes.collect(), from, error, converged: estimate.converged }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_function_is_known() {
        // a narrow peak of a millionth the height of its neighbour: measured 2e-16 and 1e-10
        let peak = |x: f64| 1e-6 / ((x - 0.3).powi(2) + 1e-6);
        let f = |x: &[f64; 15]| x.map(|x| vec![Complex64::from(x.exp()), Complex64::from(1e-6 * peak(x))]);
        let many = integrate(f, &[0.0, 1.0], 1e-9, 10_000);
        assert!(many.converged && many.error <= 1e-9);
        let value = |i: usize| many.nodes.iter().map(|(_, w, v)| v[i].re * w).sum::<f64>();
        assert!((value(0) / (1f64.exp() - 1.0) - 1.0).abs() < 1e-13);
        let exact = 1e-9 * ((0.7e3f64).atan() + (0.3e3f64).atan());
        assert!((value(1) / exact - 1.0).abs() < 1e-8, "{:e}", value(1) / exact - 1.0);
    }
}
