//! Haskell's product of transfer matrices, with its guard: a witness for thin ground and low frequency.

use super::layer_stiffness::LayerStiffness;
use super::transfer_matrix::{Waves, surface_compliance};
use super::{Profile, SoilError, SurfaceCompliance};
use nalgebra::{Matrix2, Matrix4, Matrix4x2};
use num_complex::Complex64;

/// Largest error Haskell's product may have, relative to the largest compliance.
const ALLOWED: f64 = 1e-9;

/// Surface compliance by Haskell's product of exp(−A h), or a refusal where the product has lost it.
///
/// The rounding of every factor is carried along as a bound, |δ(T y)| ≤ |T||δy| + ε|T||y|, so that what is returned is
/// right to `ALLOWED` of its largest component. A witness for thin ground and low frequency; the bound passes 1e-9 where
/// the larger Re p h exceeds about 10. Test: `cross_solver::surface_compliance`.
///
/// Arguments: `k` > 0 [rad/m], `omega` [rad/s].
///
/// # Errors
/// `DigitsLost`, with the bound.
pub fn haskell(profile: &Profile, omega: f64, k: f64) -> Result<SurfaceCompliance, SoilError> {
    let waves = Waves::new(profile, omega.abs());
    // tractions over μq, so that all entries of A are of the size q
    let largest = waves.layers.iter().map(|(w, _)| *w).chain(waves.half_space).map(|w| w.ks2.norm());
    let q = largest.fold(k * k, f64::max).sqrt();
    let mut unit = Complex64::ONE;
    let mut y = Matrix4x2::<Complex64>::zeros();
    match &waves.half_space {
        Some(wave) => {
            let stiffness = LayerStiffness::<2>::half_space(wave, k) / wave.mu / Complex64::from(q);
            y.fixed_view_mut::<2, 2>(0, 0).fill_with_identity();
            y.fixed_view_mut::<2, 2>(2, 0).copy_from(&-stiffness);
            unit = wave.mu;
        }
        None => y.fixed_view_mut::<2, 2>(2, 0).fill_with_identity(),
    }
    let size = |m: &Complex64| m.norm();
    let mut error = y.map(|m| f64::EPSILON * size(&m));
    for (wave, h) in waves.layers.iter().rev() {
        let (mu, gamma, ks2) = (wave.mu, wave.gamma, wave.ks2);
        for row in 2..4 {
            for column in 0..2 {
                y[(row, column)] *= unit / mu;
                error[(row, column)] *= (unit / mu).norm();
            }
        }
        unit = mu;
        let mut a = Matrix4::<Complex64>::zeros();
        (a[(0, 1)], a[(0, 2)]) = ((-k).into(), q.into());
        (a[(1, 0)], a[(1, 3)]) = ((1.0 - 2.0 * gamma) * k, gamma * q);
        (a[(2, 0)], a[(2, 3)]) = ((4.0 * (1.0 - gamma) * k * k - ks2) / q, -(1.0 - 2.0 * gamma) * k);
        (a[(3, 1)], a[(3, 2)]) = (-ks2 / q, k.into());
        let transfer = (a * Complex64::from(-h)).exp();
        // the exponential itself is right to a few ε of its norm
        let bound = transfer.map(|m| size(&m));
        let norm = 4.0 * f64::EPSILON * bound.max();
        error = bound * error + (bound * f64::EPSILON).add_scalar(norm) * y.map(|m| size(&m));
        y = transfer * y;
    }
    let top = waves.layers.first().map_or(unit, |l| l.0.mu) * q;
    let tractions = y.fixed_view::<2, 2>(2, 0) * top;
    let displacements = y.fixed_view::<2, 2>(0, 0);
    let inverse = tractions.try_inverse().unwrap_or_else(|| Matrix2::from_element(f64::NAN.into()));
    let g = -displacements * inverse;
    // δ(U T⁻¹) = δU T⁻¹ − U T⁻¹ δT T⁻¹
    let (abs_inverse, abs_g) = (inverse.map(|m| size(&m)), g.map(|m| size(&m)));
    let error = error.fixed_view::<2, 2>(0, 0) * abs_inverse
        + abs_g * (error.fixed_view::<2, 2>(2, 0) * top.norm()) * abs_inverse;
    let relative = error.max() / abs_g.max();
    if relative.is_nan() || relative > ALLOWED {
        return Err(SoilError::DigitsLost { k, omega, error: relative, allowed: ALLOWED });
    }
    let (v, t, _) = waves.anti_plane(Complex64::from(k));
    Ok(surface_compliance(&g, v / t, omega < 0.0))
}
