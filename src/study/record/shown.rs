//! What a reader sees of a record.

use super::{Channel, Judged, MeasuredHistory, closest};
use crate::assessment::{Averaging, Band, Guide, Level, Reference};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::Answer;
use crate::study::free_field::assessed::OnePass;
use crate::study::free_field::metrics::{
    KB_F_MAXIMUM, KB_PASS, MEASURES, PEAK_TO_315, V_SLOW_MAXIMUM, VDV, significant, told,
};
use crate::study::free_field::pictures::{band_figure, steps};
use ndarray::{Array1, Array2};

/// Reference of the levels of third octaves unless told otherwise, as DIN 45672-2 has it.
const LEVELS: Reference = Reference::German;

impl MeasuredHistory {
    /// Measures of each direction, the directions together, whole days.
    pub(super) fn answers(&self, judged: &[Judged]) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (channel, found) in self.channels.iter().zip(judged) {
            let name = &channel.name;
            for m in told(&self.assessment.guides) {
                let (measure, value) = (&MEASURES[m], found.measures[m]);
                let mut shown = measure.shown(value);
                if m == V_SLOW_MAXIMUM
                    && let Ok(level) = Level::of(value, Reference::VdB)
                {
                    shown = format!("{shown}; {level}");
                }
                let key = format!("{}_{}", measure.key, plain(name));
                answers.push(Answer::new(
                    &key,
                    format!("{} of {name}", measure.symbol),
                    value,
                    measure.unit(),
                    shown,
                ));
            }
            let (from, to) = found.spectrum.passage;
            let what = format!("Passage T₂ of {name}");
            let shown =
                format!("{:.2} s, from {:.2} to {:.2} s", to - from, self.first + from, self.first + to);
            answers.push(Answer::new(&format!("passage_time_{}", plain(name)), what, to - from, "s", shown));
        }
        answers.extend(self.building_answer(judged));
        answers.extend(self.day_answers(judged));
        answers
    }

    /// The direction that comes closest to the guide values of DIN 4150-3, beside them.
    fn building_answer(&self, judged: &[Judged]) -> Option<Answer> {
        if !self.assessment.asks(Guide::Din4150Part3) {
            return None;
        }
        let peaks: Vec<(f64, f64)> = judged.iter().map(|j| (j.measures[PEAK_TO_315], j.dominant)).collect();
        let (worst, guide) = closest(&peaks)?;
        let (peak, frequency) = peaks[worst];
        let [commercial, dwellings, sensitive] = guide.map(|v| significant(1e3 * v));
        let shown = format!(
            "{} mm/s of {} at {frequency:.1} Hz (DIN 4150-3, foundation, short-term: commercial {commercial}, dwellings {dwellings}, \
             sensitive {sensitive} mm/s)",
            significant(1e3 * peak),
            self.channels[worst].name
        );
        let what = format!("Largest of {} directions, 1 to 315 Hz", judged.len());
        Some(Answer::new("peak_velocity_of_directions", what, peak, "m/s", shown))
    }

    /// Whole days, by the direction that is largest in each measure.
    fn day_answers(&self, judged: &[Judged]) -> Vec<Answer> {
        let most = |m: usize| judged.iter().map(|j| j.measures[m]).fold(0.0, f64::max);
        let one = OnePass { kb_f_maximum: most(KB_F_MAXIMUM), kb_pass: most(KB_PASS), dose: most(VDV) };
        self.assessment.day_answers(one, 0, "", ", the largest direction")
    }

    /// Histories, measures and third octaves.
    pub(super) fn group(&self, judged: &[Judged], bands: &[Band]) -> Group {
        let velocity = &self.channels[0].velocity;
        let (count, step) = (velocity.values().len(), velocity.step());
        let times: Vec<f64> = (0..count).map(|i| self.first + step * i as f64).collect();
        let numbers: Vec<f64> = (0..judged.len()).map(|i| i as f64).collect();
        let centres: Vec<f64> = bands.iter().map(|band| band.centre()).collect();
        let names: Vec<&str> = self.channels.iter().map(|c| c.name.as_str()).collect();
        let over_time = |of: &dyn Fn(usize) -> Vec<f64>| {
            let rows: Vec<Vec<f64>> = (0..judged.len()).map(of).collect();
            Array2::from_shape_fn((judged.len(), count), |(d, i)| rows[d][i]).into_dyn()
        };
        let octaves = |of: fn(&Judged) -> &[f64]| {
            Array2::from_shape_fn((judged.len(), bands.len()), |(d, b)| of(&judged[d])[b]).into_dyn()
        };
        let (time, band) = (["direction", "time"], ["direction", "band"]);
        let mut group = Group::new("record")
            .coordinate("direction", &numbers, "1", "number of the direction")
            .coordinate("time", &times, "s", "time of the record")
            .coordinate("band", &centres, "Hz", "exact centre of the base-10 third-octave band")
            .attribute("directions", names.join(", "))
            .variable(
                "velocity",
                &time,
                over_time(&|d| self.channels[d].velocity.values().to_vec()),
                "m s-1",
                "velocity less its mean",
            )
            .variable("kb_f", &time, over_time(&|d| judged[d].kb_f.values().to_vec()), "1", "KB_F(t)")
            .variable(
                "v_interval",
                &band,
                octaves(|j| &j.spectrum.interval),
                "m s-1",
                "running r.m.s. FAST of the band, r.m.s. over the passage (DIN 45672-2, interval)",
            )
            .variable(
                "v_max_hold",
                &band,
                octaves(|j| &j.spectrum.max_hold),
                "m s-1",
                "running r.m.s. FAST of the band, its largest value (DIN 45672-2, max hold)",
            );
        for (m, measure) in MEASURES.iter().enumerate() {
            let values = judged.iter().map(|j| j.measures[m]).collect::<Array1<f64>>().into_dyn();
            let what = measure.what.replace("W_b,", "W_b vertically, W_d horizontally,");
            group = group.variable(measure.key, &["direction"], values, measure.units, &what);
        }
        group
    }

    /// Histories, KB_F(t), third octaves.
    pub(super) fn figures(&self, judged: &[Judged], bands: &[Band]) -> Vec<(Figure, String)> {
        let step = self.channels[0].velocity.step();
        let curve = |name: &str, values: &[f64], scale: f64| Series {
            name: name.to_owned(),
            x: (0..values.len()).map(|i| self.first + step * i as f64).collect(),
            y: values.iter().map(|v| scale * v).collect(),
            stroke: Stroke::Solid,
        };
        let mut figures = Vec::new();
        for Channel { name, velocity, .. } in &self.channels {
            let file = format!("record_{}", plain(name));
            let mut picture =
                LineFigure::new(file, format!("Velocity, {name}"), "time [s]", "velocity [mm/s]");
            picture.series.push(curve(name, velocity.values(), 1e3));
            figures.push((Figure::Lines(picture), "The record, less its mean.".to_owned()));
        }
        let mut picture = LineFigure::new("record_kb", "KB_F(t)", "time [s]", "KB_F [-]");
        let each = || self.channels.iter().zip(judged);
        picture.series = each().map(|(c, j)| curve(&c.name, j.kb_f.values(), 1.0)).collect();
        let averaging = Averaging::Fast.name();
        figures.push((
            Figure::Lines(picture),
            format!("Weighted vibration severity after DIN 45669-1, {averaging}."),
        ));
        for (Channel { name, .. }, found) in each() {
            let file = format!("record_bands_{}", plain(name));
            let levels = Some(self.assessment.levels.unwrap_or(LEVELS));
            let mut picture = band_figure(file, format!("Third octaves, {name}"), bands, levels);
            let spectrum = &found.spectrum;
            let largest = spectrum.max_hold.iter().copied().fold(0.0, f64::max);
            for (what, values, stroke) in [
                ("interval", &spectrum.interval, Stroke::Solid),
                ("max hold", &spectrum.max_hold, Stroke::Dashed),
            ] {
                picture.series.push(steps(what.into(), bands, values, (stroke, levels, largest)));
            }
            let caption = "Running r.m.s. FAST of each band: its r.m.s. over the passage, and its largest value (DIN 45672-2).";
            figures.push((Figure::Lines(picture), caption.to_owned()));
        }
        figures
    }

    /// What the record may be doubted for.
    pub(super) fn concerns(&self) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let velocity = &self.channels[0].velocity;
        if velocity.duration() < 4.0 {
            concerns.push(Concern::new(
                "short-record",
                format!(
                    "the record lasts {:.2} s: bands at 1 Hz need some 4 s to settle",
                    velocity.duration()
                ),
                "take a longer record, or read the lowest bands with care",
            ));
        }
        let rate = 1.0 / velocity.step();
        if rate < 250.0 {
            concerns.push(Concern::new(
                "slow-sampling",
                format!(
                    "{rate:.0} samples a second hold frequencies below {:.0} Hz alone; KB reaches to 80 Hz",
                    0.5 * rate
                ),
                "sample at 250 Hz and more",
            ));
        }
        for Channel { name, velocity, .. } in &self.channels {
            let values = velocity.values();
            let end = (values.len() / 50).max(1);
            let size = |part: &[f64]| part.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let left = size(&values[..end]).max(size(&values[values.len() - end..])) / velocity.peak();
            if left > 0.3 {
                concerns.push(Concern::new(
                    "record-ends",
                    format!(
                        "{:.0} % of the peak of {name} are left at an end of the record: it cuts the passage",
                        100.0 * left
                    ),
                    "take the whole passage, with quiet before and after it",
                ));
            }
        }
        if self.channels.len() < 3 {
            concerns.push(Concern::new(
                "directions",
                format!("{} of three directions were measured", self.channels.len()),
                "DIN 4150-2, DIN 4150-3 and NS 8176 take the largest of three",
            ));
        }
        concerns
    }
}

/// A name as a key: letters, digits and `_`.
fn plain(name: &str) -> String {
    let text: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
    text.trim_matches('_').to_owned()
}
