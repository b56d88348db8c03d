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

use crate::rail::{InteractionError, TrackOnFoundation};
use crate::vehicle::Multibody;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// Distance beyond which wheels do not feel one another through rail and ground [m].
///
/// Not exactly: of eight ICE 3 at 67.5 m/s on the ballasted track of `goicolea2014_ice3_free_field`, with wheels beyond 50, 100 or
/// 150 m uncoupled, the forces in the third octave of 40 Hz, where waves behind a wheel fade least, are off by 10, 2 or 0.3 %
/// (r.m.s. over wheels), a weak one by 31, 8 or 2 %, and |Σ p_i e^{−iωa_i/v}|² in the band by 0.85, 0.25 or 0.03 %. Up to 20 Hz and
/// above 60 Hz the forces are off by 0.6 % at most with 50 m.
pub const COUPLED: f64 = 100.0;

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

/// Where wheels that feel one another stand: few different distances in a train of equal vehicles.
pub(super) struct Distances {
    /// Of wheel i from wheel j, counted in micrometres.
    between: DMatrix<i64>,
    /// Each one up to `COUPLED` once, ascending.
    different: Vec<i64>,
}

impl Distances {
    /// The different ones [m], positive ahead.
    fn different(&self) -> impl Iterator<Item = f64> {
        self.different.iter().map(|x| 1e-6 * *x as f64)
    }

    /// α_ij from α at the different distances; 0 between wheels that do not feel one another.
    pub(super) fn matrix(&self, alpha: &[Complex64]) -> DMatrix<Complex64> {
        self.between.map(|x| self.different.binary_search(&x).map_or(Complex64::ZERO, |i| alpha[i]))
    }
}

impl WheelRail<'_> {
    /// α [m/N] at ω̃ = `omega` > 0 [rad/s], wheels × wheels, and its error over what was allowed: at most 1 where the
    /// accuracy was reached.
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn rail(&self, omega: f64) -> Result<(DMatrix<Complex64>, f64), InteractionError> {
        let distances = self.distances();
        let (alpha, worst) = self.rail_at(&distances, omega)?;
        Ok((distances.matrix(&alpha), worst))
    }

    pub(super) fn distances(&self) -> Distances {
        let axles = self.bodies.axles();
        // axle j stands at x′ = −a_j
        let between = DMatrix::from_fn(axles.len(), axles.len(), |i, j| {
            (1e6 * (axles[j].position - axles[i].position)).round() as i64
        });
        let coupled = (1e6 * COUPLED) as i64;
        let mut different: Vec<i64> = between.iter().copied().filter(|x| x.abs() <= coupled).collect();
        different.sort_unstable();
        different.dedup();
        Distances { between, different }
    }

    /// α [m/N] at the different `distances`, and its error over what was allowed.
    pub(super) fn rail_at(
        &self,
        distances: &Distances,
        omega: f64,
    ) -> Result<(Vec<Complex64>, f64), InteractionError> {
        let reach = distances.different().fold(0.0, f64::max);
        let load = self.track.harmonic(omega, self.speed, reach)?;
        Ok((distances.different().map(|x| load.rail(x)).collect(), load.worst))
    }

    /// P_i [N] per metre of a profile e^{iΩx} of the rail, Ω = ω̃/v, from α at ω̃ = `omega`; NaN where the matrix is singular, which
    /// damping forbids.
    pub fn forces(&self, alpha: &DMatrix<Complex64>, omega: f64) -> Vec<Complex64> {
        let starts: Vec<f64> = self.bodies.axles().iter().map(|a| -a.position).collect();
        self.forces_from(alpha, omega, &starts)
    }

    /// The same where wheel i stands at `starts`\[i\] [m] of its profile at t = 0, as wheels do that are not round.
    pub fn forces_from(&self, alpha: &DMatrix<Complex64>, omega: f64, starts: &[f64]) -> Vec<Complex64> {
        let mut matrix = self.bodies.receptance(omega) + alpha;
        for (i, stiffness) in self.contact.iter().enumerate() {
            matrix[(i, i)] += 1.0 / stiffness;
        }
        let wavenumber = omega / self.speed;
        let profile = DVector::from_fn(starts.len(), |i, _| -Complex64::cis(wavenumber * starts[i]));
        match matrix.lu().solve(&profile) {
            Some(forces) => forces.iter().copied().collect(),
            None => vec![Complex64::new(f64::NAN, f64::NAN); starts.len()],
        }
    }
}
