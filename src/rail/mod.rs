//! How the rail of a track on its foundation answers loads that stand or move.

mod driven_line;
mod harmonic_load;
mod moving_load;
mod track_on_foundation;
mod waves;

pub use harmonic_load::HarmonicLoad;
pub(crate) use harmonic_load::{NEGLIGIBLE, decay, within};
pub(crate) use moving_load::panels;
pub use moving_load::{MovingLoad, MovingSpectrum, Shape};
pub(crate) use track_on_foundation::{BETA_CAP, BETA_MIN};
pub use track_on_foundation::{InteractionError, TrackOnFoundation};
pub(crate) use waves::Waves;
