//! At which speed does the track move most? For the whole train and for its heaviest axle alone.

use super::{Answer, Model, Outcome, StudyError, speed_text};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, SecondAxis, Series, Stroke};
use crate::math::interpolation::cubic_weights;
use crate::math::maximum::golden_section;
use crate::progress::Observer;
use crate::rail::{MovingLoad, TrackOnFoundation};
use crate::vehicle::Train;
use ndarray::Array1;
use rayon::prelude::*;

/// Positions searched ahead of the leading axle and behind the last one [m].
const AHEAD: f64 = 30.0;
const BEHIND: f64 = 60.0;
/// Spacing of the searched positions [m]; the extremes are refined by a parabola.
const STEP: f64 = 0.1;
/// Width of the bracket at which the search for the maximum stops [m/s].
const SPEED_WIDTH: f64 = 0.1;

/// The speed curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// v [m/s], ascending.
    pub speeds: Vec<f64>,
}

/// Largest rail deflections over all positions at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Extremes {
    /// Positive down [m].
    down: f64,
    /// Positive up [m].
    up: f64,
    /// True if an extreme lies at the end of the searched positions.
    at_edge: bool,
}

/// Rail deflection under `train` from the response to a unit load, on x′ from −(length + BEHIND) to AHEAD, and where it starts.
fn superpose(response: &MovingLoad, train: &Train) -> (f64, Vec<f64>) {
    let length = train.length();
    let from = -(length + BEHIND);
    let count = ((AHEAD - from) / STEP).round() as usize + 1;
    if train.axles().len() == 1 {
        let rail = response.rail_shape(from, STEP, count);
        return (from, rail.iter().map(|u| u * train.axles()[0].load).collect());
    }
    // w(x′) = Σ P_j w₁(x′ + a_j): the unit response is wanted up to AHEAD + length, two more for the interpolation
    let extra = (length / STEP).ceil() as usize + 3;
    let unit = response.rail_shape(from - STEP, STEP, count + extra);
    let lead = train.axles()[0].position;
    let mut sum = vec![0.0; count];
    for axle in train.axles() {
        let offset = (axle.position - lead) / STEP;
        let whole = (offset + 1e-9).floor();
        let t = (offset - whole).max(0.0);
        // exact where axles stand on multiples of the spacing
        let weights = cubic_weights(t);
        let start = whole as usize;
        for (i, slot) in sum.iter_mut().enumerate() {
            let near = &unit[i + start..i + start + 4];
            *slot += axle.load * (0..4).map(|j| weights[j] * near[j]).sum::<f64>();
        }
    }
    (from, sum)
}

/// The largest value, refined by the parabola through it and its neighbours, its index, and its second difference.
fn largest(values: impl Iterator<Item = f64>) -> (f64, usize, f64) {
    let values: Vec<f64> = values.collect();
    let last = values.len() - 1;
    let top = (0..=last).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    if top == 0 || top == last {
        return (values[top], top, 0.0);
    }
    let (a, b, c) = (values[top - 1], values[top], values[top + 1]);
    let curvature = a - 2.0 * b + c;
    (if curvature < 0.0 { b - (c - a).powi(2) / (8.0 * curvature) } else { b }, top, curvature)
}

/// Curvature over one step, relative to the value, above which the parabola may err by more than 1e-5.
const SHARP: f64 = 0.002;

/// The largest of sign × deflection and whether it lies at an end; sharp peaks are searched again eight times finer.
fn extreme(response: &MovingLoad, train: &Train, from: f64, rail: &[f64], sign: f64) -> (f64, bool) {
    let (value, at, curvature) = largest(rail.iter().map(|w| sign * w));
    let at_edge = at == 0 || at + 1 == rail.len();
    if at_edge || curvature.abs() < SHARP * value.abs() {
        return (value, at_edge);
    }
    const FINE: f64 = STEP / 8.0;
    let lead = train.axles()[0].position;
    let start = from + STEP * (at as f64 - 1.0);
    let mut fine = vec![0.0; 17];
    for axle in train.axles() {
        let shape = response.rail_shape(start + axle.position - lead, FINE, fine.len());
        fine.iter_mut().zip(shape).for_each(|(sum, w)| *sum += sign * axle.load * w);
    }
    (largest(fine.into_iter()).0, false)
}

fn extremes(response: &MovingLoad, train: &Train) -> Extremes {
    let (from, rail) = superpose(response, train);
    let (down, down_edge) = extreme(response, train, from, &rail, 1.0);
    let (up, up_edge) = extreme(response, train, from, &rail, -1.0);
    // far away nothing moves: where the rail sinks all over the searched positions it rises by nothing
    Extremes { down, up: up.max(0.0), at_edge: down_edge || (up_edge && up > 0.01 * down) }
}

fn reach(train: &Train) -> f64 {
    train.length() + BEHIND.max(AHEAD) + 1.0
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
}

/// The maximum of a curve, bracketed by its grid and refined.
struct Peak {
    speed: f64,
    down: f64,
    /// At the first or last speed.
    at_end: bool,
}

fn refine(
    track: &TrackOnFoundation,
    train: &Train,
    speeds: &[f64],
    curve: &[Extremes],
) -> Result<Peak, StudyError> {
    let last = speeds.len() - 1;
    let top = (0..=last).max_by(|&a, &b| curve[a].down.total_cmp(&curve[b].down)).unwrap_or(0);
    let grid = Peak { speed: speeds[top], down: curve[top].down, at_end: top == 0 || top == last };
    if grid.at_end {
        return Ok(grid);
    }
    let down = |speed: f64| -> Result<f64, StudyError> {
        Ok(extremes(&track.moving(speed, reach(train))?, train).down)
    };
    let (speed, value) = golden_section(down, speeds[top - 1], speeds[top + 1], SPEED_WIDTH)?;
    // the grid point itself may be the best
    Ok(if value >= grid.down { Peak { speed, down: value, at_end: false } } else { grid })
}

impl CriticalSpeed {
    /// Largest downward and upward rail deflection over all positions at every speed, their maximum refined to 0.1 m/s,
    /// and amplification against the exact static limit ω = 0.
    ///
    /// Accuracy: 0.1 % of `reference/critical_speed.json` (test `cross_solver::critical_speed`); on stiff springs, whose
    /// shapes are sharp for positions 0.1 m apart, 2e-4 downward and 7e-4 upward (test `papers::closed_forms`).
    ///
    /// # Errors
    /// No track, no train, undamped waves.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let track = model.track()?;
        let train = model.train("critical_speed")?;
        let alone = train.heaviest_axle();
        let whole_train = train.axles().len() > 1;
        observer.begin("critical speed", self.speeds.len() as u64 + 2);
        let curve: Vec<(Extremes, Extremes, bool)> = self
            .speeds
            .par_iter()
            .map(|&speed| -> Result<_, StudyError> {
                let response = track.moving(speed, reach(train))?;
                let of_train = extremes(&response, train);
                let single = if whole_train { extremes(&response, &alone) } else { of_train };
                observer.advance();
                Ok((of_train, single, response.converged))
            })
            .collect::<Result<_, _>>()?;
        let trains: Vec<Extremes> = curve.iter().map(|c| c.0).collect();
        let singles: Vec<Extremes> = curve.iter().map(|c| c.1).collect();
        let at_rest = track.moving(0.0, reach(train))?;
        let (rest, rest_single) = (extremes(&at_rest, train).down, extremes(&at_rest, &alone).down);
        observer.advance();
        let (peak, peak_single) = rayon::join(
            || refine(&track, train, &self.speeds, &trains),
            || if whole_train { refine(&track, &alone, &self.speeds, &singles).map(Some) } else { Ok(None) },
        );
        let (peak, peak_single) = (peak?, peak_single?);
        observer.end();

        let column =
            |f: &dyn Fn(&Extremes) -> f64, of: &[Extremes]| -> Vec<f64> { of.iter().map(f).collect() };
        let down = column(&|e| e.down, &trains);
        let up = column(&|e| e.up, &trains);
        let amplification: Vec<f64> = down.iter().map(|d| d / rest).collect();
        let array = |v: &[f64]| Array1::from(v.to_vec()).into_dyn();
        let mut group = Group::new("critical_speed")
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .variable(
                "max_down",
                &["speed"],
                array(&down),
                "m",
                "largest downward rail deflection over all positions",
            )
            .variable(
                "max_up",
                &["speed"],
                array(&up),
                "m",
                "largest upward rail deflection over all positions, positive upward",
            )
            .variable(
                "amplification",
                &["speed"],
                array(&amplification),
                "1",
                "max_down over its static limit",
            )
            .attribute("critical_speed", peak.speed)
            .attribute("max_down", peak.down)
            .attribute("reference_deflection", rest)
            .attribute("amplification", peak.down / rest);
        let mut answers = vec![
            Answer::new("critical_speed", "Critical speed", peak.speed, "m/s", peak.text()),
            Answer::new(
                "max_down",
                "Largest downward rail deflection, at the critical speed",
                peak.down,
                "m",
                format!("{:.3} mm", 1e3 * peak.down),
            ),
            Answer::new(
                "reference_deflection",
                "Static rail deflection (speed 0)",
                rest,
                "m",
                format!("{:.3} mm", 1e3 * rest),
            ),
            Answer::new(
                "amplification",
                "Dynamic amplification at the critical speed",
                peak.down / rest,
                "1",
                format!("{:.2}", peak.down / rest),
            ),
        ];
        let mut concerns = Vec::new();
        let millimetres = |v: &[f64]| v.iter().map(|x| 1e3 * x).collect::<Vec<_>>();
        let name = if whole_train { "train, " } else { "" };
        let curve_of = |name: String, y: Vec<f64>, stroke| Series { name, x: self.speeds.clone(), y, stroke };
        let mut series = vec![
            curve_of(format!("{name}largest downward"), millimetres(&down), Stroke::Solid),
            curve_of(format!("{name}largest upward"), millimetres(&up), Stroke::Dashed),
        ];
        let mut amplifications = vec![curve_of(
            if whole_train { "train".into() } else { "single axle".into() },
            amplification,
            Stroke::Solid,
        )];
        let mut marks = vec![(peak.speed, format!("critical speed {:.1} m/s", peak.speed))];
        if let Some(single) = &peak_single {
            let (single_down, single_up) = (column(&|e| e.down, &singles), column(&|e| e.up, &singles));
            group = group
                .variable(
                    "single_axle_max_down",
                    &["speed"],
                    array(&single_down),
                    "m",
                    "largest downward rail deflection under the heaviest axle alone",
                )
                .variable(
                    "single_axle_max_up",
                    &["speed"],
                    array(&single_up),
                    "m",
                    "largest upward rail deflection under the heaviest axle alone, positive upward",
                )
                .attribute("single_axle_critical_speed", single.speed)
                .attribute("single_axle_max_down", single.down)
                .attribute("single_axle_reference_deflection", rest_single);
            answers.push(Answer::new(
                "single_axle_critical_speed",
                "Critical speed of the heaviest axle alone",
                single.speed,
                "m/s",
                single.text(),
            ));
            answers.push(Answer::new(
                "single_axle_max_down",
                "Its largest downward rail deflection",
                single.down,
                "m",
                format!("{:.3} mm", 1e3 * single.down),
            ));
            answers.push(Answer::new(
                "single_axle_reference_deflection",
                "Its static rail deflection",
                rest_single,
                "m",
                format!("{:.3} mm", 1e3 * rest_single),
            ));
            series.push(curve_of(
                "heaviest axle alone, largest downward".into(),
                millimetres(&single_down),
                Stroke::Solid,
            ));
            amplifications.push(curve_of(
                "heaviest axle alone".into(),
                single_down.iter().map(|d| d / rest_single).collect(),
                Stroke::Solid,
            ));
            marks.push((single.speed, format!("one axle {:.1} m/s", single.speed)));
            if single.at_end {
                concerns.push(end_of_range("of the heaviest axle alone ", single.speed));
            }
        }
        if peak.at_end {
            concerns.push(end_of_range("", peak.speed));
        }
        if let Some(i) = trains.iter().position(|e| e.at_edge) {
            concerns.push(Concern::new(
                "long-wake",
                format!("at {} the largest deflection lies at the end of the searched positions ({BEHIND} m behind, {AHEAD} m ahead of the train)", speed_text(self.speeds[i])),
                "the ground is so lightly damped that its wake outlasts them: raise the loss factors, or read the values as lower bounds",
            ));
        }
        concerns
            .extend(missed_accuracy(self.speeds.iter().zip(&curve).filter(|(_, c)| !c.2).map(|(v, _)| *v)));
        let axis = Some(SecondAxis { label: "speed [km/h]".into(), factor: 3.6 });
        let figure = |name: &str, title: &str, y_label: &str, series, marks| {
            Figure::Lines(LineFigure {
                name: name.into(),
                title: title.into(),
                x_label: "speed [m/s]".into(),
                y_label: y_label.into(),
                second_x: axis.clone(),
                y_down: false,
                log_x: false,
                log_y: false,
                series,
                marks,
            })
        };
        Ok(Outcome {
            group,
            figures: vec![
                (
                    figure(
                        "critical_speed",
                        "Rail deflection against speed",
                        "rail deflection [mm]",
                        series,
                        marks.clone(),
                    ),
                    "Largest downward and upward deflection of the rail over all positions, for each speed."
                        .into(),
                ),
                (
                    figure(
                        "amplification",
                        "Dynamic amplification against speed",
                        "largest downward deflection / static [-]",
                        amplifications,
                        marks,
                    ),
                    "Largest downward deflection relative to the exact static limit.".into(),
                ),
            ],
            answers,
            concerns,
        })
    }
}

fn end_of_range(whose: &str, speed: f64) -> Concern {
    Concern::new(
        "maximum-at-end",
        format!("the largest deflection {whose}is at {}, the end of the range", speed_text(speed)),
        "widen critical_speed.speeds until the curve falls on both sides",
    )
}

/// One concern for all `speeds` at which a quadrature missed its tolerance.
pub(super) fn missed_accuracy(speeds: impl Iterator<Item = f64>) -> Option<Concern> {
    let speeds: Vec<String> = speeds.map(|v| format!("{v:.1}")).collect();
    (!speeds.is_empty()).then(|| {
        Concern::new(
            "quadrature",
            format!("the wavenumber integrals missed their accuracy (1e-5) at {} m/s", speeds.join(", ")),
            "poles lie too close to the real axis (more damping helps), or the track spreads the load too little, or a layer is very thin",
        )
    })
}
