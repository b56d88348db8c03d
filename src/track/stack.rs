//! A vertical stack of members and links on a foundation.

use super::{Link, Member};
use num_complex::Complex64;

/// Members from the rail downward, each joined to the next by a link. A last link without a member below it ends on the
/// foundation through a massless base; without it the last member lies on the foundation. An empty stack is a load
/// straight on the foundation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stack {
    members: Vec<Member>,
    links: Vec<Link>,
}

/// Response to a unit force per metre wave on the rail [m per N/m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacements {
    /// Of the rail, or of whatever the load stands on.
    pub rail: Complex64,
    /// Of the foundation under the track.
    pub base: Complex64,
}

impl Stack {
    /// A stack of `members` joined by `links`.
    ///
    /// # Panics
    /// Unless there are as many links as members, or one fewer: a programming error.
    pub fn new(members: Vec<Member>, links: Vec<Link>) -> Self {
        assert!(
            links.len() == members.len() || links.len() + 1 == members.len(),
            "members and links alternate"
        );
        Self { members, links }
    }

    /// Steady response at (β, ω) on a foundation of stiffness `foundation` [N/m²].
    ///
    /// Eliminated from below, like springs in series: K ← member + upper − cross²/(lower + K).
    /// Source: appendix A.2–A.4, any of them.
    pub fn respond(&self, beta: f64, omega: f64, foundation: Complex64) -> Displacements {
        let own = |i: usize| self.members.get(i).map_or(Complex64::ZERO, |m| m.stiffness(beta, omega));
        // degrees of freedom: members, and the base where a link ends on the foundation
        let mut stiffness = own(self.links.len()) + foundation;
        let mut ratio = Complex64::ONE;
        for (i, link) in self.links.iter().enumerate().rev() {
            let link = link.stiffness(omega);
            let below = link.lower + stiffness;
            // the lower displacement per upper displacement
            let carried = -link.cross / below;
            ratio *= carried;
            stiffness = own(i) + link.upper + link.cross * carried;
        }
        let rail = 1.0 / stiffness;
        Displacements { rail, base: rail * ratio }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix3, Vector3};

    #[test]
    fn equals_the_assembled_matrix_of_the_appendix() {
        // A.2 written out; measured 2e-16
        let (beta, omega, k_eq) = (0.8_f64, 90.0_f64, Complex64::new(8e7, 6e6));
        let (ei, m_r, m_s) = (1.276e7, 120.46, 490.0);
        let pad = Complex64::new(7e8, omega * 3.84e4);
        let (ea, h, c) = (1.75e8, 0.35, 333.0);
        let x = omega * h / c;
        let (t, s) = (ea / h * x / x.tan(), ea / h * x / x.sin());
        let one = Complex64::ONE;
        let d = Matrix3::new(
            ei * 0.8f64.powi(4) - omega * omega * m_r + pad,
            -pad,
            0.0 * one,
            -pad,
            pad + t - omega * omega * m_s,
            -s * one,
            0.0 * one,
            -s * one,
            t + k_eq,
        );
        let u = d.try_inverse().unwrap() * Vector3::new(one, 0.0 * one, 0.0 * one);
        let stack = Stack::new(
            vec![Member::beam(ei, m_r, 0.0).unwrap(), Member::mass(m_s).unwrap()],
            vec![
                Link::spring(7e8, 3.84e4, 0.0).unwrap(),
                Link::Bars { axial_stiffness: ea, height: h, wave_speed: c, loss_factor: 0.0 },
            ],
        );
        let got = stack.respond(beta, omega, k_eq);
        assert!((got.rail - u[0]).norm() < 1e-14 * u[0].norm());
        assert!((got.base - u[2]).norm() < 1e-14 * u[2].norm());
    }

    #[test]
    fn an_empty_stack_is_the_foundation() {
        let got = Stack::default().respond(1.0, 1.0, Complex64::new(4.0, 0.0));
        assert_eq!(got.rail, got.base);
        assert_eq!(got.rail.re, 0.25);
    }
}
