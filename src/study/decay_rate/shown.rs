//! What a reader sees of decay rates: arrays, answers, a picture.

use super::DecayRates;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::rail::DecayRate as Definition;
use crate::study::landmarks::{landmark_answers, marks, marks_caption, stop_band_answers};
use crate::study::{Answer, Beside, Outcome};
use ndarray::Array1;

impl DecayRates {
    /// Everything a run leaves; `beside` it what others say.
    pub(super) fn shown(&self, beside: &[Beside]) -> Outcome {
        Outcome {
            group: self.group(),
            figures: vec![self.figure(beside)],
            answers: self.answers(),
            concerns: Vec::new(),
        }
    }

    fn group(&self) -> Group {
        let decay = Array1::from(self.decay.clone()).into_dyn();
        Group::new("decay_rate")
            .attribute("definition", self.definition.name())
            .attribute("method", self.rail.name())
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .variable("decay", &["frequency"], decay, "dB m-1", "track decay rate")
    }

    fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        let extreme = |worst: fn(&f64, &f64) -> std::cmp::Ordering| {
            (0..self.decay.len()).max_by(|a, b| worst(&self.decay[*a], &self.decay[*b]))
        };
        let mut record = |key: &str, what: &str, i: usize| {
            let (f, rate) = (self.frequencies[i], self.decay[i]);
            let shown = format!("{rate:.2} dB/m at {f:.1} Hz");
            answers.push(Answer::new(key, format!("{what} decay rate"), rate, "dB/m", shown));
            let of = format!("Frequency of the {} decay rate", what.to_lowercase());
            answers.push(Answer::new(&format!("{key}_frequency"), of, f, "Hz", format!("{f:.1} Hz")));
        };
        if let Some(i) = extreme(|a, b| b.total_cmp(a)) {
            record("least_decay", "Least", i);
        }
        if let Some(i) = extreme(f64::total_cmp) {
            record("largest_decay", "Largest", i);
        }
        answers.extend(landmark_answers(&self.landmarks));
        answers.extend(stop_band_answers(&self.stop_bands));
        answers
    }

    fn figure(&self, beside: &[Beside]) -> (Figure, String) {
        let series = Series {
            name: self.definition.name().to_owned(),
            x: self.frequencies.clone(),
            y: self.decay.clone(),
            stroke: Stroke::Solid,
        };
        let picture = LineFigure {
            log_x: true,
            log_y: true,
            series: std::iter::once(series).chain(beside.iter().map(|b| b.series(1.0))).collect(),
            marks: marks(&self.landmarks),
            ..LineFigure::new("decay_rate", "Track decay rate", "frequency [Hz]", "decay rate [dB/m]")
        };
        let what = match self.definition {
            Definition::Floquet => "Of the free wave along the rail that decays least.",
            Definition::ExactReceptance => {
                "4.343 |α(0)|²/∫|α|² dx of the rail's receptance ahead of the force."
            }
            Definition::En15461 => {
                "From receptances on the grid of EN 15461, as it is measured; never below 4.343 dB over the 66 bays of the grid."
            }
        };
        let caption = format!("{what}{} Method: {}.", marks_caption(&self.landmarks), self.rail.name());
        (Figure::Lines(picture), caption)
    }
}
