//! The state of the rail carried through one bay, Eqs (65)–(70), (76).

use super::cell::{Cell, Support};
use super::floquet::{ahead, uncoupled};
use crate::foundation::Foundation;
use crate::math::polynomial::roots;
use crate::rail::{Answer, BeamWaves, RailError, Receptance};
use crate::track::{Member, Supports};
use nalgebra::{Matrix4, Vector4};
use num_complex::Complex64;

/// A rail on equal supports by the matrix that carries (w, φ, −Q, −M) from one end of a bay to the other.
///
/// The eigenvalues by the pairs λ, 1/λ of its characteristic polynomial, λ⁴ − t₁λ³ + t₂λ² − t₁λ + 1 with t₁ = tr T and
/// t₂ = ½(tr²T − tr T²), the states of the waves by inverse iteration, their amplitudes by the jump of the force.
///
/// Accuracy: it loses e^{2|γ₂|L} of its digits, γ₂ the decaying wave of the bare rail: 1e-12 of the field at the force below 3 kHz on
/// the paper's track, and says so in its errors (test `cross_solver::periodic`). Source: Eqs (65)–(70), (76).
#[derive(Clone, Copy)]
pub struct TransferMatrix<'a> {
    cell: Cell<'a>,
}

impl<'a> TransferMatrix<'a> {
    /// `supports` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Supports joined by links or by the ground, whose state is more than that of the rail; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        let cell = Cell::new(supports, on)?;
        uncoupled(&cell, "transfer-matrix")?;
        if cell.joined() {
            let track = "links between supports: a bay hands on more than the state of its rail";
            return Err(RailError::Method { method: "transfer-matrix", track, able: JOINED });
        }
        Ok(Self { cell })
    }
}

/// What knows supports joined by links.
pub(super) const JOINED: &str = "floquet, dirac-comb, point-source";

/// Fields of the bare rail: columns the states of e^{−iγ₁x}, e^{−iγ₂x}, e^{iγ₁x}, e^{iγ₂x}.
struct Fields {
    beta: [Complex64; 4],
    states: Matrix4<Complex64>,
    inverse: Matrix4<Complex64>,
    /// What a state is measured in, for each of its parts.
    scale: Vector4<f64>,
}

impl Fields {
    fn new(rail: &Member, omega: f64) -> Option<Self> {
        let [a, b] = BeamWaves::new(rail, omega, Complex64::ZERO).gamma;
        let beta = [-a, -b, a, b];
        let columns = beta.map(|beta| {
            let [rotation, force, moment] = rail.carried(beta, omega);
            Vector4::new(Complex64::ONE, rotation, force, moment)
        });
        let mut states = Matrix4::from_columns(&columns);
        let scale = Vector4::from_fn(|row, _| states.row(row).iter().map(|c| c.norm()).fold(0.0, f64::max));
        (0..4).for_each(|row| states.row_mut(row).unscale_mut(scale[row]));
        Some(Self { beta, inverse: states.try_inverse()?, states, scale })
    }

    /// From x to x + `length` of bare rail.
    fn over(&self, length: f64) -> Matrix4<Complex64> {
        let turn = self.beta.map(|beta| (crate::math::complex::I * beta * length).exp());
        self.states * Matrix4::from_diagonal(&Vector4::from(turn)) * self.inverse
    }

    /// Across a support: −Q grows by −D w.
    fn across(&self, stiffness: Complex64) -> Matrix4<Complex64> {
        let mut across = Matrix4::identity();
        across[(2, 0)] = -stiffness * (self.scale[0] / self.scale[2]);
        across
    }
}

/// The state of the wave with factor `lambda` on which `matrix` acts, of length 1.
fn state_of(matrix: &Matrix4<Complex64>, lambda: Complex64) -> Option<Vector4<Complex64>> {
    // beside the eigenvalue by rounding, so that the inverse exists
    let shifted = matrix - Matrix4::identity() * (lambda * (1.0 + 1e-13));
    let inverse = shifted.lu();
    let mut state = Vector4::from_element(Complex64::ONE);
    for _ in 0..3 {
        state = inverse.solve(&state)?.normalize();
    }
    Some(state)
}

impl TransferMatrix<'_> {
    /// Fields at (bays, high, low) from a unit force, places as [`ahead`] gives them; None where a matrix is singular.
    fn fields(&self, omega: f64, stiffness: Complex64, places: &[(i64, f64, f64)]) -> Option<Vec<Answer>> {
        let fields = Fields::new(self.cell.rail(), omega)?;
        let length = self.cell.spacing();
        // of waves long beside a bay the states are nearly one; hard supports are large numbers among small ones
        let phase = fields.beta[1].norm() * length;
        let hard = fields.across(stiffness)[(2, 0)].norm();
        let lost = 1e-14 * ((2.0 * fields.beta[1].im.abs() * length).exp() + phase.powi(-3) + hard);
        places
            .iter()
            .map(|&(bays, high, low)| {
                // from the force to the same place of the next bay
                let ends = (fields.over(length - low), fields.over(low));
                let bay = ends.1 * fields.across(stiffness) * ends.0;
                let (trace, square) = (bay.trace(), (bay * bay).trace());
                // 4c² − 2t₁c + t₂ − 2 = 0
                let second = 0.5 * (trace * trace - square);
                let factors = roots(&[second - 2.0, -2.0 * trace, 4.0.into()]);
                let [a, b] = factors[..] else { return None };
                let pairs = [a, b].map(|c| {
                    let root = (c * c - 1.0).sqrt();
                    if (root * c.conj()).re < 0.0 { 1.0 / (c - root) } else { 1.0 / (c + root) }
                });
                let [right, left] = [pairs, pairs.map(|lambda| 1.0 / lambda)];
                let waves = [right[0], right[1], left[0], left[1]].map(|lambda| state_of(&bay, lambda));
                let [Some(p), Some(q), Some(r), Some(s)] = waves else { return None };
                // right of the force minus left of it: the force, (0, 0, 1, 0)
                let jump = Vector4::new(
                    Complex64::ZERO,
                    Complex64::ZERO,
                    (1.0 / fields.scale[2]).into(),
                    Complex64::ZERO,
                );
                let amplitudes = Matrix4::from_columns(&[p, q, -r, -s]).lu().solve(&jump)?;
                let own = (p * amplitudes[0] + q * amplitudes[1])[0] * fields.scale[0];
                let n = bays as i32;
                let state = p * (amplitudes[0] * right[0].powi(n)) + q * (amplitudes[1] * right[1].powi(n));
                let state = if high >= low {
                    fields.over(high - low) * state
                } else {
                    // the place lies before that of the force, one bay on
                    fields.over(high) * fields.across(stiffness) * fields.over(length - low) * state
                };
                let value = state[0] * fields.scale[0];
                // λ and 1/λ, or two waves, that are nearly one
                let apart = pairs.map(|lambda| (1.0 - lambda * lambda).norm()).into_iter();
                let nearest = apart.chain([(a - b).norm()]).fold(1.0, f64::min);
                Some(Answer { value, error: own.norm() * lost / nearest * (1.0 + bays as f64) })
            })
            .collect()
    }
}

impl Receptance for TransferMatrix<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let (p, q) = match self.cell.support(omega)? {
            Support::Local { p, q } => (p[0], q[0]),
            // refused at the door
            Support::Coupled { .. } => (Complex64::ZERO, Complex64::ONE),
        };
        let length = self.cell.spacing();
        let places: Vec<_> = x
            .iter()
            .map(|x| {
                let (bays, high, low) = ahead(*x, from, length);
                // a place before that of the force belongs to the bay before
                (if high < low { bays - 1 } else { bays }, high, low)
            })
            .collect();
        self.fields(omega, p / q, &places).ok_or(RailError::Unsettled {
            method: "transfer-matrix",
            frequency: omega / std::f64::consts::TAU,
            error: f64::INFINITY,
            remedy: "the state of a bay cannot be told from its waves there: ask \"floquet\"",
        })
    }

    fn period(&self) -> Option<f64> {
        Some(self.cell.spacing())
    }
}
