//! Tracks as vertical stacks: members (beams, masses) joined by links, standing on a foundation they do not know.

pub mod ballasted;
mod link;
mod member;
pub mod slab;
mod stack;

pub use ballasted::{Ballast, Ballasted};
pub use link::{Link, LinkStiffness};
pub use member::Member;
pub use slab::Slab;
pub use stack::{Displacements, Stack};

use thiserror::Error;

/// Why a track cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TrackError {
    /// A quantity must be finite and positive.
    #[error("{quantity} is {value} {unit}: it must be finite and above zero")]
    NotPositive {
        /// What it is.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A quantity must be finite and not negative.
    #[error("{quantity} is {value} {unit}: it must be finite and not negative")]
    Negative {
        /// What it is.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
}

/// `value` if finite and above zero.
fn positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, TrackError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(TrackError::NotPositive { quantity, value, unit })
    }
}

/// `value` if finite and not negative.
fn not_negative(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, TrackError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(TrackError::Negative { quantity, value, unit })
    }
}
