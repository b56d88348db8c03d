//! Which probabilities the samples of a study take, one for every number that varies.

use super::{Correlation, SamplingError, uniform};
use crate::math::normal;
use schemars::JsonSchema;
use serde::Deserialize;

/// Most samples of a study.
pub const MOST: usize = 1_000_000;
/// Probabilities at which one number at a time is taken.
pub const ENDS: [f64; 2] = [0.05, 0.95];

/// How samples are chosen.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum SamplingMethod {
    /// Independently of one another.
    MonteCarlo,
    /// Every number once in each of as many equally likely parts of its range as there are samples.
    #[default]
    LatinHypercube,
    /// Every combination of some values of each.
    Grid,
    /// All at their medians, then one after another at its 5 % and its 95 % quantile.
    OneAtATime,
}

/// Samples of several numbers, each a probability between 0 and 1 of its distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    method: SamplingMethod,
    seed: u64,
    samples: usize,
    keys: Vec<String>,
    correlation: Correlation,
    /// Of a grid: the probabilities of each number.
    levels: Vec<Vec<f64>>,
    /// Of a Latin hypercube: in which of the parts of each number each sample lies.
    strata: Vec<Vec<u32>>,
}

impl Design {
    /// `samples` of the numbers `keys`, drawn from `seed`, independently of each other or as a Latin hypercube.
    ///
    /// A Latin hypercube spreads the ranks of independent samples: number j of sample i lies in part r of n, where r is the rank of
    /// its score among all. So numbers vary together by their `correlation`, and each still lies once in every part. It keeps 4 bytes
    /// of every number.
    ///
    /// # Errors
    /// None, or more than a million samples.
    pub fn random(
        method: SamplingMethod,
        (samples, seed): (usize, u64),
        keys: Vec<String>,
        correlation: Correlation,
    ) -> Result<Self, SamplingError> {
        let mut design =
            Self { method, seed, samples, keys, correlation, levels: Vec::new(), strata: Vec::new() };
        design.check()?;
        if method == SamplingMethod::LatinHypercube {
            design.strata = design.ranks();
        }
        Ok(design)
    }

    /// Every combination of the probabilities `levels` of the numbers `keys`, the last one changing fastest.
    ///
    /// # Errors
    /// More than a million samples.
    pub fn grid(keys: Vec<String>, levels: Vec<Vec<f64>>) -> Result<Self, SamplingError> {
        let samples = levels.iter().fold(1, |n: usize, of| n.saturating_mul(of.len()));
        Self::regular(SamplingMethod::Grid, samples, keys, levels)
    }

    /// The numbers `keys` at their medians, then each by itself at both [`ENDS`].
    ///
    /// # Errors
    /// More than a million samples.
    pub fn one_at_a_time(keys: Vec<String>) -> Result<Self, SamplingError> {
        Self::regular(SamplingMethod::OneAtATime, 1 + 2 * keys.len(), keys, Vec::new())
    }

    fn regular(
        method: SamplingMethod,
        samples: usize,
        keys: Vec<String>,
        levels: Vec<Vec<f64>>,
    ) -> Result<Self, SamplingError> {
        let correlation = Correlation::new(keys.len(), &[])?;
        let design = Self { method, seed: 0, samples, keys, correlation, levels, strata: Vec::new() };
        design.check()?;
        Ok(design)
    }

    fn check(&self) -> Result<(), SamplingError> {
        let samples = self.samples;
        if (1..=MOST).contains(&samples) {
            Ok(())
        } else {
            Err(SamplingError::Samples { samples, most: MOST })
        }
    }

    /// How samples are chosen.
    pub fn method(&self) -> SamplingMethod {
        self.method
    }

    /// How many samples there are.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// Standard normal scores of sample `i`, which vary together.
    fn scores(&self, i: usize) -> Vec<f64> {
        let independent = self.keys.iter().map(|key| normal::quantile(uniform(self.seed, key, i as u64)));
        self.correlation.of(independent.collect())
    }

    /// The rank of every sample in each number.
    fn ranks(&self) -> Vec<Vec<u32>> {
        let scores: Vec<Vec<f64>> = (0..self.samples).map(|i| self.scores(i)).collect();
        let of = |j: usize| {
            let mut order: Vec<u32> = (0..self.samples as u32).collect();
            order.sort_by(|a, b| scores[*a as usize][j].total_cmp(&scores[*b as usize][j]));
            let mut ranks = vec![0; order.len()];
            order.iter().zip(0..).for_each(|(sample, rank)| ranks[*sample as usize] = rank);
            ranks
        };
        (0..self.keys.len()).map(of).collect()
    }

    /// Probability of every number in sample `i`, counted from 0.
    pub fn probabilities(&self, i: usize) -> Vec<f64> {
        let n = self.samples as f64;
        match self.method {
            SamplingMethod::MonteCarlo if self.correlation.any() => {
                self.scores(i).into_iter().map(normal::probability).collect()
            }
            SamplingMethod::MonteCarlo => {
                self.keys.iter().map(|key| uniform(self.seed, key, i as u64)).collect()
            }
            SamplingMethod::LatinHypercube => self
                .keys
                .iter()
                .enumerate()
                .map(|(j, key)| {
                    let within = uniform(self.seed, &format!("{key} within its part"), i as u64);
                    (f64::from(self.strata[j][i]) + within) / n
                })
                .collect(),
            SamplingMethod::Grid => {
                let mut rest = i;
                let mut probabilities: Vec<f64> = self
                    .levels
                    .iter()
                    .rev()
                    .map(|of| {
                        let level = of[rest % of.len()];
                        rest /= of.len();
                        level
                    })
                    .collect();
                probabilities.reverse();
                probabilities
            }
            SamplingMethod::OneAtATime => {
                let moved = i.checked_sub(1).map(|k| (k / 2, ENDS[k % 2]));
                (0..self.keys.len())
                    .map(|j| moved.filter(|(number, _)| *number == j).map_or(0.5, |(_, end)| end))
                    .collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys() -> Vec<String> {
        ["a", "b", "c"].map(str::to_owned).to_vec()
    }

    fn hypercube(samples: usize, pairs: &[(usize, usize, f64)]) -> Design {
        let correlation = Correlation::new(3, pairs).unwrap();
        Design::random(SamplingMethod::LatinHypercube, (samples, 5), keys(), correlation).unwrap()
    }

    #[test]
    fn a_latin_hypercube_has_one_sample_in_every_part() {
        for pairs in [&[][..], &[(0, 1, 0.8), (1, 2, -0.3)]] {
            let design = hypercube(500, pairs);
            let samples: Vec<Vec<f64>> = (0..500).map(|i| design.probabilities(i)).collect();
            for j in 0..3 {
                let mut parts: Vec<usize> = samples.iter().map(|u| (u[j] * 500.0) as usize).collect();
                parts.sort_unstable();
                assert_eq!(parts, (0..500).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn a_latin_hypercube_keeps_its_correlation() {
        let design = hypercube(2000, &[(0, 1, 0.8)]);
        let scores: Vec<Vec<f64>> =
            (0..2000).map(|i| design.probabilities(i).into_iter().map(normal::quantile).collect()).collect();
        let mean = |i: usize, j: usize| scores.iter().map(|z| z[i] * z[j]).sum::<f64>() / 2000.0;
        // standard errors (1 − ρ²)/√n = 8e-3 and 1/√n = 2.2e-2; measured 7e-4 and 2.1e-2
        assert!((mean(0, 1) - 0.8).abs() < 0.025 && mean(0, 2).abs() < 0.07, "{} {}", mean(0, 1), mean(0, 2));
    }

    #[test]
    fn samples_do_not_depend_on_how_many_there_are() {
        let of = |samples| {
            let free = Correlation::new(3, &[]).unwrap();
            Design::random(SamplingMethod::MonteCarlo, (samples, 5), keys(), free).unwrap()
        };
        assert_eq!(of(10).probabilities(7), of(1000).probabilities(7));
        // nor on what else varies
        let two = Design::random(
            SamplingMethod::MonteCarlo,
            (10, 5),
            keys()[1..].to_vec(),
            Correlation::new(2, &[]).unwrap(),
        );
        assert_eq!(two.unwrap().probabilities(7), of(10).probabilities(7)[1..]);
    }

    #[test]
    fn grids_and_single_steps_are_complete() {
        let grid = Design::grid(keys(), vec![vec![0.5], vec![0.25, 0.75], vec![0.1, 0.5, 0.9]]).unwrap();
        assert_eq!(grid.samples(), 6);
        assert_eq!(grid.probabilities(4), [0.5, 0.75, 0.5]);
        let single = Design::one_at_a_time(keys()).unwrap();
        assert_eq!((single.samples(), single.probabilities(0)), (7, vec![0.5; 3]));
        assert_eq!([single.probabilities(3), single.probabilities(4)], [[0.5, 0.05, 0.5], [0.5, 0.95, 0.5]]);
    }

    #[test]
    fn too_many_samples_are_refused() {
        assert!(Design::grid(keys(), vec![vec![0.5; 101]; 3]).unwrap_err().to_string().contains("1030301"));
        let none =
            Design::random(SamplingMethod::MonteCarlo, (0, 1), keys(), Correlation::new(3, &[]).unwrap());
        assert!(none.is_err());
    }
}
