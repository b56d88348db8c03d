//! What a reader sees of a comparison: changes of answers, curves of both, insertion losses.

use super::{Against, CurveChange, InsertionLoss};
use crate::assessment::Band;
use crate::concern::Concern;
use crate::dataset::{Group, Variable};
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::free_field::metrics::significant;
use crate::study::free_field::pictures::band_ticks;
use crate::study::{Answer, Outcome};

/// Most curves of one case in one picture.
const MOST: usize = 6;

/// SI units that answers come in; others stand in their text alone.
const UNITS: [&str; 22] = [
    "1", "m", "m/s", "m/s²", "m/s^1.75", "m²/s", "m/N", "m/Pa", "N", "N/m", "N/m²", "Pa", "Hz", "s", "dB",
    "dB/m", "rad/m", "1/m", "kg", "J", "%", "rad",
];

/// The unit in which a reader thinks of values up to `size` [SI], and what they are times.
fn of_readers(si: &str, size: f64) -> (&str, f64) {
    match si {
        "m" if size < 0.1 => ("mm", 1e3),
        "m/s" if size < 0.5 => ("mm/s", 1e3),
        "m/s" => ("km/h", 3.6),
        "Pa" if size >= 1e3 => ("kPa", 1e-3),
        "N" if size >= 1e3 => ("kN", 1e-3),
        "1" => ("", 1.0),
        si => (si, 1.0),
    }
}

fn unit(text: &str) -> &'static str {
    UNITS.into_iter().find(|unit| *unit == text).unwrap_or("")
}

impl Against {
    /// Arrays, pictures, answers and concerns.
    pub fn shown(&self) -> Outcome {
        let mut outcome = Outcome { group: self.group(), ..Outcome::default() };
        if let Some(loss) = &self.insertion_loss {
            outcome.answers.extend(loss.answers());
            outcome.figures.push(loss.figure());
        }
        outcome.answers.extend(self.answers.iter().map(|change| {
            let (a, b) = (change.of.value, change.second);
            let percent = match b - a {
                0.0 => ", no change".to_owned(),
                d if a != 0.0 => format!(", {:+.3} %", 100.0 * d / a.abs()),
                _ => String::new(),
            };
            let si = change.of.unit.as_str();
            let (of, times) = of_readers(si, a.abs().max(b.abs()));
            let [first, second] = [a, b].map(|value| significant(times * value));
            let shown = format!("{first} → {second}{}{of}{percent}", if of.is_empty() { "" } else { " " });
            let key = format!("{}_{}", change.study, change.of.key);
            Answer::new(&key, format!("{}: {}", change.study, change.of.what), b - a, unit(si), shown)
        }));
        outcome.figures.extend(self.curves.iter().filter_map(CurveChange::figure));
        if !self.skipped.is_empty() {
            outcome.concerns.push(Concern::new(
                "not-compared",
                self.skipped.join("; "),
                "give both cases the same studies, receivers, bands and ranges",
            ));
        }
        outcome
    }

    /// Differences of all curves, second less first, over their coordinates; insertion losses.
    fn group(&self) -> Group {
        let mut group = Group::new("comparison");
        let add = |group: Group, variable: &Variable, name: String, dims: Vec<String>| {
            if group.get(&name).is_some() {
                return group;
            }
            let dims: Vec<&str> = dims.iter().map(String::as_str).collect();
            group.variable(&name, &dims, variable.values.clone(), &variable.units, &variable.long_name)
        };
        for CurveChange { study, first, second, coordinates } in
            self.curves.iter().filter(|c| !c.first.is_map())
        {
            for coordinate in coordinates {
                let name = format!("{study}_{}", coordinate.name);
                group = add(group, coordinate, name.clone(), vec![name]);
            }
            let difference = Variable { values: &second.values - &first.values, ..first.clone() };
            let dims = first.dims.iter().map(|d| format!("{study}_{d}")).collect();
            group = add(group, &difference, format!("{study}_{}_difference", first.name), dims);
        }
        if let Some(loss) = &self.insertion_loss {
            let what = "20 lg of the velocity of the first case over that of the second";
            let values = loss.bandwise.clone().into_dyn();
            group = group.variable(
                "insertion_loss",
                &["free_field_receiver", "free_field_band"],
                values,
                "1",
                what,
            );
        }
        group.attribute("first", self.titles[0].as_str()).attribute("second", self.titles[1].as_str())
    }
}

impl InsertionLoss {
    fn answers(&self) -> Vec<Answer> {
        let each = self.receivers.iter().zip(&self.overall).filter(|(_, loss)| loss.is_finite());
        each.map(|(y, loss)| {
            let what = format!("Insertion loss at {y} m, all bands together");
            Answer::new(&format!("insertion_loss_{y}"), what, *loss, "dB", format!("{loss:.2} dB"))
        })
        .collect()
    }

    fn figure(&self) -> (Figure, String) {
        let title = "Insertion loss of the second case against the first";
        let label = "insertion loss D = 20 lg(v₁/v₂) [dB]";
        let mut picture = LineFigure::new("insertion_loss", title, "one-third-octave band [Hz]", label);
        picture.log_x = true;
        let all: Vec<Band> = self.bands.iter().filter_map(|f| Band::containing(*f).ok()).collect();
        picture.x_ticks = band_ticks(&all);
        picture.series = (self.receivers.iter().enumerate())
            .map(|(r, y)| {
                let (x, loss) = (all.iter().zip(self.bandwise.row(r)))
                    .flat_map(|(band, d)| [(band.lower(), *d), (band.upper(), *d)])
                    .unzip();
                Series { name: format!("{y} m"), x, y: loss, stroke: Stroke::Solid }
            })
            .collect();
        let caption =
            "Positive where the second case shakes the ground less; it belongs to the place it is taken at.";
        (Figure::Lines(picture), caption.into())
    }
}

impl CurveChange {
    /// Both over the last dimension, a curve for every row; none for maps and for what has too few points or too many rows.
    fn figure(&self) -> Option<(Figure, String)> {
        let Self { study, first, second, coordinates } = self;
        let along = coordinates.last()?;
        let length = along.values.len();
        let rows = first.values.len().checked_div(length)?;
        if first.is_map() || length < 2 || rows == 0 || rows > MOST || coordinates.len() > 2 {
            return None;
        }
        let label =
            |v: &Variable| format!("{} [{}]", v.long_name, if v.units == "1" { "-" } else { &v.units });
        let title = format!("{study}: {}, both cases", first.name);
        let name = format!("{study}_{}_of_both", first.name);
        let mut picture =
            LineFigure::new(name, title, label(along), format!("{} [{}]", first.name, first.units));
        let x = along.to_vec();
        let positive = |values: &Variable| values.values.iter().all(|v| *v > 0.0);
        let (least, most) =
            first.values.iter().fold((f64::INFINITY, 0.0f64), |(l, m), v| (l.min(*v), m.max(*v)));
        picture.log_x = matches!(along.name.as_str(), "band" | "frequency") && x.iter().all(|x| *x > 0.0);
        picture.log_y = positive(first) && positive(second) && most > 30.0 * least;
        for row in 0..rows {
            let of = match coordinates.first().filter(|_| coordinates.len() == 2) {
                Some(other) => format!(", {} {}", other.name, significant(other.to_vec()[row])),
                None => String::new(),
            };
            for (case, variable, stroke) in
                [("first", first, Stroke::Solid), ("second", second, Stroke::Dashed)]
            {
                let values = variable.to_vec()[row * length..][..length].to_vec();
                picture.series.push(Series { name: format!("{case}{of}"), x: x.clone(), y: values, stroke });
            }
        }
        Some((Figure::Lines(picture), format!("{}.", first.long_name)))
    }
}
