//! Adaptive panels along β, standing or moving: any foundation.
//!
//! ```text
//! w(x′) = (1/2π) ∫ ũ(β, ω̃ − βv) e^{iβx′} dβ
//! ```
//!
//! On springs ũ is asked at every node, with its tail at short waves taken out, and no pole is ever looked for; on layered ground it is
//! that of [`TrackOnFoundation`], whose foundation is interpolated.

use super::uniform::Uniform;
use crate::math::complex::reciprocal;
use crate::math::quadrature::{Adaptive as Panels, Tolerance};
use crate::rail::tail::Fitted;
use crate::rail::{Answer, Drive, InteractionError, Moving, RailError, Receptance, TrackOnFoundation};
use crate::track::Tower;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Wanted of the integral on springs, relative to the answer under the load.
const ACCURACY: f64 = 1e-10;
/// What [`TrackOnFoundation`] promises for constant and for harmonic loads.
const ON_GROUND: [f64; 2] = [1e-5, 1e-4];
const MOST: usize = 3_000_000;

/// A rail on any foundation that answers by adaptive panels.
pub struct Adaptive<'a>(pub(super) Uniform<'a>);

impl Adaptive<'_> {
    fn answer(&self, drive: Drive, x: &[f64]) -> Result<Vec<Answer>, RailError> {
        self.0.check_drive(drive)?;
        let reach = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
        if let Some(tower) = self.0.springs() {
            return OnSprings { tower, drive }.answer(x, reach);
        }
        let track = TrackOnFoundation::new(self.0.stack, self.0.on, 0.0);
        let Drive { omega, speed } = drive;
        if omega == 0.0 {
            let response = track.moving(speed, reach)?;
            let error = ON_GROUND[0] * response.worst.max(1.0) * response.rail(0.0).abs();
            return Ok(x.iter().map(|x| Answer { value: response.rail(*x).into(), error }).collect());
        }
        let response = track.harmonic(omega, speed, reach)?;
        let error = ON_GROUND[1] * response.worst * response.rail(0.0).norm();
        Ok(x.iter().map(|x| Answer { value: response.rail(*x), error }).collect())
    }
}

impl Receptance for Adaptive<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let x: Vec<f64> = x.iter().map(|x| x - from).collect();
        self.answer(Drive { omega, speed: 0.0 }, &x)
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}

impl Moving for Adaptive<'_> {
    fn under(&self, drive: Drive, _phase: f64, x: &[f64]) -> Result<Vec<Answer>, RailError> {
        self.answer(drive, x)
    }
}

/// A rail on springs under one load.
struct OnSprings<'a> {
    tower: &'a Tower,
    drive: Drive,
}

impl OnSprings<'_> {
    /// ũ [m per N/m] at `beta` [rad/m].
    fn spectrum(&self, beta: f64) -> Complex64 {
        reciprocal(self.tower.stiffness((beta * beta).into(), self.drive.at(beta))[0])
    }

    /// The wavenumber [rad/m] beyond which the rail hardly moves any more: |ũ| is a hundredth of its largest.
    fn scale(&self) -> f64 {
        let beta = |i: i32| 1e-3 * 1.1f64.powi(i);
        let u = |i: i32| self.spectrum(beta(i)).norm().max(self.spectrum(-beta(i)).norm());
        let largest = (0..160).map(u).fold(0.0, f64::max);
        (0..160).rev().find(|i| u(*i) > 1e-2 * largest).map_or(1.0, beta)
    }

    fn answer(&self, x: &[f64], reach: f64) -> Result<Vec<Answer>, RailError> {
        let scale = self.scale();
        let tail = Fitted::new(&|beta| self.spectrum(beta), scale);
        let mut left = |beta: f64| (self.spectrum(beta) - tail.of(beta)) / TAU;
        let widest = 7.0 / reach.max(1.0);
        let turn = if self.drive.speed == 0.0 { f64::INFINITY } else { self.drive.omega / self.drive.speed };
        let (mut panels, mut end, mut rest) = (Panels::new(), 0.0f64, f64::INFINITY);
        let (mut step, near) = (0.01 * scale, tail.at(0.0));
        while end < 1e4 * scale && rest > 0.1 * ACCURACY * (panels.value() + near).norm() {
            let to = end + step.min(widest);
            for (from, to) in [(end, to), (-to, -end)] {
                // hysteretic loss changes its sign at ω = 0
                let ends = if from < turn && turn < to { vec![from, turn, to] } else { vec![from, to] };
                panels.add(&mut left, &ends);
            }
            (end, step) = (to, 1.5 * step);
            // beyond β at least β⁻³ of it is left; where two powers cancel, half as far tells more
            let beyond = |beta: f64| (left(beta) + left(-beta)).norm() * beta / 3.0;
            rest = if end < 4.0 * scale { f64::INFINITY } else { beyond(end).max(beyond(0.5 * end) / 8.0) };
        }
        let tolerance = Tolerance { relative: ACCURACY, absolute: 0.0, max_count: MOST };
        let estimate = panels.refine(&mut left, near, tolerance);
        let answer = (estimate.value + near).norm();
        let error = estimate.error + rest;
        if error.is_nan() || error > 1e-3 * answer {
            let speed = self.drive.speed;
            return Err(InteractionError::Diverges { speed, error: error / answer }.into());
        }
        let rule = panels.into_rule();
        Ok(x.iter()
            .map(|&x| {
                let sum: Complex64 =
                    rule.0.iter().map(|n| n.value * n.weight * Complex64::cis(n.x * x)).sum();
                Answer { value: sum + tail.at(x), error }
            })
            .collect())
    }
}
