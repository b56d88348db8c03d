//! The grounds of the reference files, a reader for their tables, and what tests and benches share.
#![allow(dead_code)]

pub mod cli;
pub mod manchester;
pub mod sleepers;
pub mod tracks;

use groundwave::soil::{Base, Compatibility, Elastic, Layer, Material, PreparedGround, Profile, Strip};
use num_complex::Complex64;
use std::hint::black_box;

/// The contact of application 2's ballasted track.
pub const STRIP: Strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };

/// A soil from (E, ν, ρ, η).
pub fn soil(young: f64, poisson: f64, density: f64, eta: f64) -> Material {
    Material::new(Elastic::YoungPoisson { young, poisson }, density, eta, eta).unwrap()
}

/// A profile from layers (h, E, ν, ρ, η) over a half-space (E, ν, ρ, η).
pub fn profile(layers: &[(f64, f64, f64, f64, f64)], base: (f64, f64, f64, f64)) -> Profile {
    let layers = layers
        .iter()
        .map(|&(thickness, e, nu, rho, eta)| Layer { thickness, material: soil(e, nu, rho, eta) })
        .collect();
    Profile::new(layers, Base::HalfSpace(soil(base.0, base.1, base.2, base.3))).unwrap()
}

/// The five profiles of `reference/surface_compliance.csv`.
pub fn named(name: &str) -> Profile {
    match name {
        "paper_layered" => profile(&[(2.0, 60e6, 0.35, 1500.0, 0.06)], (200e6, 0.35, 1800.0, 0.06)),
        "paper_half_space" => profile(&[], (75e6, 0.35, 1800.0, 0.06)),
        "mezher2016_profile3" => profile(
            &[(2.0, 30e6, 0.35, 2000.0, 0.04), (4.0, 40e6, 0.35, 2000.0, 0.04)],
            (75e6, 0.40, 2000.0, 0.04),
        ),
        "stiff_over_soft" => profile(
            &[(1.5, 400e6, 0.30, 2000.0, 0.02), (5.0, 40e6, 0.45, 1700.0, 0.05)],
            (250e6, 0.40, 1900.0, 0.03),
        ),
        "nearly_incompressible" => profile(
            &[(3.0, 30e6, 0.495, 1700.0, 0.04), (8.0, 90e6, 0.49, 1800.0, 0.04)],
            (400e6, 0.48, 2000.0, 0.02),
        ),
        _ => panic!("unknown profile {name}"),
    }
}

/// The rows of a CSV with a header line, split at commas.
pub fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines().skip(1).filter(|l| !l.is_empty()).map(|l| l.split(',').collect()).collect()
}

/// Σ u_zz at `count` wavenumbers up to 10 rad/m: the baseline of the benches.
pub fn sum_u_zz(ground: &dyn PreparedGround, count: u32) -> Complex64 {
    (1..=count).map(|i| ground.u_zz(black_box(10.0 / f64::from(count) * f64::from(i)))).sum()
}
