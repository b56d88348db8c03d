//! Which waves travel along the ground by themselves, which along the track, and where do the two meet?

mod map;
mod shapes_shown;
mod shown;

use super::{Outcome, StudyError};
use crate::math::root;
use crate::progress::Observer;
use crate::railway::Ground;
use crate::soil::dispersion::{Modes, SurfaceWave, modes};
use crate::soil::mode_shape::{ModeShape, ellipticity, mode_shape};
use crate::soil::{Profile, SoilError};
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
    /// Motion over depth, where it is asked.
    pub shapes: Option<ShapesAt>,
}

/// Where mode shapes are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapesAt {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// z [m], ascending.
    pub depths: Vec<f64>,
}

/// Shapes of the modes of the undamped ground.
#[derive(Clone, Debug)]
pub struct Shapes {
    /// Where.
    pub at: ShapesAt,
    /// Those of every frequency, the slowest mode first.
    pub shapes: Vec<Vec<ModeShape>>,
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
    /// H/V of the surface in each mode of the undamped ground, positive where it turns backward; empty of Love waves.
    pub ellipticities: Vec<Vec<f64>>,
    /// Shapes of modes, where they were asked.
    pub shapes: Option<Shapes>,
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
    /// digits printed (test `papers::mezher`). Ellipticity 1e-7 (test `analytic::dispersion`).
    ///
    /// # Errors
    /// Depths outside the ground; told to stop.
    pub fn solve(
        &self,
        profile: &Profile,
        stack: Option<&Stack>,
        observer: &dyn Observer,
    ) -> Result<DispersionCurves, StudyError> {
        // a track moves the ground vertically: it has no part in waves across
        let stack = stack.filter(|_| self.wave == SurfaceWave::Rayleigh);
        let elastic = profile.with_loss_times(0.0);
        observer.begin("dispersion", self.frequencies.len() as u64);
        let found: Vec<(Modes, Vec<f64>, Option<f64>, f64)> = self
            .frequencies
            .par_iter()
            .map(|f| {
                let omega = TAU * f;
                let ground = modes(profile, self.wave, omega, self.modes);
                let turning = match self.wave {
                    SurfaceWave::Love => Vec::new(),
                    SurfaceWave::Rayleigh => {
                        let of = |k: &f64| ellipticity(&elastic, omega, *k);
                        ground.undamped.iter().map(of).collect::<Result<_, _>>()?
                    }
                };
                let track = stack.and_then(|stack| track_speed(stack, omega));
                let lead = stack.map_or(f64::NAN, |stack| lead(stack, &elastic, omega));
                observer.done()?;
                Ok((ground, turning, track, lead))
            })
            .collect::<Result<_, StudyError>>()?;
        let leads: Vec<f64> = found.iter().map(|f| f.3).collect();
        let crossing = stack.and_then(|stack| self.crossing(stack, &elastic, &leads));
        let shapes = self.shapes.as_ref().map(|at| self.shapes(&elastic, at)).transpose()?;
        observer.end();
        Ok(DispersionCurves {
            frequencies: self.frequencies.clone(),
            count: self.modes,
            wave: self.wave,
            track: found.iter().map(|f| f.2).collect(),
            ellipticities: found.iter().map(|f| f.1.clone()).collect(),
            shapes,
            grounds: found.into_iter().map(|f| f.0).collect(),
            leads,
            crossing,
            undamped: profile.is_undamped(),
        })
    }

    /// Shapes of the slowest modes of `elastic` ground.
    fn shapes(&self, elastic: &Profile, at: &ShapesAt) -> Result<Shapes, SoilError> {
        let shapes = at.frequencies.iter().map(|f| {
            let found = modes(elastic, self.wave, TAU * f, self.modes).undamped;
            found.iter().map(|k| mode_shape(elastic, self.wave, TAU * f, *k, &at.depths)).collect()
        });
        Ok(Shapes { at: at.clone(), shapes: shapes.collect::<Result<_, _>>()? })
    }

    /// Refuses depths of shapes outside the ground.
    ///
    /// # Errors
    /// `SoilError::Depth`.
    pub fn check(&self, profile: &Profile) -> Result<(), SoilError> {
        self.shapes.as_ref().map_or(Ok(()), |shapes| profile.split_at(&shapes.depths).map(|_| ()))
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
        let curves = self.solve(&ground.profile, stack, observer)?;
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
