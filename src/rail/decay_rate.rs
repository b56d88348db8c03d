//! How fast vibration dies away along the rail, Δ [dB/m], by three definitions that are not the same number.

use super::receptance::{RailError, Receptance};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;

/// 10/ln 10
const DECIBEL: f64 = 4.342_944_819_032_518;

/// Distances from the force at which EN 15461 has the rail measured, in bays.
///
/// Source: EN 15461:2008+A1:2010, table 1.
pub const EN_15461: [f64; 29] = [
    0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0,
    12.0, 16.0, 20.0, 24.0, 30.0, 36.0, 42.0, 48.0, 54.0, 66.0,
];

/// Which decay rate is meant.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum DecayRate {
    /// Of the free wave that decays least, Eq. (94).
    #[default]
    Floquet,
    /// 4.343 |α(0)|²/∫₀^∞ |α|² dx, the limit of Eq. (56) for a fine grid.
    ExactReceptance,
    /// Eq. (56) on the grid of EN 15461, as it is measured.
    #[serde(rename = "en15461")]
    En15461,
}

impl DecayRate {
    /// As a case file spells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Floquet => "floquet",
            Self::ExactReceptance => "exact-receptance",
            Self::En15461 => "en15461",
        }
    }
}

/// 4.343 |α₀|²/Σ |α_n|² Δx_n [dB/m] on the grid of EN 15461 for a force at `from` [m] and bays of `spacing` [m] at `omega` [rad/s].
///
/// Δx_n lies between mid-points, Δx₀ is half the first interval, the last one as long as the last interval.
///
/// Accuracy: that of the receptances. It is 0.7 to 1 of the rate of the free wave where that is large, 1.2 to 2 times it at 500 to
/// 1000 Hz, and never below about 4.343/(66 bays). Source: Eq. (56).
///
/// # Errors
/// As `rail`.
pub fn en15461(rail: &dyn Receptance, spacing: f64, from: f64, omega: f64) -> Result<f64, RailError> {
    let x = EN_15461.map(|bays| from + bays * spacing);
    let answers = rail.at(&x, from, omega)?;
    let last = x.len() - 1;
    let width = |n: usize| match n {
        0 => 0.5 * (x[1] - x[0]),
        n if n == last => x[last] - x[last - 1],
        n => 0.5 * (x[n + 1] - x[n - 1]),
    };
    let sum: f64 = answers.iter().enumerate().map(|(n, a)| a.value.norm_sqr() * width(n)).sum();
    Ok(DECIBEL * answers[0].value.norm_sqr() / sum)
}

/// 4.343 |α₀|²/∫₀^∞ |α|² dx [dB/m] for a force at `from` [m] at `omega` [rad/s], bays of `spacing` [m].
///
/// Bay by bay by Gauss's rule, until what one bay adds has become nothing, or falls from bay to bay as a single wave does, whose rest
/// is a geometric sum.
///
/// Accuracy: 1e-8 where one wave remains after 400 bays (test `analytic::periodic::decay_rates_as_measured`).
///
/// # Errors
/// As `rail`; vibration that does not die away.
pub fn exact(rail: &dyn Receptance, spacing: f64, from: f64, omega: f64) -> Result<f64, RailError> {
    const BAYS: usize = 400;
    const STEP: usize = 20;
    let (mut sum, mut bays): (f64, Vec<f64>) = (0.0, Vec::new());
    while bays.len() < BAYS {
        let first = bays.len();
        let x: Vec<f64> = (first..first + STEP)
            .flat_map(|bay| GAUSS.map(|(t, _)| from + spacing * (bay as f64 + t)))
            .collect();
        let answers = rail.at(&x, from, omega)?;
        for bay in answers.chunks(GAUSS.len()) {
            let energy = bay.iter().zip(GAUSS).map(|(a, (_, w))| a.value.norm_sqr() * w).sum::<f64>();
            bays.push(spacing * energy);
        }
        sum = bays.iter().sum();
        if bays[bays.len() - 1] < 1e-12 * sum {
            break;
        }
    }
    let [.., before, last] = bays[..] else { return Ok(f64::NAN) };
    // what is left of one wave
    let ratio = last / before;
    if last >= 1e-12 * sum {
        if ratio >= 1.0 {
            return Err(RailError::Unsettled {
                method: DecayRate::ExactReceptance.name(),
                frequency: omega / std::f64::consts::TAU,
                error: 1.0,
                remedy: "vibration does not die away along this track: give it some loss",
            });
        }
        sum += last * ratio / (1.0 - ratio);
    }
    let here: Complex64 = rail.at(&[from], from, omega)?[0].value;
    Ok(DECIBEL * here.norm_sqr() / sum)
}

/// Gauss's rule of ten points on [0, 1]: abscissae and weights.
const GAUSS: [(f64, f64); 10] = [
    (0.013_046_735_741_414_13, 0.033_335_672_154_344_1),
    (0.067_468_316_655_507_73, 0.074_725_674_575_290_3),
    (0.160_295_215_850_487_8, 0.109_543_181_257_991),
    (0.283_302_302_935_376_4, 0.134_633_359_654_998_2),
    (0.425_562_830_509_184_4, 0.147_762_112_357_376_4),
    (0.574_437_169_490_815_6, 0.147_762_112_357_376_4),
    (0.716_697_697_064_623_6, 0.134_633_359_654_998_2),
    (0.839_704_784_149_512_2, 0.109_543_181_257_991),
    (0.932_531_683_344_492_3, 0.074_725_674_575_290_3),
    (0.986_953_264_258_585_9, 0.033_335_672_154_344_1),
];
