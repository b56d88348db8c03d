//! One rail on continuous supports of one, two and three layers, by every method: receptance, waves, decay.

use groundwave::foundation::{FoundationModel, LayeredSoil, Springs};
use groundwave::rail::continuous::Departing;
use groundwave::rail::{Drive, Method, TrackOnFoundation, moving, rail};
use groundwave::soil::{Base, Compatibility, Elastic, Material, Profile, Solver, Strip};
use groundwave::track::{Layout, Link, Member, Stack, Tower};
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::{LN_10, TAU};

pub fn number(table: &Value, key: &str) -> f64 {
    table[key].as_f64().unwrap_or_else(|| panic!("{key}"))
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

fn complex(table: &Value) -> Vec<Complex64> {
    let (re, im) = (numbers(&table["re"]), numbers(&table["im"]));
    re.iter().zip(im).map(|(re, im)| Complex64::new(*re, im)).collect()
}

/// The rail of Table 3, Euler–Bernoulli or Timoshenko, on `layers` layers on rock.
pub fn track(p: &Value, timoshenko: bool, layers: u64, viscous: bool) -> Stack {
    let of = |key: &str| number(p, key);
    let rail = if timoshenko {
        Member::timoshenko(of("EI"), of("m"), of("kappa") * of("GA"), of("rhoI"), 0.0).unwrap()
    } else {
        Member::beam(of("EI"), of("m"), 0.0).unwrap()
    };
    let link = |i: &str| {
        let (k, c, eta) = (of(&format!("k{i}")), of(&format!("c{i}")), of(&format!("eta_{i}")));
        if viscous { Link::spring(k, c, 0.0).unwrap() } else { Link::spring(k, 0.0, eta).unwrap() }
    };
    let mass = |key: &str| Member::mass(of(key)).unwrap();
    match layers {
        1 => Stack::new(vec![rail], vec![link("1")]),
        2 => Stack::new(vec![rail, mass("ms")], vec![link("p"), link("b")]),
        _ => Stack::new(vec![rail, mass("ms"), mass("mb")], vec![link("p"), link("b"), link("f")]),
    }
}

pub fn rock() -> Springs {
    Springs::new(FoundationModel::Rigid).unwrap()
}

/// Each method that knows such tracks, and its error allowed.
pub const METHODS: &[(Method, f64)] = &[
    (Method::ClosedForm, 1e-10),
    (Method::Residues, 1e-10),
    (Method::BoundaryValues, 1e-10),
    (Method::Adaptive, 1e-7),
    (Method::Fourier, 1e-7),
    (Method::Filon, 1e-7),
];

#[test]
fn every_method_gives_the_receptances_of_the_table() {
    let reference: Value = serde_json::from_str(include_str!("../reference/boef_continuous.json")).unwrap();
    let inputs = &reference["inputs"];
    let frequencies = numbers(&inputs["frequencies_Hz"]);
    let rock = rock();
    let mut worst = vec![0.0f64; METHODS.len()];
    for (name, table) in reference["expected"].as_object().unwrap() {
        let Some((beam, rest)) = name.split_once('_').filter(|(beam, _)| ["EB", "T"].contains(beam)) else {
            continue;
        };
        let (layers, damping) = rest.split_once("layer_").unwrap();
        let stack = track(&inputs["parameters"], beam == "T", layers.parse().unwrap(), damping == "viscous");
        let tower = Tower::new(&stack, rock.stack()).unwrap();
        let layout = Layout::Continuous(stack);
        let exact = [complex(&table["receptance_x_0_m"]), complex(&table["receptance_x_3_m"])];
        for ((method, bound), worst) in METHODS.iter().zip(&mut worst) {
            let rail = rail(&layout, &rock, *method).unwrap();
            for (i, f) in frequencies.iter().enumerate() {
                for (answer, wanted) in rail.at(&[0.0, 3.0], 0.0, TAU * f).unwrap().iter().zip(&exact) {
                    let error = (answer.value - wanted[i]).norm();
                    // quadratures promise a part of the receptance at the load
                    let size = if *bound > 1e-9 { exact[0][i].norm() } else { wanted[i].norm() };
                    *worst = worst.max(error / size);
                    assert!(error < bound * size, "{name} {method:?} {f} Hz: {error:e}");
                    // fourteen digits of the file
                    assert!(
                        error <= answer.error + 1e-13 * exact[0][i].norm(),
                        "{name} {method:?} {f} Hz: {error:e} {:e}",
                        answer.error
                    );
                }
            }
        }
        let waves = [complex(&table["gamma_1"]), complex(&table["gamma_2"])];
        for (i, f) in frequencies.iter().enumerate() {
            let found = Departing::new(&tower, TAU * f).unwrap().gamma;
            for gamma in &waves {
                let nearest = found.iter().map(|g| (g - gamma[i]).norm()).fold(f64::INFINITY, f64::min);
                // measured 4e-13
                assert!(nearest < 1e-10 * gamma[i].norm(), "{name} {f} Hz: {found:?} {}", gamma[i]);
            }
            let least = found.iter().map(|g| g.im.abs()).fold(f64::INFINITY, f64::min);
            let decay = numbers(&table["decay_rate_dB_per_m"])[i];
            // measured 2e-12: a difference near a cut-on
            assert!((20.0 / LN_10 * least / decay - 1.0).abs() < 1e-10, "{name} {f} Hz: {least} {decay}");
        }
    }
    println!("receptances of the table by {METHODS:?}: {worst:?}");
}

/// A track on rock asked as one on any foundation: the integrals of moving and harmonic loads against residues.
#[test]
fn tracks_on_rock_are_tracks_on_a_foundation() {
    let reference: Value = serde_json::from_str(include_str!("../reference/boef_continuous.json")).unwrap();
    let stack = track(&reference["inputs"]["parameters"], true, 2, true);
    let (rock, layout) = (rock(), Layout::Continuous(stack.clone()));
    let residues = moving(&layout, &rock, Method::Residues).unwrap();
    let on_rock = TrackOnFoundation::new(&stack, &rock, 0.0);
    let x = [0.0, 0.6, -1.5, 4.0];
    let mut worst = [0.0f64; 2];
    for speed in [0.0, 40.0, 90.0] {
        let constant = on_rock.moving(speed, 5.0).unwrap();
        assert!(constant.converged(), "{speed}");
        let exact = residues.under(Drive { omega: 0.0, speed }, 0.0, &x).unwrap();
        for (x, exact) in x.iter().zip(&exact) {
            worst[0] = worst[0].max((constant.rail(*x) - exact.value).norm() / constant.rail(0.0));
        }
        let omega = TAU * 130.0;
        let harmonic = on_rock.harmonic(omega, speed, 5.0).unwrap();
        // a Timoshenko rail alone falls as β⁻², of which 5e-4 would lie beyond what is integrated
        assert!(harmonic.worst <= 1.0, "{speed}");
        let exact = residues.under(Drive { omega, speed }, 0.0, &x).unwrap();
        for (x, answer) in x.iter().zip(&exact) {
            worst[1] = worst[1].max((harmonic.rail(*x) - answer.value).norm() / exact[0].value.norm());
        }
    }
    println!("tracks on rock, constant {:e}, harmonic {:e}", worst[0], worst[1]);
    // asked for 1e-5 and 1e-4
    assert!(worst[0] < 5e-5 && worst[1] < 5e-4, "{worst:?}");
}

/// Layered ground is known to adaptive panels alone, which say how exact they are.
#[test]
fn layered_ground_is_for_adaptive_panels() {
    let clay =
        Material::new(Elastic::ShearPoisson { shear: 150.0, poisson: 0.4 }, 1900.0, 0.06, 0.06).unwrap();
    let profile = Profile::new(vec![], Base::HalfSpace(clay)).unwrap();
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };
    let soil = LayeredSoil::new(profile, Solver::DirectStiffness, strip).unwrap();
    let beam = Member::beam(1e8, 2000.0, 0.0).unwrap();
    let layout = Layout::Continuous(Stack::new(vec![beam], vec![]));
    for method in
        [Method::Residues, Method::ClosedForm, Method::BoundaryValues, Method::Fourier, Method::Filon]
    {
        let Err(refused) = rail(&layout, &soil, method) else { panic!("{method:?}") };
        let said = refused.to_string();
        assert!(
            said.contains("layered ground") && said.ends_with("adaptive") && said.contains(method.name()),
            "{said}"
        );
    }
    let omega = TAU * 20.0;
    let found = rail(&layout, &soil, Method::Adaptive).unwrap().at(&[1.0, 3.0], 1.0, omega).unwrap();
    let stack = Stack::new(vec![beam], vec![]);
    let direct = TrackOnFoundation::new(&stack, &soil, 0.0).harmonic(omega, 0.0, 2.0).unwrap();
    for (answer, x) in found.iter().zip([0.0, 2.0]) {
        assert!(
            (answer.value - direct.rail(x)).norm() <= answer.error
                && answer.error < 2e-4 * direct.rail(0.0).norm()
        );
    }
}
