//! What a given profile of the rail may be doubted for: gaps, steps, heights in the wrong unit.

use super::schema::{IrregularityInput, IrregularityKind};
use crate::columns;
use crate::concern::Concern;
use crate::irregularity::measured;
use std::f64::consts::TAU;

/// Steepest slope of a rail that trains run on, and largest r.m.s. height [m].
const STEEPEST: f64 = 0.01;
const HIGHEST: f64 = 0.03;
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
    match (input.kind, input.wavelength, input.amplitude, &input.file) {
        // r = A cos(2πx/λ)
        (IrregularityKind::Sinusoidal, Some(wavelength), Some(amplitude), _) => {
            steep("amplitude", TAU * amplitude / wavelength, "").into_iter().collect()
        }
        (IrregularityKind::Measured, _, _, Some(file)) => {
            files(file).map_or(Vec::new(), |text| of_profile(file, &text))
        }
        _ => Vec::new(),
    }
}

fn of_profile(file: &str, text: &str) -> Vec<Concern> {
    let (Ok(columns), Ok(profile)) = (columns::read(text), measured(text)) else { return Vec::new() };
    let (x, r) = (&columns.x, &columns.values);
    let last = x.len() - 1;
    let gradient = (r[last] - r[0]) / (x[last] - x[0]);
    let mut spacings: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let (mut slope, mut steepest, mut gaps) = (0.0, 0, Vec::new());
    for i in 0..last {
        let here = ((r[i + 1] - r[i]) / spacings[i] - gradient).abs();
        if here > slope {
            (slope, steepest) = (here, i);
        }
    }
    let widths = spacings.clone();
    spacings.sort_by(f64::total_cmp);
    let usual = spacings[last / 2];
    gaps.extend((0..last).filter(|i| widths[*i] > GAP * usual));
    let mut list = Vec::new();
    if let Some(&first) = gaps.first() {
        list.push(Concern::new(
            "gap-in-profile",
            format!(
                "irregularity.file: {file} has {} gap(s), the first from x = {} to {} m (line {}), where points are usually {:.3} m apart",
                gaps.len(),
                x[first],
                x[first + 1],
                columns.lines[first + 1],
                usual
            ),
            "a straight line fills a gap: cut the profile, or fill it with what was measured",
        ));
    }
    list.extend(steep(
        "file",
        slope,
        &format!(" at x = {} m (line {}) of {file}", x[steepest], columns.lines[steepest]),
    ));
    let rms = profile.rms();
    if rms > HIGHEST {
        list.push(Concern::new(
            "rough-rail",
            format!("irregularity.file: the profile of {file} has an r.m.s. of {:.1} mm, more than {} mm", 1e3 * rms, 1e3 * HIGHEST),
            "check its unit, which the header may name, as in r [mm]; take the line's own curves out of a levelled profile",
        ));
    }
    list
}
