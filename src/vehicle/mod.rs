//! What runs on the track.

mod axle_loads;
mod four_axle;
mod freedom;
mod hertz;
mod model;
mod multibody;

pub use axle_loads::{Axle, Train, VehicleError};
pub use four_axle::{Body, Bogie, FourAxle, GRAVITY, Suspension, Wheelset};
pub use freedom::{Freedom, Motion, Part};
pub use hertz::{ContactSpring, Hertz, Tread};
pub use model::VehicleModel;
pub use multibody::Multibody;

use crate::quantity::OutOfRange;
use thiserror::Error;

/// Why bodies on springs, or a contact, cannot be built; axle loads have [`VehicleError`].
#[derive(Clone, Debug, Error, PartialEq)]
pub enum BodyError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
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
