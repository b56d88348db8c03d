//! Methods for a rail that is carried without interruption.

mod adaptive;
mod boundary_values;
mod closed_form;
mod filon;
mod fourier;
mod residues;
mod uniform;

pub use residues::Departing;
pub(super) use residues::along;

use super::{Method, Moving, RailError, Receptance};
use crate::foundation::Foundation;
use crate::track::Stack;
use adaptive::Adaptive;
use boundary_values::BoundaryValues;
use closed_form::ClosedForm;
use filon::Filon;
use fourier::Fourier;
use residues::Residues;
use uniform::Uniform;

/// Methods that know a uniform track.
const ABLE: &str = "adaptive, closed-form, residues, boundary-values, fourier, filon, finite-elements";

/// How the rail of `stack` on `on` answers a standing force, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub(super) fn receptance<'a>(
    stack: &'a Stack,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    let uniform = Uniform::new(stack, on);
    if method != Method::Adaptive {
        uniform.tower(method.name())?;
    }
    Ok(match method {
        Method::Adaptive => Box::new(Adaptive(uniform)),
        Method::Fourier => Box::new(Fourier(uniform)),
        Method::Filon => Box::new(Filon(uniform)),
        Method::ClosedForm => Box::new(ClosedForm(uniform).known()?),
        Method::Residues => Box::new(Residues(uniform)),
        Method::BoundaryValues => Box::new(BoundaryValues(uniform)),
        other => {
            return Err(RailError::Method {
                method: other.name(),
                track: "a track without spacing",
                able: ABLE,
            });
        }
    })
}

/// How the rail of `stack` on `on` answers a force that moves, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub(super) fn moving<'a>(
    stack: &'a Stack,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Moving + 'a>, RailError> {
    let uniform = Uniform::new(stack, on);
    Ok(match method {
        Method::Adaptive => Box::new(Adaptive(uniform)),
        Method::Residues => {
            uniform.tower(method.name())?;
            Box::new(Residues(uniform))
        }
        other => {
            return Err(RailError::Method {
                method: other.name(),
                track: "a load that moves on a track without spacing",
                able: "adaptive, residues",
            });
        }
    })
}

/// Decay [dB/m] of the free wave along `stack` on `on` that decays least, at `omega` [rad/s]: 20/ln 10 · min |Im γ|. Source: Eq. (94).
///
/// # Errors
/// A track on layered ground, a method that does not know its waves.
pub(super) fn free_decay(
    stack: &Stack,
    on: &dyn Foundation,
    method: Option<Method>,
    omega: f64,
) -> Result<f64, RailError> {
    let uniform = Uniform::new(stack, on);
    let gamma = match method {
        None | Some(Method::Residues) => {
            let name = Method::Residues.name();
            Departing::new(uniform.tower(name)?, omega).ok_or(uniform.unknown(name))?.gamma
        }
        Some(Method::ClosedForm) => ClosedForm(uniform).known()?.waves(omega)?.gamma.to_vec(),
        Some(other) => {
            return Err(RailError::Method {
                method: other.name(),
                track: "the free wave of a track without spacing",
                able: "residues, closed-form",
            });
        }
    };
    let least = gamma.iter().map(|gamma| gamma.im.abs()).fold(f64::INFINITY, f64::min);
    Ok(20.0 / std::f64::consts::LN_10 * least)
}
