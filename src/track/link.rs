//! What joins one member to the next: springs, bars with wave motion, springs with consistent mass.

use super::{Element, TrackError};
use crate::math::complex::sign;
use crate::quantity::keyed;
use num_complex::Complex64;
use schemars::{JsonSchema, Schema};
use serde::Deserialize as DeriveDeserialize;
use serde::de::{Deserialize, Deserializer, Error};

/// Stiffness of a link between an upper and a lower degree of freedom, [[upper, cross], [cross, lower]] [N/m²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkStiffness {
    /// Force above per displacement above, lower side fixed.
    pub upper: Complex64,
    /// Force above per displacement below.
    pub cross: Complex64,
    /// Force below per displacement below, upper side fixed.
    pub lower: Complex64,
}

impl LinkStiffness {
    /// r = −cross/(lower + K): displacement of the lower side per displacement of the upper one, where the lower side stands on
    /// `below` = K, infinite for rock.
    #[inline]
    pub(super) fn carried(&self, below: Complex64) -> Complex64 {
        if below.re == f64::INFINITY { Complex64::ZERO } else { -self.cross / (self.lower + below) }
    }

    /// upper + r cross, the stiffness seen from the upper side, as (upper + cross) + r (lower + cross + K): no difference of stiff
    /// springs.
    #[inline]
    pub(super) fn seen_above(&self, below: Complex64, carried: Complex64) -> Complex64 {
        if below.re == f64::INFINITY {
            return self.upper;
        }
        (self.upper + self.cross) + carried * (self.lower + self.cross + below)
    }
}

/// A vertical link, per metre of track; in a case file a spring or another element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Link {
    /// Springs and dashpots without mass: rail pads.
    Element(Element),
    /// Vertical bars under the sleepers, with compression waves (A.2): ballast of Alves Costa et al.
    Bars {
        /// 2αb E_b [N]: area per metre times modulus.
        axial_stiffness: f64,
        /// h [m]
        height: f64,
        /// C_b [m/s]
        wave_speed: f64,
        /// η of E_b
        loss_factor: f64,
    },
    /// A spring whose mass is distributed consistently (A.3): ballast of Sheng et al.
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

/// Springs as a case file says them.
#[derive(DeriveDeserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = stiffness_or_element)]
pub struct Spring {
    /// k [N/m²]
    stiffness: Option<f64>,
    /// c [N s/m²]; 0 by default
    damping: Option<f64>,
    /// η; 0 by default
    loss_factor: Option<f64>,
    /// Other arrangements of springs and dashpots, instead of the three
    element: Option<Element>,
}

/// Forbids all keys but those of each kind in words that every editor knows, as springs among them have put theirs there.
pub fn closed(schema: &mut Schema) {
    let kinds = schema.get_mut("oneOf").and_then(|kinds| kinds.as_array_mut());
    for kind in kinds.into_iter().flatten().filter_map(|kind| kind.as_object_mut()) {
        if let Some(none) = kind.remove("unevaluatedProperties") {
            kind.insert("additionalProperties".into(), none);
        }
    }
}

fn stiffness_or_element(schema: &mut Schema) {
    schema.insert(
        "oneOf".into(),
        serde_json::json!([{ "required": ["stiffness"] }, { "required": ["element"] }]),
    );
}

impl<'de> Deserialize<'de> for Link {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Spring { stiffness, damping, loss_factor, element } = Spring::deserialize(deserializer)?;
        let element = match (stiffness, element) {
            (Some(stiffness), None) => Element::Spring {
                stiffness,
                damping: damping.unwrap_or_default(),
                loss_factor: loss_factor.unwrap_or_default(),
            },
            (None, Some(element)) if damping.is_none() && loss_factor.is_none() => element,
            (None, None) => return Err(D::Error::missing_field("stiffness")),
            (_, Some(_)) => {
                let more = "an element has all its springs and dashpots in its own table: remove stiffness, damping and loss_factor beside it";
                return Err(D::Error::custom(keyed("element", more)));
            }
        };
        element.checked().map(Self::Element).map_err(D::Error::custom)
    }
}

impl Link {
    /// A spring of `stiffness` [N/m²], viscous `damping` [N s/m²] and `loss_factor`.
    ///
    /// # Errors
    /// A stiffness that is not positive, negative damping.
    pub fn spring(stiffness: f64, damping: f64, loss_factor: f64) -> Result<Self, TrackError> {
        Ok(Self::Element(Element::spring(stiffness, damping, loss_factor)?))
    }

    /// Refuses `omega` [rad/s] at which it is no spring.
    ///
    /// # Errors
    /// As [`Element::check`].
    pub fn check(&self, omega: f64) -> Result<(), TrackError> {
        if let Self::Element(element) = self { element.check(omega) } else { Ok(()) }
    }

    /// `count` of them abreast.
    pub fn times(mut self, count: f64) -> Self {
        match &mut self {
            Self::Element(element) => *element = element.times(count),
            Self::Bars { axial_stiffness, .. } => *axial_stiffness *= count,
            Self::ConsistentMass { stiffness, damping, mass, .. } => {
                (*stiffness, *damping, *mass) = (count * *stiffness, count * *damping, count * *mass);
            }
        }
        self
    }

    /// The same link without dissipation.
    pub fn undamped(mut self) -> Self {
        match &mut self {
            Self::Element(element) => *element = element.undamped(),
            Self::ConsistentMass { damping, loss_factor, .. } => {
                (*damping, *loss_factor) = (0.0, 0.0);
            }
            Self::Bars { loss_factor, .. } => *loss_factor = 0.0,
        }
        self
    }

    /// The 2 × 2 stiffness at `omega` [rad/s].
    ///
    /// Bars: T = EA(ω/C)/tan(ωh/C), S = EA(ω/C)/sin(ωh/C), both EA/h at ω = 0 (A.2, corrected).
    /// Consistent mass: k − ω²m/3 and −(k + ω²m/6) (A.3).
    pub fn stiffness(&self, omega: f64) -> LinkStiffness {
        let damped = |k: f64, c: f64, eta: f64| Complex64::new(k, k * eta * sign(omega) + omega * c);
        match *self {
            Self::Element(element) => {
                let k = element.stiffness(omega);
                LinkStiffness { upper: k, cross: -k, lower: k }
            }
            Self::Bars { axial_stiffness, height, wave_speed, loss_factor } => {
                let hysteresis = Complex64::new(1.0, loss_factor * sign(omega));
                let k = axial_stiffness * hysteresis / height;
                // C* = C √(1 + iη): the density is real
                let x = omega * height / (wave_speed * hysteresis.sqrt());
                let (t, s) = if x.norm_sqr() < 1e-8 {
                    // x cot x = 1 − x²/3, x/sin x = 1 + x²/6, to x⁴/45 < 1e-17
                    (k * (1.0 - x * x / 3.0), k * (1.0 + x * x / 6.0))
                } else {
                    // cot: the tangent of a complex π/2 is NaN
                    (k * x * x.cos() / x.sin(), k * x / x.sin())
                };
                LinkStiffness { upper: t, cross: -s, lower: t }
            }
            Self::ConsistentMass { stiffness, damping, loss_factor, mass } => {
                let k = damped(stiffness, damping, loss_factor);
                let inertia = omega * omega * mass;
                LinkStiffness {
                    upper: k - inertia / 3.0,
                    cross: -(k + inertia / 6.0),
                    lower: k - inertia / 3.0,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_continuous_at_rest_and_conserve_momentum_slowly() {
        let bars = Link::Bars { axial_stiffness: 1.75e8, height: 0.35, wave_speed: 333.0, loss_factor: 0.0 };
        let still = bars.stiffness(0.0);
        assert_eq!(still.upper, -still.cross);
        assert!((still.upper.re / 5e8 - 1.0).abs() < 1e-15);
        // T − S → −ω²m/2, m = EA h/C² the mass of the bars
        for omega in [0.05, 0.5, 5.0] {
            let k = bars.stiffness(omega);
            let mass = -(k.upper + k.cross).re * 2.0 / (omega * omega);
            let exact = 1.75e8 * 0.35 / 333.0f64.powi(2);
            // at 0.05 rad/s the difference T − S keeps 1e-9 of T: 2e-7 of the mass
            assert!((mass / exact - 1.0).abs() < 1e-4, "{omega}: {mass} {exact}");
        }
    }

    #[test]
    fn undamped_bars_answer_at_a_quarter_wave() {
        // ωh/C = π/2 as it rounds: T → 0, S → EA ω/C
        let bars = Link::Bars { axial_stiffness: 1.75e8, height: 1.0, wave_speed: 1.0, loss_factor: 0.0 };
        let k = bars.stiffness(std::f64::consts::FRAC_PI_2);
        let exact = 1.75e8 * std::f64::consts::FRAC_PI_2;
        // cos of the rounded π/2 is 6e-17
        assert!(k.upper.norm() < 1e-15 * exact && (k.cross + exact).norm() < 1e-15 * exact, "{k:?}");
    }
}
