//! Horizontal lines across a picture, labelled at their right end.

use super::axis::Scale;
use super::canvas::{Anchor, Canvas, Pen, TICK};
use super::colours::GREY;
use super::curves::levels;
use super::lettering::text_width;
use super::page::Area;
use crate::figure::LineFigure;

/// Height of a label [px].
const HEIGHT: f64 = 18.0;

/// Where the label of each level stands: above the end of its line, below it where another one is in the way.
pub(super) fn places(frame: Area, y: Scale, figure: &LineFigure) -> Vec<Area> {
    let mut lines: Vec<(usize, f64)> = levels(figure).map(|(value, _)| y.at(value)).enumerate().collect();
    lines.sort_by(|a, b| a.1.total_cmp(&b.1));
    let widths: Vec<f64> = levels(figure).map(|(_, label)| text_width(label, TICK) + 8.0).collect();
    let mut found: Vec<(usize, Area)> = Vec::new();
    for (index, at) in lines {
        let right = frame.right - 6.0;
        let area = |top: f64| Area { left: right - widths[index], top, right, bottom: top + HEIGHT };
        let above = area(at - HEIGHT - 2.0);
        let free = |a: &Area| {
            a.top > frame.top && a.bottom < frame.bottom && found.iter().all(|(_, other)| !a.overlaps(other))
        };
        let place = [above, area(at + 2.0)].into_iter().find(free).unwrap_or(above);
        found.push((index, place));
    }
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, area)| area).collect()
}

/// The lines and their labels, behind the curves, of which they hide nothing.
pub(super) fn draw(canvas: &mut Canvas, frame: Area, y: Scale, figure: &LineFigure) {
    for (value, _) in levels(figure) {
        let pen = Pen { dash: Some((7.0, 4.0)), ..Pen::solid(GREY, 1.6) };
        canvas.group("level", |canvas| {
            canvas.line((frame.left, y.at(value)), (frame.right, y.at(value)), pen);
        });
    }
    for ((_, label), area) in levels(figure).zip(places(frame, y, figure)) {
        canvas.group("level", |canvas| {
            canvas.rectangle(area, Some([255; 3]), None);
            canvas.text((area.right - 4.0, area.bottom - 4.0), label, TICK, Anchor::End);
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_near_lines_keep_clear_of_each_other() {
        let frame = Area { left: 80.0, top: 50.0, right: 880.0, bottom: 490.0 };
        let y = Scale::new((0.01, 10.0), true, (frame.bottom, frame.top));
        let mut figure = LineFigure::new("n", "t", "x", "y");
        figure.log_y = true;
        figure.levels =
            vec![(0.1, "one".into()), (0.11, "two".into()), (-1.0, "nowhere".into()), (9.9, "top".into())];
        let found = places(frame, y, &figure);
        // a value without a place on the axis has no label
        assert_eq!(found.len(), 3);
        for (i, a) in found.iter().enumerate() {
            assert!(a.top > frame.top && a.bottom < frame.bottom && a.right < frame.right);
            assert!(found[..i].iter().all(|b| !a.overlaps(b)), "{i}");
        }
        // the upper one stands above its line, the lower one below
        assert!(found[1].bottom < y.at(0.11) && found[0].top > y.at(0.1));
    }
}
