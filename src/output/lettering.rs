//! The letters of pictures: DejaVu Sans, cut to what is written here (see `font/README.md`).

use super::markup::unescape;
use std::fmt::Write as _;
use std::sync::LazyLock;
use ttf_parser::{Face, OutlineBuilder};

/// The font.
const FONT: &[u8] = include_bytes!("font/DejaVuSans.ttf");

static FACE: LazyLock<Option<Face>> = LazyLock::new(|| Face::parse(FONT, 0).ok());

/// Width of a text [px] in the font of the PNGs; a letter it lacks counts as one em.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let em = |c: char| {
        let face = FACE.as_ref()?;
        let advance = face.glyph_hor_advance(face.glyph_index(c)?)?;
        Some(f64::from(advance) / f64::from(face.units_per_em()))
    };
    text.chars().map(|c| em(c).unwrap_or(1.0)).sum::<f64>() * f64::from(size)
}

/// Outlines of letters as the path of an SVG, in units of the font, y up.
#[derive(Default)]
struct Outline {
    path: String,
    /// Where the next letter begins.
    x: f32,
}

impl Outline {
    fn add(&mut self, command: char, points: &[(f32, f32)]) {
        self.path.push(command);
        // a String takes whatever is written to it
        points.iter().for_each(|(x, y)| _ = write!(self.path, "{} {y} ", x + self.x));
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.add('M', &[(x, y)]);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.add('L', &[(x, y)]);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.add('Q', &[(x1, y1), (x, y)]);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.add('C', &[(x1, y1), (x2, y2), (x, y)]);
    }
    fn close(&mut self) {
        self.path.push('Z');
    }
}

/// The page `svg` with the outlines of its letters for its texts, each of which the canvas has written on a line of its own: so that
/// pictures are the same whatever fonts a machine has, and no shaping of text is needed.
pub(super) fn outlined(svg: &str) -> String {
    let line = |line: &str| path_of(line).unwrap_or_else(|| line.to_owned()) + "\n";
    svg.lines().map(line).collect()
}

/// The path of `line` where it is a text.
fn path_of(line: &str) -> Option<String> {
    let (face, (tag, rest)) = (FACE.as_ref()?, line.strip_prefix("<text ")?.split_once('>')?);
    let text = unescape(rest.strip_suffix("</text>")?);
    let said = |key: &str| Some(tag.split_once(&format!("{key}=\""))?.1.split_once('"')?.0);
    let [x, y, size] = ["x", "y", "font-size"].map(|key| said(key).and_then(|said| said.parse::<f64>().ok()));
    let (x, y, size) = (x?, y?, size?);
    let mut outline = Outline::default();
    for c in text.chars() {
        let glyph = face.glyph_index(c);
        glyph.and_then(|glyph| face.outline_glyph(glyph, &mut outline));
        let advance = glyph.and_then(|glyph| face.glyph_hor_advance(glyph));
        outline.x += f32::from(advance.unwrap_or(face.units_per_em()));
    }
    let scale = size / f64::from(face.units_per_em());
    let share = match said("text-anchor") {
        Some("middle") => 0.5,
        Some("end") => 1.0,
        _ => 0.0,
    };
    let left = x - share * scale * f64::from(outline.x);
    let turned = said("transform").unwrap_or("");
    let path = outline.path;
    Some(format!(
        r#"<path transform="{turned} translate({left} {y}) scale({scale} {})" d="{path}"/>"#,
        -scale
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_the_source_is_in_the_font() {
        let letters = "abcxyzABCXYZ0123456789 .,:;()[]/·×−+=–−⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂ₓ′″βωηρντλγκΔ∞≤≥≈→←°µ½äéøå";
        let missing: Vec<char> =
            letters.chars().filter(|c| FACE.as_ref().unwrap().glyph_index(*c).is_none()).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn widths_are_those_of_dejavu_sans() {
        // advances of 0.634, 0.318 and 0.838 em
        assert!((text_width("n", 1000) - 634.0).abs() < 1.0, "{}", text_width("n", 1000));
        assert!((text_width(" −", 1000) - 318.0 - 838.0).abs() < 1.0, "{}", text_width(" −", 1000));
        assert_eq!(text_width("語", 10), 10.0);
    }
}
