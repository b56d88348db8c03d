//! How a rail answers a force, whatever the method: the questions, and what they may be refused for.

use super::drive::Drive;
use super::fem::FemError;
use super::track_on_foundation::InteractionError;
use crate::foundation::FoundationError;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use thiserror::Error;

/// A displacement per unit force [m/N], positive down, with what is known of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The displacement.
    pub value: Complex64,
    /// Estimated absolute error.
    pub error: f64,
}

impl Answer {
    /// Exact to rounding: what a closed form says.
    pub fn exact(value: Complex64) -> Self {
        Self { value, error: 1e-13 * value.norm() }
    }
}

/// How the rail at x answers a unit force e^{iωt} at `from`, both at rest.
pub trait Receptance: Send + Sync {
    /// α(x, from) [m/N] at every `x` [m] and `omega` > 0 [rad/s].
    ///
    /// # Errors
    /// What the method cannot do there.
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError>;

    /// After what distance [m] the track repeats: Some(0) where it is uniform, None where it never does.
    fn period(&self) -> Option<f64>;
}

/// How the rail answers a unit force e^{iω̃t} that moves, seen from it.
pub trait Moving: Send + Sync {
    /// w(x′) e^{−iω̃t} [m/N] at every `x` = x′ [m], positive ahead of the force, at the moment when that stands at `phase` [m] past a
    /// support; a uniform track does not ask where.
    ///
    /// # Errors
    /// What the method cannot do there.
    fn under(&self, drive: Drive, phase: f64, x: &[f64]) -> Result<Vec<Answer>, RailError>;
}

/// Ways to answer for a rail.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Adaptive panels along β: any foundation under a continuous track.
    Adaptive,
    /// Waves of the rail on springs, Eqs (30)–(32).
    ClosedForm,
    /// Residues of the poles of ũ(β), Eqs (43)–(48).
    Residues,
    /// Waves that meet the force's jump, Eq. (49).
    BoundaryValues,
    /// Discrete Fourier transform along β, Eqs (33)–(38), its slow tail taken out.
    Fourier,
    /// Filon's rule on uneven samples of β, Eqs (39)–(42).
    Filon,
    /// Waves from bay to bay in closed form, Eqs (71)–(74).
    Floquet,
    /// Images in the wavenumber, Eqs (57)–(61).
    DiracComb,
    /// Every support a force on the bare rail, Eqs (50)–(55).
    PointSource,
    /// The receptance at all places of the moving force, Eqs (62)–(64).
    MovingGreen,
    /// The state carried through one bay, Eqs (65)–(70).
    TransferMatrix,
    /// Sections whose waves meet at their ends, Eqs (75)–(79).
    Coupled,
    /// Finite elements between exact ends, Eqs (26)–(28).
    FiniteElements,
}

impl Method {
    /// As a case file spells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Adaptive => "adaptive",
            Self::ClosedForm => "closed-form",
            Self::Residues => "residues",
            Self::BoundaryValues => "boundary-values",
            Self::Fourier => "fourier",
            Self::Filon => "filon",
            Self::Floquet => "floquet",
            Self::DiracComb => "dirac-comb",
            Self::PointSource => "point-source",
            Self::MovingGreen => "moving-green",
            Self::TransferMatrix => "transfer-matrix",
            Self::Coupled => "coupled",
            Self::FiniteElements => "finite-elements",
        }
    }
}

/// Why a rail cannot answer.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RailError {
    /// The foundation cannot answer.
    #[error(transparent)]
    Foundation(#[from] FoundationError),
    /// A track without finite elements.
    #[error(transparent)]
    Elements(#[from] FemError),
    /// A response without end.
    #[error(transparent)]
    Interaction(#[from] InteractionError),
    /// A method that does not know such a track.
    #[error("method \"{method}\" does not know {track}; methods that do: {able}")]
    Method {
        /// Its name.
        method: &'static str,
        /// What it does not know.
        track: &'static str,
        /// Those that do.
        able: &'static str,
    },
    /// Ground that joins the supports, under sleepers without a width.
    #[error(
        "the ground joins the supports, and a sleeper without a width along the track would sink into it: give the width of \
         the sleepers, or springs of its own to every support"
    )]
    Width,
    /// A load faster than the method allows.
    #[error("{speed:.1} m/s is at or above {limit:.1} m/s, {what}: method \"{method}\" has no answer there")]
    TooFast {
        /// v [m/s]
        speed: f64,
        /// [m/s]
        limit: f64,
        /// What runs as fast.
        what: &'static str,
        /// Its name.
        method: &'static str,
    },
    /// An integral or a sum that did not settle.
    #[error(
        "method \"{method}\" did not settle at {frequency:.4} Hz (error {error:.1e} of the answer): {remedy}"
    )]
    Unsettled {
        /// Its name.
        method: &'static str,
        /// f [Hz]
        frequency: f64,
        /// Relative.
        error: f64,
        /// What helps.
        remedy: &'static str,
    },
}
