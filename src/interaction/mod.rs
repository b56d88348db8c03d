//! Track on foundation.

mod moving_load;

pub use moving_load::{InteractionError, MovingLoad, Shape, TrackOnFoundation};
