//! The rail by another method: which may be asked, and how far apart both are.

use super::comparison::TOLERABLE;
use super::{Answer, StudyError};
use crate::concern::Concern;
use crate::rail::{Method, RailError};
use crate::railway::{Railway, RailwayError};

/// What another method says to the rail.
#[derive(Clone, Debug, PartialEq)]
pub struct Verified {
    /// The other method.
    pub method: Method,
    /// Largest difference over the largest value, or why there is none.
    pub difference: Result<f64, Box<StudyError>>,
}

impl Verified {
    pub(super) fn new(method: Method, difference: Result<f64, StudyError>) -> Self {
        Self { method, difference: difference.map_err(Box::new) }
    }

    pub(super) fn answer(&self) -> Option<Answer> {
        let difference = *self.difference.as_ref().ok().filter(|difference| difference.is_finite())?;
        let what = format!("Largest difference of the rail by {}, of the largest", self.method.name());
        Some(Answer::new("verified", what, difference, "1", format!("{difference:.1e}")))
    }

    pub(super) fn concern(&self) -> Option<Concern> {
        let name = self.method.name();
        match &self.difference {
            Ok(difference) if *difference <= TOLERABLE => None,
            Ok(difference) => Some(Concern::new(
                "methods-disagree",
                format!("{name} differs by {difference:.1e} of the largest"),
                "ask a third method; look for hysteretic loss under moving loads and for little damping",
            )),
            Err(error) => Some(Concern::new(
                "not-verified",
                format!("by {name}: {error}"),
                "verify with another method, or at other frequencies",
            )),
        }
    }
}

/// Refuses another `method` than the study's `own`, and one that is to verify itself.
pub(super) fn only(own: Method, method: Option<Method>, verify: Option<Method>) -> Option<RailwayError> {
    match (method, verify) {
        (Some(other), _) if other != own => {
            let (method, track, able) = (other.name(), "this study of such a track", own.name());
            Some(RailError::Method { method, track, able }.into())
        }
        (_, Some(second)) if second == own => Some(RailwayError::Itself { method: own.name() }),
        _ => None,
    }
}

/// Refuses a `method`, and another to `verify` it, that do not know the rail of `railway`, and a method that is to verify itself.
pub(super) fn known(
    railway: &Railway,
    method: Option<Method>,
    verify: Option<Method>,
) -> Result<(), RailwayError> {
    let method = railway.method(method)?;
    railway.receptance(method)?;
    match verify {
        Some(second) if second == method => Err(RailwayError::Itself { method: method.name() }),
        Some(second) => railway.receptance(second).map(drop),
        None => Ok(()),
    }
}
