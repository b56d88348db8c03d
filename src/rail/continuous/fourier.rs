//! Discrete Fourier transform along β, its slow tail taken out: evenly spaced samples, as many as it takes.
//!
//! Spacing Δβ repeats the response every 2π/Δβ; halving it squares the e^{−αX} that the images leave, so that the last change is far above
//! the error of the finer sum. What lies beyond the last sample is measured by it.
//!
//! Source: Eqs (33)–(38).

use super::uniform::Uniform;
use crate::math::complex::reciprocal;
use crate::math::expression::Polynomial;
use crate::rail::tail::Tail;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::{Ratio, Tower};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

const NAME: &str = "fourier";
/// Wanted, relative to the receptance at the load.
const ACCURACY: f64 = 1e-8;
/// Samples allowed.
const MOST: usize = 1 << 23;

/// A rail on springs that answers by discrete Fourier transform.
pub struct Fourier<'a>(pub(super) Uniform<'a>);

/// ũ(β) less its tail, even in β.
pub(super) struct Rest<'a> {
    tower: &'a Tower,
    omega: f64,
    pub(super) tail: Tail,
    /// About its largest pole [rad/m].
    pub(super) scale: f64,
}

impl<'a> Rest<'a> {
    /// Of `tower` at `omega` [rad/s]; None where there is no polynomial.
    pub(super) fn new(tower: &'a Tower, omega: f64) -> Option<Self> {
        let ratio = tower.compliance(&Polynomial::variable(), &Polynomial::constant(omega))?;
        let scale = scale(&ratio);
        Some(Self { tower, omega, tail: Tail::new(&ratio, scale), scale })
    }

    /// [m per N/m]
    pub(super) fn at(&self, beta: f64) -> Complex64 {
        reciprocal(self.tower.stiffness((beta * beta).into(), self.omega)[0]) - self.tail.of(beta)
    }

    /// Where [rad/m] it has faded to `part` of `of` [m/N], as an integral over all that is left.
    pub(super) fn end(&self, part: f64, of: f64) -> f64 {
        let mut end = 4.0 * self.scale;
        while self.at(end).norm() * end / (4.0 * PI) > part * of && end < 1e4 * self.scale {
            end *= 1.25;
        }
        end
    }
}

/// About the largest pole or zero [rad/m] of ũ = n/d: half of Fujiwara's bound on the roots of both, √ maxₖ |p_(N − k)/p_N|^(1/k).
fn scale(ratio: &Ratio) -> f64 {
    let largest = |p: &[Complex64]| {
        let last = p.last().map_or(1.0, |c| c.norm());
        let root = |(k, c): (usize, &Complex64)| (c.norm() / last).powf(1.0 / (k + 1) as f64);
        p.iter().rev().skip(1).enumerate().map(root).fold(0.0, f64::max)
    };
    let square = largest(ratio.numerator.coefficients()).max(largest(ratio.denominator.coefficients()));
    if square > 0.0 { square.sqrt() } else { 1.0 }
}

impl Receptance for Fourier<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        self.0.check(omega)?;
        let rest = Rest::new(self.0.tower(NAME)?, omega).ok_or(self.0.unknown(NAME))?;
        let x: Vec<f64> = x.iter().map(|x| x - from).collect();
        // the force first, which says how large the answers are
        let places: Vec<f64> = std::iter::once(0.0).chain(x).collect();
        let tail: Vec<Complex64> = places.iter().map(|x| rest.tail.at(*x)).collect();
        let (end, mut spacing) = (rest.end(0.01 * ACCURACY, tail[0].norm()), rest.scale / 8.0);
        // (1/2π) Σ u e^{iβx} Δβ over β and −β
        let sum = |first: f64, spacing: f64| {
            let mut sums = vec![Complex64::ZERO; places.len()];
            for i in 0..((end - first) / spacing).ceil() as usize {
                let beta = first + spacing * i as f64;
                let u = rest.at(beta) * (spacing / PI);
                sums.iter_mut().zip(&places).for_each(|(sum, x)| *sum += u * (beta * x).cos());
            }
            sums
        };
        let origin = rest.at(0.0) * spacing / TAU;
        let mut sums: Vec<Complex64> = sum(spacing, spacing).iter().map(|s| s + origin).collect();
        loop {
            let between = sum(0.5 * spacing, spacing);
            let finer: Vec<Complex64> = sums.iter().zip(&between).map(|(a, b)| 0.5 * (a + b)).collect();
            let change = sums.iter().zip(&finer).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            let size = (finer[0] + tail[0]).norm();
            (sums, spacing) = (finer, 0.5 * spacing);
            if change < ACCURACY * size {
                let cut = rest.at(end).norm() * end / (4.0 * PI);
                let answers = sums.iter().zip(&tail).skip(1).map(|(sum, tail)| sum + tail);
                return Ok(answers
                    .map(|value| Answer { value, error: change + cut + 1e-14 * size })
                    .collect());
            }
            if end / spacing > MOST as f64 {
                return Err(RailError::Unsettled {
                    method: NAME,
                    frequency: omega / TAU,
                    error: change / size,
                    remedy: "waves that hardly decay need too many samples; method = \"residues\" or \"adaptive\" do not",
                });
            }
        }
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}
