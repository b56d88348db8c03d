//! The largest rail deflections under a train, over all positions.

use crate::rail::{RailLoad, RailWaves};
use crate::vehicle::Train;

/// Positions searched ahead of the leading axle and behind the last one [m].
pub const AHEAD: f64 = 30.0;
pub const BEHIND: f64 = 60.0;
/// Spacing of the searched positions [m]; the extremes are refined by a parabola.
const STEP: f64 = 0.1;

/// Largest rail deflections over all positions at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Positive down [m].
    pub down: f64,
    /// Positive up [m].
    pub up: f64,
    /// True if an extreme lies at the end of the searched positions.
    pub at_edge: bool,
}

impl Extremes {
    /// Under `train`, from the response to a unit load.
    pub fn under(train: &Train, response: &RailLoad) -> Self {
        let lead = train.axles()[0].position;
        let rail =
            response.under(train.axles().iter().map(|axle| (axle.position - lead, axle.load)).collect());
        let from = -(train.length() + BEHIND);
        let shape = rail.shape(from, STEP, ((AHEAD - from) / STEP).round() as usize + 1);
        let (down, down_edge) = extreme(&rail, from, &shape, 1.0);
        let (up, up_edge) = extreme(&rail, from, &shape, -1.0);
        // far away nothing moves: where the rail sinks all over the searched positions it rises by nothing
        Self { down, up: up.max(0.0), at_edge: down_edge || (up_edge && up > 0.01 * down) }
    }
}

/// Distance [m] to which the response to a unit load is wanted for `train`.
pub fn reach(train: &Train) -> f64 {
    train.length() + BEHIND.max(AHEAD) + 1.0
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
fn extreme(rail: &RailWaves, from: f64, shape: &[f64], sign: f64) -> (f64, bool) {
    let (value, at, curvature) = largest(shape.iter().map(|w| sign * w));
    let at_edge = at == 0 || at + 1 == shape.len();
    if at_edge || curvature.abs() < SHARP * value.abs() {
        return (value, at_edge);
    }
    let fine = rail.shape(from + STEP * (at as f64 - 1.0), STEP / 8.0, 17);
    (largest(fine.iter().map(|w| sign * w)).0, false)
}
