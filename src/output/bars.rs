//! Horizontal bars from zero, one below the other.

use super::OutputError;
use super::axis::Scale;
use super::canvas::{Anchor, Canvas, Pen, TICK};
use super::colours::{INK, curve};
use super::lettering::text_width;
use super::page::Area;
use crate::figure::BarFigure;

/// Page width [px].
const WIDTH: f64 = 900.0;
/// Room of a bar with its gap, and its own height [px].
const ROW: f64 = 26.0;
const BAR: f64 = 15.0;

/// Draws the figure; values that are not finite have no bar.
pub(super) fn draw(figure: &BarFigure) -> Result<Canvas, OutputError> {
    let values = figure.series.iter().flat_map(|(_, values)| values.iter().copied());
    let (low, high) =
        values.filter(|v| v.is_finite()).fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
    if low == high {
        return Err(OutputError::Figure {
            figure: figure.name.clone(),
            reason: "no bar has a length".to_owned(),
            needed: "a value that is finite and not zero".to_owned(),
        });
    }
    let room = figure.labels.iter().map(|label| text_width(label, TICK)).fold(0.0, f64::max);
    let named = figure.series.len() > 1;
    let top = if named { 78.0 } else { 52.0 };
    let bottom = top + ROW * figure.labels.len() as f64 + 8.0;
    let frame = Area { left: room + 24.0, top, right: WIDTH - 26.0, bottom };
    let margin = 0.05 * (high - low);
    let x = Scale::new((low - margin, high + margin), false, (frame.left, frame.right));
    let mut canvas = Canvas::new(WIDTH, bottom + 62.0);
    let ticks = x.ticks(8);
    for (i, (_, values)) in figure.series.iter().enumerate() {
        for (row, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
            let (from, to) = (x.at(value.min(0.0)), x.at(value.max(0.0)));
            let top = frame.top + 4.0 + ROW * row as f64 + 0.5 * (ROW - BAR);
            canvas.rectangle(Area { left: from, top, right: to, bottom: top + BAR }, Some(curve(i, 7)), None);
        }
    }
    for (row, label) in figure.labels.iter().enumerate() {
        let y = frame.top + 4.0 + ROW * (row as f64 + 0.5) + 5.0;
        canvas.text((frame.left - 8.0, y), label, TICK, Anchor::End);
    }
    canvas.line((x.at(0.0), frame.top), (x.at(0.0), frame.bottom), Pen::solid(INK, 1.2));
    canvas.rectangle(frame, None, Some(Pen::solid(INK, 1.2)));
    canvas.x_axis(frame, x, &ticks, &figure.x_label, false);
    canvas.title(frame, &figure.title);
    let mut left = frame.left;
    for (i, (name, _)) in figure.series.iter().enumerate().filter(|_| named) {
        canvas.rectangle(Area { left, top: 48.0, right: left + 24.0, bottom: 63.0 }, Some(curve(i, 7)), None);
        canvas.text((left + 32.0, 60.0), name, TICK, Anchor::Start);
        left += text_width(name, TICK) + 56.0;
    }
    Ok(canvas)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Figure;
    use crate::output::plot::Picture;

    fn figure(values: [f64; 3]) -> BarFigure {
        BarFigure {
            name: "bars".into(),
            title: "Bars".into(),
            x_label: "change [%]".into(),
            labels: ["soil.layer[0].shear_speed", "track.rail.mass", "gap"].map(str::to_owned).to_vec(),
            series: vec![("at 5 %".into(), values.to_vec()), ("at 95 %".into(), values.map(|v| -v).to_vec())],
        }
    }

    #[test]
    fn bars_have_labels_and_names() {
        let svg = Picture::of(&Figure::Bars(figure([-3.0, 1.0, f64::NAN]))).unwrap().svg;
        for text in ["soil.layer[0].shear_speed", "gap", "at 95 %", "change [%]"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(Picture::of(&Figure::Bars(figure([0.0, f64::NAN, 0.0]))).is_err());
    }
}
