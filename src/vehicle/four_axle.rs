//! Masses, springs and lengths of a vehicle on two bogies.

use super::BodyError;
use crate::quantity::{not_negative, positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// g of static axle loads [m/s²].
pub const GRAVITY: f64 = 9.81;

/// A suspension, both sides of the vehicle together: k + iωc.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Suspension {
    /// k [N/m], both sides together.
    pub stiffness: f64,
    /// c [N s/m], both sides together.
    #[serde(default)]
    pub damping: f64,
}

/// The body of a vehicle.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// [kg]
    pub mass: f64,
    /// About its centre [kg m²].
    pub pitch_inertia: f64,
    /// Between the centres of the bogies [m].
    pub bogie_centres: f64,
}

/// A bogie with two wheelsets.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Bogie {
    /// Without wheelsets [kg].
    pub mass: f64,
    /// About its centre [kg m²].
    pub pitch_inertia: f64,
    /// Between the wheelsets [m].
    pub wheelbase: f64,
}

/// A wheelset.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wheelset {
    /// With all that is unsprung [kg].
    pub mass: f64,
}

/// What a vehicle on two bogies with two wheelsets each is made of; whole vehicle, both rails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourAxle {
    /// On both bogies.
    pub body: Body,
    /// Each of two.
    pub bogie: Bogie,
    /// Each of four.
    pub wheelset: Wheelset,
    /// Of one wheelset.
    pub primary: Suspension,
    /// Of one bogie, at its centre.
    pub secondary: Suspension,
}

impl FourAxle {
    /// The same vehicle, if every mass, inertia, length and stiffness is positive, no damping negative, and the bogies do not
    /// overlap.
    ///
    /// # Errors
    /// The first quantity out of its range.
    pub fn checked(self) -> Result<Self, BodyError> {
        for (key, value, unit) in [
            ("body.mass", self.body.mass, "kg"),
            ("body.pitch_inertia", self.body.pitch_inertia, "kg m²"),
            ("body.bogie_centres", self.body.bogie_centres, "m"),
            ("bogie.mass", self.bogie.mass, "kg"),
            ("bogie.pitch_inertia", self.bogie.pitch_inertia, "kg m²"),
            ("bogie.wheelbase", self.bogie.wheelbase, "m"),
            ("wheelset.mass", self.wheelset.mass, "kg"),
            ("primary.stiffness", self.primary.stiffness, "N/m"),
            ("secondary.stiffness", self.secondary.stiffness, "N/m"),
        ] {
            positive(key, value, unit)?;
        }
        not_negative("primary.damping", self.primary.damping, "N s/m")?;
        not_negative("secondary.damping", self.secondary.damping, "N s/m")?;
        if self.bogie.wheelbase >= self.body.bogie_centres {
            return Err(BodyError::BogiesOverlap {
                wheelbase: self.bogie.wheelbase,
                bogie_centres: self.body.bogie_centres,
            });
        }
        Ok(self)
    }

    /// Body, two bogies and four wheelsets [kg].
    pub fn total_mass(&self) -> f64 {
        self.body.mass + 2.0 * self.bogie.mass + 4.0 * self.wheelset.mass
    }

    /// Static load of each axle [N]: a quarter of the weight, g = 9.81 m/s².
    pub fn axle_load(&self) -> f64 {
        0.25 * self.total_mass() * GRAVITY
    }

    /// Places of the four wheelsets behind the leading one [m].
    pub fn positions(&self) -> [f64; 4] {
        [0.0, self.bogie.wheelbase, self.body.bogie_centres, self.body.bogie_centres + self.bogie.wheelbase]
    }
}
