//! Sections of equal supports one after another: published scattering and receptances, conservation, and a witness without waves.

use crate::common::sleepers::{Loss, Rock, SPACING, complexes, layers, numbers, rail, reference};
use groundwave::rail::Receptance;
use groundwave::rail::periodic::{Coupled, Floquet};
use groundwave::track::{Section, Supports};
use num_complex::Complex64;
use std::f64::consts::TAU;

const BALLAST: [f64; 3] = [9e7, 1.8e8, 3.6e8];

/// Soft, ten bays between where there is a zone, stiff.
fn sections(beam: &str, zone: Option<usize>, loss: Loss) -> Vec<Section> {
    let supports = |ballast: f64| layers(rail(beam, 0.0), 2, ballast, loss);
    let end = |ballast| Section { bays: None, supports: supports(ballast) };
    let middle = zone.map(|bays| Section { bays: Some(bays), supports: supports(BALLAST[1]) });
    [Some(end(BALLAST[0])), middle, Some(end(BALLAST[2]))].into_iter().flatten().collect()
}

/// The larger of two differences; no number where one of them is none.
fn larger(worst: f64, d: f64) -> f64 {
    if d > worst || d.is_nan() { d } else { worst }
}

#[test]
fn scattering_and_receptances_of_the_reference() {
    let file = reference("boef_transition");
    let frequencies = numbers(&file["inputs"]["frequencies_Hz"]);
    for (name, zone) in [("EB_abrupt", None), ("EB_zone", Some(10)), ("T_abrupt", None), ("T_zone", Some(10))]
    {
        let expected = &file["expected"][name];
        let sections = sections(name.split('_').next().unwrap(), zone, Loss::Hysteretic);
        let coupled = Coupled::new(&sections, &Rock).unwrap();
        let table = |key: &str| complexes(&expected["scattering"][key]);
        let keys = ["R_AB", "T_AB", "R_BA", "T_BA", "lambda_A", "lambda_B"].map(table);
        let (mut scattering, mut receptance) = (0.0, 0.0);
        for (i, frequency) in frequencies.iter().enumerate() {
            let omega = TAU * frequency;
            let [left, right] = [true, false].map(|left| coupled.scattering(omega, 0, left).unwrap());
            let found = [
                left.reflected[0],
                left.transmitted[0],
                right.reflected[0],
                right.transmitted[0],
                left.lambda,
                right.lambda,
            ];
            for (found, exact) in found.iter().zip(&keys) {
                scattering = larger(scattering, (found - exact[i]).norm());
            }
            for bays in [1, 5, 10] {
                let from = -SPACING * f64::from(bays);
                let end = SPACING * zone.unwrap_or(0) as f64;
                let x = [from, end, end + SPACING, end + 5.0 * SPACING, end + 10.0 * SPACING];
                let answers = coupled.at(&x, from, omega).unwrap();
                let rows = ["at_load", "at_interface", "bays_1_beyond", "bays_5_beyond", "bays_10_beyond"];
                for (answer, row) in answers.iter().zip(rows) {
                    let exact = complexes(&expected["receptance"][format!("load_{bays}")][row])[i];
                    receptance = larger(receptance, (answer.value - exact).norm() / exact.norm());
                }
            }
        }
        println!("{name}: scattering {scattering:.1e}, receptance {receptance:.1e}");
        assert!(scattering < 1e-11 && receptance < 1e-10, "{name}: {scattering:e} {receptance:e}");
    }
}

#[test]
fn power_is_conserved_without_damping() {
    let file = reference("boef_transition");
    for beam in ["EB", "T"] {
        let expected = &file["expected"][format!("{beam}_abrupt_undamped")];
        let sections = sections(beam, None, Loss::None);
        let coupled = Coupled::new(&sections, &Rock).unwrap();
        let (reflected, transmitted) =
            (numbers(&expected["reflected_power"]), numbers(&expected["transmitted_power"]));
        let (mut balance, mut share) = (0.0, 0.0);
        for (i, frequency) in numbers(&expected["frequencies_Hz"]).iter().enumerate() {
            let waves = Floquet::new(&sections[0].supports, &Rock).unwrap().waves(TAU * frequency).unwrap();
            if waves.propagating() == 0 {
                assert!(reflected[i] == 1.0 && transmitted[i] == 0.0 || waves.propagating() > 0);
                continue;
            }
            // the one that travels
            let wave = waves.waves.iter().position(|w| (w.lambda.norm() - 1.0).abs() < 1e-9).unwrap();
            let found = coupled.scattering(TAU * frequency, wave, true).unwrap();
            let [r, t]: [f64; 2] =
                [found.reflected_power, found.transmitted_power].map(|shares| shares.iter().sum());
            balance = larger(balance, (r + t - 1.0).abs());
            share = larger(share, (r - reflected[i]).abs());
            println!("{beam} {frequency}: {r} {t} {} {}", reflected[i], transmitted[i]);
        }
        println!("{beam}: balance {balance:.1e}, shares {share:.1e}");
        assert!(balance < 1e-10 && share < 1e-10, "{beam}: {balance:e} {share:e}");
    }
}

#[test]
fn no_change_lets_everything_pass() {
    for (beam, loss) in [("EB", Loss::Hysteretic), ("T", Loss::Hysteretic), ("T", Loss::None)] {
        let same = |bays| Section { bays, supports: layers(rail(beam, 0.0), 2, 1.8e8, loss) };
        let sections = [same(None), same(Some(7)), same(None)];
        let coupled = Coupled::new(&sections, &Rock).unwrap();
        let floquet = Floquet::new(&sections[0].supports, &Rock).unwrap();
        for frequency in [150.0, 300.0, 700.0, 1060.0, 2000.0] {
            let omega = TAU * frequency;
            let found = coupled.scattering(omega, 0, true).unwrap();
            // measured 4e-14
            let passed = found.lambda.powi(7);
            assert!(found.reflected[0].norm() < 1e-12, "{beam} {frequency}: {}", found.reflected[0]);
            assert!((found.transmitted[0] - passed).norm() < 1e-12, "{beam} {frequency}");
            // a force anywhere: supports in the middle of bays
            let half = 0.5 * SPACING;
            for from in [-3.2, 0.0, 0.1, 1.3, 2.4, 4.2, 5.0] {
                let x = [-9.0, -0.1, 0.2, 2.0, 3.9, 4.3, 20.0];
                let shifted = x.map(|x| x + half);
                let a = coupled.at(&x, from, omega).unwrap();
                let b = floquet.at(&shifted, from + half, omega).unwrap();
                let own = floquet.at(&[from + half], from + half, omega).unwrap()[0].value.norm();
                for (a, b) in a.iter().zip(&b) {
                    assert!((a.value - b.value).norm() < 1e-11 * own, "{beam} {frequency} {from}");
                }
            }
        }
    }
}

#[test]
fn reciprocity_over_a_transition() {
    let sections = sections("T", Some(10), Loss::Hysteretic);
    let coupled = Coupled::new(&sections, &Rock).unwrap();
    let places = [-2.3, -0.3, 0.0, 1.7, 5.9, 6.0, 8.2];
    for frequency in [40.0, 160.0, 440.0, 1060.0, 2500.0] {
        for a in places {
            for b in places {
                let one = coupled.at(&[a], b, TAU * frequency).unwrap()[0].value;
                let other = coupled.at(&[b], a, TAU * frequency).unwrap()[0].value;
                let own = coupled.at(&[a], a, TAU * frequency).unwrap()[0].value;
                // measured 1e-14 of the field at the force
                assert!((one - other).norm() < 1e-12 * own.norm(), "{a} {b} {frequency}: {one} {other}");
                assert!(own.im < 0.0);
            }
        }
    }
}

/// The witness: supports as springs between points of the rail, half-infinite chains by doubling, no waves of bays.
mod chain {
    use super::*;
    use groundwave::rail::BeamWaves;
    use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};

    type M2 = Matrix2<Complex64>;

    /// Stiffness of half a bay of bare rail between (w, φ) at its ends, as four blocks.
    fn half(supports: &Supports, omega: f64) -> [M2; 4] {
        let length = 0.5 * supports.spacing;
        let [a, b] = BeamWaves::new(&supports.rail, omega, Complex64::ZERO).gamma;
        let state = |x: f64| {
            Matrix4::from_columns(&[a, b, -a, -b].map(|beta| {
                let [rotation, force, moment] = supports.rail.carried(beta, omega);
                let turn = (Complex64::new(0.0, 1.0) * beta * x).exp();
                Vector4::new(turn, rotation * turn, force * turn, moment * turn)
            }))
        };
        // deformations from the upper two rows at both ends, actions on the rail there from the lower ones
        let (start, end) = (state(0.0), state(length));
        let mut deformed = Matrix4::zeros();
        let mut acted = Matrix4::zeros();
        for column in 0..4 {
            for row in 0..2 {
                deformed[(row, column)] = start[(row, column)];
                deformed[(2 + row, column)] = end[(row, column)];
                acted[(row, column)] = start[(2 + row, column)];
                acted[(2 + row, column)] = -end[(2 + row, column)];
            }
        }
        let k = acted * deformed.try_inverse().unwrap();
        [(0, 0), (0, 2), (2, 0), (2, 2)].map(|(r, c)| k.fixed_view::<2, 2>(r, c).into())
    }

    /// Two pieces of track in a row as one: a, b, c, d the blocks of each.
    fn joined([a, b, c, d]: [M2; 4], [e, f, g, h]: [M2; 4]) -> [M2; 4] {
        let inner = (d + e).try_inverse().unwrap();
        [a - b * inner * c, -b * inner * f, -g * inner * c, h - g * inner * f]
    }

    /// One cell: half a bay, a support, half a bay.
    fn cell(supports: &Supports, omega: f64) -> [M2; 4] {
        let [a, b, c, mut d] = half(supports, omega);
        let second = [a, b, c, d];
        d[(0, 0)] += supports.stiffness(Complex64::ONE, omega, f64::INFINITY.into());
        joined([a, b, c, d], second)
    }

    /// The dynamic stiffness of endless cells to the right, and to the left, by doubling.
    fn endless(supports: &Supports, omega: f64) -> [M2; 2] {
        let mut chain = cell(supports, omega);
        for _ in 0..40 {
            chain = joined(chain, chain);
        }
        [chain[0], chain[3]]
    }

    #[test]
    fn doubled_chains_are_the_waves() {
        for zone in [None, Some(10)] {
            let sections = sections("T", zone, Loss::Hysteretic);
            let coupled = Coupled::new(&sections, &Rock).unwrap();
            for frequency in [50.0, 110.0, 440.0, 1060.0, 2000.0] {
                let omega = TAU * frequency;
                let soft = endless(&sections[0].supports, omega);
                let stiff = endless(&sections[sections.len() - 1].supports, omega);
                // the field at the end of the soft side, of a force there
                let mut right = stiff[0];
                for _ in 0..zone.unwrap_or(0) {
                    let [a, b, c, d] = cell(&sections[1].supports, omega);
                    right = a - b * (d + right).try_inverse().unwrap() * c;
                }
                let force = Vector2::new(Complex64::ONE, Complex64::ZERO);
                let exact = ((soft[1] + right).try_inverse().unwrap() * force)[0];
                let found = coupled.at(&[0.0], 0.0, omega).unwrap()[0].value;
                println!("{:.1e}", (found - exact).norm() / exact.norm());
                // measured 2e-11; the stiffnesses of half bays lose digits where waves are long
                assert!((found - exact).norm() < 1e-9 * exact.norm(), "{frequency}: {found} {exact}");
            }
        }
    }
}

/// Springs of the foundation that lose are a loss too: shares of power are numbers, and add up to one at rest from a change of nothing.
#[test]
fn springs_that_lose_have_shares() {
    let text = r#"
title = "no change"
[foundation]
kind = "winkler"
stiffness = 1.8e8
loss_factor = 0.01
[track]
kind = "beam"
beam = { bending_stiffness = 6.4e6, mass = 60.0 }
support.spacing = 0.6
section = [{}, {}]
[transition]
frequencies = [400.0]
"#;
    let case = groundwave::Case::parse(text, "case.toml", &|_| Err(String::new())).unwrap();
    let group = case.studies[0].run(&case.railway, &groundwave::Silent).unwrap().group;
    let of = |name: &str| group.get(name).unwrap().to_vec()[0];
    // measured 1e-15 and 1e-16
    assert!((of("transmitted") - 1.0).abs() < 1e-9 && of("reflected").abs() < 1e-9);
}
