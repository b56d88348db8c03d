//! Roots of real functions in a bracket and of complex functions from a start.

use num_complex::Complex64;

/// A root of `f` between `a` and `b`, where `f` changes its sign, to `relative` of its size; None if it does not change.
///
/// Regula falsi in the form of Anderson & Björck (1973), whose order is 1.7, with bisection when it is slow.
pub fn bracketed(mut f: impl FnMut(f64) -> f64, a: f64, b: f64, relative: f64) -> Option<f64> {
    let (mut a, mut b) = (a, b);
    let (mut f_a, mut f_b) = (f(a), f(b));
    if f_a == 0.0 {
        return Some(a);
    }
    if f_b == 0.0 {
        return Some(b);
    }
    // false for NaN
    let changes = f_a * f_b.signum() < 0.0;
    if !changes {
        return None;
    }
    for step in 0..200 {
        let width = (b - a).abs();
        if width <= relative * a.abs().max(b.abs()) {
            break;
        }
        let secant = b - f_b * (b - a) / (f_b - f_a);
        let x = if step % 4 == 3 || !secant.is_finite() { 0.5 * (a + b) } else { secant };
        let f_x = f(x);
        if f_x == 0.0 {
            return Some(x);
        }
        if f_x * f_b.signum() < 0.0 {
            (a, f_a) = (b, f_b);
        } else {
            // the end that stays counts for less
            let m = 1.0 - f_x / f_b;
            f_a *= if m > 0.0 { m } else { 0.5 };
        }
        (b, f_b) = (x, f_x);
    }
    Some(if f_b.abs() < f_a.abs() { b } else { 0.5 * (a + b) })
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
        // measured 30
        assert!(count < 45, "{count}");
        assert_eq!(bracketed(|x| x * x + 1.0, -1.0, 2.0, 1e-10), None);
    }

    #[test]
    fn finds_complex_roots() {
        let root = complex(|z| z * z + 1.0, Complex64::new(0.3, 0.8), 1e-13).unwrap();
        assert!((root - Complex64::new(0.0, 1.0)).norm() < 1e-12);
        assert_eq!(complex(|_| Complex64::ONE, Complex64::ONE, 1e-13), None);
    }
}
