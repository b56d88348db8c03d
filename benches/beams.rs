//! What does a rail on equal supports cost, standing force and moving?

#[path = "../tests/common/mod.rs"]
mod common;

use common::sleepers::{Loss, Rock, layers, rail};
use divan::{Bencher, black_box};
use groundwave::rail::periodic::{DiracComb, Floquet};
use groundwave::rail::{Drive, Receptance};
use std::f64::consts::TAU;

fn main() {
    divan::main();
}

/// The discrete two-layer Timoshenko track.
#[divan::bench]
fn receptance_and_decay_400(bencher: Bencher) {
    let supports = layers(rail("T", 0.0), 2, 1.8e8, Loss::Hysteretic);
    let floquet = Floquet::new(&supports, &Rock).unwrap();
    bencher.bench(|| {
        let at = |i: i32| {
            let omega = TAU * black_box(20.0 * 1.0126f64.powi(i));
            let receptance = floquet.at(&[0.3], 0.3, omega).unwrap()[0].value;
            receptance.norm() * floquet.waves(omega).unwrap().decay_rate()
        };
        (0..400).map(at).sum::<f64>()
    });
}

/// A constant load at 40 m/s over sleepers, 1 000 samples between two metres before and behind the place.
#[divan::bench(args = ["EB", "T"])]
fn history_of_1000(bencher: Bencher, beam: &str) {
    let supports = layers(rail(beam, 0.0), 1, 1.8e8, Loss::Viscous);
    let comb = DiracComb::new(&supports, &Rock).unwrap();
    let drive = Drive { omega: 0.0, speed: 40.0 };
    bencher.bench(|| comb.passage(black_box(drive), 0.0, 4.0).unwrap().history(-0.1, 2e-4, 1000));
}
