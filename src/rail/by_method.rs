//! Every layout of a track with every method that knows it.

use super::{Method, Moving, RailError, Receptance, continuous};
use crate::foundation::Foundation;
use crate::track::Layout;

/// How the rail of `layout` on the foundation `on` answers a force at rest, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub fn rail<'a>(
    layout: &'a Layout,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    match layout {
        Layout::Continuous(stack) => continuous::receptance(stack, on, method),
        Layout::Discrete(_) | Layout::Varying(_) => Err(RailError::Method {
            method: method.name(),
            track: "a track on supports",
            able: "floquet, dirac-comb, point-source, transfer-matrix, coupled",
        }),
    }
}

/// How the rail of `layout` on the foundation `on` answers a force that moves, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub fn moving<'a>(
    layout: &'a Layout,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Moving + 'a>, RailError> {
    match layout {
        Layout::Continuous(stack) => continuous::moving(stack, on, method),
        Layout::Discrete(_) | Layout::Varying(_) => Err(RailError::Method {
            method: method.name(),
            track: "a load that moves on a track on supports",
            able: "dirac-comb, moving-green",
        }),
    }
}
