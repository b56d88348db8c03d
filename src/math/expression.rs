//! A polynomial as a quantity to reckon with.

use super::polynomial::{plus, roots, times, value_and_slope};
use num_complex::Complex64;
use std::ops::{Add, Mul};

/// Σ pₖzᵏ, its last coefficient not zero; without coefficients 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<Complex64>);

impl Polynomial {
    /// From its coefficients, the constant one first.
    pub fn new(mut coefficients: Vec<Complex64>) -> Self {
        while coefficients.last() == Some(&Complex64::ZERO) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    /// A constant.
    pub fn constant(value: impl Into<Complex64>) -> Self {
        Self::new(vec![value.into()])
    }

    /// z
    pub fn variable() -> Self {
        Self(vec![Complex64::ZERO, Complex64::ONE])
    }

    /// Its coefficients, the constant one first.
    pub fn coefficients(&self) -> &[Complex64] {
        &self.0
    }

    /// Its degree; 0 of constants.
    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The value of a constant; None of others.
    pub fn as_constant(&self) -> Option<Complex64> {
        (self.degree() == 0).then(|| self.0.first().copied().unwrap_or_default())
    }

    /// p(z) and p′(z), by Horner's scheme.
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        value_and_slope(&self.0, z)
    }

    /// Σ |pₖ| |z|ᵏ, of which a rounding error is lost in p(z).
    pub fn size(&self, z: Complex64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, p| sum * z.norm() + p.norm())
    }

    /// Times a number.
    pub fn times(&self, factor: impl Into<Complex64>) -> Self {
        let factor = factor.into();
        Self::new(self.0.iter().map(|p| p * factor).collect())
    }

    /// All roots, each as often as it counts.
    ///
    /// Accuracy: that of the coefficients, 1e-16 `size`/|z p′| of a root z.
    pub fn roots(&self) -> Vec<Complex64> {
        if self.0.is_empty() { Vec::new() } else { roots(&self.0) }
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: &Polynomial) -> Polynomial {
        Polynomial::new(plus(&self.0, &other.0))
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: &Polynomial) -> Polynomial {
        Polynomial::new(times(&self.0, &other.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products() {
        let (p, q) =
            (Polynomial::new(vec![1.0.into(), 2.0.into()]), Polynomial::new(vec![1.0.into(), (-2.0).into()]));
        assert_eq!(&p + &q, Polynomial::constant(2.0));
        assert_eq!((&p * &q).coefficients(), [1.0.into(), 0.0.into(), (-4.0).into()]);
        assert_eq!(p.at(3.0.into()), (7.0.into(), 2.0.into()));
        assert_eq!((&p * &Polynomial::constant(0.0)).as_constant(), Some(Complex64::ZERO));
        assert_eq!(p.as_constant(), None);
        assert_eq!(Polynomial::variable().times(2.0).degree(), 1);
    }
}
