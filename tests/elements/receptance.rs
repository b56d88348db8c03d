//! At one frequency: orders of convergence of the endless track, exact bays as the witness.

use crate::common::sleepers::{self, Loss, SPACING, numbers, reference};
use groundwave::foundation::{FoundationModel, Springs};
use groundwave::rail::Receptance;
use groundwave::rail::fem::FiniteElements;
use groundwave::rail::periodic::{Coupled, Floquet};
use groundwave::track::{Layout, Link, Member, Section, Stack};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Two layers of Table 3 with viscous loss, per metre.
fn continuous(beam: &str) -> Stack {
    let springs = [(3.5e8, 1.92e4), (1.8e8, 2.34e5)].map(|(k, c)| Link::spring(k, c, 0.0).unwrap());
    Stack::new(vec![sleepers::rail(beam, 0.0), Member::mass(245.0).unwrap()], springs.to_vec())
}

fn rock() -> Springs {
    Springs::new(FoundationModel::Rigid).unwrap()
}

#[test]
fn errors_and_orders_of_the_reference() {
    let rock = rock();
    let file = reference("track_fe_receptance");
    for row in file["expected"].as_array().unwrap() {
        let beam = row["beam"].as_str().unwrap();
        let layout = match row["support"].as_str().unwrap() {
            "continuous" => Layout::Continuous(continuous(beam)),
            _ => Layout::Discrete(sleepers::layers(sleepers::rail(beam, 0.0), 2, 1.8e8, Loss::Viscous)),
        };
        let from = if row["load_at"] == "midspan" { 0.5 * SPACING } else { 0.0 };
        let omega = TAU * row["frequency"].as_f64().unwrap();
        let exact = numbers(&row["exact"]);
        let exact = Complex64::new(exact[0], exact[1]);
        let errors = [2, 4, 8, 16].map(|per_bay| {
            let elements = FiniteElements::new(&layout, &rock, per_bay).unwrap();
            let answer = elements.at(&[from], from, omega).unwrap()[0];
            let error = (answer.value - exact).norm();
            // its own estimate is on the safe side, from the second on
            assert!(
                per_bay == 2 || error < answer.error + 1e-8 * exact.norm(),
                "{row} {per_bay}: {error} {answer:?}"
            );
            error / exact.norm()
        });
        for (error, listed) in errors.iter().zip(numbers(&row["relative_error"])) {
            // the tolerance of the reference: 20 % of the error it lists, and its own rounding of 1e-8
            assert!((error - listed).abs() < 0.2 * listed + 1e-8, "{row}: {errors:?}");
        }
        let orders: Vec<f64> = errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect();
        for (i, (order, listed)) in orders.iter().zip(numbers(&row["order"])).enumerate() {
            assert!((order - listed).abs() < 0.15 || errors[i + 1] < 1e-7, "{row}: {orders:?}");
        }
    }
}

#[test]
fn layouts_agree_with_exact_bays() {
    let rock = rock();
    let x = [-1.2, 0.0, 0.3, 0.6, 3.0];
    let viscous = |ballast| sleepers::layers(sleepers::rail("EB", 0.0), 2, ballast, Loss::Viscous);
    let ends = [9e7, 3.6e8].map(|ballast| Section { bays: None, supports: viscous(ballast) });
    let zone = Section { bays: Some(4), supports: viscous(1.8e8) };
    let varying = Layout::Varying(vec![ends[0].clone(), zone, ends[1].clone()]);
    // hysteretic springs, and masses of ballast that are joined
    let linked = Layout::Discrete(sleepers::three_layers("EB", true));
    // measured 3.1e-6 and 3.2e-6, at 900 Hz: h⁴
    for (layout, bound) in [(&varying, 1e-5), (&linked, 1e-5)] {
        let exact: Box<dyn Receptance> = match layout {
            Layout::Varying(sections) => Box::new(Coupled::new(sections, &rock).unwrap()),
            Layout::Discrete(supports) => Box::new(Floquet::new(supports, &rock).unwrap()),
            Layout::Continuous(_) => unreachable!(),
        };
        for frequency in [20.0, 200.0, 900.0] {
            let omega = TAU * frequency;
            let found = FiniteElements::new(layout, &rock, 16).unwrap().at(&x, 0.0, omega).unwrap();
            let exact = exact.at(&x, 0.0, omega).unwrap();
            for (found, exact) in found.iter().zip(&exact) {
                let error = (found.value - exact.value).norm() / exact.value.norm();
                println!("{frequency} {error}");
                assert!(error < bound, "{frequency} Hz: {error}");
            }
        }
    }
}
