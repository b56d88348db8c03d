//! What a reader sees of the free field: answers, pictures, concerns.

use super::metrics::{KB_F_MAXIMUM, MEASURES, TOLD, V_SLOW_MAXIMUM, VDV};
use super::{Answered, Carrier, FreeField, Irregularity};
use crate::assessment::{Level, Quantity, Reference, guide_values};
use crate::concern::Concern;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::{Answer, Model, StudyError, speed_text};
use ndarray::Array2;
use std::f64::consts::TAU;

/// Share of the peak velocity at the ends of a history that counts as motion not died away.
const LEFT: f64 = 0.05;

/// `value` where a logarithmic picture has room for it beside `largest`, else a gap in the curve.
fn seen(value: f64, largest: f64) -> f64 {
    if value > 1e-4 * largest { value } else { f64::NAN }
}

/// A figure without its curves.
fn figure(name: String, title: String, labels: (&str, &str), log: bool) -> LineFigure {
    LineFigure {
        name,
        title,
        x_label: labels.0.into(),
        y_label: labels.1.into(),
        second_x: None,
        y_down: false,
        log_x: log,
        log_y: log,
        series: Vec::new(),
        marks: Vec::new(),
    }
}

impl Answered<'_> {
    /// Levels, strongest bands, where the dynamic part takes over, and measures, for each receiver.
    pub(super) fn answers(&self, velocities: &[Array2<f64>; 3]) -> Result<Vec<Answer>, StudyError> {
        let study = self.pass.study;
        let [quasi_static, dynamic, total] = velocities;
        let mut answers = Vec::new();
        if let Some(roughness) = &study.roughness {
            let sigma = roughness.irregularity.rms();
            let what = match &roughness.irregularity {
                Irregularity::Random { wavelengths: (from, to), .. } => {
                    format!("R.m.s. of the profile, wavelengths {from} to {to} m")
                }
                Irregularity::Given { .. } => "R.m.s. of the profile".into(),
            };
            answers.push(Answer::new("profile_rms", what, sigma, "m", format!("{:.3} mm", 1e3 * sigma)));
        }
        for (r, y) in study.receivers.iter().enumerate() {
            let broadband = |v: &Array2<f64>| v.row(r).iter().map(|v| v * v).sum::<f64>().sqrt();
            let mut add = |key: &str, what: String, value: f64, unit, shown: String| {
                answers.push(Answer::new(&format!("{key}_{y}"), what, value, unit, shown));
            };
            let value = broadband(total);
            let level = if value > 0.0 {
                Level::of(value, Reference::Iso1683)?.to_string()
            } else {
                "less than 1e-10 of what the track feels arrives".into()
            };
            let parts = (1e3 * broadband(quasi_static), 1e3 * broadband(dynamic));
            add(
                "v_rms",
                format!("R.m.s. velocity at {y} m over {:.2} s, all bands", self.pass.passage_time),
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
            let peak = study.bands[top];
            add(
                "peak_band",
                format!("Strongest band at {y} m"),
                peak.centre(),
                "Hz",
                format!("{} Hz, {:.4} mm/s", peak.label(), 1e3 * row[top]),
            );
            // the first band from which on the dynamic part prevails
            let last = (0..row.len()).rev().find(|&b| quasi_static[(r, b)] > dynamic[(r, b)]);
            if let Some(crossing) = last.filter(|b| b + 1 < row.len() && study.roughness.is_some()) {
                let band = study.bands[crossing + 1];
                add(
                    "crossing_band",
                    format!("Band from which on the dynamic part prevails at {y} m"),
                    band.centre(),
                    "Hz",
                    format!("{} Hz", band.label()),
                );
            }
            for m in TOLD {
                let measure = &MEASURES[m];
                let (mean, least, most) = self.metrics.spread(m, r);
                let mut shown = measure.shown(mean);
                if self.histories.len() > 1 {
                    let spread = (measure.number(least), measure.number(most));
                    shown =
                        format!("{shown}, {} to {} in {} profiles", spread.0, spread.1, self.histories.len());
                }
                if m == V_SLOW_MAXIMUM {
                    shown = format!("{shown}; {}", Level::of(mean, Reference::VdB)?);
                }
                add(measure.key, format!("{} at {y} m", measure.symbol), mean, measure.unit(), shown);
            }
        }
        Ok(answers)
    }

    /// Which profile the histories belong to.
    fn which(&self) -> String {
        match self.pass.study.roughness.as_ref().map(|r| &r.irregularity) {
            None => "Smooth rail.".into(),
            Some(Irregularity::Random { spectrum, seed, .. }) => {
                format!("One profile out of many, seed {seed}; {}.", spectrum.text())
            }
            Some(Irregularity::Given { text, .. }) => format!("Profile: {text}."),
        }
    }

    /// Bands of each receiver and of all, velocity against distance, contact force, histories, measures beside guide values.
    pub(super) fn figures(&self, velocities: &[Array2<f64>; 3]) -> Vec<(Figure, String)> {
        let mut figures = self.band_figures(velocities);
        figures.extend(self.force_figure());
        figures.extend(self.history_figures());
        figures.extend(self.guide_figures());
        figures
    }

    fn band_figures(&self, velocities: &[Array2<f64>; 3]) -> Vec<(Figure, String)> {
        let study = self.pass.study;
        let at = speed_text(study.speed);
        let centres: Vec<f64> = study.bands.iter().map(|band| band.centre()).collect();
        let labels = ("one-third-octave band [Hz]", "r.m.s. velocity [mm/s]");
        let row = |v: &Array2<f64>, r: usize| v.row(r).iter().map(|v| 1e3 * v).collect::<Vec<_>>();
        let largest = |v: &mut dyn Iterator<Item = &f64>| 1e3 * v.fold(0.0, |m: f64, v| m.max(*v));
        let line = |name: String, y: Vec<f64>, stroke, largest: f64| Series {
            name,
            x: centres.clone(),
            y: y.into_iter().map(|y| seen(y, largest)).collect(),
            stroke,
        };
        let names = [("quasi-static", Stroke::Dashed), ("dynamic", Stroke::Points), ("total", Stroke::Solid)];
        let rough = study.roughness.is_some();
        let mut figures = Vec::new();
        for (r, y) in study.receivers.iter().enumerate() {
            let name = format!("free_field_{y}");
            let mut picture = figure(name, format!("Ground velocity at {y} m, {at}"), labels, true);
            for (&(name, stroke), v) in names.iter().zip(velocities) {
                if rough || name == "total" {
                    let largest = largest(&mut velocities[2].row(r).iter());
                    picture.series.push(line(name.into(), row(v, r), stroke, largest));
                }
            }
            let caption = format!(
                "Vertical velocity of the ground's surface {y} m from the centre line, unweighted r.m.s. over {:.2} s in one-third-octave \
                 bands.",
                self.pass.passage_time
            );
            figures.push((Figure::Lines(picture), caption));
        }
        let mut picture =
            figure("free_field_receivers".into(), format!("Ground velocity, {at}"), labels, true);
        let receivers = study.receivers.iter().enumerate();
        let all = largest(&mut velocities[2].iter());
        picture.series = receivers
            .map(|(r, y)| line(format!("{y} m"), row(&velocities[2], r), Stroke::Solid, all))
            .collect();
        figures.push((Figure::Lines(picture), "Total of all receivers.".into()));
        if study.receivers.len() > 1 {
            let sums = |v: &Array2<f64>| {
                let sum = |r| row(v, r).iter().map(|v| v * v).sum::<f64>().sqrt();
                (0..study.receivers.len()).map(sum).collect::<Vec<f64>>()
            };
            let labels = ("distance from the centre line [m]", "r.m.s. velocity [mm/s]");
            let title = format!("Ground velocity against distance, {at}");
            let mut picture = figure("free_field_distance".into(), title, labels, true);
            let series = names.iter().zip(velocities).map(|(&(name, stroke), v)| Series {
                name: name.into(),
                x: study.receivers.clone(),
                y: sums(v),
                stroke,
            });
            picture.series = series.filter(|s| s.y.iter().any(|y| *y > 0.0)).collect();
            figures.push((Figure::Lines(picture), "R.m.s. velocity of all bands together.".into()));
        }
        figures
    }

    fn force_figure(&self) -> Option<(Figure, String)> {
        let roughness = self.pass.study.roughness.as_ref().filter(|_| !self.driven.is_empty())?;
        let (label, stroke) = match &roughness.irregularity {
            Irregularity::Random { .. } => ("√ of one-sided spectral density [kN/√Hz]", Stroke::Solid),
            Irregularity::Given { .. } => ("amplitude [kN]", Stroke::Points),
        };
        let largest = self.driven.iter().map(|d| d.force).fold(0.0, f64::max);
        let (x, y) = self.driven.iter().map(|d| (d.frequency, 1e-3 * seen(d.force, largest))).unzip();
        let title = format!("Dynamic wheel-rail force, {}", speed_text(self.pass.study.speed));
        let mut picture = figure("contact_force".into(), title, ("driving frequency v/λ [Hz]", label), true);
        picture.series = vec![Series { name: "leading wheelset".into(), x, y, stroke }];
        let caption =
            format!("Force of the leading wheelset on the rail; profile: {}.", roughness.irregularity.text());
        Some((Figure::Lines(picture), caption))
    }

    fn history_figures(&self) -> Vec<(Figure, String)> {
        let study = self.pass.study;
        let at = speed_text(study.speed);
        let time = self.times.values();
        let axis = "time after the leading axle was abreast [s]";
        let mut figures = Vec::new();
        for (r, y) in study.receivers.iter().enumerate() {
            let title = format!("Ground velocity at {y} m, {at}");
            let labels = (axis, "velocity [mm/s], positive down");
            let mut picture = figure(format!("free_field_history_{y}"), title, labels, false);
            picture.y_down = true;
            let series = |name: &str, v: &Array2<f64>, stroke| Series {
                name: name.into(),
                x: time.clone(),
                y: v.row(r).iter().map(|v| 1e3 * v).collect(),
                stroke,
            };
            if study.roughness.is_some() {
                picture.series.push(series("total", &self.histories[0], Stroke::Solid));
            }
            picture.series.push(series("quasi-static", &self.quasi_static.velocity, Stroke::Dashed));
            figures.push((Figure::Lines(picture), format!("Vertical velocity. {}", self.which())));
        }
        let title = format!("KB_F(t), {at}");
        let mut picture = figure("free_field_kb".into(), title, (axis, "KB_F [-]"), false);
        picture.series = study
            .receivers
            .iter()
            .enumerate()
            .map(|(r, y)| Series {
                name: format!("{y} m"),
                x: time.clone(),
                y: self.metrics.kb_f.row(r).to_vec(),
                stroke: Stroke::Solid,
            })
            .collect();
        let caption = "Weighted vibration severity of the ground's surface after DIN 45669-1, FAST.";
        figures.push((Figure::Lines(picture), format!("{caption} {}", self.which())));
        figures
    }

    /// Measures against distance with the guide values of standards, which hold inside buildings and for what the standard says.
    fn guide_figures(&self) -> Vec<(Figure, String)> {
        let study = self.pass.study;
        let ends = [0.9 * study.receivers[0], 1.1 * study.farthest()];
        let picture = |m: usize, name: &str, quantities: &[Quantity], level: bool| {
            let convert = |v: f64| if level { 20.0 * (v / Reference::VdB.velocity()).log10() } else { v };
            let measure = &MEASURES[m];
            let unit = if level { "VdB re 1 µin/s" } else { measure.unit() };
            let y_label = format!("{} [{}]", measure.symbol, if unit == "1" { "-" } else { unit });
            let title = format!("{} against distance, {}", measure.symbol, speed_text(study.speed));
            let labels = ("distance from the centre line [m]", y_label.as_str());
            let mut picture = figure(format!("free_field_{name}"), title, labels, true);
            picture.log_y = !level;
            let points = |name: &str, pick: fn((f64, f64, f64)) -> f64, stroke| Series {
                name: name.into(),
                x: study.receivers.clone(),
                y: (0..study.receivers.len()).map(|r| convert(pick(self.metrics.spread(m, r)))).collect(),
                stroke,
            };
            if self.histories.len() > 1 {
                picture.series.push(points("mean of the profiles", |s| s.0, Stroke::Solid));
                picture.series.push(points("largest of the profiles", |s| s.2, Stroke::Points));
            } else {
                picture.series.push(points(measure.symbol, |s| s.0, Stroke::Solid));
            }
            let mut notes = Vec::new();
            for guide in quantities.iter().flat_map(|q| guide_values(*q)) {
                let name = format!("{}: {}", guide.standard.split(':').next().unwrap_or(""), guide.name);
                notes.push(format!("{}, {}: {} ({})", guide.standard, guide.name, guide.value, guide.note));
                // one line for those that coincide, as far as a legend is wide
                let same = |s: &&mut Series| {
                    s.stroke == Stroke::Dashed && s.y == [guide.value; 2] && s.name.len() + name.len() < 90
                };
                match picture.series.iter_mut().find(same) {
                    Some(line) => line.name = format!("{}; {name}", line.name),
                    None => picture.series.push(Series {
                        name,
                        x: ends.to_vec(),
                        y: vec![guide.value; 2],
                        stroke: Stroke::Dashed,
                    }),
                }
            }
            let caption = format!(
                "{}, on the ground's surface without a building; guide values, which hold inside buildings, are drawn to compare, not to judge: {}.",
                measure.what,
                notes.join("; ")
            );
            (Figure::Lines(picture), caption)
        };
        vec![
            picture(KB_F_MAXIMUM, "kb_distance", &[Quantity::KbFMaximum, Quantity::VMaximum], false),
            picture(V_SLOW_MAXIMUM, "level_distance", &[Quantity::VelocityLevel(Reference::VdB)], true),
            picture(VDV, "vdv_distance", &[Quantity::VibrationDose], false),
        ]
    }

    /// What the histories may be doubted for.
    pub(super) fn concerns(&self) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let left = |history: &Array2<f64>| {
            let rows = history.rows().into_iter().map(|row| {
                let end = (row.len() / 50).max(1);
                let size =
                    |values: &mut dyn Iterator<Item = &f64>| values.fold(0.0f64, |m, v| m.max(v.abs()));
                let ends = size(&mut row.iter().take(end)).max(size(&mut row.iter().rev().take(end)));
                ends / size(&mut row.iter()).max(f64::MIN_POSITIVE)
            });
            rows.fold(0.0, f64::max)
        };
        let left = self.histories.iter().map(left).fold(0.0, f64::max);
        if left > LEFT && self.pass.study.roughness.is_some() {
            concerns.push(Concern::new(
                "history-ends",
                format!(
                    "{:.0} % of the peak velocity are left at the ends of a history: as much of what comes earlier or later is folded into it",
                    100.0 * left
                ),
                "waves fade slowly there (light damping, far receivers); bands of a spectrum's expected value are free of it",
            ));
        }
        if let Some(Irregularity::Given { profile, carrier, .. }) =
            self.pass.study.roughness.as_ref().map(|r| &r.irregularity)
        {
            let way = self.pass.study.speed * self.times.period() + self.pass.train.length();
            // what repeats by itself, as a wheel and a sinusoid do, may
            if *carrier == Carrier::Rail && profile.components().len() > 1 && profile.repeat_length() < way {
                concerns.push(Concern::new(
                    "profile-repeats",
                    format!(
                        "the profile is {:.0} m long and repeats; the train runs {way:.0} m in the histories",
                        profile.repeat_length()
                    ),
                    "measure a longer profile; the middle of it lies abreast of the receivers, where it matters most",
                ));
            }
        }
        concerns
    }
}

impl FreeField {
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
        let (low, high) = roughness.irregularity.wavenumbers();
        let (shortest, longest) = (TAU / high, TAU / low);
        if let Irregularity::Random { spectrum, .. } = &roughness.irregularity
            && let Some((least, most)) = spectrum.valid()
            && (shortest < 0.999 * least || longest > 1.001 * most)
        {
            concerns.push(Concern::new(
                "spectrum-range",
                format!(
                    "wavelengths {shortest:.4} to {longest:.4} m go beyond those for which the spectrum is published, {least} to {most} m"
                ),
                "narrow irregularity.wavelengths, or read the bands driven by them as extrapolated",
            ));
        }
        let (low, high) = (self.speed / longest, self.speed / shortest);
        // a given profile drives what it drives
        if matches!(roughness.irregularity, Irregularity::Random { .. })
            && let (Some(first), Some(last)) = (self.bands.first(), self.bands.last())
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
