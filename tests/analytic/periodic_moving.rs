//! Loads that move over equal supports, by images in the wavenumber, against published quadratures and finite elements in time.

use crate::common::sleepers::{Loss, Rock, SPACING, complexes, layers, numbers, rail, reference};
use groundwave::rail::periodic::DiracComb;
use groundwave::rail::{Answer, Drive, Moving};
use groundwave::track::{Link, Member, Stack, Supports};
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::TAU;

fn track(row: &Value) -> Supports {
    let beam = row["beam"].as_str().unwrap();
    layers(rail(beam, 0.0), row["layers"].as_u64().unwrap() as usize, 1.8e8, Loss::Viscous)
}

fn drive(row: &Value) -> Drive {
    let frequency = row.get("load_frequency_Hz").map_or(0.0, |f| f.as_f64().unwrap());
    Drive { omega: TAU * frequency, speed: row["speed"].as_f64().unwrap() }
}

/// The largest difference; no number where one of them is none.
fn apart(found: &[Answer], expected: &[Complex64]) -> f64 {
    let differences = found.iter().zip(expected).map(|(a, b)| (a.value - b).norm());
    differences.fold(0.0, |worst, d| if d > worst || d.is_nan() { d } else { worst })
}

#[test]
fn histories_of_constant_loads() {
    let file = reference("boef_moving_load");
    let places = numbers(&file["inputs"]["x_prime_m"]);
    for row in file["expected"]["constant_load"].as_array().unwrap() {
        let (supports, drive) = (track(row), drive(row));
        let comb = DiracComb::new(&supports, &Rock).unwrap();
        for (key, x) in [("over_support", 0.0), ("mid_span", 0.5 * SPACING)] {
            let expected = numbers(&row[key]);
            let largest = expected.iter().fold(0.0f64, |largest, u| largest.max(u.abs()));
            let passage = comb.passage(drive, x, 4.0).unwrap();
            let mut worst = 0.0f64;
            // x′ = x − vt, ascending: t descending
            let step = 0.25 / drive.speed;
            let history = passage.history((x - 4.0) / drive.speed, step, places.len());
            for ((place, u), sample) in places.iter().zip(&expected).zip(history.iter().rev()) {
                let found = passage.at((x - place) / drive.speed).re;
                let error = (found - u).abs().max((found - sample).abs());
                assert!(error < 1e-8 * largest && error <= f64::MAX, "{place}: {error:e}");
                worst = worst.max(error);
            }
            println!(
                "{} {} {key}: {:.1e}, said {:.1e}",
                row["layers"],
                row["speed"],
                worst / largest,
                passage.error / largest
            );
            assert!(worst < 1e-8 * largest && passage.error < 1e-8 * largest, "{worst:e}");
        }
    }
}

#[test]
fn harmonics_under_the_load() {
    let file = reference("boef_moving_load");
    for row in file["expected"]["constant_load"].as_array().unwrap() {
        let supports = track(row);
        let comb = DiracComb::new(&supports, &Rock).unwrap();
        let expected = complexes(&row["harmonics_at_load"]);
        let found = comb.harmonics(drive(row), &[0, 1, 2, 3, 4, 5]).unwrap();
        let worst = apart(&found, &expected);
        println!("{} {}: {:.1e}", row["layers"], row["speed"], worst / expected[0].norm());
        assert!(worst < 1e-8 * expected[0].norm(), "{worst:e}");
    }
    for row in file["expected"]["harmonic_load"].as_array().unwrap() {
        let supports = track(row);
        let comb = DiracComb::new(&supports, &Rock).unwrap();
        let orders: Vec<i32> = numbers(&row["j"]).iter().map(|j| *j as i32).collect();
        let expected: Vec<Complex64> = numbers(&row["W_re"])
            .iter()
            .zip(numbers(&row["W_im"]))
            .map(|(re, im)| Complex64::new(*re, im))
            .collect();
        let found = comb.harmonics(drive(row), &orders).unwrap();
        let mean = expected[5].norm();
        let worst = apart(&found, &expected);
        println!("{} {} {}: {:.1e}", row["beam"], row["layers"], row["load_frequency_Hz"], worst / mean);
        assert!(worst < 1e-8 * mean, "{worst:e}");
        // what is seen from the load at a moment is their sum
        let under = comb.under(drive(row), 0.2, &[0.0]).unwrap()[0].value;
        let sum: Complex64 = orders
            .iter()
            .zip(&found)
            .map(|(j, w)| w.value * Complex64::cis(TAU * f64::from(*j) * 0.2 / SPACING))
            .sum();
        println!("   sum {:.1e}", (under - sum).norm() / mean);
        assert!((under - sum).norm() < 2e-3 * mean, "{under} {sum}");
    }
}

#[test]
fn spectra_beside_the_track() {
    let file = reference("boef_moving_load");
    // whole track: rail and pads doubled
    let under = Stack::new(
        vec![Member::mass(0.0).unwrap()],
        vec![Link::spring(SPACING * 7e8, SPACING * 3.84e4, 0.0).unwrap()],
    );
    let supports =
        Supports { rail: Member::beam(1.276e7, 120.46, 0.0).unwrap(), spacing: SPACING, under, width: None };
    let comb = DiracComb::new(&supports, &Rock).unwrap();
    for row in file["expected"]["spectra_at_x0_like_Fig27"].as_array().unwrap() {
        let load = row["load_N"].as_f64().unwrap();
        for (frequency, expected) in numbers(&row["frequencies_Hz"]).iter().zip(complexes(&row["discrete"])) {
            let found = load * comb.spectrum(drive(row), 0.0, TAU * frequency).unwrap();
            let error = (found - expected).norm() / expected.norm();
            assert!(error < 1e-8, "{frequency}: {error:e}");
        }
    }
}
