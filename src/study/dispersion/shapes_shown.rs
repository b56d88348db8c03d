//! What a reader sees of mode shapes: arrays and curves over depth.

use super::Shapes;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::soil::mode_shape::ModeShape;
use crate::study::{tag, trimmed};
use ndarray::Array3;

/// Curves in one picture.
const MOST: usize = 4;

/// A component of a shape: name, words, values.
type Part = (&'static str, &'static str, fn(&ModeShape) -> &[f64]);

impl Shapes {
    fn parts(&self) -> Vec<Part> {
        let all: [Part; 3] = [
            (
                "shape_along",
                "motion along the direction of travel, a quarter of a period apart from shape_down",
                |s| &s.along,
            ),
            ("shape_down", "vertical motion", |s| &s.down),
            ("shape_across", "motion across the direction of travel", |s| &s.across),
        ];
        let there = |part: &Part| self.shapes.iter().flatten().any(|shape| !part.2(shape).is_empty());
        all.into_iter().filter(there).collect()
    }

    /// `group` with the shapes over (shape_frequency, mode, z).
    pub(super) fn with(&self, group: Group) -> Group {
        let count = group.get("mode").map_or(0, |mode| mode.values.len());
        let mut group = group
            .coordinate("shape_frequency", &self.at.frequencies, "Hz", "frequency of the mode shapes")
            .coordinate("z", &self.at.depths, "m", "depth below the surface");
        for (name, what, of) in self.parts() {
            let values =
                Array3::from_shape_fn((self.shapes.len(), count, self.at.depths.len()), |(i, j, d)| {
                    self.shapes[i].get(j).and_then(|shape| of(shape).get(d)).copied().unwrap_or(f64::NAN)
                });
            let what = format!(
                "{what} of the mode without damping, the largest of the mode being 1; not a number where there is no such mode"
            );
            group = group.variable(name, &["shape_frequency", "mode", "z"], values.into_dyn(), "1", &what);
        }
        group
    }

    /// One picture for each frequency: the slowest modes over depth.
    pub(super) fn figures(&self) -> Vec<(Figure, String)> {
        let figure = |f: f64, shapes: &[ModeShape]| {
            let mut series = Vec::new();
            for (j, shape) in shapes.iter().take(MOST).enumerate() {
                let curves = [
                    ("vertical", &shape.down, Stroke::Solid),
                    ("along", &shape.along, Stroke::Dashed),
                    ("across", &shape.across, Stroke::Solid),
                ];
                for (way, values, stroke) in curves.into_iter().filter(|c| !c.1.is_empty()) {
                    series.push(Series {
                        name: format!("mode {j}, {way}"),
                        x: values.clone(),
                        y: self.at.depths.clone(),
                        stroke,
                    });
                }
            }
            let picture = LineFigure {
                y_down: true,
                series,
                ..LineFigure::new(
                    format!("mode_shapes_{}", tag(f)),
                    format!("Mode shapes at {} Hz", trimmed(f)),
                    "motion, the largest of each mode being 1 [1]",
                    "depth z [m]",
                )
            };
            let caption = format!(
                "How the undamped ground moves over depth in its trapped modes at {} Hz.",
                trimmed(f)
            );
            (Figure::Lines(picture), caption)
        };
        let there = self.at.frequencies.iter().zip(&self.shapes).filter(|(_, shapes)| !shapes.is_empty());
        there.map(|(f, shapes)| figure(*f, shapes)).collect()
    }
}
