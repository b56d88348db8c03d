//! Vertical profile of French lines.

use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;

/// n₀ [1/m]
const N_0: f64 = 0.0489;
/// Wavelengths [m] of the published formula.
pub(super) const VALID: (f64, f64) = (2.0, 40.0);

/// S(n) = A/(1 + n/n₀)³, per cycle/m, used as one-sided, which quotations seldom say; here divided by 2π.
///
/// Source: Berawi 2013, doctoral thesis, University of Porto (A = 308 · 0.509e-6 and 308 · 1.790e-6 m³, n₀ = 0.0489 1/m, that
/// is 0.307 rad/m; 2 to 40 m).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Sncf {
    /// A good line.
    Good,
    /// A poor line.
    Poor,
}

impl Sncf {
    /// A [m³]
    fn a(self) -> f64 {
        match self {
            Self::Good => 308.0 * 0.509e-6,
            Self::Poor => 308.0 * 1.790e-6,
        }
    }

    pub(super) fn one_sided(self, wavenumber: f64) -> f64 {
        self.a() / (1.0 + wavenumber / (TAU * N_0)).powi(3) / TAU
    }

    pub(super) fn text(self) -> String {
        format!(
            "SNCF {} line, vertical profile A/(1 + n/n₀)³, published per cycle/m, taken as one-sided; after Berawi 2013",
            match self {
                Self::Good => "good",
                Self::Poor => "poor",
            }
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::Spectrum;

    #[test]
    fn variance_over_its_range() {
        // ∫ A/(1 + n/n₀)³ dn = −A n₀/2 (1 + n/n₀)^−2; measured 2e-16
        let f = |n: f64| -308.0 * 0.509e-6 * N_0 / 2.0 * (1.0 + n / N_0).powi(-2);
        let exact = (f(0.5) - f(1.0 / 40.0)).sqrt();
        let got = Spectrum::Sncf { quality: Sncf::Good }.band_rms(2.0, 40.0);
        assert!((got / exact - 1.0).abs() < 1e-12, "{got} {exact}");
    }
}
