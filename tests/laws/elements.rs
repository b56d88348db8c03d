//! Laws of elements k*(ω). A new `Element` enters `ELEMENTS` and inherits them all.

use crate::draw::log;
use crate::{Verdict, ask, report, within};
use groundwave::foundation::{Foundation, FoundationModel, Springs, Winkler};
use groundwave::track::{Element, Link};
use num_complex::Complex64;
use proptest::prelude::*;

/// Two stiffnesses [N/m²], two dampings [N s/m²], a loss factor.
type Numbers = (f64, f64, f64, f64, f64);

/// Every registered element.
const ELEMENTS: &[fn(Numbers) -> Element] =
    &[spring, maxwell, zener, thomson_1, thomson_2, dashpot_parallel_maxwell, causal_hysteretic];

fn spring((stiffness, _, damping, _, loss_factor): Numbers) -> Element {
    Element::Spring { stiffness, damping, loss_factor }
}

fn maxwell((stiffness, _, damping, ..): Numbers) -> Element {
    Element::Maxwell { stiffness, damping }
}

fn zener((stiffness, second_stiffness, damping, ..): Numbers) -> Element {
    Element::Zener { stiffness, second_stiffness, damping }
}

fn thomson_1((stiffness, second_stiffness, damping, ..): Numbers) -> Element {
    Element::PoyntingThomson1 { stiffness, second_stiffness, damping }
}

fn thomson_2((stiffness, _, damping, second_damping, _): Numbers) -> Element {
    Element::PoyntingThomson2 { stiffness, damping, second_damping }
}

fn dashpot_parallel_maxwell((stiffness, _, damping, second_damping, _): Numbers) -> Element {
    Element::DashpotParallelMaxwell { stiffness, damping, second_damping }
}

/// Its stiffness is negative below 1e-8 Hz at η = 0.07.
fn causal_hysteretic((stiffness, _, _, _, loss_factor): Numbers) -> Element {
    Element::CausalHysteretic { stiffness, loss_factor: 0.3 * loss_factor, reference_frequency: 100.0 }
}

/// Any registered element.
pub fn element() -> impl Strategy<Value = Element> {
    let numbers = (log(1e7, 1e9), log(1e7, 1e9), log(1e4, 1e6), log(1e4, 1e6), log(1e-3, 0.2));
    (0..ELEMENTS.len(), numbers).prop_map(|(i, numbers)| ELEMENTS[i](numbers).checked().unwrap())
}

/// An element and ω > 0.
type Input = (Element, f64);
/// How an element answers ω: that of the crate, or a wrong one.
type Answer = fn(Element, f64) -> Complex64;
type Law = fn(Answer, &Input) -> Verdict;

const LAWS: &[(&str, Law)] =
    &[("elements conjugate", conjugate), ("elements passive", passive), ("elements at their ends", ends)];

fn right(element: Element, omega: f64) -> Complex64 {
    let springs =
        Springs::new(FoundationModel::Winkler(Winkler { springs: Link::Element(element) })).unwrap();
    springs.stiffness(1.0, omega).unwrap().value
}

/// k(−ω) = k̄(ω)
fn conjugate(answer: Answer, &(element, omega): &Input) -> Verdict {
    let k = answer(element, omega);
    // measured 0
    within((answer(element, -omega).conj() - k).norm() / k.norm(), 1e-15, || format!("{element:?}"))
}

/// Im k ≥ 0 for ω > 0, and Re k ≥ 0: no element gives energy, or pushes.
fn passive(answer: Answer, &(element, omega): &Input) -> Verdict {
    let k = answer(element, omega);
    // measured 0
    within((-k.im).max(-k.re) / k.norm(), 1e-15, || format!("{element:?}: {k}"))
}

/// Slowly, the spring that is left without loss; quickly, what the dashpots hold: springs, or one dashpot.
fn ends(answer: Answer, &(element, _): &Input) -> Verdict {
    if matches!(element, Element::CausalHysteretic { .. }) {
        return Ok(0.0);
    }
    let (slow, left) = (answer(element, 1e-6), element.undamped().stiffness(1.0).re);
    let fast = 1e12;
    // k or iωc
    let held = match element {
        Element::Spring { stiffness, damping, loss_factor } => {
            stiffness * Complex64::new(1.0, loss_factor) + Complex64::new(0.0, fast * damping)
        }
        Element::Maxwell { stiffness, .. } | Element::PoyntingThomson1 { stiffness, .. } => stiffness.into(),
        Element::Zener { stiffness, second_stiffness, .. } => (stiffness + second_stiffness).into(),
        Element::PoyntingThomson2 { damping: c, second_damping, .. } => {
            Complex64::new(0.0, fast * c * second_damping / (c + second_damping))
        }
        Element::DashpotParallelMaxwell { second_damping, .. } => Complex64::new(0.0, fast * second_damping),
        Element::CausalHysteretic { .. } => unreachable!(),
    };
    let gap = (answer(element, fast) - held).norm() / held.norm();
    // ωc/k of what is left: 1e-6 × 1e6/1e7; measured 1e-7
    let rest = (slow.re - left).abs() / 1e7;
    within(gap.max(rest), 1e-6, || format!("{element:?}: {slow} {left} {held}"))
}

#[test]
fn elements_obey_every_law() {
    for (name, law) in LAWS {
        report(name, ask(2000, &(element(), log(1.0, 1e5)), |input| law(right, input)));
    }
}

#[test]
fn wrong_elements_are_caught() {
    let wrong: &[(&str, Answer)] = &[
        ("elements conjugate", |element, omega| right(element, omega.abs())),
        ("elements passive", |element, omega| right(element, -omega)),
        ("elements at their ends", |element, omega| 1.001 * right(element, omega)),
    ];
    for (name, law) in LAWS {
        let (_, answer) = wrong.iter().find(|(n, _)| n == name).expect("a wrong element for every law");
        assert!(ask(200, &(element(), log(1.0, 1e5)), |input| law(*answer, input)).is_err(), "{name}");
    }
}
