//! What a reader sees of receptances: arrays, answers, pictures, concerns.

use super::Receptances;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::doubts::missed_accuracy;
use crate::study::{Answer, Outcome};
use ndarray::{Array1, ArrayView1};
use num_complex::Complex64;

impl Receptances {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        let mut figures = vec![self.rail_figure()];
        figures.extend((!self.receivers.is_empty()).then(|| self.ground_figure()));
        let asked = (self.frequencies.len(), "frequencies", "Hz");
        let concerns = missed_accuracy(&self.missed, "1e-4", asked).into_iter().collect();
        let mut outcome = Outcome { group: self.group(), figures, answers: self.answers(), concerns };
        if let Some(map) = &self.map {
            map.add(&mut outcome);
        }
        outcome
    }

    fn group(&self) -> Group {
        let rail =
            |part: fn(&Complex64) -> f64| self.rail.iter().map(part).collect::<Array1<f64>>().into_dyn();
        let real = "rail displacement per force on the rail, real part";
        let imaginary = "the same, imaginary part (e^{i omega t})";
        let group = Group::new("receptance")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .variable("rail_re", &["frequency"], rail(|z| z.re), "m N-1", real)
            .variable("rail_im", &["frequency"], rail(|z| z.im), "m N-1", imaginary);
        if self.receivers.is_empty() {
            return group;
        }
        let dims = ["receiver", "frequency"];
        let ground = |part: fn(Complex64) -> f64| self.ground.mapv(part).into_dyn();
        let real = "vertical displacement of the ground per force on the rail, real part";
        group
            .coordinate("receiver", &self.receivers, "m", "distance from the centre line of the track")
            .variable("ground_re", &dims, ground(|z| z.re), "m N-1", real)
            .variable("ground_im", &dims, ground(|z| z.im), "m N-1", "the same, imaginary part")
    }

    /// Of the rail its first peak and its largest value, of the ground the largest at every receiver.
    fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        let mut record = |key: &str, what: &str, i: usize, value: f64| {
            let f = self.frequencies[i];
            let of = format!("Frequency of the {what}");
            answers.push(Answer::new(&format!("{key}_frequency"), of, f, "Hz", format!("{f:.1} Hz")));
            let shown = format!("{value:.3e} m/N");
            answers.push(Answer::new(key, format!("The {what}"), value, "m/N", shown));
        };
        let modulus = norms(ArrayView1::from(&self.rail));
        if let Some(i) = first_peak(&modulus) {
            record("cut_on", "first peak of the rail receptance (cut-on)", i, modulus[i]);
        }
        let top = largest(&modulus);
        record("max_receptance", "largest rail receptance", top, modulus[top]);
        for (y, row) in self.receivers.iter().zip(self.ground.rows()) {
            let values = norms(row);
            let top = largest(&values);
            let what = format!("largest ground receptance at {y} m");
            record(&format!("max_ground_{y}"), &what, top, values[top]);
        }
        answers
    }

    /// A curve of `values` [m/N] in nm/N.
    fn curve(&self, name: String, values: impl IntoIterator<Item = f64>, stroke: Stroke) -> Series {
        let y = values.into_iter().map(|v| 1e9 * v).collect();
        Series { name, x: self.frequencies.clone(), y, stroke }
    }

    fn rail_figure(&self) -> (Figure, String) {
        let curve = |name: &str, part: fn(&Complex64) -> f64, stroke| {
            self.curve(name.into(), self.rail.iter().map(part), stroke)
        };
        let (title, y_label) = ("Rail receptance under a standing load", "displacement [nm/N]");
        let picture = LineFigure {
            series: vec![
                curve("modulus", |z| z.norm(), Stroke::Solid),
                curve("real part", |z| z.re, Stroke::Dashed),
                curve("imaginary part", |z| z.im, Stroke::Dashed),
            ],
            ..LineFigure::new("receptance_rail", title, "frequency [Hz]", y_label)
        };
        let caption =
            "Displacement of the rail under a unit harmonic force on it, positive down, phases of e^{iωt}.";
        (Figure::Lines(picture), caption.into())
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
