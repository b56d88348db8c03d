//! The ground's surface around a moving train by two-dimensional inverse FFT.
//!
//! (long because the transform, what is taken out of it and put back in closed form, and its error share one grid)
//!
//! ```text
//! ũ(β_x, β_y) = G(k, −β_x v) q̃(β_x) sinc(β_y b) Σ_j P_j e^{iβ_x a_j},   q̃ = k_eq ũ_base
//! ```

use super::far_field::{FarField, component};
use crate::math::complex::I;
use crate::math::fourier::{Axis, inverse_2d};
use crate::soil::strip::sinc;
use crate::soil::{
    Base, GroundSolver, Material, PreparedGround, Profile, SoilError, Solver, SurfaceCompliance,
};
use crate::vehicle::Train;
use ndarray::Array2;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};
use thiserror::Error;

/// Accuracy of G a field asks of a solver that approximates it: well below the wrap-around that is tolerated.
const FIELD_ACCURACY: f64 = 3e-4;

/// What is wanted of the ground's surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// u_z [m], positive down.
    Vertical,
    /// ∂u_z/∂t = −v ∂u_z/∂x′ [m/s], positive down.
    VerticalVelocity,
    /// u_x [m], along the track, positive in the direction of travel.
    Along,
    /// u_y [m], across the track.
    Across,
}

impl Quantity {
    /// Name of the dataset: `u_z`, `v_z`, `u_x`, `u_y`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Vertical => "u_z",
            Self::VerticalVelocity => "v_z",
            Self::Along => "u_x",
            Self::Across => "u_y",
        }
    }
}

/// A rectangle of positions seen from the leading axle (x′ positive ahead).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// x′ from, to [m].
    pub x: (f64, f64),
    /// y from, to [m].
    pub y: (f64, f64),
    /// Spacing of both [m].
    pub spacing: f64,
}

impl Window {
    /// Positions along one side.
    fn positions(&self, side: (f64, f64)) -> Vec<f64> {
        let count = ((side.1 - side.0) / self.spacing + 1e-9).floor() as usize + 1;
        (0..count).map(|i| side.0 + self.spacing * i as f64).collect()
    }

    /// x′ of the columns [m].
    pub fn x_positions(&self) -> Vec<f64> {
        self.positions(self.x)
    }

    /// y of the rows [m].
    pub fn y_positions(&self) -> Vec<f64> {
        self.positions(self.y)
    }
}

/// How a unit axle load reaches the ground.
#[derive(Clone, Copy)]
pub enum GroundLoad<'a> {
    /// Over a strip of half-width b: force per metre spectrum q̃(β ≥ 0) for a unit load, negligible beyond `beta_max`.
    Strip {
        /// q̃(β)
        force: &'a (dyn Fn(f64) -> Complex64 + Sync),
        /// [rad/m]
        beta_max: f64,
        /// b [m]
        half_width: f64,
    },
    /// At a point.
    Point,
}

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

/// The two axes of the transform and how they thin out to the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Along the track.
    pub x: Axis,
    /// Across the track.
    pub y: Axis,
    /// Columns per wanted column, rows per wanted row.
    pub thinning: (usize, usize),
    /// Rows of β_x that carry load.
    pub rows: usize,
}

impl Grid {
    /// Memory of the transform for `fields` quantities [bytes].
    pub fn bytes(&self, fields: usize) -> u64 {
        let columns = self.y.period_count as f64;
        let spectrum = 16.0 * self.rows as f64 * columns;
        let result = 8.0 * self.x.period_count as f64 * columns;
        // a conversion from f64 stops at the largest u64
        (fields as f64 * (spectrum + result)) as u64
    }
}

/// Surface compliance at `k`; the vertical one alone costs half.
fn response(ground: &dyn PreparedGround, k: f64, vertical_only: bool) -> SurfaceCompliance {
    if vertical_only {
        let zero = Complex64::ZERO;
        SurfaceCompliance { u_zz: ground.u_zz(k), u_xx: zero, u_xz: zero, u_yy: zero }
    } else {
        ground.surface(k)
    }
}

/// A profile of one material.
fn half_space(material: Material) -> Result<Profile, SoilError> {
    Profile::new(Vec::new(), Base::HalfSpace(material))
}

impl GroundField<'_> {
    /// The grid for `window`: fine enough for the strip's edges, with periods that leave `clearance` [m], the distance over
    /// which waves fade, between the window and its images.
    pub fn grid(&self, window: &Window, clearance: f64) -> Grid {
        let length = self.train.length();
        let (half_width, beta_max) = match self.load {
            GroundLoad::Strip { half_width, beta_max, .. } => (half_width, beta_max),
            GroundLoad::Point => (f64::INFINITY, f64::INFINITY),
        };
        // a tenth of the half-width keeps the truncated 1/β_y² tail near 0.1 % of the peak
        let across = (window.spacing / (0.1 * half_width)).ceil().max(1.0);
        let along = (window.spacing * beta_max / PI).ceil().max(1.0);
        let along = if beta_max.is_finite() { along } else { 1.0 };
        let reach_x = (window.x.1.max(0.0) - window.x.0.min(-length)) + length;
        let reach_y = 2.0 * window.y.0.abs().max(window.y.1.abs());
        let x = Axis::new(window.x.0, window.spacing / along, reach_x + clearance);
        let y = Axis::new(window.y.0, window.spacing / across, reach_y + clearance);
        let rows = ((beta_max / x.beta_step()).ceil() + 1.0).min((x.period_count / 2 + 1) as f64) as usize;
        Grid { x, y, thinning: (across as usize, along as usize), rows }
    }

    /// The wanted quantities over `window`, computed on `grid`.
    ///
    /// Accuracy: 0.2 % of the largest value (test `cross_solver::contour`); `wrap_around` and `aliasing` estimate
    /// it for the case at hand.
    ///
    /// # Errors
    /// An empty window; a ground its solver cannot answer for.
    pub fn compute(
        &self,
        window: &Window,
        grid: &Grid,
        quantities: &[Quantity],
    ) -> Result<Field, GroundFieldError> {
        let (x, y) = (window.x_positions(), window.y_positions());
        if x.is_empty() || y.is_empty() {
            return Err(GroundFieldError::Window { x: window.x, y: window.y, spacing: window.spacing });
        }
        // ℓ: where the lower half-space takes over, and resolved by the grid
        let blend = self.profile.depth().max(4.0 * grid.x.step).max(4.0 * grid.y.step).max(2.0);
        let base = match self.profile.base() {
            Base::HalfSpace(material) => Some(material),
            Base::Rigid => None,
        };
        let far: Vec<Option<FarField>> = quantities
            .iter()
            .map(|&quantity| match base {
                Some(material) => FarField::new(&material, self.solver, self.speed, quantity).map(Some),
                None => Ok(None),
            })
            .collect::<Result<_, _>>()?;
        let near: Vec<Option<FarField>> = quantities
            .iter()
            .map(|&quantity| match self.load {
                GroundLoad::Point => {
                    FarField::new(self.profile.top(), self.solver, self.speed, quantity).map(Some)
                }
                GroundLoad::Strip { .. } => Ok(None),
            })
            .collect::<Result<_, _>>()?;

        let spectrum = |n: usize, out: &mut [Vec<Complex64>]| {
            let beta_x = grid.x.beta(n);
            self.row(beta_x, grid, quantities, blend, &far, &near, out)
        };
        let whole = (grid.y.period_count, grid.x.period_count);
        let periodic = inverse_2d(grid.x, grid.y, grid.rows, quantities.len(), whole, spectrum)?;

        let mut values = Vec::with_capacity(quantities.len());
        let (mut wrap_around, mut aliasing) = (0.0f64, 0.0f64);
        for (i, field) in periodic.iter().enumerate() {
            let mut value = Array2::from_shape_fn((y.len(), x.len()), |(row, column)| {
                field[(row * grid.thinning.0, column * grid.thinning.1)]
            });
            self.add_images(
                quantities[i],
                &mut value,
                &x,
                &y,
                blend,
                far[i].as_ref(),
                near[i].as_ref(),
                window.spacing,
            );
            let largest = value.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            wrap_around = wrap_around.max(self.border(field, grid) / largest);
            // the truncated part stands at the edges of the strip, be they in the window or not
            let anywhere = field.iter().fold(largest, |m, v| m.max(v.abs()));
            aliasing = aliasing.max(self.beyond(quantities[i], grid)? / anywhere);
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

    fn across(&self, beta_y: f64) -> f64 {
        match self.load {
            GroundLoad::Strip { half_width, .. } => sinc(beta_y * half_width),
            GroundLoad::Point => 1.0,
        }
    }

    /// One row ũ(β_x, ·) less the closed-form parts.
    #[allow(clippy::too_many_arguments)]
    fn row(
        &self,
        beta_x: f64,
        grid: &Grid,
        quantities: &[Quantity],
        blend: f64,
        far: &[Option<FarField>],
        near: &[Option<FarField>],
        out: &mut [Vec<Complex64>],
    ) -> Result<(), SoilError> {
        let force = self.force(beta_x);
        let phases = self.phases(beta_x);
        let omega = -beta_x * self.speed;
        let corner = (PI / grid.x.step).hypot(PI / grid.y.step);
        // k ≥ |β_x| in this row
        let solver = self.solver.resolving((0.99 * beta_x.abs(), corner), FIELD_ACCURACY, None);
        let ground = solver.prepare(self.profile, omega, &[])?;
        let prepared = |material| solver.prepare(&half_space(material)?, omega, &[]).map(Some);
        let base = match self.profile.base() {
            Base::HalfSpace(material) if far.iter().any(Option::is_some) => prepared(material)?,
            _ => None,
        };
        let top = if near.iter().any(Option::is_some) { prepared(*self.profile.top())? } else { None };
        let count = grid.y.period_count;
        let vertical_only =
            quantities.iter().all(|q| matches!(q, Quantity::Vertical | Quantity::VerticalVelocity));
        for m in 0..=count / 2 {
            let beta_y = grid.y.beta(m);
            // the origin itself: the mean over a small circle stands for it
            let at_origin = beta_x == 0.0 && m == 0;
            if at_origin {
                continue;
            }
            let k = beta_x.hypot(beta_y);
            let fade = (-k * blend).exp();
            let g = response(ground.as_ref(), k, vertical_only);
            let far_g =
                base.as_ref().filter(|_| fade > 1e-17).map(|b| response(b.as_ref(), k, vertical_only));
            let top_g = top.as_ref().map(|t| response(t.as_ref(), k, vertical_only));
            let load = force * self.across(beta_y);
            for (i, &quantity) in quantities.iter().enumerate() {
                // mirror in y: β_y → −β_y turns sin θ
                for (index, sin) in [(m, beta_y / k), ((count - m) % count, -beta_y / k)] {
                    let cos = beta_x / k;
                    let mut value = load * component(quantity, &g, cos, sin);
                    if let (Some(_), Some(far_g)) = (&far[i], &far_g) {
                        value -= phases * fade * component(quantity, far_g, cos, sin);
                    }
                    if let (Some(_), Some(top_g)) = (&near[i], &top_g) {
                        value -= phases * (1.0 - fade) * component(quantity, top_g, cos, sin);
                    }
                    if quantity == Quantity::VerticalVelocity {
                        value *= I * omega;
                    }
                    out[i][index] = value;
                }
            }
        }
        for (i, &quantity) in quantities.iter().enumerate() {
            // odd in β_y: the Nyquist line has no partner
            if quantity == Quantity::Across {
                out[i][count / 2] = Complex64::ZERO;
            }
            if beta_x == 0.0 {
                out[i][0] = self.origin(quantity, grid, blend, &far[i], &near[i])?;
            }
        }
        Ok(())
    }

    /// The bounded remainder at k = 0: its mean over a circle well inside the first cell.
    fn origin(
        &self,
        quantity: Quantity,
        grid: &Grid,
        blend: f64,
        far: &Option<FarField>,
        near: &Option<FarField>,
    ) -> Result<Complex64, SoilError> {
        const POINTS: usize = 64;
        let k = 1e-3 * grid.x.beta_step().min(grid.y.beta_step());
        let fade = (-k * blend).exp();
        let base = match (far, self.profile.base()) {
            (Some(_), Base::HalfSpace(material)) => Some(half_space(material)?),
            _ => None,
        };
        let top = near.as_ref().map(|_| half_space(*self.profile.top())).transpose()?;
        let sum: Complex64 = (0..POINTS)
            .map(|i| {
                let (sin, cos) = (TAU * (i as f64 + 0.5) / POINTS as f64).sin_cos();
                let omega = -k * cos * self.speed;
                let at = |profile: &Profile| {
                    let ground = self.solver.prepare(profile, omega, &[])?;
                    Ok(component(quantity, &ground.surface(k), cos, sin))
                };
                let force = if cos >= 0.0 { self.force(k * cos) } else { self.force(-k * cos).conj() };
                let mut value = force * self.across(k * sin) * at(self.profile)?;
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

    /// Adds the closed-form images of every axle.
    #[allow(clippy::too_many_arguments)]
    fn add_images(
        &self,
        quantity: Quantity,
        values: &mut Array2<f64>,
        x: &[f64],
        y: &[f64],
        blend: f64,
        far: Option<&FarField>,
        near: Option<&FarField>,
        spacing: f64,
    ) {
        use rayon::prelude::*;
        let lead = self.train.axles()[0].position;
        let columns = x.len();
        let largest = |side: &[f64]| side.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let reach = (largest(x) + self.train.length()).hypot(largest(y));
        let far = far.map(|far| far.table(blend, reach));
        // ℓ = 0: the table would have no innermost radius; the field is of degree −1 in r
        let near = near.map(|near| (near, near.table(blend, reach)));
        let image = |x: f64, y: f64| {
            let mut sum = far.as_ref().map_or(0.0, |far| far.at(x, y));
            if let Some((near, table)) = &near {
                // at the load itself the mean of 1/r over one cell: 4 ln(1 + √2)/spacing
                let at_load = x.hypot(y) < 1e-6 * spacing;
                let point = if at_load {
                    near.mean() * 4.0 * (1.0 + 2.0f64.sqrt()).ln() / (TAU * spacing)
                } else {
                    near.image(x, y, 0.0)
                };
                sum += point - table.at(x, y);
            }
            sum
        };
        // v_z = −v ∂u_z/∂x′, over a step in which the images are smooth
        let velocity = |x: f64, y: f64| {
            let r = x.hypot(y);
            // at the load itself the mean over one cell
            let step = if r < 1e-6 * spacing { 0.5 * spacing } else { 0.02 * r.min(blend) };
            -self.speed * (image(x + step, y) - image(x - step, y)) / (2.0 * step)
        };
        let Some(slice) = values.as_slice_mut() else { return };
        slice.par_chunks_mut(columns).zip(y).for_each(|(line, &y)| {
            for (value, &x) in line.iter_mut().zip(x) {
                for axle in self.train.axles() {
                    let x = x + axle.position - lead;
                    let image = match quantity {
                        Quantity::VerticalVelocity => velocity(x, y),
                        _ => image(x, y),
                    };
                    *value += axle.load * image;
                }
            }
        });
    }

    /// Largest remainder midway between the train and its images: half a period from it along x, and along y.
    fn border(&self, field: &Array2<f64>, grid: &Grid) -> f64 {
        let middle = -0.5 * self.train.length();
        let index = |axis: &Axis, position: f64| {
            (((position - axis.from) / axis.step).round() as i64).rem_euclid(axis.period_count as i64)
                as usize
        };
        let column = index(&grid.x, middle + 0.5 * grid.x.period());
        let row = index(&grid.y, 0.5 * grid.y.period());
        let along = field.column(column).iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let across = field.row(row).iter().fold(0.0f64, |m, v| m.max(v.abs()));
        along.max(across)
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
