//! A track and the springs under it as one chain down to rock, and its answer as a ratio of polynomials.

use super::{Element, Link, Member, Stack};
use crate::math::complex::I;
use crate::math::expression::Polynomial;
use num_complex::Complex64;

/// What moves as one from the rail downward, each floor joined to the next by a link and the last one to rock.
#[derive(Clone, Debug, PartialEq)]
pub struct Tower {
    floors: Vec<Vec<Member>>,
    links: Vec<Link>,
}

/// A ratio n/d of polynomials.
#[derive(Clone, Debug, PartialEq)]
pub struct Ratio {
    /// n
    pub numerator: Polynomial,
    /// d
    pub denominator: Polynomial,
}

impl Ratio {
    fn whole(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::constant(1.0) }
    }

    fn plus(&self, other: &Self) -> Self {
        let crossed = [&self.numerator * &other.denominator, &other.numerator * &self.denominator];
        Self { numerator: &crossed[0] + &crossed[1], denominator: &self.denominator * &other.denominator }
    }
}

impl Tower {
    /// `track` on `springs`, both with their members; None where the lowest member lies on rock itself.
    pub fn new(track: &Stack, springs: &Stack) -> Option<Self> {
        let mut floors: Vec<Vec<Member>> = track.members().iter().map(|member| vec![*member]).collect();
        let ends = track.links().len() == floors.len();
        if springs.is_empty() {
            return (ends && !floors.is_empty()).then(|| Self { floors, links: track.links().to_vec() });
        }
        if ends {
            floors.push(Vec::new());
        }
        floors.last_mut()?.push(springs.members()[0]);
        floors.extend(springs.members()[1..].iter().map(|member| vec![*member]));
        let links = [track.links(), springs.links()].concat();
        (links.len() == floors.len()).then_some(Self { floors, links })
    }

    /// Members of each floor.
    pub fn floors(&self) -> &[Vec<Member>] {
        &self.floors
    }

    /// Stiffness [N/m²] under the rail alone, if nothing but the rail joins neighbours: the same at every β.
    pub fn under_rail(&self, omega: f64) -> Option<Complex64> {
        let mut under = self.clone();
        let rail = under.floors[0].remove(0);
        let uniform = under.floors.iter().flatten().all(|member| !member.joins());
        (uniform && rail.joins()).then(|| under.stiffness(Complex64::ZERO, omega)[0])
    }

    /// Stiffness [N/m²] seen from above of each floor and all below it, at `beta2` = β² and `omega` [rad/s].
    pub fn stiffness(&self, beta2: Complex64, omega: f64) -> Vec<Complex64> {
        let mut seen = vec![Complex64::ZERO; self.floors.len()];
        let mut below = Complex64::from(f64::INFINITY);
        for (i, link) in self.links.iter().enumerate().rev() {
            let link = link.stiffness(omega);
            let own: Complex64 = self.floors[i].iter().map(|member| member.stiffness(beta2, omega)).sum();
            below = own + link.seen_above(below, link.carried(below));
            seen[i] = below;
        }
        seen
    }

    /// Displacement of each floor in a wave of `beta2` = β² and `omega` [rad/s] that moves the rail by 1.
    pub fn shape(&self, beta2: Complex64, omega: f64) -> Vec<Complex64> {
        let seen = self.stiffness(beta2, omega);
        let mut shape = vec![Complex64::ONE; self.floors.len()];
        for i in 1..shape.len() {
            shape[i] = shape[i - 1] * self.links[i - 1].stiffness(omega).carried(seen[i]);
        }
        shape
    }

    /// ũ = n/d of the rail under a unit force [m per N/m], where `beta2` = β² and `omega` = ω are polynomials in one variable; None
    /// where ω is not constant and something is no polynomial in it: hysteretic loss, bars.
    ///
    /// From below: a link of U, C, L over b on K = p/q is seen from above as (Up + (UL − C²)q/b)/(Lq + bp).
    pub fn compliance(&self, beta2: &Polynomial, omega: &Polynomial) -> Option<Ratio> {
        let mut below: Option<Ratio> = None;
        for (floor, link) in self.floors.iter().zip(&self.links).rev() {
            let LinkRatio { upper, rest, lower, over } = LinkRatio::new(link, omega)?;
            let seen = match below {
                None => Ratio { numerator: upper, denominator: over },
                Some(Ratio { numerator: p, denominator: q }) => Ratio {
                    numerator: &(&upper * &p) + &(&rest * &q),
                    denominator: &(&lower * &q) + &(&over * &p),
                },
            };
            let own = |all: Ratio, member: &Member| Some(all.plus(&of_member(member, beta2, omega)?));
            below = Some(floor.iter().try_fold(seen, own)?);
        }
        below.map(|Ratio { numerator, denominator }| Ratio { numerator: denominator, denominator: numerator })
    }
}

/// Of a link: upper, lower, (upper lower − cross²)/over, all but the last times `over`.
struct LinkRatio {
    upper: Polynomial,
    rest: Polynomial,
    lower: Polynomial,
    over: Polynomial,
}

impl LinkRatio {
    fn new(link: &Link, omega: &Polynomial) -> Option<Self> {
        if let Link::Element(element) = link {
            let Ratio { numerator, denominator } = of_element(element, omega)?;
            let none = Polynomial::constant(0.0);
            return Some(Self { upper: numerator.clone(), rest: none, lower: numerator, over: denominator });
        }
        let one = Polynomial::constant(1.0);
        if let Some(omega) = omega.as_constant() {
            let k = link.stiffness(omega.re);
            let rest = k.upper * k.lower - k.cross * k.cross;
            let [upper, rest, lower] = [k.upper, rest, k.lower].map(Polynomial::constant);
            return Some(Self { upper, rest, lower, over: one });
        }
        match *link {
            Link::ConsistentMass { stiffness, damping, loss_factor: 0.0, mass } => {
                // k − ω²m/3, −(k + ω²m/6): their difference of squares is −ω²mk + ω⁴m²/12
                let k = &Polynomial::constant(stiffness) + &omega.times(I * damping);
                let inertia = (omega * omega).times(mass);
                let upper = &k + &inertia.times(-1.0 / 3.0);
                let rest = &(&inertia * &k).times(-1.0) + &(&inertia * &inertia).times(1.0 / 12.0);
                Some(Self { lower: upper.clone(), upper, rest, over: one })
            }
            _ => None,
        }
    }
}

/// k*(ω)
fn of_element(element: &Element, omega: &Polynomial) -> Option<Ratio> {
    if let Some(omega) = omega.as_constant() {
        return Some(Ratio::whole(Polynomial::constant(element.stiffness(omega.re))));
    }
    let s = omega.times(I);
    // Σ of its parts 1, s, s²
    let of = |parts: &[f64]| {
        let none = Polynomial::constant(0.0);
        parts.iter().rev().fold(none, |sum, part| &(&sum * &s) + &Polynomial::constant(*part))
    };
    let (numerator, denominator) = match *element {
        Element::Spring { stiffness, damping, loss_factor: 0.0 } => (of(&[stiffness, damping]), of(&[1.0])),
        Element::Spring { .. } | Element::CausalHysteretic { .. } => return None,
        Element::Maxwell { stiffness: k, damping: c } => (of(&[0.0, c * k]), of(&[k, c])),
        Element::Zener { stiffness: k1, second_stiffness: k2, damping: c } => {
            (of(&[k1 * k2, (k1 + k2) * c]), of(&[k2, c]))
        }
        Element::PoyntingThomson1 { stiffness: k1, second_stiffness: k2, damping: c } => {
            (of(&[k1 * k2, k1 * c]), of(&[k1 + k2, c]))
        }
        Element::PoyntingThomson2 { stiffness: k, damping: c, second_damping: c2 } => {
            (of(&[0.0, c2 * k, c2 * c]), of(&[k, c + c2]))
        }
        Element::DashpotParallelMaxwell { stiffness: k, damping: c, second_damping: c2 } => {
            (of(&[0.0, (c2 + c) * k, c * c2]), of(&[k, c]))
        }
    };
    Some(Ratio { numerator, denominator })
}

/// bβ²/(1 + b/κGA) + Nβ² − (ω² − iωα₁)m, b = EIβ² − (ω² − iωα₁)ρI
fn of_member(member: &Member, beta2: &Polynomial, omega: &Polynomial) -> Option<Ratio> {
    if omega.as_constant().is_none() && member.loss_factor != 0.0 {
        return None;
    }
    let loss = match omega.as_constant() {
        Some(omega) => Polynomial::constant(member.loss(omega.re)),
        None => &Polynomial::constant(1.0) + &omega.times(I * member.rayleigh.of_stiffness),
    };
    let inertia = &(omega * omega) + &omega.times(-I * member.rayleigh.of_mass);
    let b = &(&loss * beta2).times(member.bending_stiffness) + &inertia.times(-member.rotary_inertia);
    let mut all = Ratio::whole(inertia.times(-member.mass));
    if let Some(tension) = &member.tension {
        let Ratio { numerator, denominator } = of_element(tension, omega)?;
        all = all.plus(&Ratio { numerator: &numerator * beta2, denominator });
    }
    let bending = if member.shear_compliance == 0.0 {
        Ratio::whole(&b * beta2)
    } else {
        Ratio { numerator: &(&b * beta2) * &loss, denominator: &loss + &b.times(member.shear_compliance) }
    };
    // neither bends nor turns: no factor that cancels
    Some(if b.coefficients().is_empty() { all } else { all.plus(&bending) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::track::Rayleigh;

    fn towers() -> Vec<Tower> {
        let rail = Member::timoshenko(6.4e6, 60.0, 2.4e8, 0.24, 0.0).unwrap();
        let damped = rail.damped(Rayleigh::new(3.0, 1e-6).unwrap());
        let element = |element: Element| Link::Element(element.checked().unwrap());
        let zener = element(Element::Zener { stiffness: 3e8, second_stiffness: 2e8, damping: 3e5 });
        let thomson =
            element(Element::PoyntingThomson1 { stiffness: 3e8, second_stiffness: 2e8, damping: 3e5 });
        let creeping =
            element(Element::PoyntingThomson2 { stiffness: 3e8, damping: 2e5, second_damping: 3e6 });
        let last =
            element(Element::DashpotParallelMaxwell { stiffness: 3e8, damping: 2e5, second_damping: 3e6 });
        let maxwell = element(Element::Maxwell { stiffness: 3e8, damping: 2e6 });
        let ballast = Link::ConsistentMass { stiffness: 2e8, damping: 1e5, loss_factor: 0.0, mass: 800.0 };
        let mass = |kg| Member::mass(kg).unwrap();
        let plate = Member::beam(1.5e6, 30.0, 0.0).unwrap();
        let layer = Member::string(2e7, 100.0).unwrap();
        [
            (Stack::new(vec![rail], vec![]), Stack::new(vec![plate], vec![zener])),
            (Stack::new(vec![damped, mass(245.0)], vec![thomson, ballast]), Stack::default()),
            (
                Stack::new(vec![rail, mass(245.0), mass(800.0)], vec![maxwell, creeping]),
                Stack::new(vec![mass(0.0), layer], vec![last, zener]),
            ),
        ]
        .iter()
        .map(|(track, springs)| Tower::new(track, springs).unwrap())
        .collect()
    }

    #[test]
    fn polynomials_are_the_chain() {
        for tower in towers() {
            for (omega, speed) in [(900.0, 0.0), (300.0, 70.0), (-50.0, 200.0)] {
                let along = Polynomial::new(vec![omega.into(), (-speed).into()]);
                let beta = Polynomial::variable();
                let ratio = tower.compliance(&(&beta * &beta), &along).unwrap();
                for beta in [-3.0, 0.2, 8.0] {
                    let direct = 1.0 / tower.stiffness((beta * beta).into(), omega - beta * speed)[0];
                    let value = ratio.numerator.at(beta.into()).0 / ratio.denominator.at(beta.into()).0;
                    // measured 4e-15
                    assert!((value - direct).norm() < 1e-12 * direct.norm(), "{value} {direct}");
                }
            }
        }
    }

    #[test]
    fn what_is_no_polynomial_in_frequency_says_so() {
        let hysteretic = Stack::new(
            vec![Member::beam(6.4e6, 60.0, 0.0).unwrap()],
            vec![Link::spring(1e8, 0.0, 0.1).unwrap()],
        );
        let tower = Tower::new(&hysteretic, &Stack::default()).unwrap();
        let (x, moving) = (Polynomial::variable(), Polynomial::new(vec![5.0.into(), 1.0.into()]));
        assert!(tower.compliance(&x, &Polynomial::constant(5.0)).is_some());
        assert!(tower.compliance(&(&x * &x), &moving).is_none());
        // a beam on rock does not move
        let beam = Stack::new(vec![Member::beam(6.4e6, 60.0, 0.0).unwrap()], vec![]);
        assert!(Tower::new(&beam, &Stack::default()).is_none());
    }
}
