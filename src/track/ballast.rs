//! How the ballast of a track is modelled, per metre of whole track.

use super::link::{Spring, closed};
use super::{Link, Member, TrackError};
use crate::quantity::{between, not_negative, positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// Ballast between sleepers and ground: `track.ballast` of a case file.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind", transform = closed)]
pub enum Ballast {
    /// Vertical bars with wave motion over the contact width (Alves Costa et al., A.2).
    Bars {
        /// E_b [Pa]
        young: f64,
        /// h [m]
        height: f64,
        /// α: share of the contact width that carries.
        alpha: f64,
        /// C_b [m/s], or density with poisson.
        wave_speed: Option<f64>,
        /// ρ_b [kg/m³]: C_b = √(E_b/ρ_b), or from the constrained modulus with poisson.
        density: Option<f64>,
        /// ν_b
        poisson: Option<f64>,
        /// η of E_b
        #[serde(default)]
        loss_factor: f64,
    },
    /// Springs with consistent mass (Sheng et al., A.3).
    ConsistentMass {
        /// k_b [N/m²]
        stiffness: f64,
        /// c_b [N s/m²]
        #[serde(default)]
        damping: f64,
        /// η
        #[serde(default)]
        loss_factor: f64,
        /// m_b [kg/m]
        mass: f64,
    },
    /// Springs, or another element, without mass: two layers, on rock or on more springs.
    Spring {
        /// k_b, or the element
        #[serde(rename = "$rest:stiffness")]
        #[schemars(flatten, with = "Spring")]
        spring: Link,
    },
    /// The same above a mass that lies on the foundation: three layers, on springs.
    Block {
        /// m_b [kg/m]
        mass: f64,
        /// Between the blocks under neighbouring supports, k_w [N/m] and c_w [N s/m], or the element
        #[schemars(with = "Option<Spring>")]
        link: Option<Link>,
        /// k_b, or the element
        #[serde(rename = "$rest:stiffness")]
        #[schemars(flatten, with = "Spring")]
        spring: Link,
    },
}

impl Ballast {
    /// The link between sleepers and base; `half_width` b [m] is half of what the track touches.
    pub(super) fn link(&self, half_width: Option<f64>) -> Result<Link, TrackError> {
        Ok(match *self {
            Self::Bars { young, height, alpha, wave_speed, density, poisson, loss_factor } => {
                let young = positive("ballast.young", young, "Pa")?;
                let half_width = half_width.ok_or(TrackError::ContactWidth)?;
                Link::Bars {
                    // area 2αb per metre of track
                    axial_stiffness: 2.0
                        * positive("ballast.alpha", alpha, "")?
                        * positive("contact.half_width", half_width, "m")?
                        * young,
                    height: positive("ballast.height", height, "m")?,
                    wave_speed: bar_speed(young, wave_speed, density, poisson)?,
                    loss_factor: not_negative("ballast.loss_factor", loss_factor, "")?,
                }
            }
            Self::ConsistentMass { stiffness, damping, loss_factor, mass } => Link::ConsistentMass {
                stiffness: positive("ballast.stiffness", stiffness, "N/m²")?,
                damping: not_negative("ballast.damping", damping, "N s/m²")?,
                loss_factor: not_negative("ballast.loss_factor", loss_factor, "")?,
                mass: not_negative("ballast.mass", mass, "kg/m")?,
            },
            Self::Spring { spring } | Self::Block { spring, .. } => spring,
        })
    }

    /// The mass at its foot; None for the massless base.
    pub(super) fn foot(&self) -> Result<Option<Member>, TrackError> {
        match *self {
            Self::Block { mass, .. } => Ok(Some(Member::mass(not_negative("ballast.mass", mass, "kg/m")?)?)),
            _ => Ok(None),
        }
    }
}

/// C_b [m/s]: as given, or √(E/ρ), or √(M/ρ) with the constrained modulus M = E(1 − ν)/((1 + ν)(1 − 2ν)).
fn bar_speed(
    young: f64,
    wave_speed: Option<f64>,
    density: Option<f64>,
    poisson: Option<f64>,
) -> Result<f64, TrackError> {
    match (wave_speed, density, poisson) {
        (Some(speed), None, None) => Ok(positive("ballast.wave_speed", speed, "m/s")?),
        (None, Some(density), poisson) => {
            let density = positive("ballast.density", density, "kg/m³")?;
            let nu = between("ballast.poisson", poisson.unwrap_or(0.0), "", (-1.0, 0.5))?;
            Ok((young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) / density).sqrt())
        }
        (Some(_), ..) => Err(TrackError::WaveSpeedTwice),
        (None, None, _) => Err(TrackError::WaveSpeedMissing),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_know_their_wave_speed_once() {
        let link = |wave_speed, density, poisson| {
            let bars = Ballast::Bars {
                young: 1.3e8,
                height: 0.35,
                alpha: 0.5,
                wave_speed,
                density,
                poisson,
                loss_factor: 0.0,
            };
            bars.link(Some(1.25))
        };
        let speed = |link| match link {
            Ok(Link::Bars { wave_speed, .. }) => wave_speed,
            other => panic!("{other:?}"),
        };
        assert_eq!(speed(link(Some(333.0), None, None)), 333.0);
        assert_eq!(speed(link(None, Some(1700.0), None)), (1.3e8f64 / 1700.0).sqrt());
        // M/E = 0.8/(1.2 × 0.6) at ν = 0.2; measured 1e-16
        let constrained = speed(link(None, Some(1700.0), Some(0.2))).powi(2) * 1700.0 / 1.3e8;
        assert!((constrained * 0.72 / 0.8 - 1.0).abs() < 1e-14);
        assert_eq!(link(None, None, Some(0.2)), Err(TrackError::WaveSpeedMissing));
        assert_eq!(link(Some(333.0), Some(1700.0), None), Err(TrackError::WaveSpeedTwice));
        assert!(
            link(None, Some(1700.0), Some(0.5)).is_err_and(|e| e.to_string().contains("ballast.poisson"))
        );
    }
}
