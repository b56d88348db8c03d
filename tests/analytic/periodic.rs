//! A rail on equal supports, by its free waves, against 32-digit numbers.

use crate::common::sleepers::{Rock, SPACING, complexes, named, numbers, rail, reference, three_layers};
use groundwave::rail::decay_rate::{EN_15461, en15461};
use groundwave::rail::periodic::Floquet;
use groundwave::rail::{Answer, BeamWaves, Receptance};
use groundwave::track::{Link, Member, Stack, Supports};
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

#[test]
fn decay_rates_as_measured() {
    let file = reference("boef_discrete");
    let frequencies = numbers(&file["inputs"]["frequencies_Hz"]);
    assert_eq!(numbers(&file["inputs"]["en15461"]["grid_bays"]), EN_15461);
    let mut worst = 0.0f64;
    for (name, expected) in file["expected"]["receptance"].as_object().unwrap() {
        let supports = named(name);
        let floquet = Floquet::new(&supports, &Rock).unwrap();
        for (key, from) in [("mid_span", 0.5 * SPACING), ("over_support", 0.0)] {
            let rates = numbers(&expected[format!("decay_en15461_{key}_dB_per_m")]);
            for (frequency, rate) in frequencies.iter().zip(rates) {
                // the file has the standard's 4.343 for 10/ln 10
                let rounded = 4.343 * 0.1 * 10f64.ln();
                let found = rounded * en15461(&floquet, SPACING, from, TAU * frequency).unwrap();
                let error = (found / rate - 1.0).abs();
                // measured 6e-13
                assert!(error < 1e-9, "{name} {key} {frequency}: {found} {rate}");
                worst = worst.max(error);
            }
        }
    }
    println!("{worst:.1e}");
}

#[test]
fn supports_that_vanish_or_never_yield_are_no_singularities() {
    let supports = named("T_2layer_undamped");
    let floquet = Floquet::new(&supports, &Rock).unwrap();
    let at = |omega: f64| floquet.at(&[0.2, 0.5, 1.9], 0.2, omega).unwrap().map_values();
    // D = ∞ at √((k_p + k_b)/m_s)
    let still = (5.3e8f64 / 245.0).sqrt();
    // D = 0 at √(k_b/m_s): the bare rail
    let free = (1.8e8f64 / 245.0).sqrt();
    for omega in [still, free] {
        let [here, beside] = [at(omega), at(omega * (1.0 + 1e-9))];
        let own = here[0].norm();
        for (a, b) in here.iter().zip(&beside) {
            // measured 3e-8 beside a pole; where D = 0 the field is that of the bare rail
            assert!((a - b).norm() < 1e-5 * own, "{omega}: {a} {b}");
        }
    }
    let bare = BeamWaves::new(&supports.rail, free, Complex64::ZERO);
    for (u, x) in at(free).iter().zip([0.0, 0.3, 1.7]) {
        // what the rounding of ω² leaves of D, 1e-16 of the pads, over the rail
        assert!((u - bare.at(x)).norm() < 1e-10 * bare.at(0.0).norm(), "{x}: {u} {}", bare.at(x));
    }
}

#[test]
fn weak_supports_hardly_damp_the_bare_rail() {
    // first order in D: θ = γL − D/(4EIγ³), so that Δ = (20/ln 10) Im D/(4EIγ³L)
    let (ei, m, omega): (f64, f64, f64) = (6.38e6, 60.23, TAU * 1500.0);
    let stiffness = Link::spring(10.0, 0.0, 0.3).unwrap();
    let under = Stack::new(vec![Member::mass(0.0).unwrap()], vec![stiffness]);
    let supports = Supports { rail: rail("EB", 0.0), spacing: SPACING, under, width: None };
    let floquet = Floquet::new(&supports, &Rock).unwrap();
    let gamma = (m * omega * omega / ei).powf(0.25);
    let exact = 20.0 / 10f64.ln() * 3.0 / (4.0 * ei * gamma.powi(3) * SPACING);
    let found = floquet.waves(omega).unwrap().decay_rate();
    // 7e-9 dB/m: |λ| is 1 to 1e-9, of which rounding leaves six digits
    assert!((found / exact - 1.0).abs() < 1e-5, "{found:e} {exact:e}");
}

/// Values alone.
trait Values {
    fn map_values(&self) -> Vec<Complex64>;
}

impl Values for Vec<Answer> {
    fn map_values(&self) -> Vec<Complex64> {
        self.iter().map(|answer| answer.value).collect()
    }
}
