//! The maximum of a function of one variable inside a bracket.

/// Golden-section search for the largest `f` in [from, to], to `width` in the abscissa: (abscissa, value).
///
/// `f` should have one maximum in the bracket; otherwise one of them is found. Fails with the first error of `f`.
pub fn golden_section<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    mut from: f64,
    mut to: f64,
    width: f64,
) -> Result<(f64, f64), E> {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    let mut a = to - RATIO * (to - from);
    let mut b = from + RATIO * (to - from);
    let (mut f_a, mut f_b) = (f(a)?, f(b)?);
    while to - from > width {
        if f_a >= f_b {
            (to, b, f_b) = (b, a, f_a);
            a = to - RATIO * (to - from);
            f_a = f(a)?;
        } else {
            (from, a, f_a) = (a, b, f_b);
            b = from + RATIO * (to - from);
            f_b = f(b)?;
        }
    }
    Ok(if f_a >= f_b { (a, f_a) } else { (b, f_b) })
}

#[cfg(test)]
mod tests {
    use super::golden_section;

    #[test]
    fn finds_the_top_of_a_parabola() {
        let top = golden_section(|x| Ok::<_, ()>(3.0 - (x - 1.7).powi(2)), 0.0, 4.0, 1e-4).unwrap();
        assert!((top.0 - 1.7).abs() < 1e-4 && (top.1 - 3.0).abs() < 1e-8);
    }
}
