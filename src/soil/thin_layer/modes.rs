//! Modes of a stack of thin layers, and what they answer in closed form.
//!
//! (κ Ā + C̄) φ = 0, κ = k², with Ā = [A_x 0; Bᵀ A_z], C̄ = [C_x B; 0 C_z] for φ = (u, k w); (κ A_y + C_y) φ = 0 anti-plane.
//! Wavenumbers span many decades, so that the smallest κ_j would drown in the rounding of the largest. Seen from κ₀ in
//! their middle, with L = κ₀ Ā + C̄, both ends keep their digits:
//!
//! ```text
//! L⁻¹ Ā φ_j = τ_j φ_j,  κ_j = κ₀ − 1/τ_j,      (κ Ā + C̄)⁻¹ = V diag( 1/(τ_j (κ − κ_j)) ) V⁻¹ L⁻¹
//! ```
//!
//! The rows of diag(1/τ_j) V⁻¹ L⁻¹ are the left vectors, already normalised. Solving with V instead of scaling each
//! pair keeps the sum right where modes nearly coincide, as P and S modes of a half-space do towards ω = 0.

use super::super::strip::{Compatibility, Strip};
use super::element::Sublayer;
use crate::math::complex::{one_minus_exp_over, sqrt_decaying};
use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

/// κ_j and, for pairs of prepared interfaces, the residues of each compliance.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    pub kappa: Vec<Complex64>,
    /// Right vectors at the prepared degrees of freedom, [freedom][mode].
    right: Vec<Vec<Complex64>>,
    /// Left vectors, [freedom][mode].
    left: Vec<Vec<Complex64>>,
    /// Residues of freedom 1 (w of the first interface) or 0 (anti-plane), kept for speed.
    pub surface: Vec<Complex64>,
}

/// Dense matrices of a stack, the base node left out.
struct Stack {
    a_x: Mat<Complex64>,
    a_z: Mat<Complex64>,
    b: Mat<Complex64>,
    c_x: Mat<Complex64>,
    c_z: Mat<Complex64>,
}

impl Stack {
    fn new(sublayers: &[Sublayer]) -> Self {
        let n: usize = sublayers.iter().map(|s| s.shape.nodes - 1).sum();
        let zeros = || Mat::<Complex64>::zeros(n, n);
        let mut stack = Self { a_x: zeros(), a_z: zeros(), b: zeros(), c_x: zeros(), c_z: zeros() };
        let mut first = 0;
        for sublayer in sublayers {
            let nodes = sublayer.shape.nodes;
            // the lowest node of the stack does not move
            for i in (0..nodes).filter(|i| first + i < n) {
                for j in (0..nodes).filter(|j| first + j < n) {
                    let e = sublayer.entry(i, j);
                    let at = (first + i, first + j);
                    stack.a_x[at] += e.a_x;
                    stack.a_z[at] += e.a_z;
                    stack.b[at] += e.b;
                    stack.c_x[at] += e.c_x;
                    stack.c_z[at] += e.c_z;
                }
            }
            first += nodes - 1;
        }
        stack
    }
}

/// Modes of (κ `a` + `c`) φ = 0 seen from `kappa0`, for the degrees of freedom `wanted`; None if they do not settle.
fn decompose(a: &Mat<Complex64>, c: &Mat<Complex64>, kappa0: f64, wanted: &[usize]) -> Option<Modes> {
    let n = a.nrows();
    let l = Mat::from_fn(n, n, |i, j| kappa0 * a[(i, j)] + c[(i, j)]).partial_piv_lu();
    let matrix = l.solve(a);
    let unit =
        Mat::from_fn(n, wanted.len(), |i, w| if i == wanted[w] { Complex64::ONE } else { Complex64::ZERO });
    let loads = l.solve(&unit);
    let eigen = matrix.eigen().ok()?;
    let vectors = eigen.U();
    let tau: Vec<Complex64> = (0..n).map(|j| eigen.S().column_vector()[j]).collect();
    let amplitudes = vectors.partial_piv_lu().solve(&loads);
    let right: Vec<Vec<Complex64>> =
        wanted.iter().map(|&i| (0..n).map(|j| vectors[(i, j)]).collect()).collect();
    let left: Vec<Vec<Complex64>> =
        (0..wanted.len()).map(|w| (0..n).map(|j| amplitudes[(j, w)] / tau[j]).collect()).collect();
    let kappa = tau.iter().map(|tau| kappa0 - tau.inv()).collect();
    Some(Modes { kappa, right, left, surface: Vec::new() })
}

impl Modes {
    /// In-plane modes for loads and receivers at the nodes `interfaces`; freedom 2i is u, 2i + 1 is w of the i-th.
    pub fn in_plane(sublayers: &[Sublayer], interfaces: &[usize], kappa0: f64) -> Option<Self> {
        let Stack { a_x, a_z, b, c_x, c_z } = Stack::new(sublayers);
        let n = a_x.nrows();
        // u and k w node by node
        let zero = Complex64::ZERO;
        let a = Mat::from_fn(2 * n, 2 * n, |i, j| match (i % 2, j % 2) {
            (0, 0) => a_x[(i / 2, j / 2)],
            (0, _) => zero,
            (_, 0) => b[(j / 2, i / 2)],
            _ => a_z[(i / 2, j / 2)],
        });
        let c = Mat::from_fn(2 * n, 2 * n, |i, j| match (i % 2, j % 2) {
            (0, 0) => c_x[(i / 2, j / 2)],
            (0, _) => b[(i / 2, j / 2)],
            (_, 0) => zero,
            _ => c_z[(i / 2, j / 2)],
        });
        let wanted: Vec<usize> = interfaces.iter().flat_map(|&i| [2 * i, 2 * i + 1]).collect();
        decompose(&a, &c, kappa0, &wanted).map(|modes| modes.with_surface(1))
    }

    /// Anti-plane modes; freedom i is u_y of the i-th interface.
    pub fn anti_plane(sublayers: &[Sublayer], interfaces: &[usize], kappa0: f64) -> Option<Self> {
        // A_y = A_z, C_y = C_x
        let Stack { a_z, c_x, .. } = Stack::new(sublayers);
        decompose(&a_z, &c_x, kappa0, interfaces).map(|modes| modes.with_surface(0))
    }

    /// Keeps the residues of `freedom` under its own load.
    fn with_surface(mut self, freedom: usize) -> Self {
        self.surface = self.right[freedom].iter().zip(&self.left[freedom]).map(|(r, l)| r * l).collect();
        self
    }

    /// Σ φ_a,j ψ_j,b/(k² − κ_j)
    pub fn sum(&self, a: usize, b: usize, k: f64) -> Complex64 {
        let kappa = Complex64::from(k * k);
        let terms = self.right[a].iter().zip(&self.left[b]).zip(&self.kappa);
        terms.map(|((r, l), pole)| r * l / (kappa - pole)).sum()
    }

    /// G of the surface freedom: Σ r_j/(k² − κ_j).
    #[inline]
    pub fn at_surface(&self, k: f64) -> Complex64 {
        let kappa = Complex64::from(k * k);
        self.surface.iter().zip(&self.kappa).map(|(r, pole)| r / (kappa - pole)).sum()
    }

    /// Σ r_j f(a_j)/(2a_j), a_j = √(β² − κ_j), Re a_j > 0: what (1/2π)∫ G(√(β² + y²)) K(y) dy becomes for a kernel whose
    /// integral over e^{−a|y|} is f.
    fn integral(&self, beta: f64, f: impl Fn(Complex64) -> Complex64) -> Complex64 {
        let beta2 = Complex64::from(beta * beta);
        self.surface
            .iter()
            .zip(&self.kappa)
            .map(|(r, pole)| {
                let a = sqrt_decaying(beta2 - pole);
                r * f(a) / (2.0 * a)
            })
            .sum()
    }

    /// 1/k_eq(β) [m²/N] of a strip.
    ///
    /// Centre: Σ r_j (1 − e^{−a b})/(2a² b). Mean: Σ r_j/(2a) · [1/(ab) − (1 − e^{−2ab})/(2a²b²)].
    pub fn strip(&self, beta: f64, strip: Strip) -> Complex64 {
        let b = strip.half_width;
        match strip.compatibility {
            Compatibility::Centre => self.integral(beta, |a| one_minus_exp_over(a * b, (-a * b).exp())),
            Compatibility::Mean => self.integral(beta, |a| {
                let z = 2.0 * a * b;
                if z.norm_sqr() < 1e-4 {
                    // 2(1 − (1 − e^{−z})/z)/z
                    1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0)))
                } else {
                    2.0 * (1.0 - one_minus_exp_over(z, (-z).exp())) / z
                }
            }),
        }
    }

    /// Displacement [m²/N] at distance `y` from the centre line of a strip of half-width `b`; a line where b = 0.
    ///
    /// y ≥ b: Σ r_j e^{−ay} sinh(ab)/(2a · ab); y < b: Σ r_j (1 − e^{−ab} cosh(ay))/(2a · ab); line: Σ r_j e^{−ay}/(2a).
    pub fn receiver(&self, beta: f64, b: f64, y: f64) -> Complex64 {
        let y = y.abs();
        // what has decayed by e^{−36} more than the mode that reaches farthest is lost in rounding beside the whole
        let kappa = |pole: &Complex64| sqrt_decaying(Complex64::from(beta * beta) - pole).re;
        let farthest = self.kappa.iter().map(kappa).fold(f64::INFINITY, f64::min);
        let seen = farthest + 36.0 / (y - b).max(f64::MIN_POSITIVE);
        self.integral(beta, |a| {
            if a.re > seen {
                Complex64::ZERO
            } else if b == 0.0 {
                (-a * y).exp()
            } else if y >= b {
                // sinh(ab) e^{−ay}/(ab) = e^{−a(y−b)} (1 − e^{−2ab})/(2ab)
                let z = 2.0 * a * b;
                (-a * (y - b)).exp() * one_minus_exp_over(z, (-z).exp())
            } else {
                // ½ ∫ over both sides of y
                let part = |c: f64| c / b * one_minus_exp_over(a * c, (-a * c).exp());
                0.5 * (part(b + y) + part(b - y))
            }
        })
    }
}
