//! Uncertain numbers: their distributions, how they vary together, and which samples of them are taken.
//!
//! A sample depends on the seed, its own number and the name of what varies, never on order, shard or thread.

mod correlation;
mod design;
mod distribution;
mod generator;
mod toro;

pub use correlation::Correlation;
pub use design::{Design, ENDS, MOST, SamplingMethod};
pub use distribution::Distribution;
pub use generator::{GENERATOR, fingerprint, uniform};
pub use toro::{Likeness, Site};

use crate::quantity::OutOfRange;
use thiserror::Error;

/// Why samples cannot be drawn.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SamplingError {
    /// A parameter out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// Numbers in the wrong order.
    #[error("{found} comes after {before}: they must grow")]
    Order {
        /// Key of one of them.
        key: &'static str,
        /// The one before.
        before: f64,
        /// The one that should be larger.
        found: f64,
    },
    /// A list without values, or whose weights do not fit.
    #[error(
        "{values} values and {weights} weights of sum {sum}: give at least one value, a weight for each, and one above zero"
    )]
    Weights {
        /// How many values.
        values: usize,
        /// How many weights.
        weights: usize,
        /// Their sum.
        sum: f64,
    },
    /// Limits of a list.
    #[error("a list has no min and max: leave out the values beyond them")]
    TruncatedList,
    /// Limits that leave nothing.
    #[error("the distribution has nothing between {min} and {max}: move its limits")]
    NothingLeft {
        /// Lower limit.
        min: f64,
        /// Upper limit.
        max: f64,
    },
    /// A correlation matrix that is none.
    #[error(
        "the correlation matrix has the eigenvalue {least:.4}: no numbers vary like that; lower the coefficients, or give those left out"
    )]
    NotDefinite {
        /// Its least eigenvalue.
        least: f64,
    },
    /// No samples, or too many.
    #[error("{samples} samples: there must be at least 1 and at most {most}")]
    Samples {
        /// How many.
        samples: usize,
        /// How many are allowed.
        most: usize,
    },
}
