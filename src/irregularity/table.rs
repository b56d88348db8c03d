//! Spectra of one's own, as tables.

use super::IrregularityError;
use super::band_levels::BandLevels;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;

/// Whether a density is that of positive wavenumbers alone, or half of it on either side.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Sided {
    /// σ² = ∫₀^∞ S
    One,
    /// σ² = ∫₋∞^∞ S
    Two,
}

/// A spectrum by a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableSpectrum {
    shape: Shape,
    text: String,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Levels(BandLevels),
    /// Wavenumbers [rad/m], rising, and one-sided densities [m²/(rad/m)].
    Density(Vec<f64>, Vec<f64>),
}

impl TableSpectrum {
    /// A spectrum of third-octave levels, called `text`.
    pub fn of_levels(levels: BandLevels, text: String) -> Self {
        Self { shape: Shape::Levels(levels), text }
    }

    /// A spectrum of densities, called `text`: at `wavenumbers` [rad/m], rising or falling throughout, `densities` [m²/(rad/m)],
    /// one- or two-`sided`; `lines` names the line of each, where they come from a file.
    ///
    /// Between them straight in logarithms, beyond them the density at the end.
    ///
    /// # Errors
    /// Fewer than two points; a wavenumber or density that is not positive and finite; wavenumbers that turn back.
    pub fn of_densities(
        wavenumbers: &[f64],
        densities: &[f64],
        sided: Sided,
        lines: &[usize],
        text: String,
    ) -> Result<Self, IrregularityError> {
        if wavenumbers.len() < 2 || wavenumbers.len() != densities.len() {
            return Err(IrregularityError::Lengths { abscissae: wavenumbers.len(), values: densities.len() });
        }
        let place = |i: usize| super::place(lines, i);
        let sound = |v: f64| v > 0.0 && v.is_finite();
        if let Some(i) = (0..densities.len()).find(|&i| !(sound(wavenumbers[i]) && sound(densities[i]))) {
            let (x, value) = (wavenumbers[i], densities[i]);
            return Err(IrregularityError::TableValue { place: place(i), x, value });
        }
        let rises = wavenumbers[1] > wavenumbers[0];
        if let Some(i) = (1..wavenumbers.len())
            .find(|&i| wavenumbers[i] == wavenumbers[i - 1] || (wavenumbers[i] > wavenumbers[i - 1]) != rises)
        {
            return Err(IrregularityError::TurnsBack { place: place(i) });
        }
        let factor = if sided == Sided::Two { 2.0 } else { 1.0 };
        let (mut omega, mut density) =
            (wavenumbers.to_vec(), densities.iter().map(|s| factor * s).collect::<Vec<_>>());
        if !rises {
            omega.reverse();
            density.reverse();
        }
        Ok(Self { shape: Shape::Density(omega, density), text })
    }

    /// S(Ω), one-sided [m²/(rad/m)].
    pub fn one_sided(&self, wavenumber: f64) -> f64 {
        match &self.shape {
            Shape::Levels(levels) => levels.one_sided(wavenumber),
            Shape::Density(omega, density) => {
                let above = omega.partition_point(|o| *o <= wavenumber);
                match above {
                    0 => density[0],
                    n if n == omega.len() => density[n - 1],
                    n => {
                        let part = (wavenumber / omega[n - 1]).ln() / (omega[n] / omega[n - 1]).ln();
                        density[n - 1] * (density[n] / density[n - 1]).powf(part)
                    }
                }
            }
        }
    }

    /// Shortest and longest wavelength of the table [m].
    pub fn range(&self) -> (f64, f64) {
        match &self.shape {
            Shape::Levels(levels) => levels.range(),
            Shape::Density(omega, _) => (TAU / omega[omega.len() - 1], TAU / omega[0]),
        }
    }

    /// Wavenumbers where it changes [rad/m].
    pub(super) fn breaks(&self) -> &[f64] {
        match &self.shape {
            Shape::Levels(levels) => levels.edges(),
            Shape::Density(omega, _) => omega,
        }
    }

    /// What it is, in one line.
    pub fn text(&self) -> String {
        self.text.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::Spectrum;

    #[test]
    fn a_power_law_by_two_points_is_itself() {
        // S = 1e-6/Ω² from 0.1 to 10 rad/m: σ² = 1e-6 (10 − 0.1); measured 2e-15
        let of = |sided, size: f64| {
            let table = TableSpectrum::of_densities(
                &[10.0, 0.1],
                &[1e-8 * size, 1e-4 * size],
                sided,
                &[],
                "x".into(),
            );
            Spectrum::Table(table.unwrap())
        };
        for spectrum in [of(Sided::One, 1.0), of(Sided::Two, 0.5)] {
            let rms = spectrum.band_rms(TAU / 10.0, TAU / 0.1);
            assert!((rms * rms / 9.9e-6 - 1.0).abs() < 1e-12);
            assert_eq!(spectrum.one_sided(0.01), spectrum.one_sided(0.1));
            let (shortest, longest) = spectrum.valid().unwrap();
            assert!((shortest - TAU / 10.0).abs() < 1e-12 && (longest - TAU / 0.1).abs() < 1e-12);
        }
    }

    #[test]
    fn levels_in_either_order() {
        let falling = BandLevels::new(&[0.4, 0.315, 0.25], &[20.0, 10.0, 0.0], &[]).unwrap();
        let rising = BandLevels::new(&[0.25, 0.315, 0.4], &[0.0, 10.0, 20.0], &[]).unwrap();
        assert_eq!(falling, rising);
        let spectrum = Spectrum::Table(TableSpectrum::of_levels(falling, "x".into()));
        // 20, 10, 0 dB: √(100 + 10 + 1) µm together
        let (shortest, longest) = spectrum.valid().unwrap();
        assert!((spectrum.band_rms(shortest, longest) / 111f64.sqrt() - 1e-6).abs() < 1e-15);
    }

    #[test]
    fn gaps_and_turns_are_told_at_their_line() {
        let why = |x: &[f64], lines: &[usize]| {
            BandLevels::new(x, &vec![1.0; x.len()], lines).unwrap_err().to_string()
        };
        let gap = why(&[0.4, 0.315, 0.2], &[2, 3, 5]);
        assert!(gap.contains("line 5") && gap.contains("0.2 m") && gap.contains("0.25 m"), "{gap}");
        assert!(why(&[0.4, 0.315, 0.4], &[]).contains("value number 3"));
        let turn =
            TableSpectrum::of_densities(&[1.0, 2.0, 1.5], &[1.0; 3], Sided::One, &[2, 3, 4], "x".into());
        assert!(turn.unwrap_err().to_string().contains("line 4"));
        let zero = TableSpectrum::of_densities(&[1.0, 2.0], &[1.0, 0.0], Sided::One, &[], "x".into());
        assert!(zero.unwrap_err().to_string().contains("value number 2"));
    }
}
