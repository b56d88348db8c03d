//! Which bodies of a vehicle on bogies move.

use super::{BodyError, BogieVehicle, Multibody};
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
    /// The wheelsets of a bogie, which bounces and pitches.
    Four,
    /// The same and half the body, which bounces.
    Five,
    /// All wheelsets, bogies and bodies, which bounce and pitch: ten degrees of freedom of a body on two bogies of two wheelsets.
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

    /// One `vehicle`, all of its wheelsets; `unsprung` [kg] replaces the mass of its wheelsets where they are alone.
    ///
    /// # Errors
    /// Those of [`BogieVehicle::checked`]; an unsprung mass that is not positive.
    pub fn of(self, vehicle: &BogieVehicle, unsprung: Option<f64>) -> Result<Multibody, BodyError> {
        let vehicle = vehicle.checked()?;
        let loads = vehicle.axle_loads();
        let model = match self {
            Self::Unsprung => {
                let mass = unsprung.unwrap_or(vehicle.wheelset.mass);
                Multibody::unsprung(mass, loads[0])?.row(&vehicle.positions())
            }
            Self::Two => Multibody::two(&vehicle)?.row(&vehicle.positions()),
            Self::Four => Multibody::four(&vehicle)?.row(&vehicle.bogie_places()),
            Self::Five => Multibody::five(&vehicle)?.row(&vehicle.bogie_places()),
            Self::Ten => Multibody::ten(&vehicle),
        };
        // bogies between two bodies carry more
        Ok(model?.with_loads(&loads))
    }
}
