//! Fields as images of few colours.

use super::colours::Rgb;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;

/// An image of at most 256 colours.
pub(super) struct Image {
    /// Pixels across.
    pub columns: usize,
    /// The colours.
    pub palette: Vec<Rgb>,
    /// A place in the palette for each pixel, top row first.
    pub pixels: Vec<u8>,
}

impl Image {
    /// The image as a PNG in a `data:` address; empty of an image without pixels, which is the only one that cannot be coded.
    pub fn address(&self) -> String {
        let mut png = Vec::new();
        match self.encode(&mut png) {
            Ok(()) => format!("data:image/png;base64,{}", BASE64_STANDARD.encode(&png)),
            Err(_) => String::new(),
        }
    }

    fn encode(&self, bytes: &mut Vec<u8>) -> Result<(), png::EncodingError> {
        let rows = self.pixels.len().checked_div(self.columns).unwrap_or(0);
        let mut encoder = png::Encoder::new(bytes, self.columns as u32, rows as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(self.palette.concat());
        encoder.set_compression(png::Compression::High);
        encoder.write_header()?.write_image_data(&self.pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_reads_back_from_its_address() {
        let palette = vec![[10, 20, 30], [200, 100, 0]];
        let image = Image { columns: 3, palette, pixels: vec![0, 1, 1, 1, 0, 0] };
        let address = image.address();
        let bytes = BASE64_STANDARD.decode(address.strip_prefix("data:image/png;base64,").unwrap()).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((frame.width, frame.height), (3, 2));
        assert_eq!(pixels[..6], [10, 20, 30, 200, 100, 0]);
        let none = Image { columns: 0, palette: Vec::new(), pixels: Vec::new() };
        assert_eq!(none.address(), "");
    }
}
