//! k = 0: columns of soil, shaken sideways and up and down.

use crate::common::soil;
use groundwave::soil::{Base, DirectStiffness, GroundSolver, Layer, Profile};
use num_complex::Complex64;
use std::f64::consts::PI;

/// On rock G_yy = tan(k_s h)/(μ k_s) and G_zz = tan(k_p h)/((λ + 2μ) k_p), at and between resonances and when cut in three.
#[test]
fn layer_on_rock() {
    let (h, eta) = (6.0, 0.04);
    let material = soil(60e6, 0.35, 1700.0, eta);
    let loss = Complex64::new(1.0, eta);
    let cut = |fractions: &[f64]| {
        let layers = fractions.iter().map(|f| Layer { thickness: f * h, material }).collect();
        Profile::new(layers, Base::Rigid).unwrap()
    };
    let mut worst = 0.0f64;
    for profile in [cut(&[1.0]), cut(&[0.2, 0.5, 0.3])] {
        for ratio in [1e-3, 0.5, 1.0, 2.0, 3.0, 7.0] {
            // ratio 1, 3, 7: resonances of the SH column
            let omega = ratio * PI * material.c_s() / (2.0 * h);
            let got = DirectStiffness.prepare(&profile, omega, &[]).unwrap().surface(0.0);
            let column = |c: f64| {
                let wavenumber = omega / (c * loss.sqrt());
                (wavenumber * h).tan() / (material.density() * c * c * loss * wavenumber)
            };
            let (u_yy, u_zz) = (column(material.c_s()), column(material.c_p()));
            for (got, exact) in [(got.u_yy, u_yy), (got.u_xx, u_yy), (got.u_zz, u_zz)] {
                worst = worst.max((got - exact).norm() / exact.norm());
            }
            assert_eq!(got.u_xz.norm(), 0.0);
        }
    }
    println!("column {worst:e}");
    // measured 1.1e-13: tan near its resonance
    assert!(worst < 1e-12, "{worst:e}");
}

/// The first resonance of a lightly damped column lies at f = c_s/4h, and amplifies 8/(π²η).
#[test]
fn first_resonance() {
    let (h, eta) = (10.0, 0.01);
    let material = soil(60e6, 0.3, 1700.0, eta);
    let profile = Profile::new(vec![Layer { thickness: h, material }], Base::Rigid).unwrap();
    let at = |omega: f64| DirectStiffness.prepare(&profile, omega, &[]).unwrap().surface(0.0).u_yy.norm();
    let expected = PI * material.c_s() / (2.0 * h);
    let (peak, value) = (0..=2000)
        .map(|i| expected * (0.9 + 1e-4 * f64::from(i)))
        .map(|w| (w, at(w)))
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap();
    // the step of the scan is 1e-4
    assert!((peak / expected - 1.0).abs() < 2e-4, "{peak} {expected}");
    // static h/μ; one mode of stiffness π²μ/8h: 8/(π²η); the other modes add a little
    let amplification = value / (h / material.shear_modulus());
    assert!((amplification * PI * PI * eta / 8.0 - 1.0).abs() < 0.01, "{amplification}");
}

/// Two materials at k = 0: u = [1 + i r tan a]/[μk (i r − tan a)] …: SH impedances in series over a half-space.
#[test]
fn layer_on_a_half_space() {
    let (top, bottom, h) = (soil(40e6, 0.3, 1600.0, 0.05), soil(400e6, 0.3, 2000.0, 0.02), 4.0);
    let profile = Profile::new(vec![Layer { thickness: h, material: top }], Base::HalfSpace(bottom)).unwrap();
    let mut worst = 0.0f64;
    for omega in [0.5, 10.0, 60.0, 400.0] {
        let got = DirectStiffness.prepare(&profile, omega, &[]).unwrap().surface(0.0).u_yy;
        let wave = |m: &groundwave::soil::Material| {
            let mu = m.complex_shear_modulus(omega);
            (mu, omega * (m.density() / mu).sqrt())
        };
        let ((mu1, k1), (mu2, k2)) = (wave(&top), wave(&bottom));
        // u = A e^{ik₁z} + B e^{−ik₁z} above, C e^{−ik₂z} below; unit traction at the top
        let (e, i) = (Complex64::cis(0.0) * (Complex64::I * k1 * h).exp(), Complex64::I);
        let r = (mu1 * k1 - mu2 * k2) / (mu1 * k1 + mu2 * k2);
        // A = r B e^{−2ik₁h}
        let ratio = r / (e * e);
        let exact = (1.0 + ratio) / (i * k1 * mu1 * (1.0 - ratio));
        worst = worst.max((got - exact).norm() / exact.norm());
    }
    println!("on a half-space {worst:e}");
    // measured 2.1e-15
    assert!(worst < 1e-12, "{worst:e}");
}
