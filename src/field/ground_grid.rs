//! What is asked of the ground's field, quantity, window and load, and the grid of the transform that follows from it.

use crate::math::decimal::arithmetic;
use crate::math::fourier::Axis;
use crate::soil::strip::sinc;
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
    /// How many positions there are along a side.
    fn count(&self, side: (f64, f64)) -> usize {
        ((side.1 - side.0) / self.spacing + 1e-9).floor() as usize + 1
    }

    /// How many columns and rows there are.
    pub fn counts(&self) -> (usize, usize) {
        (self.count(self.x), self.count(self.y))
    }

    /// Positions along one side.
    fn positions(&self, side: (f64, f64)) -> Vec<f64> {
        arithmetic(side.0, self.spacing, self.count(side))
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
    /// b [m]; 0 of a point.
    pub(super) fn half_width(&self) -> f64 {
        match self {
            Self::Strip { half_width, .. } => *half_width,
            Self::Point => 0.0,
        }
    }

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
        let thinning = (across as usize, along as usize);
        let x = Axis::new(window.x.0, window.spacing, reach_x + clearance).refined(thinning.1);
        let y = Axis::new(window.y.0, window.spacing, reach_y + clearance).refined(thinning.0);
        let rows = ((beta_max / x.beta_step()).ceil() + 1.0).min((x.period_count / 2 + 1) as f64) as usize;
        Self { x, y, thinning, rows }
    }

    /// Memory of one transform for `fields` quantities and of their `values` (x, y) at so many `speeds` [bytes].
    pub fn bytes(&self, fields: usize, values: (usize, usize), speeds: usize) -> u64 {
        let columns = self.x.period_count / self.thinning.1;
        let line = 16.0 * self.rows as f64 + 8.0 * columns as f64;
        let kept = 8.0 * values.0 as f64 * speeds as f64;
        // a conversion from f64 stops at the largest u64
        (fields as f64 * values.1 as f64 * (line + kept)) as u64
    }

    /// Number of the kept column next to `x` [m], which may lie in another period.
    pub(super) fn column(&self, x: f64) -> usize {
        kept(&self.x, self.thinning.1, x)
    }

    /// Number of the kept line next to `y` [m].
    pub(super) fn line(&self, y: f64) -> usize {
        kept(&self.y, self.thinning.0, y)
    }
}

/// Number of the position next to `position` [m] among every `thinning`-th of an axis.
fn kept(axis: &Axis, thinning: usize, position: f64) -> usize {
    let number = (position - axis.from) / (axis.step * thinning as f64);
    (number.round() as i64).rem_euclid((axis.period_count / thinning) as i64) as usize
}
