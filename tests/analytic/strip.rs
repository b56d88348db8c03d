//! k_eq of a static half-space from power series of K₀: independent of the crate's quadrature and Bessel functions.

use crate::common::soil;
use groundwave::foundation::{Foundation, LayeredSoil};
use groundwave::soil::{Base, Compatibility, DirectStiffness, GroundSolver, Layer, Profile, Solver, Strip};
use std::f64::consts::PI;

const EULER: f64 = 0.577_215_664_901_532_9;

/// (∫₀ˣ K₀ dt, ∫₀ˣ (x − t) K₀ dt) from K₀(t) = Σ (t/2)²ᵏ/(k!)² [H_k − γ − ln(t/2)], term by term; for x ≤ 6.
/// Source: Abramowitz & Stegun 9.6.13.
fn integrals_of_k0(x: f64) -> (f64, f64) {
    let (mut first, mut second) = (0.0, 0.0);
    let (mut term, mut harmonic) = (1.0, 0.0);
    let log = (0.5 * x).ln();
    for k in 0..60 {
        let n = f64::from(k);
        if k > 0 {
            term *= (0.5 * x / n).powi(2);
            harmonic += 1.0 / n;
        }
        let (a, b) = (2.0 * n + 1.0, 2.0 * n + 2.0);
        // ∫₀ˣ t²ᵏ ln(t/2) = x^{2k+1} [ln(x/2)/a − 1/a²]; with (x − t): [ln(x/2)/ab − 1/a² + 1/b²]
        first += term * x * ((harmonic - EULER - log) / a + 1.0 / (a * a));
        second += term * x * x * ((harmonic - EULER - log) / (a * b) + 1.0 / (a * a) - 1.0 / (b * b));
    }
    (first, second)
}

/// 1/k_eq = (1 − ν)/μ · (1/πb)∫₀ᵇ K₀(βx) dx (centre), · (1/2πb²)∫₀²ᵇ (2b − s) K₀(βs) ds (mean). THEORY 3.
#[test]
fn static_half_space() {
    let mut worst = 0.0f64;
    for poisson in [0.0, 0.35, 0.49] {
        let material = soil(75e6, poisson, 1800.0, 0.06);
        let mu = 75e6 / (2.0 * (1.0 + poisson));
        let layers = [1.0, 4.0].map(|thickness| Layer { thickness, material }).to_vec();
        for layers in [vec![], layers] {
            let profile = Profile::new(layers, Base::HalfSpace(material)).unwrap();
            let ground = DirectStiffness.prepare(&profile, 0.0, &[]).unwrap();
            for half_width in [0.3, 1.25, 4.0] {
                for x in [1e-4, 0.01, 0.2, 1.0, 2.5] {
                    let beta = x / half_width;
                    let centre = integrals_of_k0(x).0 / (PI * x);
                    let mean = integrals_of_k0(2.0 * x).1 / (2.0 * PI * x * x);
                    for (compatibility, shape) in
                        [(Compatibility::Centre, centre), (Compatibility::Mean, mean)]
                    {
                        let strip = Strip { half_width, compatibility };
                        let exact = (1.0 - poisson) / mu * shape;
                        let got = ground.strip(beta, strip, 1e-10);
                        assert!(got.converged && got.value.im == 0.0, "{got:?}");
                        worst = worst.max((got.value.re / exact - 1.0).abs());
                    }
                }
            }
        }
    }
    println!("worst {worst:e}");
    // measured 1.2e-11, asked for 1e-10
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn through_the_foundation() {
    let material = soil(75e6, 0.35, 1800.0, 0.06);
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };
    let profile = Profile::new(vec![], Base::HalfSpace(material)).unwrap();
    let foundation = LayeredSoil::new(profile, Solver::DirectStiffness, strip).unwrap();
    let got = foundation.stiffness_to(0.4, 0.0, 1e-9).unwrap();
    let exact = PI * 0.5 * material.shear_modulus() / (0.65 * integrals_of_k0(0.5).0);
    // asked for 1e-9
    assert!(got.converged && (got.value.re / exact - 1.0).abs() < 1e-9, "{got:?} {exact}");
}
