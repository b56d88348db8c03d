//! Tracks as vertical stacks: members (beams, masses) joined by links, standing on a foundation they do not know.

pub mod ballasted;
mod link;
mod member;
pub mod slab;
mod stack;

pub use ballasted::{Ballast, Ballasted};
pub use link::{Link, LinkStiffness};
pub use member::Member;
pub use slab::Slab;
pub use stack::{Displacements, Stack};

use crate::quantity::OutOfRange;
use thiserror::Error;

/// Why a track cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TrackError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
}
