//! The recomputed speed curves of the paper's two tracks.

use crate::common::{named, tracks};
use groundwave::foundation::{Foundation, LayeredSoil};
use groundwave::math::quadrature::{Tolerance, integrate};
use groundwave::rail::TrackOnFoundation;
use groundwave::soil::{Base, Compatibility, Elastic, Layer, Material, Profile, Solver, Strip, ThinLayer};
use num_complex::Complex64;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;

fn soil(compatibility: groundwave::soil::Compatibility) -> LayeredSoil {
    let strip = Strip { half_width: 1.25, compatibility };
    LayeredSoil::new(named("paper_layered"), Solver::DirectStiffness, strip).unwrap()
}

#[test]
fn reference() {
    let text: serde_json::Value =
        serde_json::from_str(include_str!("../reference/critical_speed.json")).unwrap();
    for case in text.as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        let (stack, compatibility) = tracks::named(name);
        let soil = soil(compatibility);
        let track = TrackOnFoundation::new(&stack, &soil, 0.0);
        let list = |key: &str| -> Vec<f64> {
            case[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
        };
        let (mut worst, mut worst_up) = (0.0f64, 0.0f64);
        for ((speed, down), up) in list("speed").iter().zip(list("max_down")).zip(list("max_up")) {
            let response = track.moving(*speed, 61.0).unwrap();
            assert!(response.converged());
            let shape = response.shape(-60.0, 0.05, 1801);
            let got_down = 150e3 * shape.rail.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let got_up = 150e3 * shape.rail.iter().map(|w| -w).fold(f64::NEG_INFINITY, f64::max);
            let (error, error_up) = ((got_down / down - 1.0).abs(), (got_up - up).abs() / down);
            if name == "paper_slab" && *speed == 220.0 {
                // The table is off by a constant 5.9 µm here (0.67 % down, 0.68 % up): see `the_table_errs_at_220`.
                assert!((got_down - down + 5.9e-6).abs() < 0.3e-6 && (got_up - up - 5.9e-6).abs() < 0.3e-6);
                continue;
            }
            worst = worst.max(error);
            worst_up = worst_up.max(error_up);
        }
        println!("{name}: {worst:e} down, {worst_up:e} up");
        // measured 7e-4 and 1.1e-3: the table's own periodic images, largest for slow loads
        assert!(worst < 3e-3, "{name} {worst:e}");
        // upward relative to the largest downward deflection; measured 1.3e-3 and 2.3e-3
        assert!(worst_up < 3e-3, "{name} {worst_up:e}");
    }
}

/// At 220 m/s our value against an integral that shares neither interpolation, nodes nor transform with it.
#[test]
fn the_table_errs_at_220() {
    let (stack, compatibility) = tracks::named("paper_slab");
    let soil = soil(compatibility);
    let speed = 220.0;
    let response = TrackOnFoundation::new(&stack, &soil, 0.0).moving(speed, 61.0).unwrap();
    let mut points = vec![0.0f64, 1e-8];
    while points[points.len() - 1] < 25.0 {
        let last = points[points.len() - 1];
        points.push(last + (2.0 * last).min(0.25));
    }
    let tolerance = Tolerance { relative: 1e-4, absolute: 1e-11, max_count: 4000 };
    for x in [-1.65, -6.3] {
        let f = |beta: f64| {
            let stiffness = soil.stiffness(beta, -beta * speed).unwrap().value;
            stack.respond(beta, -beta * speed, stiffness).rail * Complex64::cis(beta * x)
        };
        let exact = integrate(f, &points, tolerance).value.re / PI;
        let error = 150e3 * (response.rail(x) - exact).abs();
        println!("{x}: {error:e} m");
        // measured below 0.1 µm, against the 5.9 µm in question
        assert!(error < 0.3e-6, "{x}: {error:e}");
    }
}

#[test]
fn peaks() {
    for (name, expected) in [("paper_ballasted", 137.0), ("paper_slab", 170.0)] {
        let (stack, compatibility) = tracks::named(name);
        let soil = soil(compatibility);
        let track = TrackOnFoundation::new(&stack, &soil, 0.0);
        let down = |speed: f64| {
            track
                .moving(speed, 21.0)
                .map(|r| r.shape(-20.0, 0.05, 601).rail.into_iter().fold(f64::NEG_INFINITY, f64::max))
        };
        let bracket = [-6.0, 0.0, 6.0].map(|off| (expected + off, down(expected + off).unwrap()));
        let (speed, _) = groundwave::math::maximum::by_parabolas(down, bracket, 0.05).unwrap();
        println!("{name}: {speed}");
        // measured 137.3 and 170.1 m/s
        assert!((speed - expected).abs() < 1.0, "{name}: {speed}");
    }
}

/// The paper's two speed curves from thin layers and from exact layers.
#[test]
fn thin_layers() {
    let (exact, thin) = (Solver::DirectStiffness, Solver::ThinLayer(ThinLayer::default()));
    for name in ["paper_ballasted", "paper_slab"] {
        let (stack, compatibility) = tracks::named(name);
        let strip = Strip { half_width: 1.25, compatibility };
        let soils = [exact, thin].map(|s| LayeredSoil::new(named("paper_layered"), s, strip).unwrap());
        let mut worst = 0.0f64;
        let mut time = [0.0; 2];
        for i in 0..20 {
            let speed = 10.0 + 10.0 * f64::from(i);
            let mut extremes = [(0.0f64, 0.0f64); 2];
            for (j, soil) in soils.iter().enumerate() {
                let t = std::time::Instant::now();
                let response = TrackOnFoundation::new(&stack, soil, 0.0).moving(speed, 61.0).unwrap();
                time[j] += t.elapsed().as_secs_f64();
                assert!(response.converged());
                let rail = response.shape(-60.0, 0.05, 1801).rail;
                extremes[j] = rail.iter().fold((0.0, 0.0), |(a, b), w| (a.max(*w), b.max(-w)));
            }
            let [(a, a_up), (b, b_up)] = extremes;
            worst = worst.max((b / a - 1.0).abs()).max((b_up - a_up).abs() / a);
        }
        println!("{name}: {worst:e} {time:?}");
        // measured 1.35e-4 and 3.9e-5: the sublayers, and what the interpolation in frequency is allowed
        assert!(worst < 3e-3, "{worst:e}");
    }
}

/// Six materials near their critical speed, where quiet at one wavenumber has hidden 14 % of the deflection: tables, closed form of the
/// rail on its pads, fast transform and phases of a train against a plain integral at every place.
#[test]
fn six_layers_by_plain_integration() {
    let material = |young: f64, poisson, density, eta| {
        Material::new(Elastic::YoungPoisson { young, poisson }, density, eta, eta).unwrap()
    };
    let layers = [
        (1.0, material(25e6, 0.35, 1700.0, 0.06)),
        (1.5, material(45e6, 0.35, 1700.0, 0.06)),
        (2.0, material(90e6, 0.4, 1800.0, 0.05)),
        (3.0, material(70e6, 0.45, 1850.0, 0.05)),
        (4.0, material(180e6, 0.4, 1900.0, 0.04)),
    ];
    let layers = layers.map(|(thickness, material)| Layer { thickness, material });
    let base = Base::HalfSpace(material(500e6, 0.35, 2000.0, 0.04));
    let profile = Profile::new(layers.to_vec(), base).unwrap();
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };
    let soil = LayeredSoil::new(profile, Solver::DirectStiffness, strip).unwrap();
    let stack = tracks::named("paper_ballasted").0;
    let track = TrackOnFoundation::new(&stack, &soil, 0.0);
    let near = track.rail_near(98.0, 100.0, None).unwrap();
    let train = [(0.0, 150e3), (2.31, 120e3), (17.77, 150e3)];
    for speed in [100.0, 137.0] {
        let fresh = track.rail_near(speed, 100.0, None).unwrap();
        let (from, step, count) = (-75.0, 0.1, 1001);
        let shape = fresh.under(train.to_vec()).shape(from, step, count);
        let warm = track.rail_near(speed, 100.0, Some(&near)).unwrap().under(train.to_vec());
        let warm = warm.shape(from, step, count);
        let largest = shape.iter().copied().fold(0.0, f64::max);
        let mut points = vec![0.0f64, 1e-8];
        while points[points.len() - 1] < 40.0 {
            let last = points[points.len() - 1];
            points.push(last + (2.0 * last).min(0.25));
        }
        let known = RefCell::new(HashMap::new());
        let spectrum = |beta: f64| {
            *known.borrow_mut().entry(beta.to_bits()).or_insert_with(|| {
                let stiffness = soil.stiffness_to(beta, -beta * speed, 1e-6).unwrap().value;
                stack.respond(beta, -beta * speed, stiffness).rail
            })
        };
        let tolerance = Tolerance { relative: 1e-7, absolute: 1e-6 * largest, max_count: 20_000 };
        let mut worst = [0.0f64; 2];
        for i in [300usize, 640, 745, 750, 760] {
            let x = from + step * i as f64;
            let phases = |beta: f64| -> Complex64 {
                train.iter().map(|(behind, load)| load * Complex64::cis(beta * (x + behind))).sum()
            };
            let exact = integrate(|beta| spectrum(beta) * phases(beta), &points, tolerance).value.re / PI;
            for (worst, found) in worst.iter_mut().zip([shape[i], warm[i]]) {
                *worst = worst.max((found - exact).abs() / largest);
            }
        }
        println!("{speed}: {worst:?} of the largest deflection, fresh and from a neighbour");
        // measured 6e-6 at both speeds
        assert!(worst[0] < 3e-5 && worst[1] < 3e-5, "{speed}: {worst:?}");
    }
}
