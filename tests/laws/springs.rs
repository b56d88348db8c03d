//! Laws of foundations of springs. A new `FoundationModel` enters `FOUNDATIONS` and inherits them all.

use crate::draw::log;
use crate::{Verdict, ask, report, within};
use groundwave::foundation::{
    FilonenkoBorodich, Foundation, FoundationModel, Hetenyi, Kerr, Pasternak, Springs, Winkler,
};
use groundwave::track::Link;
use num_complex::Complex64;
use proptest::prelude::*;

/// Stiffness [N/m²], damping [N s/m²], loss factor; what resists slope [N] or bending [N m²]; upper stiffness [N/m²].
pub type Numbers = (f64, f64, f64, f64, f64);

/// Every registered foundation of springs.
pub const FOUNDATIONS: &[fn(Numbers) -> FoundationModel] =
    &[winkler, filonenko_borodich, hetenyi, pasternak, kerr];

fn springs_of(stiffness: f64, damping: f64, loss_factor: f64) -> Link {
    Link::spring(stiffness, damping, loss_factor).unwrap()
}

fn winkler((stiffness, damping, loss_factor, ..): Numbers) -> FoundationModel {
    FoundationModel::Winkler(Winkler { springs: springs_of(stiffness, damping, loss_factor) })
}

fn filonenko_borodich((stiffness, damping, loss_factor, tension, _): Numbers) -> FoundationModel {
    FoundationModel::FilonenkoBorodich(FilonenkoBorodich {
        springs: springs_of(stiffness, damping, loss_factor),
        tension,
    })
}

fn hetenyi((stiffness, damping, loss_factor, bending_stiffness, _): Numbers) -> FoundationModel {
    FoundationModel::Hetenyi(Hetenyi {
        springs: springs_of(stiffness, damping, loss_factor),
        bending_stiffness,
    })
}

fn pasternak((stiffness, damping, loss_factor, shear, _): Numbers) -> FoundationModel {
    FoundationModel::Pasternak(Pasternak { springs: springs_of(stiffness, damping, loss_factor), shear })
}

fn kerr((stiffness, damping, loss_factor, shear, upper_stiffness): Numbers) -> FoundationModel {
    FoundationModel::Kerr(Kerr {
        springs: springs_of(stiffness, damping, loss_factor),
        shear,
        upper_stiffness,
    })
}

pub fn numbers() -> impl Strategy<Value = Numbers> {
    let none_or = |low, high| prop_oneof![1 => Just(0.0), 3 => log(low, high)];
    (log(1e6, 1e10), none_or(1e3, 1e6), none_or(1e-3, 0.5), none_or(1e5, 1e9), log(1e6, 1e12))
}

/// Any registered foundation.
pub fn springs() -> impl Strategy<Value = Springs> {
    (0..FOUNDATIONS.len(), numbers()).prop_map(|(i, numbers)| Springs::new(FOUNDATIONS[i](numbers)).unwrap())
}

/// Numbers, β, ω > 0.
type Input = (Numbers, f64, f64);
/// How a foundation answers (β, ω): that of the crate, or a wrong one.
type Answer = fn(FoundationModel, f64, f64) -> Complex64;
type Law = fn(Answer, &Input) -> Verdict;

const LAWS: &[(&str, Law)] = &[
    ("springs even in β", even),
    ("springs conjugate", conjugate),
    ("springs passive", passive),
    ("springs at rest", at_rest),
    ("springs in their limits", limits),
];

fn inputs() -> impl Strategy<Value = Input> {
    (numbers(), log(1e-3, 20.0), log(1.0, 1e4))
}

fn right(model: FoundationModel, beta: f64, omega: f64) -> Complex64 {
    Springs::new(model).unwrap().stiffness(beta, omega).unwrap().value
}

/// The largest of `law` over all foundations.
fn all(numbers: Numbers, law: impl Fn(FoundationModel) -> Verdict) -> Verdict {
    FOUNDATIONS.iter().try_fold(0.0f64, |worst, model| Ok(worst.max(law(model(numbers))?)))
}

/// k(−β) = k(β)
fn even(answer: Answer, &(numbers, beta, omega): &Input) -> Verdict {
    all(numbers, |model| {
        let gap = (answer(model, beta, omega) - answer(model, -beta, omega)).norm();
        // measured 0: only β² enters
        within(gap, 0.0, || format!("{model:?}"))
    })
}

/// k(−ω) = k̄(ω)
fn conjugate(answer: Answer, &(numbers, beta, omega): &Input) -> Verdict {
    all(numbers, |model| {
        let k = answer(model, beta, omega);
        // measured 0
        within((answer(model, beta, -omega).conj() - k).norm() / k.norm(), 1e-14, || format!("{model:?}"))
    })
}

/// Im k ≥ 0 for ω > 0: springs give no energy.
fn passive(answer: Answer, &(numbers, beta, omega): &Input) -> Verdict {
    all(numbers, |model| {
        let k = answer(model, beta, omega);
        // measured 0
        within(-k.im / k.norm(), 1e-15, || format!("{model:?}: {k}"))
    })
}

/// At rest k is real, above zero, and no smaller for shorter waves.
fn at_rest(answer: Answer, &(numbers, beta, _): &Input) -> Verdict {
    all(numbers, |model| {
        let (k, shorter) = (answer(model, beta, 0.0), answer(model, 1.5 * beta, 0.0));
        if k.im != 0.0 || k.re <= 0.0 {
            return Err(format!("{model:?}: {k}"));
        }
        // measured 0; rounding where the upper springs alone are felt
        within((k.re - shorter.re) / k.re, 1e-14, || format!("{model:?}: {k} {shorter}"))
    })
}

/// Each foundation becomes a plainer one as its own parameter vanishes or grows.
fn limits(answer: Answer, &(numbers, beta, omega): &Input) -> Verdict {
    let (k, c, eta, n, upper) = numbers;
    let (none, rigid) = ((k, c, eta, 0.0, upper), (k, c, eta, n, 1e30));
    let pairs = [
        ("no tension", filonenko_borodich(none), winkler(none), omega),
        ("no plate", hetenyi(none), winkler(none), omega),
        ("no shear", pasternak(none), winkler(none), omega),
        ("a membrane is a shear layer", pasternak(numbers), filonenko_borodich(numbers), omega),
        ("rigid upper springs", kerr(rigid), pasternak(numbers), omega),
        ("springs in series", kerr(none), winkler((k * upper / (k + upper), 0.0, 0.0, 0.0, 0.0)), 0.0),
        (
            "rigid lower springs",
            kerr((1e30, 0.0, 0.0, n, upper)),
            winkler((upper, 0.0, 0.0, 0.0, 0.0)),
            omega,
        ),
    ];
    let mut worst = 0.0f64;
    for (name, general, plain, omega) in pairs {
        let (general, plain) = (answer(general, beta, omega), answer(plain, beta, omega));
        // measured 4e-16; 1e30 is 1e14 times whatever else there is
        worst = worst.max(within((general - plain).norm() / plain.norm(), 1e-12, || {
            format!("{name}: {general} {plain}")
        })?);
    }
    Ok(worst)
}

#[test]
fn foundations_of_springs_obey_every_law() {
    for (name, law) in LAWS {
        report(name, ask(2000, &inputs(), |input| law(right, input)));
    }
}

#[test]
fn wrong_springs_are_caught() {
    let wrong: &[(&str, Answer)] = &[
        ("springs even in β", |model, beta, omega| {
            right(model, if beta < 0.0 { 1.000_001 * beta } else { beta }, omega)
        }),
        ("springs conjugate", |model, beta, omega| right(model, beta, omega.abs())),
        ("springs passive", |model, beta, omega| right(model, beta, -omega)),
        // a membrane under pressure
        ("springs at rest", |model, beta, omega| 2.0 * right(model, 0.0, omega) - right(model, beta, omega)),
        // the upper springs are not there
        ("springs in their limits", |model, beta, omega| match model {
            FoundationModel::Kerr(kerr) => right(
                FoundationModel::Kerr(Kerr { upper_stiffness: 2.0 * kerr.upper_stiffness, ..kerr }),
                beta,
                omega,
            ),
            model => right(model, beta, omega),
        }),
    ];
    for (name, law) in LAWS {
        let (_, answer) = wrong.iter().find(|(n, _)| n == name).expect("wrong springs for every law");
        assert!(ask(200, &inputs(), |input| law(*answer, input)).is_err(), "{name}");
    }
}
