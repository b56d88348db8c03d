//! Unevenness of rails and wheels: published spectra, profiles made of sinusoids, and defects by formula.
//!
//! A profile r is positive down, as displacements are: a dip is positive. Inside the crate every spectrum is **one-sided, per
//! rad/m**: σ² = ∫_0^∞ S(Ω) dΩ. Published ones come per cycle/m, S_n(n) = 2π S_Ω(2πn), or two-sided, S_one = 2 S_two; each
//! file says which, and [`Spectrum::text`] repeats it.

mod band_levels;
pub mod china_ballastless;
mod defect;
mod dip;
mod dipped_joint;
mod flat;
pub mod fra_break_wavenumber;
pub mod fra_corner;
pub mod german;
mod iso3095;
pub mod iso8608;
pub mod measured;
pub mod out_of_round;
mod pieces;
mod ramp;
mod realisation;
pub mod sinusoidal;
pub mod sncf;
mod step;
mod table;
mod unevenness;

pub use band_levels::BandLevels;
pub use china_ballastless::ChinaBallastless;
pub use defect::Defect;
pub use dip::Dip;
pub use dipped_joint::{DippedJoint, JenkinsWheel, JointShape, LumpedTrack};
pub use flat::{FreshFlat, RoundedFlat};
pub use fra_break_wavenumber::FraBreakWavenumber;
pub use fra_corner::FraCorner;
pub use german::German;
pub use iso8608::Iso8608;
pub use measured::{Rail, measured, measured_rail, rail_columns};
pub use out_of_round::{Order, out_of_round, random_starts};
pub use ramp::Ramp;
pub use realisation::{Component, Realisation};
pub use sinusoidal::sinusoidal;
pub use sncf::Sncf;
pub use step::Step;
pub use table::{Sided, TableSpectrum};
pub use unevenness::{Profile, Unevenness};

use defect::depth;

use crate::columns::ColumnsError;
use crate::math::quadrature::{self, Tolerance};
use crate::quantity::OutOfRange;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;
use thiserror::Error;

/// A published spectrum of the vertical profile.
///
/// "FRA" names two families that do not agree: [`FraCorner`] and [`FraBreakWavenumber`].
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum Spectrum {
    /// AAR form with one corner wavenumber, FRA classes 1 to 6.
    FraCorner(FraCorner),
    /// Form with break wavenumbers (Corbin; Hamid & Yang), FRA classes 1 to 6.
    FraBreakWavenumber(FraBreakWavenumber),
    /// German low or high disturbance, ERRI B176.
    German {
        /// Which of the two.
        quality: German,
    },
    /// SNCF good or poor line.
    Sncf {
        /// Which of the two.
        quality: Sncf,
    },
    /// Chinese ballastless high-speed line.
    ChinaBallastless(ChinaBallastless),
    /// A road, or a rail described like one.
    #[serde(rename = "iso8608")]
    Iso8608(Iso8608),
    /// The limit for rails on which trains are measured.
    #[serde(rename = "iso3095")]
    Iso3095,
    /// A table of one's own, which case files name by keys of their own.
    #[serde(skip)]
    Table(TableSpectrum),
}

impl Spectrum {
    /// S(Ω), one-sided [m²/(rad/m)], at `wavenumber` Ω > 0 [rad/m]; also outside [`Spectrum::valid`].
    ///
    /// Formula and source stand in the file of each spectrum.
    pub fn one_sided(&self, wavenumber: f64) -> f64 {
        match self {
            Self::FraCorner(s) => s.one_sided(wavenumber),
            Self::FraBreakWavenumber(s) => s.one_sided(wavenumber),
            Self::German { quality: s } => s.one_sided(wavenumber),
            Self::Sncf { quality: s } => s.one_sided(wavenumber),
            Self::ChinaBallastless(s) => s.one_sided(wavenumber),
            Self::Iso8608(s) => s.one_sided(wavenumber),
            Self::Iso3095 => iso3095::one_sided(wavenumber),
            Self::Table(s) => s.one_sided(wavenumber),
        }
    }

    /// σ [m] of the wavelengths between `from_wavelength` and `to_wavelength` [m] in either order: σ² = ∫ S(Ω) dΩ.
    ///
    /// Returns NaN unless both are finite and above zero.
    /// Accuracy: closed forms to 3e-15 (tests `band_rms_is_that_of_the_closed_forms`, `german::tests::variance_over_3_to_25_metres`).
    pub fn band_rms(&self, from_wavelength: f64, to_wavelength: f64) -> f64 {
        let (a, b) = (TAU / from_wavelength, TAU / to_wavelength);
        if !(a.is_finite() && a > 0.0 && b.is_finite() && b > 0.0) {
            return f64::NAN;
        }
        let (low, high) = (a.min(b), a.max(b));
        // over ln Ω, where powers are smooth, in octaves and between the breaks of the spectrum
        let mut points = vec![low, high];
        points.extend(self.breaks().iter().filter(|&&b| low < b && b < high));
        points.extend((1..).map(|i| low * f64::powi(2.0, i)).take_while(|&p| p < high));
        points.iter_mut().for_each(|p| *p = p.ln());
        points.sort_by(f64::total_cmp);
        let f = |ln: f64| Complex64::new(self.one_sided(ln.exp()) * ln.exp(), 0.0);
        let tolerance = Tolerance { relative: 1e-12, absolute: 0.0, max_count: 100_000 };
        quadrature::integrate(f, &points, tolerance).value.re.sqrt()
    }

    /// Shortest and longest wavelength [m] for which the spectrum is published; None where its source gives none.
    pub fn valid(&self) -> Option<(f64, f64)> {
        match self {
            Self::FraCorner(_) => Some(fra_corner::VALID),
            Self::FraBreakWavenumber(_) => Some(fra_break_wavenumber::VALID),
            Self::German { .. } => Some(german::VALID),
            Self::Sncf { .. } => Some(sncf::VALID),
            Self::ChinaBallastless(_) => Some(china_ballastless::VALID),
            Self::Iso8608(_) => Some(iso8608::VALID),
            Self::Iso3095 => Some(iso3095::valid()),
            Self::Table(s) => Some(s.range()),
        }
    }

    /// Name, class, sidedness and wavenumber unit of the published formula, and its source, in one line.
    pub fn text(&self) -> String {
        match self {
            Self::FraCorner(s) => s.text(),
            Self::FraBreakWavenumber(s) => s.text(),
            Self::German { quality: s } => s.text(),
            Self::Sncf { quality: s } => s.text(),
            Self::ChinaBallastless(s) => s.text(),
            Self::Iso8608(s) => s.text(),
            Self::Iso3095 => iso3095::TEXT.to_owned(),
            Self::Table(s) => s.text(),
        }
    }

    /// Wavenumbers [rad/m] where the formula changes.
    fn breaks(&self) -> &[f64] {
        match self {
            Self::ChinaBallastless(_) => &china_ballastless::BREAKS,
            Self::Iso3095 => iso3095::edges(),
            Self::Table(s) => s.breaks(),
            _ => &[],
        }
    }
}

/// Where value number `i` of a table stands: "line 5", or "value number 3" where it comes from no file.
fn place(lines: &[usize], i: usize) -> String {
    lines.get(i).map_or_else(|| format!("value number {}", i + 1), |line| format!("line {line}"))
}

/// Why an irregularity cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum IrregularityError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// A class the spectrum does not have.
    #[error("{spectrum} has no class {found}: choose one of {allowed}")]
    Class {
        /// Which spectrum.
        spectrum: &'static str,
        /// What was given.
        found: String,
        /// What there is.
        allowed: &'static str,
    },
    /// Wavelengths in the wrong order.
    #[error("the wavelengths run from {shortest} m to {longest} m: the first must be the shorter one")]
    Wavelengths {
        /// [m]
        shortest: f64,
        /// [m]
        longest: f64,
    },
    /// A profile without components.
    #[error("no component is wanted: give a count of at least 1")]
    NoComponent,
    /// An order of a wheel that is not positive.
    #[error("order {order} of an out-of-round wheel: orders count waves around the wheel, from 1")]
    Order {
        /// What was given.
        order: u32,
    },
    /// A flat as long as its wheel is wide.
    #[error(
        "length is {length} m: a flat of a wheel of radius {radius} m is a chord of it, shorter than {} m",
        2.0 * radius
    )]
    Flat {
        /// What was given [m].
        length: f64,
        /// [m]
        radius: f64,
    },
    /// No step, or one that stops the wheel.
    #[error(
        "depth is {depth} m: a wheel of radius {radius} m rolls over steps between 0 and {radius} m, up or down"
    )]
    Step {
        /// What was given [m].
        depth: f64,
        /// [m]
        radius: f64,
    },
    /// A table that is none.
    #[error(
        "{abscissae} abscissae and {values} values: a table has two or more of both, as many of one as of the other"
    )]
    Lengths {
        /// How many.
        abscissae: usize,
        /// How many.
        values: usize,
    },
    /// A value of a table that has no meaning.
    #[error("{place}: {value} at {x}: abscissae and densities must be positive, levels finite")]
    TableValue {
        /// Its line or number.
        place: String,
        /// Abscissa.
        x: f64,
        /// What stands there.
        value: f64,
    },
    /// A third octave that is left out, or comes again.
    #[error(
        "{place} stands at {found} m, where {wanted} m is wanted: third octaves must follow one another, without gaps"
    )]
    Band {
        /// Its line or number.
        place: String,
        /// [m]
        found: f64,
        /// [m]
        wanted: f64,
    },
    /// Abscissae of a table that turn back.
    #[error(
        "{place} turns back, or repeats the one before it: abscissae must rise throughout, or fall throughout"
    )]
    TurnsBack {
        /// Its line or number.
        place: String,
    },
    /// A measured profile without the rail that is asked for.
    #[error("{found} columns: a measured profile has x and r, or x and the heights of the left and the right rail{}", if *asked { "; only the latter has rails to choose from" } else { "" })]
    Rails {
        /// How many there are.
        found: usize,
        /// Whether one of two rails is asked for.
        asked: bool,
    },
    /// A measured profile that is not two columns.
    #[error(transparent)]
    Columns(#[from] ColumnsError),
    /// Positions of a measured profile that do not rise.
    #[error(
        "line {line} stands at x = {x} m, not beyond the line before it at {before} m: sort the profile by x"
    )]
    NotRising {
        /// From 1.
        line: usize,
        /// [m]
        x: f64,
        /// [m]
        before: f64,
    },
    /// Too few points.
    #[error("the measured profile has {found} points: it needs at least {least}")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        least: usize,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Spectrum> {
        let mut all = vec![
            Spectrum::German { quality: German::Low },
            Spectrum::German { quality: German::High },
            Spectrum::Sncf { quality: Sncf::Good },
            Spectrum::Sncf { quality: Sncf::Poor },
            Spectrum::ChinaBallastless(ChinaBallastless),
            Spectrum::Iso3095,
        ];
        for class in 1..=6 {
            all.push(Spectrum::FraCorner(FraCorner::new(class).unwrap()));
            all.push(Spectrum::FraBreakWavenumber(FraBreakWavenumber::new(class).unwrap()));
        }
        all.extend(('A'..='H').map(|class| Spectrum::Iso8608(Iso8608::class(class).unwrap())));
        all
    }

    #[test]
    fn spectra_are_positive_and_fall() {
        for spectrum in all() {
            let mut last = f64::INFINITY;
            for i in 0..400 {
                let s = spectrum.one_sided(0.01 * 1.02f64.powi(i));
                // the Chinese one, published piece by piece with rounded coefficients, rises by up to 0.5 % at a break
                let rise = if matches!(spectrum, Spectrum::ChinaBallastless(_)) { 1.0 } else { 0.0 };
                // third octaves are steps
                let flat = spectrum == Spectrum::Iso3095 && s == last;
                assert!(s > 0.0 && (flat || s < last * (1.0 + 0.005 * rise)), "{spectrum:?}");
                last = s;
            }
            let (shortest, longest) = spectrum.valid().unwrap();
            assert!(0.0 < shortest && shortest < longest);
            assert!(spectrum.text().contains("one-sided") && spectrum.text().contains("after"));
        }
    }

    #[test]
    fn two_families_called_fra() {
        // class 5, 0.45 to 135 m: 10.1 and 9.7 mm in THEORY 5; measured 10.1446 and 9.7183
        let corner = Spectrum::FraCorner(FraCorner::new(5).unwrap());
        let breaks = Spectrum::FraBreakWavenumber(FraBreakWavenumber::new(5).unwrap());
        assert!(
            (corner.band_rms(0.45, 135.0) - 10.1446e-3).abs() < 0.1e-6,
            "{}",
            corner.band_rms(0.45, 135.0)
        );
        assert!(
            (breaks.band_rms(0.45, 135.0) - 9.7183e-3).abs() < 0.1e-6,
            "{}",
            breaks.band_rms(0.45, 135.0)
        );
        // but class 1 to 6 span a factor of 6 in one and 4.2 in the other
        let spread = |a: f64, b: f64| (a / b).sqrt();
        assert!((spread(1.2107, 0.0339) - 5.98).abs() < 0.01);
        assert!((spread(16.7217, 0.9525) - 4.19).abs() < 0.01);
    }

    #[test]
    fn band_rms_is_that_of_the_closed_forms() {
        let (low, high) = (TAU / 135.0, TAU / 0.45);
        // measured 0 and 2e-16. kA Ω_c²/(Ω²(Ω² + Ω_c²)) → kA [−1/Ω − atan(Ω/Ω_c)/Ω_c]
        let c = 0.8245;
        let f = |o: f64| -1.0 / o - (o / c).atan() / c;
        let exact = (0.25 * 0.2095e-4 * (f(high) - f(low))).sqrt();
        let got = Spectrum::FraCorner(FraCorner::new(5).unwrap()).band_rms(0.45, 135.0);
        assert!((got / exact - 1.0).abs() < 1e-13, "{got} {exact}");
        // Aφ₂²(φ² + φ₁²)/(φ⁴(φ² + φ₂²)) → A [−a/φ − φ₁²/(3φ³) − a atan(φ/φ₂)/φ₂], a = 1 − φ₁²/φ₂², φ in cycles/m
        let (p1, p2): (f64, f64) = (0.0233, 0.1312);
        let a = 1.0 - (p1 / p2).powi(2);
        let f = |p: f64| -a / p - p1 * p1 / (3.0 * p.powi(3)) - a * (p / p2).atan() / p2;
        let exact = (1.6722e-7 * (f(1.0 / 0.45) - f(1.0 / 135.0))).sqrt();
        let got = Spectrum::FraBreakWavenumber(FraBreakWavenumber::new(5).unwrap()).band_rms(135.0, 0.45);
        assert!((got / exact - 1.0).abs() < 1e-13, "{got} {exact}");
    }

    #[test]
    fn band_rms_adds_in_squares_and_refuses_nonsense() {
        for spectrum in all() {
            let parts = [(1.0, 7.0), (7.0, 60.0)].map(|(a, b)| spectrum.band_rms(a, b).powi(2));
            let whole = spectrum.band_rms(1.0, 60.0).powi(2);
            // measured 2e-16: the breaks of the Chinese spectrum are ends of panels
            assert!(((parts[0] + parts[1]) / whole - 1.0).abs() < 1e-12, "{spectrum:?}");
        }
        let spectrum = Spectrum::Sncf { quality: Sncf::Good };
        assert!(spectrum.band_rms(0.0, 3.0).is_nan() && spectrum.band_rms(1.0, -3.0).is_nan());
        assert_eq!(spectrum.band_rms(3.0, 3.0), 0.0);
    }
}
