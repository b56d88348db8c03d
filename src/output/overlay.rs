//! Curves over a field: dark with a light rim, so that they show on any colour, and their legend below it.

use super::axis::Scale;
use super::canvas::{Anchor, Canvas, Pen, TICK};
use super::colours::{INK, Rgb};
use super::curves::thin_out;
use super::lettering::text_width;
use super::lines::{DASH, ROW, SAMPLE, stroke};
use super::page::Point;
use crate::figure::{Series, Stroke};

/// Colours of the curves.
const COLOURS: [Rgb; 4] = [INK, [204, 51, 17], [0, 80, 160], [120, 0, 110]];
/// Width of a line with its rim [px].
const RIM: f64 = 4.8;
/// Distance from one entry of the legend to the next [px].
const GAP: f64 = 24.0;

fn rimmed(canvas: &mut Canvas, points: &[Point], kind: Stroke, colour: Rgb) {
    if kind != Stroke::Points && points.len() > 1 {
        let dash = if kind == Stroke::Dashed { DASH } else { None };
        canvas.polyline(points, Pen { dash, ..Pen::solid([255; 3], RIM) });
    }
    stroke(canvas, points, kind, colour);
}

/// Draws `series` within the spans of both axes; what is not finite is a gap.
pub(super) fn draw(
    canvas: &mut Canvas,
    series: &[Series],
    (x, x_span): (Scale, (f64, f64)),
    (y, y_span): (Scale, (f64, f64)),
) {
    for (index, series) in series.iter().enumerate() {
        canvas.group("curve", |canvas| {
            for run in cut(series, x_span, y_span) {
                let points = thin_out(run.into_iter().map(|(u, v)| (x.at(u), y.at(v))).collect());
                rimmed(canvas, &points, series.stroke, COLOURS[index % COLOURS.len()]);
            }
        });
    }
}

/// The stretches of a series inside the rectangle, ending on its edge.
fn cut(series: &Series, x: (f64, f64), y: (f64, f64)) -> Vec<Vec<Point>> {
    let points: Vec<Point> = series.x.iter().copied().zip(series.y.iter().copied()).collect();
    let inside = |(u, v): Point| (x.0..=x.1).contains(&u) && (y.0..=y.1).contains(&v);
    if series.stroke == Stroke::Points {
        return points.into_iter().filter(|p| inside(*p)).map(|p| vec![p]).collect();
    }
    let mut runs: Vec<Vec<Point>> = Vec::new();
    for whole in points.split(|p| !(p.0.is_finite() && p.1.is_finite())) {
        // a point between two gaps
        if whole.len() == 1 && inside(whole[0]) {
            runs.push(whole.to_vec());
        }
        for (i, pair) in whole.windows(2).enumerate() {
            let (a, b) = (pair[0], pair[1]);
            let Some((from, to)) = part_inside(a, b, x, y) else { continue };
            let at = |t: f64| (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1));
            let (first, last) = (if from == 0.0 { a } else { at(from) }, if to == 1.0 { b } else { at(to) });
            match runs.last_mut() {
                Some(run) if i > 0 && from == 0.0 => run.push(last),
                _ => runs.push(vec![first, last]),
            }
        }
    }
    runs
}

/// The part of the way from `a` to `b` that lies in the rectangle.
fn part_inside(a: Point, b: Point, x: (f64, f64), y: (f64, f64)) -> Option<(f64, f64)> {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for (start, end, (low, high)) in [(a.0, b.0, x), (a.1, b.1, y)] {
        if start == end {
            if !(low..=high).contains(&start) {
                return None;
            }
        } else {
            let (p, q) = ((low - start) / (end - start), (high - start) / (end - start));
            (from, to) = (from.max(p.min(q)), to.min(p.max(q)));
        }
    }
    (from < to).then_some((from, to))
}

/// Where the names of the curves stand: a column and a row for each, and the height of all.
pub(super) struct Legend {
    places: Vec<Point>,
    /// [px]
    pub height: f64,
}

/// A legend from `start` on, in rows that end before `right`.
pub(super) fn legend(series: &[Series], start: Point, right: f64) -> Legend {
    let mut places = Vec::new();
    let (mut x, mut y) = start;
    for series in series {
        let width = SAMPLE + 9.0 + text_width(&series.name, TICK);
        if x > start.0 && x + width > right {
            (x, y) = (start.0, y + ROW);
        }
        places.push((x, y));
        x += width + GAP;
    }
    let height = if places.is_empty() { 0.0 } else { y - start.1 + ROW + 8.0 };
    Legend { places, height }
}

impl Legend {
    pub fn draw(&self, canvas: &mut Canvas, series: &[Series]) {
        for (index, (series, &(left, top))) in series.iter().zip(&self.places).enumerate() {
            let y = top + 0.5 * ROW;
            let ends = match series.stroke {
                Stroke::Points => vec![(left + 0.5 * SAMPLE, y)],
                Stroke::Solid | Stroke::Dashed => vec![(left, y), (left + SAMPLE, y)],
            };
            canvas.group("key", |canvas| {
                stroke(canvas, &ends, series.stroke, COLOURS[index % COLOURS.len()]);
                canvas.text((left + SAMPLE + 9.0, y + 5.0), &series.name, TICK, Anchor::Start);
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_end_on_the_edge_and_gaps_stay_gaps() {
        let line = |x: &[f64], y: &[f64]| Series {
            name: String::new(),
            x: x.to_vec(),
            y: y.to_vec(),
            stroke: Stroke::Solid,
        };
        let (x, y) = ((0.0, 10.0), (0.0, 1.0));
        let rising = line(&[0.0, 4.0, 8.0], &[-0.5, 0.5, 1.5]);
        assert_eq!(cut(&rising, x, y), [[(2.0, 0.0), (4.0, 0.5), (6.0, 1.0)]]);
        assert!(cut(&line(&[0.0, 10.0], &[2.0, 2.0]), x, y).is_empty());
        let broken = line(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], &[0.5, f64::NAN, 0.5, 0.5, f64::NAN, 0.2]);
        assert_eq!(cut(&broken, x, y), [vec![(0.0, 0.5)], vec![(2.0, 0.5), (3.0, 0.5)], vec![(5.0, 0.2)]]);
    }
}
