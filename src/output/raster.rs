//! A drawn page as a PNG, and fields as images within an SVG.

use super::colours::Rgb;
use super::page::{Area, Point};
use kuva::backend::raster::RasterBackend;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene};

/// Pixels of a PNG per unit of the page.
const SHARPNESS: usize = 2;
/// The page is drawn this many times finer and averaged: the rasteriser's own edges are rough on flat curves and on
/// upright text.
const FINER: usize = 2;
/// Pixels per metre of paper: 300 dpi, so that a page 900 wide prints 152 mm wide.
const PRINT: u32 = 11_811;

/// A field as an image of few colours, with square pixels of one unit of the page.
pub(super) struct Image {
    /// Where it lies, on whole units of the page.
    pub area: Area,
    /// The colours.
    pub palette: Vec<Rgb>,
    /// A place in the palette for each pixel, top row first.
    pub pixels: Vec<u8>,
}

/// The page as the bytes of a PNG, two pixels per unit of the page.
pub(super) fn png(page: &Scene, image: Option<&Image>) -> Result<Vec<u8>, String> {
    let mut scene = Scene::new(page.width, page.height);
    for element in &page.elements {
        match element {
            // The page has no group but the place of its image.
            Primitive::GroupStart { .. } => image.into_iter().for_each(|i| scene.add(i.cells())),
            Primitive::GroupEnd => {}
            // The rasteriser starts its dashes anew at every point, so that a smooth curve is drawn solid.
            Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray: Some(dash) } => {
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
    let fine = RasterBackend::new().with_scale((SHARPNESS * FINER) as f32).render_scene(&scene)?;
    averaged(&fine).map_err(|error| error.to_string())
}

impl Image {
    fn columns(&self) -> usize {
        self.area.width() as usize
    }

    /// The pixels as rectangles of the page.
    fn cells(&self) -> Primitive {
        let count = self.pixels.len();
        let place = |i: usize| (i % self.columns(), i / self.columns());
        let fill = |&p: &u8| {
            let [r, g, b] = self.palette[usize::from(p)];
            Color::Rgb(r, g, b)
        };
        Primitive::RectBatch {
            x: (0..count).map(|i| self.area.left + place(i).0 as f64).collect(),
            y: (0..count).map(|i| self.area.top + place(i).1 as f64).collect(),
            w: vec![1.0; count],
            h: vec![1.0; count],
            fills: self.pixels.iter().map(fill).collect(),
        }
    }

    /// An SVG `image` element with the pixels as an embedded PNG.
    pub fn svg(&self) -> String {
        let mut png = Vec::new();
        // Writing to memory fails only for an image without pixels, which then shows as nothing.
        if self.encode(&mut png).is_err() {
            return String::new();
        }
        format!(
            r#"<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="data:image/png;base64,{}"/>"#,
            self.area.left,
            self.area.top,
            self.area.width(),
            self.area.height(),
            base64(&png)
        )
    }

    fn encode(&self, bytes: &mut Vec<u8>) -> Result<(), png::EncodingError> {
        let size = (self.area.width() as u32, self.area.height() as u32);
        let mut encoder = png::Encoder::new(bytes, size.0, size.1);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(self.palette.concat());
        encoder.write_header()?.write_image_data(&self.pixels)
    }
}

/// A PNG of half the size each way, each pixel the mean of [`FINER`]² of the given one, without transparency.
fn averaged(fine: &[u8]) -> Result<Vec<u8>, Box<dyn std::error::Error>> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(fine)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().ok_or("picture too large")?];
    let frame = reader.next_frame(&mut pixels)?;
    let depth = frame.color_type.samples();
    let (width, height) = (frame.width as usize / FINER, frame.height as usize / FINER);
    let mut coarse = Vec::with_capacity(3 * width * height);
    for row in 0..height {
        for column in 0..width {
            for channel in 0..3 {
                let mut sum = 0;
                for (dy, dx) in (0..FINER * FINER).map(|i| (i / FINER, i % FINER)) {
                    let at = (FINER * row + dy) * frame.line_size + (FINER * column + dx) * depth;
                    sum += usize::from(pixels[at + channel]);
                }
                coarse.push(((sum + FINER * FINER / 2) / (FINER * FINER)) as u8);
            }
        }
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: PRINT, yppu: PRINT, unit: png::Unit::Meter }));
    encoder.write_header()?.write_image_data(&coarse)?;
    Ok(bytes)
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

/// Base 64 (RFC 4648) of `bytes`.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let all = group.iter().fold(0u32, |sum, &byte| (sum << 8) | u32::from(byte));
        let all = all << (8 * (3 - group.len()));
        for place in 0..4 {
            text.push(if place <= group.len() {
                char::from(LETTERS[(all >> (18 - 6 * place)) as usize & 63])
            } else {
                '='
            });
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

    #[test]
    fn an_image_fills_its_place_in_the_png() {
        let mut page = Scene::new(4.0, 3.0);
        page.add(Primitive::GroupStart { transform: None, title: None, extra_attrs: None });
        let image = Image {
            area: Area { left: 1.0, top: 1.0, right: 3.0, bottom: 2.0 },
            palette: vec![[10, 20, 30], [200, 100, 0]],
            pixels: vec![0, 1],
        };
        let bytes = png(&page, Some(&image)).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((frame.width, frame.height), (8, 6));
        let at = |x: usize, y: usize| &pixels[3 * (8 * y + x)..][..3];
        assert_eq!(at(1, 2), [255, 255, 255]);
        assert_eq!(at(2, 2), [10, 20, 30]);
        assert_eq!(at(3, 3), [10, 20, 30]);
        assert_eq!(at(4, 2), [200, 100, 0]);
        assert_eq!(at(4, 4), [255, 255, 255]);
    }
}
