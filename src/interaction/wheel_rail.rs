//! Wheels on a rough rail: contact forces at driving frequency ω̃ = Ωv.
//!
//! Over a profile r = e^{iΩx} wheel i, a_i behind the first, meets r_i = e^{−iΩa_i}, and linear contact gives
//!
//! ```text
//! (A + α + I/k_H) P(ω̃) = −r,   α_ij = α(a_j − a_i; ω̃)
//! ```
//!
//! with A the receptance of the vehicle at its wheels and α that of the rail in the moving frame.
//!
//! Source: Lamprea-Pineda et al. 2022, Eqs 85–87.

use super::{InteractionError, TrackOnFoundation};
use crate::vehicle::Multibody;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// Distance beyond which wheels do not feel one another through rail and ground [m].
pub const COUPLED: f64 = 50.0;

/// A train of bodies on a track, at one speed.
pub struct WheelRail<'a> {
    /// The track.
    pub track: &'a TrackOnFoundation<'a>,
    /// What stands on the wheels, and where they are.
    pub bodies: &'a Multibody,
    /// k_H of each wheelset [N/m].
    pub contact: &'a [f64],
    /// v > 0 [m/s]
    pub speed: f64,
}

impl WheelRail<'_> {
    /// α [m/N] at ω̃ = `omega` > 0 [rad/s], wheels × wheels, and whether its accuracy was met.
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn rail(&self, omega: f64) -> Result<(DMatrix<Complex64>, bool), InteractionError> {
        let axles = self.bodies.axles();
        let at = |i: usize| axles[i].position - axles[0].position;
        let length = (0..axles.len()).map(|i| at(i).abs()).fold(0.0, f64::max);
        let load = self.track.harmonic(omega, self.speed, length.min(COUPLED))?;
        // axle j stands at x′ = −a_j
        let alpha = DMatrix::from_fn(axles.len(), axles.len(), |i, j| {
            let x = at(j) - at(i);
            if x.abs() > COUPLED { Complex64::ZERO } else { load.rail(x) }
        });
        Ok((alpha, load.converged))
    }

    /// P_i [N] per metre of a profile e^{iΩx}, Ω = ω̃/v, from α at ω̃ = `omega`; NaN where the matrix is singular, which damping
    /// forbids.
    pub fn forces(&self, alpha: &DMatrix<Complex64>, omega: f64) -> Vec<Complex64> {
        let axles = self.bodies.axles();
        let mut matrix = self.bodies.receptance(omega) + alpha;
        for (i, stiffness) in self.contact.iter().enumerate() {
            matrix[(i, i)] += 1.0 / stiffness;
        }
        let wavenumber = omega / self.speed;
        let profile = DVector::from_fn(axles.len(), |i, _| -Complex64::cis(-wavenumber * axles[i].position));
        match matrix.lu().solve(&profile) {
            Some(forces) => forces.iter().copied().collect(),
            None => vec![Complex64::new(f64::NAN, f64::NAN); axles.len()],
        }
    }
}
