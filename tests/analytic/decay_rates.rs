//! Decay rates from receptances against waves in closed form.

use groundwave::foundation::Springs;
use groundwave::math::complex::I;
use groundwave::rail::decay_rate::{EN_15461, en15461, exact};
use groundwave::rail::{BeamWaves, Method, rail};
use groundwave::track::{Layout, Member, Stack};
use num_complex::Complex64;
use std::f64::consts::TAU;

const K: f64 = 4.5e8;
const ETA: f64 = 0.2;

fn beam() -> Member {
    Member::timoshenko(6.38e6, 60.23, 2.364e8, 0.239, 0.0).unwrap()
}

#[test]
fn the_integral_is_that_of_two_waves() {
    let layout = Layout::Continuous(Stack::new(vec![beam()], vec![]));
    let springs = Springs::winkler(K, 0.0, ETA).unwrap();
    let rail = rail(&layout, &springs, Method::Residues).unwrap();
    let mut worst = 0.0f64;
    for f in [50.0, 400.0, 700.0, 2000.0, 5000.0] {
        let omega = TAU * f;
        let waves = BeamWaves::new(&beam(), omega, Complex64::new(K, ETA * K));
        // ∫₀^∞ |Σ a e^{−iγx}|² dx = Σ a_j ā_k/(i(γ_j − γ̄_k))
        let sum: Complex64 = (0..4)
            .map(|jk| {
                let (j, k) = (jk / 2, jk % 2);
                waves.amplitude[j] * waves.amplitude[k].conj()
                    / (I * (waves.gamma[j] - waves.gamma[k].conj()))
            })
            .sum();
        let known = 10.0 / std::f64::consts::LN_10 * waves.at(0.0).norm_sqr() / sum.re;
        let found = exact(rail.as_ref(), 0.6, 0.3, omega).unwrap();
        worst = worst.max((found / known - 1.0).abs());
    }
    println!("exact: {worst:.1e}");
    // measured 2.7e-12
    assert!(worst < 1e-8, "{worst:e}");
}

#[test]
fn the_grid_of_the_standard_is_a_sum() {
    let layout = Layout::Continuous(Stack::new(vec![beam()], vec![]));
    let springs = Springs::winkler(K, 0.0, ETA).unwrap();
    let rail = rail(&layout, &springs, Method::ClosedForm).unwrap();
    // mid-points to either side: the intervals cover everything from the force to half an interval behind the last point
    let ends: Vec<f64> = EN_15461.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).chain([72.0]).collect();
    for f in [100.0, 1000.0] {
        let waves = BeamWaves::new(&beam(), TAU * f, Complex64::new(K, ETA * K));
        let (mut sum, mut from) = (0.0, 0.0);
        for (bays, to) in EN_15461.iter().zip(&ends) {
            sum += waves.at(0.6 * bays).norm_sqr() * 0.6 * (to - from);
            from = *to;
        }
        let known = 10.0 / std::f64::consts::LN_10 * waves.at(0.0).norm_sqr() / sum;
        let found = en15461(rail.as_ref(), 0.6, 0.3, TAU * f).unwrap();
        // measured 3e-16
        assert!((found / known - 1.0).abs() < 1e-12, "{f}: {found} {known}");
    }
}
