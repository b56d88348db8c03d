//! What do the dispersion curves of a ground cost?

#[path = "../tests/common/mod.rs"]
mod common;

use divan::{Bencher, black_box};
use groundwave::soil::dispersion::{SurfaceWave, modes};
use groundwave::soil::{DirectStiffness, GroundSolver};
use std::f64::consts::TAU;

fn main() {
    divan::main();
}

/// Three modes at 200 frequencies up to 100 Hz, of damped and of undamped ground.
#[divan::bench(args = [1.0, 0.0], consts = [false, true])]
fn modes_200<const LOVE: bool>(bencher: Bencher, loss: f64) {
    let profile = common::named("paper_layered").with_loss_times(loss);
    let wave = if LOVE { SurfaceWave::Love } else { SurfaceWave::Rayleigh };
    bencher.bench(|| {
        let curves = (1..=200).map(|i| modes(&profile, wave, TAU * 0.5 * f64::from(i), 3));
        curves.map(|m| black_box(m).count).sum::<usize>()
    });
}

/// Baseline: 1000 compliances.
#[divan::bench]
fn baseline_u_zz_1000(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 100.0, &[]).unwrap();
    bencher.bench(|| {
        (0..1000).map(|i| ground.u_zz(0.05 * 1.006f64.powi(black_box(i)))).sum::<num_complex::Complex64>()
    });
}
