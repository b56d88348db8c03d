//! Constant axle loads moving together: the quasi-static train.

use schemars::JsonSchema;
use serde::Deserialize;
use thiserror::Error;

/// One axle.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Axle {
    /// Distance behind the leading axle [m].
    pub position: f64,
    /// Static load of the whole axle [N].
    pub load: f64,
}

/// Axles in order of position, the first at the smallest.
#[derive(Clone, Debug, PartialEq)]
pub struct Train {
    axles: Vec<Axle>,
}

/// Why a train cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum VehicleError {
    /// No axle, or only zero loads.
    #[error("the train has no load: give at least one axle with a load above zero")]
    NoLoad,
    /// A load that is negative or not finite.
    #[error("axle {index} (counted from 1) has a load of {load} N: it must be finite and not negative")]
    Load {
        /// Which, from 1.
        index: usize,
        /// What was given [N].
        load: f64,
    },
    /// A position that is not finite.
    #[error("axle {index} (counted from 1) stands at {position} m: it must be finite")]
    Position {
        /// Which, from 1.
        index: usize,
        /// What was given [m].
        position: f64,
    },
}

impl Train {
    /// A train from its `axles` in any order.
    ///
    /// # Errors
    /// No load; a load negative or not finite; a position not finite.
    pub fn new(mut axles: Vec<Axle>) -> Result<Self, VehicleError> {
        for (i, axle) in axles.iter().enumerate() {
            let index = i + 1;
            if !(axle.load.is_finite() && axle.load >= 0.0) {
                return Err(VehicleError::Load { index, load: axle.load });
            }
            if !axle.position.is_finite() {
                return Err(VehicleError::Position { index, position: axle.position });
            }
        }
        if !axles.iter().any(|a| a.load > 0.0) {
            return Err(VehicleError::NoLoad);
        }
        axles.sort_by(|a, b| a.position.total_cmp(&b.position));
        Ok(Self { axles })
    }

    /// Axles, leading one first.
    pub fn axles(&self) -> &[Axle] {
        &self.axles
    }

    /// Distance between first and last axle [m].
    pub fn length(&self) -> f64 {
        self.axles[self.axles.len() - 1].position - self.axles[0].position
    }

    /// Sum of all loads [N].
    pub fn total_load(&self) -> f64 {
        self.axles.iter().map(|a| a.load).sum()
    }

    /// The heaviest axle alone, at position 0.
    pub fn heaviest_axle(&self) -> Self {
        let load = self.axles.iter().map(|a| a.load).fold(0.0, f64::max);
        Self { axles: vec![Axle { position: 0.0, load }] }
    }
}
