//! What a reader sees of a transition: arrays, answers, pictures, concerns.

use super::Scattered;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::{Answer, Outcome, Verified, trimmed};
use ndarray::Array1;

/// Decay [dB] over a bay above which the power of a wave means little: it arrives nowhere.
const DEAF: f64 = 3.0;

impl Scattered {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        let mut figures = vec![self.power_figure()];
        figures.extend((!self.along.is_empty()).then(|| self.along_figure()));
        Outcome { group: self.group(), figures, answers: self.answers(), concerns: self.concerns() }
    }

    fn group(&self) -> Group {
        let of = |values: &[f64]| Array1::from(values.to_vec()).into_dyn();
        let group = Group::new("transition")
            .attribute("method", "coupled")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .variable(
                "reflected",
                &["frequency"],
                of(&self.reflected),
                "1",
                "share of the incident power that returns",
            )
            .variable(
                "transmitted",
                &["frequency"],
                of(&self.transmitted),
                "1",
                "share of the incident power in the last section",
            )
            .variable(
                "decay_per_bay",
                &["frequency"],
                of(&self.decay),
                "dB",
                "decay of the incident wave over a bay",
            );
        if self.along.is_empty() {
            return group;
        }
        let what = "rail displacement per force on the rail (e^{i omega t})";
        group
            .attribute("force_at", self.from)
            .coordinate("along_frequency", &self.along, "Hz", "frequency of receptances along the rail")
            .coordinate("x", &self.x, "m", "position from the first change of section")
            .complex("rail", &["along_frequency", "x"], &self.rail.clone().into_dyn(), "m N-1", what)
    }

    /// Where most returns, of frequencies at which the wave travels.
    fn answers(&self) -> Vec<Answer> {
        let heard = |i: &usize| self.decay[*i] < DEAF && self.reflected[*i].is_finite();
        let Some(i) = (0..self.frequencies.len())
            .filter(heard)
            .max_by(|a, b| self.reflected[*a].total_cmp(&self.reflected[*b]))
        else {
            return self.verified.as_ref().and_then(Verified::answer).into_iter().collect();
        };
        let (f, share) = (self.frequencies[i], self.reflected[i]);
        let what = "Largest share of power that returns, of waves that travel farther than a bay or two";
        let mut answers = vec![
            Answer::new("max_reflected", what, share, "1", format!("{:.2} % at {f:.1} Hz", 100.0 * share)),
            Answer::new("max_reflected_frequency", "Its frequency", f, "Hz", format!("{f:.1} Hz")),
        ];
        answers.extend(self.verified.as_ref().and_then(Verified::answer));
        answers
    }

    fn concerns(&self) -> Vec<Concern> {
        let deaf = self.decay.iter().filter(|decay| **decay >= DEAF).count();
        (deaf > 0)
            .then(|| {
                Concern::new(
                    "waves-die",
                    format!(
                        "at {deaf} of {} frequencies the wave that comes loses {DEAF} dB or more in a bay: shares of its power say little \
                         there",
                        self.frequencies.len()
                    ),
                    "look at the receptances along the rail instead (transition.along)",
                )
            })
            .into_iter()
            .chain(self.verified.as_ref().and_then(Verified::concern))
            .collect()
    }

    fn power_figure(&self) -> (Figure, String) {
        let curve = |name: &str, values: &[f64], stroke| Series {
            name: name.to_owned(),
            x: self.frequencies.clone(),
            y: values.to_vec(),
            stroke,
        };
        let both: Vec<f64> = self.reflected.iter().zip(&self.transmitted).map(|(r, t)| r + t).collect();
        let picture = LineFigure {
            series: vec![
                curve("reflected", &self.reflected, Stroke::Solid),
                curve("transmitted", &self.transmitted, Stroke::Solid),
                curve("both", &both, Stroke::Dashed),
            ],
            ..LineFigure::new(
                "transition",
                "Power at the change of track",
                "frequency [Hz]",
                "share of the incident power [-]",
            )
        };
        let caption = "Power of the waves that return along the first section, and of those along the last one, over that of the wave that \
                       comes along the first and decays least. Without loss both add up to 1 wherever that wave travels; loss takes its part.";
        (Figure::Lines(picture), caption.into())
    }

    fn along_figure(&self) -> (Figure, String) {
        let curve = |(i, f): (usize, &f64)| Series {
            name: format!("{} Hz", trimmed(*f)),
            x: self.x.clone(),
            y: self.rail.row(i).iter().map(|z| 1e9 * z.norm()).collect(),
            stroke: Stroke::Solid,
        };
        let change = |(i, x): (usize, &f64)| (*x, format!("change {}", i + 1));
        let title = format!("Rail receptance, force at x = {} m", self.from);
        let picture = LineFigure {
            log_y: true,
            series: self.along.iter().enumerate().map(curve).collect(),
            marks: self.changes.iter().enumerate().map(change).collect(),
            ..LineFigure::new("transition_along", title, "x from the first change [m]", "displacement [nm/N]")
        };
        let caption = "Modulus of the displacement of the rail along it per unit harmonic force; marks where sections change.";
        (Figure::Lines(picture), caption.into())
    }
}
