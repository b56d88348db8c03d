//! Vertical profile of Chinese ballastless high-speed lines.

use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;

/// Where the power changes [cycles/m].
const FREQUENCIES: [f64; 3] = [0.0187, 0.0474, 0.1533];
/// The same [rad/m].
pub(super) const BREAKS: [f64; 3] = [TAU * FREQUENCIES[0], TAU * FREQUENCIES[1], TAU * FREQUENCIES[2]];
/// A of S in mm²/(1/m) and k, from long waves to short ones.
const PIECES: [(f64, f64); 4] =
    [(1.0544e-5, 3.3891), (3.5588e-3, 1.9271), (1.9784e-2, 1.3643), (3.9488e-4, 3.4516)];
/// Wavelengths [m] of the standard.
pub(super) const VALID: (f64, f64) = (2.0, 200.0);

/// S(f) = A/fᵏ in four pieces, mm²/(1/m), used as one-sided, per cycle/m; here in m² and divided by 2π.
///
/// The pieces meet to 0.4 % (test `pieces_meet`): the coefficients are rounded in the standard. This is its mean spectrum.
/// Source: TB/T 3352-2014.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub struct ChinaBallastless;

impl ChinaBallastless {
    pub(super) fn one_sided(self, wavenumber: f64) -> f64 {
        let f = wavenumber / TAU;
        let (a, k) = PIECES[FREQUENCIES.iter().filter(|&&b| f > b).count()];
        a * f.powf(-k) * 1e-6 / TAU
    }

    pub(super) fn text(self) -> String {
        "Chinese ballastless high-speed line, vertical profile A/fᵏ in four pieces, published in mm²/(1/m), per cycle/m, \
         taken as one-sided; after TB/T 3352-2014"
            .to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_meet() {
        for b in BREAKS {
            let ratio = ChinaBallastless.one_sided(b * 1.000_001) / ChinaBallastless.one_sided(b * 0.999_999);
            // measured 0.40 %, −0.06 %, 0.04 %
            assert!((ratio - 1.0).abs() < 0.005, "{ratio}");
        }
    }

    #[test]
    fn value_of_the_standard_at_ten_metres() {
        // 1.9784e-2 · 0.1^−1.3643 = 0.45771 mm²/(1/m)
        let s = ChinaBallastless.one_sided(TAU * 0.1) * TAU * 1e6;
        assert!((s - 0.45771).abs() < 1e-4, "{s}");
    }
}
