//! What shape have the rail and the ground under the track at given speeds?

use super::doubts::{missed_accuracy, sinks_as_no_track_does};
use super::{Answer, Model, Outcome, StudyError, speed_text};
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::progress::Observer;
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

/// Rail and base displacement along x′.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackResponse {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// x′ from, to [m]; by default 40 m behind the last axle to 20 m ahead of the leading one.
    pub x: Option<(f64, f64)>,
    /// Spacing [m].
    pub spacing: f64,
    /// Records to compare with.
    pub records: Vec<Record>,
}

impl TrackResponse {
    /// Shapes of rail and base under the whole train, positive down.
    ///
    /// # Errors
    /// No track, no train, undamped waves.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let track = model.track()?;
        let train = model.train("track_response")?;
        let lead = train.axles()[0].position;
        let (from, to) = self.x.unwrap_or((-(train.length() + 40.0), 20.0));
        let count = ((to - from) / self.spacing + 1e-9).floor() as usize + 1;
        let x: Vec<f64> = (0..count).map(|i| from + self.spacing * i as f64).collect();
        let mut rail = Array2::zeros((self.speeds.len(), count));
        let mut base = Array2::zeros((self.speeds.len(), count));
        let mut missed = Vec::new();
        let mut answers = Vec::new();
        let mut figures = Vec::new();
        observer.begin("track response", self.speeds.len() as u64);
        for (row, &speed) in self.speeds.iter().enumerate() {
            let reach = from.abs().max(to.abs()) + train.length();
            let response = track.moving(speed, reach)?;
            for axle in train.axles() {
                let shape = response.shape(from + axle.position - lead, self.spacing, count);
                for i in 0..count {
                    rail[(row, i)] += axle.load * shape.rail[i];
                    base[(row, i)] += axle.load * shape.base[i];
                }
            }
            if !response.converged {
                missed.push(speed);
            }
            let extreme = |sign: f64| rail.row(row).iter().fold(f64::NEG_INFINITY, |m, w| m.max(sign * w));
            // far away nothing moves: a rail that sinks all over the window rises by nothing
            let (down, up) = (extreme(1.0), extreme(-1.0).max(0.0));
            let at = speed_text(speed);
            answers.push(Answer::new(
                &format!("max_down_{}", tag(speed)),
                format!("Largest downward rail deflection at {at}"),
                down,
                "m",
                format!("{:.3} mm", 1e3 * down),
            ));
            answers.push(Answer::new(
                &format!("max_up_{}", tag(speed)),
                format!("Largest upward rail deflection at {at}"),
                up,
                "m",
                if up > 0.0 { format!("{:.3} mm", 1e3 * up) } else { "none".into() },
            ));
            let millimetres = |values: Vec<f64>| values.iter().map(|w| 1e3 * w).collect::<Vec<_>>();
            let mut series = vec![Series {
                name: "rail".into(),
                x: x.clone(),
                y: millimetres(rail.row(row).to_vec()),
                stroke: Stroke::Solid,
            }];
            // one beam on the ground moves as one
            if rail.row(row) != base.row(row) {
                series.push(Series {
                    name: "ground under the track".into(),
                    x: x.clone(),
                    y: millimetres(base.row(row).to_vec()),
                    stroke: Stroke::Dashed,
                });
            }
            for record in self.records.iter().filter(|r| same_speed(r.speed, speed)) {
                series.push(Series {
                    name: record.label.clone(),
                    x: record.x.clone(),
                    y: millimetres(record.deflection.clone()),
                    stroke: Stroke::Points,
                });
            }
            figures.push((
                Figure::Lines(LineFigure {
                    name: format!("track_response_{}", tag(speed)),
                    title: format!("Track deflection at {at}"),
                    x_label: "position x′ relative to the leading axle [m], travel to the right".into(),
                    y_label: "deflection [mm], positive down".into(),
                    second_x: None,
                    y_down: true,
                    log_x: false,
                    log_y: false,
                    series,
                    marks: Vec::new(),
                }),
                format!("Rail and ground under the track at {at}, seen from the leading axle."),
            ));
            observer.advance();
        }
        observer.end();
        let mut group = Group::new("track_response")
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .coordinate("x", &x, "m", "position relative to the leading axle, positive ahead")
            .variable("rail", &["speed", "x"], rail.into_dyn(), "m", "rail displacement, positive down")
            .variable(
                "base",
                &["speed", "x"],
                base.into_dyn(),
                "m",
                "displacement of the ground under the track, positive down",
            );
        for (i, record) in self.records.iter().enumerate() {
            let name = format!("record_{}", i + 1);
            let x = format!("{name}_x");
            group = group
                .coordinate(&x, &record.x, "m", "position of the record, relative to the leading axle")
                .variable(
                    &name,
                    &[&x],
                    ndarray::Array1::from(record.deflection.clone()).into_dyn(),
                    "m",
                    &format!("{}, positive down", record.label),
                )
                .attribute(&format!("{name}_speed"), record.speed);
        }
        Ok(Outcome {
            group,
            figures,
            answers,
            concerns: missed_accuracy(missed.into_iter())
                .into_iter()
                .chain(sinks_as_no_track_does(model))
                .chain(self.speeds.iter().filter_map(|v| model.outruns_waves(*v)))
                .collect(),
        })
    }
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
