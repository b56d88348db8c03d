//! How much do rail and ground move under a standing harmonic load?

use super::{Answer, Model, Outcome, ReceptanceMap, StudyError};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::progress::Observer;
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Accuracy of G for receivers.
pub(super) const GROUND_ACCURACY: f64 = 1e-5;
/// Wavenumbers thin layers must resolve [rad/m]: what is shorter than the track's width does not reach receivers.
pub(super) const K_MAX: f64 = 100.0;

/// Receptance of the rail and of the ground beside the track.
#[derive(Clone, Debug, PartialEq)]
pub struct Receptance {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// Distances from the centre line of the track [m]; may be empty.
    pub receivers: Vec<f64>,
    /// The surface around the force, if wanted.
    pub map: Option<ReceptanceMap>,
}

/// Rail, every receiver, whether the accuracy was met.
type Row = (Complex64, Vec<Complex64>, bool);

impl Receptance {
    /// Displacements of rail and ground per unit force e^{iωt} on the rail [m/N], positive down.
    ///
    /// # Errors
    /// No track, receivers or a map without layered ground, undamped waves.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let track = model.track()?;
        let ground = if self.receivers.is_empty() { None } else { Some(model.ground("receptance")?) };
        observer.begin("receptance", self.frequencies.len() as u64);
        let rows: Vec<Row> = self
            .frequencies
            .par_iter()
            .map(|frequency| {
                let omega = TAU * frequency;
                let load = track.harmonic(omega, 0.0, 0.0)?;
                let (receivers, met) = match (ground, model.contact().strip()) {
                    (Some((profile, solver)), Some(strip)) => {
                        let ground = solver.prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)?;
                        track.ground(omega, ground.as_ref(), strip, &self.receivers)?
                    }
                    _ => (Vec::new(), true),
                };
                observer.advance();
                Ok((load.rail(0.0), receivers, load.converged && met))
            })
            .collect::<Result<_, StudyError>>()?;
        observer.end();

        let rail: Vec<Complex64> = rows.iter().map(|r| r.0).collect();
        let shape = (self.receivers.len(), self.frequencies.len());
        let at = Array2::from_shape_fn(shape, |(r, f)| rows[f].1[r]);
        let mut group = Group::new("receptance")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .variable(
                "rail_re",
                &["frequency"],
                parts(&rail, |z| z.re),
                "m N-1",
                "rail displacement per force on the rail, real part",
            )
            .variable(
                "rail_im",
                &["frequency"],
                parts(&rail, |z| z.im),
                "m N-1",
                "the same, imaginary part (e^{i omega t})",
            );
        if !self.receivers.is_empty() {
            let dims = ["receiver", "frequency"];
            group = group
                .coordinate("receiver", &self.receivers, "m", "distance from the centre line of the track")
                .variable(
                    "ground_re",
                    &dims,
                    at.mapv(|z| z.re).into_dyn(),
                    "m N-1",
                    "vertical displacement of the ground per force on the rail, real part",
                )
                .variable(
                    "ground_im",
                    &dims,
                    at.mapv(|z| z.im).into_dyn(),
                    "m N-1",
                    "the same, imaginary part",
                );
        }

        let mut answers = Vec::new();
        let modulus: Vec<f64> = rail.iter().map(|z| z.norm()).collect();
        let mut record = |key: &str, what: String, i: usize, value: f64| {
            let f = self.frequencies[i];
            answers.push(Answer::new(
                &format!("{key}_frequency"),
                format!("Frequency of the {what}"),
                f,
                "Hz",
                format!("{f:.1} Hz"),
            ));
            let shown = format!("{value:.3e} m/N");
            answers.push(Answer::new(key, format!("The {what}"), value, "m/N", shown));
        };
        if let Some(i) = first_peak(&modulus) {
            record("cut_on", "first peak of the rail receptance (cut-on)".into(), i, modulus[i]);
        }
        let top = largest(&modulus);
        record("max_receptance", "largest rail receptance".into(), top, modulus[top]);
        for (r, y) in self.receivers.iter().enumerate() {
            let values: Vec<f64> = at.row(r).iter().map(|z| z.norm()).collect();
            let top = largest(&values);
            record(
                &format!("max_ground_{y}"),
                format!("largest ground receptance at {y} m"),
                top,
                values[top],
            );
        }
        let line =
            |name: String, y: Vec<f64>, stroke| Series { name, x: self.frequencies.clone(), y, stroke };
        let figure = |name: &str, title: &str, y_label: &str, log_y, series| {
            Figure::Lines(LineFigure {
                name: name.into(),
                title: title.into(),
                x_label: "frequency [Hz]".into(),
                y_label: y_label.into(),
                second_x: None,
                y_down: false,
                log_x: false,
                log_y,
                series,
                marks: Vec::new(),
            })
        };
        let nano = |values: Vec<f64>| values.iter().map(|v| 1e9 * v).collect::<Vec<_>>();
        let mut figures = vec![(
            figure(
                "receptance_rail",
                "Rail receptance under a standing load",
                "displacement [nm/N]",
                false,
                vec![
                    line("modulus".into(), nano(modulus), Stroke::Solid),
                    line("real part".into(), nano(rail.iter().map(|z| z.re).collect()), Stroke::Dashed),
                    line("imaginary part".into(), nano(rail.iter().map(|z| z.im).collect()), Stroke::Dashed),
                ],
            ),
            "Displacement of the rail under a unit harmonic force on it, positive down, phases of e^{iωt}."
                .into(),
        )];
        if !self.receivers.is_empty() {
            let series = self.receivers.iter().enumerate().map(|(r, y)| {
                line(format!("{y} m"), nano(at.row(r).iter().map(|z| z.norm()).collect()), Stroke::Solid)
            });
            figures.push((
                figure("receptance_ground", "Ground receptance beside the track", "vertical displacement [nm/N]", true, series.collect()),
                "Modulus of the vertical displacement of the ground's surface per unit harmonic force on the rail, abreast of it."
                    .into(),
            ));
        }
        let missed: Vec<String> =
            self.frequencies.iter().zip(&rows).filter(|(_, r)| !r.2).map(|(f, _)| format!("{f}")).collect();
        let concerns = (!missed.is_empty()).then(|| {
            Concern::new(
                "quadrature",
                format!("the wavenumber integrals missed their accuracy (1e-4) at {} Hz", missed.join(", ")),
                "poles lie too close to the real axis (more damping helps), or the track spreads the load too little",
            )
        });
        let mut outcome = Outcome { group, figures, answers, concerns: concerns.into_iter().collect() };
        if let Some(map) = &self.map {
            map.add(model, observer, &mut outcome)?;
        }
        Ok(outcome)
    }
}

fn parts(values: &[Complex64], part: fn(&Complex64) -> f64) -> ndarray::ArrayD<f64> {
    values.iter().map(part).collect::<ndarray::Array1<f64>>().into_dyn()
}

fn largest(values: &[f64]) -> usize {
    (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0)
}

/// The first value larger than both neighbours.
fn first_peak(values: &[f64]) -> Option<usize> {
    (1..values.len().saturating_sub(1)).find(|&i| values[i] > values[i - 1] && values[i] >= values[i + 1])
}
