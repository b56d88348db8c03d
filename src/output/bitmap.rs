//! A page as a PNG, drawn from its SVG.

use super::lettering::outlined;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{ImageRendering, Options, Tree};

/// Pixels per unit of the page.
const SHARPNESS: f32 = 2.0;
/// Pixels per metre of paper: 300 dpi, so that a page 900 wide prints 152 mm wide.
const PRINT: u32 = 11_811;

/// The bytes of a PNG, two pixels per unit of the page; the reason if `svg` has no size above zero.
pub(super) fn of(svg: &str) -> Result<Vec<u8>, String> {
    // fields keep their pixels: smoothed, they code into files half as large again
    let options = Options { image_rendering: ImageRendering::OptimizeSpeed, ..Options::default() };
    let tree = Tree::from_str(&outlined(svg), &options).map_err(|error| error.to_string())?;
    let size = tree.size().to_int_size().scale_by(SHARPNESS).ok_or("no size")?;
    let mut pixels = Pixmap::new(size.width(), size.height()).ok_or("page too large")?;
    // a page that ends within a pixel
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(SHARPNESS, SHARPNESS), &mut pixels.as_mut());
    encoded(&pixels).map_err(|error| error.to_string())
}

/// Without the alpha, which is full everywhere on a white page.
fn encoded(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let rgb: Vec<u8> =
        pixels.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: PRINT, yppu: PRINT, unit: png::Unit::Meter }));
    encoder.write_header()?.write_image_data(&rgb)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::super::canvas::{Anchor, Canvas, Pen};
    use super::super::image::Image;
    use super::super::page::Area;

    /// Width, and red, green and blue of every pixel.
    fn pixels(page: &Canvas) -> (usize, Vec<[u8; 3]>) {
        let png = super::of(&page.svg()).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let width = reader.next_frame(&mut bytes).unwrap().width as usize;
        (width, bytes.chunks(3).map(|p| [p[0], p[1], p[2]]).collect())
    }

    #[test]
    fn texts_stand_at_their_anchors_and_images_fill_their_place() {
        for (anchor, share) in [(Anchor::Start, 0.0), (Anchor::Middle, 0.5), (Anchor::End, 1.0)] {
            let mut page = Canvas::new(200.0, 200.0);
            page.text((100.0, 100.0), "HnH", 16, anchor);
            let (width, pixels) = pixels(&page);
            let dark: Vec<usize> = (0..pixels.len()).filter(|i| pixels[*i][0] < 128).collect();
            let (left, right) = (dark.iter().map(|i| i % width).min(), dark.iter().map(|i| i % width).max());
            let (left, right) = (left.unwrap() as f64, right.unwrap() as f64);
            // letters stand on the baseline, and a little in from the ends of their line
            assert_eq!(dark.last().unwrap() / width, 199);
            assert!((left - (200.0 - share * (right - left))).abs() < 6.0, "{share}: {left} {right}");
            let told = 2.0 * super::super::lettering::text_width("HnH", 16);
            // measured 5: the room beside an H on both sides
            assert!((right - left - told).abs() < 8.0, "{left} {right} {told}");
        }
        let mut page = Canvas::new(4.0, 3.0);
        let palette = vec![[10, 20, 30], [200, 100, 0]];
        let area = Area { left: 1.0, top: 1.0, right: 3.0, bottom: 2.0 };
        page.image(area, &Image { columns: 2, palette, pixels: vec![0, 1] });
        let (width, pixels) = pixels(&page);
        assert_eq!((width, pixels.len()), (8, 48));
        let at = |x: usize, y: usize| pixels[8 * y + x];
        assert_eq!([at(1, 2), at(2, 2), at(3, 3)], [[255; 3], [10, 20, 30], [10, 20, 30]]);
        assert_eq!([at(4, 2), at(5, 3), at(4, 4)], [[200, 100, 0], [200, 100, 0], [255; 3]]);
    }

    #[test]
    fn dashes_leave_gaps_and_a_broken_page_is_white_to_its_end() {
        let mut page = Canvas::new(40.0, 9.3);
        let pen = Pen { dash: Some((6.0, 4.0)), ..Pen::solid([0; 3], 2.0) };
        page.line((0.0, 5.0), (40.0, 5.0), pen);
        let (width, pixels) = pixels(&page);
        let dark = pixels[10 * width..11 * width].iter().filter(|p| p[0] < 128).count();
        // four dashes of 6 in 40, two pixels each
        assert_eq!(dark, 48);
        assert_eq!(pixels.last(), Some(&[255; 3]));
        assert!(super::of(&Canvas::new(0.0, 4.0).svg()).is_err());
    }
}
