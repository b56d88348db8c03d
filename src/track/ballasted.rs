//! Ballasted tracks: rails, pads, sleepers and ballast, per metre of whole track (both rails).

use super::{Link, Member, Stack, TrackError};
use crate::quantity::{not_negative, positive};

/// How the ballast is modelled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ballast {
    /// Vertical bars with wave motion over the contact width (Alves Costa et al., A.2).
    Bars {
        /// E_b [Pa]
        young: f64,
        /// h [m]
        height: f64,
        /// α: share of the contact width that carries.
        alpha: f64,
        /// C_b [m/s]: √(E_b/ρ_b), or from the constrained modulus.
        wave_speed: f64,
        /// b [m]: half the contact width.
        half_width: f64,
        /// η of E_b
        loss_factor: f64,
    },
    /// Springs with consistent mass (Sheng et al., A.3).
    ConsistentMass {
        /// k_b [N/m²]
        stiffness: f64,
        /// c_b [N s/m²]
        damping: f64,
        /// η
        loss_factor: f64,
        /// m_b [kg/m]
        mass: f64,
    },
}

/// A ballasted track. Source: appendix A.2 (corrected) and A.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ballasted {
    /// Both rails.
    pub rail: Member,
    /// Pads of both rails.
    pub pad: Link,
    /// Sleepers [kg/m].
    pub sleeper_mass: f64,
    /// Ballast.
    pub ballast: Ballast,
}

impl Ballasted {
    /// The stack rail – pads – sleepers – ballast – base.
    ///
    /// # Errors
    /// A quantity out of its range.
    pub fn stack(&self) -> Result<Stack, TrackError> {
        let ballast = match self.ballast {
            Ballast::Bars { young, height, alpha, wave_speed, half_width, loss_factor } => Link::Bars {
                // area 2αb per metre of track
                axial_stiffness: 2.0
                    * positive("alpha", alpha, "")?
                    * positive("half_width", half_width, "m")?
                    * positive("young", young, "Pa")?,
                height: positive("height", height, "m")?,
                wave_speed: positive("wave_speed", wave_speed, "m/s")?,
                loss_factor: not_negative("loss_factor", loss_factor, "")?,
            },
            Ballast::ConsistentMass { stiffness, damping, loss_factor, mass } => Link::ConsistentMass {
                stiffness: positive("stiffness", stiffness, "N/m²")?,
                damping: not_negative("damping", damping, "N s/m²")?,
                loss_factor: not_negative("loss_factor", loss_factor, "")?,
                mass: not_negative("mass", mass, "kg/m")?,
            },
        };
        Ok(Stack::new(vec![self.rail, Member::mass(self.sleeper_mass)?], vec![self.pad, ballast]))
    }
}
