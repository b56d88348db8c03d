//! Measures of one pass against distance, beside those guide values that one pass can be compared with.

use super::PassVelocities;
use super::metrics::{
    KB_F_MAXIMUM, MEASURES, PEAK_TO_315, V_SLOW_MAXIMUM, V_W_SLOW_MAXIMUM, VDV, told, where_text,
};
use super::pictures::figure;
use crate::assessment::{GuideValue, Quantity, Reference};
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::speed_text;

/// A measure and the guide values of its standards.
struct Comparison {
    /// Place in [`MEASURES`].
    measure: usize,
    name: &'static str,
    /// Whose guide values are lines.
    drawn: &'static [Quantity],
    /// Whose are named in the caption only, and why.
    named: &'static [Quantity],
    why: &'static str,
    /// As a level, on a linear axis.
    level: bool,
}

const COMPARISONS: [Comparison; 5] = [
    Comparison {
        measure: KB_F_MAXIMUM,
        name: "kb_distance",
        drawn: &[Quantity::KbFMaximum, Quantity::VMaximum],
        named: &[Quantity::KbFRating, Quantity::VPeriod],
        why: "which apply to KB_FTr and V_per and need the passes of a day",
        level: false,
    },
    Comparison {
        measure: V_SLOW_MAXIMUM,
        name: "level_distance",
        drawn: &[Quantity::VelocityLevel(Reference::VdB)],
        named: &[],
        why: "",
        level: true,
    },
    Comparison {
        measure: VDV,
        name: "vdv_distance",
        drawn: &[],
        named: &[Quantity::VibrationDose],
        why: "which are for all of 16 h: n like passes have n^¼ times the dose of one",
        level: false,
    },
    Comparison {
        measure: V_W_SLOW_MAXIMUM,
        name: "v_w_distance",
        drawn: &[],
        named: &[],
        why: "",
        level: false,
    },
    Comparison {
        measure: PEAK_TO_315,
        name: "ppv_distance",
        drawn: &[Quantity::PeakVelocity],
        named: &[],
        why: "",
        level: false,
    },
];

impl PassVelocities<'_> {
    /// Measures against distance with the guide values of standards, which hold inside buildings and for what the standard says.
    pub(super) fn guide_figures(&self) -> Vec<(Figure, String)> {
        let guides = &self.study.assessment.guides;
        let asked = |of: &&Comparison| guides.is_empty() || told(guides).contains(&of.measure);
        COMPARISONS.iter().filter(asked).map(|of| self.guide_figure(of)).collect()
    }

    fn guide_figure(&self, of: &Comparison) -> (Figure, String) {
        let study = self.study;
        let (place, measured) = self.judged();
        let measure = &MEASURES[of.measure];
        let (unit, scale) = match measure.unit() {
            _ if of.level => ("VdB re 1 µin/s", 1.0),
            "m/s" => ("mm/s", 1e3),
            unit => (unit, 1.0),
        };
        let y_label = format!("{} [{}]", measure.symbol, if unit == "1" { "-" } else { unit });
        let title = format!("{} of one pass against distance, {}", measure.symbol, speed_text(study.speed));
        let labels = ("distance from the centre line [m]", y_label.as_str());
        let mut picture = figure(format!("free_field_{}", of.name), title, labels, true);
        picture.log_y = !of.level;
        let convert =
            |v: f64| if of.level { 20.0 * (v / Reference::VdB.velocity()).log10() } else { scale * v };
        let points = |name: &str, pick: fn((f64, f64, f64)) -> f64, stroke| Series {
            name: name.into(),
            x: study.receivers.clone(),
            y: (0..study.receivers.len()).map(|r| convert(pick(measured.spread(of.measure, r)))).collect(),
            stroke,
        };
        if self.histories.len() > 1 {
            picture.series.push(points("mean of the profiles", |s| s.0, Stroke::Solid));
            picture.series.push(points("largest of the profiles", |s| s.2, Stroke::Points));
        } else {
            picture.series.push(points(measure.symbol, |s| s.0, Stroke::Solid));
        }
        let values = study.assessment.guide_values();
        draw(&of_quantities(&values, of.drawn), &mut picture);
        (Figure::Lines(picture), format!("{}, {}{}", measure.what, where_text(place), of.caption(&values)))
    }
}

/// Those of `values` that are of one of `quantities`, quantity by quantity.
pub(super) fn of_quantities<'a>(values: &'a [GuideValue], quantities: &[Quantity]) -> Vec<&'a GuideValue> {
    quantities.iter().flat_map(|q| values.iter().filter(move |g| g.quantity == *q)).collect()
}

/// Adds a line across the picture for every guide value, labelled at its end; one for those that coincide, as far as there is room.
pub(super) fn draw(values: &[&GuideValue], picture: &mut LineFigure) {
    for guide in values {
        let name = format!("{} {}", guide.guide.short(), guide.name);
        let same =
            |(value, label): &&mut (f64, String)| *value == guide.value && label.len() + name.len() < 90;
        match picture.levels.iter_mut().find(same) {
            Some((_, label)) => *label = format!("{label}; {name}"),
            None => picture.levels.push((guide.value, name)),
        }
    }
}

/// `values` with their standards and what they mean.
pub(super) fn list(values: &[&GuideValue]) -> String {
    let one = |g: &&GuideValue| {
        format!("{}, {}: {} ({}; {})", g.guide.standard(), g.name, g.value, g.criterion, g.note)
    };
    values.iter().map(one).collect::<Vec<_>>().join("; ")
}

impl Comparison {
    /// The guide values with their standards: those drawn, and those that one pass cannot be compared with.
    fn caption(&self, values: &[GuideValue]) -> String {
        let list = |quantities: &[Quantity]| list(&of_quantities(values, quantities));
        let some = |quantities: &[Quantity]| !of_quantities(values, quantities).is_empty();
        let mut caption = String::new();
        if some(self.drawn) {
            caption += &format!(
                "; guide values, which hold inside buildings, are drawn to compare, not to judge: {}",
                list(self.drawn)
            );
        }
        if some(self.named) {
            caption += &format!(". Not compared with guide values {}: {}", self.why, list(self.named));
        }
        caption + "."
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::free_field::Assessment;

    fn all() -> Vec<GuideValue> {
        Assessment::default().guide_values()
    }

    fn drawn(of: &Comparison) -> LineFigure {
        let mut picture = figure("n".into(), "t".into(), ("x", "y"), true);
        draw(&of_quantities(&all(), of.drawn), &mut picture);
        picture
    }

    /// One pass stood beside the guide values of sixteen hours.
    #[test]
    fn the_dose_of_one_pass_meets_no_guide_value_of_a_day() {
        let dose = COMPARISONS.iter().find(|of| of.measure == VDV).unwrap();
        assert_eq!(drawn(dose).levels, []);
        let caption = dose.caption(&all());
        for said in ["Not compared", "n like passes have n^¼ times", "BS 6472-1:2008", ": 0.2 ("] {
            assert!(caption.contains(said), "no \"{said}\" in {caption}");
        }
    }

    #[test]
    fn lines_of_kb_are_labelled_and_their_criterion_is_told() {
        let kb = COMPARISONS.iter().find(|of| of.measure == KB_F_MAXIMUM).unwrap();
        let lines = drawn(kb).levels;
        let names: String = lines.iter().map(|(_, label)| format!("{label}\n")).collect();
        assert!(names.contains("DIN 4150-2 A_u residential, day\n"), "{names}");
        // A_r and A_3 belong to KB_FTr and V_per: no line, but a word
        assert!(!names.contains("A_r ") && !names.contains("A_3 dwellings"), "{names}");
        let caption = kb.caption(&all());
        for said in [
            "A_u residential, day: 0.15 (enough if KB_Fmax ≤ A_u; ",
            "missed if KB_Fmax > A_o",
            "enough if V_max",
            "need the passes of a day: DIN 4150-2:1999, A_r residential, day: 0.07",
        ] {
            assert!(caption.contains(said), "no \"{said}\" in {caption}");
        }
        // every value is on a line: 3, 0.15, 0.4, 0.2 and 0.1, and where a cause is looked into
        for value in [3.0, 0.15, 0.4, 0.2, 0.1, 0.6] {
            assert!(lines.iter().any(|line| line.0 == value), "{value}");
        }
    }
}
