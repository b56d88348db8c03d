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
use crate::math::fourier::{from_harmonics, harmonics};
use crate::math::interpolation::cubic_weights;
use crate::soil::{Base, Layer, Material, PreparedGround, Profile, SoilError, Solver};
use crate::soil::{GroundSolver, SurfaceCompliance};
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::iter::successors;

/// Directions in which g(θ) is sampled; enough for a Mach cone of η = 0.02.
const DIRECTIONS: usize = 1024;

/// g(θ) of a half-space of one material under a load at one speed, for one quantity, as harmonics.
#[derive(Clone, Debug)]
pub struct FarField {
    /// g_n i^|n|, n = 0, 1, … and from the end −1, −2, …; the last one, n = N/2, is left out.
    harmonics: Vec<Complex64>,
}

/// Images of one g(θ) e^{−kℓ}/k, tabulated for many positions.
#[derive(Clone, Debug)]
pub struct ImageTable {
    /// 2π √(ℓ² + r²) u at rows of asinh(r/ℓ), columns of φ.
    values: Vec<f64>,
    /// Rows per unit of asinh(r/ℓ).
    density: f64,
    rows: usize,
    length: f64,
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
        let mut harmonics = harmonics(samples);
        for (i, value) in harmonics.iter_mut().enumerate() {
            let n = order(i);
            *value = if n == DIRECTIONS / 2 { Complex64::ZERO } else { *value * I.powi(n as i32) };
        }
        Ok(Self { harmonics })
    }

    /// Image of g(θ) e^{−kℓ}/k at (x, y) [m] from the load, per newton, term by term.
    pub fn image(&self, x: f64, y: f64, length: f64) -> f64 {
        let r = x.hypot(y);
        let reach = length.hypot(r);
        // (√(ℓ² + r²) − ℓ)/r without cancellation
        let t = r / (reach + length);
        let direction = if r > 0.0 { Complex64::new(x / r, y / r) } else { Complex64::ONE };
        let half = DIRECTIONS / 2;
        // Σ c_n zⁿ by Horner's rule, for positive and negative n
        let series = |terms: &mut dyn Iterator<Item = &Complex64>, z: Complex64| {
            terms.fold(Complex64::ZERO, |sum, c| sum * z + c)
        };
        let positive = series(&mut self.harmonics[..half].iter().rev(), t * direction);
        let back = t * direction.conj();
        let negative = back * series(&mut self.harmonics[half..].iter(), back);
        (positive + negative).re / (TAU * reach)
    }

    /// Images for |r| ≤ `reach` [m]: one Fourier sum per radius gives all directions, cubic interpolation the rest.
    ///
    /// Accuracy: 1e-4 of the largest value of its radius against `image` (test `tests::table_agrees_with_series`).
    pub fn table(&self, length: f64, reach: f64) -> ImageTable {
        const DENSITY: f64 = 40.0;
        let rows = ((reach / length).asinh() * DENSITY).ceil() as usize + 4;
        let values = (0..rows)
            .flat_map(|row| {
                // one row before the origin, mirrored, for the cubic
                let t = ((row as f64 - 1.0) / DENSITY).abs().sinh();
                let t = t / (1.0 + t.hypot(1.0));
                // t^n
                let powers: Vec<f64> =
                    successors(Some(1.0), |power| Some(power * t)).take(DIRECTIONS / 2 + 1).collect();
                let terms = self.harmonics.iter().enumerate().map(|(i, c)| c * powers[order(i)]).collect();
                from_harmonics(terms).into_iter().map(|z| z.re)
            })
            .collect();
        ImageTable { values, density: DENSITY, rows, length }
    }

    /// g₀: the mean of g(θ) over all directions.
    pub fn mean(&self) -> f64 {
        self.harmonics[0].re
    }
}

/// |n| of harmonic number `i`.
fn order(i: usize) -> usize {
    i.min(DIRECTIONS - i)
}

impl ImageTable {
    /// The image at (x, y) [m] from the load, per newton.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        // lengths of metres: no root of squares over- or underflows, and asinh x = ln(x + √(x² + 1)) of x ≥ 0 loses nothing that counts
        let r2 = (x * x + y * y) / (self.length * self.length);
        let reach = (1.0 + r2).sqrt();
        let row = ((r2.sqrt() + reach).ln() * self.density + 1.0).min((self.rows - 3) as f64);
        let turn = y.atan2(x) / TAU;
        let column = if turn < 0.0 { turn + 1.0 } else { turn } * DIRECTIONS as f64;
        let (i, j) = (row.floor() as usize, column.floor() as usize);
        let (across, along) = (cubic_weights(row - i as f64), cubic_weights(column - j as f64));
        let mut sum = 0.0;
        for (m, a) in across.iter().enumerate() {
            // the row before the origin lies on the other side of it
            let turn = if i + m == 1 { DIRECTIONS / 2 } else { 0 };
            let line = &self.values[(i + m - 1) * DIRECTIONS..][..DIRECTIONS];
            for (n, b) in along.iter().enumerate() {
                sum += a * b * line[(j + n + DIRECTIONS - 1 + turn) % DIRECTIONS];
            }
        }
        sum / (TAU * self.length * reach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soil::{Elastic, half_space};

    #[test]
    fn table_agrees_with_series() {
        // below the wave speeds 4e-6, above them 7e-5, along the Mach cone; relative to the largest value of the radius
        let material =
            Material::new(Elastic::ShearPoisson { shear: 200.0, poisson: 0.3 }, 1800.0, 0.06, 0.06).unwrap();
        for speed in [100.0, 260.0] {
            let far = FarField::new(&material, Solver::DirectStiffness, speed, Quantity::Vertical).unwrap();
            let table = far.table(2.0, 150.0);
            let mut worst = 0.0f64;
            for r in [0.0, 0.01, 0.3, 2.0, 11.0, 70.0, 149.0] {
                let points: Vec<(f64, f64)> = (0..37)
                    .map(|i| (r * (0.17 * f64::from(i)).cos(), r * (0.17 * f64::from(i)).sin()))
                    .collect();
                let largest = points.iter().map(|p| far.image(p.0, p.1, 2.0).abs()).fold(0.0, f64::max);
                for (x, y) in points {
                    worst = worst.max((table.at(x, y) - far.image(x, y, 2.0)).abs() / largest);
                }
            }
            assert!(worst < 2e-4, "{speed}: {worst:e}");
        }
    }

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
