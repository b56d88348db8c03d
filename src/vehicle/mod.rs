//! What runs on the track.

mod axle_loads;

pub use axle_loads::{Axle, Train, VehicleError};
