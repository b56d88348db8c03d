//! Which waves travel along the ground by themselves, which along the track, and where do the two meet?

mod map;
mod shown;

use super::{Outcome, StudyError};
use crate::math::root;
use crate::progress::Observer;
use crate::railway::Ground;
use crate::soil::Profile;
use crate::soil::dispersion::{Modes, SurfaceWave, modes};
use crate::track::Stack;
use map::Compliance;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Accuracy of the crossing, relative.
const CROSSING: f64 = 1e-9;

/// The dispersion curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Dispersion {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// How many modes, the slowest first.
    pub modes: usize,
    /// Which waves.
    pub wave: SurfaceWave,
}

/// Where the free track's wave becomes faster than the ground's first mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// [Hz]
    pub frequency: f64,
    /// [m/s]
    pub speed: f64,
}

/// Trapped modes of the ground, wave of the free track, and where the two meet.
#[derive(Clone, Debug)]
pub struct DispersionCurves {
    /// f [Hz], ascending.
    pub frequencies: Vec<f64>,
    /// How many modes were asked.
    pub count: usize,
    /// Which waves.
    pub wave: SurfaceWave,
    /// The slowest modes of the damped ground at each frequency.
    pub grounds: Vec<Modes>,
    /// Phase velocity [m/s] of the undamped track without ground; None where it has no wave.
    pub track: Vec<Option<f64>>,
    /// Phase velocity [m/s] of the free track less that of the first mode of the undamped ground; NaN where one is missing.
    pub leads: Vec<f64>,
    /// Where the track's wave overtakes the ground's.
    pub crossing: Option<Crossing>,
    /// True if the ground is undamped.
    pub undamped: bool,
}

/// The phase velocity [m/s] of the free track at `omega` [rad/s].
fn track_speed(stack: &Stack, omega: f64) -> Option<f64> {
    Some(omega / stack.free_wave(omega)?)
}

/// Phase velocity [m/s] of the free track less that of the first mode of `elastic` ground; NaN where one is missing.
fn lead(stack: &Stack, elastic: &Profile, omega: f64) -> f64 {
    let ground = modes(elastic, SurfaceWave::Rayleigh, omega, 1).modes.first().copied().flatten();
    match (track_speed(stack, omega), ground) {
        (Some(track), Some(ground)) => track - ground.phase_velocity,
        _ => f64::NAN,
    }
}

impl Dispersion {
    /// Phase velocity, group velocity and attenuation of the slowest trapped modes (frequency, mode) of the ground with its
    /// damping; phase velocity of the free undamped track `stack`, as far as there is a continuous one; their crossing, both undamped,
    /// refined to 1e-9.
    ///
    /// Accuracy: that of [`modes`] and [`Stack::free_wave`]; published curves to 5e-9, crossings to 1e-7, all the
    /// digits printed (test `papers::mezher`).
    pub fn solve(
        &self,
        profile: &Profile,
        stack: Option<&Stack>,
        observer: &dyn Observer,
    ) -> DispersionCurves {
        // a track moves the ground vertically: it has no part in waves across
        let stack = stack.filter(|_| self.wave == SurfaceWave::Rayleigh);
        let elastic = profile.with_loss_times(0.0);
        observer.begin("dispersion", self.frequencies.len() as u64);
        let found: Vec<(Modes, Option<f64>, f64)> = self
            .frequencies
            .par_iter()
            .map(|f| {
                let omega = TAU * f;
                let ground = modes(profile, self.wave, omega, self.modes);
                let track = stack.and_then(|stack| track_speed(stack, omega));
                let lead = stack.map_or(f64::NAN, |stack| lead(stack, &elastic, omega));
                observer.advance();
                (ground, track, lead)
            })
            .collect();
        let leads: Vec<f64> = found.iter().map(|f| f.2).collect();
        let crossing = stack.and_then(|stack| self.crossing(stack, &elastic, &leads));
        observer.end();
        DispersionCurves {
            frequencies: self.frequencies.clone(),
            count: self.modes,
            wave: self.wave,
            track: found.iter().map(|f| f.1).collect(),
            grounds: found.into_iter().map(|f| f.0).collect(),
            leads,
            crossing,
            undamped: profile.is_undamped(),
        }
    }

    /// As [`Self::solve`], shown over the compliance of the ground.
    ///
    /// # Errors
    /// A ground that cannot answer.
    pub fn run(
        &self,
        ground: &Ground,
        stack: Option<&Stack>,
        observer: &dyn Observer,
    ) -> Result<Outcome, StudyError> {
        let curves = self.solve(&ground.profile, stack, observer);
        let compliance = Compliance::behind(&curves, ground)?;
        Ok(curves.shown(compliance))
    }

    /// The first place where the track's wave overtakes the ground's; a curve that leaps over the other does not meet it.
    fn crossing(&self, stack: &Stack, elastic: &Profile, leads: &[f64]) -> Option<Crossing> {
        let steps = leads.windows(2).zip(self.frequencies.windows(2));
        steps.filter(|(lead, _)| lead[0] <= 0.0 && lead[1] > 0.0).find_map(|(_, f)| {
            let difference = |omega| lead(stack, elastic, omega);
            let omega = root::bracketed(difference, TAU * f[0], TAU * f[1], CROSSING)?;
            let speed = track_speed(stack, omega)?;
            let met = difference(omega).abs() < 1e3 * CROSSING * speed;
            met.then_some(Crossing { frequency: omega / TAU, speed })
        })
    }
}
