//! The ground beside the track: around a train, beside a pass, around a standing force.

mod abreast;
mod channel;
mod constant_load;
mod far_field;
mod ground_field;
mod ground_grid;
mod ground_state;
mod images;
mod mirrored;
mod pass;
mod pass_energy;
mod pass_history;
mod passage;
mod section;
mod sections;
mod standing_field;
mod transfer;
mod underground;

pub use channel::Channel;
pub use constant_load::{ConstantLoad, SlowLoad};
pub use far_field::FarField;
pub use ground_field::{Field, GroundField, GroundFieldError};
pub use ground_grid::{GroundLoad, Quantity, Window};
pub use ground_state::{COMPONENTS, Component, octahedral_strain};
pub use pass::{Pass, pointwise};
pub use pass_energy::{DrivingWave, PassEnergy};
pub use pass_history::{QuasiStatic, Times};
pub use passage::Passage;
pub use section::Section;
pub use sections::{Between, Sections, Tables};
pub use standing_field::StandingField;
pub use transfer::Transfer;
pub use underground::{Underground, UndergroundField};
