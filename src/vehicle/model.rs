//! Which bodies of a vehicle on two bogies move.

use super::{BodyError, FourAxle, Multibody};
use schemars::JsonSchema;
use serde::Deserialize;

/// A model of a vehicle, by how many bodies move or how they can (Fig. 9).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum VehicleModel {
    /// The wheelsets alone.
    Unsprung,
    /// Wheelset, half a bogie.
    Two,
    /// Two wheelsets, a bogie that bounces and pitches.
    Four,
    /// The same and half the body, which bounces.
    Five,
    /// Four wheelsets, two bogies and the body, which bounce and pitch.
    Ten,
}

impl VehicleModel {
    /// As a case file says it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unsprung => "unsprung",
            Self::Two => "two",
            Self::Four => "four",
            Self::Five => "five",
            Self::Ten => "ten",
        }
    }

    /// One `vehicle`, all four wheelsets; `unsprung` [kg] replaces the mass of its wheelsets where they are alone.
    ///
    /// # Errors
    /// Those of [`FourAxle::checked`]; an unsprung mass that is not positive.
    pub fn of(self, vehicle: &FourAxle, unsprung: Option<f64>) -> Result<Multibody, BodyError> {
        let bogies = [0.0, vehicle.body.bogie_centres];
        match self {
            Self::Unsprung => {
                let mass = unsprung.unwrap_or(vehicle.wheelset.mass);
                Multibody::unsprung(mass, vehicle.axle_load())?.row(&vehicle.positions())
            }
            Self::Two => Multibody::two(vehicle)?.row(&vehicle.positions()),
            Self::Four => Multibody::four(vehicle)?.row(&bogies),
            Self::Five => Multibody::five(vehicle)?.row(&bogies),
            Self::Ten => Multibody::ten(vehicle),
        }
    }
}
