//! The ground's surface abreast of a standing harmonic load on the rail.

use super::Channel;
use super::transfer::Transfer;
use crate::math::quadrature::{Adaptive, Tolerance, miss};
use crate::rail::{BETA_CAP, InteractionError, TrackOnFoundation};
use crate::soil::strip::sinc;
use crate::soil::{Motion, PreparedGround, Strip};
use num_complex::Complex64;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Wanted error of the integral relative to its value.
const ACCURACY: f64 = 1e-4;
/// Evaluations allowed.
const MAX_COUNT: usize = 600_000;

impl TrackOnFoundation<'_> {
    /// Displacement of the ground's surface [m/N] at distances `receivers` [m] from the centre line, abreast of a standing unit
    /// force e^{iωt}: (1/π) ∫₀^∞ k_eq ũ_base R(β; y) dβ, R the receiver integral of `ground`, prepared at `omega` ≠ 0; and the
    /// error over what was allowed, where it is largest: at most 1 where the accuracy was reached at all of them.
    ///
    /// Accuracy: 1e-4 of each (test `cross_solver::receptance`).
    ///
    /// # Errors
    /// An integral that diverges.
    pub fn ground(
        &self,
        omega: f64,
        ground: &dyn PreparedGround,
        strip: Strip,
        receivers: &[f64],
    ) -> Result<(Vec<Complex64>, f64), InteractionError> {
        let transfer = Transfer::new(self.stack, ground, strip, omega);
        let kept = RefCell::new(HashMap::new());
        let worst = Cell::new(0.0f64);
        let force = |beta: f64| {
            *kept.borrow_mut().entry(beta.to_bits()).or_insert_with(|| {
                let estimate = transfer.compliance(beta, 0.1 * ACCURACY);
                worst.set(worst.get().max(estimate.miss(ACCURACY)));
                transfer.force(beta, estimate.value) * sinc(beta * self.half_length)
            })
        };
        let mut points = vec![0.0];
        points.extend(&ground.outline().wavenumbers);
        let mut values = Vec::new();
        for &y in receivers {
            let integrand = |beta: f64| {
                let (receiver, miss) =
                    transfer.receiver(beta, Channel { y, motion: Motion::Vertical }, 0.1 * ACCURACY);
                worst.set(worst.get().max(miss));
                force(beta) * receiver
            };
            let (value, miss) = decaying(integrand, &points)?;
            worst.set(worst.get().max(miss));
            values.push(value / PI);
        }
        Ok((values, worst.get()))
    }
}

/// ∫₀^∞ of an integrand that decays beyond the last of `points`, and its error over what was allowed.
fn decaying(
    mut integrand: impl FnMut(f64) -> Complex64,
    points: &[f64],
) -> Result<(Complex64, f64), InteractionError> {
    let mut integral = Adaptive::new();
    integral.add(&mut integrand, points);
    let mut top = points[points.len() - 1];
    let left = loop {
        let next = 1.3 * top + 0.2;
        integral.add(&mut integrand, &[top, next]);
        top = next;
        let rest = integrand(top).norm() * top / 3.0;
        let left = miss(rest, 0.3 * ACCURACY * integral.value().norm());
        if left < 1.0 || top > BETA_CAP {
            break left;
        }
    };
    let tolerance = Tolerance { relative: 0.5 * ACCURACY, absolute: 0.0, max_count: MAX_COUNT };
    let estimate = integral.refine(&mut integrand, Complex64::ZERO, tolerance);
    let error = estimate.error / estimate.value.norm();
    if !estimate.converged && (error.is_nan() || error > 1e-2) {
        return Err(InteractionError::Diverges { speed: 0.0, error });
    }
    Ok((estimate.value, estimate.miss(0.5 * ACCURACY).max(left)))
}
