//! The track in finite elements: what frequency methods cannot do, and a witness of what they can.
//!
//! Beams of cubic Hermite shapes, or the locking-free Timoshenko element; supports at nodes, or springs and masses on the same shapes
//! along all of a continuous track; springs and dashpots of every foundation on rock. One band of a few unknowns to either side of the
//! diagonal, factorised once.

mod assembly;
mod column;
mod harmonic;
mod layouts;
mod mesh;
mod model;
mod newmark;
mod reach;
mod shape;

pub use column::Column;
pub use harmonic::{FiniteElements, dynamic_stiffness};
pub use layouts::Form;
pub use mesh::{Fault, Gap, Mesh, Station, Support};
pub use model::{Ends, Model};
pub use newmark::{Newmark, Scheme, State};
pub use reach::reach;
pub use shape::Shape;

use crate::quantity::OutOfRange;
use thiserror::Error;

/// Why a track has no finite elements.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FemError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// A track without length.
    #[error("the track has no length: it needs an end beyond its beginning, and at least one element a bay")]
    NoElement,
    /// The rail, or the lowest member, on rock.
    #[error("the lowest member of the track lies on rigid rock and cannot move: put springs under it")]
    OnRock,
    /// Springs that join supports.
    #[error(
        "the foundation joins neighbouring supports: in finite elements each stands on springs of its own (winkler, rigid)"
    )]
    Joined,
    /// Loss that only frequencies know.
    #[error("{of} has hysteretic loss, which has no form in time: give it {instead} instead")]
    Hysteretic {
        /// What has it.
        of: &'static str,
        /// What has a form in time.
        instead: &'static str,
    },
    /// Bars with waves in them.
    #[error(
        "ballast of kind \"bars\" carries waves, which have no form in time: use \"spring\", \"block\" or \"consistent-mass\""
    )]
    Bars,
    /// A support that cannot hang.
    #[error(
        "only sleepers on a spring and a dashpot (Kelvin–Voigt) can hang above their bed: this track has none"
    )]
    NothingToHang,
    /// Damping of many modes on a long track.
    #[error(
        "damping of three modes or more couples all {size} unknowns of the track: at most {most} are possible; give two modes (Rayleigh), or a shorter track"
    )]
    Full {
        /// Found.
        size: usize,
        /// Allowed.
        most: usize,
    },
    /// Damping of many modes where something has no mass.
    #[error(
        "damping of three modes or more asks for a mass at every displacement, and one of them has none: give two modes (Rayleigh)"
    )]
    Massless,
    /// A matrix that cannot be solved.
    #[error("the track is not held: nothing resists one of its displacements")]
    Singular,
}
