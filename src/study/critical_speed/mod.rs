//! At which speed does the track move most? Under one axle, which is a matter of ground and track alone, and under the whole train.

mod curve;
mod extremes;
mod line_speed;
mod shown;

pub use curve::{Hump, Peak, Plateau, SpeedCurve};
pub use line_speed::{LineSpeed, Reached};

use super::{Outcome, StudyError};
use crate::progress::Observer;
use crate::rail::{ACCURACY, RailLoad};
use crate::railway::{Railway, RailwayError};
use extremes::{Extremes, reach};
use rayon::prelude::*;

/// So slow that only hysteresis tells moving from standing [m/s]: from 0.2 to 1 m/s deflections change by 2e-5.
const SLOW: f64 = 1.0;
/// Speeds in a row that learn from one another.
const BLOCK: usize = 10;

/// The speed curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CriticalSpeed {
    /// v [m/s], ascending.
    pub speeds: Vec<f64>,
    /// At which trains are to run [m/s].
    pub line_speed: Option<f64>,
    /// Wanted error of deflections relative to that under the load; [`ACCURACY`] where none is given.
    pub accuracy: Option<f64>,
}

/// What the track does at every speed.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedCurves {
    /// Under the heaviest axle alone: its peak is the critical speed of ground and track.
    pub axle: SpeedCurve,
    /// Under the whole train, where it has more axles than one: its peak depends on their number and spacing.
    pub train: Option<SpeedCurve>,
    /// At the speed of the line.
    pub line: Option<LineSpeed>,
    /// The first speed [m/s] at which an extreme lies at the end of the searched positions.
    pub long_wake: Option<f64>,
    /// Speeds [m/s] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
}

impl SpeedCurves {
    /// Of the train, which may be one axle.
    pub fn of_train(&self) -> &SpeedCurve {
        self.train.as_ref().unwrap_or(&self.axle)
    }
}

impl CriticalSpeed {
    /// Largest downward and upward rail deflection over all positions at every speed, their maximum refined to 0.1 m/s.
    ///
    /// Accuracy: 0.1 % of `reference/critical_speed.json` (test `cross_solver::critical_speed`); on stiff springs, whose
    /// shapes are sharp for positions 0.1 m apart, 2e-4 downward and 7e-4 upward (test `papers::closed_forms`).
    ///
    /// # Errors
    /// No track, no train, undamped waves.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<SpeedCurves, StudyError> {
        let track = railway.track()?.to_accuracy(self.accuracy.unwrap_or(ACCURACY));
        let train = railway.train()?;
        let axle = train.heaviest_axle();
        let loads = if train.axles().len() > 1 { vec![&axle, train] } else { vec![&axle] };
        observer.begin("critical speed", self.speeds.len() as u64 + 3 + u64::from(self.line_speed.is_some()));
        type Row = (Vec<Extremes>, f64);
        // begun with what the speed before it has learnt
        let at = |speed: f64, before: &mut Option<RailLoad>| -> Result<Row, StudyError> {
            let response = track.rail_near(speed, reach(train), before.as_ref())?;
            observer.done()?;
            let extremes = loads.iter().map(|load| Extremes::under(load, &response)).collect();
            let worst = response.worst;
            *before = Some(response);
            Ok((extremes, worst))
        };
        // blocks of the same speeds on any number of threads
        let blocks = self.speeds.par_chunks(BLOCK).map(|block| {
            let mut before = None;
            block.iter().map(|speed| at(*speed, &mut before)).collect::<Result<Vec<Row>, _>>()
        });
        let rows: Vec<Row> = blocks.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect();
        let (rest, slow) = (at(0.0, &mut None)?.0, at(SLOW, &mut None)?.0);
        let line = self.line_speed.map(|speed| {
            let extremes = at(speed, &mut None)?.0;
            Ok::<_, StudyError>(LineSpeed {
                speed,
                axle: extremes[0].down,
                train: extremes.get(1).map(|e| e.down),
            })
        });
        let line = line.transpose()?;
        let mut curves = (0..loads.len())
            .into_par_iter()
            .map(|i| {
                let extremes: Vec<Extremes> = rows.iter().map(|row| row.0[i]).collect();
                let mut before = None;
                let down = |speed: f64| -> Result<f64, StudyError> {
                    let response = track.rail_near(speed, reach(loads[i]), before.as_ref())?;
                    let down = Extremes::under(loads[i], &response).down;
                    before = Some(response);
                    Ok(down)
                };
                SpeedCurve::new(&self.speeds, &extremes, (rest[i].down, slow[i].down), down)
            })
            .collect::<Result<Vec<_>, _>>()?
            .into_iter();
        observer.end();
        let Some(axle) = curves.next() else {
            return Err(RailwayError::NoTrain.into());
        };
        let rows = || self.speeds.iter().copied().zip(&rows);
        let long_wake = rows().find(|(_, row)| row.0.last().is_some_and(|e| e.at_edge)).map(|(v, _)| v);
        let missed = rows().map(|(v, row)| (v, row.1)).filter(|(_, worst)| *worst > 1.0).collect();
        Ok(SpeedCurves { axle, train: curves.next(), line, long_wake, missed })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown())
    }
}
