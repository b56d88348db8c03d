//! A rail on equal supports: what repeats from bay to bay, by several methods that must agree.

mod cell;
mod coupled;
mod dirac_comb;
mod driven;
mod floquet;
mod landmarks;
mod moving_green;
mod passing;
mod point_source;
mod section;
mod section_forces;
mod span;
mod tail;
mod transfer_matrix;

pub use cell::{Cell, Ground, Support};
pub use coupled::{Coupled, Scattering};
pub use dirac_comb::DiracComb;
pub use floquet::{Floquet, FreeWave, FreeWaves};
pub use landmarks::{Band, Landmark, Undamped, pinned_pinned};
pub use moving_green::MovingGreen;
pub use passing::Passage;
pub use point_source::PointSource;
pub use section_forces::SectionForces;
pub use transfer_matrix::TransferMatrix;

use crate::foundation::Foundation;
use crate::rail::{Method, Moving, RailError, Receptance};
use crate::track::{Section, Supports};

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
        _ => refused(
            method,
            "equal supports",
            "floquet, dirac-comb, point-source, transfer-matrix, finite-elements",
        ),
    }
}

/// How the rail of `sections` one after another on `on` answers a standing force, by `method`.
///
/// # Errors
/// A method that does not know sections; what [`Coupled::new`] refuses.
pub(in crate::rail) fn over_sections<'a>(
    sections: &'a [Section],
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    match method {
        Method::Coupled => Ok(Box::new(Coupled::new(sections, on)?)),
        Method::PointSource => Ok(Box::new(SectionForces::new(sections, on)?)),
        _ => refused(method, "sections one after another", "coupled, point-source, finite-elements"),
    }
}

/// How the rail of `supports` on `on` answers a force that moves, by `method`.
///
/// # Errors
/// A method that does not know forces that move over equal supports, or not those; a foundation that cannot answer.
pub(in crate::rail) fn moving<'a>(
    supports: &'a Supports,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Moving + 'a>, RailError> {
    match method {
        Method::DiracComb => Ok(Box::new(DiracComb::new(supports, on)?)),
        Method::MovingGreen => Ok(Box::new(MovingGreen::new(supports, on)?)),
        _ => refused(method, "a force that moves over equal supports", "dirac-comb, moving-green"),
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
        None | Some(Method::Floquet) if supports.width.is_some() => {
            let waves = "the free wave of supports that the ground joins, which has no closed form";
            refused(Method::Floquet, waves, "exact-receptance, en15461")
        }
        None | Some(Method::Floquet) => Ok(Floquet::new(supports, on)?.waves(omega)?.decay_rate()),
        Some(method) => refused(method, "the free waves of equal supports", "floquet"),
    }
}
