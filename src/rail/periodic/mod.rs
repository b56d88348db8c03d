//! A rail on equal supports: what repeats from bay to bay, by several methods that must agree.

mod cell;
mod dirac_comb;
mod floquet;
mod landmarks;
mod span;

pub use cell::{Cell, Ground, Support};
pub use dirac_comb::DiracComb;
pub use floquet::{Floquet, FreeWave, FreeWaves};
pub use landmarks::{Band, Landmark, Undamped, pinned_pinned};

use super::{Method, Moving, RailError, Receptance};
use crate::foundation::Foundation;
use crate::track::{Section, Supports};

/// How the rail of `supports` on `on` answers a standing force, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub(super) fn receptance<'a>(
    supports: &'a Supports,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    Ok(match method {
        Method::Floquet => Box::new(Floquet::new(supports, on)?),
        Method::DiracComb => Box::new(DiracComb::new(supports, on)?),
        other => {
            return Err(RailError::Method {
                method: other.name(),
                track: "supports that stand apart",
                able: "floquet, dirac-comb",
            });
        }
    })
}

/// The same of a force that moves.
///
/// # Errors
/// A method that does not know such a track.
pub(super) fn moving<'a>(
    _supports: &'a Supports,
    _on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Moving + 'a>, RailError> {
    Err(RailError::Method { method: method.name(), track: "supports that stand apart", able: "none" })
}

/// The same of sections one after another.
///
/// # Errors
/// A method that does not know such a track.
pub(super) fn over_sections<'a>(
    _sections: &'a [Section],
    _on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    Err(RailError::Method { method: method.name(), track: "sections one after another", able: "none" })
}

/// Decay [dB/m] of the free wave from bay to bay that decays least, at `omega` [rad/s].
///
/// # Errors
/// Ground that joins the supports, a method that does not know the waves.
pub(super) fn free_decay(
    supports: &Supports,
    on: &dyn Foundation,
    method: Option<Method>,
    omega: f64,
) -> Result<f64, RailError> {
    match method {
        None | Some(Method::Floquet) => Ok(Floquet::new(supports, on)?.waves(omega)?.decay_rate()),
        Some(other) => Err(RailError::Method {
            method: other.name(),
            track: "the free wave from bay to bay",
            able: "floquet",
        }),
    }
}
