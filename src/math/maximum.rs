//! The maximum of a function of one variable inside a bracket.

/// Abscissa and value.
type Point = (f64, f64);

/// The largest `f` between the outer two of three points, of which the middle one is the highest, to `width` in the abscissa, by
/// parabolas through the three that bracket it; a point too near the best one is moved into the longer side instead, which every third step halves.
///
/// `f` should have one maximum in the bracket; otherwise one of them is found. Fails with the first error of `f`.
pub fn by_parabolas<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    [mut left, mut best, mut right]: [Point; 3],
    width: f64,
) -> Result<Point, E> {
    for step in 1.. {
        if right.0 - left.0 <= width {
            break;
        }
        // vertex of the parabola through the three
        let (p, q) = ((best.0 - left.0) * (best.1 - right.1), (best.0 - right.0) * (best.1 - left.1));
        let vertex = best.0 - 0.5 * ((best.0 - left.0) * p - (best.0 - right.0) * q) / (p - q);
        let longer = if right.0 - best.0 > best.0 - left.0 { 1.0 } else { -1.0 };
        let near = !((vertex - best.0).abs() >= 0.4 * width && vertex > left.0 && vertex < right.0);
        let x = match step % 3 {
            // where parabolas crawl, as along the sides of a tent
            0 => 0.5 * (best.0 + if longer > 0.0 { right.0 } else { left.0 }),
            _ if near => best.0 + longer * 0.45 * width,
            _ => vertex,
        };
        let found = (x, f(x)?);
        let (lower, higher) = if found.1 > best.1 { (best, found) } else { (found, best) };
        if lower.0 < higher.0 {
            left = lower
        } else {
            right = lower
        }
        best = higher;
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::by_parabolas;

    /// From a bracket 4 wide, and how often it asked.
    fn top(f: impl Fn(f64) -> f64) -> (f64, u32) {
        let mut count = 0;
        let asked = |x: f64| {
            count += 1;
            Ok::<_, ()>(f(x))
        };
        let top = by_parabolas(asked, [0.0, 2.0, 4.0].map(|x| (x, f(x))), 0.1).unwrap();
        (top.0, count)
    }

    #[test]
    fn finds_the_top_of_a_parabola() {
        let (x, count) = top(|x| 3.0 - (x - 1.7).powi(2));
        assert!((x - 1.7).abs() < 1e-12 && count <= 3, "{x} {count}");
    }

    #[test]
    fn finds_the_top_of_a_skewed_peak_and_of_a_tent() {
        // the bracket is 0.1 wide: measured 0.01 with 5 values, and 0.05 with 9
        let (x, count) = top(|x| (1.0 + (x - 1.6).powi(2)).recip() + 0.02 * x);
        assert!((x - 1.61).abs() < 0.05 && count <= 6, "{x} {count}");
        let (x, count) = top(|x| -(x - 2.3).abs());
        assert!((x - 2.3).abs() < 0.1 && count <= 15, "{x} {count}");
    }
}
