//! `[[study.vary]]` → its distribution, with every fault at its key.

use super::error::Finding;
use super::key_path::number;
use super::study_table::{Amount, DistributionInput, VaryInput};
use super::units::{RATIO, Unit};
use crate::sampling::{Distribution, SamplingError};

/// A fault of sampling, in the table at `path`.
pub fn refused(path: &str, error: SamplingError) -> Finding {
    match error {
        SamplingError::OutOfRange(error) => Finding::out_of_range(path, error),
        SamplingError::Order { key, .. } => Finding::new(format!("{path}.{key}"), error),
        error => Finding::new(path, error),
    }
}

/// The distribution that `vary`, which stands at `path`, gives a number in `unit`, or the factor on it.
///
/// # Errors
/// At its key.
pub fn distribution(vary: &VaryInput, unit: &Unit, path: &str) -> Result<Distribution, Finding> {
    let unit = if vary.factor { &RATIO } else { unit };
    let read = |key: &str, amount: &Amount| {
        let misread = |(message, help)| Finding::new(format!("{path}.{key}"), message).help(help);
        number(&amount.0, unit).map_err(misread)
    };
    let whole = match &vary.distribution {
        DistributionInput::Normal { mean, standard_deviation, cov } => {
            let mean = read("mean", mean)?;
            let deviation = match (standard_deviation, cov) {
                (Some(deviation), None) => read("standard_deviation", deviation)?,
                (None, Some(cov)) => cov * mean.abs(),
                _ => {
                    let finding = Finding::new(path, "a normal distribution has one width");
                    return Err(finding.help("give standard_deviation, or cov"));
                }
            };
            Distribution::normal(mean, deviation)
        }
        DistributionInput::Lognormal { median, sigma_ln, mean, cov } => match (median, sigma_ln, mean, cov) {
            (Some(median), Some(sigma), None, None) => {
                Distribution::lognormal(read("median", median)?, *sigma)
            }
            (None, None, Some(mean), Some(cov)) => Distribution::lognormal_of_mean(read("mean", mean)?, *cov),
            _ => {
                let finding = Finding::new(path, "a lognormal distribution has one centre and one width");
                return Err(finding.help("give median and sigma_ln, or mean and cov"));
            }
        },
        DistributionInput::Uniform { from, to } => {
            Distribution::uniform(read("from", from)?, read("to", to)?)
        }
        DistributionInput::Triangular { from, mode, to } => {
            Distribution::triangular(read("from", from)?, read("mode", mode)?, read("to", to)?)
        }
        DistributionInput::List { values, weights } => {
            let values = values.iter().enumerate().map(|(i, value)| read(&format!("values[{i}]"), value));
            Distribution::list(values.collect::<Result<_, _>>()?, weights.as_deref())
        }
    };
    let limit = |key, amount: &Option<Amount>| amount.as_ref().map(|amount| read(key, amount)).transpose();
    let (min, max) = (limit("min", &vary.min)?, limit("max", &vary.max)?);
    whole.and_then(|whole| whole.truncated(min, max)).map_err(|error| refused(path, error))
}
