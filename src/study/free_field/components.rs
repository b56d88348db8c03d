//! The three components of the motion: what horizontal ones are, beside the vertical one, and the largest of them.

use super::metrics::{Direction, LARGEST, MEASURES, Measured, PEAK_VELOCITY, told};
use super::pictures::{band_figure, figure, steps};
use super::{PassVelocities, StudyError};
use crate::assessment::Guide;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::{PassEnergy, Times};
use crate::figure::{Figure, Series, Stroke};
use crate::soil::Motion;
use crate::study::{Answer, speed_text};
use ndarray::{Array2, Axis};
use schemars::JsonSchema;
use serde::Deserialize;

/// Which components of the motion are wanted.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Components {
    /// The vertical one.
    #[default]
    Vertical,
    /// Along and across the track too.
    Three,
}

impl Components {
    /// The vertical one first.
    pub fn motions(self) -> &'static [Motion] {
        match self {
            Self::Vertical => &Motion::ALL[..1],
            Self::Three => &Motion::ALL,
        }
    }
}

/// One component of a pass.
pub struct OneComponent {
    /// Its direction.
    pub motion: Motion,
    /// Energies in third octaves, receivers × bands.
    pub energies: PassEnergy,
    /// Velocity [m/s] of the axle loads alone, receivers × times.
    pub quasi_static: Array2<f64>,
    /// Total velocity [m/s] of each profile, receivers × times.
    pub histories: Vec<Array2<f64>>,
}

/// The table of what is told of them.
pub(super) const COMPONENTS_TABLE: &str = "three components, open ground";

/// Name in keys and words of a direction.
pub(super) fn words(motion: Motion) -> (&'static str, &'static str) {
    match motion {
        Motion::Vertical => ("vertical", "vertical"),
        Motion::Along => ("along", "along the track"),
        Motion::Across => ("across", "across the track"),
    }
}

impl OneComponent {
    /// The vertical one and the others of the `motions`, from arrays of all channels: energies, the part of the axle loads, histories.
    pub(super) fn split(
        motions: &[Motion],
        (energies, quasi_static, histories): (&PassEnergy, &Array2<f64>, &[Array2<f64>]),
    ) -> (Self, Vec<Self>) {
        let receivers = quasi_static.nrows() / motions.len();
        let component = |number: usize, motion: Motion| {
            let rows: Vec<usize> = (number * receivers..(number + 1) * receivers).collect();
            let of = |all: &Array2<f64>| all.select(Axis(0), &rows);
            Self {
                motion,
                energies: PassEnergy {
                    quasi_static: of(&energies.quasi_static),
                    dynamic: of(&energies.dynamic),
                    total: of(&energies.total),
                },
                quasi_static: of(quasi_static),
                histories: histories.iter().map(of).collect(),
            }
        };
        let others = motions.iter().enumerate().skip(1).map(|(number, motion)| component(number, *motion));
        (component(0, Motion::Vertical), others.collect())
    }
}

/// A horizontal component with its measures.
pub struct Horizontal {
    /// Its motion.
    pub component: OneComponent,
    /// Its measures.
    pub measured: Measured,
}

/// Both horizontal components, and the largest of the three.
pub struct ThreeComponents {
    /// Along and across.
    pub horizontal: Vec<Horizontal>,
    /// The largest of the three, measure by measure.
    pub largest: Measured,
    /// max √(v_x² + v_y² + v_z²) [m/s], profiles × receivers.
    pub vector_peak: Array2<f64>,
}

impl ThreeComponents {
    /// Of `horizontal` components beside the `vertical` one, of which `measured` is known; None of no horizontal one.
    ///
    /// # Errors
    /// A velocity that is not a number.
    pub(super) fn of(
        vertical: &OneComponent,
        measured: &Measured,
        horizontal: Vec<OneComponent>,
        times: Times,
    ) -> Result<Option<Self>, StudyError> {
        if horizontal.is_empty() {
            return Ok(None);
        }
        let with_measures = |component: OneComponent| {
            let measured = Measured::of(&component.histories, times, Direction::Horizontal)?;
            Ok::<_, StudyError>(Horizontal { component, measured })
        };
        let horizontal: Vec<Horizontal> =
            horizontal.into_iter().map(with_measures).collect::<Result<_, _>>()?;
        let largest = horizontal.iter().fold(measured.clone(), |largest, h| largest.larger_of(&h.measured));
        let all: Vec<&[Array2<f64>]> = std::iter::once(&vertical.histories[..])
            .chain(horizontal.iter().map(|h| &h.component.histories[..]))
            .collect();
        let shape = (vertical.histories.len(), vertical.quasi_static.nrows());
        let vector_peak = Array2::from_shape_fn(shape, |(profile, r)| {
            let square = |i: usize| all.iter().map(|h| h[profile][(r, i)].powi(2)).sum::<f64>();
            (0..times.count).map(square).fold(0.0, f64::max).sqrt()
        });
        Ok(Some(Self { horizontal, largest, vector_peak }))
    }
}

impl PassVelocities<'_> {
    /// Adds the arrays of horizontal components, named as the vertical ones with `_along` and `_across` behind.
    pub(super) fn component_arrays(&self, mut group: Group, dims: &[&str]) -> Result<Group, StudyError> {
        let Some(three) = &self.three else { return Ok(group) };
        for Horizontal { component, measured } in &three.horizontal {
            let (key, words) = words(component.motion);
            let velocities = component.energies.velocities(self.passage_time)?;
            let parts = [
                ("v_rms_quasi_static", "quasi-static part"),
                ("v_rms_dynamic", "dynamic part"),
                ("v_rms_total", "both"),
            ];
            for ((name, what), values) in parts.into_iter().zip(velocities) {
                let what = format!("r.m.s. velocity over the passage time, {words}: {what}");
                group = group.variable(
                    &format!("{name}_{key}"),
                    &["receiver", "band"],
                    values.into_dyn(),
                    "m s-1",
                    &what,
                );
            }
            let positive = if component.motion == Motion::Along {
                "in the direction of travel"
            } else {
                "away from the track"
            };
            let mut histories = vec![("v_quasi_static", component.quasi_static.clone(), "quasi-static part")];
            if self.study.roughness.is_some() {
                let total = component.histories[0].clone();
                histories.push((
                    "v_dynamic",
                    &total - &component.quasi_static,
                    "dynamic part for the first profile",
                ));
                histories.push(("v_total", total, "both parts for the first profile"));
            }
            for (name, values, what) in histories {
                let what = format!("velocity {words} of the {what}, positive {positive}");
                group = group.variable(
                    &format!("{name}_{key}"),
                    &["receiver", "time"],
                    values.into_dyn(),
                    "m s-1",
                    &what,
                );
            }
            group = measured.arrays(group, dims, &format!("_{key}"), Direction::Horizontal, words);
        }
        let peak = &three.vector_peak;
        let values =
            if dims.len() == 2 { peak.clone().into_dyn() } else { peak.row(0).to_owned().into_dyn() };
        let what = "largest modulus of the velocity of all three components together, unweighted";
        Ok(group.variable("peak_vector_velocity", dims, values, "m s-1", what))
    }

    /// Peaks along and across the track, of the vector, and the largest of three components of what is told of the vertical one.
    pub(super) fn component_answers(&self, r: usize, y: f64) -> Result<Vec<Answer>, StudyError> {
        let Some(three) = &self.three else { return Ok(Vec::new()) };
        let mut answers = Vec::new();
        for Horizontal { component, measured } in &three.horizontal {
            let (key, words) = words(component.motion);
            answers.push(self.measure_answer(PEAK_VELOCITY, r, y, (key, words, measured))?);
        }
        let peaks = three.vector_peak.column(r);
        let mean = peaks.iter().sum::<f64>() / peaks.len() as f64;
        let (mut shown, mut number) =
            (MEASURES[PEAK_VELOCITY].shown(mean), MEASURES[PEAK_VELOCITY].number(mean));
        if peaks.len() > 1 {
            let ends = [f64::min, f64::max].map(|of| peaks.iter().copied().reduce(of).unwrap_or(mean));
            let [least, most] = ends.map(|peak| MEASURES[PEAK_VELOCITY].number(peak));
            shown = format!("{shown}, {least} to {most} in {} profiles", peaks.len());
            number = format!("{number} ({least} to {most})");
        }
        let what = format!("Peak of the velocity vector at {y} m");
        let vector = Answer::new(&format!("peak_vector_velocity_{y}"), what, mean, "m/s", shown);
        let table = self.measures_table(COMPONENTS_TABLE);
        answers.push(vector.in_table(Self::row(table, y, [("peak of the vector [mm/s]", number)])));
        for m in told(&self.study.assessment.guides) {
            answers.push(self.measure_answer(m, r, y, ("largest", LARGEST, &three.largest))?);
        }
        Ok(answers)
    }

    /// Third octaves and histories of all components at each receiver.
    pub(super) fn component_figures(&self) -> Result<Vec<(Figure, String)>, StudyError> {
        let Some(three) = &self.three else { return Ok(Vec::new()) };
        let study = self.study;
        let (at, levels) = (speed_text(study.speed), study.assessment.levels);
        let strokes = [Stroke::Solid, Stroke::Dashed, Stroke::Points];
        let mut all = vec![(Motion::Vertical, &self.energies, &self.histories[0])];
        all.extend(
            three
                .horizontal
                .iter()
                .map(|h| (h.component.motion, &h.component.energies, &h.component.histories[0])),
        );
        let mut totals = Vec::new();
        for (motion, energies, history) in all {
            let [_, _, total] = energies.velocities(self.passage_time)?;
            totals.push((words(motion).1, total, history));
        }
        let (from, to) = self.felt();
        let times = &self.times.values()[from..to];
        let mut figures = Vec::new();
        for (r, y) in study.receivers.iter().enumerate() {
            let title = format!("Components of the ground velocity at {y} m, {at}");
            let mut bands =
                band_figure(format!("free_field_components_{y}"), title.clone(), &study.bands, levels);
            let most = totals.iter().flat_map(|(_, total, _)| total.row(r).to_vec()).fold(0.0, f64::max);
            let labels = ("time after the leading axle was abreast [s]", "velocity [mm/s]");
            let mut history = figure(format!("free_field_history_components_{y}"), title, labels, false);
            for ((name, total, values), stroke) in totals.iter().zip(strokes) {
                bands.series.push(steps(
                    (*name).into(),
                    &study.bands,
                    &total.row(r).to_vec(),
                    (stroke, levels, most),
                ));
                let stroke = if stroke == Stroke::Points { Stroke::Solid } else { stroke };
                let y = values.row(r).to_vec()[from..to].iter().map(|v| 1e3 * v).collect();
                history.series.push(Series { name: (*name).into(), x: times.to_vec(), y, stroke });
            }
            let caption = format!(
                "Unweighted r.m.s. over {:.2} s in one-third-octave bands, total.",
                self.passage_time
            );
            figures.push((Figure::Lines(bands), caption));
            let caption = format!(
                "Positive down, in the direction of travel, and away from the track. {}",
                self.which()
            );
            figures.push((Figure::Lines(history), caption));
        }
        Ok(figures)
    }
}

/// A concern where a standard wants components that are not computed.
pub(super) fn missing(components: Components, guides: &[Guide]) -> Option<Concern> {
    (components == Components::Vertical && guides.contains(&Guide::Din4150Part3)).then(|| {
        Concern::new(
            "one-component",
            "DIN 4150-3 takes the largest of three components at the foundation; the vertical one alone is computed".to_owned(),
            "set free_field.components = \"three\"",
        )
    })
}
