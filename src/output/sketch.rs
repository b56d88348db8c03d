//! Train, track and ground, one above the other; lengths along the train are to scale, thicknesses as far as their labels leave room.

use super::axis::Scale;
use super::canvas::{Anchor, Canvas, Pen, TICK};
use super::colours::{GREY, INK, Rgb};
use super::lettering::text_width;
use super::page::{Area, Point};
use crate::figure::{DrawnLayer, SketchFigure};

/// Page width, and what is left free on both sides [px].
const WIDTH: f64 = 900.0;
const MARGIN: f64 = 40.0;
/// Radius of a wheel, height of a part of the track, of the thinnest and of all layers together [px].
const WHEEL: f64 = 7.0;
const PART: f64 = 26.0;
const THINNEST: f64 = 26.0;
const ALL_LAYERS: f64 = 300.0;
/// Half-width of the track [px].
const TRACK: f64 = 60.0;
/// Shear wave speeds between which the shade of a layer changes [m/s].
const SHADED: (f64, f64) = (60.0, 800.0);

/// Darker the stiffer: a shade of brown that print in grey keeps apart.
fn shade(layer: &DrawnLayer) -> Rgb {
    let Some(speed) = layer.shear_speed else { return [150, 150, 150] };
    let part = ((speed / SHADED.0).ln() / (SHADED.1 / SHADED.0).ln()).clamp(0.0, 1.0);
    let between = |light: f64, dark: f64| (light + part * (dark - light)).round() as u8;
    [between(250.0, 176.0), between(243.0, 150.0), between(228.0, 116.0)]
}

/// Draws the figure.
pub(super) fn draw(figure: &SketchFigure) -> Canvas {
    let total: f64 = figure.layers.iter().filter_map(|layer| layer.thickness).sum();
    let height = |layer: &DrawnLayer| match layer.thickness {
        Some(thickness) => (ALL_LAYERS * thickness / total).max(THINNEST),
        None => 1.6 * THINNEST,
    };
    let ground: f64 = figure.layers.iter().map(height).sum();
    let train = if figure.axles.is_empty() { 0.0 } else { 110.0 };
    let track = PART * figure.track.len() as f64 + 14.0;
    let mut canvas = Canvas::new(WIDTH, 56.0 + train + track + ground + 20.0);
    canvas.title(Area { left: MARGIN, right: WIDTH - MARGIN, top: 50.0, bottom: 60.0 }, &figure.title);
    let mut y = 56.0;
    if train > 0.0 {
        axles(&mut canvas, figure, y);
        y += train;
    }
    for part in &figure.track {
        let area = Area { left: MARGIN + 20.0, right: MARGIN + 20.0 + 2.0 * TRACK, top: y, bottom: y + PART };
        if part.is_spring {
            [-0.6, 0.0, 0.6]
                .into_iter()
                .for_each(|x| spring(&mut canvas, MARGIN + 20.0 + TRACK * (1.0 + x), y));
        } else {
            let bar = Area { top: y + 5.0, bottom: y + PART - 5.0, ..area };
            canvas.rectangle(bar, Some([205, 205, 205]), Some(Pen::solid(INK, 1.2)));
        }
        canvas.text((area.right + 16.0, y + 0.5 * PART + 5.0), &part.label, TICK, Anchor::Start);
        y += PART;
    }
    y += 14.0;
    let mut depth = 0.0;
    for layer in &figure.layers {
        let area = Area { left: MARGIN, right: WIDTH - MARGIN, top: y, bottom: y + height(layer) };
        canvas.rectangle(area, Some(shade(layer)), None);
        canvas.line((area.left, y), (area.right, y), Pen::solid(INK, 1.4));
        canvas.text(
            (area.left + 20.0, 0.5 * (area.top + area.bottom) + 5.0),
            &layer.label,
            TICK,
            Anchor::Start,
        );
        let at = format!("{depth:.2}");
        let at = format!("{} m", at.trim_end_matches('0').trim_end_matches('.'));
        canvas.text((area.right - 8.0, y + 16.0), &at, TICK, Anchor::End);
        depth += layer.thickness.unwrap_or(0.0);
        y = area.bottom;
    }
    canvas
}

/// A zigzag over the height of a part.
fn spring(canvas: &mut Canvas, x: f64, top: f64) {
    let at = |i: usize| -> Point {
        let side = [0.0, 5.0, -5.0, 5.0, -5.0, 0.0][i];
        (x + side, top + PART * i as f64 / 5.0)
    };
    canvas.polyline(&[0, 1, 2, 3, 4, 5].map(at), Pen::solid(GREY, 1.6));
}

/// Wheels with their loads above a rail, positions below it; the leading axle on the right, as in all pictures.
fn axles(canvas: &mut Canvas, figure: &SketchFigure, top: f64) {
    let last = figure.axles.iter().map(|a| a.0).fold(0.0, f64::max);
    let room = (MARGIN + 40.0, WIDTH - MARGIN - 40.0);
    // a short train does not fill the page
    let length = last.max(20.0);
    let scale = Scale::new((-length, 0.0), false, room);
    let rail = top + 62.0;
    canvas.line((MARGIN, rail), (WIDTH - MARGIN, rail), Pen::solid(INK, 2.4));
    let mut free_from = f64::NEG_INFINITY;
    let mut sorted = figure.axles.clone();
    sorted.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (behind, load) in &sorted {
        let x = scale.at(-behind);
        canvas.circle((x, rail - WHEEL - 1.0), WHEEL, INK);
        let label = format!("{:.0} kN", 1e-3 * load);
        let half = 0.5 * text_width(&label, TICK);
        // those that would lie over one another are left out
        if x - half > free_from {
            canvas.text((x, rail - 2.0 * WHEEL - 12.0), &label, TICK, Anchor::Middle);
            free_from = x + half + 8.0;
        }
    }
    let ticks = scale.ticks(8);
    let frame = Area { left: room.0, right: room.1, top, bottom: rail };
    for tick in &ticks.major {
        let x = scale.at(tick.value);
        canvas.line((x, rail), (x, rail + 5.0), Pen::solid(INK, 1.0));
        canvas.text((x, rail + 20.0), &tick.label, TICK, Anchor::Middle);
    }
    canvas.text((frame.right, rail + 38.0), "x′ [m], travel to the right", TICK, Anchor::End);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{DrawnPart, Figure};
    use crate::output::plot::Picture;

    #[test]
    fn everything_is_written() {
        let layer =
            |label: &str, thickness, shear_speed| DrawnLayer { label: label.into(), thickness, shear_speed };
        let figure = SketchFigure {
            name: "model".into(),
            title: "The railway".into(),
            axles: vec![(0.0, 150e3), (2.5, 150e3), (17.375, 160e3)],
            track: vec![
                DrawnPart { label: "rail".into(), is_spring: false },
                DrawnPart { label: "pads".into(), is_spring: true },
            ],
            layers: vec![
                layer("soft clay", Some(0.01), Some(50.0)),
                layer("till", Some(8.0), Some(300.0)),
                layer("rock", None, None),
            ],
        };
        let svg = Picture::of(&Figure::Sketch(figure)).unwrap().svg;
        for text in ["soft clay", "till", "rock", "rail", "pads", "150 kN", "160 kN", "8.01 m"] {
            assert!(svg.contains(text), "{text}");
        }
        let (soft, stiff) = (layer("", None, Some(50.0)), layer("", None, Some(900.0)));
        assert!(shade(&soft)[0] > shade(&stiff)[0]);
    }
}
