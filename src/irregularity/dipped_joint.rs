//! Joints of rails that dip, and the peak forces Jenkins gives for them.

use super::IrregularityError;
use crate::quantity::positive;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::PI;

/// How the rails come down to their joint.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum JointShape {
    /// r = α(l − |x|)
    V,
    /// r = α(l − |x|)²/(2l)
    Quadratic,
}

/// A joint at x = 0 to which both rails come down over a length l each, with an angle α each at the joint: 2α is the whole dip.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "DippedJoint")]
pub struct DippedJoint {
    /// V or quadratic.
    shape: JointShape,
    /// α of each side at the joint [rad]; the whole dip has 2α.
    angle: f64,
    /// l of each side [m].
    length: f64,
}

impl<'de> Deserialize<'de> for DippedJoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Self { shape, angle, length } = Self::deserialize(deserializer)?;
        Self::new(shape, angle, length).map_err(D::Error::custom)
    }
}

impl DippedJoint {
    /// A joint of `shape` with `angle` α [rad] and `length` l [m] of each side.
    ///
    /// # Errors
    /// An angle or a length that is not positive.
    pub fn new(shape: JointShape, angle: f64, length: f64) -> Result<Self, IrregularityError> {
        let (angle, length) = (positive("angle", angle, "rad")?, positive("length", length, "m")?);
        Ok(Self { shape, angle, length })
    }

    /// α of each side [rad].
    pub fn angle(&self) -> f64 {
        self.angle
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        let inside = (self.length - x.abs()).max(0.0);
        match self.shape {
            JointShape::V => self.angle * inside,
            JointShape::Quadratic => self.angle * inside * inside / (2.0 * self.length),
        }
    }
}

/// A track as one mass on a spring and a dashpot, as its static deflection u under a force shows it: ∫ (…) u² dx/u₀² each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LumpedTrack {
    /// K_t [N/m]
    pub stiffness: f64,
    /// M_t [kg]
    pub mass: f64,
    /// C_t [N s/m]
    pub damping: f64,
}

/// A wheel as Jenkins sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JenkinsWheel {
    /// P₀ [N]
    pub load: f64,
    /// M_u [kg]
    pub unsprung_mass: f64,
    /// v [m/s]
    pub speed: f64,
}

impl JenkinsWheel {
    /// P₂ = P₀ + 2αv √(M_u/(M_u + M_t)) (1 − πC_t/(4√(K_t(M_u + M_t)))) √(K_t M_u) [N] of a joint of `angle` α [rad] each side: the
    /// largest force of the **support** as wheel and track swing together.
    ///
    /// Accuracy: a formula of two masses; a track in elements differs by 10 to 20 %. Compare, do not equate.
    /// Source: Jenkins, Stephenson, Clayton, Morland & Lyon 1974, Railway Eng. J. 3(1), as usually quoted.
    pub fn p2(&self, angle: f64, track: &LumpedTrack) -> f64 {
        let together = self.unsprung_mass + track.mass;
        let share = (self.unsprung_mass / together).sqrt();
        let damped = 1.0 - PI * track.damping / (4.0 * (track.stiffness * together).sqrt());
        let stiff = (track.stiffness * self.unsprung_mass).sqrt();
        self.load + 2.0 * angle * self.speed * share * damped * stiff
    }

    /// P₁ = P₀ + 2αv √(k_H m_e/(1 + m_e/M_u)) [N]: the first peak, of the wheel on the contact spring `contact` k_H [N/m] against the
    /// `effective_mass` m_e [kg] of the rail.
    ///
    /// Source: as [`JenkinsWheel::p2`].
    pub fn p1(&self, angle: f64, contact: f64, effective_mass: f64) -> f64 {
        let mass = effective_mass / (1.0 + effective_mass / self.unsprung_mass);
        self.load + 2.0 * angle * self.speed * (contact * mass).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_have_the_angle_at_the_joint() {
        for shape in [JointShape::V, JointShape::Quadratic] {
            let joint = DippedJoint::new(shape, 0.005, 0.5).unwrap();
            let slope = |x: f64| (joint.at(x + 1e-6) - joint.at(x - 1e-6)) / 2e-6;
            // 1e-6/l of the quadratic one
            assert!((slope(-2e-6) - 0.005).abs() < 1e-7 && (slope(2e-6) + 0.005).abs() < 1e-7);
            assert_eq!([-0.6, -0.5, 0.5, 3.0].map(|x| joint.at(x)), [0.0; 4]);
        }
        let at = |shape, x| DippedJoint::new(shape, 0.005, 0.5).unwrap().at(x);
        assert_eq!(at(JointShape::V, 0.0), 2.5e-3);
        assert_eq!(at(JointShape::Quadratic, 0.0), 1.25e-3);
        assert!((at(JointShape::Quadratic, -0.25) - 0.005 * 0.0625).abs() < 1e-18);
        assert!(DippedJoint::new(JointShape::V, 0.0, 0.5).is_err());
    }
}
