//! The compliance of the ground over frequency and phase speed: what lies behind the curves.

use super::DispersionCurves;
use crate::railway::Ground;
use crate::soil::GroundSolver;
use crate::soil::dispersion::SurfaceWave;
use crate::study::StudyError;
use ndarray::{Array1, Array2, Axis};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Values of the map along frequency and along speed.
const GRID: (usize, usize) = (240, 240);
/// Share of the values at a frequency above which undamped ground, whose compliance has poles, is cut off.
const POLES: f64 = 0.04;

/// Moduli of the surface's compliance, relative to the largest at each frequency.
pub struct Compliance {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// c [m/s]
    pub speeds: Vec<f64>,
    /// c × f
    pub values: Array2<f64>,
}

impl Compliance {
    /// Of the ground, as wide as its `curves`; None for a single frequency.
    ///
    /// # Errors
    /// A ground that cannot answer.
    pub fn behind(
        curves: &DispersionCurves,
        Ground { profile, solver, .. }: &Ground,
    ) -> Result<Option<Self>, StudyError> {
        let (first, last) = (curves.frequencies[0], curves.frequencies[curves.frequencies.len() - 1]);
        if first == last {
            return Ok(None);
        }
        let shear = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
        let velocities =
            || curves.grounds.iter().flat_map(|g| g.modes.iter().flatten()).map(|m| m.phase_velocity);
        let slowest = velocities().fold(profile.slowest_rayleigh_speed(), f64::min);
        // on rock a mode begins infinitely fast
        let fastest = velocities().fold(0.0, f64::max).min(1.5 * shear);
        let fastest = if fastest > 0.0 { fastest } else { shear };
        let even = |low: f64, high: f64, n: usize| -> Vec<f64> {
            (0..n).map(|i| low + (high - low) * i as f64 / (n - 1) as f64).collect()
        };
        let frequencies = even(first, last, GRID.0);
        let speeds = even(0.5 * slowest, 1.3 * fastest, GRID.1);
        let columns = frequencies
            .par_iter()
            .map(|f| {
                let ground = solver.prepare(profile, TAU * f, &[])?;
                let modulus = |c: &f64| {
                    let u = ground.surface(TAU * f / c);
                    let u = if curves.wave == SurfaceWave::Love { u.u_yy } else { u.u_zz };
                    if u.is_finite() { u.norm() } else { f64::INFINITY }
                };
                Ok(relative(speeds.iter().map(modulus).collect(), curves.undamped))
            })
            .collect::<Result<Vec<_>, StudyError>>()?;
        let mut values = Array2::zeros((GRID.1, GRID.0));
        for (mut column, computed) in values.axis_iter_mut(Axis(1)).zip(columns) {
            column.assign(&Array1::from(computed));
        }
        Ok(Some(Self { frequencies, speeds, values }))
    }
}

/// `values` over their largest one, or, where there are poles, over the one that a share [`POLES`] of them exceeds.
fn relative(values: Vec<f64>, poles: bool) -> Vec<f64> {
    let mut sorted = values.clone();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len() - 1;
    let place = if poles { ((1.0 - POLES) * last as f64) as usize } else { last };
    let reference = sorted[place];
    values.into_iter().map(|v| if v < reference { v / reference } else { 1.0 }).collect()
}
