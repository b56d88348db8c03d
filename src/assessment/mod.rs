//! What vibration means to people: measures of a velocity or acceleration history, and the guide values they are drawn against.
//!
//! A result states its weighting, averaging time and reference; the direction is that of the history. Nothing here
//! judges: guide values are data.

mod band_limit;
mod guide;
mod kb_rating;
mod kb_value;
mod level;
mod limits;
mod passage_spectrum;
mod peak_velocity;
mod running_rms;
mod third_octave;
mod transfer;
mod vibration_dose;
mod weighting;

pub use guide::{Area, Guide, KbValues, Line, Period};
pub use kb_rating::{CLOCK, Exposure, clock_maxima, clock_maximum_rms, kb_rating};
pub use kb_value::{kb_f, kb_f_maximum, kb_signal, kb_transfer};
pub use level::{Level, Reference};
pub use limits::{GuideValue, Quantity, all_guide_values};
pub use passage_spectrum::{PassageSpectrum, passage_spectrum};
pub use peak_velocity::{WorkingRange, foundation_guide_values, peak_velocity, peak_velocity_within};
pub use running_rms::{Averaging, maximum_running_rms, running_rms};
pub use third_octave::{Band, rms};
pub use transfer::{Transfer, a_weighted_level, a_weighting};
pub use vibration_dose::{combined_dose, vibration_dose};
pub use weighting::{Weighting, weighted_velocity};

use crate::signal::SignalError;
use thiserror::Error;

/// Why a measure cannot be given.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum AssessmentError {
    /// The history or spectrum does not serve.
    #[error(transparent)]
    Signal(#[from] SignalError),
    /// No band contains the frequency.
    #[error("{frequency} Hz lies in no third-octave band: give a positive, finite frequency")]
    Frequency {
        /// [Hz]
        frequency: f64,
    },
    /// The range of bands is empty.
    #[error("the third-octave bands from {from} Hz to {to} Hz are none: give the lower frequency first")]
    Range {
        /// [Hz]
        from: f64,
        /// [Hz]
        to: f64,
    },
    /// A table of third octaves with a band left out, or one that comes too early.
    #[error("value number {} at {frequency} Hz stands where {wanted} Hz is wanted: third octaves must follow one another", index + 1)]
    Bands {
        /// From 0.
        index: usize,
        /// [Hz]
        frequency: f64,
        /// Nominal centre of the band that is missing [Hz].
        wanted: String,
    },
    /// A table that is none.
    #[error(
        "{frequencies} frequencies and {factors} factors: give one factor for each of one or more frequencies"
    )]
    Lengths {
        /// How many.
        frequencies: usize,
        /// How many.
        factors: usize,
    },
    /// A factor that has no meaning.
    #[error("the factor at {frequency} Hz is {factor}: it must be finite and not negative")]
    Factor {
        /// [Hz]
        frequency: f64,
        /// [1]
        factor: f64,
    },
    /// The time of a passage has no meaning.
    #[error("the passage time is {passage_time} s: it must be positive and finite")]
    PassageTime {
        /// [s]
        passage_time: f64,
    },
    /// Zero has no level.
    #[error("a velocity of {velocity} m/s has no level: it must be positive and finite")]
    Velocity {
        /// [m/s]
        velocity: f64,
    },
}
