//! What the speed of the line means: amplification there, its share of the critical speed, speeds at which the amplification passes
//! what a designer allows.

use super::shown::KMH;
use super::{SpeedCurve, SpeedCurves};
use crate::concern::Concern;
use crate::figure::{Series, Stroke};
use crate::study::{Answer, speed_text};

/// Amplifications whose speeds are told: a fifth, and a half more than at rest.
pub(super) const LEVELS: [f64; 2] = [1.2, 1.5];

/// The track at the speed of the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineSpeed {
    /// v [m/s]
    pub speed: f64,
    /// Largest downward deflection under the heaviest axle alone [m].
    pub axle: f64,
    /// Under the whole train [m], where it has more axles than one.
    pub train: Option<f64>,
}

/// Where an amplification is passed for the first time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reached {
    /// Below the first speed asked, which is this [m/s].
    Before(f64),
    /// At this speed [m/s].
    At(f64),
    /// Nowhere up to the last speed asked, which is this [m/s].
    Nowhere(f64),
}

impl Reached {
    /// The speed [m/s] that may be told: where nothing is passed the last one asked.
    fn speed(self) -> f64 {
        match self {
            Self::Before(v) | Self::At(v) | Self::Nowhere(v) => v,
        }
    }

    fn text(self) -> String {
        match self {
            Self::Before(v) => format!("below {}, the first speed asked", speed_text(v)),
            Self::At(v) => speed_text(v),
            Self::Nowhere(v) => format!("not up to {}", speed_text(v)),
        }
    }
}

impl SpeedCurve {
    /// The first speed at which the amplification reaches `level`, between the speeds of the curve by the chord.
    pub fn passes(&self, level: f64) -> Reached {
        let amplification = self.amplification();
        match amplification.iter().position(|a| *a >= level) {
            None => Reached::Nowhere(self.speeds[self.speeds.len() - 1]),
            Some(0) => Reached::Before(self.speeds[0]),
            Some(i) => {
                let (low, high) = (amplification[i - 1], amplification[i]);
                let share = (level - low) / (high - low);
                Reached::At(self.speeds[i - 1] + share * (self.speeds[i] - self.speeds[i - 1]))
            }
        }
    }
}

impl SpeedCurves {
    /// The curve that reaches `level` first, and where.
    fn first_to_pass(&self, level: f64) -> (&'static str, Reached) {
        let axle = ("one axle", self.axle.passes(level));
        let rank = |passed: Reached| (matches!(passed, Reached::Nowhere(_)), passed.speed());
        let train = self.train.as_ref().map(|train| ("this train", train.passes(level)));
        match train {
            Some(train) if rank(train.1) < rank(axle.1) => train,
            _ => axle,
        }
    }

    /// Speeds at which amplifications are passed, and what there is at the speed of the line.
    pub(super) fn speeds_that_matter(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        let critical = &self.axle.peak;
        if let Some(line) = self.line {
            let at = format!("at the line speed, {}", speed_text(line.speed));
            let ratio = |what: &str, key: &str, value: f64| {
                Answer::new(key, format!("{what} {at}"), value, "1", format!("{value:.2}"))
            };
            let share = line.speed / critical.speed;
            let shown = if critical.at_end {
                "unknown: no maximum in the range of speeds".into()
            } else {
                format!("{share:.2}")
            };
            let what = "Line speed over the critical speed of ground and track";
            answers.push(Answer::new("line_speed_ratio", what, share, "1", shown));
            if let (Some(down), Some(train)) = (line.train, &self.train) {
                let amplification = "line_speed_amplification";
                answers.push(ratio(
                    "Dynamic amplification of this train",
                    amplification,
                    down / train.at_rest,
                ));
                let alone = "line_speed_single_axle_amplification";
                answers.push(ratio(
                    "Dynamic amplification of the heaviest axle",
                    alone,
                    line.axle / self.axle.at_rest,
                ));
            } else {
                answers.push(ratio(
                    "Dynamic amplification",
                    "line_speed_amplification",
                    line.axle / self.axle.at_rest,
                ));
            }
            let down = line.train.unwrap_or(line.axle);
            let what = format!("Largest downward rail deflection {at}");
            answers.push(Answer::new(
                "line_speed_max_down",
                what,
                down,
                "m",
                format!("{:.3} mm", 1e3 * down),
            ));
        }
        for level in LEVELS {
            let (whose, passed) = self.first_to_pass(level);
            let whose = if self.train.is_some() { format!(" (first by {whose})") } else { String::new() };
            answers.push(Answer::new(
                &format!("speed_at_amplification_{level}"),
                format!("Speed at which the amplification passes {level}{whose}"),
                passed.speed(),
                "m/s",
                passed.text(),
            ));
        }
        answers
    }

    /// Where the levels are passed, as points of the picture of amplifications.
    pub(super) fn passed_levels(&self) -> Option<Series> {
        let curves = std::iter::once(&self.axle).chain(&self.train);
        let points = curves.flat_map(|curve| LEVELS.map(|level| (curve.passes(level), level)));
        let (x, y): (Vec<f64>, Vec<f64>) = points
            .filter_map(|(passed, level)| match passed {
                Reached::At(speed) => Some((KMH * speed, level)),
                _ => None,
            })
            .unzip();
        let name = format!("passes {} and {}", LEVELS[0], LEVELS[1]);
        (!x.is_empty()).then_some(Series { name, x, y, stroke: Stroke::Points })
    }

    /// A concern if trains shall run as fast as the waves of ground and track.
    pub(super) fn too_fast_a_line(&self) -> Option<Concern> {
        let (line, critical) = (self.line?, &self.axle.peak);
        (!critical.at_end && line.speed >= critical.speed).then(|| {
            Concern::new(
                "line-speed-above-critical",
                format!(
                    "the line speed, {}, is not below the critical speed of ground and track, {}",
                    speed_text(line.speed),
                    speed_text(critical.speed)
                ),
                "improve the ground or the track, or limit the speed",
            )
        })
    }
}
