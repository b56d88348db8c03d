//! The slow part of the ground's field in closed form: what a transform of finite period cannot hold.
//!
//! Under a load moving at v, ω = −β_x v, the compliance of a homogeneous half-space is of degree −1 in k:
//! G(k, −k v cos θ) = g(θ)/k. Layered ground tends to its lower half-space as k → 0 and to its top layer as
//! k → ∞. With g(θ) = Σ g_n e^{inθ} the image of g(θ) e^{−kℓ}/k is
//!
//! ```text
//! u(r, φ) = 1/(2π√(ℓ² + r²)) Σ_n g_n iⁿ t^|n| e^{inφ}  (i^|n| for n < 0),  t = (√(ℓ² + r²) − ℓ)/r
//! ```
//!
//! from ∫₀^∞ J_n(kr) e^{−kℓ} dk = tⁿ/√(ℓ² + r²). Subtracted before and added after the inverse FFT, it leaves a
//! remainder that is bounded at k = 0 and whose periodic images fade like 1/L² instead of 1/L.

use super::Quantity;
use crate::math::complex::I;
use crate::math::fourier::harmonics;
use crate::soil::{Base, Layer, Material, PreparedGround, Profile, SoilError, Solver};
use crate::soil::{GroundSolver, SurfaceCompliance};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Directions in which g(θ) is sampled; enough for a Mach cone of η = 0.02.
const DIRECTIONS: usize = 1024;

/// g(θ) of a half-space of one material under a load at one speed, for one quantity.
#[derive(Clone, Debug)]
pub struct FarField {
    /// g_n iⁿ for n ≥ 0, g_{−n} i^n for n > 0: both as powers of t.
    positive: Vec<Complex64>,
    negative: Vec<Complex64>,
}

/// `quantity` of the plane wave (k cos θ, k sin θ) from the surface compliance.
pub(super) fn component(quantity: Quantity, g: &SurfaceCompliance, cos: f64, sin: f64) -> Complex64 {
    match quantity {
        Quantity::Vertical | Quantity::VerticalVelocity => g.u_zz,
        Quantity::Along => g.u_xz * cos,
        Quantity::Across => g.u_xz * sin,
    }
}

impl FarField {
    /// g(θ) of a half-space of `material` at `speed` [m/s].
    ///
    /// # Errors
    /// None for a valid material.
    pub fn new(
        material: &Material,
        solver: Solver,
        speed: f64,
        quantity: Quantity,
    ) -> Result<Self, SoilError> {
        let half_space = Profile::new(Vec::<Layer>::new(), Base::HalfSpace(*material))?;
        let mut samples = Vec::with_capacity(DIRECTIONS);
        for i in 0..DIRECTIONS {
            // half a step off the axes, where ω = 0 and sgn ω jumps
            let (sin, cos) = (TAU * (i as f64 + 0.5) / DIRECTIONS as f64).sin_cos();
            let ground: Box<dyn PreparedGround> = solver.prepare(&half_space, -speed * cos, &[])?;
            samples.push(component(quantity, &ground.surface(1.0), cos, sin));
        }
        let harmonics = harmonics(samples);
        let largest = harmonics.iter().map(|g| g.norm()).fold(0.0, f64::max);
        let half = DIRECTIONS / 2;
        // the half step put back
        let harmonic = |n: i32| {
            let index = n.rem_euclid(DIRECTIONS as i32) as usize;
            harmonics[index] * Complex64::cis(-PI * f64::from(n) / DIRECTIONS as f64)
        };
        let kept = (0..half as i32)
            .rev()
            .find(|&n| harmonic(n).norm().max(harmonic(-n).norm()) > 1e-9 * largest)
            .unwrap_or(0);
        Ok(Self {
            positive: (0..=kept).map(|n| harmonic(n) * I.powi(n)).collect(),
            negative: (0..=kept)
                .map(|n| if n == 0 { Complex64::ZERO } else { harmonic(-n) * I.powi(n) })
                .collect(),
        })
    }

    /// Σ c_n zⁿ by Horner's rule.
    fn series(coefficients: &[Complex64], z: Complex64) -> Complex64 {
        coefficients.iter().rev().fold(Complex64::ZERO, |sum, c| sum * z + c)
    }

    /// Image of g(θ) e^{−kℓ}/k at (x, y) [m] from the load, per newton.
    pub fn image(&self, x: f64, y: f64, length: f64) -> f64 {
        let r = x.hypot(y);
        let reach = length.hypot(r);
        // (√(ℓ² + r²) − ℓ)/r without cancellation
        let t = r / (reach + length);
        let direction = if r > 0.0 { Complex64::new(x / r, y / r) } else { Complex64::ONE };
        let sum =
            Self::series(&self.positive, t * direction) + Self::series(&self.negative, t * direction.conj());
        sum.re / (TAU * reach)
    }

    /// g₀: the mean of g(θ) over all directions.
    pub fn mean(&self) -> f64 {
        self.positive[0].re
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soil::{Elastic, half_space};

    #[test]
    fn slow_load_on_a_half_space_is_the_closed_form() {
        // ℓ = 0: the field itself; v = 0.8 c_R, η = 1e-6. Measured 2e-6
        let material =
            Material::new(Elastic::ShearPoisson { shear: 100.0, poisson: 0.3 }, 1800.0, 1e-6, 1e-6).unwrap();
        let speed = 0.8 * material.rayleigh_speed();
        let far = FarField::new(&material, Solver::DirectStiffness, speed, Quantity::Vertical).unwrap();
        for theta in [0.0, 0.5, 1.2, 1.57, 2.5, 4.0] {
            let exact = half_space::moving_point_load(&material, 1.0, speed, 7.0, theta);
            let got = far.image(7.0 * theta.cos(), 7.0 * theta.sin(), 0.0);
            assert!((got / exact - 1.0).abs() < 2e-5, "{theta}: {got} {exact}");
        }
    }
}
