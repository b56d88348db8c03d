//! Symmetric matrices that are zero beyond a few places off the diagonal: a chain of elements, node by node.
//!
//! faer and nalgebra know dense and sparse matrices; a band factorised once and solved for every step of time needs neither pivots
//! nor index lists.

use nalgebra::ComplexField;
use std::ops::Range;

/// A symmetric matrix (of complex numbers symmetric too, not Hermitian), aᵢⱼ = 0 for |i − j| > half the bandwidth.
#[derive(Clone, Debug, PartialEq)]
pub struct Banded<T> {
    half: usize,
    /// Row i holds aᵢⱼ for j = i − half … i.
    rows: Vec<T>,
}

/// Those diagonals of a [`Banded`] matrix that are not all zero, for products again and again: long loops without an index, 4 times as
/// fast as rows.
#[derive(Clone, Debug)]
pub struct Diagonals<T> {
    /// k and aᵢ₊ₖ,ᵢ for all i.
    diagonals: Vec<(usize, Vec<T>)>,
}

impl<T: ComplexField + Copy> Diagonals<T> {
    /// y ← y + A `x`.
    pub fn multiply(&self, x: &[T], y: &mut [T]) {
        let add = |y: &mut [T], a: &[T], x: &[T]| {
            for ((y, a), x) in y.iter_mut().zip(a).zip(x) {
                *y += *a * *x;
            }
        };
        for (k, a) in &self.diagonals {
            add(&mut y[*k..], a, x);
            if *k > 0 {
                add(y, a, &x[*k..]);
            }
        }
    }
}

/// L D Lᵀ of a [`Banded`] matrix, ready to solve.
#[derive(Clone, Debug)]
pub struct Factor<T> {
    half: usize,
    /// Row i holds Lᵢⱼ for j = i − half … i − 1.
    lower: Vec<T>,
    /// Column j holds Lᵢⱼ for i = j + half … j + 1: the same, as the way back reads them.
    upper: Vec<T>,
    /// 1/Dᵢ
    inverse: Vec<T>,
}

impl<T: ComplexField + Copy> Banded<T> {
    /// `size` × `size` zeros, `half` places to either side of the diagonal.
    pub fn zeros(size: usize, half: usize) -> Self {
        Self { half, rows: vec![T::zero(); size * (half + 1)] }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.rows.len() / (self.half + 1)
    }

    /// Places to either side of the diagonal.
    pub fn half(&self) -> usize {
        self.half
    }

    /// Where aᵢⱼ, j ≤ i, stands.
    fn place(&self, i: usize, j: usize) -> usize {
        i * (self.half + 1) + self.half + j - i
    }

    /// aᵢⱼ
    pub fn get(&self, i: usize, j: usize) -> T {
        let (i, j) = (i.max(j), i.min(j));
        if i - j > self.half { T::zero() } else { self.rows[self.place(i, j)] }
    }

    /// Adds to aᵢⱼ, j ≤ i ≤ j + half, and so to aⱼᵢ.
    ///
    /// # Panics
    /// Outside the band: a programming error.
    pub fn add(&mut self, i: usize, j: usize, value: T) {
        assert!(j <= i && i - j <= self.half, "({i}, {j}) is outside the band");
        let place = self.place(i, j);
        self.rows[place] += value;
    }

    /// A + `factor` B of equal bands.
    pub fn plus(mut self, factor: T, other: &Self) -> Self {
        self.rows.iter_mut().zip(&other.rows).for_each(|(a, b)| *a += factor * *b);
        self
    }

    /// The same with room for `half` places, at least as many as it has.
    pub fn widened(&self, half: usize) -> Self {
        let mut wide = Self::zeros(self.size(), half);
        for i in 0..self.size() {
            (i.saturating_sub(self.half)..=i).for_each(|j| wide.add(i, j, self.get(i, j)));
        }
        wide
    }

    /// Makes row and column `i` those of the unit matrix.
    pub fn fix(&mut self, i: usize) {
        for j in i.saturating_sub(self.half)..(i + self.half + 1).min(self.size()) {
            let place = self.place(i.max(j), i.min(j));
            self.rows[place] = if i == j { T::one() } else { T::zero() };
        }
    }

    /// Its diagonals without those that are zero.
    pub fn diagonals(&self) -> Diagonals<T> {
        let diagonal = |k: usize| (k, (k..self.size()).map(|i| self.get(i, i - k)).collect::<Vec<T>>());
        let some = |(_, a): &(usize, Vec<T>)| a.iter().any(|a| *a != T::zero());
        Diagonals { diagonals: (0..=self.half).map(diagonal).filter(some).collect() }
    }

    /// y ← y + A `x`.
    pub fn multiply(&self, x: &[T], y: &mut [T]) {
        let width = self.half + 1;
        for (i, row) in self.rows.chunks_exact(width).enumerate() {
            let from = i.saturating_sub(self.half);
            let (row, diagonal) = (&row[self.half + from - i..self.half], row[self.half]);
            let mut sum = diagonal * x[i];
            for ((a, x_j), y_j) in row.iter().zip(&x[from..i]).zip(&mut y[from..i]) {
                sum += *a * *x_j;
                *y_j += *a * x[i];
            }
            y[i] += sum;
        }
    }

    /// xᵀ A `x`
    pub fn quadratic(&self, x: &[T]) -> T {
        let mut product = vec![T::zero(); x.len()];
        self.multiply(x, &mut product);
        product.iter().zip(x).fold(T::zero(), |sum, (a, b)| sum + *a * *b)
    }

    /// L D Lᵀ without pivots: of positive definite matrices, and of dynamic stiffnesses with loss; None where a pivot is zero.
    pub fn factor(&self) -> Option<Factor<T>> {
        let (size, half) = (self.size(), self.half);
        let mut lower = vec![T::zero(); size * half];
        let mut upper = lower.clone();
        let mut inverse = vec![T::zero(); size];
        // row i of L D
        let mut row = vec![T::zero(); half];
        for i in 0..size {
            let from = i.saturating_sub(half);
            let mut pivot = self.get(i, i);
            for j in from..i {
                // (LD)ᵢⱼ = aᵢⱼ − Σₖ (LD)ᵢₖ Lⱼₖ
                let mut sum = self.get(i, j);
                for k in from.max(j.saturating_sub(half))..j {
                    sum -= row[k - from] * lower[j * half + half + k - j];
                }
                row[j - from] = sum;
                let l = sum * inverse[j];
                lower[i * half + half + j - i] = l;
                upper[j * half + half + j - i] = l;
                pivot -= sum * l;
            }
            if pivot == T::zero() {
                return None;
            }
            inverse[i] = T::one() / pivot;
        }
        Some(Factor { half, lower, upper, inverse })
    }
}

impl<T: ComplexField + Copy> Factor<T> {
    /// A⁻¹ `b`, in place.
    pub fn solve(&self, b: &mut [T]) {
        // a track in elements: 4 with supports, 3 or 7 without; what a sweep still needs then stays in registers, 2 times as fast
        match self.half {
            3 => self.sweep::<3>(b),
            4 => self.sweep::<4>(b),
            7 => self.sweep::<7>(b),
            _ => {
                (0..b.len()).for_each(|i| self.forward(b, 0, i));
                (0..b.len()).rev().for_each(|i| self.backward(b, 0, i));
            }
        }
    }

    fn sweep<const HALF: usize>(&self, b: &mut [T]) {
        // what all that is known takes from the next values: the nearest first, so that only one product waits for its neighbour
        let take = |rest: &mut [T; HALF], column: &[T; HALF], value: T| {
            for k in 1..HALF {
                rest[k - 1] = rest[k] - column[HALF - k] * value;
            }
            rest[HALF - 1] = -column[0] * value;
        };
        let mut rest = [T::zero(); HALF];
        for (x, column) in b.iter_mut().zip(self.upper.as_chunks::<HALF>().0) {
            *x += rest[0];
            take(&mut rest, column, *x);
        }
        rest = [T::zero(); HALF];
        for ((x, row), inverse) in b.iter_mut().zip(self.lower.as_chunks::<HALF>().0).zip(&self.inverse).rev()
        {
            *x = *x * *inverse + rest[0];
            take(&mut rest, row, *x);
        }
    }

    fn forward(&self, b: &mut [T], first: usize, i: usize) {
        let from = i.saturating_sub(self.half).max(first);
        let row = &self.lower[i * self.half + self.half + from - i..(i + 1) * self.half];
        let (done, rest) = b.split_at_mut(i - first);
        let mut sum = rest[0];
        for (l, x) in row.iter().zip(&done[from - first..]) {
            sum -= *l * *x;
        }
        rest[0] = sum;
    }

    fn backward(&self, b: &mut [T], first: usize, i: usize) {
        let (this, done) = b[i - first..].split_at_mut(1);
        let mut sum = this[0] * self.inverse[i];
        let count = self.half.min(done.len());
        for (l, x) in self.upper[(i + 1) * self.half - count..(i + 1) * self.half]
            .iter()
            .zip(done[..count].iter().rev())
        {
            sum -= *l * *x;
        }
        this[0] = sum;
    }
}

impl Factor<f64> {
    /// A⁻¹ b of the few `entries` (place, value) of b, as far to both sides as it stays above `least` times its largest value: where the
    /// first value stands, and all of them. Of mass and stiffness of a beam over one step of time a few metres are left.
    pub fn solve_near(&self, entries: &[(usize, f64)], least: f64) -> (usize, Vec<f64>) {
        let size = self.inverse.len();
        let begin = entries.iter().map(|e| e.0).min().unwrap_or(0);
        let end = entries.iter().map(|e| e.0 + 1).max().unwrap_or(0);
        let mut values = vec![0.0; end - begin];
        entries.iter().for_each(|&(i, value)| values[i - begin] += value);
        (begin..end).for_each(|i| self.forward(&mut values, begin, i));
        let mut largest = values.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        // quiet over a whole bandwidth: all that follows is quieter
        let quiet =
            |values: &[f64], range: Range<usize>, limit: f64| values[range].iter().all(|x| x.abs() <= limit);
        let window = 2 * self.half.max(1);
        while begin + values.len() < size {
            let count = values.len();
            if count > window && quiet(&values, count - window..count, least * largest) {
                break;
            }
            values.push(0.0);
            self.forward(&mut values, begin, begin + count);
        }
        (begin..begin + values.len()).rev().for_each(|i| self.backward(&mut values, begin, i));
        largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // before the first entry: x = −Lᵀx, in an order that grows
        let mut before: Vec<f64> = values.iter().take(self.half).rev().copied().collect();
        let known = before.len();
        let mut first = begin;
        while first > 0
            && !(before.len() >= window
                && quiet(&before, before.len() - window..before.len(), least * largest))
        {
            first -= 1;
            let row = &self.upper[first * self.half..(first + 1) * self.half];
            let sum: f64 = row.iter().rev().zip(before.iter().rev()).map(|(l, x)| l * x).sum();
            before.push(-sum);
        }
        let mut all: Vec<f64> = before.drain(known..).rev().collect();
        all.extend(values);
        (first, all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use num_complex::Complex64;

    /// A chain with a band of 4: positive definite, its inverse decays.
    fn chain(size: usize) -> Banded<f64> {
        let mut a = Banded::zeros(size, 4);
        for i in 0..size {
            for j in i.saturating_sub(4)..i {
                a.add(i, j, ((3 * i + 7 * j) as f64).sin());
            }
            a.add(i, i, 9.0 + (i as f64).cos());
        }
        a
    }

    #[test]
    fn solves_as_the_dense_matrix() {
        let a = chain(60);
        let dense = DMatrix::from_fn(60, 60, |i, j| a.get(i, j));
        let b = DVector::from_fn(60, |i, _| (i as f64 * 0.7).sin());
        let exact = dense.clone().lu().solve(&b).unwrap();
        let factor = a.factor().unwrap();
        let mut x = b.as_slice().to_vec();
        factor.solve(&mut x);
        let mut back = vec![0.0; 60];
        a.multiply(&x, &mut back);
        for i in 0..60 {
            // measured 6e-17 and 3e-16
            assert!((x[i] - exact[i]).abs() < 1e-14 && (back[i] - b[i]).abs() < 1e-14);
        }
        let mut again = vec![0.0; 60];
        a.diagonals().multiply(&x, &mut again);
        assert!(again.iter().zip(&back).all(|(a, b)| (a - b).abs() < 1e-14));
        assert!((a.quadratic(&x) - x.iter().zip(&back).map(|(x, y)| x * y).sum::<f64>()).abs() < 1e-14);
    }

    #[test]
    fn near_a_force_it_is_the_whole_solution() {
        let factor = chain(400).factor().unwrap();
        for entries in
            [vec![(200, 1.0), (203, -0.5)], vec![(0, 1.0)], vec![(398, 2.0), (399, 1.0)], vec![(2, 1.0)]]
        {
            let mut exact = vec![0.0; 400];
            entries.iter().for_each(|&(i, value)| exact[i] += value);
            factor.solve(&mut exact);
            let (first, near) = factor.solve_near(&entries, 1e-17);
            assert!(near.len() < 260, "{}", near.len());
            for (i, x) in exact.iter().enumerate() {
                let got = i.checked_sub(first).and_then(|i| near.get(i)).copied().unwrap_or(0.0);
                // measured 1e-17
                assert!((got - x).abs() < 1e-16, "{i}: {got} {x}");
            }
        }
    }

    #[test]
    fn complex_matrices_are_symmetric_and_unknowns_can_be_fixed() {
        let mut a = Banded::<Complex64>::zeros(3, 1);
        for i in 0..3 {
            a.add(i, i, Complex64::new(2.0, 1.0));
        }
        a.add(1, 0, Complex64::new(0.0, 1.0));
        a.add(2, 1, Complex64::new(1.0, 0.0));
        let mut x = [Complex64::ONE, Complex64::ZERO, Complex64::new(0.0, 2.0)];
        let b = x;
        a.factor().unwrap().solve(&mut x);
        let mut back = [Complex64::ZERO; 3];
        a.multiply(&x, &mut back);
        (0..3).for_each(|i| assert!((back[i] - b[i]).norm() < 1e-15));
        a.fix(1);
        assert_eq!(
            (a.get(0, 1), a.get(1, 1), a.get(2, 1)),
            (Complex64::ZERO, Complex64::ONE, Complex64::ZERO)
        );
        assert!(Banded::<f64>::zeros(2, 1).factor().is_none());
    }
}
