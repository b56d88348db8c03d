//! The letters of pictures: DejaVu Sans, cut to what is written here (see `font/README.md`).

use std::sync::LazyLock;
use ttf_parser::Face;

/// The font.
pub(super) const FONT: &[u8] = include_bytes!("font/DejaVuSans.ttf");

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
