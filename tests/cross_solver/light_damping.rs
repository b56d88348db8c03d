//! Poles close to the real axis: the strip integral of lightly damped ground, on the axis and off it.

use crate::common::profile;
use groundwave::foundation::{Foundation, FoundationError, LayeredSoil};
use groundwave::math::quadrature::{Tolerance, integrate};
use groundwave::soil::{Compatibility, DirectStiffness, GroundSolver, Profile, Solver, Strip, half_space};
use num_complex::Complex64;
use std::f64::consts::PI;

fn ground(eta: f64) -> Profile {
    profile(&[(2.0, 60e6, 0.35, 1500.0, eta)], (200e6, 0.35, 1800.0, eta))
}

/// The oracle: a plain adaptive integral to 2e-9 without tail, outline or kernel period, on ten thousand panels.
fn plain(profile: &Profile, beta: f64, omega: f64, strip: Strip) -> Complex64 {
    let ground = DirectStiffness.prepare(profile, omega, &[]).unwrap();
    let f = |y: f64| ground.u_zz(beta.hypot(y)) * strip.kernel(y);
    let points: Vec<f64> = (0..=10_000).map(|i| 0.5 * f64::from(i)).collect();
    let tolerance = Tolerance { relative: 1e-10, absolute: 0.0, max_count: 2_000_000 };
    // beyond Y = 5000: ∫ (A/y) · ½/(by)² dy = A/(4 b² Y²)
    let (a, _) = half_space::static_tail(profile.top(), omega);
    (integrate(f, &points, tolerance).value + a / (4.0 * (strip.half_width * 5000.0).powi(2))) / PI
}

#[test]
fn narrow_poles_are_found() {
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };
    for eta in [1e-4, 1e-3, 1e-2] {
        let profile = ground(eta);
        for (beta, omega) in [(0.2, 60.0), (0.5, 120.0), (1.0, 300.0)] {
            let prepared = DirectStiffness.prepare(&profile, omega, &[]).unwrap();
            let got = prepared.strip(beta, strip, 1e-8);
            let exact = plain(&profile, beta, omega, strip);
            let error = (got.value - exact).norm() / exact.norm();
            println!(
                "η = {eta}, β = {beta}, ω = {omega}: {error:e} of {:e}, {} evaluations",
                got.error / got.value.norm(),
                got.count
            );
            assert!(got.converged);
            // measured 1e-9 at most
            assert!(error < 1e-8, "{error:e}");
        }
    }
}

#[test]
fn a_pole_on_the_axis_is_reported() {
    // undamped: the integral does not exist, and the quadrature says so
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };
    let prepared = DirectStiffness.prepare(&ground(0.0), 60.0, &[]).unwrap();
    assert!(!prepared.strip(0.2, strip, 1e-8).converged);
}

/// Limiting absorption: undamped ground under a foundation has the stiffness to which damped ground tends, radiation and all.
#[test]
fn undamped_ground_is_the_limit_of_damped_ground() {
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };
    let stiffness = |eta: f64, beta: f64, omega: f64, solver: Solver| {
        LayeredSoil::new(ground(eta), solver, strip).unwrap().stiffness_to(beta, omega, 1e-8)
    };
    for (beta, omega) in [(0.2, 60.0), (0.5, 120.0), (1.0, 300.0), (1.0, 60.0)] {
        let limit = stiffness(0.0, beta, omega, Solver::DirectStiffness).unwrap().value;
        let away = |eta: f64| {
            (stiffness(eta, beta, omega, Solver::DirectStiffness).unwrap().value - limit).norm()
                / limit.norm()
        };
        let (coarse, fine) = (away(1e-3), away(1e-4));
        println!("β = {beta}, ω = {omega}: {limit:.4e}, {coarse:.2e} at 1e-3, {fine:.2e} at 1e-4");
        // in proportion to η: measured 9.9 to 10.1 times less for a tenth of it; waves are shed where ω/β exceeds theirs
        assert!(fine < 1e-3 && (coarse / fine - 10.0).abs() < 0.5, "{coarse:e} {fine:e}");
        assert!((limit.im > 1e-3 * limit.re) == (omega / beta > 150.0), "{limit}");
    }
    // what stays on the real axis has no value there
    let refused = stiffness(0.0, 0.2, 60.0, Solver::Flexibility);
    assert!(matches!(refused, Err(FoundationError::Undamped { .. })), "{refused:?}");
}
