//! A vertical stack of members and links on a foundation.

use super::{Link, Member, TrackError};
use crate::math::complex::reciprocal;
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
    /// Handed to the foundation per unit force [1]: its stiffness times `base`, on rock what the last link bears.
    pub force: Complex64,
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

    /// Members from the rail downward.
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// Links from the rail downward.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// True without members: a load straight on what carries it.
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// Steady response at (β, ω) on a foundation of stiffness `foundation` [N/m²]: [`respond_at`](Self::respond_at) for real `beta`
    /// [rad/m].
    #[inline]
    pub fn respond(&self, beta: f64, omega: f64, foundation: Complex64) -> Displacements {
        self.respond_at((beta * beta).into(), omega, foundation)
    }

    /// Steady response at `beta2` = β² [rad²/m²], real or complex, and `omega` [rad/s] on a foundation of stiffness `foundation`
    /// [N/m²], infinite for rock.
    ///
    /// Eliminated from below, like springs in series. With r = −cross/(lower + K) the lower displacement per upper one,
    /// K ← member + (upper + cross) + r (lower + cross + K): what a link's ends do not share is its inertia alone, so that nothing
    /// cancels where it is stiff. Source: appendix A.2–A.4, any of them.
    pub fn respond_at(&self, beta2: Complex64, omega: f64, foundation: Complex64) -> Displacements {
        // degrees of freedom: members, and the base where a link ends on the foundation
        let mut stiffness = self.own(self.links.len(), beta2, omega) + foundation;
        let (mut ratio, mut force) = (Complex64::ONE, foundation);
        for (i, link) in self.links.iter().enumerate().rev() {
            let link = link.stiffness(omega);
            let carried = link.carried(stiffness);
            // on rock −cross per unit displacement above
            force = if stiffness.re == f64::INFINITY { -link.cross } else { force * carried };
            ratio *= carried;
            stiffness = self.own(i, beta2, omega) + link.seen_above(stiffness, carried);
        }
        let rail = reciprocal(stiffness);
        Displacements { rail, base: rail * ratio, force: rail * force }
    }

    /// Stiffness [N/m²] of the stack standing on rigid rock, seen from its top, at `beta2` = β² [rad²/m²] and `omega` [rad/s]; without
    /// a link infinite, the rock itself.
    pub fn on_rock(&self, beta2: Complex64, omega: f64) -> Complex64 {
        // None: what does not move
        let mut below: Option<Complex64> = None;
        for (i, link) in self.links.iter().enumerate().rev() {
            let link = link.stiffness(omega);
            let seen = below.map_or(link.upper, |k| link.seen_above(k, link.carried(k)));
            below = Some(self.own(i, beta2, omega) + seen);
        }
        below.unwrap_or(f64::INFINITY.into())
    }

    /// Stiffness of member number `i` by itself; 0 for the massless base.
    #[inline]
    fn own(&self, i: usize, beta2: Complex64, omega: f64) -> Complex64 {
        self.members.get(i).map_or(Complex64::ZERO, |member| member.stiffness(beta2, omega))
    }

    /// Refuses `omega` [rad/s] at which one of its elements is no spring; a constant load asks at 0, whatever its speed.
    ///
    /// # Errors
    /// As [`Element::check`](super::Element::check).
    pub fn check(&self, omega: f64) -> Result<(), TrackError> {
        self.members.iter().try_for_each(|member| member.check(omega))?;
        self.links.iter().try_for_each(|link| link.check(omega))
    }

    /// The same stack without dissipation.
    pub fn undamped(&self) -> Self {
        Self {
            members: self.members.iter().map(|m| m.undamped()).collect(),
            links: self.links.iter().map(|l| l.undamped()).collect(),
        }
    }

    /// Wavenumber β [rad/m] of the slowest wave that travels along the undamped stack at `omega` > 0 [rad/s] without load
    /// and with nothing below; None where there is no such wave, as between the resonance of the sleepers on the pads
    /// and the next one.
    ///
    /// The matrix grows with x = β⁴, as EI and N ≥ 0, so that its negative pivots become fewer as x grows, one at every wave: the
    /// last step is bisected. This wave is the bending of the whole track as ω → 0.
    ///
    /// Accuracy: of β⁴, rounding of the springs against the inertia of the track, 1e-16 k/(ω²m); published curves to 4e-9,
    /// their digits (test `papers::mezher`).
    /// Source: Mezher et al. 2016; the real part of their determinant is that of the undamped track.
    pub fn free_wave(&self, omega: f64) -> Option<f64> {
        let links: Vec<_> = self.links.iter().map(|l| l.undamped().stiffness(omega)).collect();
        let own = |i: usize, x: f64| match self.members.get(i) {
            // what resists bending or shear does not move then
            Some(beam) if x == f64::INFINITY && !beam.is_mass() => x,
            Some(mass) if x == f64::INFINITY => mass.stiffness(Complex64::ZERO, omega).re,
            Some(member) => member.undamped().stiffness(x.sqrt().into(), omega).re,
            None => 0.0,
        };
        let negative = |x: f64| {
            let mut pivot = own(links.len(), x);
            let mut count = 0;
            for (i, link) in links.iter().enumerate().rev() {
                pivot += link.lower.re;
                count += usize::from(pivot < 0.0);
                pivot = own(i, x) + link.upper.re - link.cross.re * link.cross.re / pivot;
            }
            count + usize::from(pivot < 0.0)
        };
        let rest = negative(f64::INFINITY);
        let (mut low, mut high) = (0.0, 1e-12);
        if negative(low) <= rest {
            return None;
        }
        // β up to 1e9 rad/m
        while negative(high) > rest {
            if high > 1e36 {
                return None;
            }
            (low, high) = (high, 16.0 * high);
        }
        while high - low > 1e-15 * high {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if negative(middle) > rest { low = middle } else { high = middle }
        }
        Some((0.5 * (low + high)).sqrt().sqrt())
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
    fn free_waves_are_those_of_the_determinant() {
        // a lone beam: β⁴ = ω²m/EI; measured 2e-16
        let beam = Stack::new(vec![Member::beam(1e8, 2000.0, 0.1).unwrap()], vec![]);
        let beta = beam.free_wave(30.0).unwrap();
        assert!((beta / (900.0f64 * 2000.0 / 1e8).powf(0.25) - 1.0).abs() < 1e-15);
        // two beams joined: det = (EI₁x − ω²m₁ + k)(EI₂x − ω²m₂ + k) − k², its larger root; measured 2e-15
        let (a, b, k) = ((1.29e7, 120.0), (1.34e8, 1093.75), 5e8);
        let members = [a, b].map(|(ei, m)| Member::beam(ei, m, 0.0).unwrap()).to_vec();
        let two = Stack::new(members, vec![Link::spring(k, 2.5e5, 0.2).unwrap()]);
        for omega in [0.1, 30.0, 500.0, 1500.0, 4000.0] {
            let (p, q) = (k - omega * omega * a.1, k - omega * omega * b.1);
            let (half, product) = (0.5 * (a.0 * q + b.0 * p), a.0 * b.0);
            let root = (half * half - product * (p * q - k * k)).sqrt();
            let x = if half < 0.0 { (root - half) / product } else { (k * k - p * q) / (half + root) };
            let found = two.free_wave(omega).unwrap();
            assert!((found.powi(4) / x - 1.0).abs() < 1e-9, "{omega}: {found} {x}");
        }
        // rail on pads on sleepers: no wave from √(k/m_s) to √(k/m_s + k/m_r)
        let members = vec![Member::beam(1.29e7, 120.0, 0.0).unwrap(), Member::mass(490.0).unwrap()];
        let sleepers = Stack::new(members, vec![Link::spring(5e8, 0.0, 0.0).unwrap()]);
        let (low, high) = ((5e8f64 / 490.0).sqrt(), (5e8f64 / 490.0 + 5e8 / 120.0).sqrt());
        for (omega, there) in
            [(0.99 * low, true), (1.01 * low, false), (0.99 * high, false), (1.01 * high, true)]
        {
            assert_eq!(sleepers.free_wave(omega).is_some(), there, "{omega}");
        }
        assert_eq!(Stack::default().free_wave(1.0), None);
    }

    #[test]
    fn standing_on_rock_is_the_limit_of_stiff_foundations() {
        let links = || {
            vec![
                Link::spring(7e8, 3.84e4, 0.1).unwrap(),
                Link::ConsistentMass { stiffness: 3.6e8, damping: 0.0, loss_factor: 1.0, mass: 1695.8 },
            ]
        };
        let rail = Member::beam(1.276e7, 120.46, 0.02).unwrap();
        let members = vec![rail, Member::string(2e7, 490.0).unwrap()];
        for stack in [
            Stack::new(members.clone(), links()),
            // the last member lies on the rock itself
            Stack::new([members, vec![rail]].concat(), links()),
        ] {
            for (beta2, omega) in [(0.0.into(), 0.0), (0.8.into(), 90.0), (Complex64::new(0.3, -2.0), -400.0)]
            {
                let (limit, rock) =
                    (1.0 / stack.respond_at(beta2, omega, 1e26.into()).rail, stack.on_rock(beta2, omega));
                // measured 2e-16; the springs are 1e-17 of the foundation
                assert!((limit - rock).norm() < 1e-14 * rock.norm(), "{limit} {rock}");
            }
        }
        assert_eq!(Stack::default().on_rock(0.0.into(), 1.0).re, f64::INFINITY);
    }

    #[test]
    fn stiff_links_cost_no_digits() {
        // springs in series: 1/k = 1/k₁ + 1/k₂; measured 2e-16, and 1e-7 before the differences were taken apart
        let pad = Stack::new(vec![Member::mass(0.0).unwrap()], vec![Link::spring(1e15, 0.0, 0.0).unwrap()]);
        let k = Complex64::new(1e6, 3e5);
        let exact = 1e-15 + 1.0 / k;
        assert!((pad.respond(1.0, 0.0, k).rail - exact).norm() < 1e-15 * exact.norm());
    }

    #[test]
    fn an_empty_stack_is_the_foundation() {
        let got = Stack::default().respond(1.0, 1.0, Complex64::new(4.0, 0.0));
        assert_eq!(got.rail, got.base);
        assert_eq!(got.rail.re, 0.25);
    }
}
