//! What a reader sees of the free field: answers, pictures, concerns.

use super::free_field::{Component, FreeField};
use super::{Answer, Model, StudyError, speed_text};
use crate::assessment::{Level, Reference};
use crate::concern::Concern;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use ndarray::Array2;
use std::f64::consts::TAU;

impl FreeField {
    /// Levels, strongest bands, and where the dynamic part takes over, for each receiver.
    pub(super) fn answers(
        &self,
        passage_time: f64,
        quasi_static: &Array2<f64>,
        dynamic: &Array2<f64>,
        total: &Array2<f64>,
    ) -> Result<Vec<Answer>, StudyError> {
        let mut answers = Vec::new();
        if let Some(roughness) = &self.roughness {
            let sigma = roughness.spectrum.band_rms(roughness.wavelengths.0, roughness.wavelengths.1);
            let (from, to) = roughness.wavelengths;
            answers.push(Answer::new(
                "profile_rms",
                format!("R.m.s. of the profile, wavelengths {from} to {to} m"),
                sigma,
                "m",
                format!("{:.2} mm", 1e3 * sigma),
            ));
        }
        for (r, y) in self.receivers.iter().enumerate() {
            let broadband = |v: &Array2<f64>| v.row(r).iter().map(|v| v * v).sum::<f64>().sqrt();
            let mut add = |key: &str, what: String, value: f64, unit, shown: String| {
                answers.push(Answer::new(&format!("{key}_{y}"), what, value, unit, shown));
            };
            let value = broadband(total);
            let level = Level::of(value, Reference::Iso1683)?;
            let parts = (1e3 * broadband(quasi_static), 1e3 * broadband(dynamic));
            add(
                "v_rms",
                format!("R.m.s. velocity at {y} m over {passage_time:.2} s, all bands"),
                value,
                "m/s",
                format!(
                    "{:.4} mm/s (quasi-static {:.4}, dynamic {:.4}), {level}",
                    1e3 * value,
                    parts.0,
                    parts.1
                ),
            );
            let row = total.row(r);
            let top = (0..row.len()).max_by(|&a, &b| row[a].total_cmp(&row[b])).unwrap_or(0);
            let peak = self.bands[top];
            add(
                "peak_band",
                format!("Strongest band at {y} m"),
                peak.centre(),
                "Hz",
                format!("{} Hz, {:.4} mm/s", peak.label(), 1e3 * row[top]),
            );
            // the first band from which on the dynamic part prevails
            let last = (0..row.len()).rev().find(|&b| quasi_static[(r, b)] > dynamic[(r, b)]);
            if let Some(crossing) = last.filter(|b| b + 1 < row.len() && self.roughness.is_some()) {
                let band = self.bands[crossing + 1];
                add(
                    "crossing_band",
                    format!("Band from which on the dynamic part prevails at {y} m"),
                    band.centre(),
                    "Hz",
                    format!("{} Hz", band.label()),
                );
            }
        }
        Ok(answers)
    }

    /// Bands of each receiver and of all, velocity against distance, contact force.
    pub(super) fn figures(
        &self,
        passage_time: f64,
        centres: &[f64],
        parts: [&Array2<f64>; 3],
        components: &[Component],
    ) -> Vec<(Figure, String)> {
        let figure = |name: String, title: String, x_label: &str, y_label: &str, series| {
            Figure::Lines(LineFigure {
                name,
                title,
                x_label: x_label.into(),
                y_label: y_label.into(),
                second_x: None,
                y_down: false,
                log_x: true,
                log_y: true,
                series,
                marks: Vec::new(),
            })
        };
        let (band, velocity) = ("one-third-octave band [Hz]", "r.m.s. velocity [mm/s]");
        let at = speed_text(self.speed);
        // what is too small for a logarithmic picture is left out
        let least = 1e-4 * parts[2].iter().copied().fold(0.0, f64::max) * 1e3;
        let line = |name: String, x: &[f64], y: Vec<f64>, stroke| {
            let kept = x.iter().zip(y).filter(|(_, y)| *y > least);
            let (x, y) = kept.map(|(x, y)| (*x, y)).unzip();
            Series { name, x, y, stroke }
        };
        let row = |v: &Array2<f64>, r: usize| v.row(r).iter().map(|v| 1e3 * v).collect::<Vec<_>>();
        let mut figures = Vec::new();
        for (r, y) in self.receivers.iter().enumerate() {
            let mut series = vec![line("total".into(), centres, row(parts[2], r), Stroke::Solid)];
            if self.roughness.is_some() {
                series.push(line("quasi-static".into(), centres, row(parts[0], r), Stroke::Dashed));
                series.push(line("dynamic".into(), centres, row(parts[1], r), Stroke::Points));
            }
            figures.push((
                figure(format!("free_field_{y}"), format!("Ground velocity at {y} m, {at}"), band, velocity, series),
                format!(
                    "Vertical velocity of the ground's surface {y} m from the centre line, unweighted r.m.s. over {passage_time:.2} s in \
                     one-third-octave bands."
                ),
            ));
        }
        let series = self.receivers.iter().enumerate();
        let series = series.map(|(r, y)| line(format!("{y} m"), centres, row(parts[2], r), Stroke::Solid));
        figures.push((
            figure(
                "free_field_receivers".into(),
                format!("Ground velocity, {at}"),
                band,
                velocity,
                series.collect(),
            ),
            "Total of all receivers.".into(),
        ));
        if self.receivers.len() > 1 {
            let sums = |v: &Array2<f64>| {
                let sum = |r| row(v, r).iter().map(|v| v * v).sum::<f64>().sqrt();
                (0..self.receivers.len()).map(sum).collect::<Vec<f64>>()
            };
            let names =
                [("quasi-static", Stroke::Dashed), ("dynamic", Stroke::Points), ("total", Stroke::Solid)];
            let series = names.iter().zip(parts).map(|(&(name, stroke), v)| Series {
                name: name.into(),
                x: self.receivers.clone(),
                y: sums(v),
                stroke,
            });
            let series = series.filter(|s| s.y.iter().all(|y| *y > 0.0)).collect();
            let label = "distance from the centre line [m]";
            figures.push((
                figure(
                    "free_field_distance".into(),
                    format!("Ground velocity against distance, {at}"),
                    label,
                    velocity,
                    series,
                ),
                "R.m.s. velocity of all bands together.".into(),
            ));
        }
        if let Some(roughness) = &self.roughness {
            let x: Vec<f64> = components.iter().map(|c| c.wavenumber * self.speed / TAU).collect();
            let y = components.iter().map(|c| {
                let density = c.forces[0].norm_sqr() * roughness.spectrum.one_sided(c.wavenumber);
                1e-3 * (density * TAU / self.speed).sqrt()
            });
            let series = vec![line("leading wheelset".into(), &x, y.collect(), Stroke::Solid)];
            figures.push((
                figure(
                    "contact_force".into(),
                    format!("Dynamic wheel-rail force, {at}"),
                    "driving frequency v/λ [Hz]",
                    "√ of one-sided spectral density [kN/√Hz]",
                    series,
                ),
                format!("Force of the leading wheelset on the rail; profile: {}.", roughness.spectrum.text()),
            ));
        }
        figures
    }

    /// The quasi-static history.
    pub(super) fn history_figure(&self, time: &[f64], histories: &Array2<f64>) -> (Figure, String) {
        let series = self.receivers.iter().enumerate().map(|(r, y)| Series {
            name: format!("{y} m"),
            x: time.to_vec(),
            y: histories.row(r).iter().map(|v| 1e3 * v).collect(),
            stroke: Stroke::Solid,
        });
        let figure = LineFigure {
            name: "free_field_history".into(),
            title: format!("Quasi-static ground velocity, {}", speed_text(self.speed)),
            x_label: "time after the leading axle was abreast [s]".into(),
            y_label: "velocity [mm/s], positive down".into(),
            second_x: None,
            y_down: true,
            log_x: false,
            log_y: false,
            series: series.collect(),
            marks: Vec::new(),
        };
        let caption =
            "Vertical velocity of the ground under the constant axle loads alone, without the rough rail.";
        (Figure::Lines(figure), caption.into())
    }

    /// Speeds and wavelengths the result may be doubted for.
    pub(super) fn concerns(&self, model: &Model) -> Vec<Concern> {
        let mut concerns: Vec<Concern> = model.outruns_waves(self.speed).into_iter().collect();
        if let Ok((profile, _)) = model.ground("free_field") {
            let slowest = profile.slowest_rayleigh_speed();
            if self.speed >= slowest {
                concerns.push(Concern::new(
                    "faster-than-rayleigh",
                    format!(
                        "{} is not below the slowest Rayleigh wave of the ground ({slowest:.1} m/s): the axle loads alone radiate",
                        speed_text(self.speed)
                    ),
                    "see the critical speed of this train and track with [critical_speed]",
                ));
            }
        }
        let Some(roughness) = &self.roughness else { return concerns };
        let (shortest, longest) = roughness.wavelengths;
        if let Some((least, most)) = roughness.spectrum.valid()
            && (shortest < 0.999 * least || longest > 1.001 * most)
        {
            concerns.push(Concern::new(
                "spectrum-range",
                format!(
                    "wavelengths {shortest} to {longest} m go beyond those for which the spectrum is published, {least} to {most} m"
                ),
                "narrow irregularity.wavelengths, or read the bands driven by them as extrapolated",
            ));
        }
        let (low, high) = (self.speed / longest, self.speed / shortest);
        if let (Some(first), Some(last)) = (self.bands.first(), self.bands.last())
            && (first.lower() < low || last.upper() > high)
        {
            concerns.push(Concern::new(
                "bands-without-drive",
                format!(
                    "at {} the profile drives {low:.2} to {high:.1} Hz, the bands reach from {:.2} to {:.1} Hz",
                    speed_text(self.speed),
                    first.lower(),
                    last.upper()
                ),
                "widen irregularity.wavelengths, or narrow free_field.frequencies; outside, the dynamic part is too small",
            ));
        }
        concerns
    }
}
