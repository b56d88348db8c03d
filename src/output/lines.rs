//! Curves over one abscissa.
//!
//! The file is long because curves, legend and marks seek their room on one page.

use super::OutputError;
use super::axis::Scale;
use super::canvas::{Anchor, Canvas, Pen, TICK};
use super::colours::{FEW, GREY, INK, Rgb, curve};
use super::curves::{marks, ranges, runs, thin_out};
use super::frame::label_room;
use super::lettering::text_width;
use super::levels;
use super::markers;
use super::page::{Area, Point};
use super::readout;
use crate::figure::{LineFigure, Stroke};

/// Page width [px].
const WIDTH: f64 = 900.0;
/// Height of the frame around the curves [px].
const HEIGHT: f64 = 440.0;
/// Height of a line of the legend [px].
pub(super) const ROW: f64 = 22.0;
/// Room for ticks and label below the frame [px].
pub(super) const BELOW: f64 = 62.0;
/// Length of the stroke shown in the legend [px].
pub(super) const SAMPLE: f64 = 34.0;

/// Dash and gap of a dashed line [px].
pub(super) const DASH: Option<(f64, f64)> = Some((9.0, 5.0));

/// Draws the figure, and what it tells under the pointer; values that are not finite (or not positive on a logarithmic axis) are
/// gaps in the curves.
pub(super) fn draw(figure: &LineFigure) -> Result<(Canvas, String), OutputError> {
    let Some((x_range, y_range)) = ranges(figure) else {
        return Err(OutputError::Figure {
            figure: figure.name.clone(),
            reason: "no curve has a point that can be shown".to_owned(),
            needed: "at least one finite point (positive on a logarithmic axis)".to_owned(),
        });
    };
    let plan = |room_right: f64| Plan::new(figure, x_range, y_range, room_right);
    let mut plan_taken = plan(0.0);
    let mut spots = plan_taken.spots(figure);
    // No free corner: the legend goes beside the frame if that leaves the curves most of the page, else below it.
    if spots.crowded {
        let beside = spots.legend.width() < 0.35 * WIDTH;
        if beside {
            plan_taken = plan(spots.legend.width() + 6.0);
            spots = plan_taken.spots(figure);
        }
        let frame = plan_taken.frame;
        let (left, top) =
            if beside { (frame.right + 6.0, frame.top) } else { (frame.left, frame.bottom + BELOW) };
        let (width, height) = (spots.legend.width(), spots.legend.height());
        spots.legend = Area { left, top, right: left + width, bottom: top + height };
    }
    let Plan { frame, x, y } = plan_taken;
    Ok((plan_taken.draw(figure, &spots), readout::of_lines(figure, frame, x, y)))
}

/// Where everything lies.
struct Plan {
    frame: Area,
    x: Scale,
    y: Scale,
}

/// Room found for the legend and for the label of each vertical mark.
struct Spots {
    legend: Area,
    crowded: bool,
    marks: Vec<Area>,
}

impl Plan {
    fn new(figure: &LineFigure, x: (f64, f64), y: (f64, f64), room_right: f64) -> Self {
        let pixels = (HEIGHT, 0.0);
        let labels = Scale::new(y, figure.log_y, pixels).ticks(7);
        let top = if figure.second_x.is_some() { 104.0 } else { 52.0 };
        let frame = Area {
            left: (label_room(&labels) + 46.0).round(),
            top,
            right: WIDTH - 26.0 - room_right.round(),
            bottom: top + HEIGHT,
        };
        let (low, high) = if figure.y_down { (frame.top, frame.bottom) } else { (frame.bottom, frame.top) };
        Self {
            frame,
            x: Scale::new(x, figure.log_x, (frame.left, frame.right)),
            y: Scale::new(y, figure.log_y, (low, high)),
        }
    }

    fn at(&self, (x, y): Point) -> Point {
        (self.x.at(x), self.y.at(y))
    }

    fn draw(&self, figure: &LineFigure, spots: &Spots) -> Canvas {
        let frame = self.frame;
        let mut canvas = Canvas::new(WIDTH, (frame.bottom + BELOW).max(spots.legend.bottom + 4.0));
        let (x_ticks, y_ticks) = (self.x.ticks_or(&figure.x_ticks, 8), self.y.ticks(7));
        canvas.grid(frame, (self.x, &x_ticks), (self.y, &y_ticks));
        canvas.group("plot", |canvas| {
            levels::draw(canvas, frame, self.y, figure);
            for (value, _) in marks(figure) {
                let x = self.x.at(value);
                let pen = Pen { dash: Some((2.5, 3.5)), ..Pen::solid(GREY, 1.6) };
                canvas.group("mark", |canvas| canvas.line((x, frame.top), (x, frame.bottom), pen));
            }
            (0..figure.series.len()).for_each(|index| self.curve(canvas, figure, index));
            for ((_, label), area) in marks(figure).zip(&spots.marks) {
                canvas.group("mark", |canvas| {
                    canvas.rectangle(*area, Some([255; 3]), None);
                    canvas.text((area.left + 4.0, area.bottom - 5.0), label, TICK, Anchor::Start);
                });
            }
        });
        canvas.rectangle(frame, None, Some(Pen::solid(INK, 1.2)));
        canvas.x_axis(frame, self.x, &x_ticks, &figure.x_label, false);
        canvas.y_axis(frame, self.y, &y_ticks, &figure.y_label, false);
        if let Some(second) = &figure.second_x {
            let scale = self.x.times(second.factor);
            canvas.x_axis(frame, scale, &scale.ticks(8), &second.label, true);
        }
        canvas.title(frame, &figure.title);
        if has_legend(figure) {
            legend(&mut canvas, figure, spots.legend);
        }
        canvas
    }

    /// Curve number `index`, with its marks where there are few.
    fn curve(&self, canvas: &mut Canvas, figure: &LineFigure, index: usize) {
        let series = &figure.series[index];
        let colour = curve(index, figure.series.len());
        let runs: Vec<Vec<Point>> = runs(series, figure)
            .into_iter()
            .map(|run| run.into_iter().map(|p| self.at(p)).collect())
            .collect();
        let marked = if is_marked(figure) { markers::places(&runs, index) } else { Vec::new() };
        canvas.group("curve", |canvas| {
            for points in runs {
                numbered(canvas, &thin_out(points), series.stroke, (index, colour));
            }
            if series.stroke != Stroke::Points {
                marked.into_iter().for_each(|place| markers::mark(canvas, place, index, colour));
            }
        });
    }

    /// Looks for room that no curve crosses, first beside each mark, then in the corners for the legend.
    fn spots(&self, figure: &LineFigure) -> Spots {
        let mut taken = Vec::new();
        for series in &figure.series {
            for run in runs(series, figure) {
                if series.stroke == Stroke::Points {
                    // a marker takes more room than its centre
                    let around = [(0.0, 0.0), (-7.0, 0.0), (7.0, 0.0), (0.0, -7.0), (0.0, 7.0)];
                    let centres: Vec<Point> = run.iter().map(|p| self.at(*p)).collect();
                    taken.extend(centres.iter().flat_map(|c| around.map(|d| (c.0 + d.0, c.1 + d.1))));
                } else {
                    taken.extend(self.trail(&run));
                }
            }
        }
        let frame = self.frame;
        let mut busy: Vec<Area> = marks(figure)
            .map(|(value, _)| self.x.at(value))
            .map(|x| Area { left: x - 3.0, right: x + 3.0, ..frame })
            .chain(levels::places(frame, self.y, figure))
            .collect();
        let mut labels = Vec::new();
        for (value, label) in marks(figure) {
            let x = self.x.at(value);
            let (width, height) = (text_width(label, TICK) + 8.0, 20.0);
            let candidates = (0..(frame.height() / height) as usize - 1).flat_map(|row| {
                let top = frame.top + 10.0 + height * row as f64;
                [x + 4.0, x - 4.0 - width].map(|left| Area {
                    left,
                    top,
                    right: left + width,
                    bottom: top + height,
                })
            });
            let inside = candidates.filter(|a| a.left > frame.left + 2.0 && a.right < frame.right - 2.0);
            let (area, _) = freest(inside, &taken, &busy).unwrap_or((frame, 0));
            busy.push(area);
            labels.push(area);
        }
        let names = figure.series.iter().map(|s| text_width(&s.name, TICK));
        let width = names.fold(0.0, f64::max) + SAMPLE + 27.0;
        let height = ROW * figure.series.len() as f64 + 12.0;
        let columns =
            [frame.right - 14.0 - width, frame.left + 14.0, 0.5 * (frame.left + frame.right - width)];
        let rows = [frame.top + 12.0, frame.bottom - 12.0 - height];
        let candidates = columns
            .into_iter()
            .flat_map(|left| rows.map(|top| Area { left, top, right: left + width, bottom: top + height }));
        let found = if has_legend(figure) { freest(candidates, &taken, &busy) } else { None };
        let (legend, hits) = found.unwrap_or((Area { bottom: frame.top, ..frame }, 0));
        Spots { legend, crowded: has_legend(figure) && hits > 0, marks: labels }
    }

    /// Points at most 4 px apart along a curve.
    fn trail(&self, run: &[Point]) -> Vec<Point> {
        let mut trail: Vec<Point> = run.iter().take(1).map(|p| self.at(*p)).collect();
        for pair in run.windows(2) {
            let (a, b) = (self.at(pair[0]), self.at(pair[1]));
            let parts = ((b.0 - a.0).hypot(b.1 - a.1) / 4.0).ceil().clamp(1.0, 500.0);
            trail.extend((1..=parts as usize).map(|i| {
                let part = i as f64 / parts;
                (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1))
            }));
        }
        trail
    }
}

/// The first candidate that nothing touches, or the one that touches least; with the number of points touched.
fn freest(candidates: impl Iterator<Item = Area>, taken: &[Point], busy: &[Area]) -> Option<(Area, usize)> {
    let hits = |area: &Area| {
        taken.iter().filter(|p| area.contains(**p)).count()
            + 50 * busy.iter().filter(|other| area.overlaps(other)).count()
    };
    candidates.map(|area| (area, hits(&area))).min_by_key(|(_, hits)| *hits)
}

/// Few curves carry marks; a large family is told by its ramp of colours, which is one of greys too.
fn is_marked(figure: &LineFigure) -> bool {
    figure.series.len() <= FEW
}

/// As [`stroke`], with the markers of curve number `index`.
fn numbered(canvas: &mut Canvas, points: &[Point], kind: Stroke, (index, colour): (usize, Rgb)) {
    if kind == Stroke::Points {
        points.iter().for_each(|point| markers::mark(canvas, *point, index, colour));
    } else {
        stroke(canvas, points, kind, colour);
    }
}

/// The names of the curves, one below the other, each with a piece of its line.
fn legend(canvas: &mut Canvas, figure: &LineFigure, area: Area) {
    canvas.rectangle(area, Some([255; 3]), None);
    for (index, series) in figure.series.iter().enumerate() {
        let y = area.top + 6.0 + ROW * (index as f64 + 0.5);
        let left = area.left + 8.0;
        let ends = match series.stroke {
            Stroke::Points => vec![(left + 0.5 * SAMPLE, y)],
            Stroke::Solid | Stroke::Dashed => vec![(left, y), (left + SAMPLE, y)],
        };
        let colour = curve(index, figure.series.len());
        canvas.group("key", |canvas| {
            numbered(canvas, &ends, series.stroke, (index, colour));
            if is_marked(figure) && index > 0 && series.stroke != Stroke::Points {
                markers::mark(canvas, (left + 0.5 * SAMPLE, y), index, colour);
            }
            canvas.text((left + SAMPLE + 9.0, y + 5.0), &series.name, TICK, Anchor::Start);
        });
    }
}

/// A single curve is named by the axis it lies on.
fn has_legend(figure: &LineFigure) -> bool {
    figure.series.len() > 1
}

/// Draws a line of the usual width, or markers.
pub(super) fn stroke(canvas: &mut Canvas, points: &[Point], stroke: Stroke, colour: Rgb) {
    let pen = Pen::solid(colour, 2.2);
    match stroke {
        // A point alone between gaps makes no line.
        _ if points.len() == 1 => canvas.circle(points[0], 4.2, colour),
        Stroke::Solid => canvas.polyline(points, pen),
        Stroke::Dashed => canvas.polyline(points, Pen { dash: DASH, ..pen }),
        Stroke::Points => points.iter().for_each(|point| canvas.circle(*point, 4.2, colour)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Figure, SecondAxis, Series};
    use crate::output::plot::Picture;

    fn figure() -> LineFigure {
        let x: Vec<f64> = (0..100).map(|i| 10.0 + f64::from(i)).collect();
        let hill = |centre: f64| {
            let y = x.iter().map(|v| 1.0 + 4.0 * (-(v - centre).powi(2) / 200.0).exp());
            y.collect::<Vec<_>>()
        };
        let series =
            |name: &str, centre, stroke| Series { name: name.into(), x: x.clone(), y: hill(centre), stroke };
        LineFigure {
            second_x: Some(SecondAxis { label: "speed [km/h]".into(), factor: 3.6 }),
            series: vec![series("down", 60.0, Stroke::Solid), series("up", 80.0, Stroke::Dashed)],
            marks: vec![(60.0, "critical speed".into())],
            ..LineFigure::new("critical_speed", "Deflection & speed", "speed [m/s]", "deflection [mm]")
        }
    }

    #[test]
    fn the_svg_carries_every_label() {
        let svg = Picture::of(&Figure::Lines(figure())).unwrap().svg;
        for text in [
            "Deflection &amp; speed",
            "speed [m/s]",
            "speed [km/h]",
            "deflection [mm]",
            "down",
            "up",
            "critical speed",
            "stroke-dasharray",
            "viewBox=\"0 0 900 606\"",
        ] {
            assert!(svg.contains(text), "{text} is missing");
        }
    }

    #[test]
    fn levels_and_own_ticks_are_labelled() {
        let mut figure = figure();
        figure.levels = vec![(6.5, "a limit".into())];
        figure.x_ticks = vec![(31.5, "31.5".into()), (900.0, "outside".into())];
        // the axis reaches to the limit
        assert!(ranges(&figure).unwrap().1.1 > 6.5);
        let svg = Picture::of(&Figure::Lines(figure)).unwrap().svg;
        assert!(svg.contains("a limit") && svg.contains(">31.5<") && !svg.contains("outside"));
    }

    #[test]
    fn the_png_has_twice_the_size_of_the_page() {
        let png = Picture::of(&Figure::Lines(figure())).unwrap().png().unwrap();
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!((number(16), number(20)), (1800, 1212));
    }

    #[test]
    fn legend_and_mark_labels_keep_clear_of_the_curves() {
        let figure = figure();
        let (x, y) = ranges(&figure).unwrap();
        let plan = Plan::new(&figure, x, y, 0.0);
        let spots = plan.spots(&figure);
        assert!(!spots.crowded);
        let points = figure.series.iter().flat_map(|s| runs(s, &figure)).flatten();
        for point in points.map(|p| plan.at(p)) {
            assert!(!spots.legend.contains(point));
            assert!(!spots.marks[0].contains(point));
        }
        assert!(!spots.legend.overlaps(&spots.marks[0]));
    }

    #[test]
    fn a_downward_axis_points_down_and_gaps_stay_gaps() {
        let mut figure = figure();
        figure.y_down = true;
        figure.series[0].y[50] = f64::NAN;
        assert_eq!(runs(&figure.series[0], &figure).len(), 2);
        let (x, y) = ranges(&figure).unwrap();
        let plan = Plan::new(&figure, x, y, 0.0);
        assert!(plan.at((20.0, 5.0)).1 > plan.at((20.0, 1.0)).1);
    }

    #[test]
    fn a_curve_breaks_where_a_logarithm_has_no_place_for_it() {
        let mut figure = figure();
        figure.log_y = true;
        figure.series.truncate(1);
        figure.marks.clear();
        for (at, value) in [(20, 0.0), (40, -1.0), (60, f64::NAN), (80, 1e-320)] {
            figure.series[0].y[at] = value;
        }
        let svg = Picture::of(&Figure::Lines(figure)).unwrap().svg;
        // the only curve is drawn in its colour: five pieces, each of one move and lines
        let colour = curve(0, 1).map(|c| format!("{c:02x}")).concat();
        let paths: Vec<&str> = svg.lines().filter(|l| l.contains("<path") && l.contains(&colour)).collect();
        assert_eq!(paths.len(), 5, "{paths:#?}");
        assert!(paths.iter().all(|p| p.matches('M').count() == 1));
    }

    #[test]
    fn whatever_the_values_a_picture_comes_to_an_end() {
        let values =
            [0.0, -0.0, 5e-324, -1e-310, 1e-300, 1.0, 1e300, f64::MAX, f64::MIN, f64::INFINITY, f64::NAN];
        for (a, b) in values.iter().flat_map(|a| values.map(|b| (*a, b))) {
            for log in [false, true] {
                let mut figure = figure();
                (figure.log_x, figure.log_y) = (log, log);
                for series in &mut figure.series {
                    (series.x, series.y) = (vec![a, b, 1.0], vec![b, a, b]);
                }
                // drawn or refused; a wrong range would never end
                let _ = draw(&figure);
            }
        }
    }

    #[test]
    fn a_figure_without_points_is_refused() {
        let mut figure = figure();
        figure.series.clear();
        let error = Picture::of(&Figure::Lines(figure)).unwrap_err().to_string();
        assert!(error.contains("critical_speed"), "{error}");
    }
}
