//! What does one equivalent stiffness cost, in evaluations of G?

#[path = "../tests/common/mod.rs"]
mod common;

use common::STRIP;
use divan::{Bencher, black_box};
use groundwave::soil::{DirectStiffness, GroundSolver};

fn main() {
    divan::main();
}

/// Baseline: a thousand evaluations of G.
#[divan::bench]
fn baseline_u_zz_1000(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1000));
}

/// β = 1 rad/m at 137 m/s.
#[divan::bench(args = [1e-4, 1e-6, 1e-9])]
fn k_eq(bencher: Bencher, relative: f64) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| ground.strip(black_box(1.0), STRIP, relative));
}

/// The same with η = 0.001.
#[divan::bench]
fn k_eq_lightly_damped(bencher: Bencher) {
    let profile = common::profile(&[(2.0, 60e6, 0.35, 1500.0, 0.001)], (200e6, 0.35, 1800.0, 0.001));
    let ground = DirectStiffness.prepare(&profile, 137.0, &[]).unwrap();
    bencher.bench(|| ground.strip(black_box(1.0), STRIP, 1e-6));
}
