//! Thin-layer elements: shape functions in depth, exact in the horizontal direction.
//!
//! With u_x = i u and nodal values u, w, u_y the in-plane stiffness of an element of thickness h is
//!
//! ```text
//! K = | k²A_x + C_x   k B         |     A_x = (λ+2μ) h P    C_x = μ S/h − ω²ρ h P     A_y = μ h P
//!     | k Bᵀ          k²A_z + C_z |     A_z = μ h P         C_z = (λ+2μ) S/h − ω²ρ h P    C_y = C_x
//!                                       B = μ Qᵀ − λ Q
//! ```
//!
//! P = ∫NᵀN, Q = ∫NᵀN′, S = ∫N′ᵀN′ on an element of unit thickness. Source: Kausel & Peek 1982; Waas 1972.

use super::super::layer_stiffness::LayerStiffness;
use super::super::wave::Wave;
use nalgebra::{Matrix1, Matrix2};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;

/// Polynomial degree of the displacements in a sublayer.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Element {
    /// Two nodes; error ∝ h².
    Linear,
    /// Three nodes; error ∝ h⁴.
    Quadratic,
    /// Four nodes; error ∝ h⁶.
    #[default]
    Cubic,
}

/// P, Q, S of an element with `nodes` nodes; only the leading `nodes` rows and columns count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub nodes: usize,
    mass: [[f64; 4]; 4],
    mixed: [[f64; 4]; 4],
    slope: [[f64; 4]; 4],
}

/// Matrix of integers over a common denominator.
const fn over<const N: usize>(numerators: [[i32; N]; N], denominator: f64) -> [[f64; 4]; 4] {
    let mut result = [[0.0; 4]; 4];
    let mut i = 0;
    while i < N {
        let mut j = 0;
        while j < N {
            result[i][j] = numerators[i][j] as f64 / denominator;
            j += 1;
        }
        i += 1;
    }
    result
}

const LINEAR: Shape = Shape {
    nodes: 2,
    mass: over([[2, 1], [1, 2]], 6.0),
    mixed: over([[-1, 1], [-1, 1]], 2.0),
    slope: over([[1, -1], [-1, 1]], 1.0),
};

const QUADRATIC: Shape = Shape {
    nodes: 3,
    mass: over([[4, 2, -1], [2, 16, 2], [-1, 2, 4]], 30.0),
    mixed: over([[-3, 4, -1], [-4, 0, 4], [1, -4, 3]], 6.0),
    slope: over([[7, -8, 1], [-8, 16, -8], [1, -8, 7]], 3.0),
};

const CUBIC: Shape = Shape {
    nodes: 4,
    mass: over([[128, 99, -36, 19], [99, 648, -81, -36], [-36, -81, 648, 99], [19, -36, 99, 128]], 1680.0),
    mixed: over([[-40, 57, -24, 7], [-57, 0, 81, -24], [24, -81, 0, 57], [-7, 24, -57, 40]], 80.0),
    slope: over(
        [[148, -189, 54, -13], [-189, 432, -297, 54], [54, -297, 432, -189], [-13, 54, -189, 148]],
        40.0,
    ),
};

/// Linear displacements integrated at mid-depth: a perfectly matched discrete layer.
const MATCHED: Shape = Shape { nodes: 2, mass: over([[1, 1], [1, 1]], 4.0), ..LINEAR };

impl Element {
    /// Degree of the polynomials.
    pub fn degree(self) -> usize {
        match self {
            Self::Linear => 1,
            Self::Quadratic => 2,
            Self::Cubic => 3,
        }
    }

    pub(super) fn shape(self) -> &'static Shape {
        match self {
            Self::Linear => &LINEAR,
            Self::Quadratic => &QUADRATIC,
            Self::Cubic => &CUBIC,
        }
    }
}

/// One sublayer: a finite element in a layer, or a matched layer of complex thickness in the half-space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sublayer {
    pub shape: &'static Shape,
    /// h [m]
    pub thickness: Complex64,
    pub wave: Wave,
}

/// Coefficients of nodes a and b in the matrices of a sublayer.
pub(super) struct Entry {
    pub a_x: Complex64,
    pub a_z: Complex64,
    pub b: Complex64,
    pub c_x: Complex64,
    pub c_z: Complex64,
}

impl Sublayer {
    pub fn matched(wave: Wave, thickness: Complex64) -> Self {
        Self { shape: &MATCHED, thickness, wave }
    }

    pub fn entry(&self, i: usize, j: usize) -> Entry {
        let (h, mu) = (self.thickness, self.wave.mu);
        let m = mu / self.wave.gamma;
        let (p, q, q_t, s) =
            (self.shape.mass[i][j], self.shape.mixed[i][j], self.shape.mixed[j][i], self.shape.slope[i][j]);
        // ω²ρ = μ k_s²
        let inertia = mu * self.wave.ks2 * h * p;
        Entry {
            a_x: m * h * p,
            a_z: mu * h * p,
            b: mu * q_t - (m - 2.0 * mu) * q,
            c_x: mu * s / h - inertia,
            c_z: m * s / h - inertia,
        }
    }

    /// The in-plane stiffness at `k` with the inner nodes eliminated.
    pub fn in_plane(&self, k: f64) -> LayerStiffness<2> {
        let n = self.shape.nodes;
        let mut full = [[Complex64::ZERO; 8]; 8];
        for i in 0..n {
            for j in 0..n {
                let e = self.entry(i, j);
                full[2 * i][2 * j] = k * k * e.a_x + e.c_x;
                full[2 * i + 1][2 * j + 1] = k * k * e.a_z + e.c_z;
                full[2 * i][2 * j + 1] = k * e.b;
                full[2 * j + 1][2 * i] = k * e.b;
            }
        }
        let inner = 2..2 * (n - 1);
        eliminate(&mut full, inner, 2 * n);
        let bottom = 2 * (n - 1);
        let block =
            |i: usize, j: usize| Matrix2::new(full[i][j], full[i][j + 1], full[i + 1][j], full[i + 1][j + 1]);
        // cross takes the turned top displacements (u, −w)
        let turned = Matrix2::from_diagonal(&[Complex64::ONE, -Complex64::ONE].into());
        LayerStiffness { direct: block(bottom, bottom), cross: block(bottom, 0) * turned }
    }

    /// The anti-plane stiffness at `k` with the inner nodes eliminated.
    pub fn anti_plane(&self, k: f64) -> LayerStiffness<1> {
        let n = self.shape.nodes;
        let mut full = [[Complex64::ZERO; 8]; 8];
        for (i, row) in full.iter_mut().enumerate().take(n) {
            for (j, value) in row.iter_mut().enumerate().take(n) {
                let e = self.entry(i, j);
                *value = k * k * e.a_z + e.c_x;
            }
        }
        eliminate(&mut full, 1..n - 1, n);
        LayerStiffness { direct: Matrix1::new(full[n - 1][n - 1]), cross: Matrix1::new(full[n - 1][0]) }
    }
}

/// Static condensation of the unknowns `inner`.
fn eliminate(full: &mut [[Complex64; 8]; 8], inner: std::ops::Range<usize>, size: usize) {
    for pivot in inner.clone() {
        let row = full[pivot];
        let inverse = row[pivot].inv();
        for i in (0..size).filter(|i| *i > pivot || !inner.contains(i)) {
            let factor = full[i][pivot] * inverse;
            for j in 0..size {
                full[i][j] -= factor * row[j];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀¹ of products of polynomials that the nodes interpolate exactly.
    #[test]
    fn integrates_polynomials() {
        for shape in [&LINEAR, &QUADRATIC, &CUBIC] {
            let n = shape.nodes;
            let at = |i: usize| i as f64 / (n - 1) as f64;
            for a in 0..n as i32 {
                for b in 0..n as i32 {
                    let form = |matrix: &[[f64; 4]; 4]| -> f64 {
                        (0..n)
                            .flat_map(|i| (0..n).map(move |j| (i, j)))
                            .map(|(i, j)| at(i).powi(a) * matrix[i][j] * at(j).powi(b))
                            .sum()
                    };
                    let (x, y) = (f64::from(a), f64::from(b));
                    assert!((form(&shape.mass) - 1.0 / (x + y + 1.0)).abs() < 1e-14);
                    let mixed = if b == 0 { 0.0 } else { y / (x + y) };
                    assert!((form(&shape.mixed) - mixed).abs() < 1e-14, "{n} {a} {b}");
                    let slope = if a * b == 0 { 0.0 } else { x * y / (x + y - 1.0) };
                    assert!((form(&shape.slope) - slope).abs() < 1e-13);
                }
            }
        }
    }
}
