//! Valid grounds drawn widely: thin to thick, stiff over soft and soft over stiff, ν to 0.499, η 0.1 % to 20 %.

use groundwave::soil::{Base, Elastic, Layer, Material, Profile};
use proptest::prelude::*;

/// A soil in plain numbers, so that a counterexample can be read and its units changed.
#[derive(Clone, Copy, Debug)]
pub struct Soil {
    pub young: f64,
    pub poisson: f64,
    pub density: f64,
    pub eta_s: f64,
    pub eta_p: f64,
}

impl Soil {
    pub fn material(&self) -> Material {
        let elastic = Elastic::YoungPoisson { young: self.young, poisson: self.poisson };
        Material::new(elastic, self.density, self.eta_s, self.eta_p).unwrap()
    }
}

/// Layers (thickness, soil) over a half-space, or over rigid rock (None); a wavenumber, a frequency, a fraction.
#[derive(Clone, Debug)]
pub struct Ground {
    pub layers: Vec<(f64, Soil)>,
    pub base: Option<Soil>,
    /// [rad/m]
    pub k: f64,
    /// [rad/s], ≥ 0
    pub omega: f64,
    /// Between 0.1 and 0.9, wherever something is to be cut.
    pub fraction: f64,
}

impl Ground {
    pub fn profile(&self) -> Profile {
        profile(&self.layers, self.base)
    }

    /// The surface, a depth inside every layer, every interface, and one depth inside the half-space [m].
    pub fn depths(&self) -> Vec<f64> {
        let mut depths = vec![0.0];
        let mut top = 0.0;
        for (thickness, _) in &self.layers {
            depths.extend([top + self.fraction * thickness, top + thickness]);
            top += thickness;
        }
        match self.base {
            Some(_) => depths.push(top + 3.0 * self.fraction),
            // the rigid base itself does not move
            None => _ = depths.pop(),
        }
        depths
    }

    /// What stiffness matrices cost in rounding at `k`: the largest of the layers' stiffnesses μ/h, all layers cut at
    /// `fraction`, relative to the smallest μk the surface may feel; at least 1.
    pub fn cost(&self, k: f64) -> f64 {
        let cut = self.fraction.min(1.0 - self.fraction);
        let layers = self.layers.iter().map(|(h, s)| (cut * h, s.young));
        let all: Vec<_> = layers.chain(self.base.map(|s| (3.0 * self.fraction, s.young))).collect();
        let softest = all.iter().map(|l| l.1).fold(f64::INFINITY, f64::min);
        all.iter().map(|(h, young)| young / (softest * (k * h).min(1.0))).fold(1.0, f64::max)
    }
}

pub fn profile(layers: &[(f64, Soil)], base: Option<Soil>) -> Profile {
    let layers = layers.iter().map(|&(thickness, soil)| Layer { thickness, material: soil.material() });
    let base = base.map_or(Base::Rigid, |soil| Base::HalfSpace(soil.material()));
    Profile::new(layers.collect(), base).unwrap()
}

/// Even in the logarithm.
pub fn log(from: f64, to: f64) -> impl Strategy<Value = f64> + Clone {
    (from.ln()..to.ln()).prop_map(f64::exp)
}

fn soil() -> impl Strategy<Value = Soil> {
    let poisson = prop_oneof![4 => -0.2..0.49, 1 => 0.49..0.499];
    let pressure = prop_oneof![2 => Just(1.0), 1 => 0.0..3.0];
    (log(2e6, 2e10), poisson, 1000.0..2700.0, log(1e-3, 0.2), pressure).prop_map(
        |(young, poisson, density, eta_s, ratio): (f64, f64, f64, f64, f64)| {
            // the least loss factor of compression that keeps the bulk modulus passive
            let least = 4.0 / 3.0 * eta_s * (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
            Soil { young, poisson, density, eta_s, eta_p: (ratio * eta_s).max(1.001 * least) }
        },
    )
}

/// A ground with k and ω over the given decades; every fourth ω is 0, every fourth lies among the wave speeds.
pub fn ground(k: (f64, f64), omega: (f64, f64)) -> impl Strategy<Value = Ground> {
    ground_of((0.05, 50.0), k, omega)
}

/// The same with layers of the given `thickness` [m]: crusts too.
pub fn ground_of(thickness: (f64, f64), k: (f64, f64), omega: (f64, f64)) -> impl Strategy<Value = Ground> {
    let layers = prop::collection::vec((log(thickness.0, thickness.1), soil()), 0..=6);
    let base = prop_oneof![3 => soil().prop_map(Some), 1 => Just(None)];
    let frequency = prop_oneof![
        1 => Just((0.0, 0.0)),
        2 => log(omega.0, omega.1).prop_map(|w| (w, 0.0)),
        1 => (0.3..2.5).prop_map(|ratio| (0.0, ratio)),
    ];
    (layers, base, soil(), log(k.0, k.1), frequency, 0.1..0.9).prop_map(
        |(mut layers, base, spare, k, (omega, ratio), fraction)| {
            if layers.is_empty() && base.is_none() {
                layers.push((1.0, spare));
            }
            let top = layers.first().map(|l| l.1).or(base).unwrap_or(spare);
            let omega = if ratio > 0.0 { ratio * k * top.material().c_s() } else { omega };
            Ground { layers, base, k, omega, fraction }
        },
    )
}
