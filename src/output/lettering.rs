//! The texts of a page, drawn by the chart library with its bundled font.
//!
//! The library hands over no pixels, only a coded picture. So the texts alone are drawn, close together on a sheet a tenth
//! of the page, and cut out of it.

use super::colours::Rgb;
use super::page::{Point, SHARPNESS};
use super::pixels::Pixels;
use kuva::backend::raster::RasterBackend;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor as Anchor};

/// Room left and right of a text [px of the page]; letters may reach over their own width.
const ROOM: f64 = 4.0;
/// Heights of a line of text over and under its baseline, in font sizes.
const OVER: f64 = 1.25;
const UNDER: f64 = 0.5;

/// A text as ink on pixels.
pub(super) struct Label {
    /// Pixels from its left edge and its top to the point it is anchored at.
    origin: (usize, usize),
    width: usize,
    /// Of 255, row by row.
    ink: Vec<u8>,
}

/// Every text of `page`, in order.
pub(super) fn labels(page: &Scene) -> Result<Vec<Label>, String> {
    let mut sheet = Scene::new(page.width, 0.0);
    // left, top, width and height of each text, and the point it is anchored at [px of the sheet]
    let mut cells = Vec::new();
    let (mut left, mut top, mut line) = (0.0, 0.0, 0.0_f64);
    for element in &page.elements {
        let Primitive::Text { content, size, anchor, bold, .. } = element else { continue };
        let width = (text_width(content, *size) + 2.0 * ROOM).ceil();
        let (over, under) = ((OVER * f64::from(*size)).ceil(), (UNDER * f64::from(*size)).ceil());
        if left + width > sheet.width && left > 0.0 {
            (left, top, line) = (0.0, top + line, 0.0);
        }
        let across = match anchor {
            Anchor::Start => ROOM,
            Anchor::Middle => (0.5 * width).round(),
            Anchor::End => width - ROOM,
        };
        cells.push(((left, top), (width, over + under), (across, over)));
        sheet.add(Primitive::Text {
            x: left + across,
            y: top + over,
            content: content.clone(),
            size: *size,
            anchor: *anchor,
            rotate: None,
            bold: *bold,
            color: Some(Color::Rgb(0, 0, 0)),
        });
        line = line.max(over + under);
        left += width;
        sheet.width = sheet.width.max(width);
        sheet.height = top + line;
    }
    if cells.is_empty() {
        return Ok(Vec::new());
    }
    let drawn = RasterBackend::new().with_scale(SHARPNESS as f32).render_scene(&sheet)?;
    cut(&drawn, &cells).map_err(|error| error.to_string())
}

/// Width of a text [px], a little generous: enough to keep boxes and margins clear of it.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let em = |c: char| match c {
        ' ' | '.' | ',' | ':' | ';' | '|' | '\'' | 'i' | 'j' | 'l' | 'I' | 't' | 'f' | '(' | ')' | '['
        | ']' | '/' | '·' => 0.39,
        'm' | 'w' | 'M' | 'W' | '×' | '−' | '+' | '=' | '–' => 0.92,
        '⁰' | '¹' | '²' | '³' | '⁴' | '⁵' | '⁶' | '⁷' | '⁸' | '⁹' | '⁻' => 0.42,
        c if c.is_uppercase() => 0.72,
        _ => 0.635,
    };
    text.chars().map(em).sum::<f64>() * f64::from(size)
}

/// The `cells` of a picture of black text on white.
fn cut(drawn: &[u8], cells: &[(Point, Point, Point)]) -> Result<Vec<Label>, Box<dyn std::error::Error>> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(drawn)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().ok_or("picture too large")?];
    let frame = reader.next_frame(&mut pixels)?;
    let depth = frame.color_type.samples();
    let whole = |(x, y): Point| (SHARPNESS * x as usize, SHARPNESS * y as usize);
    let label = |&(corner, size, origin): &(Point, Point, Point)| {
        let ((left, top), (width, height)) = (whole(corner), whole(size));
        let row = |row: usize| pixels[row * frame.line_size + depth * left..].chunks(depth).take(width);
        let ink = (top..top + height).flat_map(row).map(|pixel| 255 - pixel[0]).collect();
        Label { origin: whole(origin), width, ink }
    };
    Ok(cells.iter().map(label).collect())
}

impl Label {
    /// Puts the text on `pixels` with its anchor at the point [px], level or reading upward.
    pub fn put(&self, pixels: &mut Pixels, (x, y): Point, upward: bool, colour: Rgb) {
        let (x, y) = (x.round() as i64, y.round() as i64);
        for (i, &ink) in self.ink.iter().enumerate().filter(|(_, ink)| **ink > 0) {
            let along = (i % self.width) as i64 - self.origin.0 as i64;
            let down = (i / self.width) as i64 - self.origin.1 as i64;
            let (column, row) = if upward { (x + down, y - 1 - along) } else { (x + along, y + down) };
            pixels.dot(column, row, colour, ink);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::canvas::Canvas;
    use super::super::page::{Area, SHARPNESS};

    /// Columns and rows that a page's ink reaches from and to.
    fn reach(png: &[u8]) -> [usize; 4] {
        let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let width = reader.next_frame(&mut pixels).unwrap().width as usize;
        let dark = || (0..pixels.len() / 3).filter(|i| pixels[3 * i] < 128);
        let (columns, rows) = (|| dark().map(|i| i % width), || dark().map(|i| i / width));
        [columns().min(), columns().max(), rows().min(), rows().max()].map(|edge| edge.unwrap())
    }

    #[test]
    fn texts_stand_at_their_anchors_level_and_upward() {
        let anchors = [super::Anchor::Start, super::Anchor::Middle, super::Anchor::End];
        for (anchor, share) in anchors.into_iter().zip([0.0, 0.5, 1.0]) {
            let mut level = Canvas::new(200.0, 200.0);
            level.text((100.0, 100.0), "HnH", 16, anchor);
            let [left, right, top, bottom] = reach(&level.png().unwrap());
            let width = (right - left) as f64;
            // letters stand on the baseline, and a little in from the ends of their line
            assert_eq!(bottom, 199, "{share}");
            assert!((left as f64 - (200.0 - share * width)).abs() < 6.0, "{share}: {left} {right}");
            assert!((20..28).contains(&(bottom - top)), "{top} {bottom}");
        }
        let mut upward = Canvas::new(200.0, 200.0);
        upward.upright_text((100.0, 100.0), "HnH", 16);
        let [_, right, top, bottom] = reach(&upward.png().unwrap());
        assert_eq!(right, 199);
        assert!((top + bottom).abs_diff(400) < 6, "{top} {bottom}");
    }

    #[test]
    fn a_text_wider_than_the_page_is_drawn_whole() {
        let mut page = Canvas::new(60.0, 40.0);
        page.rectangle(Area { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 }, None, None);
        page.text((30.0, 20.0), "wider than its page", 16, super::Anchor::Middle);
        let [left, right, ..] = reach(&page.png().unwrap());
        // a letter or the gap between two at either edge
        assert!(left < 8 && right > 60 * SHARPNESS - 9, "{left} {right}");
    }
}
