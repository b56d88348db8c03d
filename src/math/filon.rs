//! Filon's rules: integrals of f(β)e^{iβx} whose f alone is replaced by straight lines or parabolas between uneven nodes.
//!
//! Source: Filon 1928; Eqs (39)–(42) of the review, corrected.

use super::complex::I;
use num_complex::Complex64;

/// mₖ = ∫₀¹ tᵏe^{iθt} dt, k = 0, 1, 2, by series where the closed form cancels.
///
/// Accuracy: 2e-15 (test `moments_are_continuous`).
fn moments(theta: f64) -> [Complex64; 3] {
    if theta.abs() < 1.0 {
        let mut moments = [Complex64::ZERO; 3];
        let mut power = Complex64::ONE;
        // (iθ)ⁿ/n!(n + k + 1)
        for n in 0..20 {
            for (k, moment) in moments.iter_mut().enumerate() {
                *moment += power / f64::from(n + 1 + k as i32);
            }
            power *= I * theta / f64::from(n + 1);
        }
        return moments;
    }
    let (end, turn) = (Complex64::cis(theta), 1.0 / (I * theta));
    let zeroth = (end - 1.0) * turn;
    let first = (end - zeroth) * turn;
    [zeroth, first, (end - 2.0 * first) * turn]
}

/// ∫ f(β)e^{iβx} dβ of `values` f at `nodes` β, ascending: straight lines between them. At x = 0 the trapezoidal rule.
pub fn linear(nodes: &[f64], values: &[Complex64], x: f64) -> Complex64 {
    let panel = |(nodes, f): (&[f64], &[Complex64])| {
        let width = nodes[1] - nodes[0];
        let [zeroth, first, _] = moments(width * x);
        width * Complex64::cis(nodes[0] * x) * (f[0] * (zeroth - first) + f[1] * first)
    };
    nodes.windows(2).zip(values.windows(2)).map(panel).sum()
}

/// The same with a parabola through every three nodes; their number is odd. Between even nodes at x = 0 Simpson's rule.
pub fn quadratic(nodes: &[f64], values: &[Complex64], x: f64) -> Complex64 {
    let panel = |(nodes, f): (&[f64], &[Complex64])| {
        let width = nodes[2] - nodes[0];
        let [m0, m1, m2] = moments(width * x);
        // Lagrange's parabolas through 0, τ, 1
        let tau = (nodes[1] - nodes[0]) / width;
        let left = (m2 - (1.0 + tau) * m1 + tau * m0) / tau;
        let middle = (m1 - m2) / (tau * (1.0 - tau));
        let right = (m2 - tau * m1) / (1.0 - tau);
        width * Complex64::cis(nodes[0] * x) * (f[0] * left + f[1] * middle + f[2] * right)
    };
    let starts = (0..nodes.len().saturating_sub(2)).step_by(2);
    starts.map(|i| panel((&nodes[i..i + 3], &values[i..i + 3]))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_continuous() {
        for sign in [1.0, -1.0] {
            let (series, closed) = (moments(sign * (1.0 - 1e-15)), moments(sign));
            for (a, b) in series.iter().zip(closed) {
                // measured 1e-15
                assert!((a - b).norm() < 5e-15, "{a} {b}");
            }
        }
        assert_eq!(moments(0.0), [1.0.into(), 0.5.into(), (1.0 / 3.0).into()]);
    }

    #[test]
    fn parabolas_are_exact() {
        // ∫₀² β²e^{iβx} dβ
        let nodes = [0.0, 0.3, 1.1, 1.7, 2.0];
        let values = nodes.map(|beta| Complex64::from(beta * beta));
        for x in [-7.0, 0.2, 3.0] {
            let ix = I * x;
            let primitive =
                |b: f64| (ix * b).exp() * (b * b / ix - 2.0 * b / (ix * ix) + 2.0 / (ix * ix * ix));
            let exact = primitive(2.0) - primitive(0.0);
            // measured 2e-14: the primitive cancels at small x
            assert!((quadratic(&nodes, &values, x) - exact).norm() < 1e-12 * exact.norm());
        }
        let lines = nodes.map(|beta| Complex64::from(3.0 - beta));
        assert!((linear(&nodes, &lines, 2.0) - quadratic(&nodes, &lines, 2.0)).norm() < 1e-14);
    }
}
