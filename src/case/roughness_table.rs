//! `[irregularity]` with `kind = "table"`: a spectrum of one's own, inline or in a file.

use super::error::Finding;
use super::values::SpanInput;
use crate::columns;
use crate::irregularity::{BandLevels, IrregularityError, Sided, Spectrum, TableSpectrum};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;

/// Keys of a spectrum by table. Of `wavelength`, `wavenumber` and `cycles` one, of `level` and `density` one, or `file` with both.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoughnessTable {
    /// CSV file beside the case: a header with units, then abscissa (wavelength [m], wavenumber [rad/m] or cycles [1/m]) and level [dB] of
    /// third octaves re 1 µm, or density.
    pub file: Option<String>,
    /// λ [m]
    pub wavelength: Option<Vec<f64>>,
    /// Ω [rad/m]
    pub wavenumber: Option<Vec<f64>>,
    /// 1/λ [1/m]
    pub cycles: Option<Vec<f64>>,
    /// Levels of third octaves one after another [dB re 1 µm r.m.s.].
    pub level: Option<Vec<f64>>,
    /// Spectral densities in `unit`.
    pub density: Option<Vec<f64>>,
    /// Of densities: "m2/(rad/m)", "cm2/(rad/m)", "mm2/(rad/m)", "m2/(1/m)", "cm2/(1/m)", "mm2/(1/m)"; a file may say it in its header.
    pub unit: Option<DensityUnit>,
    /// Of densities: "one", over positive wavenumbers, or "two".
    pub sided: Option<Sided>,
    /// Shortest and longest wavelength [m]; those of the table by default.
    pub wavelengths: Option<SpanInput>,
    /// Seed of the first profile histories are made for, 1 by default.
    pub seed: Option<u64>,
    /// How many profiles histories are made for, with this seed and the next; 10 by default.
    pub profiles: Option<usize>,
}

/// Unit of a spectral density of heights.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum DensityUnit {
    /// m²/(rad/m)
    #[serde(rename = "m2/(rad/m)")]
    MetresPerRadian,
    /// cm²/(rad/m)
    #[serde(rename = "cm2/(rad/m)")]
    CentimetresPerRadian,
    /// mm²/(rad/m)
    #[serde(rename = "mm2/(rad/m)")]
    MillimetresPerRadian,
    /// m²/(1/m)
    #[serde(rename = "m2/(1/m)")]
    MetresPerCycle,
    /// cm²/(1/m)
    #[serde(rename = "cm2/(1/m)")]
    CentimetresPerCycle,
    /// mm²/(1/m)
    #[serde(rename = "mm2/(1/m)")]
    MillimetresPerCycle,
}

impl DensityUnit {
    /// Its size in m²/(rad/m): S_Ω = S_n/2π.
    fn size(self) -> f64 {
        match self {
            Self::MetresPerRadian => 1.0,
            Self::CentimetresPerRadian => 1e-4,
            Self::MillimetresPerRadian => 1e-6,
            Self::MetresPerCycle => 1.0 / TAU,
            Self::CentimetresPerCycle => 1e-4 / TAU,
            Self::MillimetresPerCycle => 1e-6 / TAU,
        }
    }
}

/// What an abscissa counts.
#[derive(Clone, Copy)]
enum Abscissa {
    /// × λ [m]
    Wavelength(f64),
    /// Ω [rad/m]
    Wavenumber,
    /// 1/λ [1/m]
    Cycles,
}

impl Abscissa {
    fn wavelength(self, value: f64) -> f64 {
        match self {
            Self::Wavelength(size) => size * value,
            Self::Wavenumber => TAU / value,
            Self::Cycles => 1.0 / value,
        }
    }
}

#[derive(Clone, Copy)]
enum Ordinate {
    Level,
    Density(Option<DensityUnit>),
}

/// A table as it was read, with the line of each row where it comes from a file.
struct Rows {
    abscissa: Abscissa,
    x: Vec<f64>,
    ordinate: Ordinate,
    values: Vec<f64>,
    lines: Vec<usize>,
}

const ROOT: &str = "irregularity";

fn at(name: &str) -> String {
    format!("{ROOT}.{name}")
}

impl RoughnessTable {
    /// The spectrum, and the wavelengths it reaches over [m]; `files` reads a file beside the case.
    pub fn spectrum(&self, files: &dyn Fn(&str) -> Result<String, String>) -> Result<Spectrum, Finding> {
        let Rows { abscissa, x, ordinate, values, lines } = match &self.file {
            Some(file) => self.of_file(file, files)?,
            None => self.inline()?,
        };
        let name = self.file.as_ref().map_or_else(|| "by table".to_owned(), |file| format!("table {file}"));
        let fault = |error: IrregularityError| match &self.file {
            Some(file) => Finding::new(at("file"), format!("{file}: {error}")),
            None => Finding::new(ROOT, error),
        };
        let table = match ordinate {
            Ordinate::Level => {
                if let Some(key) = self.sided.map(|_| "sided").or(self.unit.map(|_| "unit")) {
                    let finding =
                        Finding::new(at(key), "levels of third octaves have neither sides nor a unit");
                    return Err(finding.help("remove it"));
                }
                let wavelengths: Vec<f64> = x.iter().map(|x| abscissa.wavelength(*x)).collect();
                let levels = BandLevels::new(&wavelengths, &values, &lines).map_err(fault)?;
                TableSpectrum::of_levels(
                    levels,
                    format!("{name}, third-octave levels re 1 µm r.m.s., one-sided"),
                )
            }
            Ordinate::Density(unit) => {
                let Some(unit) = self.unit.or(unit) else {
                    let finding = Finding::new(ROOT, "the unit of the densities is not said");
                    return Err(
                        finding.help("add unit = \"mm2/(rad/m)\", \"m2/(1/m)\" …, or name it in the header")
                    );
                };
                let Some(sided) = self.sided else {
                    let finding =
                        Finding::new(ROOT, "it is not said whether the densities are one- or two-sided");
                    return Err(finding.help("add sided = \"one\" or \"two\""));
                };
                let wavenumbers: Vec<f64> = x.iter().map(|x| TAU / abscissa.wavelength(*x)).collect();
                let densities: Vec<f64> = values.iter().map(|v| unit.size() * v).collect();
                let sides = if sided == Sided::One { "one" } else { "two" };
                let text = format!("{name}, spectral density, {sides}-sided as given");
                TableSpectrum::of_densities(&wavenumbers, &densities, sided, &lines, text).map_err(fault)?
            }
        };
        Ok(Spectrum::Table(table))
    }

    fn inline(&self) -> Result<Rows, Finding> {
        let abscissae = [
            (&self.wavelength, Abscissa::Wavelength(1.0)),
            (&self.wavenumber, Abscissa::Wavenumber),
            (&self.cycles, Abscissa::Cycles),
        ];
        let mut given = abscissae.into_iter().filter_map(|(list, kind)| Some((list.clone()?, kind)));
        let (Some((x, abscissa)), None) = (given.next(), given.next()) else {
            let finding = Finding::new(
                ROOT,
                "a table needs one list of wavelength [m], wavenumber [rad/m] or cycles [1/m]",
            );
            return Err(finding.help("add one of them, or file"));
        };
        let (values, ordinate) = match (&self.level, &self.density) {
            (Some(level), None) => (level.clone(), Ordinate::Level),
            (None, Some(density)) => (density.clone(), Ordinate::Density(None)),
            _ => {
                let finding = Finding::new(ROOT, "a table needs one list of level [dB re 1 µm] or density");
                return Err(finding.help("add one of them, or file"));
            }
        };
        Ok(Rows { abscissa, x, ordinate, values, lines: Vec::new() })
    }

    fn of_file(&self, file: &str, files: &dyn Fn(&str) -> Result<String, String>) -> Result<Rows, Finding> {
        let lists = [
            ("wavelength", &self.wavelength),
            ("wavenumber", &self.wavenumber),
            ("cycles", &self.cycles),
            ("level", &self.level),
            ("density", &self.density),
        ];
        if let Some((key, _)) = lists.into_iter().find(|(_, list)| list.is_some()) {
            let finding = Finding::new(at(key), "file and lists are both given");
            return Err(finding.help("remove one of them"));
        }
        let header =
            "a header with units, as in wavelength [m]; level [dB], or wavenumber [rad/m]; S [mm2/(rad/m)]";
        let refuse = |reason: String| Finding::new(at("file"), format!("{file}: {reason}")).help(header);
        let text = files(file)
            .map_err(|reason| Finding::new(at("file"), format!("cannot read \"{file}\": {reason}")))?;
        let table = columns::table(&text).map_err(|e| refuse(e.to_string()))?;
        let Ok([x, values]) = <[Vec<f64>; 2]>::try_from(table.columns) else {
            return Err(refuse(format!("{} columns, where two are wanted", table.names.len())));
        };
        let known = [
            ("m", Abscissa::Wavelength(1.0)),
            ("cm", Abscissa::Wavelength(1e-2)),
            ("mm", Abscissa::Wavelength(1e-3)),
            ("rad/m", Abscissa::Wavenumber),
            ("1/m", Abscissa::Cycles),
        ];
        let abscissa =
            columns::unit(&table.names[0], table.header, &known).map_err(|e| refuse(e.to_string()))?;
        let Some(abscissa) = abscissa else {
            return Err(refuse(format!(
                "line {} does not say the unit of \"{}\"",
                table.header, table.names[0]
            )));
        };
        let density = |unit| Ordinate::Density(Some(unit));
        let known = [
            ("dB", Ordinate::Level),
            ("dBre1um", Ordinate::Level),
            ("m2/(rad/m)", density(DensityUnit::MetresPerRadian)),
            ("cm2/(rad/m)", density(DensityUnit::CentimetresPerRadian)),
            ("mm2/(rad/m)", density(DensityUnit::MillimetresPerRadian)),
            ("m2/(1/m)", density(DensityUnit::MetresPerCycle)),
            ("m3", density(DensityUnit::MetresPerCycle)),
            ("cm2/(1/m)", density(DensityUnit::CentimetresPerCycle)),
            ("mm2/(1/m)", density(DensityUnit::MillimetresPerCycle)),
            ("mm2m", density(DensityUnit::MillimetresPerCycle)),
        ];
        let ordinate =
            columns::unit(&table.names[1], table.header, &known).map_err(|e| refuse(e.to_string()))?;
        let ordinate = ordinate.unwrap_or(Ordinate::Density(None));
        Ok(Rows { abscissa, x, ordinate, values, lines: table.lines })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(keys: &str, csv: &str) -> Result<Spectrum, String> {
        let input: RoughnessTable = toml::from_str(keys).unwrap();
        let files = |_: &str| Ok(csv.to_owned());
        input.spectrum(&files).map_err(|finding| format!("{} {finding:?}", finding.message))
    }

    #[test]
    fn one_spectrum_in_many_units() {
        // S = 2e-6 m²/(rad/m) at 1 rad/m, 2e-8 at 10 rad/m
        let at_one = |spectrum: Spectrum| spectrum.one_sided(1.0);
        let cycle = 1.0 / TAU;
        for (keys, csv) in [
            (
                "wavenumber = [1.0, 10.0]\ndensity = [2e-6, 2e-8]\nunit = \"m2/(rad/m)\"\nsided = \"one\""
                    .to_owned(),
                String::new(),
            ),
            (
                "wavenumber = [1.0, 10.0]\ndensity = [1.0, 0.01]\nunit = \"mm2/(rad/m)\"\nsided = \"two\""
                    .to_owned(),
                String::new(),
            ),
            (
                format!(
                    "cycles = [{cycle}, {}]\ndensity = [{}, 1e-7]\nunit = \"m2/(1/m)\"\nsided = \"one\"",
                    10.0 * cycle,
                    2e-6 * TAU
                ),
                String::new(),
            ),
            (
                "file = \"a.csv\"\nsided = \"one\"".to_owned(),
                format!("% comment\nlambda [m];S [mm²/(rad/m)]\n{};2\n{};0,02\n", TAU, TAU / 10.0)
                    .replace('.', ","),
            ),
        ] {
            let found = at_one(table(&keys, &csv).unwrap());
            assert!((found / 2e-6 - 1.0).abs() < 1e-9, "{keys}: {found}");
        }
    }

    #[test]
    fn levels_in_a_file() {
        let csv = "wavelength [mm]\tL [dB]\n400\t20\n315\t10\n250\t0\n";
        let spectrum = table("file = \"a.csv\"", csv).unwrap();
        let (shortest, longest) = spectrum.valid().unwrap();
        // √(100 + 10 + 1) µm
        assert!((spectrum.band_rms(shortest, longest) - 111f64.sqrt() * 1e-6).abs() < 1e-15);
    }

    #[test]
    fn faults_are_told_at_their_key_and_line() {
        for (keys, csv, said) in [
            (
                "file = \"a.csv\"",
                "wavelength [m];L [dB]\n0,4;1\n# none\n0,25;1\n",
                "line 4 stands at 0.25 m, where 0.315 m is wanted",
            ),
            (
                "file = \"a.csv\"\nsided = \"one\"",
                "wavenumber [rad/m],S [m2/(rad/m)]\n1,1\n2,1\n1.5,1\n",
                "line 4 turns back",
            ),
            (
                "file = \"a.csv\"\nsided = \"one\"",
                "wavenumber [rad/m],S [m2/(rad/m)]\n1,1\n2,\n3,1\n",
                "line 3 reads",
            ),
            ("file = \"a.csv\"", "wavenumber [rad/m],S [m2/(rad/m)]\n1,1\n2,1\n", "one- or two-sided"),
            ("file = \"a.csv\"", "wavenumber,S [m2/(rad/m)]\n1,1\n2,1\n", "does not say the unit"),
            ("file = \"a.csv\"", "wavenumber [ft],S [m2/(rad/m)]\n1,1\n2,1\n", "\"ft\""),
            (
                "wavelength = [1.0, 2.0]\nwavenumber = [1.0, 2.0]\nlevel = [1.0, 2.0]",
                "",
                "one list of wavelength",
            ),
            ("wavelength = [0.4, 0.315]\nlevel = [1.0, 2.0]\nsided = \"one\"", "", "neither sides"),
            ("wavelength = [0.4, 0.315, 0.315]\nlevel = [1.0, 2.0, 3.0]", "", "value number 3"),
            ("wavelength = [0.4]\nlevel = [1.0]", "", "two or more"),
            ("wavenumber = [1.0, 2.0]\ndensity = [1.0, 2.0]\nsided = \"one\"", "", "unit of the densities"),
        ] {
            let why = table(keys, csv).unwrap_err();
            assert!(why.contains(said), "{keys} {csv}: no \"{said}\" in {why}");
        }
    }
}
