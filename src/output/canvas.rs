//! Lines, text and images on a page, as SVG and as PNG: the only file that draws with the chart library.
//!
//! The chart library's own charts cannot point an axis downward, embed a field as an image or dash a curve in a PNG, so
//! its drawing primitives are used: its SVG writer, its rasteriser and its bundled font.

use super::axis::{Scale, Ticks, superscript};
use super::colours::{FAINT, INK, Rgb};
use super::lettering::text_width;
use super::page::{Area, Point};
use super::raster::{self, Image};
use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
pub(super) use kuva::render::render::TextAnchor as Anchor;
use kuva::render::render::{Primitive, Scene};

/// Font sizes [px on a page of 900 px].
const TITLE: u32 = 19;
pub(super) const LABEL: u32 = 16;
pub(super) const TICK: u32 = 14;
/// Stands for the image within the SVG text until the image is put there.
const IMAGE_MARK: &str = r#"class="field""#;

/// Colour, width [px] and, for a dashed line, the lengths of dash and gap [px].
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    pub colour: Rgb,
    pub width: f64,
    pub dash: Option<(f64, f64)>,
}

impl Pen {
    pub fn solid(colour: Rgb, width: f64) -> Self {
        Self { colour, width, dash: None }
    }
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

    /// The title, centred over the frame, or on the page if it is wider; smaller if it is wider than the page.
    pub fn title(&mut self, frame: Area, text: &str) {
        let (page, width) = (self.scene.width, text_width(text, TITLE));
        let fit = ((page - 20.0) / width).min(1.0);
        let size = ((f64::from(TITLE) * fit) as u32).max(TICK);
        let middle = if width < frame.width() { 0.5 * (frame.left + frame.right) } else { 0.5 * page };
        self.text((middle, 30.0), text, size, Anchor::Middle);
    }

    /// Text reading upward.
    pub fn upright_text(&mut self, at: Point, text: &str, size: u32) {
        self.put_text(at, text, size, Anchor::Middle, Some(-90.0));
    }

    fn put_text(&mut self, (x, y): Point, text: &str, size: u32, anchor: Anchor, rotate: Option<f64>) {
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

    /// The one image of the page, beneath what is drawn later.
    pub fn image(&mut self, image: Image) {
        self.scene.add(Primitive::GroupStart {
            transform: None,
            title: None,
            extra_attrs: Some(IMAGE_MARK.to_owned()),
        });
        self.scene.add(Primitive::GroupEnd);
        self.image = Some(image);
    }

    /// Ticks outward, tick labels and the axis label, below (`above` = false) or above the frame.
    pub fn x_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, above: bool) {
        let (edge, outward) = if above { (frame.top, -1.0) } else { (frame.bottom, 1.0) };
        let pen = Pen::solid(INK, 1.2);
        for &value in &ticks.minor {
            let x = scale.at(value);
            self.line((x, edge), (x, edge + 3.5 * outward), pen);
        }
        for tick in &ticks.major {
            let x = scale.at(tick.value);
            self.line((x, edge), (x, edge + 6.0 * outward), pen);
            let y = if above { edge - 11.0 } else { edge + 22.0 };
            self.text((x, y), &tick.label, TICK, Anchor::Middle);
        }
        let y = if above { edge - 34.0 } else { edge + 48.0 };
        let middle = 0.5 * (frame.left + frame.right);
        let label = with_power(label, ticks.exponent);
        self.text((middle, y), &label, LABEL, Anchor::Middle);
    }

    /// Ticks outward, tick labels and the axis label, left of the frame (`right` = false) or right of it.
    pub fn y_axis(&mut self, frame: Area, scale: Scale, ticks: &Ticks, label: &str, right: bool) {
        let (edge, outward) = if right { (frame.right, 1.0) } else { (frame.left, -1.0) };
        let pen = Pen::solid(INK, 1.2);
        for &value in &ticks.minor {
            let y = scale.at(value);
            self.line((edge, y), (edge + 3.5 * outward, y), pen);
        }
        for tick in &ticks.major {
            let y = scale.at(tick.value);
            self.line((edge, y), (edge + 6.0 * outward, y), pen);
            let anchor = if right { Anchor::Start } else { Anchor::End };
            self.text((edge + 10.0 * outward, y + 5.0), &tick.label, TICK, anchor);
        }
        // The label reads upward: its baseline is on its right, so it needs more room on the right of a frame.
        let away = 24.0 + label_room(ticks);
        let x = if right { edge + away + 11.0 } else { edge - away };
        let middle = 0.5 * (frame.top + frame.bottom);
        self.upright_text((x, middle), &with_power(label, ticks.exponent), LABEL);
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
        let svg = SvgBackend::new().with_pretty(true).render_scene(&self.scene);
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

    /// The picture as the bytes of a PNG, two pixels per unit of the page.
    pub fn png(&self) -> Result<Vec<u8>, String> {
        raster::png(&self.scene, self.image.as_ref())
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

fn colour([r, g, b]: Rgb) -> Color {
    Color::Rgb(r, g, b)
}

fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
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
