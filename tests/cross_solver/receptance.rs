//! Standing and moving harmonic loads against one another and against a plain sum.

use crate::common::{named, tracks};
use groundwave::foundation::LayeredSoil;
use groundwave::rail::TrackOnFoundation;
use groundwave::soil::{Solver, Strip, ThinLayer};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

fn soil(name: &str, solver: Solver) -> LayeredSoil {
    let strip = Strip { half_width: 1.25, compatibility: tracks::named(name).1 };
    LayeredSoil::new(named("paper_layered"), solver, strip).unwrap()
}

/// A driving frequency of 0 is a constant load, which other code knows.
#[test]
fn harmonic_load_of_no_frequency_is_the_moving_load() {
    for name in ["paper_ballasted", "paper_slab"] {
        let (stack, _) = tracks::named(name);
        let soil = soil(name, Solver::DirectStiffness);
        let track = TrackOnFoundation::new(&stack, &soil, 0.0);
        for speed in [40.0, 120.0] {
            let (harmonic, moving) =
                (track.harmonic(0.0, speed, 10.0).unwrap(), track.moving(speed, 10.0).unwrap());
            for x in [0.0, 2.5, -6.0] {
                let (a, b) = (harmonic.rail(x), moving.rail(x));
                let error = (a - b).norm() / moving.rail(0.0);
                println!("{name}, {speed} m/s, {x} m: {error:.1e}");
                // measured: at most 4e-5
                assert!(error < 2e-4, "{name}, {speed} m/s, {x} m: {a} {b}");
            }
        }
    }
}

/// Rail and ground by adaptive integrals against trapezoid sums over a fixed grid, and thin layers against exact ones.
#[test]
fn standing_load_by_plain_sums() {
    let (stack, compatibility) = tracks::named("paper_ballasted");
    let strip = Strip { half_width: 1.25, compatibility };
    let profile = named("paper_layered");
    for frequency in [19.0, 60.0] {
        let omega = TAU * frequency;
        let receivers = [5.0, 15.0];
        let answers = [Solver::DirectStiffness, Solver::ThinLayer(ThinLayer::default())].map(|solver| {
            let soil = soil("paper_ballasted", solver);
            let track = TrackOnFoundation::new(&stack, &soil, 0.0);
            let ground = solver.prepare_many(&profile, omega, 100.0, 1e-5).unwrap();
            let mut answer = vec![track.harmonic(omega, 0.0, 0.0).unwrap().rail(0.0)];
            let (ground, miss) = track.ground(omega, ground.as_ref(), strip, &receivers).unwrap();
            assert!(miss <= 1.0);
            answer.extend(ground);
            answer
        });
        // (1/π) ∫₀^∞ dβ by the trapezoid of an even function, integrals across by the solver's quadrature
        let ground = Solver::DirectStiffness.prepare_many(&profile, omega, 100.0, 1e-5).unwrap();
        // against poles 0.03 k_R from the axis, e^{−2π·0.03 k_R/step}
        let step = 2.5e-3 * frequency.min(12.0) / 8.0;
        let mut sum = [Complex64::ZERO; 3];
        for i in 0..(24.0 / step) as i32 {
            let beta = step * (f64::from(i) + 0.5);
            let stiffness = 1.0 / ground.strip(beta, strip, 1e-5).value;
            let u = stack.respond(beta, omega, stiffness);
            sum[0] += u.rail * step / PI;
            if beta < 5.0 {
                for (r, y) in receivers.iter().enumerate() {
                    let g = ground.receiver(beta, 1.25, *y, if beta < 3.5 { 1e-4 } else { 1e-1 }).value;
                    sum[r + 1] += u.base * stiffness * g * step / PI;
                }
            }
        }
        for i in 0..3 {
            let (direct, thin) = (answers[0][i], answers[1][i]);
            let by_sum = (direct - sum[i]).norm() / sum[i].norm();
            let by_solver = (thin - direct).norm() / direct.norm();
            println!("{frequency} Hz, {i}: {by_sum:.1e} {by_solver:.1e}");
            // measured: 2.3e-4 (the rail at 60 Hz, cut off at 24 rad/m), receivers 1e-5; solvers 2.3e-5
            assert!(by_sum < 1e-3 && by_solver < 2e-4, "{frequency} Hz, {i}: {by_sum:e} {by_solver:e}");
        }
    }
}

/// Two wheels feel one another alike while they stand: α(x) = α(−x).
#[test]
fn standing_wheels_are_reciprocal() {
    let (stack, _) = tracks::named("paper_slab");
    let soil = soil("paper_slab", Solver::DirectStiffness);
    let load = TrackOnFoundation::new(&stack, &soil, 0.0).harmonic(TAU * 30.0, 0.0, 3.0).unwrap();
    let (ahead, behind) = (load.rail(2.5), load.rail(-2.5));
    // measured 1e-16: even by construction
    assert!((ahead - behind).norm() < 1e-9 * ahead.norm(), "{ahead} {behind}");
    // running, they do not
    let load = TrackOnFoundation::new(&stack, &soil, 0.0).harmonic(TAU * 30.0, 60.0, 3.0).unwrap();
    assert!((load.rail(2.5) - load.rail(-2.5)).norm() > 1e-3 * load.rail(0.0).norm());
}
