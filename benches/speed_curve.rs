//! What does the paper's speed curve cost?

#[path = "../tests/common/mod.rs"]
mod common;

use common::STRIP;
use divan::Bencher;
use groundwave::progress::Silent;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{DirectStiffness, GroundSolver, Solver, ThinLayer};
use groundwave::study::CriticalSpeed;
use groundwave::vehicle::{Axle, Train};

fn main() {
    divan::main();
}

fn model(axles: usize, solver: Solver) -> Railway {
    let support =
        Support::Ground(Ground::new(common::named("paper_layered"), solver, Some(Contact::Strip(STRIP))));
    let axles = (0..axles).map(|i| Axle { position: 2.9 * i as f64, load: 150e3 }).collect();
    Railway::new(support, common::tracks::ballasted(), Some(Train::new(axles).unwrap())).unwrap()
}

/// Baseline: a million evaluations of G, on one thread.
#[divan::bench(sample_count = 10)]
fn baseline_u_zz_1e6(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1_000_000));
}

/// 100 speeds from 10 to 208 m/s with static limit and refined maximum, all threads.
#[divan::bench(args = [1, 20], sample_count = 5)]
fn hundred_speeds(bencher: Bencher, axles: usize) {
    let model = model(axles, Solver::DirectStiffness);
    let study = CriticalSpeed {
        speeds: (0..100).map(|i| 10.0 + 2.0 * f64::from(i)).collect(),
        ..CriticalSpeed::default()
    };
    bencher.bench(|| study.run(&model, &Silent).unwrap());
}

/// The same for one axle with modes of thin layers instead of quadrature.
#[divan::bench(sample_count = 5)]
fn hundred_speeds_from_modes(bencher: Bencher) {
    let study = CriticalSpeed {
        speeds: (0..100).map(|i| 10.0 + 2.0 * f64::from(i)).collect(),
        ..CriticalSpeed::default()
    };
    // a new model each time: modes are kept
    bencher
        .with_inputs(|| model(1, Solver::ThinLayer(ThinLayer::default())))
        .bench_refs(|model| study.run(model, &Silent).unwrap());
}
