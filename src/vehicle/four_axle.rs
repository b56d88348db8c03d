//! Masses, springs and lengths of a vehicle on two bogies.

use super::BodyError;
use crate::quantity::{not_negative, positive};

/// g of static axle loads [m/s²].
pub const GRAVITY: f64 = 9.81;

/// A suspension, both sides of the vehicle together: k + iωc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suspension {
    /// k [N/m]
    pub stiffness: f64,
    /// c [N s/m]
    pub damping: f64,
}

/// What a vehicle on two bogies with two wheelsets each is made of; whole vehicle, both rails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourAxle {
    /// Body [kg].
    pub body_mass: f64,
    /// Body about its centre [kg m²].
    pub body_pitch_inertia: f64,
    /// Between the centres of the bogies [m].
    pub bogie_centres: f64,
    /// One bogie without wheelsets [kg].
    pub bogie_mass: f64,
    /// One bogie about its centre [kg m²].
    pub bogie_pitch_inertia: f64,
    /// Between the wheelsets of a bogie [m].
    pub wheelbase: f64,
    /// One wheelset, with all that is unsprung [kg].
    pub wheelset_mass: f64,
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
            ("body.mass", self.body_mass, "kg"),
            ("body.pitch_inertia", self.body_pitch_inertia, "kg m²"),
            ("body.bogie_centres", self.bogie_centres, "m"),
            ("bogie.mass", self.bogie_mass, "kg"),
            ("bogie.pitch_inertia", self.bogie_pitch_inertia, "kg m²"),
            ("bogie.wheelbase", self.wheelbase, "m"),
            ("wheelset.mass", self.wheelset_mass, "kg"),
            ("primary.stiffness", self.primary.stiffness, "N/m"),
            ("secondary.stiffness", self.secondary.stiffness, "N/m"),
        ] {
            positive(key, value, unit)?;
        }
        not_negative("primary.damping", self.primary.damping, "N s/m")?;
        not_negative("secondary.damping", self.secondary.damping, "N s/m")?;
        if self.wheelbase >= self.bogie_centres {
            return Err(BodyError::BogiesOverlap {
                wheelbase: self.wheelbase,
                bogie_centres: self.bogie_centres,
            });
        }
        Ok(self)
    }

    /// Body, two bogies and four wheelsets [kg].
    pub fn total_mass(&self) -> f64 {
        self.body_mass + 2.0 * self.bogie_mass + 4.0 * self.wheelset_mass
    }

    /// Static load of each axle [N]: a quarter of the weight, g = 9.81 m/s².
    pub fn axle_load(&self) -> f64 {
        0.25 * self.total_mass() * GRAVITY
    }

    /// Places of the four wheelsets behind the leading one [m].
    pub fn positions(&self) -> [f64; 4] {
        [0.0, self.wheelbase, self.bogie_centres, self.bogie_centres + self.wheelbase]
    }
}
