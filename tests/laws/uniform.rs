//! Methods for a rail that is carried without interruption: they agree with one another, and each keeps the laws of receptances.

use crate::draw::log;
use crate::elements::element;
use crate::{Verdict, ask, report, springs, within};
use groundwave::foundation::{FoundationModel, Springs};
use groundwave::rail::{Drive, Method, RailError, moving, rail};
use groundwave::track::{Layout, Link, Member, Stack};
use proptest::prelude::*;

/// A track on springs or on rock, ω and a place.
#[derive(Debug)]
struct Input {
    layout: Layout,
    on: Springs,
    omega: f64,
    x: f64,
}

/// Rails of Euler–Bernoulli or Timoshenko with some loss, none to three layers of any elements, on any foundation.
fn inputs() -> impl Strategy<Value = Input> {
    let rail = (log(1e6, 1e8), log(20.0, 2000.0), log(1e8, 1e10), log(0.05, 5.0), any::<bool>());
    let layers = prop::collection::vec((element(), log(30.0, 3000.0)), 0..3);
    let lossy = springs::springs().prop_filter("a foundation with some loss", |springs| {
        let k = springs.at(0.0.into(), 1.0);
        k.im > 1e-3 * k.re
    });
    let on = prop_oneof![lossy.prop_map(Some), Just(None)];
    (rail, layers, on, log(10.0, 3e4), 0.0..5.0).prop_map(|(rail, layers, on, omega, x)| {
        let (ei, mass, shear, rotary, timoshenko) = rail;
        // what alone carries waves has some loss
        let rail = if timoshenko {
            Member::timoshenko(ei, mass, shear, rotary, 0.01).unwrap()
        } else {
            Member::beam(ei, mass, 0.01).unwrap()
        };
        let mut members = vec![rail];
        let mut links = Vec::new();
        for (element, mass) in layers {
            links.push(Link::Element(element));
            members.push(Member::mass(mass).unwrap());
        }
        let rock = on.is_none();
        if rock {
            links.push(Link::spring(1e8, 0.0, 0.1).unwrap());
        }
        let on = on.unwrap_or_else(|| Springs::new(FoundationModel::Rigid).unwrap());
        Input { layout: Layout::Continuous(Stack::new(members, links)), on, omega, x }
    })
}

/// Residues against every other method that knows the track; those by quadrature to 1e-6, or as far as they say.
fn agree(Input { layout, on, omega, x }: &Input) -> Verdict {
    let places = [0.0, *x];
    let ask = |method| rail(layout, on, method).and_then(|rail| rail.at(&places, 0.0, *omega));
    let exact = ask(Method::Residues).map_err(|error| error.to_string())?;
    let size = exact[0].value.norm();
    let mut worst = 0.0f64;
    for (method, bound) in [
        (Method::ClosedForm, 1e-9),
        (Method::BoundaryValues, 1e-9),
        (Method::Adaptive, 1e-6),
        (Method::Fourier, 1e-6),
        (Method::Filon, 1e-6),
    ] {
        let found = match ask(method) {
            Ok(found) => found,
            Err(RailError::Method { .. }) if method == Method::ClosedForm => continue,
            Err(error) => return Err(format!("{method:?}: {error}")),
        };
        for (a, b) in found.iter().zip(&exact) {
            let gap = (a.value - b.value).norm();
            within(gap / size, bound, || format!("{method:?}: {a:?} {b:?}"))?;
            // what it says of itself covers what it is
            within(gap, 2.0 * (a.error + b.error) + 1e-13 * size, || {
                format!("{method:?} says: {a:?} {b:?}")
            })?;
            worst = worst.max(gap / size / bound);
        }
    }
    Ok(worst)
}

/// Im α(x, x) ≤ 0 for ω > 0; α(x, x₀) = α(x₀, x); α(−ω) = ᾱ(ω).
fn receptances(Input { layout, on, omega, x }: &Input) -> Verdict {
    for method in [Method::Residues, Method::BoundaryValues, Method::Adaptive] {
        let rail = rail(layout, on, method).map_err(|error| error.to_string())?;
        let at = |x: f64, from: f64, omega: f64| {
            rail.at(&[x], from, omega).map(|a| a[0]).map_err(|e| e.to_string())
        };
        let here = at(*x, *x, *omega)?;
        let (size, error) = (here.value.norm(), here.error);
        within(here.value.im, error + 1e-13 * size, || format!("{method:?} gives energy: {here:?}"))?;
        let gap = (at(*x, 0.3, *omega)?.value - at(0.3, *x, *omega)?.value).norm();
        within(gap, 2.0 * error + 1e-13 * size, || format!("{method:?} is not reciprocal"))?;
        let gap = (at(*x, 0.3, -omega)?.value.conj() - at(*x, 0.3, *omega)?.value).norm();
        within(gap, 2.0 * error + 1e-13 * size, || format!("{method:?} is not real in time"))?;
    }
    Ok(0.0)
}

/// Residues and adaptive panels under loads that move, where the track is a polynomial in frequency.
fn moving_agree(Input { layout, on, omega, x }: &Input) -> Verdict {
    let drive = Drive { omega: *omega, speed: 40.0 };
    let places = [0.0, *x, -x];
    let ask = |method| moving(layout, on, method).and_then(|rail| rail.under(drive, 0.0, &places));
    let exact = match ask(Method::Residues) {
        Ok(exact) => exact,
        Err(RailError::Method { .. } | RailError::Foundation(_)) => return Ok(0.0),
        Err(error) => return Err(error.to_string()),
    };
    let found = ask(Method::Adaptive).map_err(|error| error.to_string())?;
    let size = exact[0].value.norm();
    found.iter().zip(&exact).try_fold(0.0f64, |worst, (a, b)| {
        let gap = (a.value - b.value).norm() / size;
        Ok(worst.max(within(gap, 1e-6, || format!("{a:?} {b:?}"))?))
    })
}

#[test]
fn methods_for_uniform_tracks_agree() {
    report("uniform tracks by all methods, of their bounds", ask(120, &inputs(), agree));
}

#[test]
fn receptances_of_uniform_tracks_obey_every_law() {
    report("receptances of uniform tracks", ask(100, &inputs(), receptances));
}

#[test]
fn loads_that_move_on_uniform_tracks_agree() {
    let viscous = inputs().prop_map(|input| {
        let Layout::Continuous(stack) = input.layout else { unreachable!() };
        let members = stack.members().iter().map(|m| m.undamped()).collect();
        Input { layout: Layout::Continuous(Stack::new(members, stack.links().to_vec())), ..input }
    });
    report("moving loads on uniform tracks", ask(400, &viscous, moving_agree));
}
