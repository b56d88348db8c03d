//! A train passing receivers beside the track, and what answers for the ground on its way.

use super::{Channel, Section, Sections};
use crate::assessment::Band;
use crate::foundation::FoundationError;
use crate::progress::Observer;
use crate::rail::InteractionError;
use crate::soil::{GroundSolver, Motion, Profile, Solver, Strip};
use crate::track::Stack;
use crate::vehicle::Train;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Accuracy of G, and the wavenumbers thin layers must resolve [rad/m].
const GROUND_ACCURACY: f64 = 1e-4;
const K_MAX: f64 = 30.0;

/// A train at constant speed past receivers abreast of x = 0, heard in third octaves.
#[derive(Clone, Copy, Debug)]
pub struct Pass<'a> {
    /// v > 0 [m/s]
    pub speed: f64,
    /// The axles; the leading one is abreast of the receivers at t = 0.
    pub train: &'a Train,
    /// Distances of the receivers from the centre line of the track [m], beyond its strip.
    pub receivers: &'a [f64],
    /// What of their motion is wanted.
    pub motions: &'a [Motion],
    /// Bands, one after another.
    pub bands: &'a [Band],
}

/// The solver for integrals whose every point has its own ω: modes would serve one point each.
pub fn pointwise(solver: Solver) -> Solver {
    if solver.has_modes() { Solver::DirectStiffness } else { solver }
}

impl Pass<'_> {
    /// Every motion of every receiver: all receivers for one motion, then for the next.
    pub fn channels(&self) -> Vec<Channel> {
        Channel::all(self.receivers, self.motions)
    }

    /// Distance of the farthest receiver [m].
    pub fn farthest(&self) -> f64 {
        self.receivers.iter().copied().fold(0.0, f64::max)
    }

    /// Upper end of the highest band [Hz].
    pub fn highest(&self) -> f64 {
        self.bands.iter().map(|band| band.upper()).fold(0.0, f64::max)
    }

    /// e^{−iωa_i/v} for ω = `omega` [rad/s], a_i the distance of axle i behind the leading one.
    pub fn phases(&self, omega: f64) -> Vec<Complex64> {
        let lead = self.train.axles()[0].position;
        let phase = |position: f64| Complex64::cis(-omega * (position - lead) / self.speed);
        self.train.axles().iter().map(|a| phase(a.position)).collect()
    }

    /// Largest wavenumber Ω of a profile [rad/m] whose forces reach a receiver within the bands: of shorter waves |Ω − ω/v| is too
    /// large for any of the `sections`.
    pub fn heard(&self, sections: &Sections) -> f64 {
        TAU * self.highest() / self.speed + sections.reach()
    }

    /// h(β, ω) of the channels of `stack` on the `strip` of a ground and its solver, on paths lifted off the poles, by the solver
    /// `otherwise` where they may not be taken; from the lowest frequency of histories of
    /// `period` [s], or of the bands, to the upper end of the bands.
    ///
    /// Accuracy: as [`Sections::new`].
    ///
    /// # Errors
    /// A ground that cannot answer; told to stop.
    pub fn sections(
        &self,
        stack: &Stack,
        (profile, solver, otherwise): (&Profile, Solver, Solver),
        strip: Strip,
        period: f64,
        observer: &dyn Observer,
    ) -> Result<Sections, InteractionError> {
        let lowest = self.bands.iter().map(|b| b.lower()).fold(1.0 / period, f64::min);
        let channels = self.channels();
        let section = |omega: f64| -> Result<_, InteractionError> {
            let exact = pointwise(solver).prepare(profile, omega, &[]).map_err(FoundationError::from)?;
            if !solver.has_modes()
                && let Some(section) = Section::lifted(stack, exact.as_ref(), strip, omega, &channels)
            {
                return Ok(section);
            }
            let ground = otherwise
                .prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)
                .map_err(FoundationError::from)?;
            Ok(Section::new(stack, (ground.as_ref(), exact.as_ref()), strip, omega, &channels))
        };
        let (range, slowest) = ((TAU * lowest, TAU * self.highest()), profile.slowest_rayleigh_speed());
        Sections::new(range, &channels, 1.0 / slowest, section, observer)
    }
}
