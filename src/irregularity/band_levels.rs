//! Roughness as levels of third octaves of the wavelength: steps of constant density.

use super::IrregularityError;
use std::f64::consts::TAU;

/// r₀ [m], the roughness of level zero: 1 µm r.m.s. in the band.
const REFERENCE: f64 = 1e-6;

/// Levels of third octaves one after another, L = 20 lg(r_rms/1 µm) [dB].
#[derive(Clone, Debug, PartialEq)]
pub struct BandLevels {
    /// Number of the band with the longest waves: bands are centred on 10^{n/10} waves a metre.
    first: i32,
    /// Longest waves first.
    levels: Vec<f64>,
    /// Wavenumbers between bands [rad/m].
    edges: Vec<f64>,
}

/// Number of the band that holds `wavelength` [m].
fn number(wavelength: f64) -> i32 {
    (-10.0 * wavelength.log10()).round() as i32
}

/// Lower edge of band number n [rad/m].
fn edge(n: i32) -> f64 {
    TAU * 10f64.powf((2.0 * f64::from(n) - 1.0) / 20.0)
}

/// The nominal wavelength of a band [m], as 0.315.
fn nominal(n: i32) -> f64 {
    const NOMINAL: [f64; 10] = [1.0, 0.8, 0.63, 0.5, 0.4, 0.315, 0.25, 0.2, 0.16, 0.125];
    NOMINAL[n.rem_euclid(10) as usize] * 10f64.powi(-n.div_euclid(10))
}

impl BandLevels {
    /// One of `levels` [dB re 1 µm] at each of `wavelengths` [m], third octave after third octave in either order; `lines` names
    /// the line of each, where they come from a file.
    ///
    /// # Errors
    /// Fewer than two bands; a wavelength that is not positive; a band that is left out or comes again; a level that is not finite.
    pub fn new(wavelengths: &[f64], levels: &[f64], lines: &[usize]) -> Result<Self, IrregularityError> {
        if wavelengths.len() < 2 || wavelengths.len() != levels.len() {
            return Err(IrregularityError::Lengths { abscissae: wavelengths.len(), values: levels.len() });
        }
        let place = |i: usize| super::place(lines, i);
        if let Some(i) = (0..levels.len()).find(|&i| !(wavelengths[i] > 0.0 && levels[i].is_finite())) {
            let (x, value) = (wavelengths[i], levels[i]);
            return Err(IrregularityError::TableValue { place: place(i), x, value });
        }
        let numbers: Vec<i32> = wavelengths.iter().map(|w| number(*w)).collect();
        let step = if numbers[1] < numbers[0] { -1 } else { 1 };
        for i in 1..numbers.len() {
            if numbers[i] != numbers[i - 1] + step {
                let wanted = nominal(numbers[i - 1] + step);
                return Err(IrregularityError::Band { place: place(i), found: wavelengths[i], wanted });
            }
        }
        let mut levels = levels.to_vec();
        if step < 0 {
            levels.reverse();
        }
        let first = numbers[0].min(numbers[numbers.len() - 1]);
        let edges = (0..=levels.len() as i32).map(|i| edge(first + i)).collect();
        Ok(Self { first, levels, edges })
    }

    /// Those of a standard, longest waves first, known to follow one another.
    pub(super) fn of_standard(wavelengths: &[f64], levels: &[f64]) -> Self {
        let first = number(wavelengths[0]);
        let edges = (0..=levels.len() as i32).map(|i| edge(first + i)).collect();
        Self { first, levels: levels.to_vec(), edges }
    }

    /// S(Ω) [m²/(rad/m)], one-sided: r²_rms/ΔΩ of the band; beyond the table with the level of its nearest band, as 1/Ω.
    pub fn one_sided(&self, wavenumber: f64) -> f64 {
        let count = self.levels.len();
        let square = |at: usize| REFERENCE * REFERENCE * 10f64.powf(0.1 * self.levels[at]);
        match self.edges.partition_point(|edge| *edge <= wavenumber) {
            // r² over ∫ dΩ/Ω = ln 10/10 of a third octave
            0 => square(0) / (0.1 * std::f64::consts::LN_10 * wavenumber),
            above if above > count => square(count - 1) / (0.1 * std::f64::consts::LN_10 * wavenumber),
            above => square(above - 1) / (self.edges[above] - self.edges[above - 1]),
        }
    }

    /// Shortest and longest wavelength of its bands [m].
    pub fn range(&self) -> (f64, f64) {
        (TAU / self.edges[self.edges.len() - 1], TAU / self.edges[0])
    }

    /// Wavenumbers where it steps [rad/m].
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }
}
