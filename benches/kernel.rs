//! What does one compliance G(k, ω) cost?

#[path = "../tests/common/mod.rs"]
mod common;

use divan::{Bencher, black_box};
use groundwave::math::complex::sqrt_decaying;
use groundwave::soil::wave_amplitudes::WaveAmplitudes;
use groundwave::soil::{DirectStiffness, GroundSolver, Solver, half_space};
use num_complex::Complex64;

fn main() {
    divan::main();
}

/// One k after another, as a quadrature asks.
fn wavenumbers() -> Vec<f64> {
    (0..1000).map(|i| 0.05 * 1.006f64.powi(i)).collect()
}

#[divan::bench(args = ["paper_half_space", "paper_layered", "mezher2016_profile3"])]
fn u_zz_1000(bencher: Bencher, name: &str) {
    let ground = DirectStiffness.prepare(&common::named(name), 100.0, &[]).unwrap();
    let k = wavenumbers();
    bencher.bench(|| k.iter().map(|&k| ground.u_zz(black_box(k))).sum::<Complex64>());
}

#[divan::bench]
fn all_components_1000(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 100.0, &[]).unwrap();
    let k = wavenumbers();
    bencher.bench(|| ground.batch(black_box(&k)));
}

/// Wavenumbers as an integral asks for them, all at once.
#[divan::bench(args = ["paper_half_space", "paper_layered", "mezher2016_profile3"])]
fn u_zz_many_1000(bencher: Bencher, name: &str) {
    let ground = DirectStiffness.prepare(&common::named(name), 100.0, &[]).unwrap();
    let k = wavenumbers();
    bencher.bench(|| ground.u_zz_many(black_box(&k)));
}

/// Calibration: a thousand complex roots. G of n layers on a half-space takes 2(n + 1) of them and 2n exponentials: no kernel is
/// faster than that.
#[divan::bench]
fn calibration_root_1000(bencher: Bencher) {
    let z = arguments();
    bencher.bench(|| black_box(&z).iter().map(|z| sqrt_decaying(*z)).sum::<Complex64>());
}

/// Calibration: a thousand complex exponentials.
#[divan::bench]
fn calibration_exponential_1000(bencher: Bencher) {
    let z = arguments();
    bencher.bench(|| black_box(&z).iter().map(|z| (-z).exp()).sum::<Complex64>());
}

/// k² − k_s² of damped ground.
fn arguments() -> Vec<Complex64> {
    wavenumbers().iter().map(|k| Complex64::new(k * k - 1.0, 0.06)).collect()
}

/// Baseline: the closed form of the half-space.
#[divan::bench]
fn baseline_half_space_closed_form_1000(bencher: Bencher) {
    let profile = common::named("paper_half_space");
    let k = wavenumbers();
    bencher.bench(|| {
        k.iter()
            .map(|&k| half_space::surface_compliance(profile.top(), black_box(k), 100.0).u_zz)
            .sum::<Complex64>()
    });
}

/// Baseline: the dense system of wave amplitudes.
#[divan::bench]
fn baseline_wave_amplitudes_1000(bencher: Bencher) {
    let ground = WaveAmplitudes.prepare(&common::named("paper_layered"), 100.0, &[]).unwrap();
    let k = wavenumbers();
    bencher.bench(|| k.iter().map(|&k| ground.surface(black_box(k)).u_zz).sum::<Complex64>());
}

/// The other exact solvers, two layers.
#[divan::bench(args = [Solver::TransferMatrix, Solver::Flexibility])]
fn u_zz_1000_by(bencher: Bencher, solver: &Solver) {
    let ground = solver.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1000));
}
