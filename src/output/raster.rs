//! A drawn page as a PNG, coded once and fast, and fields as images within an SVG.

use super::colours::Rgb;
use super::lettering::{Label, labels};
use super::page::{Area, Point, SHARPNESS};
use super::pixels::Pixels;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene};

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
    let size = |units: f64| (units * SHARPNESS as f64).ceil() as usize;
    let mut pixels = Pixels::white(size(page.width), size(page.height));
    let mut labels = labels(page)?.into_iter();
    for element in &page.elements {
        draw(&mut pixels, element, image, &mut labels);
    }
    encoded(&pixels).map_err(|error| error.to_string())
}

/// Puts one element of a page on `pixels`; the `image` where its group stands, texts as the next of the `labels`.
fn draw(
    pixels: &mut Pixels,
    element: &Primitive,
    image: Option<&Image>,
    labels: &mut impl Iterator<Item = Label>,
) {
    let scale = SHARPNESS as f64;
    match element {
        // The page has no group but the place of its image.
        Primitive::GroupStart { .. } => image.into_iter().for_each(|image| image.put(pixels)),
        Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray } => {
            let pieces = match stroke_dasharray {
                Some(dash) => {
                    let mut lengths = dash.split(' ').filter_map(|part| part.parse().ok());
                    dashes(points, lengths.next().unwrap_or(6.0), lengths.next().unwrap_or(4.0))
                }
                None => vec![points.clone()],
            };
            for piece in pieces {
                pixels.stroke(&scaled(&piece), scale * stroke_width, rgb(stroke));
            }
        }
        Primitive::Rect { x, y, width, height, fill, stroke, stroke_width, .. } => {
            let (right, bottom) = (x + width, y + height);
            if !matches!(fill, Color::None) {
                let area =
                    Area { left: scale * x, top: scale * y, right: scale * right, bottom: scale * bottom };
                pixels.fill(area, rgb(fill));
            }
            if let (Some(stroke), Some(width)) = (stroke, stroke_width) {
                let corners = [(*x, *y), (right, *y), (right, bottom), (*x, bottom), (*x, *y)];
                pixels.stroke(&scaled(&corners), scale * width, rgb(stroke));
            }
        }
        Primitive::Circle { cx, cy, r, fill, stroke, stroke_width, .. } => {
            let (centre, half) = ((scale * cx, scale * cy), 0.5 * stroke_width.unwrap_or(0.0));
            if let Some(stroke) = stroke {
                pixels.disc(centre, scale * (r + half), rgb(stroke));
            }
            pixels.disc(centre, scale * (r - half), rgb(fill));
        }
        Primitive::Text { x, y, rotate, color, .. } => {
            let colour = color.as_ref().map_or([0; 3], rgb);
            for label in labels.by_ref().take(1) {
                label.put(pixels, (scale * x, scale * y), rotate.is_some(), colour);
            }
        }
        _ => {}
    }
}

fn scaled(points: &[Point]) -> Vec<Point> {
    points.iter().map(|(x, y)| (SHARPNESS as f64 * x, SHARPNESS as f64 * y)).collect()
}

/// A page is drawn in plain colours only.
fn rgb(colour: &Color) -> Rgb {
    match colour {
        Color::Rgb(r, g, b) => [*r, *g, *b],
        _ => [0; 3],
    }
}

impl Image {
    fn columns(&self) -> usize {
        self.area.width() as usize
    }

    /// Each pixel as [`SHARPNESS`]² of `pixels`.
    fn put(&self, pixels: &mut Pixels) {
        let (left, top) = (self.area.left as usize, self.area.top as usize);
        for (i, &place) in self.pixels.iter().enumerate() {
            let (column, row) = (left + i % self.columns(), top + i / self.columns());
            pixels.square(SHARPNESS, column, row, self.palette[usize::from(place)]);
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
        encoder.set_compression(png::Compression::Fast);
        encoder.write_header()?.write_image_data(&self.pixels)
    }
}

fn encoded(pixels: &Pixels) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width() as u32, pixels.height() as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: PRINT, yppu: PRINT, unit: png::Unit::Meter }));
    encoder.write_header()?.write_image_data(pixels.rgb())?;
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
