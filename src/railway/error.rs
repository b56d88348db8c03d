//! What a railway lacks for the question put to it.

use crate::foundation::FoundationError;
use crate::rail::RailError;
use thiserror::Error;

/// What a railway lacks for the question put to it.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RailwayError {
    /// The foundation cannot answer.
    #[error(transparent)]
    Foundation(#[from] FoundationError),
    /// The rail cannot answer.
    #[error(transparent)]
    Rail(#[from] RailError),
    /// Waves need layered ground.
    #[error("it needs layered ground: give [soil] instead of [foundation]")]
    NoGround,
    /// Springs are needed.
    #[error("it needs springs: layered ground has no form in time; give [foundation] instead of [soil]")]
    OnGround,
    /// A load is needed.
    #[error("it needs a load: give [train] with at least one axle")]
    NoTrain,
    /// The width of the load on the ground is needed.
    #[error(
        "it needs to know how the ground is loaded: give [track], or [track] with kind = \"none\", contact.half_width \
         and contact.compatibility"
    )]
    NoContact,
    /// A rail is needed.
    #[error(
        "it needs a track: give [track] with kind = \"ballasted\", \"slab\" or \"beam\"; kind = \"none\" has no rail"
    )]
    NoTrack,
    /// Everything must be spread along the rail.
    #[error(
        "its supports stand apart, and this is known of continuous tracks alone, the ground beside them included: without track.support all \
         is spread along the rail; receptance of the rail knows supports and sections, decay_rate and track_response equal supports, transition \
         sections"
    )]
    Apart,
    /// A method that is to verify itself.
    #[error(
        "method \"{method}\" is how the rail is asked already: verify with another one, or remove verify"
    )]
    Itself {
        /// Its name.
        method: &'static str,
    },
    /// Loads that stand over supports.
    #[error("a load at rest over supports is a question of [receptance]: give speeds above zero")]
    AtRest,
    /// Sections are needed.
    #[error("it needs a track that changes: give two or more [[track.section]], and support.spacing")]
    OneSection,
    /// Ground under a point load sinks without end.
    #[error(
        "the ground under a point load has no finite deflection: give track.load.kind = \"patch\" with half_length and half_width, \
         or ask for a contour only"
    )]
    PointLoad,
    /// A receiver on the track.
    #[error(
        "the receiver at {distance} m stands on the track, whose half-width is {half_width} m: receivers are distances from the \
         centre line of the track"
    )]
    OnTrack {
        /// From the centre line [m].
        distance: f64,
        /// [m]
        half_width: f64,
    },
}
