//! Masses, springs and lengths of a vehicle on bogies: two of them, or, articulated, one between each body and the next.

use super::BodyError;
use crate::quantity::{not_negative, positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// Most bodies of an articulated vehicle.
const MOST_BODIES: usize = 100;

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
    /// Bodies one behind the other that share the bogies between them: an articulated vehicle where there are more than one.
    #[serde(default = "one")]
    pub count: usize,
}

fn one() -> usize {
    1
}

/// A bogie.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Bogie {
    /// Without wheelsets [kg].
    pub mass: f64,
    /// About its centre [kg m²].
    pub pitch_inertia: f64,
    /// Between the first and the last of its wheelsets [m].
    pub wheelbase: f64,
    /// Its wheelsets, evenly apart: 2, or 3.
    #[serde(default = "two")]
    pub wheelsets: usize,
}

fn two() -> usize {
    2
}

/// A wheelset.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wheelset {
    /// With all that is unsprung [kg].
    pub mass: f64,
}

/// What a vehicle on bogies is made of; both rails. Of an articulated one every body end stands on a suspension of its own, so that all bodies are
/// level at rest: a bogie that two bodies share has two of them, and carries twice what an end bogie carries of bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BogieVehicle {
    /// Each of them.
    pub body: Body,
    /// Each of them: one more than bodies.
    pub bogie: Bogie,
    /// Each of them.
    pub wheelset: Wheelset,
    /// Of one wheelset.
    pub primary: Suspension,
    /// Under one end of a body, at the centre of the bogie.
    pub secondary: Suspension,
}

impl BogieVehicle {
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
        if !(1..=MOST_BODIES).contains(&self.body.count) {
            return Err(BodyError::Count {
                key: "body.count",
                count: self.body.count,
                allowed: (1, MOST_BODIES),
            });
        }
        if !(2..=3).contains(&self.bogie.wheelsets) {
            return Err(BodyError::Count {
                key: "bogie.wheelsets",
                count: self.bogie.wheelsets,
                allowed: (2, 3),
            });
        }
        if self.bogie.wheelbase >= self.body.bogie_centres {
            return Err(BodyError::BogiesOverlap {
                wheelbase: self.bogie.wheelbase,
                bogie_centres: self.body.bogie_centres,
            });
        }
        Ok(self)
    }

    /// How many bogies there are: one more than bodies.
    pub fn bogies(&self) -> usize {
        self.body.count + 1
    }

    /// Bodies, bogies and wheelsets [kg].
    pub fn total_mass(&self) -> f64 {
        let bogie = self.bogie.mass + self.bogie.wheelsets as f64 * self.wheelset.mass;
        self.body.count as f64 * self.body.mass + self.bogies() as f64 * bogie
    }

    /// Static load of each axle [N], leading one first: its wheelset, its part of the bogie, and of half a body for each body on that
    /// bogie, g = 9.81 m/s².
    pub fn axle_loads(&self) -> Vec<f64> {
        let last = self.bogies() - 1;
        let on = |bogie: usize| if bogie == 0 || bogie == last { 0.5 } else { 1.0 };
        let sprung = |bogie: usize| self.bogie.mass + on(bogie) * self.body.mass;
        let load =
            |bogie: usize| GRAVITY * (self.wheelset.mass + sprung(bogie) / self.bogie.wheelsets as f64);
        (0..=last).flat_map(|bogie| std::iter::repeat_n(load(bogie), self.bogie.wheelsets)).collect()
    }

    /// Places of the leading wheelsets of all bogies behind the first one [m].
    pub fn bogie_places(&self) -> Vec<f64> {
        (0..self.bogies()).map(|bogie| self.body.bogie_centres * bogie as f64).collect()
    }

    /// Places of the wheelsets of a bogie behind its leading one [m].
    pub fn wheelset_places(&self) -> Vec<f64> {
        let gaps = self.bogie.wheelsets - 1;
        (0..=gaps).map(|i| self.bogie.wheelbase * i as f64 / gaps as f64).collect()
    }

    /// Places of all wheelsets behind the leading one [m].
    pub fn positions(&self) -> Vec<f64> {
        let wheelsets = self.wheelset_places();
        self.bogie_places().iter().flat_map(|bogie| wheelsets.iter().map(move |w| bogie + w)).collect()
    }

    /// Between the first and the last wheelset [m].
    pub fn span(&self) -> f64 {
        self.body.count as f64 * self.body.bogie_centres + self.bogie.wheelbase
    }
}
