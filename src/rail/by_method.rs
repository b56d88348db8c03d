//! Every layout of a track with every method that knows it.

use super::fem::FiniteElements;
use super::receptance::{Method, Moving, RailError, Receptance};
use super::{continuous, periodic};
use crate::foundation::{Foundation, Grain};
use crate::track::Layout;

impl Method {
    /// The best for a standing force on the rail of `layout` on `on`: exact where the springs of a support are its own.
    pub fn standing(layout: &Layout, on: &dyn Foundation) -> Self {
        match (layout, on.grain()) {
            (Layout::Continuous(_), Grain::Formula) => Self::Residues,
            (Layout::Continuous(_), _) => Self::Adaptive,
            (Layout::Discrete(supports), _) if supports.width.is_some() => Self::DiracComb,
            (Layout::Discrete(_), _) => Self::Floquet,
            (Layout::Varying(_), _) => Self::Coupled,
        }
    }
}

/// How the rail of `layout` on `on` answers a standing force, by `method`.
///
/// # Errors
/// A method that does not know such a track.
pub fn rail<'a>(
    layout: &'a Layout,
    on: &'a dyn Foundation,
    method: Method,
) -> Result<Box<dyn Receptance + 'a>, RailError> {
    match layout {
        _ if method == Method::FiniteElements => {
            Ok(Box::new(FiniteElements::new(layout, on, FiniteElements::PER_BAY)?))
        }
        Layout::Continuous(stack) => continuous::receptance(stack, on, method),
        Layout::Discrete(supports) => periodic::receptance(supports, on, method),
        Layout::Varying(sections) => periodic::over_sections(sections, on, method),
    }
}

/// How the rail of `layout` on `on` answers a force that moves, by `method`.
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
        Layout::Discrete(supports) => periodic::moving(supports, on, method),
        Layout::Varying(_) => Err(RailError::Method {
            method: method.name(),
            track: "a load that moves over sections",
            able: "none: give one section",
        }),
    }
}

/// Decay [dB/m] of the free wave along the rail of `layout` on `on` that decays least, at `omega` [rad/s]; by the roots of the track, or
/// another `method`.
///
/// # Errors
/// A track without free waves of its own, a method that does not know them.
pub fn free_decay(
    layout: &Layout,
    on: &dyn Foundation,
    method: Option<Method>,
    omega: f64,
) -> Result<f64, RailError> {
    match layout {
        Layout::Continuous(stack) => continuous::free_decay(stack, on, method, omega),
        Layout::Discrete(supports) => periodic::free_decay(supports, on, method, omega),
        Layout::Varying(_) => Err(RailError::Method {
            method: "floquet",
            track: "the free wave of sections one after another",
            able: "exact-receptance, en15461",
        }),
    }
}
