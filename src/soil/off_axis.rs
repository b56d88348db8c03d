//! The strip integral of Eq. 80 on a path off the real axis: a witness whose cost does not depend on damping.
//!
//! ```text
//! y = t + i d tanh(t/d),  t = s sinh u:   1/k_eq = (1/π) ∫₀^∞ G_zz(√(β² + y²)) C(y b) (dy/du) du
//! ```
//!
//! Damping moves the poles and branch points of waves below the real axis of y (ω > 0), and the path keeps its distance above it, so that
//! the midpoint rule in u converges like e^{−cn} however close to the axis they lie. A wave whose crests run against its energy lies
//! on the other side: the path is a witness, not a solver.

use super::Profile;
use super::half_space::static_tail;
use super::strip::{Compatibility, Strip, tail_integrals};
use super::transfer_matrix::Waves;
use crate::math::complex::I;
use num_complex::Complex64;
use std::f64::consts::PI;

/// Top of the path over the largest wavenumber on which anything varies.
const TOP: f64 = 9.0;

/// 1/k_eq(β, ω) [m²/N] by `count` points, by compound transfer matrices; `beta` ≠ 0 [rad/m], `omega` [rad/s].
///
/// Accuracy: what doubling `count` changes, until 1e-7 of it is left beyond the path (test `laws::light_damping`); 1e-8 against the real axis at 256 points for β b < 6.
pub fn strip(profile: &Profile, omega: f64, beta: f64, strip: Strip, count: usize) -> Complex64 {
    let waves = Waves::new(profile, omega.abs());
    let (beta, b) = (beta.abs(), strip.half_width);
    let (d, kappa0) = (0.7 / b, 1.0 / b);
    let speeds = profile.materials().flat_map(|m| [m.c_p(), m.c_s(), m.rayleigh_speed()]);
    let wavenumbers: Vec<f64> = speeds.map(|c| omega.abs() / c).collect();
    let highest = wavenumbers.iter().fold(beta.max(kappa0), |a, k| a.max(*k));
    let highest = profile.layers().first().map_or(highest, |layer| highest.max(1.0 / layer.thickness));
    // where G starts to vary with y
    let nearest = wavenumbers.iter().map(|k| (k * k - beta * beta).abs().sqrt()).fold(highest, f64::min);
    let scale = nearest.max(0.25 * beta);
    let (a, c) = static_tail(profile.top(), omega.abs());
    let third = c + 0.5 * a * kappa0 * kappa0;
    let step = (TOP * highest / scale).asinh() / count as f64;
    let sum: Complex64 = (0..count)
        .map(|i| {
            let u = (i as f64 + 0.5) * step;
            let t = scale * u.sinh();
            let y = t + I * (d * (t / d).tanh());
            let slope = (1.0 + I / (t / d).cosh().powi(2)) * (scale * u.cosh());
            let k2 = beta * beta + y * y;
            let kappa2 = k2 + kappa0 * kappa0;
            let sinc = (y * b).sin() / (y * b);
            let kernel = match strip.compatibility {
                Compatibility::Centre => sinc,
                Compatibility::Mean => sinc * sinc,
            };
            (waves.u_zz(k2.sqrt()) - (a + third / kappa2) / kappa2.sqrt()) * kernel * slope
        })
        .sum();
    let (first, cubed) = tail_integrals(beta.hypot(kappa0), strip);
    let value = sum * (step / PI) + a * first + third * cubed;
    if omega < 0.0 { value.conj() } else { value }
}
