//! The ground beside the track: around a train, beside a pass, around a standing force.

mod abreast;
mod far_field;
mod ground_field;
mod ground_grid;
mod passage;
mod section;
mod sections;
mod standing_field;
mod transfer;

pub use far_field::FarField;
pub use ground_field::{Field, GroundField, GroundFieldError};
pub use ground_grid::{GroundLoad, Quantity, Window};
pub use passage::Passage;
pub use section::Section;
pub use sections::{Between, Sections};
pub use standing_field::StandingField;
pub use transfer::Transfer;
