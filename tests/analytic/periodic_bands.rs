//! Undamped landmarks of a rail on equal supports: cut-ons, antiresonance, pinned–pinned frequencies, pass and stop bands.

use crate::common::sleepers::{Rock, named, numbers, rail, reference};
use groundwave::rail::Receptance;
use groundwave::rail::periodic::{Floquet, Landmark, Undamped, pinned_pinned};
use std::f64::consts::{PI, TAU};

#[test]
fn bands_of_the_paper() {
    let file = reference("boef_discrete");
    for (name, expected) in file["expected"]["undamped_bands"].as_object().unwrap() {
        // the loss is taken out by the one who is asked
        let supports = named(&name.replace("undamped", "hysteretic"));
        let floquet = Floquet::new(&supports, &Rock).unwrap();
        let bands = Undamped::new(&floquet).bands(3000.0).unwrap();
        let waves: Vec<f64> = bands.iter().map(|band| band.waves as f64).collect();
        assert_eq!(waves, numbers(&expected["propagating_waves_between"]), "{name}: {bands:?}");
        let edges = numbers(&expected["edges_Hz"]);
        for (edge, band) in edges.iter().zip(&bands) {
            println!("{name} {edge}: {:.1e}", band.to / edge - 1.0);
            assert!((band.to / edge - 1.0).abs() < 1e-8, "{name}: {} {edge}", band.to);
        }
    }
}

#[test]
fn pinned_pinned_frequencies_are_closed_forms() {
    let expected = &reference("boef_discrete")["expected"]["pinned_pinned_Hz"];
    for beam in ["EB", "T"] {
        let found = pinned_pinned(&rail(beam, 0.1), 0.6, 1).unwrap();
        let exact = expected[beam].as_f64().unwrap();
        // measured 1e-13, the digits of the file
        assert!((found / exact - 1.0).abs() < 1e-12, "{beam}: {found} {exact}");
    }
    let (ei, m, ga, rho_i): (f64, f64, f64, f64) = (6.38e6, 60.23, 0.4 * 5.91e8, 0.239);
    for n in 1..4u32 {
        let q = (f64::from(n) * PI / 0.6).powi(2);
        let eb = q * (ei / m).sqrt() / TAU;
        assert!((pinned_pinned(&rail("EB", 0.0), 0.6, n).unwrap() / eb - 1.0).abs() < 1e-13);
        // a x² − b x + q² = 0, x = ω², its smaller root
        let (a, b) = (rho_i * m / (ei * ga), m / ei + q * m / ga + q * rho_i / ei);
        let x: f64 = 2.0 * q * q / (b + (b * b - 4.0 * a * q * q).sqrt());
        let t = x.sqrt() / TAU;
        assert!((pinned_pinned(&rail("T", 0.0), 0.6, n).unwrap() / t - 1.0).abs() < 1e-13);
    }
}

#[test]
fn landmarks_are_those_of_masses_on_springs() {
    let supports = named("T_2layer_hysteretic");
    let floquet = Floquet::new(&supports, &Rock).unwrap();
    let marks = Undamped::new(&floquet).landmarks(1500.0).unwrap();
    let (kp, kb, m, ms) = (3.5e8f64, 1.8e8, 60.23, 245.0);
    // eigenvalues of [[kp/m, −kp/m], [−kp/ms, (kp + kb)/ms]]
    let (trace, determinant) = (kp / m + (kp + kb) / ms, kp * kb / (m * ms));
    let root = (0.25 * trace * trace - determinant).sqrt();
    let hertz = |square: f64| square.sqrt() / TAU;
    let exact = [
        (Landmark::CutOn, hertz(determinant / (0.5 * trace + root))),
        (Landmark::Antiresonance, hertz((kp + kb) / ms)),
        (Landmark::CutOn, hertz(0.5 * trace + root)),
        (Landmark::PinnedPinned, 1057.2920269634),
    ];
    assert_eq!(marks.len(), 4, "{marks:?}");
    for ((kind, frequency), mark) in exact.iter().zip(&marks) {
        // measured 1e-13; the settled theory prints 120.91 and 432.87 Hz
        assert!(*kind == mark.0 && (mark.1 / frequency - 1.0).abs() < 1e-12, "{mark:?} {frequency}");
    }
}

#[test]
fn dip_and_peak_about_the_pinned_pinned_frequency() {
    let expected = &reference("boef_discrete")["expected"]["extrema_near_pinned_pinned"];
    for (name, row) in expected.as_object().unwrap() {
        let supports = named(name);
        let floquet = Floquet::new(&supports, &Rock).unwrap();
        let at = |x: f64, f: f64| floquet.at(&[x], x, TAU * f).unwrap()[0].value.norm();
        // golden section for the least of `f`
        let least = |f: &dyn Fn(f64) -> f64, mut a: f64, mut b: f64| {
            while b - a > 1e-7 {
                let (p, q) = (b - 0.618034 * (b - a), a + 0.618034 * (b - a));
                if f(p) < f(q) { b = q } else { a = p }
            }
            0.5 * (a + b)
        };
        let dip = least(&|f| at(0.0, f), 1070.0, 1090.0);
        // within the digits of the file
        assert!((dip - row["over_support_dip_Hz"].as_f64().unwrap()).abs() < 1e-3, "{name}: {dip}");
        assert!((at(0.0, dip) / row["over_support_dip_abs"].as_f64().unwrap() - 1.0).abs() < 1e-7);
        let middle = |f| at(0.3, f);
        if let Some(peak) = row["mid_span_peak_Hz"].as_f64() {
            let found = least(&|f| -middle(f), 1050.0, 1065.0);
            assert!((found - peak).abs() < 1e-3, "{found}");
            assert!((middle(found) / row["mid_span_peak_abs"].as_f64().unwrap() - 1.0).abs() < 1e-7);
        } else {
            // no bound: as 1/√|f − f_pp|
            let pinned = pinned_pinned(&supports.rail, 0.6, 1).unwrap();
            let growth = middle(pinned - 1e-7) / middle(pinned - 1e-3);
            assert!((growth / 100.0 - 1.0).abs() < 0.01, "{name}: {growth}");
        }
    }
}
