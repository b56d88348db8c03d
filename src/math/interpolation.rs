//! Adaptive piecewise Chebyshev interpolation: many cheap values of a dear complex function.

use super::lanes::LANES;
use super::quadrature::miss;
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::convert::Infallible;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Chebyshev points per piece.
pub const NODES: usize = 12;
/// How often the allowed error a control value may differ: the last coefficients bound the error less tightly.
const CONTROL: f64 = 3.0;
/// Halvings of the first pieces allowed.
const DEEPEST: u32 = 14;

/// A function on [from, to] as polynomials of degree 11 on pieces halved until their last coefficients vanish.
#[derive(Clone, Debug)]
pub struct Interpolant {
    /// Ends of the pieces, ascending; one more than there are pieces.
    ends: Vec<f64>,
    coefficients: Vec<[Complex64; NODES]>,
    /// Evaluations of the function.
    pub count: usize,
    /// The last coefficients over what was allowed, of the worst piece: at most 1 where the tolerance was met everywhere.
    pub worst: f64,
}

/// One polynomial.
struct Piece {
    from: f64,
    to: f64,
    depth: u32,
    coefficients: [Complex64; NODES],
    /// Its last coefficients, or its error at the control value, over what is allowed.
    miss: f64,
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Piece {}
impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Piece {
    /// The worst last; of pieces missed alike the leftmost.
    fn cmp(&self, other: &Self) -> Ordering {
        self.miss.total_cmp(&other.miss).then(other.from.total_cmp(&self.from))
    }
}

impl Piece {
    fn new<E>(
        f: &mut impl FnMut(&[f64; NODES]) -> Result<[Complex64; NODES], E>,
        control: &mut impl FnMut(f64) -> Result<Option<Complex64>, E>,
        allowed: &impl Fn(f64, Complex64) -> f64,
        (from, to, depth): (f64, f64, u32),
    ) -> Result<Self, E> {
        let nodes = chebyshev_nodes(from, to);
        let values = f(&nodes)?;
        let coefficients = chebyshev_coefficients(&values);
        let tail = coefficients[NODES - 1].norm().max(coefficients[NODES - 2].norm());
        let least = nodes.iter().zip(&values).map(|(&x, &v)| allowed(x, v)).fold(f64::INFINITY, f64::min);
        let mut piece = Self { from, to, depth, coefficients, miss: miss(tail, least) };
        if piece.miss <= 1.0 && least.is_finite() {
            // between the nodes, where the polynomial says that least is allowed
            let between = nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
            let strict = |x: f64| allowed(x, piece.at(x));
            let at = between.map(|x| (x, strict(x))).min_by(|a, b| a.1.total_cmp(&b.1));
            let value = at.map_or(Ok(None), |(x, _)| control(x))?;
            if let (Some((x, least)), Some(value)) = (at, value) {
                let borne = CONTROL * least.min(allowed(x, value));
                piece.miss = piece.miss.max(miss((value - piece.at(x)).norm(), borne));
            }
        }
        Ok(piece)
    }

    fn at(&self, x: f64) -> Complex64 {
        clenshaw(&self.coefficients, (2.0 * x - self.from - self.to) / (self.to - self.from))
    }
}

impl Interpolant {
    /// Interpolates `f`, asked for all nodes of a piece at once, between consecutive `breakpoints` (ascending) until the last
    /// two Chebyshev coefficients of each piece fall below the error `allowed(x, f(x))` at all its nodes.
    pub fn new(
        mut f: impl FnMut(&[f64; NODES]) -> [Complex64; NODES],
        breakpoints: &[f64],
        allowed: impl Fn(f64, Complex64) -> f64,
    ) -> Self {
        let answered = Self::bounded(|nodes| Ok::<_, Infallible>(f(nodes)), breakpoints, allowed, || true);
        match answered {
            Ok(interpolant) => interpolant,
            Err(never) => match never {},
        }
    }

    /// The same of an `f` that may fail; the worst piece is halved first, as long as `more()`. Where that ends before the
    /// tolerance is met, `worst` says what is missing.
    ///
    /// # Errors
    /// The first of `f`.
    pub fn bounded<E>(
        f: impl FnMut(&[f64; NODES]) -> Result<[Complex64; NODES], E>,
        breakpoints: &[f64],
        allowed: impl Fn(f64, Complex64) -> f64,
        more: impl Fn() -> bool,
    ) -> Result<Self, E> {
        Self::controlled(f, |_| Ok(None), breakpoints, allowed, more)
    }

    /// The same, of which every piece is compared with one value of `control` where least is allowed: the last coefficients say
    /// nothing of what stands between the nodes.
    ///
    /// # Errors
    /// The first of `f` or `control`.
    pub fn controlled<E>(
        mut f: impl FnMut(&[f64; NODES]) -> Result<[Complex64; NODES], E>,
        mut control: impl FnMut(f64) -> Result<Option<Complex64>, E>,
        breakpoints: &[f64],
        allowed: impl Fn(f64, Complex64) -> f64,
        more: impl Fn() -> bool,
    ) -> Result<Self, E> {
        let (mut done, mut todo) = (Vec::new(), BinaryHeap::new());
        for pair in breakpoints.windows(2) {
            todo.push(Piece::new(&mut f, &mut control, &allowed, (pair[0], pair[1], 0))?);
        }
        let mut count = NODES * todo.len();
        while let Some(piece) = todo.pop() {
            if piece.miss <= 1.0 || piece.depth >= DEEPEST || !more() {
                done.push(piece);
                continue;
            }
            let middle = 0.5 * (piece.from + piece.to);
            for (from, to) in [(piece.from, middle), (middle, piece.to)] {
                todo.push(Piece::new(&mut f, &mut control, &allowed, (from, to, piece.depth + 1))?);
                count += NODES;
            }
        }
        done.sort_by(|a, b| a.from.total_cmp(&b.from));
        Ok(Self {
            ends: breakpoints[..1].iter().copied().chain(done.iter().map(|piece| piece.to)).collect(),
            coefficients: done.iter().map(|piece| piece.coefficients).collect(),
            count,
            worst: done.iter().map(|piece| piece.miss).fold(0.0, f64::max),
        })
    }

    /// Another function, whose features lie where those of this one do times `stretch`, on its pieces stretched likewise.
    /// It is asked for all nodes at once, ascending.
    pub fn alike(&self, stretch: f64, f: impl FnOnce(&[f64]) -> Vec<Complex64>) -> Self {
        let ends: Vec<f64> = self.ends.iter().map(|end| stretch * end).collect();
        let nodes: Vec<f64> = ends.windows(2).flat_map(|pair| chebyshev_nodes(pair[0], pair[1])).collect();
        let values = f(&nodes);
        let (pieces, _) = values.as_chunks::<NODES>();
        Self { coefficients: pieces.iter().map(chebyshev_coefficients).collect(), ends, ..*self }
    }

    /// Ends of its pieces, ascending.
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// True where the tolerance was met everywhere.
    pub fn converged(&self) -> bool {
        self.worst <= 1.0
    }

    /// The values at many `x`, as [`at`](Self::at): eight at a time of neighbours on one piece.
    pub fn at_many(&self, x: &[f64]) -> Vec<Complex64> {
        dispatch!(Level::new(), simd => self.at_many_in_lanes(simd, x))
    }

    #[inline(always)]
    fn at_many_in_lanes<S: Simd>(&self, simd: S, x: &[f64]) -> Vec<Complex64> {
        let mut values = Vec::with_capacity(x.len());
        let last = self.coefficients.len() - 1;
        while let Some(&first) = x.get(values.len()) {
            let rest = &x[values.len()..];
            let piece = self.ends[1..=last].partition_point(|&end| end < first);
            let (from, to) = (self.ends[piece], self.ends[piece + 1]);
            let inside = |x: &&f64| (piece == 0 || from < **x) && (piece == last || **x <= to);
            let count = rest.iter().take(LANES).take_while(inside).count();
            let x = f64x8::from_fn(simd, |i| rest[i.min(count - 1)]);
            let t = ((x * 2.0 - (from + to)) * (1.0 / (to - from))).max(-1.0).min(1.0);
            // Clenshaw's recurrence, as in `clenshaw`
            let (twice, zero) = (t + t, f64x8::splat(simd, 0.0));
            let (mut re, mut im, mut re2, mut im2) = (zero, zero, zero, zero);
            let coefficients = &self.coefficients[piece];
            for c in coefficients[1..].iter().rev() {
                (re, re2) = (re.mul_add(twice, c.re - re2), re);
                (im, im2) = (im.mul_add(twice, c.im - im2), im);
            }
            let (re, im) = (re.mul_add(t, coefficients[0].re - re2), im.mul_add(t, coefficients[0].im - im2));
            values.extend((0..count).map(|i| Complex64::new(re[i], im[i])));
        }
        values
    }

    /// The value at `x`; outside the range the polynomial of the end piece at the end of the range.
    pub fn at(&self, x: f64) -> Complex64 {
        let last = self.coefficients.len() - 1;
        let piece = self.ends[1..=last].partition_point(|&end| end < x);
        let (from, to) = (self.ends[piece], self.ends[piece + 1]);
        let t = ((2.0 * x - from - to) / (to - from)).clamp(-1.0, 1.0);
        clenshaw(&self.coefficients[piece], t)
    }
}

/// Σ c_n T_n(t): b_n = c_n + 2t b_{n+1} − b_{n+2}
#[inline]
fn clenshaw(coefficients: &[Complex64; NODES], t: f64) -> Complex64 {
    let (mut b1, mut b2) = (Complex64::ZERO, Complex64::ZERO);
    for c in coefficients[1..].iter().rev() {
        (b1, b2) = (c + b1 * (2.0 * t) - b2, b1);
    }
    coefficients[0] + b1 * t - b2
}

/// Weights of the values at `nodes` (all different) in the polynomial through them, at `x`; no numbers where it lies beyond the `ends`
/// of the data by more than rounding.
pub fn lagrange_within<const N: usize>(nodes: &[f64; N], x: f64, ends: (f64, f64)) -> [f64; N] {
    let rounding = 1e-9 * (ends.1 - ends.0).abs().max(ends.1.abs());
    if x < ends.0 - rounding || x > ends.1 + rounding { [f64::NAN; N] } else { lagrange_weights(nodes, x) }
}

/// Weights of the values at −1, 0, 1, 2 in the cubic through them, at `t` in [0, 1].
pub fn cubic_weights(t: f64) -> [f64; 4] {
    [
        -t * (t - 1.0) * (t - 2.0) / 6.0,
        (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
        -(t + 1.0) * t * (t - 2.0) / 2.0,
        (t + 1.0) * t * (t - 1.0) / 6.0,
    ]
}

/// Weights of the values at `nodes` (all different) in the polynomial through them, at `x`.
fn lagrange_weights<const N: usize>(nodes: &[f64; N], x: f64) -> [f64; N] {
    // w_i = Π_{j ≠ i} (x − x_j)/(x_i − x_j)
    std::array::from_fn(|i| {
        (0..N).filter(|j| *j != i).map(|j| (x - nodes[j]) / (nodes[i] - nodes[j])).product()
    })
}

/// x_j = −cos(π(j + ½)/NODES) of the piece, ascending.
fn chebyshev_nodes(from: f64, to: f64) -> [f64; NODES] {
    static UNIT: LazyLock<[f64; NODES]> =
        LazyLock::new(|| std::array::from_fn(|j| -(PI * (j as f64 + 0.5) / NODES as f64).cos()));
    UNIT.map(|x| 0.5 * (from + to) + 0.5 * (to - from) * x)
}

/// c_n = (2 − δ_n0)/NODES Σ_j f_j T_n(x_j), x_j ascending
fn chebyshev_coefficients(values: &[Complex64; NODES]) -> [Complex64; NODES] {
    // T_n(−x) = (−1)ⁿ T_n(x)
    static WEIGHTS: LazyLock<[[f64; NODES]; NODES]> = LazyLock::new(|| {
        let weight = |n: usize, j: usize| {
            let share = if n == 0 { 1.0 } else { 2.0 } * if n.is_multiple_of(2) { 1.0 } else { -1.0 };
            share / NODES as f64 * (PI * n as f64 * (j as f64 + 0.5) / NODES as f64).cos()
        };
        std::array::from_fn(|n| std::array::from_fn(|j| weight(n, j)))
    });
    WEIGHTS.map(|weights| values.iter().zip(weights).map(|(v, w)| v * w).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_exact() {
        let cubic = |x: f64| ((0.3 * x - 1.0) * x + 2.0) * x - 5.0;
        for t in [0.0, 0.3, 1.0] {
            let w = cubic_weights(t);
            let sum: f64 = (0..4).map(|i| w[i] * cubic(i as f64 - 1.0)).sum();
            assert!((sum - cubic(t)).abs() < 1e-14);
        }
    }

    #[test]
    fn uneven_nodes_are_exact_for_their_degree() {
        let quintic = |x: f64| ((((0.1 * x + 0.2) * x - 0.3) * x + 1.0) * x - 2.0) * x + 0.5;
        let nodes = [0.0, 0.7, 1.1, 2.5, 3.0, 4.2];
        for x in [-0.3, 0.0, 1.9, 4.5] {
            let weights = lagrange_weights(&nodes, x);
            let sum: f64 = nodes.iter().zip(weights).map(|(n, w)| w * quintic(*n)).sum();
            // rounding
            assert!((sum - quintic(x)).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn what_stands_between_the_nodes_is_found() {
        // a resonance 0.002 wide on [0, 1] midway between two nodes, of which they show 2e-3, felt where it stands
        let nodes: [f64; 2] = [3.5, 4.5].map(|j: f64| 0.5 - 0.5 * (PI * j / NODES as f64).cos());
        let at = 0.5 * (nodes[0] + nodes[1]);
        let f = |x: f64| 1.0 + 1e-3 / Complex64::new(x - at, 1e-3);
        let allowed = |x: f64, _| 0.01 + 10.0 * (x - at).abs();
        let table = |watched: bool| {
            let control = |x: f64| Ok::<_, Infallible>(watched.then(|| f(x)));
            Interpolant::controlled(|x| Ok(x.map(f)), control, &[0.0, 1.0], allowed, || true).unwrap()
        };
        let error = |table: Interpolant| (table.at(at) - f(at)).norm();
        // measured: the resonance is lost, or met to what is allowed
        let (lost, found) = (error(table(false)), error(table(true)));
        assert!(lost > 0.5 && found < 0.03, "{lost} {found}");
    }

    #[test]
    fn follows_a_resonance() {
        // 1/(x − 1 + 0.01 i) on [0, 4]; measured 3e-9 of the maximum
        let f = |x: f64| 1.0 / Complex64::new(x - 1.0, 0.01);
        let interpolant = Interpolant::new(|x| x.map(f), &[0.0, 4.0], |_, f| 1e-8 * f.norm());
        assert!(interpolant.converged() && interpolant.count < 1000, "{}", interpolant.count);
        for i in 0..=1000 {
            let x = 0.004 * f64::from(i);
            assert!((interpolant.at(x) - f(x)).norm() < 1e-7 * f(x).norm(), "{x}");
        }
        // in any order, at the ends of pieces and beyond the last of them; rounding
        let x: Vec<f64> =
            (0..300).map(|i| 0.03 * f64::from(i * 7 % 150)).chain(interpolant.ends().to_vec()).collect();
        for (x, value) in x.iter().zip(interpolant.at_many(&x)) {
            assert!((value - interpolant.at(*x)).norm() < 1e-12 * value.norm(), "{x}");
        }
    }
}
