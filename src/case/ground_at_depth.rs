//! `[ground_at_depth]` → the study, with every fault at its key.

use super::checks::{ascending, distinct, span};
use super::error::Finding;
use super::ranges::{MOST, NOT_NEGATIVE, numbers, speeds};
use super::schema::GroundAtDepthInput;
use crate::quantity::positive;
use crate::study::{GroundAtDepth, SHALLOWEST};

/// Deepest point a case may ask for [m].
const DEEPEST: f64 = 200.0;
/// Most values of one component at one speed.
const MOST_VALUES: usize = 2_000_000;

pub fn ground_at_depth(input: &GroundAtDepthInput) -> Result<GroundAtDepth, Finding> {
    let key = |name: &str| format!("ground_at_depth.{name}");
    let speeds = input.speeds.as_ref().map_or(Ok(Vec::new()), |range| speeds(range, &key("speeds")))?;
    distinct(&speeds, &key("speeds"), "m/s")?;
    let depths = numbers(&input.z, &key("z"), "m", NOT_NEGATIVE)?;
    ascending(&depths, &key("z"))?;
    if let Some(z) = depths.iter().find(|z| **z < SHALLOWEST || **z > DEEPEST) {
        let message = format!("{z} m: depths must lie between {SHALLOWEST} and {DEEPEST} m");
        return Err(Finding::new(key("z"), message).help("the surface itself is that of [contour]"));
    }
    let y = input
        .y
        .as_ref()
        .map_or(Ok(vec![0.0]), |y| numbers(y, &key("y"), "m", (|v| v.abs() <= 500.0, "within 500 m")))?;
    let x = input.x.map(|x| span(x, &key("x"))).transpose()?;
    let above_zero = |value: Option<f64>, name: &'static str, unit| {
        value
            .map(|value| positive(name, value, unit).map_err(|e| Finding::out_of_range("ground_at_depth", e)))
            .transpose()
    };
    let spacing = above_zero(input.spacing, "spacing", "m")?;
    let threshold = above_zero(input.threshold_strain, "threshold_strain", "1")?;
    if let Some(threshold) = threshold.filter(|t| *t > 0.1) {
        let message = format!("threshold_strain is {threshold}: it must not lie above 0.1");
        return Err(Finding::new(key("threshold_strain"), message).help("a strain of 0.01 % is 1e-4"));
    }
    let columns = x.map_or(1.0, |(from, to)| (to - from) / spacing.unwrap_or(0.25));
    if columns > MOST as f64 || columns * (depths.len() * y.len()) as f64 > MOST_VALUES as f64 {
        let message = format!(
            "{columns:.0} positions along the track × {} across × {} depths: more than {MOST_VALUES} values",
            y.len(),
            depths.len()
        );
        return Err(Finding::new("ground_at_depth", message).help("use a larger spacing, or fewer y and z"));
    }
    Ok(GroundAtDepth { speeds, depths, y, x, spacing, threshold })
}
