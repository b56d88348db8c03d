//! What do thin layers cost: one eigenproblem, and what its modes answer, in evaluations of G?

#[path = "../tests/common/mod.rs"]
mod common;

use common::STRIP;
use divan::{Bencher, black_box};
use groundwave::soil::{DirectStiffness, GroundSolver, ThinLayer};

fn main() {
    divan::main();
}

/// Baseline: a thousand evaluations of G.
#[divan::bench]
fn baseline_u_zz_1000(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1000));
}

/// The in-plane eigenproblem of the paper's soil at 0.2 rad/s to 1e-6 (200 unknowns) and as a speed curve asks (1e-4).
#[divan::bench(args = [1e-6, 1e-4])]
fn modes(bencher: Bencher, accuracy: f64) {
    let solver = ThinLayer::default().resolving((0.0, 240.0), accuracy);
    let profile = common::named("paper_layered");
    bencher.bench(|| {
        let ground = solver.prepare(&profile, black_box(1.7), &[]).unwrap();
        // modes are found when first asked for
        ground.strip(0.2, STRIP, 1e-6).count
    });
}

/// k_eq from modes that are there.
#[divan::bench]
fn k_eq_from_modes(bencher: Bencher) {
    let ground = ThinLayer::default()
        .resolving((0.0, 240.0), 1e-6)
        .prepare(&common::named("paper_layered"), 1.7, &[])
        .unwrap();
    println!("{} modes", ground.strip(0.2, STRIP, 1e-6).count);
    bencher.bench(|| ground.strip(black_box(0.2), STRIP, 1e-6));
}
