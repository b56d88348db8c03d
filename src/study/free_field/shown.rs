//! What a reader sees of the free field: answers and pictures.

use super::components::COMPONENTS_TABLE;
use super::metrics::{MEASURES, Measured, V_SLOW_MAXIMUM, estimated, significant, told};
use super::pictures::{band_figure, figure, seen, steps};
use super::{Irregularity, PassVelocities};
use crate::assessment::{Band, Level, Reference};
use crate::figure::{Figure, Series, Stroke};
use crate::study::{Answer, Cells, StudyError, speed_text};
use ndarray::Array2;

impl PassVelocities<'_> {
    /// R.m.s. of the profile; levels, strongest bands, where the dynamic part takes over, and measures, for each receiver.
    pub(super) fn answers(&self, velocities: &[Array2<f64>; 3]) -> Result<Vec<Answer>, StudyError> {
        let mut answers: Vec<Answer> = self.profile_answer().into_iter().collect();
        for (r, y) in self.study.receivers.iter().enumerate() {
            answers.push(self.level_answer(velocities, r, *y)?);
            answers.extend(self.band_answers(velocities, r, *y));
            for m in told(&self.study.assessment.guides) {
                answers.push(self.measure_answer(m, r, *y, ("", "", &self.metrics.measured))?);
            }
            for estimate in &self.estimates {
                for m in told(&self.study.assessment.guides) {
                    let place = (estimate.place, estimate.place, &estimate.measured);
                    answers.push(self.measure_answer(m, r, *y, place)?);
                }
            }
            answers.extend(self.component_answers(r, *y)?);
            answers.extend(self.noise_answer(&velocities[2], r, *y));
            answers.extend(self.day_answers(r, *y));
        }
        if self.study.receivers.len() == 1 {
            answers.iter_mut().for_each(|answer| answer.cells = None);
        }
        Ok(answers)
    }

    /// `columns` of the row of the receiver at `y` m in the table called `table`.
    pub(super) fn row<const N: usize>(table: String, y: f64, columns: [(&str, String); N]) -> Cells {
        let columns = columns.map(|(heading, text)| (heading.to_owned(), text)).to_vec();
        Cells { table, of: "distance [m]", row: format!("{y}"), columns }
    }

    /// The table of velocities of the open ground.
    pub(super) fn velocities_table(&self) -> String {
        format!("R.m.s. velocity over {:.2} s, open ground", self.passage_time)
    }

    fn profile_answer(&self) -> Option<Answer> {
        let irregularity = &self.study.roughness.as_ref()?.irregularity;
        let what = match irregularity {
            Irregularity::Random { wavelengths: (from, to), .. } => {
                format!("R.m.s. of the profile, wavelengths {from} to {to} m")
            }
            Irregularity::Given { .. } => "R.m.s. of the profile".into(),
        };
        let sigma = irregularity.rms();
        Some(Answer::new("profile_rms", what, sigma, "m", format!("{:.3} mm", 1e3 * sigma)))
    }

    fn level_answer(&self, velocities: &[Array2<f64>; 3], r: usize, y: f64) -> Result<Answer, StudyError> {
        let broadband = |v: &Array2<f64>| v.row(r).iter().map(|v| v * v).sum::<f64>().sqrt();
        let [quasi_static, dynamic, value] = [0, 1, 2].map(|part| broadband(&velocities[part]));
        let level = if value > 0.0 { Some(Level::of(value, Reference::Iso1683)?) } else { None };
        let nothing = || "less than 1e-10 of what the track feels arrives".to_owned();
        let what = format!("R.m.s. velocity at {y} m over {:.2} s, all bands", self.passage_time);
        let [whole, smooth, rough] = [value, quasi_static, dynamic].map(|v| significant(1e3 * v));
        let said = level.map_or_else(nothing, |level| level.to_string());
        let shown = format!("{whole} mm/s (quasi-static {smooth}, dynamic {rough}), {said}");
        let heading = format!("level [{}]", Reference::Iso1683.name());
        let level = level.map_or_else(nothing, |level| format!("{:.1}", level.decibels));
        let columns = [
            ("v_rms [mm/s]", whole),
            ("quasi-static [mm/s]", smooth),
            ("dynamic [mm/s]", rough),
            (&heading, level),
        ];
        let answer = Answer::new(&format!("v_rms_{y}"), what, value, "m/s", shown);
        Ok(answer.in_table(Self::row(self.velocities_table(), y, columns)))
    }

    /// The strongest band, and the first from which on the dynamic part prevails.
    fn band_answers(
        &self,
        [quasi_static, dynamic, total]: &[Array2<f64>; 3],
        r: usize,
        y: f64,
    ) -> Vec<Answer> {
        let study = self.study;
        let answer = |key: &str, what: &str, band: Band, shown: String| {
            Answer::new(&format!("{key}_{y}"), format!("{what} at {y} m"), band.centre(), "Hz", shown)
        };
        let row = total.row(r);
        let top = (0..row.len()).max_by(|&a, &b| row[a].total_cmp(&row[b])).unwrap_or(0);
        let peak = study.bands[top];
        let strongest = significant(1e3 * row[top]);
        let shown = format!("{} Hz, {strongest} mm/s", peak.label());
        let columns = [("strongest band [Hz]", peak.label()), ("there [mm/s]", strongest)];
        let strongest = answer("peak_band", "Strongest band", peak, shown);
        let mut answers = vec![strongest.in_table(Self::row(self.velocities_table(), y, columns))];
        let last = (0..row.len()).rev().find(|&b| quasi_static[(r, b)] > dynamic[(r, b)]);
        if let Some(crossing) = last.filter(|b| b + 1 < row.len() && study.roughness.is_some()) {
            let band = study.bands[crossing + 1];
            let what = "Band from which on the dynamic part prevails";
            let columns = [("dynamic part prevails from [Hz]", band.label())];
            let crossing = answer("crossing_band", what, band, format!("{} Hz", band.label()));
            answers.push(crossing.in_table(Self::row(self.velocities_table(), y, columns)));
        }
        answers
    }

    /// The table of measures of one pass.
    pub(super) fn measures_table(&self, of: &str) -> String {
        let spread = match self.histories.len() {
            1 => String::new(),
            count => format!(": mean (least to largest of {count} profiles)"),
        };
        format!("Measures of one pass, {of}{spread}")
    }

    /// Measure number `m` at a place or of a component, with its key and words: its mean over the profiles, and from where to where it
    /// reaches.
    pub(super) fn measure_answer(
        &self,
        m: usize,
        r: usize,
        y: f64,
        (key, words, measured): (&str, &str, &Measured),
    ) -> Result<Answer, StudyError> {
        let measure = &MEASURES[m];
        let (mean, least, most) = measured.spread(m, r);
        let (mut shown, mut cell) = (measure.shown(mean), measure.number(mean));
        let component = ["along", "across", "largest"].contains(&key);
        let (table, said) = match key {
            "" => (self.measures_table("vertical, open ground"), String::new()),
            _ if component => (self.measures_table(COMPONENTS_TABLE), format!(", {words}")),
            _ => (self.measures_table(&format!("vertical, {words}, estimate")), estimated(words)),
        };
        if self.histories.len() > 1 {
            let (least, most) = (measure.number(least), measure.number(most));
            shown = format!("{shown}, {least} to {most} in {} profiles", self.histories.len());
            cell = format!("{cell} ({least} to {most})");
        }
        if m == V_SLOW_MAXIMUM && mean > 0.0 {
            shown = format!("{shown}; {}", Level::of(mean, Reference::VdB)?);
        }
        let what = format!("{} at {y} m{said}", measure.symbol);
        let key = if key.is_empty() { measure.key.to_owned() } else { format!("{}_{key}", measure.key) };
        let symbol =
            if component { format!("{}, {words}", measure.symbol) } else { measure.symbol.to_owned() };
        let heading = match measure.unit() {
            "1" => symbol,
            "m/s" => format!("{symbol} [mm/s]"),
            unit => format!("{symbol} [{unit}]"),
        };
        let answer = Answer::new(&format!("{key}_{y}"), what, mean, measure.unit(), shown);
        Ok(answer.in_table(Self::row(table, y, [(&heading, cell)])))
    }

    /// Which profile the histories belong to.
    pub(super) fn which(&self) -> String {
        match self.study.roughness.as_ref().map(|r| &r.irregularity) {
            None => "Smooth rail.".into(),
            Some(Irregularity::Random { spectrum, seed, .. }) => {
                format!("One profile out of many, seed {seed}; {}.", spectrum.text())
            }
            Some(Irregularity::Given { text, .. }) => format!("Profile: {text}."),
        }
    }

    /// Bands of each receiver and of all, velocity against distance, contact force, histories, measures beside guide values.
    ///
    /// # Errors
    /// A passage time that is not positive.
    pub(super) fn figures(&self, velocities: &[Array2<f64>; 3]) -> Result<Vec<(Figure, String)>, StudyError> {
        let mut figures = self.band_figures(velocities);
        figures.extend(self.building_figures(&velocities[2]));
        figures.extend(self.profile_figures());
        figures.extend(self.force_figure());
        figures.extend(self.history_figures());
        figures.extend(self.component_figures()?);
        figures.extend(self.guide_figures());
        figures.extend(self.day_figures());
        Ok(figures)
    }

    fn band_figures(&self, velocities: &[Array2<f64>; 3]) -> Vec<(Figure, String)> {
        let study = self.study;
        let (at, levels) = (speed_text(study.speed), study.assessment.levels);
        let row = |v: &Array2<f64>, r: usize| v.row(r).to_vec();
        let largest = |v: &mut dyn Iterator<Item = &f64>| v.fold(0.0, |m: f64, v| m.max(*v));
        let names = [("quasi-static", Stroke::Dashed), ("dynamic", Stroke::Points), ("total", Stroke::Solid)];
        let rough = study.roughness.is_some();
        let mut figures = Vec::new();
        for (r, y) in study.receivers.iter().enumerate() {
            let (name, title) = (format!("free_field_{y}"), format!("Ground velocity at {y} m, {at}"));
            let mut picture = band_figure(name, title, &study.bands, levels);
            let most = largest(&mut velocities[2].row(r).iter());
            for (&(name, stroke), v) in names.iter().zip(velocities) {
                if rough || name == "total" {
                    picture.series.push(steps(name.into(), &study.bands, &row(v, r), (stroke, levels, most)));
                }
            }
            let caption = format!(
                "Vertical velocity of the ground's surface {y} m from the centre line, unweighted r.m.s. over {:.2} s in one-third-octave \
                 bands.",
                self.passage_time
            );
            figures.push((Figure::Lines(picture), caption));
        }
        let title = format!("Ground velocity, {at}");
        let mut picture = band_figure("free_field_receivers".into(), title, &study.bands, levels);
        let all = largest(&mut velocities[2].iter());
        picture.series = (study.receivers.iter().enumerate())
            .map(|(r, y)| {
                steps(format!("{y} m"), &study.bands, &row(&velocities[2], r), (Stroke::Solid, levels, all))
            })
            .collect();
        figures.push((Figure::Lines(picture), "Total of all receivers.".into()));
        if study.receivers.len() > 1 {
            let sums = |v: &Array2<f64>| {
                let sum = |r| 1e3 * row(v, r).iter().map(|v| v * v).sum::<f64>().sqrt();
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
        let roughness = self.study.roughness.as_ref().filter(|_| !self.driven.is_empty())?;
        let (label, stroke) = match &roughness.irregularity {
            Irregularity::Random { .. } => ("√ of one-sided spectral density [kN/√Hz]", Stroke::Solid),
            Irregularity::Given { .. } => ("amplitude [kN]", Stroke::Points),
        };
        let largest = self.driven.iter().map(|d| d.force).fold(0.0, f64::max);
        let (x, y) = self.driven.iter().map(|d| (d.frequency, 1e-3 * seen(d.force, largest))).unzip();
        let title = format!("Dynamic wheel-rail force, {}", speed_text(self.study.speed));
        let mut picture = figure("contact_force".into(), title, ("driving frequency v/λ [Hz]", label), true);
        picture.series = vec![Series { name: "leading wheelset".into(), x, y, stroke }];
        let caption =
            format!("Force of the leading wheelset on the rail; profile: {}.", roughness.irregularity.text());
        Some((Figure::Lines(picture), caption))
    }

    /// First and one after the last sample at which KB_F is above 2 % of its largest value anywhere.
    pub(super) fn felt(&self) -> (usize, usize) {
        let kb_f = &self.metrics.kb_f;
        let least = 0.02 * kb_f.iter().copied().fold(0.0, f64::max);
        let felt = |i: &usize| kb_f.column(*i).iter().any(|kb| *kb > least);
        let count = kb_f.ncols();
        let first = (0..count).find(felt).unwrap_or(0);
        (first, (first..count).rev().find(felt).map_or(count, |last| last + 1))
    }

    fn history_figures(&self) -> Vec<(Figure, String)> {
        let study = self.study;
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
            picture.series.push(series("quasi-static", &self.quasi_static, Stroke::Dashed));
            figures.push((Figure::Lines(picture), format!("Vertical velocity. {}", self.which())));
        }
        let title = format!("KB_F(t), {at}");
        let mut picture = figure("free_field_kb".into(), title, (axis, "KB_F [-]"), false);
        let (from, to) = self.felt();
        picture.series = study
            .receivers
            .iter()
            .enumerate()
            .map(|(r, y)| Series {
                name: format!("{y} m"),
                x: time[from..to].to_vec(),
                y: self.metrics.kb_f.row(r).to_vec()[from..to].to_vec(),
                stroke: Stroke::Solid,
            })
            .collect();
        let caption = "Weighted vibration severity of the ground's surface after DIN 45669-1, FAST.";
        figures.push((Figure::Lines(picture), format!("{caption} {}", self.which())));
        figures
    }
}
