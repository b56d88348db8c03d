//! Road profiles of ISO 8608, for tracks described like roads.

use super::IrregularityError;
use crate::quantity::positive;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::f64::consts::TAU;

/// n₀ [cycles/m]
const N_0: f64 = 0.1;
/// 2.83 to 0.011 cycles/m [m]
pub(super) const VALID: (f64, f64) = (1.0 / 2.83, 1.0 / 0.011);

/// S(n) = S₀ (n/n₀)^−2, n₀ = 0.1 cycles/m, one-sided, per cycle/m; here divided by 2π.
///
/// Source: ISO 8608:2016; geometric means 16 · 4^i · 1e-6 m³ of classes A to H.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, remote = "Self")]
#[schemars(rename = "Iso8608")]
pub struct Iso8608 {
    /// S₀ at 0.1 cycles/m [m³].
    #[serde(rename = "roughness")]
    s_0: f64,
    #[serde(skip)]
    class: Option<char>,
}

impl<'de> Deserialize<'de> for Iso8608 {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(Self::deserialize(deserializer)?.s_0).map_err(D::Error::custom)
    }
}

impl Iso8608 {
    /// The spectrum with S₀ = `roughness` [m²/(1/m)] at 0.1 cycles/m.
    ///
    /// # Errors
    /// A roughness that is not positive.
    pub fn new(roughness: f64) -> Result<Self, IrregularityError> {
        Ok(Self { s_0: positive("roughness", roughness, "m³")?, class: None })
    }

    /// The geometric mean of a `class`, from 'A', 16e-6 m³, four times more in each step, to 'H'.
    ///
    /// # Errors
    /// A class that is not A to H.
    pub fn class(class: char) -> Result<Self, IrregularityError> {
        match "ABCDEFGH".find(class) {
            Some(step) => Ok(Self { s_0: 16e-6 * 4f64.powi(step as i32), class: Some(class) }),
            None => {
                let found = class.to_string();
                Err(IrregularityError::Class { spectrum: "iso8608", found, allowed: "A to H" })
            }
        }
    }

    pub(super) fn one_sided(&self, wavenumber: f64) -> f64 {
        self.s_0 * (TAU * N_0 / wavenumber).powi(2) / TAU
    }

    pub(super) fn text(&self) -> String {
        let class = self.class.map_or(String::new(), |c| format!(" class {c}"));
        format!(
            "ISO 8608{class}, S₀ (n/0.1)^−2 with S₀ = {:e} m³, published one-sided, per cycle/m; after ISO 8608:2016",
            self.s_0
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::Spectrum;

    #[test]
    fn variance_between_two_wavelengths() {
        // ∫ S₀ n₀²/n² dn = S₀ n₀² (λ₂ − λ₁): class C, 1 to 11 m: 256e-6 · 0.01 · 10; measured 3e-16
        let got = Spectrum::Iso8608(Iso8608::class('C').unwrap()).band_rms(1.0, 11.0);
        assert!((got / 2.56e-5f64.sqrt() - 1.0).abs() < 1e-12, "{got}");
        assert!(Iso8608::class('c').is_err() && Iso8608::new(0.0).is_err());
        assert_eq!(Iso8608::new(256e-6).unwrap().one_sided(1.0), Iso8608::class('C').unwrap().one_sided(1.0));
    }
}
