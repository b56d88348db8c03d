//! The points of a figure's curves: which can be shown, and the ranges they need.

use super::axis::{PLACES, step};
use super::page::Point;
use crate::figure::{LineFigure, Series, Stroke};

/// True for a value that has a place on an axis.
fn shown(value: f64, log: bool) -> bool {
    if log { PLACES.contains(&value) } else { value.abs() < PLACES.end }
}

/// The vertical marks that have a place on the x axis.
pub(super) fn marks(figure: &LineFigure) -> impl Iterator<Item = (f64, &str)> {
    let marks = figure.marks.iter().filter(|m| shown(m.0, figure.log_x));
    marks.map(|(x, label)| (*x, label.as_str()))
}

/// The horizontal lines that have a place on the y axis.
pub(super) fn levels(figure: &LineFigure) -> impl Iterator<Item = (f64, &str)> {
    let levels = figure.levels.iter().filter(|l| shown(l.0, figure.log_y));
    levels.map(|(y, label)| (*y, label.as_str()))
}

/// The unbroken stretches of a series that can be shown.
pub(super) fn runs(series: &Series, figure: &LineFigure) -> Vec<Vec<Point>> {
    let mut runs = vec![Vec::new()];
    for (&x, &y) in series.x.iter().zip(&series.y) {
        if shown(x, figure.log_x) && shown(y, figure.log_y) {
            runs.last_mut().into_iter().for_each(|run| run.push((x, y)));
        } else {
            runs.push(Vec::new());
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

/// Leaves out points within a third of a pixel of the last one kept: they cannot be seen, and make an SVG heavy.
pub(super) fn thin_out(points: Vec<Point>) -> Vec<Point> {
    let last = points.len().saturating_sub(1);
    let mut kept: Vec<Point> = Vec::new();
    for (index, point) in points.into_iter().enumerate() {
        let far = kept.last().is_none_or(|k: &Point| (k.0 - point.0).hypot(k.1 - point.1) > 0.33);
        if far || index == last {
            kept.push(point);
        }
    }
    kept
}

/// The ranges of both axes: x as the data have it, y with a margin; none if nothing can be shown.
pub(super) fn ranges(figure: &LineFigure) -> Option<((f64, f64), (f64, f64))> {
    let points: Vec<Point> =
        figure.series.iter().flat_map(|s| runs(s, figure).into_iter().flatten()).collect();
    let marks = marks(figure).map(|(x, _)| x);
    let x = bounds(points.iter().map(|p| p.0).chain(marks))?;
    bounds(points.iter().map(|p| p.1))?;
    let held = figure.y_holds.into_iter().flat_map(|(low, high)| [low, high]);
    let held = held.filter(|v| shown(*v, figure.log_y));
    let y = bounds(points.iter().map(|p| p.1).chain(held).chain(levels(figure).map(|(y, _)| y)))?;
    let has_markers = figure.series.iter().any(|s| s.stroke == Stroke::Points);
    // Room at the ends of the vertical marks for their labels.
    let y_margin = if figure.marks.is_empty() && figure.levels.is_empty() { 0.06 } else { 0.1 };
    let x_margin = if has_markers { 0.02 } else { 0.0 };
    Some((widen(x, figure.log_x, x_margin, false), widen(y, figure.log_y, y_margin, true)))
}

fn bounds(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter(|v| v.is_finite()).fold(None, |sofar, v| match sofar {
        None => Some((v, v)),
        Some((lo, hi)) => Some((lo.min(v), hi.max(v))),
    })
}

/// A range with a margin on both sides, never empty; from zero if the values begin near it and `from_zero`.
fn widen((lo, hi): (f64, f64), log: bool, margin: f64, from_zero: bool) -> (f64, f64) {
    if log {
        let decades = (hi / lo).log10();
        let factor = 10f64.powf(if decades > 0.0 { margin * decades } else { 0.5 });
        return (lo / factor, hi * factor);
    }
    let size = lo.abs().max(hi.abs());
    if hi - lo <= 1e-12 * size || size < PLACES.start {
        // A constant, perhaps with rounding noise: show it as flat, between whole steps.
        let half = if size < PLACES.start { 1.0 } else { step(size, 2) };
        return (lo - half, hi + half);
    }
    let more = margin * (hi - lo);
    if from_zero && lo >= 0.0 && lo < 0.4 * hi {
        return (0.0, hi + more);
    }
    if from_zero && hi <= 0.0 && hi > 0.4 * lo {
        return (lo - more, 0.0);
    }
    (lo - more, hi + more)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_begin_at_zero_when_near_and_are_never_empty() {
        assert_eq!(widen((1.0, 5.0), false, 0.0, true), (0.0, 5.0));
        assert_eq!(widen((4.0, 5.0), false, 0.0, true), (4.0, 5.0));
        assert_eq!(widen((-5.0, -1.0), false, 0.0, true), (-5.0, 0.0));
        assert_eq!(widen((3.0, 3.0), false, 0.0, false), (1.0, 5.0));
        assert_eq!(widen((0.0, 0.0), false, 0.0, false), (-1.0, 1.0));
        let (lo, hi) = widen((10.0, 10.0), true, 0.0, false);
        assert!(lo < 10.0 && hi > 10.0);
    }

    #[test]
    fn thinning_keeps_ends_and_whatever_is_seen() {
        let fine: Vec<Point> = (0..=1000).map(|i| (0.01 * f64::from(i), 0.0)).collect();
        let kept = thin_out(fine);
        assert!(kept.len() < 40);
        assert_eq!((kept[0].0, kept[kept.len() - 1].0), (0.0, 10.0));
    }
}
