//! Fields over a rectangle.

use super::axis::{PLACES, Scale};
use super::canvas::{Canvas, LABEL, Pen};
use super::colours::{INK, MISSING, Rgb, diverging, sequential};
use super::frame::label_room;
use super::image::Image;
use super::lettering::text_width;
use super::lines::BELOW;
use super::page::Area;
use super::{OutputError, overlay, readout};
use crate::figure::MapFigure;

/// Page width [px].
const WIDTH: f64 = 900.0;
/// Largest frame around the field [px].
const LARGEST: (f64, f64) = (700.0, 700.0);
/// Frame height of a map whose axes are not equal [px].
const HEIGHT: f64 = 440.0;
/// Width of the colour bar, and its distance from the frame [px].
const BAR: (f64, f64) = (18.0, 22.0);
/// Steps of the colours; the next place of the palette is for what is not a number, those after it for hatched colours. Indexed images
/// are small.
const STEPS: u8 = 169;
/// Pixels from one line of the hatching to the next: over what is below zero where the sign matters, since on grey paper both ends of the
/// colours are dark.
const HATCHING: usize = 8;
/// Steps from the middle on within which nothing is hatched: 5 % of the largest value.
const UNHATCHED: u8 = 4;

/// Where field and colour bar stand on the page.
struct Layout {
    frame: Area,
    bar: Area,
    /// A flat map has its colour bar below, where the label has room.
    flat: bool,
    /// How far an upright label reaches beyond the frame [px].
    overhang: f64,
}

impl Layout {
    /// The frame that holds `x_span` by `y_span`, to scale if the figure wants it, and the bar of `range`.
    fn new(figure: &MapFigure, x_span: (f64, f64), y_span: (f64, f64), range: (f64, f64)) -> Self {
        let lengths = (x_span.1 - x_span.0, y_span.1 - y_span.0);
        let ticks = |span| Scale::new(span, false, (1.0, 0.0)).ticks(8);
        let left = (label_room(&ticks(y_span)) + 46.0).round();
        let flat = figure.equal_axes && lengths.1 < 0.4 * lengths.0;
        let (right, room) = if flat {
            (34.0, WIDTH - left - 34.0)
        } else {
            let right = BAR.0 + BAR.1 + label_room(&ticks(range)) + 48.0;
            (right, LARGEST.0.min(WIDTH - left - right))
        };
        let (width, height) = if figure.equal_axes {
            let per_metre = (room / lengths.0).min(LARGEST.1 / lengths.1);
            (per_metre * lengths.0, per_metre * lengths.1)
        } else {
            (room, HEIGHT)
        };
        // A narrow map is centred on the page, with its colour bar.
        let start = (left + 0.5 * (WIDTH - left - right - width)).round();
        let beside = if flat { "" } else { &figure.value_label };
        let longest = text_width(&figure.y_label, LABEL).max(text_width(beside, LABEL));
        let overhang = 0.5 * (longest - height);
        let top = (40.0 + overhang).max(52.0).round();
        let frame = Area { left: start, top, right: start + width.round(), bottom: top + height.round() };
        let bar = if flat {
            Area { top: frame.bottom + 70.0, bottom: frame.bottom + 70.0 + BAR.0, ..frame }
        } else {
            Area { left: frame.right + BAR.1, right: frame.right + BAR.1 + BAR.0, ..frame }
        };
        Self { frame, bar, flat, overhang }
    }
}

/// Draws the figure. The field is an embedded image, interpolated linearly between its values; what is not a number is
/// grey. With it, what it tells under the pointer.
pub(super) fn draw(figure: &MapFigure) -> Result<(Canvas, String), OutputError> {
    let refuse = |reason: String, needed: &str| OutputError::Figure {
        figure: figure.name.clone(),
        reason,
        needed: needed.to_owned(),
    };
    let (nx, ny) = (figure.x.len(), figure.y.len());
    if figure.values.dim() != (ny, nx) || nx < 2 || ny < 2 {
        let reason = format!("{:?} values over {ny} × {nx} points (y, x)", figure.values.dim());
        return Err(refuse(reason, "one value per point, and two points each way at least"));
    }
    let Some(range) = range(figure) else {
        return Err(refuse("no value is finite".to_owned(), "a finite value at least"));
    };
    let (x_span, y_span) = (outer(&figure.x), outer(&figure.y));
    let Layout { frame, bar, flat, overhang } = Layout::new(figure, x_span, y_span, range);
    let x = Scale::new(x_span, false, (frame.left, frame.right));
    let y = Scale::new(y_span, false, (frame.bottom, frame.top));

    let under = (frame.bottom + overhang).max(bar.bottom + BELOW);
    let keys = overlay::legend(&figure.overlay, (frame.left, under), WIDTH - 20.0);
    let mut canvas = Canvas::new(WIDTH, (under + keys.height).round());
    let palette = palette(figure.symmetric);
    let size = [frame.width() as usize, frame.height() as usize];
    let field = Image { columns: size[0], palette, pixels: pixels(figure, size, range) };
    canvas.group("plot", |canvas| {
        canvas.image(frame, &field);
        overlay::draw(canvas, &figure.overlay, (x, x_span), (y, y_span));
    });
    keys.draw(&mut canvas, &figure.overlay);
    canvas.rectangle(frame, None, Some(Pen::solid(INK, 1.2)));
    let x_count = ((frame.width() / 90.0) as usize).clamp(3, 8);
    canvas.x_axis(frame, x, &x.ticks(x_count), &figure.x_label, false);
    let y_count = ((frame.height() / 45.0) as usize).clamp(3, 8);
    canvas.y_axis(frame, y, &y.ticks(y_count), &figure.y_label, false);
    colour_bar(&mut canvas, bar, flat, (field.palette, figure.symmetric));
    if flat {
        let scale = Scale::new(range, false, (bar.left, bar.right));
        canvas.x_axis(bar, scale, &scale.ticks(8), &figure.value_label, false);
    } else {
        let scale = Scale::new(range, false, (bar.bottom, bar.top));
        canvas.y_axis(bar, scale, &scale.ticks(y_count), &figure.value_label, true);
    }
    canvas.title(frame, &figure.title);
    Ok((canvas, readout::of_map(figure, frame, x, y)))
}

/// The colours of all steps, and of what is not a number.
fn palette(symmetric: bool) -> Vec<Rgb> {
    let part = |step: u8| f64::from(step) / f64::from(STEPS - 1);
    let colour = |t: f64| if symmetric { diverging(2.0 * t - 1.0) } else { sequential(t) };
    let colours = (0..STEPS).map(|step| colour(part(step)));
    // a line is light where the field is dark, and dark where it is light
    let line = |rgb: Rgb| {
        let light = rgb.iter().map(|c| u32::from(*c)).sum::<u32>() < 3 * 128;
        rgb.map(|c| if light { 255 - (255 - c) / 2 } else { c / 2 + c / 8 })
    };
    let hatched = (0..STEPS / 2 - UNHATCHED).map(|step| line(colour(part(step)))).filter(|_| symmetric);
    colours.clone().chain([MISSING]).chain(hatched).collect()
}

/// The place in the palette of `step` at a pixel (column, row): on a line of the hatching that of its line.
fn hatched(step: u8, symmetric: bool, (column, row): (usize, usize)) -> u8 {
    let on_line = (column + row).is_multiple_of(HATCHING);
    if symmetric && on_line && step < STEPS / 2 - UNHATCHED { STEPS + 1 + step } else { step }
}

/// The colours side by side, from the left or from below, hatched as the field is.
fn colour_bar(canvas: &mut Canvas, bar: Area, flat: bool, (palette, symmetric): (Vec<Rgb>, bool)) {
    let [columns, rows] = [bar.width() as usize, bar.height() as usize];
    let step = |i: usize, count: usize| (i * usize::from(STEPS) / count) as u8;
    let pixel = |(column, row): (usize, usize)| {
        let step = if flat { step(column, columns) } else { step(rows - 1 - row, rows) };
        hatched(step, symmetric, (column, row))
    };
    let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).map(pixel).collect();
    canvas.image(bar, &Image { columns, palette, pixels });
    canvas.rectangle(bar, None, Some(Pen::solid(INK, 1.2)));
}

/// The edges of the outermost cells.
fn outer(points: &[f64]) -> (f64, f64) {
    let last = points.len() - 1;
    let half = 0.5 * (points[last] - points[0]) / last as f64;
    (points[0] - half, points[last] + half)
}

/// The values at both ends of the colours: symmetric about zero if the figure is; never an empty range.
fn range(figure: &MapFigure) -> Option<(f64, f64)> {
    let held = figure.holds.into_iter().flat_map(|(low, high)| [low, high]);
    let finite = figure.values.iter().copied().chain(held).filter(|v| v.abs() < PLACES.end);
    let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
    if lo > hi {
        return None;
    }
    let size = lo.abs().max(hi.abs());
    let unit = if size >= PLACES.start { size } else { 1.0 };
    Some(if figure.symmetric {
        (-unit, unit)
    } else if size >= PLACES.start && lo >= 0.0 && lo < 0.1 * hi {
        // A modulus: its colours begin at zero.
        (0.0, hi)
    } else if hi - lo > 1e-12 * unit {
        (lo, hi)
    } else {
        (lo - 0.5 * unit, hi + 0.5 * unit)
    })
}

/// The image: at every pixel's centre the step of `range` for the value interpolated linearly in x and y, the top row being the
/// largest y.
fn pixels(figure: &MapFigure, [columns, rows]: [usize; 2], range: (f64, f64)) -> Vec<u8> {
    let (ny, nx) = figure.values.dim();
    // ⌊(v − lo)/(hi − lo) · STEPS⌋
    let place = |value: f64| {
        let part = (value - range.0) / (range.1 - range.0);
        if part.is_nan() { STEPS } else { ((part * f64::from(STEPS)) as u8).min(STEPS - 1) }
    };
    // Cells reach half a spacing beyond the outer points, where the field is held constant.
    let places = |count: usize, n: usize| -> Vec<(usize, f64)> {
        (0..count)
            .map(|i| {
                let place = (i as f64 + 0.5) / count as f64 * n as f64 - 0.5;
                let place = place.clamp(0.0, (n - 1) as f64);
                let below = (place as usize).min(n - 2);
                (below, place - below as f64)
            })
            .collect()
    };
    let across = places(columns, nx);
    let mut image = Vec::with_capacity(columns * rows);
    for (at_row, &(j, v)) in places(rows, ny).iter().rev().enumerate() {
        for (at_column, &(i, u)) in across.iter().enumerate() {
            let row = |j: usize| (1.0 - u) * figure.values[[j, i]] + u * figure.values[[j, i + 1]];
            let step = place((1.0 - v) * row(j) + v * row(j + 1));
            image.push(hatched(step, figure.symmetric, (at_column, at_row)));
        }
    }
    image
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Figure, Series, Stroke};
    use crate::output::plot::Picture;
    use ndarray::Array2;

    fn figure(nx: usize, ny: usize, symmetric: bool) -> MapFigure {
        let axis = |n: usize, span: f64| -> Vec<f64> {
            (0..n).map(|i| span * (i as f64 / (n - 1) as f64 - 0.5)).collect()
        };
        let (x, y) = (axis(nx, 60.0), axis(ny, 40.0));
        let values = Array2::from_shape_fn((ny, nx), |(j, i)| {
            (0.9 * x[i].hypot(y[j])).cos() * (-0.05 * x[i].hypot(y[j])).exp()
        });
        MapFigure {
            name: "contour_137".into(),
            title: "Vertical displacement".into(),
            x_label: "x [m]".into(),
            y_label: "y [m]".into(),
            value_label: "displacement [mm]".into(),
            x,
            y,
            values,
            holds: None,
            symmetric,
            equal_axes: true,
            overlay: Vec::new(),
        }
    }

    #[test]
    fn a_large_field_stays_a_light_svg() {
        let svg = Picture::of(&Figure::Map(figure(1100, 1024, true))).unwrap().svg;
        assert!(svg.len() < 1_000_000, "{} bytes", svg.len());
        for text in ["data:image/png;base64,iVBOR", "x [m]", "y [m]", "displacement [mm]", "Vertical"] {
            assert!(svg.contains(text), "{text} is missing");
        }
    }

    #[test]
    fn the_png_has_twice_the_size_of_the_page() {
        let png = Picture::of(&Figure::Map(figure(61, 41, false))).unwrap().png().unwrap();
        let width = u32::from_be_bytes(png[16..20].try_into().unwrap());
        assert_eq!(width, 1800);
    }

    #[test]
    fn a_flat_map_has_its_colour_bar_below() {
        let mut map = figure(121, 11, true);
        map.y.iter_mut().for_each(|y| *y *= 0.2);
        let svg = Picture::of(&Figure::Map(map)).unwrap().svg;
        let label = svg.lines().find(|l| l.contains("displacement [mm]")).unwrap();
        assert!(!label.contains("rotate"), "{label}");
    }

    #[test]
    fn colours_are_symmetric_about_zero_where_the_sign_matters() {
        let mut map = figure(21, 21, true);
        map.values.fill(0.0);
        map.values[[3, 4]] = -2.0;
        assert_eq!(range(&map), Some((-2.0, 2.0)));
        map.symmetric = false;
        assert_eq!(range(&map), Some((-2.0, 0.0)));
        map.values.fill(f64::NAN);
        assert!(Picture::of(&Figure::Map(map)).is_err());
    }

    #[test]
    fn curves_over_the_field_are_cut_at_its_edge_and_named_below() {
        let mut map = figure(31, 31, false);
        let plain = Picture::of(&Figure::Map(map.clone())).unwrap().svg;
        let names = ["first mode", "free track"];
        map.overlay = [Stroke::Solid, Stroke::Dashed]
            .into_iter()
            .zip(names)
            .map(|(stroke, name)| Series {
                name: name.into(),
                x: vec![-20.0, 20.0],
                y: vec![-90.0, 90.0],
                stroke,
            })
            .collect();
        let drawn = Picture::of(&Figure::Map(map)).unwrap().svg;
        let page = |svg: &str| {
            let view = svg.split("viewBox=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
            view.split(' ').map(|v| v.parse().unwrap()).collect::<Vec<f64>>()
        };
        assert!(page(&drawn)[3] > page(&plain)[3]);
        for name in names {
            assert!(drawn.contains(name) && !plain.contains(name), "{name}");
        }
    }

    #[test]
    fn the_image_has_large_y_on_top() {
        let mut map = figure(3, 3, false);
        map.values = Array2::from_shape_fn((3, 3), |(j, _)| j as f64);
        let rows = pixels(&map, [3, 3], (0.0, 2.0));
        assert_eq!([rows[0], rows[4], rows[8]], [168, 84, 0]);
        // below zero, where the sign matters, every eighth diagonal is a line
        map.symmetric = true;
        let rows = pixels(&map, [8, 3], (-9.0, 2.0));
        assert!(rows.iter().all(|place| *place <= STEPS), "{rows:?}");
        map.values.fill(-8.0);
        let rows = pixels(&map, [8, 3], (-9.0, 9.0));
        assert_eq!(rows.iter().filter(|place| **place > STEPS).count(), 3);
        assert!(rows.iter().all(|place| usize::from(*place) < palette(true).len()));
    }
}
