//! What pictures of the free field have in common; third octaves as steps from edge to edge of each band, as velocities or as levels.

use crate::assessment::{Band, Reference};
use crate::figure::{LineFigure, Series, Stroke};

/// `value` where a logarithmic picture has room for it beside `largest`, else a gap in the curve.
pub(in crate::study) fn seen(value: f64, largest: f64) -> f64 {
    if value > 1e-4 * largest { value } else { f64::NAN }
}

/// A figure without its curves.
pub(in crate::study) fn figure(name: String, title: String, labels: (&str, &str), log: bool) -> LineFigure {
    LineFigure { log_x: log, log_y: log, ..LineFigure::new(name, title, labels.0, labels.1) }
}

/// A picture of third octaves in `bands` without its curves, with their nominal centres: velocities, or levels over a reference.
pub(in crate::study) fn band_figure(
    name: String,
    title: String,
    bands: &[Band],
    levels: Option<Reference>,
) -> LineFigure {
    let label = match levels {
        None => "r.m.s. velocity [mm/s]".to_owned(),
        Some(reference) => format!("velocity level [{}]", reference.name()),
    };
    let picture = figure(name, title, ("one-third-octave band [Hz]", &label), true);
    LineFigure { log_y: levels.is_none(), x_ticks: band_ticks(bands), ..picture }
}

/// The nominal centres of `bands` as ticks, every second or third one where all have no room.
pub(in crate::study) fn band_ticks(bands: &[Band]) -> Vec<(f64, String)> {
    let stride = bands.len().div_ceil(24).max(1) as i32;
    let shown = bands.iter().filter(|band| band.number.rem_euclid(stride) == 0);
    shown.map(|band| (band.centre(), band.label())).collect()
}

/// `velocities` [m/s] of `bands` as steps; what is small beside `largest` [m/s] is a gap.
pub(in crate::study) fn steps(
    name: String,
    bands: &[Band],
    velocities: &[f64],
    (stroke, levels, largest): (Stroke, Option<Reference>, f64),
) -> Series {
    let shown = |v: f64| match (levels, seen(v, largest)) {
        (None, v) => 1e3 * v,
        (Some(reference), v) => 20.0 * (v / reference.velocity()).log10(),
    };
    let edges = bands.iter().zip(velocities);
    let (x, y) = match stroke {
        // markers stand in the middle of their band
        Stroke::Points => edges.map(|(band, v)| (band.centre(), shown(*v))).unzip(),
        _ => edges.flat_map(|(band, v)| [(band.lower(), shown(*v)), (band.upper(), shown(*v))]).unzip(),
    };
    Series { name, x, y, stroke }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_nominal_centres() {
        let labels = |from, to| -> String {
            let ticks = band_ticks(&Band::range(from, to).unwrap());
            ticks.iter().map(|(_, label)| format!("{label} ")).collect()
        };
        assert_eq!(labels(16.0, 40.0), "16 20 25 31.5 40 ");
        assert_eq!(labels(1.0, 315.0), "1 1.6 2.5 4 6.3 10 16 25 40 63 100 160 250 ");
    }

    #[test]
    fn steps_go_from_edge_to_edge() {
        let bands = Band::range(8.0, 12.5).unwrap();
        let line = steps("v".into(), &bands, &[1e-4, 1e-3, 1e-9], (Stroke::Solid, None, 1e-3));
        assert_eq!(line.x.len(), 6);
        assert_eq!((line.x[1], line.x[2]), (bands[0].upper(), bands[1].lower()));
        assert!((line.y[0] - 0.1).abs() < 1e-12 && (line.y[3] - 1.0).abs() < 1e-12 && line.y[4].is_nan());
        // 0.1 mm/s: 100 dB re 1e-9 m/s
        let level = steps("v".into(), &bands, &[1e-4; 3], (Stroke::Points, Some(Reference::Iso1683), 1e-4));
        assert_eq!(level.x, bands.iter().map(|b| b.centre()).collect::<Vec<_>>());
        assert!((level.y[0] - 100.0).abs() < 1e-9);
    }
}
