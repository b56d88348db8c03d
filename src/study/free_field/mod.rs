//! How much does a passing train shake the ground beside the track?
//!
//! Quasi-static part: the axle loads, constant and moving. Dynamic part: forces of the wheels on a rough rail, as the expected value
//! over all profiles of a spectrum and for single profiles; r.m.s. velocities in third octaves over the passage time T,
//!
//! ```text
//! v_rms = √( (1/π) ∫_band ω²|û|² dω / T )
//! ```
//!
//! and histories. The physics of both is that of [`crate::field`].

pub(in crate::study) mod assessed;
mod building;
mod check;
mod components;
mod dataset;
mod doubts;
mod guides;
pub(in crate::study) mod metrics;
pub(in crate::study) mod pictures;
mod profile;
mod roughness;
mod shown;

pub use assessed::{Assessment, OtherTrain, Passes};
pub use building::{Building, SOUND};
pub use components::{Components, Horizontal, OneComponent, ThreeComponents};
pub use roughness::{Carrier, Irregularity, Roughness};

use super::contour::check_memory;
use super::doubts::by_up_to;
use super::{Outcome, StudyError};
use crate::assessment::Band;
use crate::concern::Concern;
use crate::contact::{COUPLED, ContactForces, WheelRail};
use crate::field::{ConstantLoad, Pass, PassEnergy, QuasiStatic, Sections, SlowLoad, Times, pointwise};
use crate::foundation::LayeredSoil;
use crate::irregularity::{Component, random_starts};
use crate::progress::Observer;
use crate::rail::TrackOnFoundation;
use crate::railway::{Contact, Railway, RailwayError};
use crate::soil::{Profile, Solver};
use crate::vehicle::Train;
use ndarray::Array2;
use std::f64::consts::TAU;

/// Velocity of the ground's surface at some receivers during one pass.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeField {
    /// v [m/s]
    pub speed: f64,
    /// Distances from the centre line of the track [m], ascending.
    pub receivers: Vec<f64>,
    /// T [s], over which the energy of the pass is averaged; None: the train's length and twice the farthest receiver's distance,
    /// over v.
    pub passage_time: Option<f64>,
    /// Directions of the motion.
    pub components: Components,
    /// Third-octave bands, one after another.
    pub bands: Vec<Band>,
    /// None: the quasi-static part alone.
    pub roughness: Option<Roughness>,
    /// What answers for the ground across the track, many β and receivers at one ω, where exact solvers may not leave the real axis for a
    /// path lifted off the poles; None: the solver of the model. Modes do that in closed form.
    pub sections: Option<Solver>,
    /// What the motion is held against.
    pub assessment: Assessment,
    /// What a building makes of it.
    pub building: Building,
}

/// Integrals that missed their accuracy, and contact forces that could not be followed, by what factor (at most 1: reached).
fn missed(integrals: f64, forces: f64) -> Vec<Concern> {
    let integrals = (integrals > 1.0).then(|| {
        Concern::new(
            "quadrature",
            format!("wavenumber integrals of the free field missed their accuracy (1e-3) {}", by_up_to(integrals)),
            "poles lie too close to the real axis (more damping helps), or the track spreads the load too little",
        )
    });
    let forces = (forces > 1.0).then(|| {
        Concern::new(
            "contact-forces",
            format!(
                "contact forces between the frequencies asked missed 1 %, or a receptance of the rail 1e-4, {}",
                by_up_to(forces)
            ),
            "a resonance of wheels on the track is very sharp: damping of pads, ballast or ground helps",
        )
    });
    integrals.into_iter().chain(forces).collect()
}

/// Error of an integral over what was allowed, where it is largest.
fn worst_of(quasi_static: &QuasiStatic, load: &ConstantLoad, sections: Option<&Sections>) -> f64 {
    quasi_static.worst.max(load.worst()).max(sections.map_or(0.0, |sections| sections.worst))
}

impl FreeField {
    /// Third-octave energies of the pass, quasi-static, dynamic and total; its histories, and what people make of them.
    ///
    /// Accuracy: 1 % of each dynamic band, 1e-3 of the energy of quasi-static bands that are not negligible beside the largest (tests
    /// `cross_solver::free_field`, `cross_solver::passage`); histories: see [`Pass::dynamic`].
    ///
    /// # Errors
    /// No layered ground, no train, wheels that are not those of the train, a receiver on the track, undamped waves.
    pub fn solve<'a>(
        &'a self,
        railway: &'a Railway,
        observer: &dyn Observer,
    ) -> Result<PassVelocities<'a>, StudyError> {
        let pass = self.pass(self.train(railway)?);
        let passage_time =
            self.passage_time.unwrap_or((pass.train.length() + 2.0 * pass.farthest()) / self.speed);
        let times = pass.times();
        let ground = railway.ground()?;
        let (of_ground, strip) = ((&ground.profile, ground.solver), ground.strip()?);
        // each β along ω̃ − βv has its own ω
        let soil = LayeredSoil::new(ground.profile.clone(), pointwise(ground.solver), strip)?;
        let stack = railway.stack()?;
        let track = TrackOnFoundation::new(stack, &soil, 0.0);
        let quasi_static = pass.quasi_static(&track, of_ground, strip, times, observer)?;
        // loads slower than the waves on a smooth rail ask for β = ω/v alone, of the exact ground
        let fast = self.speed >= ground.profile.slowest_rayleigh_speed();
        let otherwise = self.sections.unwrap_or(ground.solver);
        let across = (&ground.profile, ground.solver, otherwise);
        let sections = || pass.sections(stack, across, strip, times.period(), observer);
        let sections = (fast || self.roughness.is_some()).then(sections).transpose()?;
        let load = match sections.as_ref().filter(|_| fast) {
            Some(sections) => ConstantLoad::Fast(sections),
            None => ConstantLoad::Slow(SlowLoad::new(&pass, stack, of_ground, strip)?),
        };
        let smooth = Shaken::on_smooth_rail(&pass, &load, &quasi_static);
        let Shaken { energies, histories, driven, forces_worst } = match (&self.roughness, &sections) {
            (Some(roughness), Some(sections)) => {
                let rough = Rough { pass, roughness, track: &track, sections, profile: &ground.profile };
                rough.shaken(smooth, times, observer)?
            }
            _ => smooth,
        };
        let worst = worst_of(&quasi_static, &load, sections.as_ref());
        let (vertical, horizontal) =
            OneComponent::split(pass.motions, (&energies, &quasi_static.velocity, &histories));
        let metrics = metrics::Metrics::of(&vertical.histories, times, &self.bands)?;
        let estimates = self.building.estimates(&vertical.histories, times)?;
        let three = ThreeComponents::of(&vertical, &metrics.measured, horizontal, times)?;
        let OneComponent { energies, quasi_static, histories, .. } = vertical;
        Ok(PassVelocities {
            study: self,
            railway,
            pass,
            passage_time,
            energies,
            quasi_static,
            histories,
            times,
            metrics,
            three,
            estimates,
            driven,
            sections: sections.as_ref().filter(|s| s.lifted()).map_or(otherwise, |_| ground.solver).name(),
            worst,
            forces_worst,
        })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let answer = self.solve(railway, observer)?;
        let mut concerns = self.concerns(railway);
        concerns.extend(self.building.concerns(&self.bands));
        concerns.extend(answer.concerns());
        concerns.extend(answer.contradictions()?);
        concerns.extend(missed(answer.worst, answer.forces_worst));
        let velocities = answer.energies.velocities(answer.passage_time)?;
        Ok(Outcome {
            group: answer.group(&velocities)?,
            figures: answer.figures(&velocities)?,
            answers: answer.answers(&velocities)?,
            concerns,
        })
    }

    /// The pass of `train`.
    fn pass<'a>(&'a self, train: &'a Train) -> Pass<'a> {
        Pass {
            speed: self.speed,
            train,
            receivers: &self.receivers,
            motions: self.components.motions(),
            bands: &self.bands,
        }
    }

    /// The axles, which are those of the bodies.
    fn train<'a>(&self, railway: &'a Railway) -> Result<&'a Train, StudyError> {
        let train = railway.train()?;
        let Some(roughness) = &self.roughness else { return Ok(train) };
        let (axles, wheels) = (train.axles(), roughness.bodies.axles());
        let apart = axles.iter().zip(wheels).any(|(a, w)| (a.position - w.position).abs() > 1e-6);
        if apart || axles.len() != wheels.len() {
            return Err(StudyError::OtherWheels { axles: axles.len(), wheelsets: wheels.len() });
        }
        Ok(train)
    }

    /// Refuses what cannot be answered before anything is computed.
    ///
    /// # Errors
    /// As `run`.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        railway.ground()?;
        let pass = self.pass(self.train(railway)?);
        railway.check_receivers(&self.receivers)?;
        railway.track()?;
        let Contact::Strip(_) = railway.ground()?.contact()? else {
            return Err(RailwayError::NoTrack.into());
        };
        let profiles = match self.roughness.as_ref().map(|r| &r.irregularity) {
            Some(Irregularity::Random { count, .. }) => *count,
            _ => 1,
        };
        // a history, and an eighth of it as complex harmonics, for each profile and channel
        let (samples, histories) = (pass.times().count, profiles * pass.channels().len());
        check_memory("histories", (samples, histories), 16 * (samples as u64) * (histories as u64))
    }
}

/// What shakes the ground, and how strongly: of a smooth rail, or of a rough one.
struct Shaken {
    energies: PassEnergy,
    /// Total velocity [m/s] of each profile, receivers × times.
    histories: Vec<Array2<f64>>,
    driven: Vec<Driven>,
    /// Error of the contact forces over what was allowed, where it is largest.
    forces_worst: f64,
}

impl Shaken {
    /// By the axle loads alone.
    fn on_smooth_rail(pass: &Pass, load: &ConstantLoad, quasi_static: &QuasiStatic) -> Self {
        Self {
            energies: PassEnergy::quasi_static(pass, load),
            histories: vec![quasi_static.velocity.clone()],
            driven: Vec::new(),
            forces_worst: 0.0,
        }
    }
}

/// Force of the leading wheelset at one driving frequency.
struct Driven {
    /// f̃ = Ωv/2π [Hz]
    frequency: f64,
    /// √ of the one-sided density [N/√Hz] on a random profile, the amplitude [N] on a given one.
    force: f64,
}

/// What the ground does beside the track during one pass.
pub struct PassVelocities<'a> {
    study: &'a FreeField,
    railway: &'a Railway,
    pass: Pass<'a>,
    /// T [s], over which energies are averaged.
    pub passage_time: f64,
    /// Energies in third octaves.
    pub energies: PassEnergy,
    /// Velocity [m/s] of the axle loads alone, positive down, receivers × times.
    pub quasi_static: Array2<f64>,
    /// Total velocity [m/s], positive down, of each profile, receivers × times.
    pub histories: Vec<Array2<f64>>,
    /// Times of the histories.
    pub times: Times,
    metrics: metrics::Metrics,
    /// Horizontal components, where they are wanted.
    pub three: Option<ThreeComponents>,
    estimates: Vec<building::Estimate>,
    driven: Vec<Driven>,
    /// Name of the solver that answered across the track.
    sections: &'static str,
    /// Error of an integral over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
    /// The same of the contact forces.
    pub forces_worst: f64,
}

/// Wheels on a rough rail.
struct Rough<'a> {
    pass: Pass<'a>,
    roughness: &'a Roughness,
    track: &'a TrackOnFoundation<'a>,
    sections: &'a Sections,
    profile: &'a Profile,
}

impl Rough<'_> {
    /// What they add to the `smooth` rail.
    fn shaken(&self, smooth: Shaken, times: Times, observer: &dyn Observer) -> Result<Shaken, StudyError> {
        let Self { pass, roughness, sections, .. } = self;
        let (speed, irregularity) = (pass.speed, &roughness.irregularity);
        let (bodies, contact) = (&roughness.bodies, &roughness.contact[..]);
        let wheels = WheelRail { track: self.track, bodies, contact, speed };
        let (least, most) = irregularity.wavenumbers();
        let range = (least, most.min(pass.heard(sections)).max(least));
        let mut forces = ContactForces::new(&wheels, range, observer)?;
        if let Irregularity::Given { profile, carrier: Carrier::Wheels { seed }, .. } = irregularity {
            let starts = random_starts(roughness.bodies.wheelset_count(), profile.repeat_length(), *seed);
            forces = forces.on_profiles_of_their_own(starts);
        }
        let at = |wavenumber: f64| forces.at(wavenumber);
        let profiles = irregularity.profiles(pass, TAU / range.1, times.period())?;
        let Shaken { mut energies, histories: quasi_static, .. } = smooth;
        let histories: Vec<_> = pass
            .dynamic(sections, &profiles, &at, times, observer)?
            .into_iter()
            .map(|dynamic| dynamic + &quasi_static[0])
            .collect();
        let frequency = |wavenumber: f64| wavenumber * speed / TAU;
        let driven = match irregularity {
            Irregularity::Random { spectrum, wavelengths, .. } => {
                let wavelengths = (TAU / range.1, wavelengths.1);
                let waves = pass.waves(spectrum, wavelengths, &at, COUPLED, self.profile);
                energies.add_expected(pass, sections, &waves, observer)?;
                let driven = waves
                    .iter()
                    .map(|w| Driven { frequency: frequency(w.wavenumber), force: w.force(speed) });
                driven.collect()
            }
            Irregularity::Given { .. } => {
                energies.add_given(pass, &histories[0], &quasi_static[0], times)?;
                let force = |c: &Component| Driven {
                    frequency: frequency(c.wavenumber),
                    force: c.amplitude * at(c.wavenumber)[0].norm(),
                };
                profiles[0].components().iter().map(force).collect()
            }
        };
        Ok(Shaken { energies, histories, driven, forces_worst: forces.worst })
    }
}
