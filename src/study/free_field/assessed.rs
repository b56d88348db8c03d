//! Whole days: what all passes of a day and of a night come to, beside the guide values for them.

use super::PassVelocities;
use super::guides::{draw, list, of_quantities};
use super::metrics::{KB_F_MAXIMUM, KB_PASS, LARGEST, VDV, estimated, significant, where_text};
use super::pictures::figure;
use crate::assessment::{
    Area, CLOCK, Exposure, Guide, GuideValue, Line, Period, Quantity, Reference, all_guide_values,
    combined_dose, kb_rating,
};
use crate::figure::{Figure, Series, Stroke};
use crate::study::Answer;
use schemars::JsonSchema;
use serde::Deserialize;

/// How often the train passes.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(deny_unknown_fields)]
pub struct Passes {
    /// During the 16 h of the day.
    #[serde(default)]
    pub day: u32,
    /// During the 8 h of the night.
    #[serde(default)]
    pub night: u32,
}

impl Passes {
    /// How often by day or by night.
    pub fn during(self, period: Period) -> u32 {
        match period {
            Period::Day => self.day,
            Period::Night => self.night,
        }
    }
}

/// Another train of the same days, by what one pass of it is at each receiver.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct OtherTrain {
    /// What it is.
    pub name: String,
    /// How often it passes.
    pub passes: Passes,
    /// KB_FTm at each receiver, of trains that occupy one interval of 30 s; of longer ones `kb_pass` of their own case.
    pub kb_ftm: Vec<f64>,
    /// VDV of one pass at each receiver [m/s^1.75]; left out of the doses where it is not given.
    #[serde(default)]
    pub vdv: Vec<f64>,
}

/// What the free field is held against.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assessment {
    /// Whose guide values; none: all that there are.
    pub guides: Vec<Guide>,
    /// Kind of area.
    pub area: Area,
    /// Kind of line.
    pub line: Line,
    /// Passes of the train; None: one pass alone is looked at.
    pub passes: Option<Passes>,
    /// Other trains of the same days, known by their own cases.
    pub others: Vec<OtherTrain>,
    /// Pictures of third octaves show levels over this; None: velocities.
    pub levels: Option<Reference>,
}

impl Assessment {
    /// Whether `guide` is asked for.
    pub fn asks(&self, guide: Guide) -> bool {
        self.guides.is_empty() || self.guides.contains(&guide)
    }

    /// The guide values asked for.
    pub fn guide_values(&self) -> Vec<GuideValue> {
        let mut values = all_guide_values(self.area, self.line);
        values.retain(|value| self.asks(value.guide));
        values
    }
}

const PERIODS: [Period; 2] = [Period::Day, Period::Night];

/// KB_FTr in a `period` of trains, each with √Σ KB²_FTi of one pass and how often it passes.
///
/// Each pass occupies its intervals of 30 s: KB_FTr = √( Σ n 30 s Σ KB²_FTi / T_r ), DIN 4150-2:1999, (A.3).
fn rating(trains: &[(f64, u32)], period: Period) -> f64 {
    let exposure = |&(kb_pass, passes): &(f64, u32)| Exposure {
        kb_ftm: kb_pass,
        time: CLOCK * f64::from(passes),
        at_rest: false,
    };
    kb_rating(&trains.iter().map(exposure).collect::<Vec<_>>(), period)
}

/// VDV of trains, each with the dose of one pass and how often it passes.
fn dose(trains: &[(f64, u32)]) -> f64 {
    combined_dose(&trains.iter().map(|(one, passes)| (*one, f64::from(*passes))).collect::<Vec<_>>())
}

/// What one pass brings to a day.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct OnePass {
    /// The largest KB_Fmax there is.
    pub kb_f_maximum: f64,
    /// √Σ KB²_FTi
    pub kb_pass: f64,
    /// VDV [m/s^1.75]
    pub dose: f64,
}

impl Assessment {
    /// `own` of one pass and how often it passes in a `period`, then the `other` trains at receiver number `r`.
    fn trains(
        &self,
        own: f64,
        other: fn(&OtherTrain) -> &[f64],
        r: usize,
        period: Period,
    ) -> Vec<(f64, u32)> {
        let passes = self.passes.unwrap_or_default();
        let others = self.others.iter().filter_map(|o| Some((*other(o).get(r)?, o.passes.during(period))));
        std::iter::once((own, passes.during(period))).chain(others).collect()
    }

    /// How many trains pass in a `period`.
    fn count(&self, period: Period) -> u32 {
        let own = self.passes.unwrap_or_default().during(period);
        own + self.others.iter().map(|o| o.passes.during(period)).sum::<u32>()
    }

    /// KB_FTr and VDV of day and night, keys ending in `suffix`, of passes `at` receiver number `r`; none where no passes are given.
    pub(in crate::study) fn day_answers(
        &self,
        one: OnePass,
        r: usize,
        suffix: &str,
        at: &str,
    ) -> Vec<Answer> {
        if self.passes.is_none() {
            return Vec::new();
        }
        let others = self.others.iter().filter_map(|o| o.kb_ftm.get(r).copied());
        let kb_f_maximum = others.fold(one.kb_f_maximum, f64::max);
        let mut answers = Vec::new();
        for period in PERIODS {
            let (count, name) = (self.count(period), period.name());
            let what = |symbol: &str| format!("{symbol} of {count} passes by {name}{at}");
            if self.asks(Guide::Din4150Part2) {
                let value = rating(&self.trains(one.kb_pass, |o| &o.kb_ftm, r, period), period);
                let shown = self.kb_text(kb_f_maximum, value, period);
                answers.push(Answer::new(
                    &format!("kb_ftr_{name}{suffix}"),
                    what("KB_FTr"),
                    value,
                    "1",
                    shown,
                ));
            }
            if self.asks(Guide::Bs6472Part1) {
                let value = dose(&self.trains(one.dose, |o| &o.vdv, r, period));
                let key = format!("vdv_{name}{suffix}");
                answers.push(Answer::new(&key, what("VDV"), value, "m/s^1.75", dose_text(value, period)));
            }
        }
        answers
    }
}

impl PassVelocities<'_> {
    fn rating(&self, r: usize, period: Period) -> f64 {
        let one = self.judged().1.mean_of_powers(KB_PASS, r, 2);
        rating(&self.study.assessment.trains(one, |o| &o.kb_ftm, r, period), period)
    }

    fn dose(&self, r: usize, period: Period) -> f64 {
        let one = self.judged().1.mean_of_powers(VDV, r, 4);
        dose(&self.study.assessment.trains(one, |o| &o.vdv, r, period))
    }

    /// KB_FTr and VDV of day and night at receiver number `r`, `y` m from the track.
    pub(super) fn day_answers(&self, r: usize, y: f64) -> Vec<Answer> {
        let (place, measured) = self.judged();
        let one = OnePass {
            kb_f_maximum: measured.spread(KB_F_MAXIMUM, r).2,
            kb_pass: measured.mean_of_powers(KB_PASS, r, 2),
            dose: measured.mean_of_powers(VDV, r, 4),
        };
        let place = match place {
            "" => ", open ground".to_owned(),
            LARGEST => format!(", open ground, {LARGEST}"),
            place => estimated(place),
        };
        let at = format!(" at {y} m{place}");
        let answers = self.study.assessment.day_answers(one, r, &format!("_{y}"), &at);
        let in_table = |answer: Answer| {
            let columns = [(answer.what.trim_end_matches(&at), answer.shown.clone())];
            let cells = Self::row(format!("Whole days{place}"), y, columns);
            answer.in_table(cells)
        };
        answers.into_iter().map(in_table).collect()
    }

    /// KB_FTr and VDV of days and nights against distance.
    pub(super) fn day_figures(&self) -> Vec<(Figure, String)> {
        let assessment = &self.study.assessment;
        if assessment.passes.is_none() {
            return Vec::new();
        }
        let receivers = &self.study.receivers;
        let values = assessment.guide_values();
        type Of<'a> = &'a dyn Fn(usize, Period) -> f64;
        let picture = |name: &str, quantity: Quantity, unit: &str, of: Of| {
            let title = format!("{} of whole days against distance", quantity.name());
            let label = format!("{} [{unit}]", quantity.name());
            let mut picture = figure(
                format!("free_field_{name}"),
                title,
                ("distance from the centre line [m]", &label),
                true,
            );
            for (period, stroke) in PERIODS.into_iter().zip([Stroke::Solid, Stroke::Points]) {
                picture.series.push(Series {
                    name: format!("{}, {} passes", period.name(), assessment.count(period)),
                    x: receivers.clone(),
                    y: (0..receivers.len()).map(|r| of(r, period)).collect(),
                    stroke,
                });
            }
            let lines = of_quantities(&values, &[quantity]);
            draw(&lines, &mut picture);
            let caption = format!(
                "{}, {}; guide values, which hold inside buildings, are drawn to compare, not to judge: {}.",
                quantity_text(quantity),
                where_text(self.judged().0),
                list(&lines)
            );
            (Figure::Lines(picture), caption)
        };
        let mut figures = Vec::new();
        if assessment.asks(Guide::Din4150Part2) {
            let of = |r, period| self.rating(r, period);
            figures.push(picture("kb_ftr_distance", Quantity::KbFRating, "-", &of));
        }
        if assessment.asks(Guide::Bs6472Part1) {
            let of = |r, period| self.dose(r, period);
            figures.push(picture("vdv_day_distance", Quantity::VibrationDose, "m/s^1.75", &of));
        }
        figures
    }
}

fn quantity_text(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::KbFRating => {
            "KB_FTr of all passes over 16 h of the day and 8 h of the night (DIN 4150-2 takes the largest of three \
             directions; hours of rest are not counted twice for railways)"
        }
        _ => {
            "Vibration dose of all passes over 16 h of the day and 8 h of the night, W_b vertically, W_d horizontally"
        }
    }
}

impl Assessment {
    /// KB_FTr with what DIN 4150-2, 6.2 and 6.5.3 ask of it: KB_Fmax against A_u first, then KB_FTr against A_r.
    fn kb_text(&self, kb_f_maximum: f64, kb_ftr: f64, period: Period) -> String {
        let at = self.area.kb(self.line, period);
        let [value, most, lower, rating] = [kb_ftr, kb_f_maximum, at.lower, at.rating].map(significant);
        let outcome = if kb_f_maximum <= at.lower {
            format!("met: KB_Fmax {most} is not above A_u {lower}")
        } else if kb_ftr <= at.rating {
            format!("met: not above A_r {rating}; KB_Fmax {most} is above A_u {lower}")
        } else {
            format!("not met: above A_r {rating}; KB_Fmax {most} is above A_u {lower}")
        };
        format!("{value} (DIN 4150-2, {}, {}: {outcome})", self.area.name(), period.name())
    }
}

/// VDV with what BS 6472-1 says of it by day.
fn dose_text(value: f64, period: Period) -> String {
    let shown = format!("{} m/s^1.75", significant(value));
    match period {
        Period::Night => shown,
        Period::Day => {
            let says = match value {
                v if v < 0.2 => "below 0.2: adverse comment is not expected",
                v if v <= 0.4 => "0.2 to 0.4: low probability of adverse comment",
                _ => "above 0.4: adverse comment is possible",
            };
            format!("{shown} (BS 6472-1, residential, day: {says})")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_day_by_hand() {
        // one interval of KB_FTi = 0.3 a pass, 64 passes by day: 64 · 30 s · 0.09/57600 s = 0.003; √ = 0.0547723
        assert!((rating(&[(0.3, 64)], Period::Day) - 0.054_772_3).abs() < 1e-7);
        // 8 by night: 8 · 30 · 0.09/28800 = 0.00075; √ = 0.0273861
        assert!((rating(&[(0.3, 8)], Period::Night) - 0.027_386_1).abs() < 1e-7);
        // intervals of 0.3 and 0.4 a pass count as one of 0.5: 64 · 30 · 0.25/57600 = 1/120; √ = 0.0912871
        assert!((rating(&[(0.5, 64)], Period::Day) - 0.091_287_1).abs() < 1e-7);
        // VDV: sixteen passes have twice the dose of one, 81 three times: 0.05 · 81^¼ = 0.15
        assert!((dose(&[(0.05, 81)]) - 0.15).abs() < 1e-12);
    }

    #[test]
    fn trains_of_one_day_add_up() {
        let freight = OtherTrain {
            name: "freight".into(),
            passes: Passes { day: 0, night: 10 },
            kb_ftm: vec![0.4, 0.2],
            vdv: vec![0.1],
        };
        let passes = Some(Passes { day: 64, night: 8 });
        let both = Assessment { passes, others: vec![freight], ..Assessment::default() };
        let one = OnePass { kb_f_maximum: 0.3, kb_pass: 0.3, dose: 0.05 };
        let of = |r, key: &str| both.day_answers(one, r, "", "").iter().find(|a| a.key == key).unwrap().value;
        // by day as alone; by night (8 · 0.09 + 10 · 0.16) 30/28800 = 2.32/960 = 0.00241667, √ = 0.0491596
        assert!((of(0, "kb_ftr_day") - 0.054_772_3).abs() < 1e-7);
        assert!((of(0, "kb_ftr_night") - 0.049_159_6).abs() < 1e-7);
        // (8 · 0.05⁴ + 10 · 0.1⁴)^¼ = (5e-5 + 1e-3)^¼ = 0.180010; without a dose of the other 8^¼ · 0.05 = 0.0840896
        assert!((of(0, "vdv_night") - 0.180_010).abs() < 1e-6);
        assert!((of(1, "vdv_night") - 0.084_089_6).abs() < 1e-7);
    }

    #[test]
    fn limits_are_read_in_their_order() {
        let assessment = Assessment::default();
        let text = |most, rating| assessment.kb_text(most, rating, Period::Day);
        assert!(text(0.15, 0.09).contains("met: KB_Fmax 0.150 is not above A_u 0.150"));
        assert!(text(0.2, 0.07).contains("(DIN 4150-2, residential, day: met: not above A_r 0.0700"));
        assert!(text(0.2, 0.0701).contains("not met: above A_r"));
        let urban = Assessment { line: Line::Urban, ..Assessment::default() };
        // 1.5 times 0.07
        assert!(urban.kb_text(0.3, 0.104, Period::Day).contains("met: not above A_r 0.105"));
        assert!(dose_text(0.3, Period::Day).contains("low probability"));
    }

    #[test]
    fn guides_asked_for_alone() {
        let one = Assessment { guides: vec![Guide::Bs6472Part1], ..Assessment::default() };
        assert!(one.guide_values().iter().all(|g| g.guide == Guide::Bs6472Part1));
        assert!(!one.asks(Guide::Fta) && Assessment::default().asks(Guide::Fta));
    }
}
