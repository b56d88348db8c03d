//! What a reader sees of the surface around a standing load.

use super::Surface;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, MapFigure};
use crate::study::{Answer, Outcome, tag};
use ndarray::{Array1, Array2, Array3, Axis};
use num_complex::Complex64;

/// Estimated error of the integrals relative to the largest value above which it is a concern.
const TOLERABLE: f64 = 1e-3;

/// Share of the area beyond the colours of a picture.
const OUTSIDE: f64 = 0.01;
/// Range of levels in a picture [dB]: what is smaller is not known, the error being 1e-4 of the largest value.
const RANGE: f64 = 80.0;

impl Surface {
    /// Adds what the maps leave to `outcome`.
    pub(super) fn add(&self, outcome: &mut Outcome) {
        for (field, &frequency) in self.fields.iter().zip(&self.frequencies) {
            outcome.figures.extend(self.pictures(&field.values, frequency));
            let largest = field.values.iter().map(|u| u.norm()).fold(0.0, f64::max);
            outcome.answers.push(Answer::new(
                &format!("max_map_{}", tag(frequency)),
                format!("The largest ground receptance in the map at {frequency} Hz"),
                largest,
                "m/N",
                format!("{largest:.3e} m/N"),
            ));
            if field.error > TOLERABLE {
                outcome.concerns.push(Concern::new(
                    "quadrature",
                    format!(
                        "the map at {frequency} Hz may be off by {:.2} % of its largest value",
                        100.0 * field.error
                    ),
                    "poles lie too close to the real axis (more damping helps), or the track spreads the load too little",
                ));
            }
        }
        outcome.group = self.arrays(std::mem::take(&mut outcome.group));
    }

    fn arrays(&self, group: Group) -> Group {
        let mut all = Array3::from_elem((self.fields.len(), self.y.len(), self.x.len()), Complex64::ZERO);
        for (n, field) in self.fields.iter().enumerate() {
            all.index_axis_mut(Axis(0), n).assign(&field.values);
        }
        let errors: Array1<f64> = self.fields.iter().map(|field| field.error).collect();
        let what = "vertical displacement of the ground's surface per force on the rail, positive down";
        let error = "estimated error of the map over its largest value";
        group
            .coordinate("map_frequency", &self.frequencies, "Hz", "frequency of each map")
            .coordinate("y", &self.y, "m", "position across the track, from its centre line")
            .coordinate("x", &self.x, "m", "position along the track, from the force")
            .complex("map", &["map_frequency", "y", "x"], &all.into_dyn(), "m N-1", what)
            .variable("relative_error", &["map_frequency"], errors.into_dyn(), "1", error)
    }

    /// Modulus and real part at one frequency.
    fn pictures(&self, values: &Array2<Complex64>, frequency: f64) -> [(Figure, String); 2] {
        let map = |name: &str, what: &str, value_label: &str, values: Array2<f64>, symmetric| {
            Figure::Map(MapFigure {
                name: format!("receptance_map_{name}_{}", tag(frequency)),
                title: format!("Ground surface around a standing load at {frequency} Hz: {what}"),
                x_label: "x [m], along the track".into(),
                y_label: "y [m]".into(),
                value_label: value_label.into(),
                x: self.x.clone(),
                y: self.y.clone(),
                values,
                holds: None,
                symmetric,
                equal_axes: true,
                overlay: Vec::new(),
            })
        };
        // nodes are as deep as the spacing finds them, and the force hides the waves: the colours end within both
        let mut level = values.mapv(|u| 20.0 * (1e9 * u.norm()).log10());
        let largest = level.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = quantile(level.iter().copied(), OUTSIDE).max(largest - RANGE);
        level.mapv_inplace(|value| value.max(least));
        let mut real = values.mapv(|u| 1e9 * u.re);
        let most = quantile(real.iter().map(|value| value.abs()), 1.0 - OUTSIDE);
        real.mapv_inplace(|value| value.min(most).max(-most));
        let percent = 100.0 * OUTSIDE;
        let of = "of the vertical displacement of the ground's surface per unit harmonic force on the rail at the origin";
        [
            (
                map("modulus", "modulus", "|u_z| [dB re 1 nm/N]", level, false),
                format!(
                    "At {frequency} Hz: modulus {of}, in decibels; {percent} % of the area, and all that is {RANGE} dB below the largest, has the darkest colour."
                ),
            ),
            (
                map("real", "real part", "Re u_z [nm/N], positive down", real, true),
                format!(
                    "At {frequency} Hz: real part {of}, the shape at the moment the force is largest; {percent} % of the area lies beyond the colours."
                ),
            ),
        ]
    }
}

/// The value below which `share` of the `values` lie.
fn quantile(values: impl Iterator<Item = f64>, share: f64) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[(share * (values.len() - 1) as f64).round() as usize]
}
