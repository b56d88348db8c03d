//! What runs on the track.

mod axle_loads;
mod four_axle;
mod hertz;
mod multibody;

pub use axle_loads::{Axle, Train, VehicleError};
pub use four_axle::{FourAxle, GRAVITY, Suspension};
pub use hertz::{Hertz, Tread};
pub use multibody::Multibody;

use thiserror::Error;

/// Why bodies on springs, or a contact, cannot be built; axle loads have [`VehicleError`].
#[derive(Clone, Debug, Error, PartialEq)]
pub enum BodyError {
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
    /// A copy of a vehicle that is nowhere.
    #[error("copy {index} (counted from 1) stands {offset} m behind the first: it must be finite")]
    Offset {
        /// Which, from 1.
        index: usize,
        /// What was given [m].
        offset: f64,
    },
    /// Two bogies in one place.
    #[error(
        "the wheelbase of a bogie is {wheelbase} m, the bogies {bogie_centres} m apart: it must be shorter"
    )]
    BogiesOverlap {
        /// [m]
        wheelbase: f64,
        /// [m]
        bogie_centres: f64,
    },
}

/// `value` if finite and above zero.
fn positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, BodyError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(BodyError::NotPositive { quantity, value, unit })
    }
}

/// `value` if finite and not negative.
fn not_negative(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, BodyError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(BodyError::Negative { quantity, value, unit })
    }
}
