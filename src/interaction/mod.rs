//! Track on foundation: moving loads along the track, and the ground around it.

mod contact_forces;
mod driven_line;
mod far_field;
mod ground_field;
mod ground_grid;
mod harmonic_load;
mod moving_load;
mod passage;
mod section;
mod sections;
mod standing_field;
mod wheel_rail;

pub use contact_forces::ContactForces;
pub use far_field::FarField;
pub use ground_field::{Field, GroundField, GroundFieldError};
pub use ground_grid::{GroundLoad, Quantity, Window};
pub use harmonic_load::HarmonicLoad;
pub use moving_load::{InteractionError, MovingLoad, MovingSpectrum, Shape, TrackOnFoundation};
pub use passage::Passage;
pub use section::{Section, transfer};
pub use sections::{Between, Sections};
pub use standing_field::StandingField;
pub use wheel_rail::{COUPLED, WheelRail};
