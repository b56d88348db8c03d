//! Filon's rule on uneven samples: parabolas between β = s sinh t, dense where the waves are, its slow tail taken out.
//!
//! Halving the steps of t changes the sum by fifteen times the error that is left, as the rule is of fourth order.
//!
//! Source: Eqs (39)–(42), corrected.

use super::fourier::Rest;
use super::uniform::Uniform;
use crate::math::filon::quadratic;
use crate::rail::{Answer, Drive, RailError, Receptance};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

const NAME: &str = "filon";
/// Wanted, relative to the receptance at the load.
const ACCURACY: f64 = 1e-8;
/// Samples allowed.
const MOST: usize = 1 << 21;

/// A rail on springs that answers by Filon's rule.
pub struct Filon<'a>(pub(super) Uniform<'a>);

impl Receptance for Filon<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        self.0.check(Drive { omega, speed: 0.0 })?;
        let rest = Rest::new(self.0.tower(NAME)?, omega).ok_or(self.0.unknown(NAME))?;
        // the force first, which says how large the answers are
        let places: Vec<f64> = std::iter::once(0.0).chain(x.iter().map(|x| x - from)).collect();
        let tail: Vec<Complex64> = places.iter().map(|x| rest.tail.at(*x)).collect();
        let end = rest.end(0.01 * ACCURACY, tail[0].norm());
        let last = (end / rest.scale).asinh();
        let mut before: Option<Vec<Complex64>> = None;
        let mut count = 128;
        loop {
            let nodes: Vec<f64> =
                (0..=count).map(|i| rest.scale * (last * i as f64 / count as f64).sinh()).collect();
            let values: Vec<Complex64> = nodes.iter().map(|beta| rest.at(*beta)).collect();
            // even in β: (1/π) ∫₀ f cos βx dβ
            let sum = |x: &f64| (quadratic(&nodes, &values, *x) + quadratic(&nodes, &values, -x)) / TAU;
            let sums: Vec<Complex64> = places.iter().map(sum).collect();
            let size = (sums[0] + tail[0]).norm();
            let change = before.iter().flatten().zip(&sums).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            if before.is_some() && change < 5.0 * ACCURACY * size {
                // a third of the change, as the asymptote is not always reached
                let error = change / 5.0 + rest.at(end).norm() * end / (4.0 * PI) + 1e-13 * size;
                let answers = sums.iter().zip(&tail).skip(1);
                return Ok(answers.map(|(sum, tail)| Answer { value: sum + tail, error }).collect());
            }
            if count >= MOST {
                return Err(RailError::Unsettled {
                    method: NAME,
                    frequency: omega / TAU,
                    error: change / size,
                    remedy: "waves that hardly decay need too many samples; method = \"residues\" or \"adaptive\" do not",
                });
            }
            (before, count) = (Some(sums), 2 * count);
        }
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}
