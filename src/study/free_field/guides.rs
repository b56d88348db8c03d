//! Measures of one pass against distance, beside those guide values that one pass can be compared with.

use super::PassVelocities;
use super::metrics::{KB_F_MAXIMUM, MEASURES, V_SLOW_MAXIMUM, VDV};
use super::shown::figure;
use crate::assessment::{Quantity, Reference, guide_values};
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

const COMPARISONS: [Comparison; 3] = [
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
];

impl PassVelocities<'_> {
    /// Measures against distance with the guide values of standards, which hold inside buildings and for what the standard says.
    pub(super) fn guide_figures(&self) -> Vec<(Figure, String)> {
        COMPARISONS.iter().map(|of| self.guide_figure(of)).collect()
    }

    fn guide_figure(&self, of: &Comparison) -> (Figure, String) {
        let study = self.study;
        let measure = &MEASURES[of.measure];
        let unit = if of.level { "VdB re 1 µin/s" } else { measure.unit() };
        let y_label = format!("{} [{}]", measure.symbol, if unit == "1" { "-" } else { unit });
        let title = format!("{} of one pass against distance, {}", measure.symbol, speed_text(study.speed));
        let labels = ("distance from the centre line [m]", y_label.as_str());
        let mut picture = figure(format!("free_field_{}", of.name), title, labels, true);
        picture.log_y = !of.level;
        let convert = |v: f64| if of.level { 20.0 * (v / Reference::VdB.velocity()).log10() } else { v };
        let points = |name: &str, pick: fn((f64, f64, f64)) -> f64, stroke| Series {
            name: name.into(),
            x: study.receivers.clone(),
            y: (0..study.receivers.len())
                .map(|r| convert(pick(self.metrics.spread(of.measure, r))))
                .collect(),
            stroke,
        };
        if self.histories.len() > 1 {
            picture.series.push(points("mean of the profiles", |s| s.0, Stroke::Solid));
            picture.series.push(points("largest of the profiles", |s| s.2, Stroke::Points));
        } else {
            picture.series.push(points(measure.symbol, |s| s.0, Stroke::Solid));
        }
        of.draw([0.9 * study.receivers[0], 1.1 * self.pass.farthest()], &mut picture);
        (
            Figure::Lines(picture),
            format!("{}, on the ground's surface without a building{}", measure.what, of.caption()),
        )
    }
}

impl Comparison {
    /// Adds a dashed line from one of `ends` to the other for every guide value; one for those that coincide, as far as a legend is
    /// wide.
    fn draw(&self, ends: [f64; 2], picture: &mut LineFigure) {
        for guide in self.drawn.iter().flat_map(|q| guide_values(*q)) {
            let standard = guide.standard.split([':', ' ']).next().unwrap_or("");
            let name = format!("{standard} {}: {}", guide.name, guide.criterion);
            let same = |s: &&mut Series| {
                s.stroke == Stroke::Dashed && s.y == [guide.value; 2] && s.name.len() + name.len() < 110
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
    }

    /// The guide values with their standards: those drawn, and those that one pass cannot be compared with.
    fn caption(&self) -> String {
        let list = |quantities: &[Quantity]| -> String {
            let all = quantities.iter().flat_map(|q| guide_values(*q));
            let one = |g: &crate::assessment::GuideValue| {
                format!("{}, {}: {} ({})", g.standard, g.name, g.value, g.note)
            };
            all.map(one).collect::<Vec<_>>().join("; ")
        };
        let mut caption = String::new();
        if !self.drawn.is_empty() {
            caption += &format!(
                "; guide values, which hold inside buildings, are drawn to compare, not to judge: {}",
                list(self.drawn)
            );
        }
        if !self.named.is_empty() {
            caption += &format!(". Not compared with guide values {}: {}", self.why, list(self.named));
        }
        caption + "."
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(of: &Comparison) -> LineFigure {
        let mut picture = figure("n".into(), "t".into(), ("x", "y"), true);
        of.draw([5.0, 20.0], &mut picture);
        picture
    }

    /// One pass stood beside the guide values of sixteen hours.
    #[test]
    fn the_dose_of_one_pass_meets_no_guide_value_of_a_day() {
        let dose = COMPARISONS.iter().find(|of| of.measure == VDV).unwrap();
        assert_eq!(drawn(dose).series, []);
        let caption = dose.caption();
        for said in ["Not compared", "n like passes have n^¼ times", "BS 6472-1:2008", ": 0.2 ("] {
            assert!(caption.contains(said), "no \"{said}\" in {caption}");
        }
    }

    #[test]
    fn lines_of_kb_carry_their_criterion() {
        let kb = COMPARISONS.iter().find(|of| of.measure == KB_F_MAXIMUM).unwrap();
        let lines = drawn(kb).series;
        let names: String = lines.iter().map(|s| format!("{}\n", s.name)).collect();
        for said in
            ["A_u residential, day: enough if KB_Fmax ≤ A_u", "missed if KB_Fmax > A_o", "enough if V_max"]
        {
            assert!(names.contains(said), "no \"{said}\" in {names}");
        }
        // A_r and A_3 belong to KB_FTr and V_per: no line, but a word
        assert!(!names.contains("A_r ") && !names.contains("A_3 dwellings"), "{names}");
        assert!(
            kb.caption().contains("need the passes of a day: DIN 4150-2:1999, A_r residential, day: 0.07")
        );
        // every value is on a line: 3, 0.15, 0.4, 0.2 and 0.1
        for value in [3.0, 0.15, 0.4, 0.2, 0.1] {
            assert!(lines.iter().any(|s| s.y == [value; 2]), "{value}");
        }
    }
}
