//! The limit of ISO 3095:2013 for the roughness of rails on which trains are measured.

use super::band_levels::BandLevels;
use std::sync::LazyLock;

/// Nominal wavelength [m] and limit [dB re 1 µm].
///
/// From 0.4 m down: ISO 3095:2013, Figure 2, as transcribed in the library phonometry (github.com/jmrplens/phonometry); above, Commission
/// Directive (EU) 2015/996, Appendix G, Table G-1, "EN ISO 3095:2013 (well maintained and very smooth)", as replaced by (EU) 2021/1226,
/// which agrees below and continues with 17.1 dB to 2 m.
const LIMIT: [(f64, f64); 29] = [
    (2.0, 17.1),
    (1.6, 17.1),
    (1.25, 17.1),
    (1.0, 17.1),
    (0.8, 17.1),
    (0.63, 17.1),
    (0.5, 17.1),
    (0.4, 17.1),
    (0.315, 15.0),
    (0.25, 13.0),
    (0.2, 11.0),
    (0.16, 9.0),
    (0.125, 7.0),
    (0.1, 4.9),
    (0.08, 2.9),
    (0.063, 0.9),
    (0.05, -1.1),
    (0.04, -3.2),
    (0.0315, -5.0),
    (0.025, -5.6),
    (0.02, -6.2),
    (0.016, -6.8),
    (0.0125, -7.4),
    (0.01, -8.0),
    (0.008, -8.6),
    (0.0063, -9.2),
    (0.005, -9.8),
    (0.004, -10.4),
    (0.00315, -11.0),
];

static LEVELS: LazyLock<BandLevels> = LazyLock::new(|| {
    let (wavelengths, levels): (Vec<f64>, Vec<f64>) = LIMIT.iter().copied().unzip();
    BandLevels::of_standard(&wavelengths, &levels)
});

/// S(Ω), one-sided [m²/(rad/m)]: constant in each third octave.
pub(super) fn one_sided(wavenumber: f64) -> f64 {
    LEVELS.one_sided(wavenumber)
}

/// Shortest and longest wavelength [m].
pub(super) fn valid() -> (f64, f64) {
    LEVELS.range()
}

/// Wavenumbers between bands [rad/m].
pub(super) fn edges() -> &'static [f64] {
    LEVELS.edges()
}

/// What it is.
pub(super) const TEXT: &str = "limit of ISO 3095:2013 (third octaves re 1 µm r.m.s., one-sided, longer waves than 0.4 m after Directive (EU) 2015/996, Table G-1)";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::Spectrum;

    #[test]
    fn bands_have_their_levels() {
        for (wavelength, level) in LIMIT {
            let n = (-10.0 * wavelength.log10()).round();
            let [from, to] = [n - 0.5, n + 0.5].map(|n| 10f64.powf(-n / 10.0));
            let rms = Spectrum::Iso3095.band_rms(from, to);
            // measured 6e-15 dB
            assert!((20.0 * (rms / 1e-6).log10() - level).abs() < 1e-9, "{wavelength} m");
        }
    }

    #[test]
    fn all_of_it_together() {
        // the sum of the bands by hand: Σ 10^{L/10} = 8 · 51.29 + 31.62 + 19.95 + 12.59 + 7.94 + 5.01 + 3.09 + 1.95 + 1.23 + 0.776 + 0.479 +
        // 0.316 + 0.275 + 0.240 + 0.209 + 0.182 + 0.158 + 0.138 + 0.120 + 0.105 + 0.0912 + 0.0794 = 496.9; √ = 22.29 µm
        let (shortest, longest) = valid();
        let rms = Spectrum::Iso3095.band_rms(shortest, longest);
        assert!((rms - 22.29e-6).abs() < 0.01e-6, "{rms}");
    }
}
