//! Tracks as vertical stacks: members (beams, strings, masses) joined by links, standing on a foundation they do not know.

mod ballast;
pub mod ballasted;
mod element;
mod link;
mod member;
pub mod slab;
mod stack;
mod supports;

pub use ballast::Ballast;
pub use ballasted::{Ballasted, Sleeper};
pub use element::Element;
pub use link::{Link, LinkStiffness};
pub use member::Member;
pub use slab::Slab;
pub use stack::{Displacements, Stack};
pub use supports::{Layout, Section, Supports};

use crate::quantity::OutOfRange;
use member::Beam;
use schemars::JsonSchema;
use serde::Deserialize;
use thiserror::Error;

/// A published track by its parameters, whole track: `[track]` of a case file, less how it touches the ground.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum Track {
    /// Rails, pads, sleepers, ballast.
    Ballasted(Ballasted),
    /// Rails, pads, slab.
    Slab(Slab),
    /// One beam.
    Beam {
        /// Rails, track and embankment together.
        #[schemars(with = "Beam")]
        beam: Member,
    },
    /// Axles straight on the ground.
    None,
}

impl Track {
    /// Its members and links; `half_width` [m] is half of the contact with the ground, as far as there is one.
    ///
    /// # Errors
    /// As [`Ballasted::stack`].
    pub fn stack(&self, half_width: Option<f64>) -> Result<Stack, TrackError> {
        match self {
            Self::Ballasted(track) => track.stack(half_width),
            Self::Slab(track) => Ok(track.stack()),
            Self::Beam { beam } => Ok(Stack::new(vec![*beam], vec![])),
            Self::None => Ok(Stack::default()),
        }
    }
}

/// Why a track cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TrackError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// Bars are as wide as the contact, and there is none.
    #[error("ballast bars need the contact width")]
    ContactWidth,
    /// Bars without wave speed and density.
    #[error("the wave speed of the ballast is missing")]
    WaveSpeedMissing,
    /// Bars with both.
    #[error("the wave speed is given twice")]
    WaveSpeedTwice,
}
