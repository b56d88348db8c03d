//! What is asked of the ground's field, quantity, window and load, and the grid of the transform that follows from it.

use crate::math::decimal::arithmetic;
use crate::math::fourier::Axis;
use crate::soil::strip::sinc;
use ndarray::Array2;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::PI;

/// What is wanted of the ground's surface.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
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

    /// Whether u_zz alone answers it.
    pub(super) fn is_vertical(self) -> bool {
        matches!(self, Self::Vertical | Self::VerticalVelocity)
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
        arithmetic(side.0, self.spacing, count)
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

impl GroundLoad<'_> {
    /// Spectrum across the track at `beta_y` [rad/m] for a unit load.
    pub(super) fn across(&self, beta_y: f64) -> f64 {
        match self {
            Self::Strip { half_width, .. } => sinc(beta_y * half_width),
            Self::Point => 1.0,
        }
    }
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
    /// The grid for `window`: fine enough for the strip's edges, with periods that leave `clearance` [m], the distance over
    /// which waves fade, between the window and its images, for a train of `length` [m].
    pub fn new(window: &Window, load: &GroundLoad, length: f64, clearance: f64) -> Self {
        let (half_width, beta_max) = match *load {
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
        Self { x, y, thinning: (across as usize, along as usize), rows }
    }

    /// Memory of the transform for `fields` quantities [bytes].
    pub fn bytes(&self, fields: usize) -> u64 {
        let columns = self.y.period_count as f64;
        let spectrum = 16.0 * self.rows as f64 * columns;
        let result = 8.0 * self.x.period_count as f64 * columns;
        // a conversion from f64 stops at the largest u64
        (fields as f64 * (spectrum + result)) as u64
    }

    /// Largest remainder of a whole `field` midway between a train of `length` [m] and its images: half a period from it
    /// along x, and along y.
    pub(super) fn remainder(&self, field: &Array2<f64>, length: f64) -> f64 {
        let middle = -0.5 * length;
        let index = |axis: &Axis, position: f64| {
            (((position - axis.from) / axis.step).round() as i64).rem_euclid(axis.period_count as i64)
                as usize
        };
        let column = index(&self.x, middle + 0.5 * self.x.period());
        let row = index(&self.y, 0.5 * self.y.period());
        let along = field.column(column).iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let across = field.row(row).iter().fold(0.0f64, |m, v| m.max(v.abs()));
        along.max(across)
    }
}
