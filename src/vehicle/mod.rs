//! What runs on the track.

mod axle_loads;
mod bogie_vehicle;
mod freedom;
mod hertz;
mod model;
mod multibody;

pub use axle_loads::{Axle, Train, VehicleError};
pub use bogie_vehicle::{Body, Bogie, BogieVehicle, GRAVITY, Suspension, Wheelset};
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
    /// Bodies, or wheelsets of a bogie, that there are none of, or too many.
    #[error("{key} is {count}: it must lie between {} and {}", allowed.0, allowed.1)]
    Count {
        /// What.
        key: &'static str,
        /// What was given.
        count: usize,
        /// Least and most.
        allowed: (usize, usize),
    },
    /// A model of one bogie and half a body, of a vehicle whose bogies carry different parts of bodies.
    #[error(
        "the model \"five\" has half a body on every bogie, an articulated vehicle a whole one on those between its bodies"
    )]
    HalfBodies,
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
