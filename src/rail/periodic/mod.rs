//! A rail on equal supports: what repeats from bay to bay, by several methods that must agree.

mod cell;
mod dirac_comb;
mod floquet;
mod landmarks;
mod point_source;
mod span;
mod transfer_matrix;

pub use cell::{Cell, Ground, Support};
pub use dirac_comb::DiracComb;
pub use floquet::{Floquet, FreeWave, FreeWaves};
pub use landmarks::{Band, Landmark, Undamped, pinned_pinned};
pub use point_source::PointSource;
pub use transfer_matrix::TransferMatrix;

use crate::foundation::Foundation;
use crate::rail::{Method, RailError, Receptance};
use crate::track::Supports;

/// Refuses `method` for `track`.
fn refused<T>(method: Method, track: &'static str, able: &'static str) -> Result<T, RailError> {
    Err(RailError::Method { method: method.name(), track, able })
}

/// How the rail of `supports` on `on` answers a standing force, by `method`.
///
/// # Errors
/// A method that does not know equal supports, or not those; a foundation that cannot answer.
pub(in crate::rail) fn receptance<'a>(
    supports: &'a Supports,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    match method {
        Method::Floquet => Ok(Box::new(Floquet::new(supports, on)?)),
        Method::DiracComb => Ok(Box::new(DiracComb::new(supports, on)?)),
        Method::PointSource => Ok(Box::new(PointSource::new(supports, on)?)),
        Method::TransferMatrix => Ok(Box::new(TransferMatrix::new(supports, on)?)),
        _ => refused(method, "equal supports", "floquet, dirac-comb, point-source, transfer-matrix"),
    }
}

/// Decay [dB/m] of the free wave along the rail of `supports` on `on` that decays least, at `omega` [rad/s].
///
/// # Errors
/// A method without free waves; ground that joins the supports.
pub(in crate::rail) fn free_decay(
    supports: &Supports,
    on: &dyn Foundation,
    method: Option<Method>,
    omega: f64,
) -> Result<f64, RailError> {
    match method {
        None | Some(Method::Floquet) => Ok(Floquet::new(supports, on)?.waves(omega)?.decay_rate()),
        Some(method) => refused(method, "the free waves of equal supports", "floquet"),
    }
}
