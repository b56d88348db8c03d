//! What stands around a picture: title, grid, axes with their ticks.

use super::axis::{Scale, Ticks, superscript};
use super::canvas::{Anchor, Canvas, LABEL, Pen, TICK, TITLE};
use super::colours::{FAINT, INK};
use super::lettering::text_width;
use super::page::Area;

impl Canvas {
    /// The title, centred over the frame, or on the page if it is wider; smaller if it is wider than the page.
    pub fn title(&mut self, frame: Area, text: &str) {
        let (page, width) = (self.width, text_width(text, TITLE));
        let fit = ((page - 20.0) / width).min(1.0);
        let size = ((f64::from(TITLE) * fit) as u32).max(TICK);
        let middle = if width < frame.width() { 0.5 * (frame.left + frame.right) } else { 0.5 * page };
        self.text((middle, 30.0), text, size, Anchor::Middle);
    }

    /// Ticks outward, tick labels and the axis label, below (`above` = false) or above the frame.
    pub fn x_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, above: bool) {
        let (edge, outward) = if above { (frame.top, -1.0) } else { (frame.bottom, 1.0) };
        let pen = Pen::solid(INK, 1.2);
        self.group(if above { "ticks second" } else { "ticks x" }, |canvas| {
            for &value in &ticks.minor {
                let x = scale.at(value);
                canvas.line((x, edge), (x, edge + 3.5 * outward), pen);
            }
            for tick in &ticks.major {
                let x = scale.at(tick.value);
                canvas.line((x, edge), (x, edge + 6.0 * outward), pen);
                let y = if above { edge - 11.0 } else { edge + 22.0 };
                canvas.text((x, y), &tick.label, TICK, Anchor::Middle);
            }
        });
        let y = if above { edge - 34.0 } else { edge + 48.0 };
        let middle = 0.5 * (frame.left + frame.right);
        let label = with_power(label, ticks.exponent);
        self.text((middle, y), &label, LABEL, Anchor::Middle);
    }

    /// Ticks outward, tick labels and the axis label, left of the frame (`right` = false) or right of it.
    pub fn y_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, right: bool) {
        let (edge, outward) = if right { (frame.right, 1.0) } else { (frame.left, -1.0) };
        let pen = Pen::solid(INK, 1.2);
        self.group(if right { "ticks colours" } else { "ticks y" }, |canvas| {
            for &value in &ticks.minor {
                let y = scale.at(value);
                canvas.line((edge, y), (edge + 3.5 * outward, y), pen);
            }
            for tick in &ticks.major {
                let y = scale.at(tick.value);
                canvas.line((edge, y), (edge + 6.0 * outward, y), pen);
                let anchor = if right { Anchor::Start } else { Anchor::End };
                canvas.text((edge + 10.0 * outward, y + 5.0), &tick.label, TICK, anchor);
            }
        });
        // The label reads upward: its baseline is on its right, so it needs more room on the right of a frame.
        let away = 24.0 + label_room(ticks);
        let x = if right { edge + away + 11.0 } else { edge - away };
        let middle = 0.5 * (frame.top + frame.bottom);
        self.upright_text((x, middle), &with_power(label, ticks.exponent), LABEL);
    }

    pub fn grid(&mut self, frame: Area, x: (Scale, &Ticks), y: (Scale, &Ticks)) {
        let pen = Pen::solid(FAINT, 1.0);
        self.group("grid x", |canvas| {
            for x in x.1.major.iter().map(|tick| x.0.at(tick.value)) {
                canvas.line((x, frame.top), (x, frame.bottom), pen);
            }
        });
        self.group("grid y", |canvas| {
            for y in y.1.major.iter().map(|tick| y.0.at(tick.value)) {
                canvas.line((frame.left, y), (frame.right, y), pen);
            }
        });
    }
}

/// An axis label whose tick labels leave out a power of ten: `u [m]` becomes `u [10⁻³ m]`.
fn with_power(label: &str, exponent: i32) -> String {
    if exponent == 0 {
        return label.to_owned();
    }
    let unit = label.strip_suffix(']').and_then(|head| head.rsplit_once('['));
    match unit {
        Some((name, "-" | "1" | "–")) => format!("{name}[10{}]", superscript(exponent)),
        Some((name, unit)) => format!("{name}[10{} {unit}]", superscript(exponent)),
        // Without a unit the label itself takes the inverse power, as labels × 10ⁿ = values.
        None => format!("{label} × 10{}", superscript(-exponent)),
    }
}

/// Width of the longest tick label [px].
pub(super) fn label_room(ticks: &Ticks) -> f64 {
    let widths = ticks.major.iter().map(|t| text_width(&t.label, TICK));
    widths.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_power_of_ten_joins_the_unit() {
        assert_eq!(with_power("u [m/N]", -9), "u [10⁻⁹ m/N]");
        assert_eq!(with_power("u [-]", 6), "u [10⁶]");
        assert_eq!(with_power("u", 6), "u × 10⁻⁶");
        assert_eq!(with_power("u [mm]", 0), "u [mm]");
    }
}
