//! Complex stiffnesses k*(ω) of what joins two degrees of freedom: springs and dashpots by their arrangement.

use crate::math::complex::{I, sign};
use crate::quantity::{not_negative, positive};
use crate::track::TrackError;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::{FRAC_2_PI, PI, TAU};

/// A massless element, per metre of track or per support as what it belongs to: `element` of a case file. Four arrangements of a
/// spring k₂ and dashpot c with one more spring k₁ or dashpot c₂ are all there are of three parts; their names say the arrangement.
/// Source: Fig. 4.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind", rename = "SpringElement")]
pub enum Element {
    /// Spring and dashpot abreast (Kelvin–Voigt), with hysteretic loss: k(1 + iη sgn ω) + iωc. Source: Eqs (19), (24).
    Spring {
        /// k [N/m²]
        stiffness: f64,
        /// c [N s/m²]
        #[serde(default)]
        damping: f64,
        /// η
        #[serde(default)]
        loss_factor: f64,
    },
    /// Spring and dashpot in series: iωck/(k + iωc); gives way at rest.
    Maxwell {
        /// k [N/m²]
        stiffness: f64,
        /// c [N s/m²]
        damping: f64,
    },
    /// A spring abreast of spring and dashpot in series: k₁ + iωck₂/(k₂ + iωc).
    Zener {
        /// k₁ of the spring that stands alone [N/m²]
        stiffness: f64,
        /// k₂ of the spring on the dashpot [N/m²]
        second_stiffness: f64,
        /// c [N s/m²]
        damping: f64,
    },
    /// A spring in series with spring and dashpot abreast: k₁(k₂ + iωc)/(k₁ + k₂ + iωc).
    #[serde(rename = "poynting-thomson-1")]
    PoyntingThomson1 {
        /// k₁ of the spring that stands alone [N/m²]
        stiffness: f64,
        /// k₂ of the spring beside the dashpot [N/m²]
        second_stiffness: f64,
        /// c [N s/m²]
        damping: f64,
    },
    /// A dashpot in series with spring and dashpot abreast: iωc₂(k₂ + iωc)/(k₂ + iω(c + c₂)); gives way at rest.
    #[serde(rename = "poynting-thomson-2")]
    PoyntingThomson2 {
        /// k₂ [N/m²]
        stiffness: f64,
        /// c of the dashpot beside the spring [N s/m²]
        damping: f64,
        /// c₂ of the dashpot that stands alone [N s/m²]
        second_damping: f64,
    },
    /// A dashpot abreast of spring and dashpot in series: iωc₂ + iωck₂/(k₂ + iωc); gives way at rest.
    DashpotParallelMaxwell {
        /// k₂ [N/m²]
        stiffness: f64,
        /// c of the dashpot on the spring [N s/m²]
        damping: f64,
        /// c₂ of the dashpot that stands alone [N s/m²]
        second_damping: f64,
    },
    /// Hysteretic loss that answers no force before it acts: k(1 + (2/π)η ln|ω/ε| + iη sgn ω); no spring at
    /// [`pushes_below`](Element::pushes_below) and under it. Source: Eq. (25).
    CausalHysteretic {
        /// k at the reference frequency [N/m²]
        stiffness: f64,
        /// η
        loss_factor: f64,
        /// ε/2π [Hz]
        reference_frequency: f64,
    },
}

impl Element {
    /// A spring of `stiffness` [N/m²], viscous `damping` [N s/m²] and `loss_factor`.
    ///
    /// # Errors
    /// A stiffness that is not positive, negative damping.
    pub fn spring(stiffness: f64, damping: f64, loss_factor: f64) -> Result<Self, TrackError> {
        Self::Spring { stiffness, damping, loss_factor }.checked()
    }

    /// The same element, if its numbers are in their range.
    ///
    /// # Errors
    /// A stiffness or frequency that is not positive, a negative loss factor; a damping that is negative, or zero where the element
    /// is one of several parts.
    pub fn checked(self) -> Result<Self, TrackError> {
        match self {
            Self::Spring { stiffness, damping, loss_factor } => {
                positive("stiffness", stiffness, "N/m²")?;
                not_negative("damping", damping, "N s/m²")?;
                not_negative("loss_factor", loss_factor, "")?;
            }
            Self::Maxwell { stiffness, damping } => {
                positive("element.stiffness", stiffness, "N/m²")?;
                positive("element.damping", damping, "N s/m²")?;
            }
            Self::Zener { stiffness, second_stiffness, damping }
            | Self::PoyntingThomson1 { stiffness, second_stiffness, damping } => {
                positive("element.stiffness", stiffness, "N/m²")?;
                positive("element.second_stiffness", second_stiffness, "N/m²")?;
                positive("element.damping", damping, "N s/m²")?;
            }
            Self::PoyntingThomson2 { stiffness, damping, second_damping }
            | Self::DashpotParallelMaxwell { stiffness, damping, second_damping } => {
                positive("element.stiffness", stiffness, "N/m²")?;
                positive("element.damping", damping, "N s/m²")?;
                positive("element.second_damping", second_damping, "N s/m²")?;
            }
            Self::CausalHysteretic { stiffness, loss_factor, reference_frequency } => {
                positive("element.stiffness", stiffness, "N/m²")?;
                positive("element.loss_factor", loss_factor, "")?;
                positive("element.reference_frequency", reference_frequency, "Hz")?;
            }
        }
        Ok(self)
    }

    /// `count` of them abreast.
    pub fn times(self, count: f64) -> Self {
        let mut all = self;
        match &mut all {
            Self::Spring { stiffness, damping, .. } | Self::Maxwell { stiffness, damping } => {
                (*stiffness, *damping) = (count * *stiffness, count * *damping);
            }
            Self::Zener { stiffness, second_stiffness: second, damping }
            | Self::PoyntingThomson1 { stiffness, second_stiffness: second, damping }
            | Self::PoyntingThomson2 { stiffness, damping, second_damping: second }
            | Self::DashpotParallelMaxwell { stiffness, damping, second_damping: second } => {
                (*stiffness, *second, *damping) = (count * *stiffness, count * *second, count * *damping);
            }
            Self::CausalHysteretic { stiffness, .. } => *stiffness *= count,
        }
        all
    }

    /// As a case file spells it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Spring { .. } => "spring",
            Self::Maxwell { .. } => "maxwell",
            Self::Zener { .. } => "zener",
            Self::PoyntingThomson1 { .. } => "poynting-thomson-1",
            Self::PoyntingThomson2 { .. } => "poynting-thomson-2",
            Self::DashpotParallelMaxwell { .. } => "dashpot-parallel-maxwell",
            Self::CausalHysteretic { .. } => "causal-hysteretic",
        }
    }

    /// The spring that is left where dashpots move freely and nothing is lost: that of rest; of causal hysteresis, that at the
    /// reference frequency.
    pub fn undamped(self) -> Self {
        let stiffness = match self {
            Self::Spring { stiffness, .. }
            | Self::Zener { stiffness, .. }
            | Self::CausalHysteretic { stiffness, .. } => stiffness,
            Self::PoyntingThomson1 { stiffness, second_stiffness, .. } => {
                stiffness * second_stiffness / (stiffness + second_stiffness)
            }
            Self::Maxwell { .. } | Self::PoyntingThomson2 { .. } | Self::DashpotParallelMaxwell { .. } => 0.0,
        };
        Self::Spring { stiffness, damping: 0.0, loss_factor: 0.0 }
    }

    /// k*(ω) [N/m²] at `omega` [rad/s], where [`check`](Self::check) has nothing against it.
    ///
    /// Accuracy: rounding (test `analytic::springs`).
    #[inline]
    pub fn stiffness(&self, omega: f64) -> Complex64 {
        // iωc
        let dashpot = |c: f64| Complex64::new(0.0, omega * c);
        match *self {
            Self::Spring { stiffness, damping, loss_factor } => {
                Complex64::new(stiffness, stiffness * loss_factor * sign(omega) + omega * damping)
            }
            Self::Maxwell { stiffness, damping } => in_series(stiffness.into(), dashpot(damping)),
            Self::Zener { stiffness, second_stiffness, damping } => {
                stiffness + in_series(second_stiffness.into(), dashpot(damping))
            }
            Self::PoyntingThomson1 { stiffness, second_stiffness, damping } => {
                in_series(stiffness.into(), second_stiffness + dashpot(damping))
            }
            Self::PoyntingThomson2 { stiffness, damping, second_damping } => {
                in_series(stiffness + dashpot(damping), dashpot(second_damping))
            }
            Self::DashpotParallelMaxwell { stiffness, damping, second_damping } => {
                dashpot(second_damping) + in_series(stiffness.into(), dashpot(damping))
            }
            Self::CausalHysteretic { stiffness, loss_factor, reference_frequency } => {
                let stiffened =
                    1.0 + FRAC_2_PI * loss_factor * (omega.abs() / (TAU * reference_frequency)).ln();
                stiffness * (stiffened + I * loss_factor * sign(omega))
            }
        }
    }

    /// ω [rad/s] under which Re k* < 0: ε e^{−π/2η} of causal hysteresis; 0 of all others.
    pub fn pushes_below(&self) -> f64 {
        match *self {
            Self::CausalHysteretic { loss_factor, reference_frequency, .. } => {
                TAU * reference_frequency * (-0.5 * PI / loss_factor).exp()
            }
            _ => 0.0,
        }
    }

    /// Refuses `omega` [rad/s] at which the element is no spring; a constant load asks at 0, whatever its speed.
    ///
    /// # Errors
    /// At 0 what gives way under any force; causal hysteresis where its stiffness is negative.
    pub fn check(&self, omega: f64) -> Result<(), TrackError> {
        let element = self.name();
        match self {
            Self::Maxwell { .. } | Self::PoyntingThomson2 { .. } | Self::DashpotParallelMaxwell { .. }
                if omega == 0.0 =>
            {
                Err(TrackError::NoStatics { element })
            }
            Self::CausalHysteretic { .. } if omega.abs() <= self.pushes_below() => {
                Err(TrackError::Pushes { frequency: omega.abs() / TAU, limit: self.pushes_below() / TAU })
            }
            _ => Ok(()),
        }
    }
}

/// ab/(a + b), of which the second may be zero.
fn in_series(a: Complex64, b: Complex64) -> Complex64 {
    a * b / (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_spring_is_refused_by_name() {
        let (stiffness, damping, second_damping) = (1e8, 1e5, 2e5);
        let creeps = [
            Element::Maxwell { stiffness, damping },
            Element::PoyntingThomson2 { stiffness, damping, second_damping },
            Element::DashpotParallelMaxwell { stiffness, damping, second_damping },
        ];
        for element in creeps {
            let error = element.check(0.0).unwrap_err();
            assert_eq!(error, TrackError::NoStatics { element: element.name() });
            assert!(element.check(1e-3).is_ok() && element.stiffness(0.0).norm() == 0.0);
        }
        let causal = Element::CausalHysteretic { stiffness, loss_factor: 0.2, reference_frequency: 100.0 };
        let limit = causal.pushes_below();
        // at its limit it is a dashpot; measured 9e-16
        assert!(causal.stiffness(limit).re.abs() < 1e-14 * stiffness);
        assert!(causal.check(1.01 * limit).is_ok() && causal.check(-limit).is_err());
        assert!(matches!(causal.check(0.0), Err(TrackError::Pushes { .. })));
        assert!(Element::spring(1e8, 0.0, 0.1).unwrap().check(0.0).is_ok());
    }

    #[test]
    fn without_loss_it_is_the_spring_of_rest() {
        let (stiffness, second_stiffness, damping) = (4.5e8, 3e8, 4e5);
        for element in [
            Element::Spring { stiffness, damping, loss_factor: 0.0 },
            Element::Zener { stiffness, second_stiffness, damping },
            Element::PoyntingThomson1 { stiffness, second_stiffness, damping },
            Element::Maxwell { stiffness, damping },
        ] {
            let (left, rest) = (element.undamped().stiffness(300.0), element.stiffness(0.0));
            assert!((left - rest).norm() <= 1e-15 * rest.norm(), "{element:?}");
        }
        assert!(Element::Zener { stiffness, second_stiffness: 0.0, damping }.checked().is_err());
        assert!(Element::Maxwell { stiffness, damping: -1.0 }.checked().is_err());
    }
}
