//! What a track stands on: k(β, ω) [N/m²], nothing more.

mod filonenko_borodich;
mod hetenyi;
mod kerr;
mod layered_soil;
mod pasternak;
mod springs;
mod winkler;

pub use filonenko_borodich::FilonenkoBorodich;
pub use hetenyi::Hetenyi;
pub use kerr::Kerr;
pub use layered_soil::LayeredSoil;
pub use pasternak::Pasternak;
pub use springs::Springs;
pub use winkler::Winkler;

use crate::math::quadrature::miss;
use crate::quantity::OutOfRange;
use crate::soil::SoilError;
use crate::track::{Stack, TrackError, closed};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use thiserror::Error;

/// A published foundation of springs, by its parameters per metre of track. Source: section 2.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind", transform = closed)]
pub enum FoundationModel {
    /// Independent springs.
    Winkler(Winkler),
    /// Springs under a stretched membrane.
    FilonenkoBorodich(FilonenkoBorodich),
    /// Springs under a plate that bends.
    Hetenyi(Hetenyi),
    /// Springs under a layer that shears.
    Pasternak(Pasternak),
    /// Springs on a layer that shears, on springs.
    Kerr(Kerr),
    /// Rock under the last springs of the track: k = ∞.
    Rigid,
}

impl FoundationModel {
    /// Its members and links, to stand on rock.
    fn stack(&self) -> Result<Stack, TrackError> {
        match self {
            Self::Winkler(model) => model.stack(),
            Self::FilonenkoBorodich(model) => model.stack(),
            Self::Hetenyi(model) => model.stack(),
            Self::Pasternak(model) => model.stack(),
            Self::Kerr(model) => model.stack(),
            Self::Rigid => Ok(Stack::default()),
        }
    }

    /// What it is, and its author.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Winkler(_) => "independent springs (Winkler)",
            Self::FilonenkoBorodich(_) => "springs under a stretched membrane (Filonenko-Borodich)",
            Self::Hetenyi(_) => "springs under a plate that bends (Hetényi)",
            Self::Pasternak(_) => "springs under a layer that shears (Pasternak)",
            Self::Kerr(_) => "springs on a layer that shears, on springs (Kerr)",
            Self::Rigid => "rigid rock",
        }
    }
}

/// Relative accuracy of a stiffness asked for itself.
pub const ACCURACY: f64 = 1e-8;

/// A stiffness with what is known of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// k(β, ω) [N/m²]
    pub value: Complex64,
    /// Estimated relative error.
    pub relative_error: f64,
    /// False where the wanted accuracy was not reached.
    pub converged: bool,
    /// Evaluations of the ground it took.
    pub count: usize,
}

/// One question: k at (β, ω), how exactly, and in what company.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// β [rad/m]
    pub beta: f64,
    /// ω [rad/s]
    pub omega: f64,
    /// Relative accuracy wanted.
    pub relative: f64,
    /// What is asked along with it, to be computed in one way.
    pub among: Option<Among>,
}

/// Questions along the line of a moving load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Among {
    /// Lowest and highest |ω| [rad/s]; both zero at rest.
    pub omega: (f64, f64),
    /// Highest β [rad/m].
    pub beta: f64,
}

/// How k lies along the line of a moving load.
#[derive(Clone, Debug, PartialEq)]
pub enum Grain {
    /// It is a formula: asking is cheaper than any table.
    Formula,
    /// Smooth, and as exact as one asks.
    Smooth,
    /// Computed in another way in each of these pieces, ends in ln ω, [`LayeredSoil::MOVING_ACCURACY`] exact; what was dear at one ω
    /// serves all β.
    Pieces(Vec<f64>),
}

impl Stiffness {
    /// Error over what was allowed, `relative` of the value: at most 1 where that was met, or what was asked for.
    pub fn miss(&self, relative: f64) -> f64 {
        let factor = miss(self.relative_error, relative);
        if self.converged { factor.min(1.0) } else { factor }
    }
}

/// A foundation.
pub trait Foundation: Send + Sync {
    /// k(β, ω) [N/m²].
    ///
    /// # Errors
    /// Where the foundation has no finite stiffness there.
    fn answer(&self, asked: Asked) -> Result<Stiffness, FoundationError>;

    /// The same at wavenumber `beta` [rad/m] along the track and `omega` [rad/s], to a `relative` accuracy.
    ///
    /// # Errors
    /// As `answer`.
    fn stiffness_to(&self, beta: f64, omega: f64, relative: f64) -> Result<Stiffness, FoundationError> {
        self.answer(Asked { beta, omega, relative, among: None })
    }

    /// The same to 1e-8.
    ///
    /// # Errors
    /// As `answer`.
    fn stiffness(&self, beta: f64, omega: f64) -> Result<Stiffness, FoundationError> {
        self.stiffness_to(beta, omega, ACCURACY)
    }

    /// Refuses `omega` [rad/s] at which springs are none; a constant load asks at 0, whatever its speed.
    ///
    /// # Errors
    /// As [`Stack::check`].
    fn check(&self, _omega: f64) -> Result<(), FoundationError> {
        Ok(())
    }

    /// The springs it is, if it is one of springs.
    fn springs(&self) -> Option<&Springs> {
        None
    }

    /// How it is best asked along a line.
    fn grain(&self) -> Grain {
        Grain::Smooth
    }

    /// Told what will be asked next, so that threads at different speeds can share the work instead of waiting for one another.
    fn begin(&self, _next: &[Asked]) {}
}

/// Why a foundation cannot answer.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FoundationError {
    /// The ground cannot answer.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// Springs that cannot be built.
    #[error(transparent)]
    Track(#[from] TrackError),
    /// Waves of undamped ground are real poles of the integral.
    #[error(
        "the ground has no damping and the phase speed {phase_speed:.1} m/s exceeds its slowest wave ({slowest:.1} m/s): \
         the integral diverges; give every layer a loss factor above zero (0.001 is enough)"
    )]
    Undamped {
        /// |ω/β| [m/s]
        phase_speed: f64,
        /// Slowest Rayleigh speed [m/s].
        slowest: f64,
    },
}
