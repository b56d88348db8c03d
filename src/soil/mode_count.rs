//! How many modes of undamped ground have a larger wavenumber, in real numbers: without damping every stiffness is real.
//!
//! The formulas are those of [`LayerStiffness`](super::layer_stiffness), a square root that turns imaginary making its tanh
//! a tan. Read for waves slower than shear waves in the half-space, and for parts of a layer too thin to vibrate between
//! fixed faces, √(k_s² − k²) h < π, so that no tangent passes its pole.

use super::transfer_matrix::Waves;
use super::wave::Wave;
use std::f64::consts::PI;

/// A symmetric 2 × 2 matrix: first, beside, last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Symmetric(pub f64, pub f64, pub f64);

impl Symmetric {
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1, self.2 + other.2)
    }

    pub fn determinant(self) -> f64 {
        self.0 * self.2 - self.1 * self.1
    }

    /// A − C B⁻¹ C, the sign of what stands beside turned: seen from the other face.
    fn condensed(self, cross: Self, pivot: Self) -> Self {
        let scale = 1.0 / pivot.determinant();
        let Self(x, y, z) = cross;
        let Self(a, b, c) = Self(pivot.2 * scale, -pivot.1 * scale, pivot.0 * scale);
        // C B⁻¹
        let (p, q, r, s) = (x * a + y * b, x * b + y * c, y * a + z * b, y * b + z * c);
        Self(self.0 - (p * x + q * y), (r * x + s * y) - self.1, self.2 - (r * y + s * z))
    }

    fn turned(self) -> Self {
        Self(self.0, -self.1, self.2)
    }

    /// How many of its two eigenvalues are negative.
    fn negative(self) -> usize {
        match self.determinant() {
            product if product < 0.0 => 1,
            _ if self.0 + self.2 < 0.0 => 2,
            _ => 0,
        }
    }
}

/// What a material without damping says at one ω.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elastic {
    pub mu: f64,
    pub ks2: f64,
    pub kp2: f64,
    pub gamma: f64,
}

impl Elastic {
    pub fn new(wave: &Wave) -> Self {
        Self { mu: wave.mu.re, ks2: wave.ks2.re, kp2: wave.kp2.re, gamma: wave.gamma.re }
    }

    /// Stiffness of a layer of thickness `h`, bottom per bottom and bottom per turned top displacement.
    fn layer(&self, h: f64, k: f64) -> (Symmetric, Symmetric) {
        let Self { mu, ks2, kp2, gamma } = *self;
        let (p, s) = (Vertical::new(k * k - kp2, h), Vertical::new(k * k - ks2, h));
        // p² − s²
        let difference = ks2 - kp2;
        // divided differences of f and of sech² = 1 − f²x² over p², s²; close together, both are real
        let plain = p.f - s.f;
        let (f, sech) = if s.square > 0.0 {
            let sum = p.root + s.root;
            // (e^{−sh} − e^{−ph})/(p − s)
            let q = -s.decay * (-difference / sum * h).exp_m1() * sum / difference;
            let inv_w = 1.0 / ((1.0 + p.decay) * (1.0 + s.decay));
            let f = if difference > 0.25 * p.square {
                plain / difference
            } else {
                (2.0 * q * inv_w - s.f) / (p.root * sum)
            };
            (f, 4.0 * q * inv_w * inv_w * (-sum * h).exp_m1() / sum)
        } else {
            (plain / difference, (s.f * s.f * s.square - p.f * p.f * p.square) / difference)
        };
        let rest = (1.0 - gamma) * (k * k);
        let (even, odd) = (gamma * p.f - rest * f, s.f + rest * f);
        let both = 1.0 / (even * odd);
        let (inv_even, inv_odd) = (odd * both, even * both);
        let (ff, half) = (p.f * s.f, 0.5 * mu);
        let direct = Symmetric(
            half * (p.square * ff * inv_even + inv_odd),
            half * k * (4.0 - s.f * inv_even - p.f * inv_odd),
            half * (inv_even + s.square * ff * inv_odd),
        );
        let scale = half * both;
        let g = rest * (p.sech * f - p.f * sech);
        let cross = Symmetric(
            scale * (g - gamma * p.f * s.sech),
            scale * k * (1.0 - gamma) * sech,
            scale * (g + s.f * p.sech),
        );
        (direct, cross)
    }

    /// Stiffness at the surface of a half-space, k > k_s.
    pub fn half_space(&self, k: f64) -> Symmetric {
        let (p, s) = ((k * k - self.kp2).sqrt(), (k * k - self.ks2).sqrt());
        let inv_r = (p + s) / (p + self.gamma * s);
        Symmetric(self.mu * p * inv_r, self.mu * k * (inv_r - 2.0), self.mu * s * inv_r)
    }

    /// Anti-plane: μs coth sh and −μs/sinh sh.
    fn across(&self, h: f64, k: f64) -> (f64, f64) {
        let s = Vertical::new(k * k - self.ks2, h);
        // tanh x = 2t/(1 + t²), t = tanh x/2 = s f, sech² x/2 = 1 − t²
        let half = self.mu / (2.0 * s.f);
        (half * (1.0 + s.f * s.f * s.square), -half * s.sech)
    }

    /// Anti-plane: μs, k > k_s.
    pub fn half_space_across(&self, k: f64) -> f64 {
        self.mu * (k * k - self.ks2).sqrt()
    }
}

/// A vertical wavenumber x, real or imaginary, and its functions over half a thickness a = h/2.
struct Vertical {
    /// x²
    square: f64,
    /// |x|
    root: f64,
    /// e^{−xh}, of a real x.
    decay: f64,
    /// tanh(xa)/x
    f: f64,
    /// sech²(xa)
    sech: f64,
}

impl Vertical {
    fn new(square: f64, h: f64) -> Self {
        let root = square.abs().sqrt();
        let x = root * h;
        if x == 0.0 {
            return Self { square, root, decay: 1.0, f: 0.5 * h, sech: 1.0 };
        }
        if square > 0.0 {
            let less = -(-x).exp_m1();
            let decay = 1.0 - less;
            let inv = 1.0 / (2.0 - less);
            return Self { square, root, decay, f: less * inv / root, sech: 4.0 * decay * inv * inv };
        }
        let tan = (0.5 * x).tan();
        Self { square, root, decay: f64::NAN, f: tan / root, sech: 1.0 + tan * tan }
    }
}

/// Layers and half-space at one ω > 0, without damping.
pub(super) struct RealWaves {
    /// Waves and thickness, top first.
    pub layers: Vec<(Elastic, f64)>,
    /// None for a rigid base.
    pub half_space: Option<Elastic>,
}

impl RealWaves {
    /// Of `waves` without damping.
    pub fn new(waves: &Waves) -> Self {
        Self {
            layers: waves.layers.iter().map(|(wave, h)| (Elastic::new(wave), *h)).collect(),
            half_space: waves.half_space.as_ref().map(Elastic::new),
        }
    }

    /// Layers from below, each with the number of its parts: ω² < c_s²(k² + π²/h²) for every part.
    fn upward(&self, k: f64) -> impl Iterator<Item = (&Elastic, f64, usize)> {
        self.layers.iter().rev().map(move |(elastic, h)| {
            let parts = 1.0 + (h * (elastic.ks2 - k * k).max(0.0).sqrt() / PI).floor();
            (elastic, h / parts, parts as usize)
        })
    }

    /// Rayleigh modes with this wavenumber and a lower frequency, as [`count`](super::dispersion::count) finds them in complex numbers.
    pub fn in_plane(&self, k: f64) -> usize {
        let mut below = self.half_space.map(|elastic| elastic.half_space(k));
        let mut sum = 0;
        for (elastic, h, parts) in self.upward(k) {
            let (direct, cross) = elastic.layer(h, k);
            for _ in 0..parts {
                below = Some(match below {
                    Some(below) => {
                        let pivot = direct.plus(below);
                        sum += pivot.negative();
                        direct.condensed(cross, pivot)
                    }
                    None => direct.turned(),
                });
            }
        }
        sum + below.map_or(0, Symmetric::negative)
    }

    /// Love modes with this wavenumber and a lower frequency.
    pub fn across(&self, k: f64) -> usize {
        let mut below = self.half_space.map(|elastic| elastic.half_space_across(k));
        let mut sum = 0;
        for (elastic, h, parts) in self.upward(k) {
            let (direct, cross) = elastic.across(h, k);
            for _ in 0..parts {
                below = Some(match below {
                    Some(below) => {
                        let pivot = direct + below;
                        sum += usize::from(pivot < 0.0);
                        direct - cross * cross / pivot
                    }
                    None => direct,
                });
            }
        }
        sum + below.map_or(0, |surface| usize::from(surface < 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::layer_stiffness::LayerStiffness;
    use super::super::{Elastic as Given, Material};
    use super::*;

    fn apart(worst: &mut f64, got: Symmetric, exact: nalgebra::Matrix2<num_complex::Complex64>) {
        let scale = exact.norm();
        for (got, at) in [(got.0, (0, 0)), (got.1, (0, 1)), (got.2, (1, 1))] {
            *worst = worst.max((got - exact[at].re).abs() / scale);
        }
    }

    #[test]
    fn stiffnesses_are_those_in_complex_numbers() {
        let mut worst = [0.0f64; 3];
        for poisson in [0.0, 0.3, 0.499] {
            let elastic = Given::ShearPoisson { shear: 150.0, poisson };
            let material = Material::new(elastic, 1800.0, 0.0, 0.0).unwrap();
            for (omega, h) in [(1.0, 2.0), (60.0, 0.01), (60.0, 2.0), (600.0, 0.7), (3000.0, 0.1)] {
                let wave = Wave::new(&material, omega);
                let real = Elastic::new(&wave);
                let ks = omega / 150.0;
                for ratio in [0.01, 0.3, 0.57, 0.99, 1.0 + 1e-9, 1.03, 1.2, 3.0, 40.0] {
                    let k = ratio * ks;
                    let ((direct, cross), exact) =
                        (real.layer(h, k), LayerStiffness::<2>::layer(&wave, h, k));
                    apart(&mut worst[0], direct, exact.direct);
                    let scale = exact.cross.norm() / exact.direct.norm();
                    // what couples the faces is compared to itself until it is rounding
                    let mut own = 0.0;
                    apart(&mut own, cross, exact.cross);
                    worst[1] = worst[1].max(own * scale);
                    let exact = LayerStiffness::<1>::layer(&wave, h, k);
                    let (direct, cross) = real.across(h, k);
                    let size = exact.direct[(0, 0)].norm();
                    worst[2] = worst[2].max((direct - exact.direct[(0, 0)].re).abs() / size);
                    worst[2] = worst[2].max((cross - exact.cross[(0, 0)].re).abs() / size);
                    if ratio > 1.0 {
                        apart(&mut worst[0], real.half_space(k), LayerStiffness::<2>::half_space(&wave, k));
                    }
                }
            }
        }
        println!("{worst:?}");
        assert!(worst.iter().all(|worst| *worst < 1e-11), "{worst:?}");
    }
}
