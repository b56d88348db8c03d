//! Lamprea-Pineda, Connolly & Hussein (2022), application 2: one axle on layered ground.

use crate::{Run, near, relative, run};
use groundwave::math::quadrature::{Tolerance, integrate};
use groundwave::{
    Base, Case, Compatibility, Elastic, Foundation, Layer, LayeredSoil, Link, Material, Member, Profile,
    Slab, Solver, Strip, Study, TrackOnFoundation,
};
use num_complex::Complex64;
use std::f64::consts::PI;
use std::sync::LazyLock;

pub const CASES: &[&str] = &["lamprea2022_ballasted", "lamprea2022_half_space", "lamprea2022_slab"];

pub static BALLASTED: LazyLock<Run> = LazyLock::new(|| run("lamprea2022_ballasted"));
static SLAB: LazyLock<Run> = LazyLock::new(|| run("lamprea2022_slab"));
static HALF_SPACE: LazyLock<Run> = LazyLock::new(|| run("lamprea2022_half_space"));

#[test]
fn ballasted_track() {
    let case = &*BALLASTED;
    // published, to the metre per second; α, the ballast's wave speed and the compatibility are not: +1.7 %
    relative("critical speed", case.critical_speed(), 135.0, 0.03);
    // what the equations give: 137.34; an independent script 137.7
    near("critical speed", case.critical_speed(), 137.3, 1.0);
    near("critical speed, independent", case.critical_speed(), 137.7, 3.0);
    // 2.2342 against 2.243 of the script: −0.4 %
    relative("largest deflection", case.critical_mm("max_down"), 2.243, 0.02);
    // 1.1505 against 1.13: +1.8 %, a constant of 0.02 mm at low speeds which that script lacks
    relative("static", case.critical_mm("reference_deflection"), 1.13, 0.025);
    near("amplification", case.answer("critical_speed", "amplification"), 1.942, 0.01);
}

#[test]
fn ballasted_track_in_shape_and_ground() {
    let case = &*BALLASTED;
    // the refined maximum and the shape at 137 m/s: 2.2342 and 2.2321
    let at_peak = 1e3 * case.answer("track_response", "max_down_137");
    relative("rail at 137 m/s", at_peak, case.critical_mm("max_down"), 2e-3);
    // centre compatibility: the base is the ground under the centre line; on grids of 0.1 and 0.25 m, 2.2267 and 2.2257
    let (speeds, x) = (case.values("track_response", "speed"), case.values("track_response", "x"));
    let base = case.values("track_response", "base");
    assert_eq!(base.len(), speeds.len() * x.len());
    let deepest = 1e3 * base.iter().fold(0.0f64, |m, u| m.max(*u));
    let ground = 1e3 * case.answer("contour", "max_u_z_137");
    relative("ground under the track", ground, deepest, 0.01);
    // below the ground's waves nearly nothing rises: 0.004 of 1.243
    assert!(
        case.answer("track_response", "max_up_68.5") < 0.01 * case.answer("track_response", "max_down_68.5")
    );
    // symmetric about the track
    let field = &case.outcome("contour").group.get("u_z").unwrap().values;
    let rows = field.shape()[1];
    for row in 0..rows / 2 {
        for column in 0..field.shape()[2] {
            let (left, right) = (field[[1, row, column]], field[[1, rows - 1 - row, column]]);
            assert!((left - right).abs() < 1e-9, "{row} {column}");
        }
    }
}

/// What the source does not print moves the ballasted track's critical speed by some per cent.
#[test]
fn unprinted_choices() {
    let text = std::fs::read_to_string(crate::folder().join("lamprea2022_ballasted/case.toml")).unwrap();
    for (from, to, speed, down) in [
        // measured 135.3, 2.331
        ("ballast.wave_speed = 333.0", "ballast.density = 1700.0", 135.3, 2.331),
        // measured 135.0, 2.014; independent script 135.3, 2.02
        ("\"centre\"", "\"mean\"", 135.0, 2.014),
        // measured 131.8, 2.505; independent script 131
        ("alpha = 0.5", "alpha = 1.0", 131.8, 2.505),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text);
        let mut case = Case::parse(&changed, "case", &|_| Err(String::new())).unwrap();
        case.studies.truncate(1);
        let Study::CriticalSpeed(study) = &mut case.studies[0] else { panic!() };
        study.speeds = vec![125.0, 130.0, 135.0, 140.0, 145.0];
        let found = crate::run_case(case);
        near(to, found.critical_speed(), speed, 0.3);
        relative(to, found.critical_mm("max_down"), down, 2e-3);
    }
}

#[test]
fn slab_track() {
    let case = &*SLAB;
    // published: −0.5 %
    relative("critical speed", case.critical_speed(), 171.0, 0.03);
    // 170.08; an independent script 170.5
    near("critical speed", case.critical_speed(), 170.0, 1.0);
    near("critical speed, independent", case.critical_speed(), 170.5, 3.0);
    // 1.2153 against 1.21: +0.4 %
    relative("largest deflection", case.critical_mm("max_down"), 1.21, 0.02);
    // 0.7403 against 0.721: +2.7 %, the same constant of 0.02 mm
    relative("static", case.critical_mm("reference_deflection"), 0.721, 0.03);
    near("amplification", case.answer("critical_speed", "amplification"), 1.642, 0.01);
    // the script's curve: never further away than 0.0195 mm
    for (speed, down) in [
        (60.0, 0.744),
        (90.0, 0.78),
        (100.0, 0.798),
        (120.0, 0.848),
        (130.0, 0.886),
        (140.0, 0.939),
        (150.0, 1.015),
        (160.0, 1.126),
        (170.0, 1.211),
        (180.0, 1.127),
        (190.0, 0.992),
        (200.0, 0.986),
    ] {
        near(&format!("{speed} m/s"), case.curve_mm(speed), down, 0.021);
    }
}

/// At 220 m/s the reference curve lies 0.67 % off; integrating without interpolating k_eq decides.
#[test]
fn slab_track_at_220_without_interpolation() {
    let material = |young, density| {
        Material::new(Elastic::YoungPoisson { young, poisson: 0.35 }, density, 0.06, 0.06).unwrap()
    };
    let layers = vec![Layer { thickness: 2.0, material: material(60e6, 1500.0) }];
    let profile = Profile::new(layers, Base::HalfSpace(material(200e6, 1800.0))).unwrap();
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };
    let soil = LayeredSoil::new(profile, Solver::DirectStiffness, strip).unwrap();
    let (rail, slab) = (Member::beam(1.276e7, 120.46, 0.0), Member::beam(9.77e7, 1250.0, 0.0));
    let pad = Link::spring(7e8, 3.84e4, 0.0).unwrap();
    let stack = Slab::new(rail.unwrap().into(), pad.into(), slab.unwrap()).stack().unwrap();
    let speed = 220.0;
    let response = TrackOnFoundation::new(&stack, &soil, 0.0).moving(speed, 60.0).unwrap();
    let rail = response.shape(-10.0, 0.05, 401).rail;
    let deepest = (0..rail.len()).max_by(|&a, &b| rail[a].total_cmp(&rail[b])).unwrap();
    let x = -10.0 + 0.05 * deepest as f64;
    // (1/π) Re ∫ ũ(β, −βv) e^{iβx} dβ, k_eq at every node
    let spectrum = |beta: f64| {
        let k_eq = soil.stiffness(beta, -beta * speed).unwrap().value;
        stack.respond(beta, -beta * speed, k_eq).rail * Complex64::cis(beta * x)
    };
    let mut points = vec![1e-7, 1e-5, 1e-3];
    while points[points.len() - 1] < 100.0 {
        let last: f64 = points[points.len() - 1];
        points.push(last + last.min(1.0));
    }
    let tolerance = Tolerance { relative: 1e-6, absolute: 0.0, max_count: 6000 };
    let direct = integrate(spectrum, &points, tolerance);
    let exact = direct.value.re / PI;
    println!("{} evaluations, error {:e}", direct.count, direct.error / direct.value.norm());
    relative("unit deflection", rail[deepest] / exact, 1.0, 1e-4);
}

#[test]
fn half_space() {
    let case = &*HALF_SPACE;
    let soil =
        Material::new(Elastic::YoungPoisson { young: 75e6, poisson: 0.35 }, 1800.0, 0.06, 0.06).unwrap();
    let rayleigh = soil.rayleigh_speed();
    relative("Rayleigh speed", rayleigh, 0.935_013_13 * soil.c_s(), 1e-8);
    // 114.78 below 116.16: the track's mass lowers it by 1.2 %
    relative("critical speed", case.critical_speed(), rayleigh, 0.03);
    assert!(case.critical_speed() < rayleigh);
    // its own values: 114.78, 2.551, 1.255
    near("critical speed", case.critical_speed(), 114.8, 0.3);
    relative("largest deflection", case.critical_mm("max_down"), 2.551, 5e-3);
    relative("static", case.critical_mm("reference_deflection"), 1.255, 5e-3);
}
