//! What a reader sees of receptances: arrays, answers, pictures, concerns.

use super::Receptances;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::doubts::missed_accuracy;
use crate::study::landmarks::{landmark_answers, marks, marks_caption, unbounded};
use crate::study::{Answer, Beside, Outcome};
use crate::track::Supports;
use ndarray::{Array2, ArrayView1};
use num_complex::Complex64;
use std::f64::consts::TAU;

impl Receptances {
    /// Everything a run leaves; `beside` it what others say.
    pub(super) fn shown(&self, beside: &[Beside]) -> Outcome {
        let mut figures =
            vec![if self.x.is_none() { self.rail_figure(beside) } else { self.along_figure(beside) }];
        figures.extend(self.on_springs().then(|| self.mobility_figure(beside)));
        figures.extend((!self.receivers.is_empty()).then(|| self.ground_figure()));
        let between = self.on_supports.as_ref().filter(|supports| self.between(supports));
        let unbounded = between.and_then(|supports| unbounded(&self.landmarks, &supports.rail));
        let asked = (self.frequencies.len(), "frequencies", "Hz");
        let concerns = missed_accuracy(&self.missed, "1e-4", asked).into_iter().chain(unbounded).collect();
        let mut outcome = Outcome { group: self.group(), figures, answers: self.answers(), concerns };
        if let Some(map) = &self.map {
            map.add(&mut outcome);
        }
        outcome
    }

    /// Whether force and answer both lie between supports.
    fn between(&self, supports: &Supports) -> bool {
        let off = |x: f64| (x / supports.spacing - (x / supports.spacing).round()).abs() > 1e-6;
        off(self.from) && self.x.as_deref().unwrap_or(&[self.from]).iter().any(|x| off(*x))
    }

    /// Whether the track is one of springs, whose landmarks are known.
    fn on_springs(&self) -> bool {
        !self.landmarks.is_empty()
    }

    fn group(&self) -> Group {
        let mut group = Group::new("receptance")
            .attribute("method", self.method.name())
            .attribute("force_at", self.from)
            .coordinate("frequency", &self.frequencies, "Hz", "frequency");
        let dims: &[&str] = if let Some(x) = &self.x {
            group = group.coordinate("x", x, "m", "position along the rail");
            &["frequency", "x"]
        } else {
            &["frequency"]
        };
        // Y = iωα, A = −ω²α
        let derived = |power: i32| {
            let factor = |f: usize| Complex64::new(0.0, TAU * self.frequencies[f]).powi(power);
            let values = Array2::from_shape_fn(self.rail.raw_dim(), |(f, i)| factor(f) * self.rail[(f, i)]);
            if self.x.is_some() { values.into_dyn() } else { values.column(0).to_owned().into_dyn() }
        };
        let group = group
            .complex(
                "rail",
                dims,
                &derived(0),
                "m N-1",
                "rail displacement per force on the rail (e^{i omega t})",
            )
            .complex("mobility", dims, &derived(1), "m s-1 N-1", "rail velocity per force on the rail")
            .complex(
                "accelerance",
                dims,
                &derived(2),
                "m s-2 N-1",
                "rail acceleration per force on the rail",
            );
        if self.receivers.is_empty() {
            return group;
        }
        let dims = ["receiver", "frequency"];
        let what = "vertical displacement of the ground per force on the rail";
        group
            .coordinate("receiver", &self.receivers, "m", "distance from the centre line of the track")
            .complex("ground", &dims, &self.ground.clone().into_dyn(), "m N-1", what)
    }

    /// Of the rail its first peak and its largest value, of the ground the largest at every receiver; landmarks without loss.
    fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        let mut record = |key: &str, what: &str, i: usize, value: f64| {
            let f = self.frequencies[i];
            let of = format!("Frequency of the {what}");
            answers.push(Answer::new(&format!("{key}_frequency"), of, f, "Hz", format!("{f:.1} Hz")));
            let shown = format!("{value:.3e} m/N");
            answers.push(Answer::new(key, format!("The {what}"), value, "m/N", shown));
        };
        let places = self.x.as_deref().unwrap_or(&[0.0]);
        for (i, x) in places.iter().enumerate() {
            let modulus = norms(self.rail.column(i));
            let (key, at) = match &self.x {
                Some(_) => (format!("_at_{x}"), format!(" at x = {x} m")),
                None => (String::new(), String::new()),
            };
            // a first peak, where the force stands, is the cut-on
            if let (None, Some(i)) = (&self.x, first_peak(&modulus)) {
                record("cut_on", "first peak of the rail receptance (cut-on)", i, modulus[i]);
            }
            let top = largest(&modulus);
            record(
                &format!("max_receptance{key}"),
                &format!("largest rail receptance{at}"),
                top,
                modulus[top],
            );
        }
        for (y, row) in self.receivers.iter().zip(self.ground.rows()) {
            let values = norms(row);
            let top = largest(&values);
            let what = format!("largest ground receptance at {y} m");
            record(&format!("max_ground_{y}"), &what, top, values[top]);
        }
        answers.extend(landmark_answers(&self.landmarks));
        answers
    }

    /// A curve of `values` [m/N] in nm/N.
    fn curve(&self, name: String, values: impl IntoIterator<Item = f64>, stroke: Stroke) -> Series {
        let y = values.into_iter().map(|v| 1e9 * v).collect();
        Series { name, x: self.frequencies.clone(), y, stroke }
    }

    fn rail_figure(&self, beside: &[Beside]) -> (Figure, String) {
        let curve = |name: &str, part: fn(&Complex64) -> f64, stroke| {
            self.curve(name.into(), self.rail.iter().map(part), stroke)
        };
        let (title, y_label) = ("Rail receptance under a standing load", "displacement [nm/N]");
        let curves = [
            curve("modulus", |z| z.norm(), Stroke::Solid),
            curve("real part", |z| z.re, Stroke::Dashed),
            curve("imaginary part", |z| z.im, Stroke::Dashed),
        ];
        let picture = LineFigure {
            series: curves.into_iter().chain(beside.iter().map(|b| b.series(1e9))).collect(),
            ..LineFigure::new("receptance_rail", title, "frequency [Hz]", y_label)
        };
        let caption =
            "Displacement of the rail under a unit harmonic force on it, positive down, phases of e^{iωt}.";
        (Figure::Lines(picture), caption.into())
    }

    /// Moduli at every x.
    fn along_figure(&self, beside: &[Beside]) -> (Figure, String) {
        let places = self.x.as_deref().unwrap_or_default();
        let curve = |(i, x): (usize, &f64)| {
            self.curve(format!("x = {x} m"), norms(self.rail.column(i)), Stroke::Solid)
        };
        let title = format!("Rail receptance, force at x = {} m", self.from);
        let curves = places.iter().enumerate().map(curve);
        let picture = LineFigure {
            log_x: true,
            log_y: true,
            series: curves.chain(beside.iter().map(|b| b.series(1e9))).collect(),
            marks: marks(&self.landmarks),
            ..LineFigure::new("receptance_rail", title, "frequency [Hz]", "displacement [nm/N]")
        };
        let caption = format!(
            "Modulus of the displacement of the rail per unit harmonic force on it.{} Method: {}.",
            marks_caption(&self.landmarks),
            self.method.name()
        );
        (Figure::Lines(picture), caption)
    }

    /// |iωα| at every x.
    fn mobility_figure(&self, beside: &[Beside]) -> (Figure, String) {
        let curve = |i: usize, name: String| {
            let values =
                self.frequencies.iter().zip(self.rail.column(i)).map(|(f, z)| 1e6 * TAU * f * z.norm());
            Series { name, x: self.frequencies.clone(), y: values.collect(), stroke: Stroke::Solid }
        };
        let name = |i: usize| match &self.x {
            Some(x) => format!("x = {} m", x[i]),
            None => "under the force".to_owned(),
        };
        let points = beside.iter().map(|b| {
            let values = b.x.iter().zip(&b.values).map(|(f, v)| TAU * f * v).collect();
            Beside { values, ..b.clone() }.series(1e6)
        });
        let picture = LineFigure {
            log_x: true,
            log_y: true,
            series: (0..self.rail.ncols()).map(|i| curve(i, name(i))).chain(points).collect(),
            marks: marks(&self.landmarks),
            ..LineFigure::new("mobility_rail", "Rail mobility", "frequency [Hz]", "mobility [µm/s/N]")
        };
        let caption = format!(
            "Modulus of the velocity of the rail per unit harmonic force on it.{} Method: {}.",
            marks_caption(&self.landmarks),
            self.method.name()
        );
        (Figure::Lines(picture), caption)
    }

    fn ground_figure(&self) -> (Figure, String) {
        let curve = |(y, row): (&f64, _)| self.curve(format!("{y} m"), norms(row), Stroke::Solid);
        let (title, y_label) = ("Ground receptance beside the track", "vertical displacement [nm/N]");
        let picture = LineFigure {
            log_y: true,
            series: self.receivers.iter().zip(self.ground.rows()).map(curve).collect(),
            ..LineFigure::new("receptance_ground", title, "frequency [Hz]", y_label)
        };
        let caption = "Modulus of the vertical displacement of the ground's surface per unit harmonic force on the rail, abreast of it.";
        (Figure::Lines(picture), caption.into())
    }
}

fn norms(values: ArrayView1<Complex64>) -> Vec<f64> {
    values.iter().map(|z| z.norm()).collect()
}

fn largest(values: &[f64]) -> usize {
    (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0)
}

/// The first value larger than both neighbours.
fn first_peak(values: &[f64]) -> Option<usize> {
    (1..values.len().saturating_sub(1)).find(|&i| values[i] > values[i - 1] && values[i] >= values[i + 1])
}
