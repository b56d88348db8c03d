//! A rail on equal supports, by its free waves, against 32-digit numbers.

use crate::common::sleepers::{Rock, complexes, named, numbers, reference, three_layers};
use groundwave::rail::Receptance;
use groundwave::rail::periodic::Floquet;
use groundwave::track::Supports;
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::TAU;

/// Largest relative differences over all frequencies and bays: of receptances, of decay rates.
fn worst(supports: &Supports, expected: &Value, frequencies: &[f64], bays: &[f64]) -> (f64, f64) {
    let floquet = Floquet::new(supports, &Rock).unwrap();
    let (mut receptance, mut decay) = (0.0f64, 0.0f64);
    let key =
        if expected.get("decay_dB_per_m").is_some() { "decay_dB_per_m" } else { "decay_floquet_dB_per_m" };
    for (i, rate) in numbers(&expected[key]).into_iter().enumerate() {
        let waves = floquet.waves(TAU * frequencies[i]).unwrap();
        decay = decay.max((waves.decay_rate() / rate - 1.0).abs());
    }
    for (place, from) in [("over_support", 0.0), ("mid_span", 0.5 * supports.spacing)] {
        let columns: Vec<Vec<Complex64>> =
            bays.iter().map(|n| complexes(&expected[place][format!("bays_{n}")])).collect();
        for (i, frequency) in frequencies.iter().enumerate() {
            let x: Vec<f64> = bays.iter().map(|n| from + n * supports.spacing).collect();
            let found = floquet.at(&x, from, TAU * frequency).unwrap();
            for (column, answer) in columns.iter().zip(&found) {
                let error = (answer.value - column[i]).norm() / column[i].norm();
                receptance = receptance.max(error);
            }
        }
    }
    (receptance, decay)
}

#[test]
fn receptances_and_decay_rates_of_the_paper() {
    let file = reference("boef_discrete");
    let (frequencies, bays) = (numbers(&file["inputs"]["frequencies_Hz"]), numbers(&file["inputs"]["bays"]));
    for (name, expected) in file["expected"]["receptance"].as_object().unwrap() {
        let (receptance, decay) = worst(&named(name), expected, &frequencies, &bays);
        println!("{name}: {receptance:.1e}, decay {decay:.1e}");
        assert!(receptance < 1e-9 && decay < 1e-9, "{name}: {receptance:e} {decay:e}");
    }
}

#[test]
fn two_hundred_bays() {
    let file = reference("boef_discrete");
    let list = &file["expected"]["receptance_over_200_bays_from_over_support_2layer_hysteretic"];
    for row in list.as_array().unwrap() {
        let number = |key: &str| row[key].as_f64().unwrap();
        let supports = named(&format!("{}_2layer", row["beam"].as_str().unwrap()));
        let floquet = Floquet::new(&supports, &Rock).unwrap();
        let found = floquet.at(&[120.0], 0.0, TAU * number("frequency_Hz")).unwrap()[0].value;
        let exact = Complex64::new(number("re"), number("im"));
        println!("{:.1e}", (found - exact).norm() / exact.norm());
        assert!((found - exact).norm() < 1e-8 * exact.norm(), "{found} {exact}");
        // 5000 bays: finite, and nothing where nothing is left
        let far = floquet.at(&[3000.0], 0.0, TAU * number("frequency_Hz")).unwrap()[0].value;
        assert!(far.is_finite() && far.norm() < found.norm());
    }
}

#[test]
fn links_between_ballast_masses() {
    let file = reference("boef_shear_link");
    let (frequencies, bays) = (numbers(&file["inputs"]["frequencies_Hz"]), numbers(&file["inputs"]["bays"]));
    for (name, expected) in file["expected"].as_object().unwrap() {
        let beam = name.split('_').next().unwrap();
        let supports = three_layers(beam, name.ends_with("_link") && !name.contains("_no_"));
        let (receptance, decay) = worst(&supports, expected, &frequencies, &bays);
        println!("{name}: {receptance:.1e}, decay {decay:.1e}");
        assert!(receptance < 1e-10 && decay < 1e-10, "{name}: {receptance:e} {decay:e}");
    }
}
