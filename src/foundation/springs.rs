//! Foundations of springs: whatever a stack of members and links on rigid rock says at its top.

use super::{Asked, Foundation, FoundationError, FoundationModel, Grain, Stiffness, Winkler};
use crate::track::Stack;
use num_complex::Complex64;
use serde::Deserialize;

/// A foundation of springs, checked: `[foundation]` of a case file.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(try_from = "FoundationModel")]
pub struct Springs {
    model: FoundationModel,
    stack: Stack,
}

impl Springs {
    /// The springs of `model`.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(model: FoundationModel) -> Result<Self, FoundationError> {
        Ok(Self { model, stack: model.stack()? })
    }

    /// Winkler's springs of `stiffness` k [N/m²], viscous `damping` c [N s/m²] and `loss_factor` η.
    ///
    /// # Errors
    /// A stiffness that is not positive, negative damping.
    pub fn winkler(stiffness: f64, damping: f64, loss_factor: f64) -> Result<Self, FoundationError> {
        Self::new(FoundationModel::Winkler(Winkler { stiffness, damping, loss_factor }))
    }

    /// What they were made from.
    pub fn model(&self) -> &FoundationModel {
        &self.model
    }

    /// k(β, ω) [N/m²], exact; `beta2` = β² may be complex.
    pub fn at(&self, beta2: Complex64, omega: f64) -> Complex64 {
        self.stack.on_rock(beta2, omega)
    }
}

impl TryFrom<FoundationModel> for Springs {
    type Error = FoundationError;

    fn try_from(model: FoundationModel) -> Result<Self, FoundationError> {
        Self::new(model)
    }
}

impl Foundation for Springs {
    fn answer(&self, asked: Asked) -> Result<Stiffness, FoundationError> {
        let value = self.at((asked.beta * asked.beta).into(), asked.omega);
        Ok(Stiffness { value, relative_error: 0.0, converged: true, count: 0 })
    }

    fn grain(&self) -> Grain {
        Grain::Formula
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FilonenkoBorodich, Hetenyi, Kerr, Pasternak};
    use super::*;
    use crate::math::complex::{I, sign};

    #[test]
    fn stacks_are_the_closed_forms() {
        let (stiffness, damping, loss_factor) = (4.5e8, 3e4, 0.2);
        let (n, d, upper_stiffness) = (3e7, 1.5e6, 9e8);
        for omega in [-700.0, 0.0, 60.0] {
            let k = stiffness * (1.0 + I * loss_factor * sign(omega)) + I * omega * damping;
            for beta2 in [Complex64::ZERO, 0.25.into(), 400.0.into(), Complex64::new(-1.0, 3.0)] {
                for (model, exact) in [
                    (FoundationModel::Winkler(Winkler { stiffness, damping, loss_factor }), k),
                    (
                        FoundationModel::FilonenkoBorodich(FilonenkoBorodich {
                            stiffness,
                            damping,
                            loss_factor,
                            tension: n,
                        }),
                        k + n * beta2,
                    ),
                    (
                        FoundationModel::Hetenyi(Hetenyi {
                            stiffness,
                            damping,
                            loss_factor,
                            bending_stiffness: d,
                        }),
                        k + d * beta2 * beta2,
                    ),
                    (
                        FoundationModel::Pasternak(Pasternak { stiffness, damping, loss_factor, shear: n }),
                        k + n * beta2,
                    ),
                    (
                        FoundationModel::Kerr(Kerr {
                            stiffness,
                            damping,
                            loss_factor,
                            shear: n,
                            upper_stiffness,
                        }),
                        upper_stiffness * (k + n * beta2) / (upper_stiffness + k + n * beta2),
                    ),
                ] {
                    let got = Springs::new(model).unwrap().at(beta2, omega);
                    // measured 3e-16
                    assert!((got - exact).norm() < 1e-14 * exact.norm(), "{}: {got} {exact}", model.name());
                }
            }
        }
    }

    #[test]
    fn what_is_out_of_range_is_named_by_its_key() {
        let kerr = |stiffness, shear, upper_stiffness| {
            let model = Kerr { stiffness, damping: 0.0, loss_factor: 0.0, shear, upper_stiffness };
            Springs::new(FoundationModel::Kerr(model)).map_err(|error| error.to_string())
        };
        assert!(kerr(1e8, 0.0, 1e8).is_ok());
        assert!(kerr(0.0, 1e7, 1e8).is_err_and(|e| e.contains("stiffness is 0 N/m²")));
        assert!(kerr(1e8, -1e7, 1e8).is_err_and(|e| e.contains("shear is -10000000 N")));
        assert!(kerr(1e8, 1e7, -1.0).is_err_and(|e| e.contains("upper_stiffness is -1 N/m²")));
    }
}
