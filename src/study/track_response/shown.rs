//! What a reader sees of the shapes of a track: arrays, answers, pictures with records beside them, concerns.

use super::{Record, TrackShapes, same_speed, tag};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::railway::Railway;
use crate::study::doubts::{missed_accuracy, outruns_waves, sinks_as_no_track_does};
use crate::study::{Answer, Outcome, Verified, speed_text};
use ndarray::Array1;

fn millimetres<'a>(values: impl IntoIterator<Item = &'a f64>) -> Vec<f64> {
    values.into_iter().map(|w| 1e3 * w).collect()
}

impl TrackShapes {
    /// Everything a run leaves.
    pub(super) fn shown(&self, records: &[Record], railway: &Railway) -> Outcome {
        let rows = 0..self.speeds.len();
        Outcome {
            group: self.group(records),
            figures: rows.clone().map(|row| self.figure(row, records)).collect(),
            answers: rows
                .flat_map(|row| self.answers(row))
                .chain(self.at_line_speed())
                .chain(self.verified.as_ref().and_then(Verified::answer))
                .collect(),
            concerns: self.concerns(railway),
        }
    }

    fn answers(&self, row: usize) -> [Answer; 2] {
        let (down, up) = self.extremes(row);
        let speed = self.speeds[row];
        let answer = |key: &str, way: &str, value: f64, shown: String| {
            let what = format!("Largest {way} rail deflection at {}", speed_text(speed));
            Answer::new(&format!("{key}_{}", tag(speed)), what, value, "m", shown)
        };
        let text = |value: f64| format!("{:.3} mm", 1e3 * value);
        [
            answer("max_down", "downward", down, text(down)),
            answer("max_up", "upward", up, if up > 0.0 { text(up) } else { "none".into() }),
        ]
    }

    /// The amplification at the speed of the line.
    fn at_line_speed(&self) -> Option<Answer> {
        let (line, at_rest) = self.line?;
        let row = self.speeds.iter().position(|v| tag(*v) == tag(line))?;
        let ratio = self.extremes(row).0 / at_rest;
        let what = format!("Dynamic amplification at the line speed, {}", speed_text(line));
        Some(Answer::new("line_speed_amplification", what, ratio, "1", format!("{ratio:.2}")))
    }

    fn figure(&self, row: usize, records: &[Record]) -> (Figure, String) {
        let speed = self.speeds[row];
        let at = speed_text(speed);
        let curve =
            |name: &str, y: Vec<f64>, stroke| Series { name: name.into(), x: self.x.clone(), y, stroke };
        let (rail, base) = (self.rail.row(row), self.base.row(row));
        let mut series = vec![curve("rail", millimetres(rail), Stroke::Solid)];
        // one beam on the ground moves as one
        if rail != base {
            series.push(curve("ground under the track", millimetres(base), Stroke::Dashed));
        }
        series.extend(records.iter().filter(|r| same_speed(r.speed, speed)).map(|record| Series {
            name: record.label.clone(),
            x: record.x.clone(),
            y: millimetres(&record.deflection),
            stroke: Stroke::Points,
        }));
        let all = self.rail.iter().chain(&self.base);
        let (low, high) = all.fold((0.0f64, 0.0f64), |(low, high), w| (low.min(*w), high.max(*w)));
        let picture = LineFigure {
            y_down: true,
            // shapes at several speeds are compared
            y_holds: Some((1e3 * low, 1e3 * high)),
            series,
            ..LineFigure::new(
                format!("track_response_{}", tag(speed)),
                format!("Track deflection at {at}"),
                "position x′ relative to the leading axle [m], travel to the right",
                "deflection [mm], positive down",
            )
        };
        let caption = format!("Rail and ground under the track at {at}, seen from the leading axle.");
        (Figure::Lines(picture), caption)
    }

    fn group(&self, records: &[Record]) -> Group {
        let dims = ["speed", "x"];
        let below = "displacement of the ground under the track, positive down";
        let mut group = Group::new("track_response")
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .coordinate("x", &self.x, "m", "position relative to the leading axle, positive ahead")
            .variable("rail", &dims, self.rail.clone().into_dyn(), "m", "rail displacement, positive down")
            .variable("base", &dims, self.base.clone().into_dyn(), "m", below);
        for (i, record) in records.iter().enumerate() {
            let name = format!("record_{}", i + 1);
            let x = format!("{name}_x");
            let deflection = Array1::from(record.deflection.clone()).into_dyn();
            group = group
                .coordinate(&x, &record.x, "m", "position of the record, relative to the leading axle")
                .variable(&name, &[&x], deflection, "m", &format!("{}, positive down", record.label))
                .attribute(&format!("{name}_speed"), record.speed);
        }
        group
    }

    fn concerns(&self, railway: &Railway) -> Vec<Concern> {
        let missed = missed_accuracy(&self.missed, "1e-5", (self.speeds.len(), "speeds", "m/s"));
        let fast = self.speeds.iter().filter_map(|v| outruns_waves(railway, *v));
        let disagree = self.verified.as_ref().and_then(Verified::concern);
        missed.into_iter().chain(sinks_as_no_track_does(railway)).chain(fast).chain(disagree).collect()
    }
}
