//! Roots of real functions in a bracket and of complex functions from a start.

use num_complex::Complex64;

/// A root of `f` between `a` and `b`, where `f` changes its sign, to `relative` of its size; None if it does not change.
///
/// Inverse quadratic interpolation where the last three values say that it converges, else bisection.
/// Source: Chandrupatla 1997, Adv. Eng. Softw. 28:145.
pub fn bracketed(mut f: impl FnMut(f64) -> f64, a: f64, b: f64, relative: f64) -> Option<f64> {
    let (mut a, mut b) = (a, b);
    let (mut f_a, mut f_b) = (f(a), f(b));
    if f_a == 0.0 {
        return Some(a);
    }
    if f_b == 0.0 {
        return Some(b);
    }
    let product = f_a * f_b.signum();
    if product.is_nan() || product >= 0.0 {
        return None;
    }
    // a is the latest point, b holds the root against it; the next one lies a share of the way from a to b
    let mut share = f_a / (f_a - f_b);
    for _ in 0..200 {
        let x = a + share * (b - a);
        let f_x = f(x);
        if f_x == 0.0 {
            return Some(x);
        }
        // the point left behind
        let (c, f_c);
        if (f_x > 0.0) == (f_a > 0.0) {
            (c, f_c) = (a, f_a);
        } else {
            (c, f_c) = (b, f_b);
            (b, f_b) = (a, f_a);
        }
        (a, f_a) = (x, f_x);
        let best = if f_a.abs() < f_b.abs() { a } else { b };
        let least = 0.5 * relative * best.abs() / (b - a).abs();
        if least >= 0.5 || a == b {
            return Some(best);
        }
        let (xi, phi) = ((a - b) / (c - b), (f_a - f_b) / (f_c - f_b));
        share = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            let (first, second) = (f_a / (f_b - f_a), f_b / (f_c - f_b));
            -first * f_c / (f_c - f_b) + (c - a) / (b - a) * f_a / (f_c - f_a) * second
        } else {
            0.5
        };
        share = share.max(least).min(1.0 - least);
    }
    Some(if f_b.abs() < f_a.abs() { b } else { a })
}

/// A root of the complex `f` near `start` by the secant method, to `relative` of its size; None if it does not settle.
pub fn complex(
    mut f: impl FnMut(Complex64) -> Complex64,
    start: Complex64,
    relative: f64,
) -> Option<Complex64> {
    let (mut a, mut b) = (start * (1.0 + 1e-6), start);
    let (mut f_a, mut f_b) = (f(a), f(b));
    for _ in 0..40 {
        if f_b == Complex64::ZERO {
            return Some(b);
        }
        let step = f_b * (b - a) / (f_b - f_a);
        // not finite once both values are rounding
        if !step.is_finite() {
            return ((b - a).norm() <= relative * b.norm()).then_some(b);
        }
        (a, f_a) = (b, f_b);
        b -= step;
        if step.norm() <= relative * b.norm() {
            return Some(b);
        }
        f_b = f(b);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_roots_flat_and_steep() {
        let mut count = 0;
        let root = bracketed(
            |x: f64| {
                count += 1;
                x.powi(9) - 1e-3
            },
            0.0,
            4.0,
            1e-13,
        );
        assert!((root.unwrap() - 1e-3f64.powf(1.0 / 9.0)).abs() < 1e-12);
        // measured 14
        assert!(count < 20, "{count}");
        assert_eq!(bracketed(|x| x * x + 1.0, -1.0, 2.0, 1e-10), None);
        // one that bends, one that leaps, one beside another
        let mut worst = 0;
        for (f, low, high, root) in [
            (
                &(|x: f64| (5.0 * x).sin() * x.exp()) as &dyn Fn(f64) -> f64,
                1.2,
                1.3,
                std::f64::consts::PI / 2.5,
            ),
            (&|x| if x < 0.7 { -1.0 } else { 1.0 }, 0.0, 1.0, 0.7),
            (&|x| (x - 0.5) * (x - 0.5001), 0.0, 0.500_05, 0.5),
        ] {
            let mut count = 0;
            let counted = |x: f64| {
                count += 1;
                f(x)
            };
            assert!((bracketed(counted, low, high, 1e-14).unwrap() - root).abs() < 2e-14);
            worst = worst.max(count);
        }
        // measured 49, of the leap: as many as halves of the bracket
        assert!(worst < 60, "{worst}");
    }

    #[test]
    fn finds_complex_roots() {
        let root = complex(|z| z * z + 1.0, Complex64::new(0.3, 0.8), 1e-13).unwrap();
        assert!((root - Complex64::new(0.0, 1.0)).norm() < 1e-12);
        assert_eq!(complex(|_| Complex64::ONE, Complex64::ONE, 1e-13), None);
    }
}
