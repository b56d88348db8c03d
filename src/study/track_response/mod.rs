//! What shape have the rail and the ground under the track at given speeds?

mod over_supports;
mod over_supports_shown;
mod shown;

pub use over_supports::OverSupports;

use super::{Beside, Outcome, StudyError, Verified};
use crate::math::decimal::arithmetic;
use crate::progress::Observer;
use crate::rail::{Drive, Method};
use crate::railway::Railway;
use crate::track::Layout;
use ndarray::Array2;

/// A measured or published record to be drawn beside the computed one.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Speed it belongs to [m/s].
    pub speed: f64,
    /// Legend entry.
    pub label: String,
    /// x′ [m], positive ahead of the leading axle.
    pub x: Vec<f64>,
    /// Deflection [m], positive down.
    pub deflection: Vec<f64>,
}

/// Rail and base displacement along x′; over supports, of the rail at places of the bay while the train passes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrackResponse {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// At which trains are to run [m/s]: one of the speeds.
    pub line_speed: Option<f64>,
    /// x′ from, to [m]; by default 40 m behind the last axle to 20 m ahead of the leading one.
    pub x: Option<(f64, f64)>,
    /// Spacing [m]; 0.1 m by default, 0.02 m over supports.
    pub spacing: Option<f64>,
    /// Records to compare with.
    pub records: Vec<Record>,
    /// Over supports: where the rail is watched [m] from a support; over it and in the middle of the bay by default.
    pub at: Vec<f64>,
    /// Over supports: f̃ [Hz] with which all axle loads oscillate; None where they are constant.
    pub harmonic: Option<f64>,
    /// Over supports: f [Hz] of spectra; may be empty.
    pub frequencies: Vec<f64>,
    /// Spectra [m s] to compare with.
    pub beside: Vec<Beside>,
    /// How the rail is asked: adaptive, over supports by the comb of images; None for whichever it is.
    pub method: Option<Method>,
    /// Another method, to be compared.
    pub verify: Option<Method>,
}

/// Spacing of a shape [m].
const SPACING: f64 = 0.1;

/// Shapes of rail and base under the whole train, positive down.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackShapes {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// x′ [m], positive ahead of the leading axle.
    pub x: Vec<f64>,
    /// Of the rail [m], speeds × x.
    pub rail: Array2<f64>,
    /// Of the ground under the track [m], speeds × x.
    pub base: Array2<f64>,
    /// Speeds [m/s] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
    /// Speed of the line [m/s], and the largest downward rail deflection [m] of the train at rest.
    pub line: Option<(f64, f64)>,
    /// What another method says.
    pub verified: Option<Verified>,
}

impl TrackShapes {
    /// Largest downward and upward rail deflection [m] at the speed in `row`, both positive or zero.
    pub fn extremes(&self, row: usize) -> (f64, f64) {
        let extreme = |sign: f64| self.rail.row(row).iter().fold(f64::NEG_INFINITY, |m, w| m.max(sign * w));
        // far away nothing moves: a rail that sinks all over the window rises by nothing
        (extreme(1.0), extreme(-1.0).max(0.0))
    }
}

impl TrackResponse {
    /// w(x′) = Σ P_j w₁(x′ + a_j) of rail and base under the whole train, positive down.
    ///
    /// Accuracy: 1e-5 of the deflection under the load (test `analytic::beam`).
    ///
    /// # Errors
    /// No track, no train, undamped waves.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<TrackShapes, StudyError> {
        let track = railway.track()?;
        let train = railway.train()?;
        let lead = train.axles()[0].position;
        let (from, to) = self.x.unwrap_or((-(train.length() + 40.0), 20.0));
        let spacing = self.spacing.unwrap_or(SPACING);
        let count = ((to - from) / spacing + 1e-9).floor() as usize + 1;
        let mut shapes = TrackShapes {
            speeds: self.speeds.clone(),
            x: arithmetic(from, spacing, count),
            rail: Array2::zeros((self.speeds.len(), count)),
            base: Array2::zeros((self.speeds.len(), count)),
            missed: Vec::new(),
            line: None,
            verified: None,
        };
        observer.begin("track response", self.speeds.len() as u64);
        for (row, &speed) in self.speeds.iter().enumerate() {
            let response = track.moving(speed, from.abs().max(to.abs()) + train.length())?;
            for axle in train.axles() {
                let shape = response.shape(from + axle.position - lead, spacing, count);
                for i in 0..count {
                    shapes.rail[(row, i)] += axle.load * shape.rail[i];
                    shapes.base[(row, i)] += axle.load * shape.base[i];
                }
            }
            if !response.converged() {
                shapes.missed.push((speed, response.worst));
            }
            observer.done()?;
        }
        if let Some(line) = self.line_speed {
            let at_rest = track.moving(0.0, train.length() + 1.0)?;
            let under = |x: f64| -> f64 {
                train.axles().iter().map(|axle| axle.load * at_rest.rail(x + axle.position - lead)).sum()
            };
            let steps = (train.length() / SPACING).ceil() as usize;
            let down = (0..=steps).map(|i| under(-SPACING * i as f64)).fold(0.0, f64::max);
            shapes.line = Some((line, down));
        }
        observer.end();
        shapes.verified = self.verify.map(|method| Verified::new(method, verified(&shapes, railway, method)));
        Ok(shapes)
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        if matches!(railway.layout(), Layout::Discrete(_)) {
            return Ok(self.over_supports(railway, observer)?.shown(&self.beside));
        }
        Ok(self.solve(railway, observer)?.shown(&self.records, railway))
    }
}

/// The rail of `shapes` by another `method`.
fn verified(shapes: &TrackShapes, railway: &Railway, method: Method) -> Result<f64, StudyError> {
    let (moving, train) = (railway.moving(method)?, railway.train()?);
    let lead = train.axles()[0].position;
    let (mut largest, mut gap) = (0.0f64, 0.0f64);
    for (row, speed) in shapes.speeds.iter().enumerate() {
        let mut rail = vec![0.0; shapes.x.len()];
        for axle in train.axles() {
            let x: Vec<f64> = shapes.x.iter().map(|x| x + axle.position - lead).collect();
            let answers = moving.under(Drive { omega: 0.0, speed: *speed }, 0.0, &x)?;
            rail.iter_mut().zip(answers).for_each(|(sum, a)| *sum += axle.load * a.value.re);
        }
        for (one, other) in shapes.rail.row(row).iter().zip(&rail) {
            (largest, gap) = (largest.max(one.abs()), gap.max((one - other).abs()));
        }
    }
    Ok(gap / largest)
}

/// True if a record at one speed belongs to the other: within 0.1 %.
pub fn same_speed(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
}

/// "68.5" for names of files and keys: at most two decimals, no trailing zeros.
pub fn tag(speed: f64) -> String {
    let text = format!("{speed:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
