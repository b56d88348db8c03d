//! How the rail is carried along the track: without interruption, on equal supports, or by sections one after another.

use super::{Element, Member, Stack, TrackError};
use crate::math::polynomial::{plus, times};
use crate::quantity::positive;
use num_complex::Complex64;

/// What lies along the track.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// Everything is continuous: a stack per metre.
    Continuous(Stack),
    /// A rail on equal supports at x = nL.
    Discrete(Supports),
    /// Sections with supports, one after another.
    Varying(Vec<Section>),
}

impl From<Stack> for Layout {
    fn from(stack: Stack) -> Self {
        Self::Continuous(stack)
    }
}

/// A rail on equal supports at x = nL, n any integer.
#[derive(Clone, Debug, PartialEq)]
pub struct Supports {
    /// The rail.
    pub rail: Member,
    /// L [m]
    pub spacing: f64,
    /// What stands under the rail at each support, in N/m and kg, its first member the massless seat of the rail. What joins
    /// neighbouring supports is the tension [N/m] of a member.
    pub under: Stack,
    /// w [m] along the track over which a sleeper presses on ground that feels its neighbours, as soil does; None where every support
    /// has springs of its own.
    pub width: Option<f64>,
}

/// Supports of one kind, over a length.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Bays; None for the first and the last section, which never end. Supports stand in the middle of their bays.
    pub bays: Option<usize>,
    /// The supports.
    pub supports: Supports,
}

impl Supports {
    /// Those of a `track` per metre, every support carrying `spacing` L × what lies along a metre; `between` neighbouring ones is a spring
    /// [N/m] that joins their lowest masses.
    ///
    /// # Errors
    /// Lengths that are not positive, a track without a rail, springs between supports that have no mass to hold them.
    pub fn new(
        track: &Stack,
        spacing: f64,
        width: Option<f64>,
        between: Option<Element>,
    ) -> Result<Self, TrackError> {
        positive("support.spacing", spacing, "m")?;
        width.map(|width| positive("support.width", width, "m")).transpose()?;
        let (rail, below) = track.members().split_first().ok_or(TrackError::NoRail)?;
        let mut members = vec![Member::mass(0.0)?];
        members.extend(below.iter().map(|member| member.times(spacing)));
        if let Some(between) = between {
            let weighs = |member: &&mut Member| member.mass > 0.0;
            let lowest = members.iter_mut().rfind(weighs).ok_or(TrackError::NothingToJoin)?;
            *lowest = lowest.joined(between);
        }
        let links = track.links().iter().map(|link| link.times(spacing)).collect();
        Ok(Self { rail: *rail, spacing, under: Stack::new(members, links), width })
    }

    /// Stiffness D [N/m] of one support under the rail on ground of stiffness `ground` [N/m] (infinite: rock) in a wave whose
    /// neighbouring bays have the phase βL, `c` = cos βL.
    ///
    /// Links between neighbours give k_w(2u_n − u_{n−1} − u_{n+1}) = 2k_w(1 − c)u_n.
    pub fn stiffness(&self, c: Complex64, omega: f64, ground: Complex64) -> Complex64 {
        1.0 / self.under.respond_at(2.0 * (1.0 - c), omega, ground).rail
    }

    /// The same as numerator and denominator, D = P(y)/Q(y), in y = 2(1 − c), lowest power first, so that neither D = 0 nor D = ∞ is
    /// singular.
    ///
    /// Eliminated from below: a member of stiffness d(y)/n(y) over a link of upper u, cross x, lower l, that stands on P/Q, makes
    /// P ← d(lQ + P) + n(uP + (ul − x²)Q), Q ← n(lQ + P).
    pub fn rational(&self, omega: f64, ground: Complex64) -> (Vec<Complex64>, Vec<Complex64>) {
        let own = |i: usize| match self.under.members().get(i) {
            Some(member) => {
                let (n, d) = member.rational(omega, Complex64::ZERO);
                (n.to_vec(), d.to_vec())
            }
            None => (vec![Complex64::ONE], vec![Complex64::ZERO]),
        };
        let links = self.under.links();
        let (n, d) = own(links.len());
        let rigid = ground.re == f64::INFINITY;
        let (mut p, mut q) =
            if rigid { (n, vec![Complex64::ZERO]) } else { (plus(&d, &times(&n, &[ground])), n) };
        for (i, link) in links.iter().enumerate().rev() {
            let link = link.stiffness(omega);
            let (n, d) = own(i);
            let base = plus(&times(&q, &[link.lower]), &p);
            let beyond = link.upper * link.lower - link.cross * link.cross;
            let seen = plus(&times(&p, &[link.upper]), &times(&q, &[beyond]));
            (p, q) = (plus(&times(&d, &base), &times(&n, &seen)), times(&n, &base));
            // numbers of the size of one stiffness
            let size = base.iter().map(|c| c.norm()).fold(0.0, f64::max);
            p.iter_mut().chain(&mut q).for_each(|c| *c /= size);
        }
        (p, q)
    }

    /// Whether neighbouring supports are joined: D depends on c.
    pub fn joined(&self) -> bool {
        self.under.members().iter().any(Member::joins)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::track::Link;

    #[test]
    fn numerator_over_denominator_is_the_stiffness() {
        let spring = |k, eta| Link::spring(k, 0.0, eta).unwrap();
        let ballast = Member::mass(508.8).unwrap().joined(Element::spring(8e7, 0.0, 0.1).unwrap());
        let members = vec![Member::mass(0.0).unwrap(), Member::mass(147.0).unwrap(), ballast];
        let links = vec![spring(2.1e8, 0.15), spring(1.08e8, 1.0), spring(7.2e7, 0.1)];
        let rail = Member::beam(6.38e6, 60.23, 0.0).unwrap();
        let value =
            |p: &[Complex64], y: Complex64| p.iter().rev().fold(Complex64::ZERO, |sum, c| sum * y + c);
        for (links, ground) in [
            (links.clone(), f64::INFINITY.into()),
            (links.clone(), Complex64::new(5e7, 1e7)),
            (links[..2].to_vec(), Complex64::new(5e7, 1e7)),
        ] {
            let under = Stack::new(members.clone(), links);
            let supports = Supports { rail, spacing: 0.6, under, width: None };
            for omega in [10.0, 400.0, 3000.0] {
                let (p, q) = supports.rational(omega, ground);
                for c in [Complex64::ONE, Complex64::new(-0.3, 0.2), Complex64::new(40.0, -3.0)] {
                    let y = 2.0 * (1.0 - c);
                    let d = supports.stiffness(c, omega, ground);
                    // measured 7e-16
                    assert!((value(&p, y) / value(&q, y) - d).norm() < 1e-14 * d.norm(), "{omega} {c}");
                }
            }
        }
    }
}
