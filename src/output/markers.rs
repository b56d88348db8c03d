//! Marks along curves, so that they are told apart without colour.

use super::canvas::{Canvas, Pen};
use super::colours::Rgb;
use super::page::Point;

/// Half-width of a mark [px].
const SIZE: f64 = 4.2;
/// Distance between the marks of a curve, and what those of the next curve are ahead [px].
const SPACING: f64 = 150.0;
const AHEAD: f64 = 43.0;

/// Outlines on the unit square, y downward: square, triangle, diamond, triangle downward, cross, plus.
const SHAPES: [&[Point]; 6] = [
    &[(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85), (-0.85, -0.85)],
    &[(0.0, -1.1), (1.0, 0.8), (-1.0, 0.8), (0.0, -1.1)],
    &[(0.0, -1.25), (1.0, 0.0), (0.0, 1.25), (-1.0, 0.0), (0.0, -1.25)],
    &[(0.0, 1.1), (1.0, -0.8), (-1.0, -0.8), (0.0, 1.1)],
    &[(-1.0, -1.0), (1.0, 1.0), (0.0, 0.0), (1.0, -1.0), (-1.0, 1.0)],
    &[(-1.2, 0.0), (1.2, 0.0), (0.0, 0.0), (0.0, -1.2), (0.0, 1.2)],
];

/// The mark of curve number `index` at `centre`; the first has a circle.
pub(super) fn mark(canvas: &mut Canvas, centre: Point, index: usize, colour: Rgb) {
    canvas.group("marker", |canvas| match index.checked_sub(1) {
        None => canvas.circle(centre, SIZE, colour),
        Some(index) => {
            let shape = SHAPES[index % SHAPES.len()];
            let outline: Vec<Point> =
                shape.iter().map(|(x, y)| (centre.0 + SIZE * x, centre.1 + SIZE * y)).collect();
            canvas.polyline(&outline, Pen::solid(colour, 1.8));
        }
    });
}

/// Points in equal distances along the stretches `runs` of curve number `index`; none of the first curve, which is known by that.
pub(super) fn places(runs: &[Vec<Point>], index: usize) -> Vec<Point> {
    let mut places = Vec::new();
    if index == 0 {
        return places;
    }
    let mut next = (AHEAD * index as f64) % SPACING + 0.2 * SPACING;
    for pair in runs.iter().flat_map(|run| run.windows(2)) {
        let (a, b) = (pair[0], pair[1]);
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        while next <= length {
            let share = next / length;
            places.push((a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1)));
            next += SPACING;
        }
        next -= length;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_keep_their_distance_along_bends_and_gaps() {
        let runs = [vec![(0.0, 0.0), (100.0, 0.0), (100.0, 200.0)], vec![(300.0, 0.0), (700.0, 0.0)]];
        assert!(places(&runs, 0).is_empty());
        let found = places(&runs, 1);
        // first after 43 + 30 px, then every 150 px of 700
        assert_eq!(found.len(), 5);
        assert_eq!(found[0], (73.0, 0.0));
        assert!((found[1].0 - 100.0).abs() < 1e-9 && (found[1].1 - 123.0).abs() < 1e-9);
        assert!((found[2].0 - 373.0).abs() < 1e-9, "{found:?}");
        assert!(places(&runs, 2) != places(&runs, 3));
    }
}
