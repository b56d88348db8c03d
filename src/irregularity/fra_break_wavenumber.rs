//! Vertical profile by FRA class in the form with break wavenumbers: what the source paper means by "FRA".

use super::IrregularityError;
use crate::quantity::keyed;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::TAU;

/// φ₁ and φ₂ [cycles/m]
const BREAKS: (f64, f64) = (0.0233, 0.1312);
/// A of class 1 to 6 [m]
const A: [f64; 6] = [16.7217e-7, 9.5250e-7, 5.2917e-7, 2.9633e-7, 1.6722e-7, 0.9525e-7];
/// 5 to 1000 ft [m]
pub(super) const VALID: (f64, f64) = (1.524, 304.8);

/// S(φ) = A φ₂²(φ² + φ₁²)/(φ⁴(φ² + φ₂²)), one-sided, per cycle/m; here divided by 2π.
///
/// Source: Corbin 1980, FRA/ORD-80/22; Hamid & Yang 1981, Transp. Res. Rec. 838; range of wavelengths as quoted by Cantero 2022,
/// SoftwareX 20:101253, who has A some ten times smaller after Frýba 1996 (15.53e-8 m for class 1): not followed.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "FraBreakWavenumber")]
pub struct FraBreakWavenumber {
    /// 1 worst, 6 best.
    #[schemars(range(min = 1, max = 6))]
    class: u8,
}

impl<'de> Deserialize<'de> for FraBreakWavenumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(Self::deserialize(deserializer)?.class).map_err(|e| D::Error::custom(keyed("class", e)))
    }
}

impl FraBreakWavenumber {
    /// The spectrum of a `class`: 1 worst, 6 best.
    ///
    /// # Errors
    /// A class that is not 1 to 6.
    pub fn new(class: u8) -> Result<Self, IrregularityError> {
        if (1..=6).contains(&class) {
            Ok(Self { class })
        } else {
            let found = class.to_string();
            Err(IrregularityError::Class { spectrum: "fra-break-wavenumber", found, allowed: "1 to 6" })
        }
    }

    pub(super) fn one_sided(&self, wavenumber: f64) -> f64 {
        let phi2 = (wavenumber / TAU).powi(2);
        let (b1, b2) = (BREAKS.0 * BREAKS.0, BREAKS.1 * BREAKS.1);
        A[usize::from(self.class) - 1] * b2 * (phi2 + b1) / (phi2 * phi2 * (phi2 + b2)) / TAU
    }

    pub(super) fn text(&self) -> String {
        format!(
            "FRA class {}, vertical profile, break-wavenumber form A φ₂²(φ² + φ₁²)/(φ⁴(φ² + φ₂²)), published one-sided, \
             per cycle/m; after Corbin 1980, Hamid & Yang 1981",
            self.class
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn per_radian_is_per_cycle_over_two_pi() {
        // φ = φ₂ = 0.1312, class 1: A (1 + (φ₁/φ₂)²)/(2φ₂²) = 16.7217e-7 · 1.031539/0.03442688 = 5.010364e-5 m²/(1/m)
        let s = FraBreakWavenumber::new(1).unwrap().one_sided(TAU * 0.1312) * TAU;
        assert!((s / 5.010_36e-5 - 1.0).abs() < 1e-5, "{s}");
    }

    #[test]
    fn refuses_a_class_it_does_not_have() {
        assert!(FraBreakWavenumber::new(0).is_err());
    }
}
