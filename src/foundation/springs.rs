//! Foundations of springs: whatever a stack of members and links on rigid rock says at its top.

use super::{Asked, Foundation, FoundationError, FoundationModel, Grain, Stiffness, Winkler};
use crate::track::{Link, Member, Stack};
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
        let springs = Link::spring(stiffness, damping, loss_factor)?;
        Self::new(FoundationModel::Winkler(Winkler { springs }))
    }

    /// What they were made from.
    pub fn model(&self) -> &FoundationModel {
        &self.model
    }

    /// Its members and links, which stand on rock.
    pub fn stack(&self) -> &Stack {
        &self.stack
    }

    /// Whether neighbours feel one another: k depends on β.
    pub fn joined(&self) -> bool {
        self.stack.members().iter().any(Member::joins)
    }

    /// k(β, ω) [N/m²], exact, infinite for rock; `beta2` = β² may be complex.
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
    fn springs(&self) -> Option<&Springs> {
        Some(self)
    }

    fn check(&self, omega: f64) -> Result<(), FoundationError> {
        Ok(self.stack.check(omega)?)
    }

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
    use crate::track::Element;

    #[test]
    fn stacks_are_the_closed_forms() {
        let (stiffness, damping, loss_factor) = (4.5e8, 3e4, 0.2);
        let (n, d, upper_stiffness) = (3e7, 1.5e6, 9e8);
        for omega in [-700.0, 0.0, 60.0] {
            let k = stiffness * (1.0 + I * loss_factor * sign(omega)) + I * omega * damping;
            for beta2 in [Complex64::ZERO, 0.25.into(), 400.0.into(), Complex64::new(-1.0, 3.0)] {
                let springs = Link::spring(stiffness, damping, loss_factor).unwrap();
                for (model, exact) in [
                    (FoundationModel::Winkler(Winkler { springs }), k),
                    (
                        FoundationModel::FilonenkoBorodich(FilonenkoBorodich { springs, tension: n }),
                        k + n * beta2,
                    ),
                    (
                        FoundationModel::Hetenyi(Hetenyi { springs, bending_stiffness: d }),
                        k + d * beta2 * beta2,
                    ),
                    (FoundationModel::Pasternak(Pasternak { springs, shear: n }), k + n * beta2),
                    (
                        FoundationModel::Kerr(Kerr { springs, shear: n, upper_stiffness }),
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
            let springs = Link::spring(stiffness, 0.0, 0.0).map_err(|error| error.to_string())?;
            let model = Kerr { springs, shear, upper_stiffness };
            Springs::new(FoundationModel::Kerr(model)).map_err(|error| error.to_string())
        };
        assert!(kerr(1e8, 0.0, 1e8).is_ok());
        assert!(kerr(0.0, 1e7, 1e8).is_err_and(|e| e.contains("stiffness is 0 N/m²")));
        assert!(kerr(1e8, -1e7, 1e8).is_err_and(|e| e.contains("shear is -10000000 N")));
        assert!(kerr(1e8, 1e7, -1.0).is_err_and(|e| e.contains("upper_stiffness is -1 N/m²")));
    }

    #[test]
    fn rock_is_the_limit_of_stiff_springs() {
        let pads = Stack::new(
            vec![Member::beam(6e6, 60.0, 0.0).unwrap()],
            vec![Link::spring(2e8, 3e4, 0.0).unwrap()],
        );
        let rock = Springs::new(FoundationModel::Rigid).unwrap();
        let stiff = Springs::winkler(1e25, 0.0, 0.0).unwrap();
        for omega in [-300.0, 0.0, 2000.0] {
            let on = |springs: &Springs| pads.respond(0.7, omega, springs.at(0.49.into(), omega));
            let (rock, stiff) = (on(&rock), on(&stiff));
            // measured 0: the springs are 1e-17 of what stands on them
            assert!((rock.rail - stiff.rail).norm() < 1e-15 * rock.rail.norm());
            assert!((rock.force - stiff.force).norm() < 1e-15 * rock.force.norm());
            assert_eq!(rock.base, Complex64::ZERO);
        }
    }

    #[test]
    fn springs_that_creep_say_so() {
        let element = Element::Maxwell { stiffness: 1e8, damping: 1e5 };
        let creeping =
            Springs::new(FoundationModel::Winkler(Winkler { springs: Link::Element(element) })).unwrap();
        assert!(
            creeping.check(0.0).is_err_and(|e| e.to_string().contains("maxwell"))
                && creeping.check(1.0).is_ok()
        );
        assert!(Springs::winkler(1e8, 0.0, 0.1).unwrap().check(0.0).is_ok());
    }
}
