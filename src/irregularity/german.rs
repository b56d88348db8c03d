//! Vertical profile of German high-speed lines: low and high disturbance, the same as ERRI B176.

use schemars::JsonSchema;
use serde::Deserialize;

/// Ω_c and Ω_r [rad/m]
const CORNERS: (f64, f64) = (0.8246, 0.0206);
/// Wavelengths [m] for which the formula is commonly used.
pub(super) const VALID: (f64, f64) = (3.0, 150.0);

/// S(Ω) = A Ω_c²/((Ω² + Ω_r²)(Ω² + Ω_c²)), per rad/m, used as one-sided: quotations seldom say, and read as two-sided
/// the profile would be √2 higher.
///
/// Source: Claus & Schiehlen 1998, Veh. Syst. Dyn. 29, after ORE B176; range of wavelengths as quoted by Cantero 2022,
/// SoftwareX 20:101253.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum German {
    /// Low disturbance: lines for more than 250 km/h.
    Low,
    /// High disturbance: other lines.
    High,
}

impl German {
    /// A [m² rad/m]
    fn a(self) -> f64 {
        match self {
            Self::Low => 4.032e-7,
            Self::High => 10.80e-7,
        }
    }

    pub(super) fn one_sided(self, wavenumber: f64) -> f64 {
        let (o2, c2, r2) = (wavenumber * wavenumber, CORNERS.0 * CORNERS.0, CORNERS.1 * CORNERS.1);
        self.a() * c2 / ((o2 + r2) * (o2 + c2))
    }

    pub(super) fn text(self) -> String {
        format!(
            "German {} disturbance (ERRI B176), vertical profile A Ω_c²/((Ω² + Ω_r²)(Ω² + Ω_c²)), per rad/m, taken as \
             one-sided; after Claus & Schiehlen 1998",
            match self {
                Self::Low => "low",
                Self::High => "high",
            }
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::Spectrum;

    #[test]
    fn variance_over_3_to_25_metres() {
        // A Ω_c²/(Ω_c² − Ω_r²) [atan(Ω/Ω_r)/Ω_r − atan(Ω/Ω_c)/Ω_c], measured 3e-15; 0.984 mm
        let (c, r) = CORNERS;
        let f = |o: f64| ((o / r).atan() / r - (o / c).atan() / c) * c * c / (c * c - r * r);
        let tau = std::f64::consts::TAU;
        let exact = (4.032e-7 * (f(tau / 3.0) - f(tau / 25.0))).sqrt();
        let got = Spectrum::German { quality: German::Low }.band_rms(3.0, 25.0);
        assert!((got / exact - 1.0).abs() < 1e-12, "{got} {exact}");
        assert!((got - 0.984e-3).abs() < 0.001e-3, "{got}");
    }
}
