//! How long a track and which steps a passage needs, and what its wheels roll over.

use super::settings::{Passage, Running, Step};
use crate::irregularity::{Defect, Realisation, Unevenness, random_starts};
use crate::rail::fem::reach;
use crate::railway::{Railway, RailwayError};
use crate::study::{Carrier, Irregularity, StudyError};
use std::f64::consts::TAU;

/// Least track beyond both ends of the way of the axles [m]: moving loads are then known to 1e-5, below critical speeds.
const MARGIN: f64 = 18.0;
/// What of a moving load may be felt at the ends, and the longest track that is added for it at each [m].
const FELT: f64 = 1e-5;
const LONGEST_MARGIN: f64 = 300.0;
/// The same where something strikes: 100 bays, from whose ends 0.4 % of the static load returns.
const STRUCK_MARGIN: f64 = 30.0;
/// v Δt [m] at corners, where impacts are known to 1e-3.
const CORNER: f64 = 0.5e-3;
/// Steps in the shortest wave of a profile: its force is known to 9/n² of the static load.
const PER_WAVE: f64 = 100.0;
/// Steps in the shortest period of interest: periods are known to 0.8 %.
const PER_PERIOD: f64 = 20.0;
/// Longest step [s] that is chosen.
const LONGEST: f64 = 1e-4;
/// Elements in the shortest bending wave of interest: its receptance is known to 1e-3.
const PER_BENDING_WAVE: f64 = 6.0;
/// Elements in a bay below which a wheel on a smooth rail feels them, by more than 5 N of 75 kN.
const ROLLED: usize = 4;

/// What one speed takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    /// Ends of the track [m], before it is rounded to whole bays.
    pub track: (f64, f64),
    /// Δt [s]
    pub step: f64,
    /// How many.
    pub count: usize,
}

/// The length over which a defect changes as fast as a step must follow [m].
fn detail(defect: &Defect) -> f64 {
    match defect {
        Defect::Dip(dip) => (dip.length() / PER_WAVE).max(CORNER),
        _ => CORNER,
    }
}

impl Running {
    /// Longest v Δt [m] that follows what the wheels roll over.
    fn followed(&self) -> f64 {
        let wave = match &self.irregularity {
            Some(irregularity) => TAU / irregularity.wavenumbers().1 / PER_WAVE,
            None => f64::INFINITY,
        };
        self.defects.iter().map(|(defect, ..)| detail(defect)).fold(wave, f64::min)
    }

    /// The irregularity on a way of `length` [m].
    pub(super) fn waves(&self, length: f64) -> Result<Unevenness, StudyError> {
        let count = self.bodies.wheelset_count();
        let mut all = Unevenness::default();
        match &self.irregularity {
            None => {}
            Some(Irregularity::Random { spectrum, wavelengths, seed, .. }) => {
                // it does not repeat on the way; eight components at least below twice the lowest wavenumber
                let components = length.max(8.0 * wavelengths.1) / wavelengths.0;
                let profile = Realisation::of(spectrum, *wavelengths, components.ceil() as usize, *seed)?;
                all = all.in_rail(profile, 0.0);
            }
            Some(Irregularity::Given { profile, carrier: Carrier::Rail, .. }) => {
                all = all.in_rail(profile.clone(), 0.0);
            }
            Some(Irregularity::Given { profile, carrier: Carrier::Wheels { seed }, .. }) => {
                let starts = random_starts(count, profile.repeat_length(), *seed);
                for (wheel, start) in starts.into_iter().enumerate() {
                    all = all.on_wheel(wheel, profile.clone(), -start);
                }
            }
        }
        Ok(all)
    }

    /// The defects.
    pub(super) fn dents(&self) -> Unevenness {
        let mut all = Unevenness::default();
        for (defect, at, wheels) in &self.defects {
            if wheels.is_empty() {
                all = all.in_rail(*defect, *at);
            }
            for &wheel in wheels {
                all = all.on_wheel(wheel, *defect, *at);
            }
        }
        all
    }
}

impl Passage {
    /// Whether something strikes, and waves that return from the ends of the track are felt.
    pub(super) fn strikes(&self) -> bool {
        let defects = self.running.iter().flat_map(|running| &running.defects);
        !self.hanging.is_empty() || defects.into_iter().any(|(defect, ..)| !matches!(defect, Defect::Dip(_)))
    }

    /// Track that is wanted beyond both ends of the way of the axles at `speed` [m]: until the waves of a moving load have decayed, and
    /// more where something strikes.
    ///
    /// # Errors
    /// A track on ground.
    pub(super) fn margin(&self, railway: &Railway, speed: f64) -> Result<f64, RailwayError> {
        let decayed = reach(railway.layout(), railway.springs()?, speed, FELT).min(LONGEST_MARGIN);
        Ok(decayed.max(if self.strikes() { STRUCK_MARGIN } else { MARGIN }))
    }

    /// Longest Δt [s] at `speed` [m/s] that follows profiles and frequencies.
    pub(super) fn wanted_step(&self, speed: f64) -> f64 {
        let followed = self.running.as_ref().map_or(f64::INFINITY, Running::followed);
        (followed / speed).min(1.0 / (PER_PERIOD * self.frequencies.1))
    }

    /// Elements per `bay` [m] that follow the bending waves of a rail of EI/m = `ratio` [m⁴/s²]: λ = 2π (EI/m)^{1/4}/√ω.
    pub(super) fn wanted_elements(&self, bay: f64, ratio: f64) -> usize {
        let wave = TAU * ratio.powf(0.25) / (TAU * self.frequencies.1).sqrt();
        let least = if self.running.is_some() { ROLLED } else { 1 };
        ((PER_BENDING_WAVE * bay / wave).ceil() as usize).max(least)
    }

    /// What `speed` [m/s] takes of `railway`.
    ///
    /// # Errors
    /// No train, a track on ground.
    pub(super) fn plan(&self, railway: &Railway, speed: f64) -> Result<Plan, StudyError> {
        let (from, to) = self.run;
        let (length, margin) = (railway.train()?.length(), self.margin(railway, speed)?);
        let track = self.track.unwrap_or((from - length - margin, to + margin));
        let time = (to - from) / speed;
        // decimals of the file: a whole number of steps is one
        let given = |step: f64| (step, ((time / step) * (1.0 + 1e-12)).floor().max(1.0) as usize);
        let (step, count) = match self.step {
            Step::Time(step) => given(step),
            Step::Length(length) => given(length / speed),
            Step::Chosen => {
                let count = (time / self.wanted_step(speed).min(LONGEST)).ceil();
                (time / count, count as usize)
            }
        };
        Ok(Plan { track, step, count })
    }
}
