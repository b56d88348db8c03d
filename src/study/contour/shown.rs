//! What a reader sees of the ground around the train: arrays, maps, largest values, concerns.

use super::{GroundMaps, TOLERABLE};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::{Field, Quantity};
use crate::figure::{Figure, MapFigure};
use crate::railway::Railway;
use crate::study::doubts::{missed_accuracy, outruns_waves, sinks_as_no_track_does};
use crate::study::{Answer, Outcome, speed_text, tag};
use ndarray::{Array1, Array2, Array3, Axis, Slice};

/// Values along a side of a picture: twice its pixels.
const DRAWN: usize = 1500;

/// Words for a quantity.
struct Words {
    /// Unit of the array, and of an answer.
    unit: &'static str,
    answer: &'static str,
    /// Unit of a thousandth, as shown.
    shown: &'static str,
    /// Of the colour bar, in a thousandth of the unit.
    label: &'static str,
    long: &'static str,
}

fn words(quantity: Quantity) -> Words {
    let displacement = |label, long| Words { unit: "m", answer: "m", shown: "mm", label, long };
    match quantity {
        Quantity::Vertical => {
            displacement("u_z [mm], positive down", "vertical ground displacement, positive down")
        }
        Quantity::VerticalVelocity => Words {
            unit: "m s-1",
            answer: "m/s",
            shown: "mm/s",
            label: "v_z [mm/s], positive down",
            long: "vertical ground velocity, positive down",
        },
        Quantity::Along => displacement(
            "u_x [mm]",
            "ground displacement along the track, positive in the direction of travel",
        ),
        Quantity::Across => {
            displacement("u_y [mm]", "ground displacement across the track, positive towards +y")
        }
    }
}

impl GroundMaps {
    /// Everything a run leaves.
    pub(super) fn shown(self, railway: &Railway) -> Outcome {
        let mut outcome = Outcome::default();
        for (i, &quantity) in self.quantities.iter().enumerate() {
            let of_all = self.fields.iter().flat_map(|field| field.values[i].iter());
            let most = 1e3 * of_all.fold(0.0f64, |m, v| m.max(v.abs()));
            for (field, &speed) in self.fields.iter().zip(&self.speeds) {
                outcome.figures.push(self.map(quantity, &field.values[i], speed, most));
                outcome.answers.push(largest(quantity, &field.values[i], speed));
            }
        }
        outcome.concerns = self.concerns(railway);
        outcome.group = self.group();
        outcome
    }

    /// The arrays, which are large: they are moved, one field after another.
    fn group(mut self) -> Group {
        let ahead = "position relative to the leading axle, positive ahead (moving frame)";
        let mut group = Group::new("contour")
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .coordinate("y", &self.y, "m", "position across the track, from its centre line")
            .coordinate("x", &self.x, "m", ahead);
        for (i, &quantity) in self.quantities.iter().enumerate() {
            let mut fields =
                self.fields.iter_mut().map(|field| std::mem::take(&mut field.values[i]).insert_axis(Axis(0)));
            let mut all = fields.next().unwrap_or_else(|| Array3::zeros((0, self.y.len(), self.x.len())));
            for field in fields {
                // never fails: all of them are over the same x and y
                let _ = all.append(Axis(0), field.view());
            }
            let Words { unit, long, .. } = words(quantity);
            group = group.variable(quantity.name(), &["speed", "y", "x"], all.into_dyn(), unit, long);
        }
        let number = |group: Group, name: &str, f: fn(&Field) -> f64, unit: &str, what: &str| {
            let values = self.fields.iter().map(f).collect::<Array1<f64>>().into_dyn();
            group.variable(name, &["speed"], values, unit, what)
        };
        let rest = "remainder at the border of the period over the largest value";
        let beyond = "estimate of the part beyond the largest wavenumber over the largest value";
        let group = number(group, "wrap_around", |f| f.wrap_around, "1", rest);
        let group = number(group, "aliasing", |f| f.aliasing, "1", beyond);
        let group = number(group, "period_x", |f| f.period.0, "m", "period of the transform along the track");
        number(group, "period_y", |f| f.period.1, "m", "period of the transform across the track")
    }

    fn map(&self, quantity: Quantity, values: &Array2<f64>, speed: f64, largest: f64) -> (Figure, String) {
        let at = speed_text(speed);
        let Words { label, long, .. } = words(quantity);
        let every = |step: usize| Slice::new(0, None, step as isize);
        let steps = (values.nrows().div_ceil(DRAWN), values.ncols().div_ceil(DRAWN));
        let mut values = values.view();
        values.slice_axis_inplace(Axis(0), every(steps.0));
        values.slice_axis_inplace(Axis(1), every(steps.1));
        let map = MapFigure {
            name: format!("contour_{}_{}", quantity.name(), tag(speed)),
            title: format!("Ground surface at {at}"),
            x_label: "x′ [m], travel to the right".into(),
            y_label: "y [m]".into(),
            value_label: label.into(),
            x: self.x.iter().step_by(steps.1).copied().collect(),
            y: self.y.iter().step_by(steps.0).copied().collect(),
            values: values.mapv(|v| 1e3 * v),
            // maps of the same quantity at several speeds have the same colours
            holds: Some((-largest, largest)),
            symmetric: true,
            equal_axes: true,
            overlay: Vec::new(),
        };
        (Figure::Map(map), format!("At {at}, seen from the leading axle: {long}."))
    }

    fn concerns(&self, railway: &Railway) -> Vec<Concern> {
        let mut concerns = Vec::new();
        for (field, &speed) in self.fields.iter().zip(&self.speeds) {
            let at = speed_text(speed);
            if field.wrap_around > TOLERABLE {
                concerns.push(Concern::new(
                    "wrap-around",
                    format!("at {at} {:.2} % of the largest value is left at the border of the {:.0} m × {:.0} m period", 100.0 * field.wrap_around, field.period.0, field.period.1),
                    "set contour.clearance to a larger distance [m]",
                ));
            }
            if field.aliasing > TOLERABLE {
                concerns.push(Concern::new(
                    "aliasing",
                    format!(
                        "at {at} about {:.2} % of the largest value lies beyond the largest wavenumber",
                        100.0 * field.aliasing
                    ),
                    "use a contour.spacing below a tenth of the contact half-width, or half of the present one",
                ));
            }
        }
        concerns.extend(missed_accuracy(&self.missed, "1e-5", (self.speeds.len(), "speeds", "m/s")));
        concerns.extend(sinks_as_no_track_does(railway));
        concerns.extend(self.speeds.iter().filter_map(|v| outruns_waves(railway, *v)));
        concerns
    }
}

fn largest(quantity: Quantity, values: &Array2<f64>, speed: f64) -> Answer {
    let Words { answer, shown, long, .. } = words(quantity);
    let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let what = long.split(',').next().unwrap_or(long);
    Answer::new(
        &format!("max_{}_{}", quantity.name(), tag(speed)),
        format!("Largest {what} in the window at {}", speed_text(speed)),
        largest,
        answer,
        format!("{:.3} {shown}", 1e3 * largest),
    )
}
