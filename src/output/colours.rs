//! Colours: of curves, and of fields (perceptually uniform, readable with a colour-vision deficiency).

/// Red, green, blue.
pub(super) type Rgb = [u8; 3];

/// Ink of frames and text.
pub(super) const INK: Rgb = [34, 34, 34];
/// Marks and helper lines.
pub(super) const GREY: Rgb = [110, 110, 110];
/// Grid lines.
pub(super) const FAINT: Rgb = [228, 228, 228];
/// A value that is not a number.
pub(super) const MISSING: Rgb = [190, 190, 190];

/// Curves that have a hue each.
pub(super) const FEW: usize = CURVES.len();
/// Okabe & Ito (2008), Color universal design, without its yellow, its light blue and its orange darkened: lines stand out from white
/// by 3 : 1 (WCAG 1.4.11).
const CURVES: [Rgb; 7] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [50, 150, 205], [190, 130, 0], [0, 0, 0]];

/// viridis: Smith & van der Walt (2015), in matplotlib under CC0, sampled at 33 equal steps.
#[rustfmt::skip]
const VIRIDIS: [Rgb; 33] = [
    [68, 1, 84], [71, 13, 96], [72, 24, 106], [72, 35, 116], [71, 45, 123], [69, 55, 129], [66, 64, 134],
    [62, 73, 137], [59, 82, 139], [55, 91, 141], [51, 99, 141], [47, 107, 142], [44, 114, 142], [41, 122, 142],
    [38, 130, 142], [35, 137, 142], [33, 144, 140], [31, 151, 139], [31, 159, 136], [33, 166, 133], [39, 173, 129],
    [49, 181, 123], [62, 188, 116], [77, 194, 108], [92, 200, 99], [110, 206, 88], [130, 211, 77], [149, 216, 64],
    [170, 220, 50], [192, 223, 37], [213, 226, 26], [234, 229, 26], [253, 231, 37],
];

/// `vik`: Crameri (2018), Scientific colour maps, doi 10.5281/zenodo.1243862, sampled at 33 equal steps.
#[rustfmt::skip]
const VIK: [Rgb; 33] = [
    [0, 18, 97], [2, 31, 105], [2, 43, 113], [2, 55, 121], [3, 68, 129], [5, 81, 137], [12, 94, 146], [28, 109, 156],
    [48, 125, 166], [72, 141, 178], [97, 158, 189], [122, 174, 200], [148, 190, 210], [173, 205, 221],
    [198, 219, 230], [222, 230, 233], [236, 229, 224], [238, 217, 205], [233, 202, 184], [226, 186, 162],
    [219, 170, 141], [213, 155, 121], [207, 140, 102], [201, 126, 83], [194, 112, 65], [188, 98, 47], [178, 81, 29],
    [163, 62, 13], [145, 45, 6], [129, 31, 6], [115, 20, 6], [101, 9, 7], [89, 0, 8],
];

/// Colour of curve `index` of `count`: distinct hues while they last, an ordered ramp for a larger family.
pub(super) fn curve(index: usize, count: usize) -> Rgb {
    if count <= CURVES.len() {
        CURVES[index % CURVES.len()]
    } else {
        // The light end of viridis does not show on white.
        sequential(0.59 * index as f64 / (count - 1) as f64)
    }
}

/// viridis at `t` in [0, 1].
pub(super) fn sequential(t: f64) -> Rgb {
    between(&VIRIDIS, t)
}

/// vik at `t` in [−1, 1]: blue below zero, red above.
pub(super) fn diverging(t: f64) -> Rgb {
    between(&VIK, 0.5 * (t + 1.0))
}

/// A colour at `t` in [0, 1] of a row of colours.
fn between(colours: &[Rgb; 33], t: f64) -> Rgb {
    let place = 32.0 * t.clamp(0.0, 1.0);
    let below = (place as usize).min(31);
    let part = place - below as f64;
    std::array::from_fn(|i| {
        let (a, b) = (f64::from(colours[below][i]), f64::from(colours[below + 1][i]));
        (a + part * (b - a)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, coarse but enough to tell light from dark.
    fn light([r, g, b]: Rgb) -> f64 {
        0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
    }

    #[test]
    fn curves_stand_out_from_white() {
        let linear =
            |v: u8| (f64::from(v) / 255.0 / 12.92).max(((f64::from(v) / 255.0 + 0.055) / 1.055).powf(2.4));
        for (index, count) in
            [3, 7, 8, 40].into_iter().flat_map(|count| (0..count).map(move |index| (index, count)))
        {
            let [r, g, b] = curve(index, count).map(linear);
            let contrast = 1.05 / (0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05);
            // measured 3.06 (a hue) and 3.09 (the ramp) at least; WCAG 1.4.11 asks for 3
            assert!(contrast > 3.0, "{contrast} of {index} among {count}");
        }
    }

    #[test]
    fn the_sequential_map_brightens_all_the_way() {
        let lights: Vec<_> = (0..=20).map(|i| light(sequential(f64::from(i) / 20.0))).collect();
        assert!(lights.windows(2).all(|w| w[1] > w[0]), "{lights:?}");
    }

    #[test]
    fn the_diverging_map_is_lightest_at_zero_and_darkens_alike() {
        assert_eq!(diverging(0.0), VIK[16]);
        for i in 1..=10 {
            let t = f64::from(i) / 10.0;
            for side in [t, -t] {
                assert!(light(diverging(side)) < light(diverging(side - 0.1 * side.signum())));
            }
            // Measured: 17 of 255 at most.
            assert!((light(diverging(t)) - light(diverging(-t))).abs() < 25.0);
        }
    }
}
