//! Polynomials with complex coefficients, lowest power first: sums, products, values, roots.

use num_complex::Complex64;
use std::f64::consts::TAU;

/// Steps of the search for roots allowed; simple roots take ten.
const MOST: usize = 200;

/// a + b.
pub fn plus(a: &[Complex64], b: &[Complex64]) -> Vec<Complex64> {
    let at = |p: &[Complex64], i: usize| p.get(i).copied().unwrap_or_default();
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

/// a b; nothing where one of them has no coefficients.
pub fn times(a: &[Complex64], b: &[Complex64]) -> Vec<Complex64> {
    let mut product = vec![Complex64::ZERO; (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

/// p(x) and p′(x), by Horner.
pub fn value_and_slope(p: &[Complex64], x: Complex64) -> (Complex64, Complex64) {
    p.iter()
        .rev()
        .fold((Complex64::ZERO, Complex64::ZERO), |(value, slope), c| (value * x + c, slope * x + value))
}

/// p(x).
pub fn value(p: &[Complex64], x: Complex64) -> Complex64 {
    p.iter().rev().fold(Complex64::ZERO, |sum, c| sum * x + c)
}

/// All roots; leading coefficients that are zero beside the others make it one of lower degree.
///
/// One or two in closed form without cancellation, more by the simultaneous iteration of Aberth (1973): Newton's step of every root
/// with the others divided out.
///
/// Accuracy: simple roots to rounding of the coefficients (test `tests::roots_are_found`).
pub fn roots(p: &[Complex64]) -> Vec<Complex64> {
    let largest = p.iter().map(|c| c.norm()).fold(0.0, f64::max);
    let degree = p.iter().rposition(|c| c.norm() > 1e-300 * largest).unwrap_or(0);
    let p = &p[..=degree];
    match degree {
        0 => vec![],
        1 => vec![-p[0] / p[1]],
        2 => {
            // the larger one by the sum that does not cancel, the other by Vieta
            let root = (p[1] * p[1] - 4.0 * p[0] * p[2]).sqrt();
            let root = if (root * p[1].conj()).re < 0.0 { -root } else { root };
            let q = -0.5 * (p[1] + root);
            if q == Complex64::ZERO { vec![q; 2] } else { vec![q / p[2], p[0] / q] }
        }
        _ => simultaneous(p),
    }
}

/// On circles whose radii are the slopes of the upper hull of ln|pₖ| over k (Bini 1996), which no missing power disturbs.
fn first_guesses(p: &[Complex64]) -> Vec<Complex64> {
    let slope = |i: usize, j: usize| (p[j].norm().ln() - p[i].norm().ln()) / (j - i) as f64;
    let degree = p.len() - 1;
    // roots at zero
    let mut from = p.iter().position(|c| *c != Complex64::ZERO).unwrap_or(degree);
    let mut guesses = vec![Complex64::ZERO; from];
    while from < degree {
        let ends = from + 1..=degree;
        let to = ends.max_by(|a, b| slope(from, *a).total_cmp(&slope(from, *b))).unwrap_or(degree);
        let turn = |k: usize| TAU * (k - from) as f64 / (to - from) as f64 + 0.7 + from as f64;
        guesses.extend((from..to).map(|k| Complex64::from_polar((-slope(from, to)).exp(), turn(k))));
        from = to;
    }
    guesses
}

/// Aberth's iteration.
fn simultaneous(p: &[Complex64]) -> Vec<Complex64> {
    let degree = p.len() - 1;
    let mut roots = first_guesses(p);
    for _ in 0..MOST {
        let mut moved = 0.0f64;
        for i in 0..degree {
            let x = roots[i];
            let (value, slope) = value_and_slope(p, x);
            let others: Complex64 =
                roots.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, y)| 1.0 / (x - y)).sum();
            let step = value / (slope - value * others);
            if step.is_finite() {
                roots[i] -= step;
                moved = moved.max(step.norm() / roots[i].norm().max(f64::MIN_POSITIVE));
            }
        }
        if moved < 1e-15 {
            break;
        }
    }
    roots
}

#[cfg(test)]
mod tests {
    use super::*;

    fn built(roots: &[Complex64]) -> Vec<Complex64> {
        roots.iter().fold(vec![Complex64::new(0.7, -2.0)], |p, r| times(&p, &[-r, Complex64::ONE]))
    }

    #[test]
    fn roots_are_found() {
        // measured 4e-16 of the root
        for wanted in [
            vec![Complex64::new(0.3, 0.1)],
            vec![Complex64::new(1e-9, 0.0), Complex64::new(1e9, 1.0)],
            vec![Complex64::new(0.9, -1e-3), Complex64::new(0.8, 0.3), Complex64::new(4e4, -2.0)],
            vec![
                Complex64::new(1e-3, 1e-4),
                Complex64::new(-0.5, 0.5),
                Complex64::new(3.0, 0.0),
                Complex64::new(2e3, 5.0),
                Complex64::new(0.0, 1.0),
            ],
        ] {
            let found = roots(&built(&wanted));
            assert_eq!(found.len(), wanted.len());
            for w in &wanted {
                let nearest = found.iter().map(|f| (f - w).norm()).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-14 * w.norm(), "{w}: {nearest:e}");
            }
        }
        assert!(roots(&[Complex64::ONE]).is_empty());
        // powers that are missing, and roots at zero: x²(x⁴ + 1)
        let mut gaps = vec![Complex64::ZERO; 7];
        (gaps[2], gaps[6]) = (Complex64::ONE, Complex64::ONE);
        let found = roots(&gaps);
        assert_eq!(found.iter().filter(|x| **x == Complex64::ZERO).count(), 2);
        assert_eq!(found.iter().filter(|x| (x.powi(4) + 1.0).norm() < 1e-14).count(), 4);
        // a leading coefficient of zero
        assert_eq!(roots(&[-Complex64::ONE, Complex64::ONE, Complex64::ZERO]), [Complex64::ONE]);
    }

    #[test]
    fn sums_products_values() {
        let one = |re: f64| Complex64::from(re);
        let p = times(&[one(1.0), one(2.0)], &[one(3.0), one(-1.0)]);
        assert_eq!(plus(&p, &[one(1.0)]), [one(4.0), one(5.0), one(-2.0)]);
        assert_eq!(value_and_slope(&p, one(2.0)), (one(5.0), one(-3.0)));
        assert_eq!(value(&p, one(2.0)), one(5.0));
    }
}
