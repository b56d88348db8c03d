//! Lines, text and images on a page, as SVG and as PNG: the only file that draws with the chart library.
//!
//! The chart library's own charts cannot point an axis downward, embed a field as an image or dash a curve in a PNG, so
//! its drawing primitives are used: its SVG writer, its rasteriser and its bundled font.

use super::axis::{Scale, Ticks, superscript};
use super::colours::{FAINT, INK, Rgb};
use kuva::backend::raster::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
pub(super) use kuva::render::render::TextAnchor as Anchor;
use kuva::render::render::{Primitive, Scene};
use std::fmt::Write as _;

/// Font sizes [px on a page of 900 px].
pub(super) const TITLE: u32 = 19;
pub(super) const LABEL: u32 = 16;
pub(super) const TICK: u32 = 14;
/// Pixels of a PNG per unit of the page.
pub(super) const SHARPNESS: f32 = 2.0;
/// Stands for the image within the SVG text until the image is put there.
const IMAGE_MARK: &str = r#"class="field""#;

/// A point of the page [px], y downward.
pub(super) type Point = (f64, f64);

/// An upright rectangle of the page [px].
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub fn contains(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    pub fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// Colour, width [px] and, for a dashed line, the lengths of dash and gap [px].
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    pub colour: Rgb,
    pub width: f64,
    pub dash: Option<(f64, f64)>,
}

impl Pen {
    pub fn solid(colour: Rgb, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: None,
        }
    }
}

/// Equal rectangles of colour filling an area, top row first.
struct Image {
    area: Area,
    columns: usize,
    pixels: Vec<Rgb>,
}

/// A page being drawn.
pub(super) struct Canvas {
    scene: Scene,
    image: Option<Image>,
}

impl Canvas {
    pub fn new(width: f64, height: f64) -> Self {
        let mut scene = Scene::new(width, height);
        scene.font_family = Some("DejaVu Sans, Verdana, Arial, sans-serif".to_owned());
        scene.text_color = Some(hex(INK));
        Self { scene, image: None }
    }

    pub fn polyline(&mut self, points: Vec<Point>, pen: Pen) {
        self.scene.add(Primitive::PolyLine {
            points,
            stroke: colour(pen.colour),
            stroke_width: pen.width,
            stroke_dasharray: pen.dash.map(|(on, off)| format!("{on} {off}")),
        });
    }

    pub fn line(&mut self, from: Point, to: Point, pen: Pen) {
        self.polyline(vec![from, to], pen);
    }

    pub fn circle(&mut self, (cx, cy): Point, radius: f64, ring: Rgb) {
        self.scene.add(Primitive::Circle {
            cx,
            cy,
            r: radius,
            fill: Color::Rgb(255, 255, 255),
            fill_opacity: None,
            stroke: Some(colour(ring)),
            stroke_width: Some(1.8),
        });
    }

    pub fn rectangle(&mut self, area: Area, fill: Option<Rgb>, border: Option<Pen>) {
        self.scene.add(Primitive::Rect {
            x: area.left,
            y: area.top,
            width: area.width(),
            height: area.height(),
            fill: fill.map_or(Color::None, colour),
            stroke: border.map(|pen| colour(pen.colour)),
            stroke_width: border.map(|pen| pen.width),
            opacity: None,
        });
    }

    /// Text on the baseline through the point.
    pub fn text(&mut self, at: Point, text: &str, size: u32, anchor: Anchor) {
        self.put_text(at, text, size, anchor, None);
    }

    /// Text reading upward.
    pub fn upright_text(&mut self, at: Point, text: &str, size: u32) {
        self.put_text(at, text, size, Anchor::Middle, Some(-90.0));
    }

    fn put_text(
        &mut self,
        (x, y): Point,
        text: &str,
        size: u32,
        anchor: Anchor,
        rotate: Option<f64>,
    ) {
        self.scene.add(Primitive::Text {
            x,
            y,
            content: text.to_owned(),
            size,
            anchor,
            rotate,
            bold: false,
            color: Some(colour(INK)),
        });
    }

    /// The one image of the page, beneath what is drawn later: `pixels` by rows of `columns`, top row first.
    pub fn image(&mut self, area: Area, columns: usize, pixels: Vec<Rgb>) {
        self.scene.add(Primitive::GroupStart {
            transform: None,
            title: None,
            extra_attrs: Some(IMAGE_MARK.to_owned()),
        });
        self.scene.add(Primitive::GroupEnd);
        self.image = Some(Image {
            area,
            columns,
            pixels,
        });
    }

    /// Ticks inward, labels and axis label below (`above` = false) or above the frame.
    pub fn x_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, above: bool) {
        let (edge, inward) = if above {
            (frame.top, 1.0)
        } else {
            (frame.bottom, -1.0)
        };
        let pen = Pen::solid(INK, 1.2);
        for &value in &ticks.minor {
            let x = scale.at(value);
            self.line((x, edge), (x, edge + 4.0 * inward), pen);
        }
        for tick in &ticks.major {
            let x = scale.at(tick.value);
            self.line((x, edge), (x, edge + 7.0 * inward), pen);
            let y = if above { edge - 8.0 } else { edge + 20.0 };
            self.text((x, y), &tick.label, TICK, Anchor::Middle);
        }
        let y = if above { edge - 32.0 } else { edge + 46.0 };
        let middle = 0.5 * (frame.left + frame.right);
        let label = format!("{label}{}", factor(ticks.exponent));
        self.text((middle, y), &label, LABEL, Anchor::Middle);
    }

    /// Ticks inward, labels and axis label left of the frame (`right` = false) or right of it.
    pub fn y_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, right: bool) {
        let (edge, inward) = if right {
            (frame.right, -1.0)
        } else {
            (frame.left, 1.0)
        };
        let pen = Pen::solid(INK, 1.2);
        for &value in &ticks.minor {
            let y = scale.at(value);
            self.line((edge, y), (edge + 4.0 * inward, y), pen);
        }
        for tick in &ticks.major {
            let y = scale.at(tick.value);
            self.line((edge, y), (edge + 7.0 * inward, y), pen);
            let anchor = if right { Anchor::Start } else { Anchor::End };
            self.text((edge - 8.0 * inward, y + 5.0), &tick.label, TICK, anchor);
        }
        let away = 8.0 + label_room(ticks) + 14.0;
        let x = if right {
            edge + away + 11.0
        } else {
            edge - away
        };
        let middle = 0.5 * (frame.top + frame.bottom);
        self.upright_text(
            (x, middle),
            &format!("{label}{}", factor(ticks.exponent)),
            LABEL,
        );
    }

    pub fn grid(&mut self, frame: Area, x: (Scale, &Ticks), y: (Scale, &Ticks)) {
        let pen = Pen::solid(FAINT, 1.0);
        for tick in &x.1.major {
            let x = x.0.at(tick.value);
            self.line((x, frame.top), (x, frame.bottom), pen);
        }
        for tick in &y.1.major {
            let y = y.0.at(tick.value);
            self.line((frame.left, y), (frame.right, y), pen);
        }
    }

    pub fn svg(&self) -> String {
        let svg = SvgBackend::new()
            .with_pretty(true)
            .render_scene(&self.scene);
        // Without a viewBox the picture cannot be scaled to a page.
        let (width, height) = (self.scene.width, self.scene.height);
        let view = format!(r#"<svg viewBox="0 0 {width} {height}" "#);
        let svg = svg.replacen("<svg ", &view, 1);
        match &self.image {
            Some(image) => {
                let mark = format!("<g {IMAGE_MARK}>");
                svg.replacen(&mark, &format!("{mark}{}", image.svg()), 1)
            }
            None => svg,
        }
    }

    pub fn png(&self) -> Result<Vec<u8>, String> {
        let mut scene = Scene::new(self.scene.width, self.scene.height);
        for element in &self.scene.elements {
            match (element, &self.image) {
                (Primitive::GroupStart { .. }, Some(image)) => scene.add(image.cells()),
                (Primitive::GroupStart { .. } | Primitive::GroupEnd, _) => {}
                // The rasteriser starts its dashes anew at every point, so that a smooth curve is drawn solid.
                (
                    Primitive::PolyLine {
                        points,
                        stroke,
                        stroke_width,
                        stroke_dasharray: Some(dash),
                    },
                    _,
                ) => {
                    let mut lengths = dash.split(' ').filter_map(|part| part.parse().ok());
                    let (on, off) = (lengths.next().unwrap_or(6.0), lengths.next().unwrap_or(4.0));
                    for points in dashes(points, on, off) {
                        scene.add(Primitive::PolyLine {
                            points,
                            stroke: stroke.clone(),
                            stroke_width: *stroke_width,
                            stroke_dasharray: None,
                        });
                    }
                }
                _ => scene.add(element.clone()),
            }
        }
        RasterBackend::new()
            .with_scale(SHARPNESS)
            .render_scene(&scene)
    }
}

impl Image {
    fn rows(&self) -> usize {
        self.pixels.len() / self.columns
    }

    /// The pixels as rectangles of the page.
    fn cells(&self) -> Primitive {
        let (w, h) = (
            self.area.width() / self.columns as f64,
            self.area.height() / self.rows() as f64,
        );
        let place = |i: usize| (i % self.columns, i / self.columns);
        let count = self.pixels.len();
        Primitive::RectBatch {
            x: (0..count)
                .map(|i| self.area.left + w * place(i).0 as f64)
                .collect(),
            y: (0..count)
                .map(|i| self.area.top + h * place(i).1 as f64)
                .collect(),
            w: vec![w; count],
            h: vec![h; count],
            fills: self.pixels.iter().copied().map(colour).collect(),
        }
    }

    /// An `image` element with the pixels as an embedded PNG.
    fn svg(&self) -> String {
        let (columns, rows) = (self.columns as f64, self.rows() as f64);
        let mut scene = Scene::new(columns, rows);
        let area = Area {
            left: 0.0,
            top: 0.0,
            right: columns,
            bottom: rows,
        };
        let own_size = Self {
            area,
            columns: self.columns,
            pixels: self.pixels.clone(),
        };
        scene.add(own_size.cells());
        // Fails only for an image without pixels, which then shows as nothing.
        let png = RasterBackend::new()
            .with_scale(1.0)
            .render_scene(&scene)
            .unwrap_or_default();
        format!(
            r#"<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="data:image/png;base64,{}"/>"#,
            self.area.left,
            self.area.top,
            self.area.width(),
            self.area.height(),
            base64(&png)
        )
    }
}

/// The pieces of a polyline that a pen of dashes `on` and gaps `off` [px] leaves on the page.
fn dashes(points: &[Point], on: f64, off: f64) -> Vec<Vec<Point>> {
    let mut pieces = Vec::new();
    let mut piece: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, on);
    for pair in points.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let part = done / length;
            let cut = (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1));
            if drawing {
                piece.push(cut);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![cut];
            }
            drawing = !drawing;
            left = if drawing { on } else { off };
        }
        left -= length - done;
        if drawing {
            piece.push(b);
        }
    }
    if drawing && piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

/// ` (×10ⁿ)` after an axis label whose tick labels leave the power out; nothing for n = 0.
fn factor(exponent: i32) -> String {
    match exponent {
        0 => String::new(),
        n => format!("  (×10{})", superscript(n)),
    }
}

/// Width of the longest tick label [px].
pub(super) fn label_room(ticks: &Ticks) -> f64 {
    let widths = ticks.major.iter().map(|t| text_width(&t.label, TICK));
    widths.fold(0.0, f64::max)
}

/// Width of a text [px], a little generous: enough to keep boxes and margins clear of it.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let em = |c: char| match c {
        ' ' | '.' | ',' | ':' | ';' | '|' | '\'' | 'i' | 'j' | 'l' | 'I' | 't' | 'f' | '('
        | ')' | '[' | ']' | '/' | '·' => 0.39,
        'm' | 'w' | 'M' | 'W' | '×' | '−' | '+' | '=' | '–' => 0.92,
        '⁰' | '¹' | '²' | '³' | '⁴' | '⁵' | '⁶' | '⁷' | '⁸' | '⁹' | '⁻' => 0.42,
        c if c.is_uppercase() => 0.72,
        _ => 0.635,
    };
    text.chars().map(em).sum::<f64>() * f64::from(size)
}

fn colour([r, g, b]: Rgb) -> Color {
    Color::Rgb(r, g, b)
}

fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Base 64 (RFC 4648) of `bytes`.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let all = group
            .iter()
            .fold(0u32, |sum, &byte| (sum << 8) | u32::from(byte));
        let all = all << (8 * (3 - group.len()));
        for place in 0..4 {
            if place <= group.len() {
                text.push(char::from(LETTERS[(all >> (18 - 6 * place)) as usize & 63]));
            } else {
                let _ = text.write_char('=');
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_agrees_with_rfc_4648() {
        assert_eq!(base64(b""), "");
        assert_eq!(base64(b"f"), "Zg==");
        assert_eq!(base64(b"fo"), "Zm8=");
        assert_eq!(base64(b"foobar"), "Zm9vYmFy");
    }

    #[test]
    fn dashes_run_on_across_points() {
        let fine: Vec<Point> = (0..=20).map(|i| (f64::from(i), 0.0)).collect();
        let pieces = dashes(&fine, 6.0, 4.0);
        let ends: Vec<_> = pieces.iter().map(|p| (p[0].0, p[p.len() - 1].0)).collect();
        assert_eq!(ends, [(0.0, 6.0), (10.0, 16.0)]);
    }
}
