//! Lines, text and images on a page, written as SVG: what is drawn here is what SVG, PNG and report show.

use super::colours::{INK, Rgb};
use super::image::Image;
use super::markup::{escape, number};
use super::page::{Area, Point};
use std::fmt::Write as _;

/// Font sizes [px on a page of 900 px].
pub(super) const TITLE: u32 = 19;
pub(super) const LABEL: u32 = 16;
pub(super) const TICK: u32 = 14;

/// Which end of a text stands at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
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
        Self { colour, width, dash: None }
    }

    /// As attributes of an element.
    fn attributes(self) -> String {
        let dash = self.dash.map(|(on, off)| format!(r#" stroke-dasharray="{on} {off}""#));
        format!(
            r#" stroke="{}" stroke-width="{}"{}"#,
            hex(self.colour),
            number(self.width),
            dash.unwrap_or_default()
        )
    }
}

/// A page being drawn.
pub(super) struct Canvas {
    /// [px]
    pub width: f64,
    height: f64,
    /// The elements, one a line.
    body: String,
}

impl Canvas {
    /// A white page of `width` × `height` px.
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new() }
    }

    fn add(&mut self, element: std::fmt::Arguments) {
        // a String takes whatever is written to it
        let _ = writeln!(self.body, "{element}");
    }

    /// What `draw` draws, as one group of a class by which the report's script knows it.
    pub fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        self.add(format_args!(r#"<g class="{class}">"#));
        draw(self);
        self.add(format_args!("</g>"));
    }

    pub fn polyline(&mut self, points: &[Point], pen: Pen) {
        let places: Vec<String> =
            points.iter().map(|(x, y)| format!("{},{}", number(*x), number(*y))).collect();
        self.add(format_args!(r#"<path d="M{}" fill="none"{}/>"#, places.join(" "), pen.attributes()));
    }

    pub fn line(&mut self, from: Point, to: Point, pen: Pen) {
        self.polyline(&[from, to], pen);
    }

    pub fn circle(&mut self, (x, y): Point, radius: f64, ring: Rgb) {
        let (x, y, pen) = (number(x), number(y), Pen::solid(ring, 1.8).attributes());
        self.add(format_args!(r##"<circle cx="{x}" cy="{y}" r="{}" fill="#ffffff"{pen}/>"##, number(radius)));
    }

    pub fn rectangle(&mut self, area: Area, fill: Option<Rgb>, border: Option<Pen>) {
        self.add(format_args!(
            r#"<rect {} fill="{}"{}/>"#,
            place(area),
            fill.map_or("none".to_owned(), hex),
            border.map(Pen::attributes).unwrap_or_default()
        ));
    }

    /// Text on the baseline through the point.
    pub fn text(&mut self, at: Point, text: &str, size: u32, anchor: Anchor) {
        self.put_text(at, text, size, anchor, "");
    }

    /// Text reading upward.
    pub fn upright_text(&mut self, at: Point, text: &str, size: u32) {
        let turned = format!(r#" transform="rotate(-90,{},{})""#, number(at.0), number(at.1));
        self.put_text(at, text, size, Anchor::Middle, &turned);
    }

    fn put_text(&mut self, (x, y): Point, text: &str, size: u32, anchor: Anchor, turned: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let (x, y, text) = (number(x), number(y), escape(text));
        self.add(format_args!(r#"<text x="{x}" y="{y}" font-size="{size}"{anchor}{turned}>{text}</text>"#));
    }

    /// `image` stretched over `area`.
    pub fn image(&mut self, area: Area, image: &Image) {
        let (place, address) = (place(area), image.address());
        self.add(format_args!(r#"<image {place} preserveAspectRatio="none" href="{address}"/>"#));
    }

    /// The page as SVG text; its letters are those of the font in PNGs too, or near ones.
    pub fn svg(&self) -> String {
        let (width, height) = (number(self.width), number(self.height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" fill=\"{}\" \
             stroke-linejoin=\"round\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            hex(INK),
            self.body
        )
    }
}

fn place(area: Area) -> String {
    let [x, y, width, height] = [area.left, area.top, area.width(), area.height()].map(number);
    format!(r#"x="{x}" y="{y}" width="{width}" height="{height}""#)
}

fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
