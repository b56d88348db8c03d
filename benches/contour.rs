//! What does a ground contour cost?

#[path = "../tests/common/mod.rs"]
mod common;

use common::STRIP;
use divan::Bencher;
use groundwave::field::{Quantity, Window};
use groundwave::progress::Silent;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{DirectStiffness, GroundSolver, Solver};
use groundwave::study::Contour;
use groundwave::vehicle::{Axle, Train};

fn main() {
    divan::main();
}

/// Baseline: a million evaluations of G, on one thread.
#[divan::bench(sample_count = 10)]
fn baseline_u_zz_1e6(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1_000_000));
}

/// 1024 × 1024 values 0.25 m apart at 137 m/s, all threads.
#[divan::bench(sample_count = 5)]
fn contour_1024(bencher: Bencher) {
    let support = Support::Ground(Ground::new(
        common::named("paper_layered"),
        Solver::DirectStiffness,
        Some(Contact::Strip(STRIP)),
    ));
    let train = Train::new(vec![Axle { position: 0.0, load: 150e3 }]).unwrap();
    let model = Railway::new(support, common::tracks::ballasted(), Some(train)).unwrap();
    let study = Contour {
        speeds: vec![137.0],
        window: Window { x: (-192.0, 63.75), y: (-128.0, 127.75), spacing: 0.25 },
        quantities: vec![Quantity::Vertical],
        clearance: None,
    };
    bencher.bench(|| study.run(&model, &Silent).unwrap());
}
