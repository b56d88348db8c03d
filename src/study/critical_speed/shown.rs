//! What a reader sees of the speed curves: arrays, answers, pictures, concerns. The lower number, that of ground and track, comes first.

use super::extremes::{AHEAD, BEHIND};
use super::{Peak, SpeedCurve, SpeedCurves};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, SecondAxis, Series, Stroke};
use crate::study::doubts::{missed_accuracy, static_deflection};
use crate::study::{Answer, Outcome, speed_text};
use ndarray::Array1;

/// Share of the axle's critical speed by which that of the train's largest deflection may lie above or below.
const ABOVE: f64 = 0.05;
const BELOW: f64 = 0.02;
/// Difference from 1 of the amplification as v → 0 that a reader asks about.
const SLOW: f64 = 0.01;

/// km/h in a m/s.
pub(super) const KMH: f64 = 3.6;

/// "4.816 mm" of a deflection in metres.
fn millimetres(deflection: f64) -> String {
    format!("{:.3} mm", 1e3 * deflection)
}

impl Peak {
    /// The speed, or that there is no maximum inside the range.
    fn text(&self) -> String {
        if self.at_end {
            format!("not in the range; largest at its end, {}", speed_text(self.speed))
        } else {
            speed_text(self.speed)
        }
    }

    /// Its line in a picture, if the range holds it.
    fn mark(&self, name: &str) -> Option<(f64, String)> {
        (!self.at_end).then(|| (KMH * self.speed, format!("{name} {:.0} km/h", KMH * self.speed)))
    }
}

impl SpeedCurves {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        Outcome {
            group: self.group(),
            figures: self.figures(),
            answers: self.answers().into_iter().chain(self.speeds_that_matter()).collect(),
            concerns: self.concerns(),
        }
    }

    fn group(&self) -> Group {
        let whole = self.of_train();
        let array = |v: &[f64]| Array1::from(v.to_vec()).into_dyn();
        let down = "largest downward rail deflection";
        let up = "largest upward rail deflection";
        let group = Group::new("critical_speed")
            .coordinate("speed", &whole.speeds, "m s-1", "train speed")
            .variable("max_down", &["speed"], array(&whole.down), "m", &format!("{down} over all positions"))
            .variable(
                "max_up",
                &["speed"],
                array(&whole.up),
                "m",
                &format!("{up} over all positions, positive upward"),
            )
            .variable(
                "amplification",
                &["speed"],
                array(&whole.amplification()),
                "1",
                "max_down over its static limit",
            )
            .attribute("critical_speed", self.axle.peak.speed)
            .attribute("max_down", whole.peak.down)
            .attribute("reference_deflection", whole.at_rest)
            .attribute("amplification", whole.peak.down / whole.at_rest);
        let group = match self.line {
            Some(line) => group
                .attribute("line_speed", line.speed)
                .attribute("line_speed_max_down", line.train.unwrap_or(line.axle)),
            None => group,
        };
        if self.train.is_none() {
            return group;
        }
        let alone = "under the heaviest axle alone";
        group
            .variable(
                "single_axle_max_down",
                &["speed"],
                array(&self.axle.down),
                "m",
                &format!("{down} {alone}"),
            )
            .variable(
                "single_axle_max_up",
                &["speed"],
                array(&self.axle.up),
                "m",
                &format!("{up} {alone}, positive upward"),
            )
            .attribute("train_largest_speed", whole.peak.speed)
            .attribute("single_axle_critical_speed", self.axle.peak.speed)
            .attribute("single_axle_max_down", self.axle.peak.down)
            .attribute("single_axle_reference_deflection", self.axle.at_rest)
    }

    fn answers(&self) -> Vec<Answer> {
        let axle = &self.axle;
        let speed =
            |key: &str, what: &str, peak: &Peak| Answer::new(key, what, peak.speed, "m/s", peak.text());
        let deflection =
            |key: &str, what: String, value: f64| Answer::new(key, what, value, "m", millimetres(value));
        let amplification = |what: &str, curve: &SpeedCurve| {
            let value = curve.peak.down / curve.at_rest;
            Answer::new("amplification", what, value, "1", format!("{value:.2}"))
        };
        let Some(train) = &self.train else {
            return vec![
                speed("critical_speed", "Critical speed", &axle.peak),
                deflection(
                    "max_down",
                    "Largest downward rail deflection, at the critical speed".into(),
                    axle.peak.down,
                ),
                deflection("reference_deflection", "Static rail deflection (speed 0)".into(), axle.at_rest),
                amplification("Dynamic amplification at the critical speed", axle),
            ];
        };
        let at = format!("{:.0} km/h", 3.6 * train.peak.speed);
        vec![
            speed("critical_speed", "Critical speed of ground and track (one axle)", &axle.peak),
            deflection(
                "single_axle_max_down",
                "Largest deflection of the heaviest axle, there".into(),
                axle.peak.down,
            ),
            deflection(
                "single_axle_reference_deflection",
                "Static deflection of the heaviest axle".into(),
                axle.at_rest,
            ),
            speed("train_largest_speed", "Speed at which this train moves the rail most", &train.peak),
            deflection("max_down", format!("Largest deflection of this train, at {at}"), train.peak.down),
            deflection(
                "reference_deflection",
                "Static deflection of this train (speed 0)".into(),
                train.at_rest,
            ),
            amplification(&format!("Dynamic amplification of this train, at {at}"), train),
            speed("single_axle_critical_speed", "Critical speed of the heaviest axle (as above)", &axle.peak),
        ]
    }

    fn figures(&self) -> Vec<(Figure, String)> {
        let curve = |name: &str, y: Vec<f64>, stroke| Series {
            name: name.into(),
            x: self.axle.speeds.iter().map(|v| KMH * v).collect(),
            y,
            stroke,
        };
        let mm = |v: &[f64]| v.iter().map(|x| 1e3 * x).collect::<Vec<_>>();
        let line =
            self.line.map(|line| (KMH * line.speed, format!("line speed {:.0} km/h", KMH * line.speed)));
        let critical = self.axle.peak.mark("critical speed").into_iter().chain(line);
        let (deflections, mut amplifications, marks): (_, Vec<Series>, Vec<(f64, String)>) = match &self.train
        {
            None => (
                vec![
                    curve("largest downward", mm(&self.axle.down), Stroke::Solid),
                    curve("largest upward", mm(&self.axle.up), Stroke::Dashed),
                ],
                vec![curve("single axle", self.axle.amplification(), Stroke::Solid)],
                critical.collect(),
            ),
            Some(train) => (
                vec![
                    curve("heaviest axle alone, largest downward", mm(&self.axle.down), Stroke::Solid),
                    curve("this train, largest downward", mm(&train.down), Stroke::Solid),
                    curve("this train, largest upward", mm(&train.up), Stroke::Dashed),
                ],
                vec![
                    curve("heaviest axle alone", self.axle.amplification(), Stroke::Solid),
                    curve("this train", train.amplification(), Stroke::Solid),
                ],
                critical.chain(train.peak.mark("train's largest")).collect(),
            ),
        };
        amplifications.extend(self.passed_levels());
        let figure = |name: &str, title: &str, y_label: &str, series, marks| {
            Figure::Lines(LineFigure {
                second_x: Some(SecondAxis { label: "speed [m/s]".into(), factor: 1.0 / KMH }),
                series,
                marks,
                ..LineFigure::new(name, title, "speed [km/h]", y_label)
            })
        };
        let (title, label) = ("Rail deflection against speed", "rail deflection [mm]");
        let caption = "Largest downward and upward deflection of the rail over all positions, for each speed. The critical speed is that of \
             ground and track, found with one axle.";
        let first = figure("critical_speed", title, label, deflections, marks.clone());
        let (title, label) =
            ("Dynamic amplification against speed", "largest downward deflection / static [-]");
        let second = figure("amplification", title, label, amplifications, marks);
        let relative = "Largest downward deflection relative to the exact static limit.".to_owned();
        let relative = relative + &self.of_train().towards_rest();
        vec![(first, caption.into()), (second, relative)]
    }

    fn concerns(&self) -> Vec<Concern> {
        let mut concerns: Vec<Concern> = Vec::new();
        match &self.train {
            None => concerns.extend(self.axle.concerns("")),
            Some(train) => {
                concerns.extend(self.axle.concerns(" under the heaviest axle alone"));
                concerns.extend(train.concerns(" of this train"));
                concerns.extend(beside(&self.axle.peak, &train.peak));
            }
        }
        concerns.extend(self.too_fast_a_line());
        concerns.extend(static_deflection(self.axle.at_rest));
        if let Some(speed) = self.long_wake {
            concerns.push(Concern::new(
                "long-wake",
                format!("at {} the largest deflection lies at the end of the searched positions ({BEHIND} m behind, {AHEAD} m ahead of the train)", speed_text(speed)),
                "the ground is so lightly damped that its wake outlasts them: raise the loss factors, or read the values as lower bounds",
            ));
        }
        concerns.extend(missed_accuracy(&self.missed, "1e-5", (self.axle.speeds.len(), "speeds", "m/s")));
        concerns
    }
}

impl SpeedCurve {
    /// Why the amplification does not begin at 1, if it does not.
    fn towards_rest(&self) -> String {
        let slow = self.slow / self.at_rest;
        if (slow - 1.0).abs() < SLOW {
            return String::new();
        }
        format!(
            " Towards speed 0 it tends to {slow:.3}, not to 1: hysteretic damping acts however slowly a load moves. Ground and track \
             recover late behind each axle, in proportion to their loss factors, and the axles of a long train add up; the static limit \
             has none of this."
        )
    }

    /// What the curve may be doubted for; `whose` follows "the largest deflection".
    fn concerns(&self, whose: &str) -> Vec<Concern> {
        let mut concerns = Vec::new();
        if self.peak.at_end {
            concerns.push(Concern::new(
                "maximum-at-end",
                format!(
                    "the largest deflection{whose} is at {}, the end of the range",
                    speed_text(self.peak.speed)
                ),
                "widen critical_speed.speeds until the curve falls on both sides",
            ));
        }
        let humps = self.humps();
        if let Some(first) = humps.first() {
            let all: Vec<String> =
                humps.iter().map(|h| format!("{} ({:.0} %)", speed_text(h.speed), 100.0 * h.share)).collect();
            concerns.push(Concern::new(
                "other-maxima",
                format!(
                    "the deflection{whose} has other maxima within 10 % of its largest, near {}; the lowest of all is at {}",
                    all.join(", "),
                    speed_text(first.speed.min(self.peak.speed))
                ),
                "plan with the lowest; finer critical_speed.speeds place them better",
            ));
        }
        if let Some(plateau) = self.plateau() {
            concerns.push(Concern::new(
                "plateau",
                format!(
                    "the deflection{whose} is within 2 % of its largest from {} to {}: a plateau rather than a peak",
                    speed_text(plateau.from),
                    speed_text(plateau.to)
                ),
                "plan with its lower end",
            ));
        }
        concerns
    }
}

/// A concern where the train moves the rail most far above the critical speed of ground and track, or below it.
fn beside(axle: &Peak, train: &Peak) -> Option<Concern> {
    let ratio = train.speed / axle.speed - 1.0;
    let (code, side, remedy) = if ratio > ABOVE {
        (
            "train-above-critical",
            "above",
            "plan with the lower one: ground waves grow from there on under every train, and the other depends on number and spacing of \
             this train's axles",
        )
    } else if ratio < -BELOW {
        ("train-below-critical", "below", "plan with the lower one for this train")
    } else {
        return None;
    };
    Some(Concern::new(
        code,
        format!(
            "this train moves the rail most at {}, {:.0} % {side} the critical speed of ground and track, {}",
            speed_text(train.speed),
            100.0 * ratio.abs(),
            speed_text(axle.speed)
        ),
        remedy,
    ))
}
