//! The static half-space: compliances, and Boussinesq by Hankel integrals of them.

use crate::common::soil;
use groundwave::math::quadrature::{Tolerance, integrate};
use groundwave::soil::{Base, DirectStiffness, GroundSolver, Layer, Material, Profile};
use num_complex::Complex64;
use std::f64::consts::PI;

/// One material as a half-space, and the same cut into layers.
fn whole_and_cut(material: Material) -> [Profile; 2] {
    let layers = [0.3, 2.0, 7.0].map(|thickness| Layer { thickness, material }).to_vec();
    [vec![], layers].map(|layers| Profile::new(layers, Base::HalfSpace(material)).unwrap())
}

/// u_zz = u_xx = (1 − ν)/(μk), u_xz = i(1 − 2ν)/(2μk), u_yy = 1/(μk)
#[test]
fn static_compliance() {
    let mut worst = [0.0f64; 2];
    for poisson in [-0.2, 0.0, 0.3, 0.49, 0.499] {
        let material = soil(50e6, poisson, 1800.0, 0.1);
        let mu = 50e6 / (2.0 * (1.0 + poisson));
        for (n, profile) in whole_and_cut(material).iter().enumerate() {
            let ground = DirectStiffness.prepare(profile, 0.0, &[]).unwrap();
            for k in [1e-3, 0.02, 0.5, 3.0, 100.0] {
                let g = ground.surface(k);
                let unit = 1.0 / (mu * k);
                let u_xz = Complex64::new(0.0, 0.5 * (1.0 - 2.0 * poisson) * unit);
                let gap = (g.u_zz - (1.0 - poisson) * unit).norm()
                    + (g.u_xx - (1.0 - poisson) * unit).norm()
                    + (g.u_xz - u_xz).norm()
                    + (g.u_yy - unit).norm();
                worst[n] = worst[n].max(gap / unit);
            }
        }
    }
    println!("whole {:e}, cut {:e}", worst[0], worst[1]);
    // measured 2.2e-15 for the half-space, 8.8e-11 through layers: 1/(kh) of the thinnest at k = 1e-3
    assert!(worst[0] < 1e-12 && worst[1] < 1e-9, "{worst:?}");
}

/// J_n(x) = (1/2π)∫₀^{2π} cos(nθ − x sin θ) dθ: the trapezoidal rule converges faster than any power.
fn bessel_j(n: i32, x: f64) -> f64 {
    let count = 64 + 2 * x as i32;
    let step = 2.0 * PI / f64::from(count);
    (0..count).map(|i| f64::from(i) * step).map(|t| (f64::from(n) * t - x * t.sin()).cos()).sum::<f64>()
        / f64::from(count)
}

/// A unit vertical force on the surface: (u_r, u_z) at distance `r` and depth `z` > 0, u_z = (1/2π)∫₀^∞ u_zz J₀(kr) k dk
/// and u_r = (1/2π)∫₀^∞ i u_xz J₁(kr) k dk.
fn point_load(profile: &Profile, r: f64, z: f64) -> (f64, f64) {
    let ground = DirectStiffness.prepare(profile, 0.0, &[0.0, z]).unwrap();
    let points: Vec<f64> = (0..=80).map(|i| 0.5 * f64::from(i) / z).collect();
    let tolerance = Tolerance { relative: 1e-11, absolute: 0.0, max_count: 100_000 };
    let hankel = |f: &dyn Fn(f64) -> f64| {
        integrate(|k| Complex64::from(f(k)), &points, tolerance).value.re / (2.0 * PI)
    };
    (
        hankel(&|k| (Complex64::I * ground.at_depths(k, 0)[1].u_xz).re * bessel_j(1, k * r) * k),
        hankel(&|k| ground.at_depths(k, 0)[1].u_zz.re * bessel_j(0, k * r) * k),
    )
}

/// u_z = F/(4πμ) [z²/R³ + 2(1 − ν)/R], u_r = F/(4πμ) [rz/R³ − (1 − 2ν) r/(R(R + z))]; on the axis F(3 − 2ν)/(4πμz).
/// Source: Boussinesq 1885, as in Timoshenko & Goodier.
#[test]
fn boussinesq_in_depth() {
    let mut worst = 0.0f64;
    for poisson in [0.0, 0.35, 0.495] {
        let mu = 50e6 / (2.0 * (1.0 + poisson));
        let [_, cut] = whole_and_cut(soil(50e6, poisson, 1800.0, 0.1));
        for (r, z) in [(0.0, 1.0), (0.0, 5.0), (1.0, 1.0), (6.0, 2.0), (3.0, 12.0)] {
            let distance = f64::hypot(r, z);
            let scale = 1.0 / (4.0 * PI * mu);
            let u_z = scale * (z * z / distance.powi(3) + 2.0 * (1.0 - poisson) / distance);
            let u_r =
                scale * (r * z / distance.powi(3) - (1.0 - 2.0 * poisson) * r / (distance * (distance + z)));
            if r == 0.0 {
                assert!((u_z / ((3.0 - 2.0 * poisson) * scale / z) - 1.0).abs() < 1e-14);
            }
            let got = point_load(&cut, r, z);
            worst = worst.max(((got.0 - u_r).abs() + (got.1 - u_z).abs()) / u_z);
        }
    }
    println!("in depth {worst:e}");
    // measured 1.7e-12: the integral, cut at kz = 40
    assert!(worst < 1e-9, "{worst:e}");
}

/// On the surface u_z = (1 − ν)F/(2πμr): the integral only just converges, so its partial sums between multiples of π/r
/// are averaged again and again (Euler).
#[test]
fn boussinesq_on_the_surface() {
    let mut worst = 0.0f64;
    for (poisson, r) in [(0.0, 2.0), (0.35, 0.7), (0.35, 9.0), (0.49, 4.0)] {
        let mu = 50e6 / (2.0 * (1.0 + poisson));
        let [_, cut] = whole_and_cut(soil(50e6, poisson, 1800.0, 0.1));
        let ground = DirectStiffness.prepare(&cut, 0.0, &[]).unwrap();
        let tolerance = Tolerance { relative: 1e-12, absolute: 0.0, max_count: 10_000 };
        let mut sums = Vec::new();
        let mut sum = 0.0;
        for n in 0..30 {
            let ends = [PI * f64::from(n) / r, PI * f64::from(n + 1) / r];
            let f = |k: f64| ground.u_zz(k) * (bessel_j(0, k * r) * k);
            sum += integrate(f, &ends, tolerance).value.re / (2.0 * PI);
            sums.push(sum);
        }
        while sums.len() > 1 {
            sums = sums.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
        }
        worst = worst.max((sums[0] / ((1.0 - poisson) / (2.0 * PI * mu * r)) - 1.0).abs());
    }
    println!("on the surface {worst:e}");
    // measured 4.7e-12: the averaging of thirty half-waves
    assert!(worst < 1e-8, "{worst:e}");
}

/// A static layer on rough rock: u_zz = (1 − ν)/(μk) · (2κ sinh 2a − 4a)/(2κ cosh 2a + 1 + κ² + 4a²), κ = 3 − 4ν, a = kh.
/// Source: Vorovich & Ustinov 1959; → h/(λ + 2μ) as k → 0.
#[test]
fn static_layer_on_rock() {
    let mut worst = 0.0f64;
    for poisson in [0.0, 0.3, 0.45, 0.495] {
        let material = soil(50e6, poisson, 1800.0, 0.1);
        let mu = material.shear_modulus();
        let kappa = 3.0 - 4.0 * poisson;
        let parts = [0.5, 1.5, 2.0].map(|thickness| Layer { thickness, material }).to_vec();
        let profile = Profile::new(parts, Base::Rigid).unwrap();
        let ground = DirectStiffness.prepare(&profile, 0.0, &[]).unwrap();
        for a in [0.02, 0.3, 1.0, 3.0, 20.0] {
            let exact = (1.0 - poisson) * 4.0 / (mu * a) * (2.0 * kappa * f64::sinh(2.0 * a) - 4.0 * a)
                / (2.0 * kappa * f64::cosh(2.0 * a) + 1.0 + kappa * kappa + 4.0 * a * a);
            worst = worst.max((ground.u_zz(a / 4.0) / exact - 1.0).norm());
        }
    }
    println!("layer on rock {worst:e}");
    // measured 3.4e-14
    assert!(worst < 1e-11, "{worst:e}");
}
