//! The ground's surface around a moving train by two-dimensional inverse FFT.
//!
//! ```text
//! ũ(β_x, β_y) = G(k, −β_x v) q̃(β_x) sinc(β_y b) Σ_j P_j e^{iβ_x a_j},   q̃ = k_eq ũ_base
//! ```
//!
//! Less the closed form of its lower half-space, and under a point load of its top layer, which are added as images.

use super::far_field::{FarField, component};
use super::ground_grid::{Grid, GroundLoad, Quantity, Window};
use super::images::Images;
use super::mirrored::Mirrored;
use crate::math::complex::I;
use crate::math::fourier::{Wanted, inverse_2d};
use crate::progress::{Cancelled, Observer};
use crate::soil::{Base, GroundSolver, Material, PreparedGround, Profile, SoilError, Solver};
use crate::vehicle::Train;
use ndarray::{Array2, ArrayView, ArrayView1, Dimension};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use thiserror::Error;

/// Accuracy of G a field asks of a solver that approximates it: well below the wrap-around that is tolerated.
const FIELD_ACCURACY: f64 = 3e-4;

/// What the field is computed for.
pub struct GroundField<'a> {
    /// The ground.
    pub profile: &'a Profile,
    /// Its solver.
    pub solver: Solver,
    /// v [m/s]
    pub speed: f64,
    /// The train.
    pub train: &'a Train,
    /// How its loads reach the ground.
    pub load: GroundLoad<'a>,
}

/// Fields with what is known of their error.
#[derive(Clone, Debug)]
pub struct Field {
    /// x′ of the columns [m].
    pub x: Vec<f64>,
    /// y of the rows [m].
    pub y: Vec<f64>,
    /// One array (y, x) for each quantity asked.
    pub values: Vec<Array2<f64>>,
    /// Remainder at the border of the period relative to the largest value: what may wrap around.
    pub wrap_around: f64,
    /// Estimate of what lies beyond the largest wavenumber, relative to the largest value.
    pub aliasing: f64,
    /// Periods of the transform (x, y) [m].
    pub period: (f64, f64),
    /// Samples of the transform (x, y).
    pub samples: (usize, usize),
}

/// Why a field cannot be computed.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GroundFieldError {
    /// The ground cannot answer.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// Told to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A grid without points or spacing.
    #[error("the contour window is empty: x {x:?} m, y {y:?} m, spacing {spacing} m")]
    Window {
        /// x′ from, to [m].
        x: (f64, f64),
        /// y from, to [m].
        y: (f64, f64),
        /// [m]
        spacing: f64,
    },
}

/// Wavenumbers beyond which u_zz is its tail and one more term: so many times the slowest wave's, and over the top layer's thickness.
/// (k_s/k)⁶ and e^{−2kh}(kh)² are 6e-5 and 1e-5 there.
const SLOWEST: f64 = 5.0;
const THIN: f64 = 8.0;

/// Compliances of the surface to a vertical force at many k: the vertical one, and the horizontal one where it is wanted.
struct Responses {
    u_zz: Vec<Complex64>,
    u_xz: Vec<Complex64>,
}

impl Responses {
    /// At all `k`, which ascend; where the vertical one is enough most of it is its tail A/k + C/k³ + E/k⁵, E taken where the
    /// tail begins.
    fn new(ground: &dyn PreparedGround, k: &[f64], vertical_only: bool) -> Self {
        if !vertical_only {
            let (u_zz, u_xz) = ground.batch(k).into_iter().map(|g| (g.u_zz, g.u_xz)).unzip();
            return Self { u_zz, u_xz };
        }
        let outline = ground.outline();
        let slowest = SLOWEST * outline.wavenumbers.last().copied().unwrap_or(0.0);
        let from = slowest.max(outline.top_thickness.map_or(0.0, |h| THIN / h));
        // the first of the tail stands for its last term
        let near = (k.partition_point(|k| *k < from) + 1).min(k.len());
        let mut u_zz = Vec::with_capacity(k.len());
        u_zz.extend(ground.u_zz_many(&k[..near]));
        if let (Some(k0), Some(g0)) = (k[..near].last(), u_zz.last()) {
            let (a, c) = outline.tail;
            let last = ((g0 * k0 - a) * k0 * k0 - c) * k0 * k0;
            u_zz.extend(k[near..].iter().map(|k| {
                let inverse = 1.0 / (k * k);
                (a + (c + last * inverse) * inverse) / k
            }));
        }
        Self { u_zz, u_xz: Vec::new() }
    }

    /// `quantity` of the plane wave number `place`, (k cos θ, k sin θ).
    fn component(&self, quantity: Quantity, place: usize, cos: f64, sin: f64) -> Complex64 {
        match quantity {
            Quantity::Vertical | Quantity::VerticalVelocity => self.u_zz[place],
            Quantity::Along => self.u_xz[place] * cos,
            Quantity::Across => self.u_xz[place] * sin,
        }
    }
}

/// The largest modulus; 0 of none.
fn largest<D: Dimension>(values: ArrayView<f64, D>) -> f64 {
    values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

/// A profile of one material.
fn half_space(material: Material) -> Result<Profile, SoilError> {
    Profile::new(Vec::new(), Base::HalfSpace(material))
}

impl GroundField<'_> {
    /// The grid for `window`, with `clearance` [m], the distance over which waves fade, between it and its images.
    pub fn grid(&self, window: &Window, clearance: f64) -> Grid {
        Grid::new(window, &self.load, self.train.length(), clearance)
    }

    /// The wanted quantities over `window`, computed on `grid`.
    ///
    /// Accuracy: 0.2 % of the largest value (test `cross_solver::contour`); `wrap_around` and `aliasing` estimate
    /// it for the case at hand.
    ///
    /// # Errors
    /// An empty window; a ground its solver cannot answer for; told to stop.
    pub fn compute(
        &self,
        window: &Window,
        grid: &Grid,
        quantities: &[Quantity],
        observer: &dyn Observer,
    ) -> Result<Field, GroundFieldError> {
        let (x, y) = (window.x_positions(), window.y_positions());
        if x.is_empty() || y.is_empty() {
            return Err(GroundFieldError::Window { x: window.x, y: window.y, spacing: window.spacing });
        }
        // ℓ: where the lower half-space takes over, and resolved by the grid
        let blend = self.profile.depth().max(4.0 * grid.x.step).max(4.0 * grid.y.step).max(2.0);

        let across: Vec<f64> =
            (0..=grid.y.period_count / 2).map(|m| self.load.across(grid.y.beta(m))).collect();
        let spectrum = |n: usize, out: &mut [Vec<Complex64>]| {
            self.row(grid.x.beta(n), (grid, &across), quantities, blend, out)?;
            Ok::<_, GroundFieldError>(observer.done()?)
        };
        observer.begin("ground contour", grid.rows as u64);
        // one of two lines that mirror each other; the track's axis, the strip's edge and the border of the period for the errors
        let mirrored = Mirrored::new(&y);
        let distinct = mirrored.first();
        let edge = self.load.half_width();
        let others = [0.0, edge, 0.5 * grid.y.period()].map(|y| grid.line(y));
        let lines: Vec<usize> = distinct.iter().copied().chain(others).collect();
        let wanted = Wanted { thinning: grid.thinning, lines: &lines };
        let fields = inverse_2d(grid.x, grid.y, grid.rows, quantities.len(), wanted, spectrum)?;
        observer.end();

        let middle = -0.5 * self.train.length();
        let border = grid.column(middle + 0.5 * grid.x.period());
        let mut values = Vec::with_capacity(quantities.len());
        let (mut wrap_around, mut aliasing) = (0.0f64, 0.0f64);
        for (field, &quantity) in fields.into_iter().zip(quantities) {
            // midway between the train and its images
            let remainder = largest(field.column(border)).max(largest(field.row(lines.len() - 1)));
            let along_track = field.outer_iter().skip(distinct.len()).map(largest).fold(0.0, f64::max);
            let images = self.images(quantity, (&x, &y), blend, window.spacing)?;
            let value = self.in_window(field, &images, (&x, &y), (&mirrored, &distinct));
            let in_window = largest(value.view());
            wrap_around = wrap_around.max(remainder / in_window);
            // the truncated part stands at the edges of the strip, be they in the window or not
            aliasing = aliasing.max(self.beyond(quantity, grid)? / in_window.max(along_track));
            values.push(value);
        }
        Ok(Field {
            x,
            y,
            values,
            wrap_around,
            aliasing,
            period: (grid.x.period(), grid.y.period()),
            samples: (grid.x.period_count, grid.y.period_count),
        })
    }

    /// One quantity at all `x` × `y` [m], (y, x): of the `distinct` lines of the transform, with their `images`, and of those that mirror them.
    fn in_window(
        &self,
        mut field: Array2<f64>,
        images: &Images,
        (x, y): (&[f64], &[f64]),
        (mirrored, distinct): (&Mirrored, &[usize]),
    ) -> Array2<f64> {
        let (axles, columns) = (self.axles(), field.ncols());
        let of_line: Vec<f64> = distinct.iter().map(|j| y[*j]).collect();
        let lines = field.as_slice_mut().unwrap_or(&mut []).par_chunks_mut(columns);
        lines.zip(&of_line).for_each(|(line, y)| images.add(&mut line[..x.len()], x, *y, &axles));
        let mut value = Array2::zeros((y.len(), x.len()));
        let rows = value.as_slice_mut().unwrap_or(&mut []).par_chunks_mut(x.len());
        rows.zip(&mirrored.places).zip(y).for_each(|((row, &place), y)| {
            let turned = images.quantity == Quantity::Across && y * of_line[place] < 0.0;
            let sign = if turned { -1.0 } else { 1.0 };
            row.iter_mut().zip(field.row(place)).for_each(|(value, u)| *value = sign * u);
        });
        value
    }

    /// Material of the lower half-space: what the ground tends to as k → 0.
    fn base(&self) -> Option<Material> {
        match self.profile.base() {
            Base::HalfSpace(material) => Some(material),
            Base::Rigid => None,
        }
    }

    /// Material of the top layer, what the ground tends to as k → ∞, where the load reaches that far.
    fn top(&self) -> Option<Material> {
        match self.load {
            GroundLoad::Point => Some(*self.profile.top()),
            GroundLoad::Strip { .. } => None,
        }
    }

    /// Σ_j P_j e^{iβ_x a_j}: the train's phases; axle j stands at x′ = −a_j, a_j measured from the leading axle.
    fn phases(&self, beta_x: f64) -> Complex64 {
        let lead = self.train.axles()[0].position;
        self.train.axles().iter().map(|a| a.load * Complex64::cis(beta_x * (a.position - lead))).sum()
    }

    /// Spectrum along x of the load on the ground, all axles [N].
    fn force(&self, beta_x: f64) -> Complex64 {
        match self.load {
            GroundLoad::Strip { force, .. } => force(beta_x) * self.phases(beta_x),
            GroundLoad::Point => self.phases(beta_x),
        }
    }

    /// One row ũ(β_x, ·) less the closed-form parts, of a unit load's spectrum `across` the track.
    fn row(
        &self,
        beta_x: f64,
        (grid, across): (&Grid, &[f64]),
        quantities: &[Quantity],
        blend: f64,
        out: &mut [Vec<Complex64>],
    ) -> Result<(), SoilError> {
        let (force, phases, omega) = (self.force(beta_x), self.phases(beta_x), -beta_x * self.speed);
        let corner = (PI / grid.x.step).hypot(PI / grid.y.step);
        // k ≥ |β_x| in this row
        let solver = self.solver.resolving((0.99 * beta_x.abs(), corner), FIELD_ACCURACY, None);
        let ground = solver.prepare(self.profile, omega, &[])?;
        let prepared = |material| solver.prepare(&half_space(material)?, omega, &[]);
        let base = self.base().map(prepared).transpose()?;
        let top = self.top().map(prepared).transpose()?;
        let count = grid.y.period_count;
        let vertical_only = quantities.iter().all(|q| q.is_vertical());
        // the origin itself: the mean over a small circle stands for it
        let first = usize::from(beta_x == 0.0);
        let beta_y: Vec<f64> = (first..=count / 2).map(|m| grid.y.beta(m)).collect();
        let k: Vec<f64> = beta_y.iter().map(|beta_y| (beta_x * beta_x + beta_y * beta_y).sqrt()).collect();
        let all = Responses::new(ground.as_ref(), &k, vertical_only);
        // e^{−kℓ} above rounding
        let felt = k.partition_point(|k| k * blend < 39.0);
        let far = base.map(|base| Responses::new(base.as_ref(), &k[..felt], vertical_only));
        let near = top.map(|top| Responses::new(top.as_ref(), &k, vertical_only));
        for (out, &quantity) in out.iter_mut().zip(quantities) {
            let rate = if quantity == Quantity::VerticalVelocity { I * omega } else { Complex64::ONE };
            let (force, phases) = (rate * force, rate * phases);
            // odd in β_y, as sin θ
            let mirror = if quantity == Quantity::Across { -1.0 } else { 1.0 };
            for (place, k) in k.iter().enumerate() {
                let (cos, sin) = (beta_x / k, beta_y[place] / k);
                let m = first + place;
                let mut value = force * across[m] * all.component(quantity, place, cos, sin);
                let fade = if place < felt { (-k * blend).exp() } else { 0.0 };
                if let Some(far) = far.as_ref().filter(|_| place < felt) {
                    value -= phases * fade * far.component(quantity, place, cos, sin);
                }
                if let Some(near) = &near {
                    value -= phases * (1.0 - fade) * near.component(quantity, place, cos, sin);
                }
                out[(count - m) % count] = mirror * value;
                out[m] = value;
            }
        }
        for (out, &quantity) in out.iter_mut().zip(quantities) {
            // odd in β_y: the Nyquist line has no partner
            if quantity == Quantity::Across {
                out[count / 2] = Complex64::ZERO;
            }
            if beta_x == 0.0 {
                out[0] = self.origin(quantity, grid, blend)?;
            }
        }
        Ok(())
    }

    /// The bounded remainder at k = 0: its mean over a circle well inside the first cell.
    fn origin(&self, quantity: Quantity, grid: &Grid, blend: f64) -> Result<Complex64, SoilError> {
        const POINTS: usize = 64;
        let k = 1e-3 * grid.x.beta_step().min(grid.y.beta_step());
        let fade = (-k * blend).exp();
        let base = self.base().map(half_space).transpose()?;
        let top = self.top().map(half_space).transpose()?;
        let sum: Complex64 = (0..POINTS)
            .map(|i| {
                let (sin, cos) = (TAU * (i as f64 + 0.5) / POINTS as f64).sin_cos();
                let omega = -k * cos * self.speed;
                let at = |profile: &Profile| {
                    let ground = self.solver.prepare(profile, omega, &[])?;
                    Ok::<_, SoilError>(component(quantity, &ground.surface(k), cos, sin))
                };
                let force = if cos >= 0.0 { self.force(k * cos) } else { self.force(-k * cos).conj() };
                let mut value = force * self.load.across(k * sin) * at(self.profile)?;
                if let Some(base) = &base {
                    value -= self.phases(k * cos) * fade * at(base)?;
                }
                // the top layer's part tends to ℓ g(θ), not to zero
                if let Some(top) = &top {
                    value -= self.phases(k * cos) * (1.0 - fade) * at(top)?;
                }
                Ok(if quantity == Quantity::VerticalVelocity { value * I * omega } else { value })
            })
            .sum::<Result<_, SoilError>>()?;
        Ok(sum / POINTS as f64)
    }

    /// Place x′ [m] and load [N] of every axle.
    fn axles(&self) -> Vec<(f64, f64)> {
        let lead = self.train.axles()[0].position;
        self.train.axles().iter().map(|axle| (lead - axle.position, axle.load)).collect()
    }

    /// The closed-form images of a unit load.
    fn images(
        &self,
        quantity: Quantity,
        (x, y): (&[f64], &[f64]),
        blend: f64,
        spacing: f64,
    ) -> Result<Images, SoilError> {
        let reach = (largest(ArrayView1::from(x)) + self.train.length()).hypot(largest(ArrayView1::from(y)));
        let form = |material| FarField::new(&material, self.solver, self.speed, quantity);
        let far = self.base().map(form).transpose()?.map(|far| far.table(blend, reach));
        // ℓ = 0: the table would have no innermost radius; the field is of degree −1 in r
        let near = self.top().map(form).transpose()?.map(|near| {
            let table = near.table(blend, reach);
            (near, table)
        });
        Ok(Images { far, near, quantity, speed: self.speed, blend, spacing })
    }

    /// (1/4π²)·2∬ beyond |β_y| = π/Δy of a spectrum falling like β_y⁻²: 2 β_N Σ |ũ(β_x, β_N)| Δβ_x, for both signs of β_x.
    fn beyond(&self, quantity: Quantity, grid: &Grid) -> Result<f64, SoilError> {
        let GroundLoad::Strip { half_width, .. } = self.load else { return Ok(0.0) };
        let beta_y = grid.y.beta_max();
        let sum: f64 = (0..grid.rows)
            .step_by((grid.rows / 64).max(1))
            .map(|n| {
                let beta_x = grid.x.beta(n);
                let k = beta_x.hypot(beta_y);
                let ground = self.solver.prepare(self.profile, -beta_x * self.speed, &[])?;
                let g = component(quantity, &ground.surface(k), beta_x / k, beta_y / k).norm();
                let rate = if quantity == Quantity::VerticalVelocity { beta_x * self.speed } else { 1.0 };
                // sinc ~ 1/(β_y b), and its sign changes leave 1/(β_y b) of the integral
                Ok(self.force(beta_x).norm() * g * rate / (beta_y * half_width).powi(2))
            })
            .sum::<Result<_, SoilError>>()?;
        Ok(4.0 * beta_y * sum * (grid.rows / 64).max(1) as f64 * grid.x.beta_step() / (4.0 * PI * PI))
    }
}
