//! How the rail of a track on its foundation answers loads that stand or move.

mod driven_line;
mod harmonic_load;
mod moving_load;

pub use harmonic_load::HarmonicLoad;
pub(crate) use harmonic_load::{NEGLIGIBLE, decay, within};
pub(crate) use moving_load::{BETA_MIN, panels};
pub use moving_load::{InteractionError, MovingLoad, MovingSpectrum, Shape, TrackOnFoundation};
