//! Boundary values: as many waves as the members need to meet the jump of the force just ahead of it.
//!
//! By symmetry no section turns at x = 0⁺, of the rail the left half bears half of the force, and of all other members none.
//!
//! Source: Eq. (49), corrected.

use super::residues::Departing;
use super::uniform::Uniform;
use crate::rail::{Answer, Drive, RailError, Receptance};
use crate::track::{Member, Tower};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

const NAME: &str = "boundary-values";

/// A rail on springs that answers by the values at its boundary.
pub struct BoundaryValues<'a>(pub(super) Uniform<'a>);

/// Amplitudes of the waves `gamma` [rad/m] at `omega` [rad/s], one condition for each; None where the conditions are not as many as
/// the waves, or do not tell them apart.
fn amplitudes(tower: &Tower, gamma: &[Complex64], omega: f64) -> Option<Vec<Complex64>> {
    let mut conditions: Vec<(Vec<Complex64>, f64)> = Vec::new();
    let shapes: Vec<Vec<Complex64>> = gamma.iter().map(|gamma| tower.shape(gamma * gamma, omega)).collect();
    for (i, floor) in tower.floors().iter().enumerate() {
        // e^{iβx} with β = −γ
        let of = |what: &dyn Fn(Complex64) -> Complex64| -> Vec<Complex64> {
            gamma.iter().zip(&shapes).map(|(gamma, shape)| shape[i] * what(-gamma)).collect()
        };
        if !floor.iter().any(|member| member.joins()) {
            continue;
        }
        let force = of(&|beta| floor.iter().map(|member| member.carried(beta, omega)[1]).sum());
        conditions.push((force, if i == 0 { 0.5 } else { 0.0 }));
        // Euler–Bernoulli beams of one floor turn together
        let (shearing, stiff): (Vec<&Member>, Vec<&Member>) =
            floor.iter().filter(|member| member.bends()).partition(|member| member.shears());
        for member in shearing.into_iter().chain(stiff.into_iter().take(1)) {
            conditions.push((of(&|beta| member.carried(beta, omega)[0]), 0.0));
        }
    }
    let count = gamma.len();
    // rows of one size
    let sizes: Vec<f64> = conditions
        .iter()
        .map(|(row, _)| row.iter().map(|c| c.norm()).fold(f64::MIN_POSITIVE, f64::max))
        .collect();
    (conditions.len() == count).then_some(())?;
    let matrix = DMatrix::from_fn(count, count, |i, j| conditions[i].0[j] / sizes[i]);
    let right = DVector::from_fn(count, |i, _| Complex64::from(conditions[i].1 / sizes[i]));
    Some(matrix.full_piv_lu().solve(&right)?.iter().copied().collect())
}

impl Receptance for BoundaryValues<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        self.0.check(Drive { omega, speed: 0.0 })?;
        let tower = self.0.tower(NAME)?;
        let waves = Departing::new(tower, omega).ok_or(self.0.unknown(NAME))?;
        let amplitude = amplitudes(tower, &waves.gamma, omega).ok_or(RailError::Unsettled {
            method: NAME,
            frequency: omega / std::f64::consts::TAU,
            error: f64::INFINITY,
            remedy: "two waves cannot be told apart there; use method = \"residues\", or a frequency beside it",
        })?;
        Ok(x.iter().map(|x| waves.at(&amplitude, x - from)).collect())
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}
