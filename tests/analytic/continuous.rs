//! One rail on continuous supports of one, two and three layers, by every method: receptance, waves, decay.

use groundwave::foundation::{FoundationModel, Springs};
use groundwave::rail::continuous::Departing;
use groundwave::rail::{Method, rail};
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
    (Method::Adaptive, 1e-6),
    (Method::Fourier, 1e-6),
    (Method::Filon, 1e-6),
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
                    *worst = worst.max(error / wanted[i].norm());
                    assert!(error < bound * wanted[i].norm(), "{name} {method:?} {f} Hz: {error:e}");
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
