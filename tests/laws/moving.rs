//! Laws of tracks under moving loads, on springs and on layered ground.

use crate::draw::{Ground, ground};
use crate::springs::springs;
use crate::track::{Track, track};
use crate::{SOLVERS, Verdict, ask, report, within};
use groundwave::foundation::{Foundation, LayeredSoil, Springs};
use groundwave::rail::TrackOnFoundation;
use groundwave::soil::{Compatibility, Solver, Strip};
use proptest::prelude::*;

/// A track, a ground, springs, speed over the slowest Rayleigh speed of the ground.
type Input = (Track, Ground, Springs, f64);
type Law = fn(&Track, &dyn Foundation, f64) -> Verdict;

const LAWS: &[(&str, Law)] = &[
    ("foundation", foundation),
    ("line", line),
    ("force balance", balance),
    ("drag", drag),
    ("mirror", mirror),
];

fn inputs() -> impl Strategy<Value = Input> {
    (track(), ground((1e-2, 10.0), (0.1, 1e3)), springs(), 0.05..1.4)
}

/// k(−β) = k(β), k(−ω) = k̄(ω), Im k ≥ 0, k > 0 at rest.
fn foundation(_: &Track, foundation: &dyn Foundation, speed: f64) -> Verdict {
    let at =
        |beta: f64, omega: f64| foundation.stiffness(beta, omega).map(|k| k.value).map_err(|e| e.to_string());
    for beta in [0.03, 0.4, 3.0] {
        let omega = beta * speed;
        let k = at(beta, omega)?;
        // measured 0, 0
        within((at(-beta, omega)? - k).norm() / k.norm(), 1e-14, || "β".into())?;
        within((at(beta, -omega)?.conj() - k).norm() / k.norm(), 1e-14, || "ω".into())?;
        // measured 0; the integral is asked for 1e-7
        within(-k.im / k.norm(), 1e-7, || format!("{k}"))?;
        let rest = at(beta, 0.0)?;
        if rest.re <= 0.0 || rest.im != 0.0 {
            return Err(format!("{rest} at rest"));
        }
    }
    Ok(0.0)
}

/// Along ω = −βv the rail answers as on k(β, ω) point by point.
fn line(track: &Track, foundation: &dyn Foundation, speed: f64) -> Verdict {
    let on = TrackOnFoundation::new(&track.stack, foundation, 0.0);
    let spectrum = on.spectrum(speed).map_err(|e| e.to_string())?;
    let rail = |beta: f64| -> Result<_, String> {
        let k = foundation.stiffness(beta, -beta * speed).map_err(|e| e.to_string())?.value;
        Ok((spectrum.at(beta).rail, track.stack.respond(beta, -beta * speed, k).rail))
    };
    let pairs = [0.03, 0.4, 3.0].into_iter().map(rail).collect::<Result<Vec<_>, _>>()?;
    let largest = pairs.iter().map(|(_, exact)| exact.norm()).fold(0.0, f64::max);
    let gap = pairs.iter().map(|(got, exact)| (got - exact).norm() / largest).fold(0.0, f64::max);
    // measured 2.4e-5 on ground, 0 on springs; 1e-5 of ∫ |ũ| dβ is allowed, in a unit of ln β
    within(gap, 2e-4, || format!("missed by {}", spectrum.worst()))
}

/// The ground carries the whole load: q̃ → 1 as β → 0.
fn balance(track: &Track, foundation: &dyn Foundation, speed: f64) -> Verdict {
    let track = TrackOnFoundation::new(&track.stack, foundation, 0.0);
    let spectrum = track.spectrum(speed).map_err(|e| e.to_string())?;
    let force = spectrum.force(1e-6);
    // measured 1.4e-10 on springs, 2.5e-12 on ground
    within((force - 1.0).norm(), 1e-8, || format!("{force}"))
}

/// A constant load feeds in P v (−w′) ≥ 0: it never rolls downhill, and at rest it stands level.
fn drag(track: &Track, foundation: &dyn Foundation, speed: f64) -> Verdict {
    let track = TrackOnFoundation::new(&track.stack, foundation, 0.0);
    let mut worst = 0.0f64;
    for speed in [0.0, speed] {
        let response = track.moving(speed, 5.0).map_err(|e| e.to_string())?;
        let slope = response.rail(0.01) - response.rail(-0.01);
        let scale = response.rail(0.0).abs();
        let gap = if speed == 0.0 { slope.abs() } else { slope };
        // measured 0; the integral is asked for 1e-5
        worst = worst.max(within(gap / scale, 1e-9, || format!("slope {slope} at {speed} m/s"))?);
    }
    Ok(worst)
}

/// Running the other way mirrors the shape.
fn mirror(track: &Track, foundation: &dyn Foundation, speed: f64) -> Verdict {
    let track = TrackOnFoundation::new(&track.stack, foundation, 0.0);
    let forth = track.moving(speed, 20.0).map_err(|e| e.to_string())?;
    let back = track.moving(-speed, 20.0).map_err(|e| e.to_string())?;
    let mut worst = 0.0f64;
    for x in [-15.0, -2.0, 0.0, 0.7, 9.0] {
        let gap = (forth.rail(x) - back.rail(-x)).abs() / forth.rail(0.0).abs();
        // measured 0: conjugate integrands
        worst = worst.max(within(gap, 1e-12, || format!("x = {x}"))?);
    }
    Ok(worst)
}

fn soil(ground: &Ground, solver: Solver) -> LayeredSoil {
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };
    LayeredSoil::new(ground.profile(), solver, strip).unwrap()
}

#[test]
fn springs_obey_every_law() {
    for (name, law) in LAWS {
        let verdict = ask(200, &inputs(), |(track, _, springs, ratio)| law(track, springs, 100.0 * ratio));
        report(&format!("springs, {name}"), verdict);
    }
}

#[test]
fn layered_ground_obeys_every_law() {
    for &solver in SOLVERS {
        for (name, law) in LAWS {
            let verdict = ask(10, &inputs(), |(track, ground, _, ratio)| {
                let soil = soil(ground, solver);
                law(track, &soil, ratio * ground.profile().slowest_rayleigh_speed())
            });
            report(&format!("{solver:?}, {name}"), verdict);
        }
    }
}
