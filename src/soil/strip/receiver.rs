//! The surface beside a loaded strip, at one distance, at many, and horizontally: the integrals of `strip` with other kernels.

use super::{Compliances, Kernel, Outline, integral, known, sinc, tail, tail_at};
use crate::math::bessel::modified_bessel;
use crate::math::complex::I;
use crate::math::quadrature::{Estimate, Node};
use crate::soil::Motion;
use num_complex::Complex64;
use std::f64::consts::PI;

/// The integrals of `tail_integrals` with C = sinc(q b) cos(q y): displacement at `y` under a strip, or under a line where b = 0 < y.
///
/// The means of K₀(β_c x)/π and (x/β_c) K₁(β_c x)/π over |y − b| … y + b.
pub(in crate::soil) fn receiver_tail_integrals(beta_c: f64, b: f64, y: f64) -> (f64, f64) {
    if b == 0.0 {
        let m = modified_bessel(beta_c * y);
        return (m.k0 / PI, y / beta_c * m.k1 / PI);
    }
    // odd primitives of both from 0
    let primitives = |x: f64| {
        if x == 0.0 {
            return (0.0, 0.0);
        }
        let z = beta_c * x.abs();
        let m = modified_bessel(z);
        let sign = x.signum() / beta_c;
        (sign * m.integral_k0, sign * (m.integral_k0 - z * m.k0) / (beta_c * beta_c))
    };
    let (upper, lower) = (primitives(y + b), primitives(y - b));
    ((upper.0 - lower.0) / (2.0 * PI * b), (upper.1 - lower.1) / (2.0 * PI * b))
}

/// Displacement [m²/N] of the surface at distance `y` [m] from the centre line of a strip of half-width `half_width` [m]
/// under a unit force per metre e^{i(ωt + βx)}, spread evenly over the strip; a line load where it is zero (then y ≠ 0).
///
/// (1/π) ∫₀^∞ G_zz sinc(q b) cos(q y) dq to `relative` of its modulus; else as `quadrature`.
pub fn receiver_quadrature(
    u_zz: Compliances,
    outline: &Outline,
    beta: f64,
    half_width: f64,
    y: f64,
    relative: f64,
) -> Estimate {
    let (b, y) = (half_width, y.abs());
    let kappa0 = if b > 0.0 { 1.0 / b } else { 1.0 / y };
    let coefficients = tail(outline, kappa0);
    let kernel = Kernel {
        times: &|q, g| g * (sinc(q * b) * (q * y).cos()),
        envelope: &|q| 1.0 / (q * b).max(1.0),
        period: 2.0 * PI / (b + y),
        kappa0,
        tail: &|k| tail_at(coefficients, kappa0, k),
        known: known(coefficients, receiver_tail_integrals(beta.hypot(kappa0), b, y)),
    };
    integral(u_zz, outline, beta, &kernel, relative).0
}

/// Horizontal displacement [m²/N] there, along or across; `horizontal` gives g/k of G_xz = i g, see [`Motion`].
///
/// Its tail γA/k² is removed as γA/κ², κ² = k² + κ₀², whose integral is that of e^{−β_c|x|}/(2β_c) over the strip; the rest falls like k⁻⁴.
/// Accuracy as `receiver_quadrature` (test `cross_solver::beside`).
pub fn horizontal_quadrature(
    horizontal: Compliances,
    outline: &Outline,
    beta: f64,
    half_width: f64,
    y: f64,
    motion: Motion,
    relative: f64,
) -> Estimate {
    let b = half_width;
    let kappa0 = if b > 0.0 { 1.0 / b } else { 1.0 / y.abs() };
    let (a, across) = (outline.horizontal_tail, motion == Motion::Across);
    let beta_c = beta.hypot(kappa0);
    let kernel = Kernel {
        times: &|q, g| g * (sinc(q * b) * if across { q * (q * y).sin() } else { (q * y).cos() }),
        envelope: &|q| if across { q } else { 1.0 } / (q * b).max(1.0),
        period: 2.0 * PI / (b + y.abs()),
        kappa0,
        tail: &|k| a / (k * k + kappa0 * kappa0),
        known: a * horizontal_tail_integral(beta_c, b, y, across),
    };
    let estimate = integral(horizontal, outline, beta, &kernel, relative).0;
    let scale = if across { 1.0 } else { beta.abs() };
    Estimate { value: motion.displacement(beta, estimate.value), error: scale * estimate.error, ..estimate }
}

/// (1/π) ∫₀^∞ sinc(qb) cos(qy)/(q² + β_c²) dq, or `across` of q sin(qy) in place of cos(qy).
fn horizontal_tail_integral(beta_c: f64, b: f64, y: f64, across: bool) -> f64 {
    // e^{−β_c|x|}/(2β_c) and sgn x e^{−β_c|x|}/2, averaged over y − b … y + b by their primitives
    let fade = |x: f64| (-beta_c * x.abs()).exp();
    match (b > 0.0, across) {
        (false, false) => fade(y) / (2.0 * beta_c),
        (false, true) => 0.5 * y.signum() * fade(y),
        (true, false) => {
            let primitive = |x: f64| x.signum() * (1.0 - fade(x)) / beta_c;
            (primitive(y + b) - primitive(y - b)) / (4.0 * b * beta_c)
        }
        (true, true) => (fade(y - b) - fade(y + b)) / (4.0 * b * beta_c),
    }
}

/// [`receiver_quadrature`] for many distances `y` [m]: the nodes that serve the nearest and the farthest of them, in one integral of
/// C = sinc(q b) (cos(q y₁) + i cos(q y₂)), serve all.
///
/// To `relative` of the modulus of that integral: what is small beside it is known less well. `y` is not empty; a line load
/// has none at 0.
pub fn receivers_quadrature(
    u_zz: Compliances,
    outline: &Outline,
    beta: f64,
    half_width: f64,
    y: &[f64],
    relative: f64,
) -> Vec<Estimate> {
    let (beta, b) = (beta.abs(), half_width);
    let near = y.iter().map(|y| y.abs()).fold(f64::INFINITY, f64::min);
    let far = y.iter().map(|y| y.abs()).fold(0.0, f64::max);
    let kappa0 = if b > 0.0 { 1.0 / b } else { 1.0 / near };
    let coefficients = tail(outline, kappa0);
    let beta_c = beta.hypot(kappa0);
    let tail_of = |y: f64| known(coefficients, receiver_tail_integrals(beta_c, b, y.abs()));
    let kernel = Kernel {
        times: &|q, g| g * Complex64::new((q * near).cos(), (q * far).cos()) * sinc(q * b),
        envelope: &|q| 1.0 / (q * b).max(1.0),
        period: 2.0 * PI / (b + far),
        kappa0,
        tail: &|k| tail_at(coefficients, kappa0, k),
        known: tail_of(near) + I * tail_of(far),
    };
    let (estimate, integral) = integral(u_zz, outline, beta, &kernel, relative);
    let rule = integral.into_rule();
    let k: Vec<f64> = rule.0.iter().map(|node| beta.hypot(node.x)).collect();
    let weighted = |((&Node { x: q, weight, .. }, k), g): ((&Node, &f64), Complex64)| {
        (q, (g - tail_at(coefficients, kappa0, *k)) * (sinc(q * b) * weight / PI))
    };
    let nodes: Vec<(f64, Complex64)> = rule.0.iter().zip(&k).zip(u_zz(&k)).map(weighted).collect();
    y.iter()
        .map(|y| {
            let sum: Complex64 = nodes.iter().map(|(q, g)| g * (q * y).cos()).sum();
            Estimate { value: sum + tail_of(*y), ..estimate }
        })
        .collect()
}
