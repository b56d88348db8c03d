//! A settled integral over β as a sum of waves along the track: Σ u e^{iβx}.

use crate::math::quadrature::{Node, Rule};
use num_complex::Complex64;

/// Waves of wavenumber β and amplitude u.
#[derive(Clone, Debug, Default)]
pub struct Waves {
    /// β [rad/m]
    pub beta: Vec<f64>,
    /// u, the weight of its node in it.
    pub u: Vec<Complex64>,
}

impl Waves {
    /// One wave for every node of `rule`: its weight times `share` of the integrand's `amplitude` at (β, value).
    pub fn new(rule: &Rule, share: f64, amplitude: impl Fn(f64, Complex64) -> Complex64) -> Self {
        let wave = |node: &Node| (node.x, amplitude(node.x, node.value) * (node.weight * share));
        let (beta, u) = rule.0.iter().map(wave).unzip();
        Self { beta, u }
    }

    /// β and u of every wave.
    pub fn iter(&self) -> impl Iterator<Item = (f64, Complex64)> {
        self.beta.iter().copied().zip(self.u.iter().copied())
    }

    /// The same waves, each times `factor` of its β.
    pub fn times(&self, factor: impl Fn(f64) -> Complex64) -> Self {
        Self { beta: self.beta.clone(), u: self.iter().map(|(beta, u)| u * factor(beta)).collect() }
    }

    /// Those of an integrand even in β, from those of β ≥ 0.
    pub fn mirrored(self) -> Self {
        let beta = self.beta.iter().rev().map(|beta| -beta).chain(self.beta.iter().copied()).collect();
        let u = self.u.iter().rev().chain(&self.u).copied().collect();
        Self { beta, u }
    }

    /// Σ u e^{iβx} at `x` [m].
    pub fn at(&self, x: f64) -> Complex64 {
        self.iter().map(|(beta, u)| u * Complex64::cis(beta * x)).sum()
    }

    /// Re Σ u e^{iβx} at `count` positions from `from` in steps of `step` [m], four waves at a time; e^{iβx} by rotation, restarted
    /// every 256 steps so that its rounding stays below 1e-13.
    pub fn shape(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        const LANES: usize = 4;
        const RESTART: usize = 256;
        let mut sum = vec![0.0; count];
        for (betas, values) in self.beta.chunks(LANES).zip(self.u.chunks(LANES)) {
            let (mut turn_re, mut turn_im) = ([1.0; LANES], [0.0; LANES]);
            for (i, beta) in betas.iter().enumerate() {
                (turn_im[i], turn_re[i]) = (beta * step).sin_cos();
            }
            for (block, part) in sum.chunks_mut(RESTART).enumerate() {
                let x = from + step * (block * RESTART) as f64;
                let (mut re, mut im) = ([0.0; LANES], [0.0; LANES]);
                for (i, (beta, value)) in betas.iter().zip(values).enumerate() {
                    let z = value * Complex64::cis(beta * x);
                    (re[i], im[i]) = (z.re, z.im);
                }
                for slot in part {
                    let mut total = 0.0;
                    for i in 0..LANES {
                        total += re[i];
                        (re[i], im[i]) = (
                            re[i] * turn_re[i] - im[i] * turn_im[i],
                            re[i] * turn_im[i] + im[i] * turn_re[i],
                        );
                    }
                    *slot += total;
                }
            }
        }
        sum
    }
}
