//! A chain of layers loaded at one interface: condensed from both ends, then followed outward.

use super::layer_stiffness::LayerStiffness;
use nalgebra::{Matrix2, SMatrix, Vector2};
use num_complex::Complex64;

/// M A M with M = diag(1, −1, …): a stiffness seen from the other face.
#[inline]
pub(super) fn upside_down<const N: usize>(mut a: SMatrix<Complex64, N, N>) -> SMatrix<Complex64, N, N> {
    for i in 0..N {
        for j in 0..N {
            if (i + j) % 2 == 1 {
                a[(i, j)] = -a[(i, j)];
            }
        }
    }
    a
}

/// M A: displacements seen from the other face.
fn turned<const N: usize>(mut a: SMatrix<Complex64, N, N>) -> SMatrix<Complex64, N, N> {
    for i in (1..N).step_by(2) {
        for j in 0..N {
            a[(i, j)] = -a[(i, j)];
        }
    }
    a
}

/// Inverse of a symmetric 2 × 2 block; not finite where the block is singular, as at an undamped resonance.
#[inline]
pub(super) fn inverse_symmetric(a: &Matrix2<Complex64>) -> Matrix2<Complex64> {
    let scale = (a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(0, 1)]).inv();
    let off = -a[(0, 1)] * scale;
    Matrix2::new(a[(1, 1)] * scale, off, off, a[(0, 0)] * scale)
}

/// Inverse of any block; NaN where it is singular.
pub(super) fn inverse<const N: usize>(a: SMatrix<Complex64, N, N>) -> SMatrix<Complex64, N, N> {
    a.try_inverse().unwrap_or_else(|| SMatrix::from_element(Complex64::new(f64::NAN, f64::NAN)))
}

/// M u of one vector.
pub(super) fn turned_vector(u: Vector2<Complex64>) -> Vector2<Complex64> {
    Vector2::new(u[0], -u[1])
}

/// Stiffness of all below each of the n + 1 interfaces of n `layers`, None where that is rigid.
pub(super) fn condensed<const N: usize>(
    layers: &[LayerStiffness<N>],
    base: Option<SMatrix<Complex64, N, N>>,
) -> Vec<Option<SMatrix<Complex64, N, N>>> {
    let mut below = vec![base; layers.len() + 1];
    for (j, LayerStiffness { direct, cross }) in layers.iter().enumerate().rev() {
        below[j] = Some(upside_down(match below[j + 1] {
            Some(stiffness) => direct - cross * inverse(direct + stiffness) * cross,
            None => *direct,
        }));
    }
    below
}

/// Displacements at the n + 1 interfaces of n `layers` for unit tractions at interface `source`, each an N × N matrix
/// [m/Pa]. `base` is the stiffness of the half-space, None for a rigid base.
pub(super) fn displacements<const N: usize>(
    layers: &[LayerStiffness<N>],
    base: Option<SMatrix<Complex64, N, N>>,
    source: usize,
) -> Vec<SMatrix<Complex64, N, N>> {
    let n = layers.len();
    // above[j]: stiffness of all above interface j
    let below = condensed(layers, base);
    let mut above = vec![SMatrix::zeros(); n + 1];
    for (j, LayerStiffness { direct, cross }) in layers.iter().enumerate() {
        above[j + 1] = direct - cross * inverse(direct + upside_down(above[j])) * cross;
    }
    let mut u = vec![SMatrix::zeros(); n + 1];
    let Some(stiffness) = below[source] else {
        return u;
    };
    u[source] = inverse(stiffness + above[source]);
    for j in source..n {
        // (B + S) u_bottom = −C M u_top
        if let Some(stiffness) = below[j + 1] {
            u[j + 1] = -inverse(layers[j].direct + stiffness) * layers[j].cross * turned(u[j]);
        }
    }
    for j in (0..source).rev() {
        // (S + M B M) u_top = −M C u_bottom
        u[j] = -inverse(above[j] + upside_down(layers[j].direct)) * turned(layers[j].cross * u[j + 1]);
    }
    u
}
