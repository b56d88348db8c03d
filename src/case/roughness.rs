//! What a given profile of the rail may be doubted for: gaps, steps, heights in the wrong unit.

use super::schema::IrregularityInput;
use crate::columns::Columns;
use crate::concern::Concern;
use crate::irregularity::{Rail, measured_rail, rail_columns};
use std::f64::consts::TAU;

/// Steepest slope of a rail that trains run on, and largest r.m.s. height [m].
const STEEPEST: f64 = 0.01;
const HIGHEST: f64 = 0.03;
/// Largest deflection of a track under a train that anybody recorded [m].
const DEEPEST: f64 = 0.1;
/// Spacing, relative to the usual one of the profile, from which on it is a gap.
const GAP: f64 = 3.0;

fn steep(key: &str, slope: f64, at: &str) -> Option<Concern> {
    (slope > STEEPEST).then(|| {
        Concern::new(
            "steep-rail",
            format!("irregularity.{key}: the rail slopes by {slope:.2e}{at}; above {STEEPEST} no train runs"),
            "check the units: all lengths are in metres unless the header of a CSV file names another unit, as in r [mm]",
        )
    })
}

/// The concerns about the profile of `input`; `files` reads a file beside the case. Silent about what cannot be read: that
/// is refused elsewhere.
pub fn concerns(input: &IrregularityInput, files: &dyn Fn(&str) -> Result<String, String>) -> Vec<Concern> {
    match input {
        // r = A cos(2πx/λ)
        IrregularityInput::Sinusoidal { wavelength, amplitude, .. } => {
            steep("amplitude", TAU * amplitude / wavelength, "").into_iter().collect()
        }
        IrregularityInput::Measured { file, rail, .. } => {
            files(file).map_or(Vec::new(), |text| of_profile(file, &text, *rail))
        }
        _ => Vec::new(),
    }
}

fn of_profile(file: &str, text: &str, rail: Option<Rail>) -> Vec<Concern> {
    let (Ok(columns), Ok(profile)) = (rail_columns(text, rail), measured_rail(text, rail)) else {
        return Vec::new();
    };
    let rms = profile.rms();
    let rough = (rms > HIGHEST).then(|| {
        Concern::new(
            "rough-rail",
            format!(
                "irregularity.file: the profile of {file} has an r.m.s. of {:.1} mm, more than {} mm",
                1e3 * rms,
                1e3 * HIGHEST
            ),
            "check its unit, which the header may name, as in r [mm]; take the line's own curves out of a levelled profile",
        )
    });
    [gap(file, &columns), steepest(file, &columns), rough].into_iter().flatten().collect()
}

/// The gaps of a profile, spacings [`GAP`] times the median one.
fn gap(file: &str, Columns { x, lines, .. }: &Columns) -> Option<Concern> {
    let spacings: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let mut sorted = spacings.clone();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted[sorted.len() / 2];
    let gaps: Vec<usize> = (0..spacings.len()).filter(|i| spacings[*i] > GAP * usual).collect();
    let first = *gaps.first()?;
    let more = if gaps.len() == 1 { String::new() } else { format!(" and {} more", gaps.len() - 1) };
    let message = format!(
        "irregularity.file: {file} has a gap from x = {} to {} m (line {}){more}; points are usually {usual:.3} m apart",
        x[first],
        x[first + 1],
        lines[first + 1],
    );
    Some(Concern::new(
        "gap-in-profile",
        message,
        "a straight line fills a gap: cut the profile, or fill it with what was measured",
    ))
}

/// The steepest slope of a profile against the line through its ends, where no train runs.
fn steepest(file: &str, Columns { x, values: r, lines }: &Columns) -> Option<Concern> {
    let last = x.len() - 1;
    let gradient = (r[last] - r[0]) / (x[last] - x[0]);
    let slope = |i: usize| ((r[i + 1] - r[i]) / (x[i + 1] - x[i]) - gradient).abs();
    let at = (0..last).max_by(|&i, &j| slope(i).total_cmp(&slope(j)))?;
    steep("file", slope(at), &format!(" at x = {} m (line {}) of {file}", x[at], lines[at]))
}

/// The concern about a `record` of the rail's deflection at the key `path`: one no track shows.
pub fn of_record(path: &str, file: &str, record: &Columns) -> Option<Concern> {
    let largest = record.values.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
    (largest > DEEPEST).then(|| {
        Concern::new(
            "unusual-value",
            format!("{path}: {file} has a deflection of {largest:.3} m; usual is up to {DEEPEST} m"),
            "check its unit, which the header may name, as in deflection [mm]",
        )
    })
}
