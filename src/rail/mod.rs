//! How the rail of a track on its foundation answers loads that stand or move.

mod beam_waves;
mod by_method;
pub mod continuous;
pub mod decay_rate;
mod drive;
pub mod fem;
mod harmonic_load;
mod moving_load;
pub mod periodic;
mod receptance;
mod tail;
mod track_on_foundation;
mod waves;

pub use beam_waves::BeamWaves;
pub use by_method::{free_decay, moving, rail};
pub use decay_rate::DecayRate;
pub use drive::Drive;
pub use harmonic_load::HarmonicLoad;
pub(crate) use harmonic_load::{NEGLIGIBLE, decay};
pub(crate) use moving_load::panels;
pub use moving_load::{MovingLoad, MovingSpectrum, RailLoad, RailWaves, Shape};
pub use periodic::Landmark;
pub use receptance::{Answer, Method, Moving, RailError, Receptance};
pub use track_on_foundation::{ACCURACY, InteractionError, TrackOnFoundation};
pub(crate) use track_on_foundation::{BETA_CAP, BETA_MIN};
pub(crate) use waves::Waves;
