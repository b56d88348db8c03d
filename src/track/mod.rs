//! Tracks as vertical stacks: members (beams, strings, masses) joined by links, standing on a foundation they do not know.

mod ballast;
pub mod ballasted;
mod damping;
mod element;
mod link;
mod member;
mod pad;
mod section;
pub mod slab;
mod stack;
mod supports;
mod tower;

pub use ballast::Ballast;
pub use ballasted::{Ballasted, Sleeper, SleeperMass};
pub use damping::{Caughey, Rayleigh};
pub use element::Element;
pub use link::{Link, LinkStiffness, Spring, closed};
pub use member::Member;
pub use pad::Pad;
pub use section::{Rail, Rails, Section as RailSection};
pub use slab::Slab;
pub use stack::{Displacements, Stack};
pub use supports::{Layout, Section, Supports};
pub use tower::{Ratio, Tower};

use crate::quantity::OutOfRange;
use schemars::JsonSchema;
use section::RailKeys;
use serde::Deserialize;
use thiserror::Error;

/// A published track by its parameters, whole track: `[track]` of a case file, less how it touches the ground.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum Track {
    /// Rails, pads, sleepers, ballast, mats.
    Ballasted(Ballasted),
    /// Rails, pads, slab, mat.
    Slab(Slab),
    /// One beam.
    Beam {
        /// How many rails all numbers stand for; the whole track by default, and to be said of a section.
        rails: Option<Rails>,
        /// Rails, track and embankment together.
        #[schemars(with = "RailKeys")]
        beam: Rail,
    },
    /// Axles straight on the ground.
    None,
}

impl Track {
    /// How many rails its numbers stand for: two, the whole track, unless it says one.
    pub fn rails(&self) -> Rails {
        match self {
            Self::Ballasted(Ballasted { rails, .. })
            | Self::Slab(Slab { rails, .. })
            | Self::Beam { rails, .. } => rails.unwrap_or_default(),
            Self::None => Rails::Two,
        }
    }

    /// What joins the ballast under neighbouring supports [N/m].
    pub fn between(&self) -> Option<Element> {
        match self {
            Self::Ballasted(Ballasted {
                ballast: Ballast::Block { link: Some(Link::Element(link)), .. },
                ..
            }) => Some(*link),
            _ => None,
        }
    }

    /// The same with `spacing` [m] from one sleeper to the next, if its sleepers do not say.
    pub fn spaced(mut self, spacing: f64) -> Self {
        if let Self::Ballasted(Ballasted { sleeper, .. }) = &mut self {
            sleeper.spacing.get_or_insert(spacing);
        }
        self
    }

    /// From one sleeper to the next [m], where they say.
    pub fn spacing(&self) -> Option<f64> {
        match self {
            Self::Ballasted(track) => track.sleeper.spacing,
            _ => None,
        }
    }

    /// Its members and links; `half_width` [m] is half of the contact with the ground, as far as there is one.
    ///
    /// # Errors
    /// As [`Ballasted::stack`].
    pub fn stack(&self, half_width: Option<f64>) -> Result<Stack, TrackError> {
        match self {
            Self::Ballasted(track) => track.stack(half_width),
            Self::Slab(track) => track.stack(),
            Self::Beam { rails, beam } => Ok(Stack::new(vec![beam.member(*rails)?], vec![])),
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
    /// Something by the piece without a spacing.
    #[error("what is said of one piece lies how far apart? The spacing is missing")]
    SpacingMissing,
    /// Something of the second layer of ballast.
    #[error(transparent)]
    SubBallast(Box<TrackError>),
    /// Supports under nothing.
    #[error("there is no rail for supports to carry")]
    NoRail,
    /// Springs between supports without masses.
    #[error("springs between neighbouring supports need a mass under each to hold them")]
    NothingToJoin,
    /// Numbers for no rail, or for many.
    #[error("found {found} rails: a track has 2, and its numbers may stand for 1 of them")]
    Rails {
        /// As given.
        found: f64,
    },
    /// A section, which is one rail, without their number.
    #[error("the number of rails is missing: a section is one rail")]
    RailsMissing,
    /// Damping of modes that are not told apart, or of another number of modes.
    #[error(
        "found {modes} modes and {ratios} damping ratios: each mode has one, and no two have one frequency"
    )]
    Modes {
        /// Frequencies given.
        modes: usize,
        /// Ratios given.
        ratios: usize,
    },
    /// Springs and dashpots that give way under any force that lasts.
    #[error("element \"{element}\" gives way under a force that lasts: it has no static stiffness")]
    NoStatics {
        /// Its name.
        element: &'static str,
    },
    /// Causal hysteresis so slow that it pushes instead of holding.
    #[error(
        "element \"causal-hysteretic\" is no spring at {frequency:.3e} Hz: its stiffness is above zero only above {limit:.3e} Hz"
    )]
    Pushes {
        /// [Hz]
        frequency: f64,
        /// [Hz]
        limit: f64,
    },
}
