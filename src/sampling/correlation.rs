//! Numbers that vary together: a Gaussian copula.

use super::SamplingError;
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

/// Correlation of the standard normal scores z of several numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// L of R = L Lᵀ; None where all are independent.
    factor: Option<DMatrix<f64>>,
}

impl Correlation {
    /// Of `count` numbers, with the coefficients of `pairs`; all others are independent.
    ///
    /// # Errors
    /// A coefficient that does not lie above −1 and below 1; a matrix that is not positive definite: no numbers vary like that.
    pub fn new(count: usize, pairs: &[(usize, usize, f64)]) -> Result<Self, SamplingError> {
        if pairs.is_empty() {
            return Ok(Self { factor: None });
        }
        let mut matrix = DMatrix::identity(count, count);
        for &(i, j, value) in pairs {
            crate::quantity::between("value", value, "", (-1.0, 1.0))?;
            (matrix[(i, j)], matrix[(j, i)]) = (value, value);
        }
        match Cholesky::new(matrix.clone()) {
            Some(cholesky) => Ok(Self { factor: Some(cholesky.unpack()) }),
            None => Err(SamplingError::NotDefinite { least: SymmetricEigen::new(matrix).eigenvalues.min() }),
        }
    }

    /// L z: scores with this correlation from independent ones.
    pub fn of(&self, scores: Vec<f64>) -> Vec<f64> {
        match &self.factor {
            Some(factor) => (factor * DVector::from_vec(scores)).data.into(),
            None => scores,
        }
    }

    /// Whether any numbers vary together.
    pub fn any(&self) -> bool {
        self.factor.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::normal;
    use crate::sampling::uniform;

    #[test]
    fn scores_have_their_correlation() {
        const N: u64 = 20_000;
        let correlation = Correlation::new(3, &[(0, 1, 0.7), (1, 2, -0.4)]).unwrap();
        let draw =
            |i| correlation.of(["a", "b", "c"].map(|key| normal::quantile(uniform(3, key, i))).to_vec());
        let scores: Vec<Vec<f64>> = (0..N).map(draw).collect();
        let mean = |i: usize, j: usize| scores.iter().map(|z| z[i] * z[j]).sum::<f64>() / N as f64;
        // standard errors √(2/n) = 1e-2 of a variance, √((1 + ρ²)/n) = 8.6e-3 of a product; measured 1.7e-2 and 1.9e-2
        for (i, j, expected) in
            [(0, 0, 1.0), (1, 1, 1.0), (2, 2, 1.0), (0, 1, 0.7), (1, 2, -0.4), (0, 2, 0.0)]
        {
            assert!((mean(i, j) - expected).abs() < 0.025, "{i} {j}: {}", mean(i, j));
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let three = Correlation::new(3, &[(0, 1, 0.9), (1, 2, 0.9), (0, 2, -0.9)]).unwrap_err();
        // eigenvalues 1.9, 1.9, −0.8
        assert!(three.to_string().contains("-0.8"), "{three}");
        assert!(Correlation::new(2, &[(0, 1, 1.0)]).unwrap_err().to_string().contains("value is 1"));
    }
}
