//! Shear wave speeds of layers that scatter together: ln c_s = ln c̃_s + σ Z, Z of a layer like that of the layer above it.
//!
//! Z_i = ρ Z_{i−1} + √(1 − ρ²) ε_i: the correlation of two layers is the product of the ρ between them.
//! Source: Toro (1995), Probabilistic models of site velocity profiles for generic and site-specific ground-motion amplification
//! studies, Brookhaven National Laboratory 779574; its parameters as in Kottke & Rathje (2009), Technical manual for Strata, PEER
//! 2008/10, and in the program pystrata.

use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of sites whose scatter is published; those of the USGS by V_s30: `a` above 750 m/s, `b` 360 to 750, `c` 180 to 360, `d` below.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Site {
    /// Rock, and stiff soil over rock.
    GeomatrixAb,
    /// Deep soil.
    GeomatrixCd,
    /// V_s30 above 360 m/s.
    UsgsAb,
    /// V_s30 below 360 m/s.
    UsgsCd,
    /// V_s30 above 750 m/s.
    UsgsA,
    /// V_s30 from 360 to 750 m/s.
    UsgsB,
    /// V_s30 from 180 to 360 m/s.
    UsgsC,
    /// V_s30 below 180 m/s.
    UsgsD,
}

impl Site {
    /// σ_ln, ρ₀, Δ [m], ρ₂₀₀, b.
    fn parameters(self) -> [f64; 5] {
        match self {
            Self::GeomatrixAb => [0.46, 0.96, 13.1, 0.96, 0.095],
            Self::GeomatrixCd => [0.38, 0.99, 8.0, 1.00, 0.160],
            Self::UsgsAb => [0.35, 0.95, 4.2, 1.00, 0.138],
            Self::UsgsCd => [0.36, 0.99, 3.9, 1.00, 0.293],
            Self::UsgsA => [0.36, 0.95, 3.4, 0.42, 0.063],
            Self::UsgsB => [0.27, 0.97, 3.8, 1.00, 0.293],
            Self::UsgsC => [0.31, 0.99, 3.9, 0.98, 0.344],
            Self::UsgsD => [0.37, 0.00, 5.0, 0.50, 0.744],
        }
    }

    /// σ, the standard deviation of ln c_s.
    pub fn sigma(self) -> f64 {
        self.parameters()[0]
    }
}

/// How like neighbours are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Likeness {
    /// ρ = (1 − ρ_d) ρ_t + ρ_d with ρ_t = ρ₀ e^{−t/Δ} of the distance t of the middles of both layers, and
    /// ρ_d = ρ₂₀₀ (d/200 m)^b of their mean depth d, ρ₂₀₀ below 200 m.
    Toro(Site),
    /// ρ = e^{−t/l} of the correlation length l [m].
    Length(f64),
}

impl Likeness {
    /// ρ of two neighbours whose middles lie at the depths `above` and `below` [m].
    pub fn between(self, above: f64, below: f64) -> f64 {
        let (t, d) = (below - above, 0.5 * (above + below));
        match self {
            Self::Length(length) => (-t / length).exp(),
            Self::Toro(site) => {
                let [_, rho_0, delta, rho_200, b] = site.parameters();
                let rho_t = rho_0 * (-t / delta).exp();
                let rho_d = rho_200 * (d / 200.0).min(1.0).powf(b);
                (1.0 - rho_d) * rho_t + rho_d
            }
        }
    }

    /// Correlation of every two of the layers with middles at `depths` [m], ascending: (i, j, ρ).
    pub fn pairs(self, depths: &[f64]) -> Vec<(usize, usize, f64)> {
        let mut pairs = Vec::new();
        for i in 0..depths.len() {
            let mut rho = 1.0;
            for j in i + 1..depths.len() {
                rho *= self.between(depths[j - 1], depths[j]);
                pairs.push((i, j, rho));
            }
        }
        pairs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::Correlation;

    #[test]
    fn neighbours_are_as_alike_as_published() {
        // USGS C, middles at 1 and 3 m: ρ_t = 0.99 e^{−2/3.9} = 0.592816, ρ_d = 0.98 × 0.01^0.344 = 0.201014; by hand
        let rho = Likeness::Toro(Site::UsgsC).between(1.0, 3.0);
        assert!((rho - 0.674_666).abs() < 1e-6, "{rho}");
        // 50 m of distance leave what depth alone makes of it
        let deep = Likeness::Toro(Site::UsgsC).between(225.0, 275.0);
        assert!((deep - 0.98).abs() < 1e-6, "{deep}");
        assert_eq!(Likeness::Length(2.0).between(0.0, 2.0), (-1f64).exp());
    }

    #[test]
    fn layers_form_a_chain_that_can_be() {
        let pairs = Likeness::Length(5.0).pairs(&[1.0, 3.0, 8.0]);
        assert_eq!(pairs.iter().map(|p| (p.0, p.1)).collect::<Vec<_>>(), [(0, 1), (0, 2), (1, 2)]);
        // e^{−2/5} e^{−5/5} = e^{−7/5}
        assert!((pairs[1].2 - (-1.4f64).exp()).abs() < 1e-15);
        let depths: Vec<f64> = (0..30).map(|i| 0.25 + 0.5 * f64::from(i)).collect();
        for site in [Site::UsgsA, Site::UsgsD, Site::GeomatrixAb, Site::GeomatrixCd] {
            assert!(Correlation::new(30, &Likeness::Toro(site).pairs(&depths)).is_ok(), "{site:?}");
        }
    }
}
