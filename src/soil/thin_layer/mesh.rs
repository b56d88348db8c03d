//! How finely the ground is cut: sublayers follow the wavelength **and** the distance to the load.
//!
//! A sublayer at distance d from the nearest load or receiver is at most
//!
//! ```text
//! h = (1/n) min( λ_R, max(4/k_max, 2.4 d) ) · min(1, (2γ)^{1/2p})
//! ```
//!
//! thick, n the number of sublayers per Rayleigh wavelength, p the degree of the elements: of the waves with k > 2.6/d little is
//! left there. But what travels in a soft layer above a stiff one reaches it from any distance: at d′ below the soft
//! layer, sublayers are at most max(λ_R/n of the soft layer, 2.4 d′/n) thick. Soil that hardly changes its volume,
//! γ = (c_s/c_p)² ≪ 1, errs like 1/γ and gets thinner ones; so do resonances of lightly damped layers, where an error ε of
//! the wave speed counts ε/η: there λ_R/n is (η/0.02)^{1/2p} as long, η taken as 0.002 at least. In a half-space
//! follow matched layers: a linear layer of thickness L integrated at mid-depth is exact for the vertical wavenumber
//! 2/L and turns back ((2 − sL)/(2 + sL))² of any other s. Thicknesses in geometric progression, real ones for the
//! decaying field from k_max down to the smallest √(k² − k_p²) on the real axis, imaginary ones for waves leaving at
//! any angle, turn back less than e^{−π²/δ}, δ the logarithm of their ratio, however small ω is.
//!
//! Source: Guddati & Tassoulas 2000 (matched layers); the spacing is our own.

use super::super::wave::Wave;
use super::super::{Base, Layer, Material, Profile};
use super::element::{Element, Sublayer};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// What the sublayers have to resolve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resolution {
    pub element: Element,
    /// n
    pub per_wavelength: f64,
    /// Error wanted of G.
    pub accuracy: f64,
    /// [rad/m]
    pub k_min: f64,
    /// [rad/m]
    pub k_max: f64,
    /// Lowest and highest frequency the same sublayers are to serve [rad/s]; results are smooth in between.
    pub omega: (f64, f64),
}

/// A cut profile.
#[derive(Clone, Debug)]
pub(super) struct Mesh {
    /// Top first.
    pub sublayers: Vec<Sublayer>,
    /// Node (not sublayer) at each depth asked for.
    pub nodes: Vec<usize>,
    /// Number of the sublayer above which each depth lies.
    pub interfaces: Vec<usize>,
    /// Material below the sublayers; None on rock.
    pub half_space: Option<Material>,
    /// Slowest c_s, the half-space included [m/s].
    pub slowest: f64,
}

impl Mesh {
    /// Cuts the layers of `profile` at `omega` ≥ 0 for loads and receivers at `depths`, interfaces of the profile. Stops
    /// where what decays at least as e^{−Re s(k)z}, k = `slowest`, has gone for good.
    pub fn new(profile: &Profile, omega: f64, depths: &[f64], to: &Resolution, slowest: f64) -> Self {
        let mut mesh = Self {
            sublayers: Vec::new(),
            nodes: vec![0; depths.len()],
            interfaces: vec![0; depths.len()],
            half_space: match profile.base() {
                Base::HalfSpace(material) => Some(material),
                Base::Rigid => None,
            },
            slowest: profile.materials().map(Material::c_s).fold(f64::INFINITY, f64::min),
        };
        let deepest = depths.iter().copied().fold(0.0, f64::max);
        let gone = 0.5 * (1.0 / to.accuracy).ln() + 4.0;
        let (low, high) = to.omega;
        let (mut top, mut node, mut decay) = (0.0, 0, 0.0);
        let shape = to.element.shape();
        // bottom and longest sublayer of the layers above
        let mut above: Vec<(f64, f64)> = Vec::new();
        for layer in profile.layers() {
            let wave = Wave::new(&layer.material, omega);
            if decay > gone && top > deepest {
                mesh.half_space = Some(layer.material);
                break;
            }
            let longest = longest(&layer.material, to);
            let cuts = cut(top, layer, depths, to, longest, &above);
            // slowly decaying waves: S at whichever end of the frequencies
            let slow = [low, high].map(|omega| Wave::new(&layer.material, omega).vertical(slowest).1.re);
            let slow = slow[0].min(slow[1]);
            for pair in cuts.windows(2) {
                let thickness = Complex64::from(pair[1] - pair[0]);
                mesh.sublayers.push(Sublayer { shape, thickness, wave });
                node += shape.nodes - 1;
                // from the deepest load downward
                if pair[0] >= deepest * (1.0 - 1e-9) {
                    decay += slow * thickness.re;
                }
                if decay > gone && pair[1] > deepest {
                    break;
                }
            }
            if decay > gone && top + layer.thickness > deepest {
                mesh.half_space = Some(layer.material);
                break;
            }
            top += layer.thickness;
            above.push((top, longest));
            for (i, depth) in depths.iter().enumerate() {
                if (depth - top).abs() <= 1e-9 * top {
                    (mesh.nodes[i], mesh.interfaces[i]) = (node, mesh.sublayers.len());
                }
            }
        }
        mesh
    }

    /// Matched layers instead of the half-space, the last one on rock, for loads and receivers at `depths`.
    pub fn matched(mut self, omega: f64, depths: &[f64], to: &Resolution) -> Self {
        let Some(material) = self.half_space.take() else { return self };
        let wave = Wave::new(&material, omega);
        let bottom: f64 = self.sublayers.iter().map(|s| s.thickness.re).sum();
        let clear = bottom - depths.iter().copied().fold(0.0, f64::max);
        // of the waves with k > s_max nothing comes back from the half-space to the deepest load or receiver
        let mut highest = 2.0 * to.k_max;
        if clear > 1e-9 * bottom {
            highest = highest.min((0.5 * (1.0 / to.accuracy).ln() + 1.0) / clear);
        }
        let (low, high) = to.omega;
        let k_s = high / material.c_s();
        let spacing = PI * PI / (300.0 / to.accuracy).ln();
        let mut slownesses = Vec::new();
        // |√(k² − k_p²)| ≥ √(η/2) k_p on the real axis; nearly undamped ground is cut a little short of its branch point
        let lowest = if low == 0.0 {
            to.k_min
        } else {
            let lowest = 0.5 * material.loss_factor_pressure().max(1e-3).sqrt() * low / material.c_p();
            let count = ((k_s / lowest).ln() / spacing).ceil() as usize + 1;
            slownesses.extend(geometric(k_s, lowest, count).map(|s| Complex64::new(0.0, s)));
            lowest
        };
        // nor less than what travels in softer layers above
        highest = highest.max(2.0 * high / self.slowest).max(4.0 * lowest);
        let count = ((highest / lowest).ln() / spacing).ceil() as usize + 1;
        slownesses.extend(geometric(highest, lowest, count).map(Complex64::from));
        slownesses.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        self.sublayers.extend(slownesses.into_iter().map(|s| Sublayer::matched(wave, 2.0 / s)));
        self
    }

    /// Nodes that move.
    pub fn size(&self) -> usize {
        self.sublayers.iter().map(|s| s.shape.nodes - 1).sum()
    }
}

/// `count` values from `from` to `to` in geometric progression.
fn geometric(from: f64, to: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| from * (to / from).powf(i as f64 / (count - 1).max(1) as f64))
}

/// min(1, (2γ)^{1/2p})
fn soft(material: &Material, to: &Resolution) -> f64 {
    let gamma = (material.c_s() / material.c_p()).powi(2);
    (2.0 * gamma).min(1.0).powf(0.5 / to.element.degree() as f64)
}

/// λ_R/n of ordinary soil, the longest sublayer.
fn longest(material: &Material, to: &Resolution) -> f64 {
    // what is wrong of the wave speed moves a resonance of width η
    let sharp = (material.loss_factor() / 0.02).clamp(0.1, 1.0).powf(0.5 / to.element.degree() as f64);
    sharp * soft(material, to) * TAU * material.rayleigh_speed() / (to.per_wavelength * to.omega.1)
}

/// Depths at which a layer from `top` is cut, its faces included, into sublayers of at most `longest`; `above` are the bottoms
/// and longest sublayers of the layers above it.
fn cut(
    top: f64,
    layer: &Layer,
    depths: &[f64],
    to: &Resolution,
    longest: f64,
    above: &[(f64, f64)],
) -> Vec<f64> {
    let bottom = top + layer.thickness;
    let n = to.per_wavelength;
    let soft = soft(&layer.material, to);
    // the least thickness beside a load
    let least = soft * 4.0 / (n * to.k_max);
    let growth = soft * 2.4 / n;
    let mut cuts = vec![top];
    let mut z = top;
    while z < bottom {
        // every depth above lets the next sublayer be g d thick, every one below asks that it be thin enough at its end
        let near = std::iter::once(&0.0).chain(depths).map(|&d| {
            if d <= z + 1e-12 * bottom { growth * (z - d) } else { growth * (d - z) / (1.0 + growth) }
        });
        let entering = above.iter().map(|&(end, longest)| (growth * (z - end)).max(longest));
        z += entering.fold(near.fold(f64::INFINITY, f64::min).max(least).min(longest), f64::min);
        cuts.push(z);
    }
    // stretched back to fit
    let factor = layer.thickness / (z - top);
    cuts.iter_mut().for_each(|c| *c = top + (*c - top) * factor);
    cuts
}
