//! Rational approximation on [0, 1] from values alone: the AAA algorithm, its support points added where the error is largest.
//!
//! ```text
//! r(z) = N(z)/D(z),   N = Σ_j w_j f_j/(z − z_j),   D = Σ_j w_j/(z − z_j)
//! ```
//!
//! takes the values f_j at the support points z_j whatever the weights. w makes N − f D least on samples between them: it is the
//! vector of unit length for which the Loewner matrix (f_i − f_j)/(z_i − z_j), each row over the error allowed there, is smallest.
//! Poles are the zeros of D.
//!
//! Source: Nakatsukasa, Sète & Trefethen 2018, SIAM J. Sci. Comput. 40:A1494; samples between support points as Driscoll, Nakatsukasa
//! & Trefethen 2024, SIAM J. Sci. Comput. 46:A929.

use super::quadrature::miss;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use num_complex::Complex64;

/// Samples between two neighbouring support points, and how many times finer those are that have the last word.
const BETWEEN: usize = 4;
/// Samples after which a function is given up: those that settle take 100 to 800.
const MOST_SAMPLES: usize = 4000;

/// f at one place.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// z in [0, 1].
    pub z: f64,
    /// f(z)
    pub value: Complex64,
    /// Error of it that is allowed.
    pub allowed: f64,
}

/// A sample on its way.
#[derive(Clone, Copy)]
struct Point {
    /// z = cos² θ
    theta: f64,
    sample: Sample,
    support: bool,
}

/// A rational function in barycentric form.
#[derive(Clone, Debug)]
pub struct Rational {
    support: Vec<Sample>,
    weights: Vec<Complex64>,
}

impl Rational {
    /// r(z)
    pub fn at(&self, z: f64) -> Complex64 {
        let (mut above, mut below) = (Complex64::ZERO, Complex64::ZERO);
        for (s, w) in self.support.iter().zip(&self.weights) {
            if s.z == z {
                return s.value;
            }
            let part = w / (z - s.z);
            above += part * s.value;
            below += part;
        }
        above / below
    }

    /// Poles p and residues ρ of r = Σ ρ/(z − p) + r(∞), r(0) = 0 being one of the support points; None if they do not settle.
    ///
    /// With s = Σ w_j, D = (s + Σ w_j z_j/(z − z_j))/z is zero at the eigenvalues of diag(z) − 1 (w z)ᵀ/s, and ρ = N/D′.
    pub fn poles(&self) -> Option<Vec<(Complex64, Complex64)>> {
        let sum: Complex64 = self.weights.iter().sum();
        let terms: Vec<(Sample, Complex64)> =
            self.support.iter().copied().zip(self.weights.iter().copied()).collect();
        let rows: Vec<(Sample, Complex64)> = terms.iter().filter(|(s, _)| s.z != 0.0).copied().collect();
        let matrix = Mat::from_fn(rows.len(), rows.len(), |i, j| {
            let (column, w) = rows[j];
            let diagonal = if i == j { column.z } else { 0.0 };
            diagonal - w * column.z / sum
        });
        let residue = |p: Complex64| {
            let (mut above, mut slope) = (Complex64::ZERO, Complex64::ZERO);
            for (s, w) in &terms {
                let part = w / (p - s.z);
                above += part * s.value;
                slope -= part / (p - s.z);
            }
            above / slope
        };
        Some(matrix.eigenvalues().ok()?.into_iter().map(|p| (p, residue(p))).collect())
    }

    /// Weights on `support` from `samples`: the smallest singular vector, by inverse iteration on the Gram matrix of columns of unit
    /// length; None where that is not definite.
    fn fit(support: Vec<Sample>, samples: &[Sample]) -> Option<Self> {
        // four steps from any start; the shift is rounding of the unit diagonal, whose root bounds what is found: 1e-7 of f
        const STEPS: usize = 4;
        const SHIFT: f64 = 1e-14;
        let n = support.len();
        let mut loewner = Mat::from_fn(samples.len(), n, |i, j| {
            (samples[i].value - support[j].value) / ((samples[i].z - support[j].z) * samples[i].allowed)
        });
        let scale: Vec<f64> = (0..n).map(|j| 1.0 / loewner.col(j).norm_l2().max(f64::MIN_POSITIVE)).collect();
        for (j, scale) in scale.iter().enumerate() {
            loewner.col_mut(j).iter_mut().for_each(|entry| *entry *= scale);
        }
        let mut gram = loewner.adjoint() * &loewner;
        (0..n).for_each(|j| gram[(j, j)] += SHIFT);
        let gram = gram.llt(Side::Lower).ok()?;
        let mut vector = Mat::from_fn(n, 1, |_, _| Complex64::ONE);
        for _ in 0..STEPS {
            vector = gram.solve(&vector);
            let norm = vector.norm_l2();
            vector.col_mut(0).iter_mut().for_each(|entry| *entry /= norm);
        }
        Some(Self { support, weights: (0..n).map(|j| vector[(j, 0)] * scale[j]).collect() })
    }

    /// Of `f`, asked for its samples at many θ at once, z = cos² θ, from support points at `angles` (ascending) on, with not many
    /// more than `most` of them; and every sample it took. None where no weights are found.
    pub fn adaptive(
        f: impl Fn(&[f64]) -> Vec<Sample>,
        angles: &[f64],
        most: usize,
    ) -> Option<(Self, Vec<Sample>)> {
        let points = |angles: Vec<f64>, support: bool| {
            let samples = f(&angles);
            angles
                .into_iter()
                .zip(samples)
                .map(move |(theta, sample)| Point { theta, sample, support })
                .collect::<Vec<_>>()
        };
        let mut all = points(angles.to_vec(), true);
        let mut checked = false;
        loop {
            let new = between(&all, checked);
            all.extend(points(new, false));
            all.sort_by(|a, b| a.theta.total_cmp(&b.theta));
            let of = |support: bool| all.iter().filter(|p| p.support == support).map(|p| p.sample).collect();
            let samples: Vec<Sample> = of(false);
            let fit = Self::fit(of(true), &samples)?;
            let worst = fit.worst(&all);
            let full = fit.support.len() >= most || samples.len() > MOST_SAMPLES;
            if (worst.is_empty() && checked) || full {
                return Some((fit, all.into_iter().map(|p| p.sample).collect()));
            }
            checked = worst.is_empty();
            // a quarter more, the worst first
            for i in worst.into_iter().take((fit.support.len() / 4).max(1)) {
                all[i].support = true;
            }
        }
    }

    /// Of the samples between two support points the one that is missed most, for all where one is missed; the worst first, none of
    /// those missed by less than 3 % of it.
    fn worst(&self, all: &[Point]) -> Vec<usize> {
        let mut worst: Vec<(f64, usize)> = Vec::new();
        let mut here = (1.0, 0);
        for (i, point) in all.iter().enumerate() {
            if point.support {
                worst.extend((here.0 > 1.0).then_some(here));
                here = (1.0, 0);
            } else {
                let Sample { z, value, allowed } = point.sample;
                let missed = miss((self.at(z) - value).norm(), allowed);
                if missed > here.0 {
                    here = (missed, i);
                }
            }
        }
        worst.sort_by(|a, b| b.0.total_cmp(&a.0));
        let least = worst.first().map_or(0.0, |w| 0.03 * w.0);
        worst.into_iter().filter(|w| w.0 > least).map(|w| w.1).collect()
    }
}

/// Angles of samples still to take: `BETWEEN` of them between support points that have fewer, or one between any two to check.
fn between(all: &[Point], check: bool) -> Vec<f64> {
    if check {
        return all.windows(2).map(|pair| 0.5 * (pair[0].theta + pair[1].theta)).collect();
    }
    let support: Vec<usize> = (0..all.len()).filter(|i| all[*i].support).collect();
    let few = support.windows(2).filter(|pair| pair[1] - pair[0] <= BETWEEN);
    few.flat_map(|pair| {
        let (from, to) = (all[pair[0]].theta, all[pair[1]].theta);
        // not where others may stand already: those are at fifths, halves
        (0..BETWEEN).map(move |i| from + (to - from) * (i as f64 + 0.43) / BETWEEN as f64)
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn poles_of_a_rational_function_are_its_own() {
        // measured 3e-11 of the poles
        let own = [
            (Complex64::new(0.3, -0.01), Complex64::new(1.0, 0.2)),
            (Complex64::new(0.7, -0.05), Complex64::new(-0.4, 0.1)),
        ];
        let at = |z: Complex64| -> Complex64 {
            own.iter().map(|(p, r)| r / (z - p) - r / (Complex64::ZERO - p)).sum()
        };
        let sample = |theta: &f64| {
            let z = theta.cos().powi(2);
            let z = if *theta >= FRAC_PI_2 { 0.0 } else { z };
            Sample { z, value: at(z.into()), allowed: 1e-8 }
        };
        let f = |angles: &[f64]| angles.iter().map(sample).collect();
        let (fit, samples) = Rational::adaptive(f, &[0.0, 0.8, FRAC_PI_2], 20).unwrap();
        assert!(samples.len() < 200);
        let poles = fit.poles().unwrap();
        for (p, r) in own {
            let near =
                poles.iter().map(|(q, s)| (q - p).norm() + (s - r).norm()).fold(f64::INFINITY, f64::min);
            assert!(near < 1e-6, "{near:e}");
        }
    }
}
