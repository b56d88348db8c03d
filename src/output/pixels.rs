//! Lines, areas, discs and masks on a grid of pixels, their edges smooth.

use super::colours::Rgb;
use super::page::{Area, Point};
use std::ops::Range;

/// A picture; x to the right and y down, in pixels, whose centres lie at halves.
pub(super) struct Pixels {
    width: usize,
    rgb: Vec<u8>,
    /// How much of each pixel the line being drawn covers, of 255; zero between lines.
    stencil: Vec<u8>,
}

impl Pixels {
    /// A white picture.
    pub fn white(width: usize, height: usize) -> Self {
        Self { width, rgb: vec![255; 3 * width * height], stencil: vec![0; width * height] }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.stencil.len().checked_div(self.width).unwrap_or(0)
    }

    /// Red, green and blue of every pixel, row by row from the top.
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Lays `colour` over `covered` of 255 parts of the pixel at `place`.
    fn lay(&mut self, place: usize, colour: Rgb, covered: u8) {
        let covered = u32::from(covered);
        for (below, above) in self.rgb[3 * place..][..3].iter_mut().zip(colour) {
            *below = ((u32::from(above) * covered + u32::from(*below) * (255 - covered) + 127) / 255) as u8;
        }
    }

    /// The same, where the pixel lies in the picture.
    pub fn dot(&mut self, column: i64, row: i64, colour: Rgb, covered: u8) {
        let (Ok(column), Ok(row)) = (usize::try_from(column), usize::try_from(row)) else { return };
        if column < self.width && row < self.height() {
            self.lay(row * self.width + column, colour, covered);
        }
    }

    /// The square of `side`² pixels at `column`, `row` of a grid of such squares.
    pub fn square(&mut self, side: usize, column: usize, row: usize, colour: Rgb) {
        for row in side * row..(side * (row + 1)).min(self.height()) {
            let from = (row * self.width + side * column).min(self.stencil.len());
            let to = (from + side).min((row + 1) * self.width);
            self.rgb[3 * from..3 * to].chunks_exact_mut(3).for_each(|pixel| pixel.copy_from_slice(&colour));
        }
    }

    /// An upright rectangle.
    pub fn fill(&mut self, area: Area, colour: Rgb) {
        let inside = |low: f64, high: f64, i: usize| (high.min(i as f64 + 1.0) - low.max(i as f64)).max(0.0);
        for row in within(area.top, area.bottom, self.height()) {
            for column in within(area.left, area.right, self.width) {
                let covered = inside(area.top, area.bottom, row) * inside(area.left, area.right, column);
                self.lay(row * self.width + column, colour, (255.0 * covered).round() as u8);
            }
        }
    }

    /// A line through `points`, its corners and ends round.
    pub fn stroke(&mut self, points: &[Point], width: f64, colour: Rgb) {
        // a pixel at a corner is covered once, by the piece that covers more of it
        let mut touched = Vec::new();
        for pair in points.windows(2) {
            let (size, stencil) = ((self.width, self.height()), &mut self.stencil);
            capsule(size, (pair[0], pair[1]), 0.5 * width, |place, covered| {
                if stencil[place] == 0 {
                    touched.push(place);
                }
                stencil[place] = stencil[place].max(covered);
            });
        }
        for place in touched {
            let covered = std::mem::take(&mut self.stencil[place]);
            self.lay(place, colour, covered);
        }
    }

    /// A filled circle.
    pub fn disc(&mut self, centre: Point, radius: f64, colour: Rgb) {
        let size = (self.width, self.height());
        capsule(size, (centre, centre), radius, |place, covered| self.lay(place, colour, covered));
    }
}

/// The pixels of `count` that an interval touches.
fn within(low: f64, high: f64, count: usize) -> Range<usize> {
    // a float below zero or not a number becomes 0
    low.floor() as usize..(high.ceil() as usize).min(count)
}

/// Gives `mark` each pixel nearer than `half` to the line between two points, with its share of 255: at the edge, the part of
/// a pixel's width that lies within.
fn capsule(
    (width, height): (usize, usize),
    (a, b): (Point, Point),
    half: f64,
    mut mark: impl FnMut(usize, u8),
) {
    let reach = half + 0.5;
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    for row in within(a.1.min(b.1) - reach, a.1.max(b.1) + reach, height) {
        let y = row as f64 + 0.5 - a.1;
        let (mut left, mut right) = (a.0.min(b.0) - reach, a.0.max(b.0) + reach);
        if dy != 0.0 {
            // |x d_y − y d_x| ≤ reach · length
            let (middle, room) = (a.0 + y * dx / dy, reach * square.sqrt() / dy.abs());
            (left, right) = (left.max(middle - room), right.min(middle + room));
        }
        for column in within(left, right, width) {
            let x = column as f64 + 0.5 - a.0;
            let along = if square > 0.0 { ((x * dx + y * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
            let (x, y) = (x - along * dx, y - along * dy);
            let covered = (255.0 * (reach - (x * x + y * y).sqrt()).clamp(0.0, 1.0)).round() as u8;
            if covered > 0 {
                mark(row * width + column, covered);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Rgb = [0, 0, 0];

    /// How much ink lies on each pixel, in pixels, row by row.
    fn ink(pixels: &Pixels) -> Vec<f64> {
        pixels.rgb().chunks(3).map(|p| 1.0 - f64::from(p[0]) / 255.0).collect()
    }

    #[test]
    fn a_line_is_as_wide_as_asked_whichever_way_it_runs() {
        for end in [(40.0, 10.0), (10.0, 40.0), (38.2, 31.7), (33.3, 12.1)] {
            let mut pixels = Pixels::white(60, 60);
            pixels.stroke(&[(10.0, 10.0), end], 3.0, INK);
            let length = (end.0 - 10.0).hypot(end.1 - 10.0);
            let area = 3.0 * length + 2.25 * std::f64::consts::PI;
            let sum: f64 = ink(&pixels).iter().sum();
            // measured 2 % at worst: edges are smoothed by distance, not by area
            assert!((sum / area - 1.0).abs() < 0.04, "{end:?}: {sum} of {area}");
        }
    }

    #[test]
    fn corners_are_not_drawn_twice() {
        let (mut whole, mut pieces) = (Pixels::white(40, 20), Pixels::white(40, 20));
        whole.stroke(&[(5.0, 5.3), (35.0, 14.6)], 2.4, INK);
        let points: Vec<Point> = (0..=30).map(|i| (5.0 + f64::from(i), 5.3 + 0.31 * f64::from(i))).collect();
        pieces.stroke(&points, 2.4, INK);
        let apart = ink(&whole).iter().zip(ink(&pieces)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // measured 0.004, one of 255
        assert!(apart < 0.01, "{apart}");
        assert!(pieces.stencil.iter().all(|&covered| covered == 0));
    }

    #[test]
    fn areas_and_discs_cover_what_they_should_and_stay_on_the_page() {
        let mut pixels = Pixels::white(8, 6);
        pixels.fill(Area { left: 1.5, top: 2.0, right: 4.0, bottom: 3.25 }, INK);
        assert!((ink(&pixels).iter().sum::<f64>() - 2.5 * 1.25).abs() < 0.02);
        let mut pixels = Pixels::white(30, 30);
        pixels.disc((15.0, 15.0), 8.0, INK);
        // measured 0.1 %
        assert!((ink(&pixels).iter().sum::<f64>() / (64.0 * std::f64::consts::PI) - 1.0).abs() < 0.01);
        for far in [(-50.0, -50.0), (80.0, 15.0), (f64::NAN, 3.0)] {
            pixels.disc(far, 3.0, [9; 3]);
            pixels.stroke(&[far, far], 3.0, [9; 3]);
            pixels.dot(far.0 as i64, -3, [9; 3], 255);
        }
        assert!(pixels.rgb().iter().all(|&byte| byte != 9));
    }
}
