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

use super::super::pole_sum::PoleSum;
use super::element::Sublayer;
use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

/// κ_j and, for pairs of prepared interfaces, the residues of each compliance.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// Right vectors at the prepared degrees of freedom, [freedom][mode].
    right: Vec<Vec<Complex64>>,
    /// Left vectors, [freedom][mode].
    left: Vec<Vec<Complex64>>,
    /// κ_j, and the residues of freedom 1 (w of the first interface) or 0 (anti-plane).
    pub surface: PoleSum,
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
    Some(Modes { right, left, surface: PoleSum { kappa, residue: Vec::new() } })
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
        self.surface.residue =
            self.right[freedom].iter().zip(&self.left[freedom]).map(|(r, l)| r * l).collect();
        self
    }

    /// Σ φ_a,j ψ_j,b/(k² − κ_j)
    pub fn sum(&self, a: usize, b: usize, k: f64) -> Complex64 {
        let kappa = Complex64::from(k * k);
        let terms = self.right[a].iter().zip(&self.left[b]).zip(&self.surface.kappa);
        terms.map(|((r, l), pole)| r * l / (kappa - pole)).sum()
    }
}
