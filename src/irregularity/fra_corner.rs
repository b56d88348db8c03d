//! Vertical profile by FRA class in the form of the Association of American Railroads, with one corner wavenumber.

use super::IrregularityError;
use crate::quantity::keyed;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// k
const K: f64 = 0.25;
/// Ω_c [rad/m]
const CORNER: f64 = 0.8245;
/// A of class 1 to 6 [m² rad/m]; published in cm² rad/m.
const A: [f64; 6] = [1.2107e-4, 1.0181e-4, 0.6816e-4, 0.5376e-4, 0.2095e-4, 0.0339e-4];
/// 5 to 1000 ft [m]
pub(super) const VALID: (f64, f64) = (1.524, 304.8);

/// S(Ω) = k A Ω_c²/(Ω²(Ω² + Ω_c²)), one-sided, per rad/m. The profile has no finite variance: wavelengths must be bounded.
///
/// Source: Fries & Coffey 1990, J. Dyn. Syst. Meas. Control 112, as quoted by Lei & Noda 2002, J. Sound Vib. 258:147, who
/// use k = 0.25 and A in cm² rad/m; range of wavelengths as quoted by Cantero 2022, SoftwareX 20:101253.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "FraCorner")]
pub struct FraCorner {
    /// 1 worst, 6 best.
    #[schemars(range(min = 1, max = 6))]
    class: u8,
}

impl<'de> Deserialize<'de> for FraCorner {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(Self::deserialize(deserializer)?.class).map_err(|e| D::Error::custom(keyed("class", e)))
    }
}

impl FraCorner {
    /// The spectrum of a `class`: 1 worst, 6 best.
    ///
    /// # Errors
    /// A class that is not 1 to 6.
    pub fn new(class: u8) -> Result<Self, IrregularityError> {
        if (1..=6).contains(&class) {
            Ok(Self { class })
        } else {
            let found = class.to_string();
            Err(IrregularityError::Class { spectrum: "fra-corner", found, allowed: "1 to 6" })
        }
    }

    pub(super) fn one_sided(&self, wavenumber: f64) -> f64 {
        let (o2, c2) = (wavenumber * wavenumber, CORNER * CORNER);
        K * A[usize::from(self.class) - 1] * c2 / (o2 * (o2 + c2))
    }

    pub(super) fn text(&self) -> String {
        format!(
            "FRA class {}, vertical profile, AAR corner form k A Ω_c²/(Ω²(Ω² + Ω_c²)), published one-sided, per rad/m; \
             after Fries & Coffey 1990, Lei & Noda 2002",
            self.class
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_the_corner_half_of_the_asymptote() {
        // k A/(2 Ω_c²), class 6: 0.25 · 3.39e-6/(2 · 0.67980) = 6.23345e-7; its six digits
        let s = FraCorner::new(6).unwrap().one_sided(0.8245);
        assert!((s / 6.233_45e-7 - 1.0).abs() < 1e-6, "{s}");
    }

    #[test]
    fn refuses_a_class_it_does_not_have() {
        let error = FraCorner::new(7).unwrap_err();
        assert_eq!(error.to_string(), "fra-corner has no class 7: choose one of 1 to 6");
    }
}
