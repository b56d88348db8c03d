//! How much does a passing train shake the ground beside the track?
//!
//! Quasi-static part: the axle loads, constant and moving. Dynamic part: forces of the wheels on a rough rail, as the expected value
//! over all profiles of a spectrum and for single profiles. With h the ground's displacement per unit force on the rail,
//!
//! ```text
//! û_qs(ω) = (1/v) h(−ω/v, ω) Σ_i P_i e^{−iωa_i/v}
//! û_dyn(ω) = (1/2v) Σ_j a_j ( e^{iθ_j} H_j⁺ + e^{−iθ_j} H_j⁻ )            r(x) = Σ_j a_j cos(Ω_j x + θ_j)
//! E|û_dyn(ω)|² = ∫ ½ S(Ω) ( |H⁺|² + |H⁻|² )/v² dΩ,   H^± = h(β, ω) Σ_i P_i(±Ω) e^{iβa_i},  β = ±Ω − ω/v
//! v_rms = √( (1/π) ∫_band ω²|û|² dω / T )
//! ```

mod bands;
mod check;
mod dataset;
mod doubts;
mod guides;
mod metrics;
mod passes;
mod shown;

use super::contour::check_memory;
use super::{Outcome, StudyError};
use crate::assessment::Band;
use crate::concern::Concern;
use crate::contact::{ContactForces, WheelRail};
use crate::field::{Section, Sections};
use crate::foundation::LayeredSoil;
use crate::irregularity::{Realisation, Spectrum, random_starts};
use crate::progress::Observer;
use crate::rail::TrackOnFoundation;
use crate::railway::{Contact, Ground, Railway, RailwayError};
use crate::soil::{Profile, Solver, Strip};
use crate::vehicle::{Multibody, Train};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Accuracy of G, and the wavenumbers thin layers must resolve [rad/m].
const GROUND_ACCURACY: f64 = 1e-4;
const K_MAX: f64 = 30.0;

/// The solver for integrals whose every point has its own ω: modes would serve one point each.
fn pointwise(solver: Solver) -> Solver {
    if solver.has_modes() { Solver::DirectStiffness } else { solver }
}

/// What carries a given profile.
#[derive(Clone, Debug, PartialEq)]
pub enum Carrier {
    /// The rail: each wheel meets what the one before it met.
    Rail,
    /// Every wheel, turned by an angle of its own from this seed.
    Wheels {
        /// Of the angles.
        seed: u64,
    },
}

/// What the wheels roll over.
#[derive(Clone, Debug, PartialEq)]
pub enum Irregularity {
    /// All profiles of a spectrum, and some of them.
    Random {
        /// S(Ω)
        spectrum: Spectrum,
        /// Shortest and longest wavelength [m].
        wavelengths: (f64, f64),
        /// Seed of the first profile; the next ones count up.
        seed: u64,
        /// How many profiles; at least one.
        count: usize,
    },
    /// One profile. x = 0 of a rail is abreast of the receivers.
    Given {
        /// The profile.
        profile: Realisation,
        /// What it is, in one line.
        text: String,
        /// Of the rail, or of each wheel by itself.
        carrier: Carrier,
    },
}

impl Irregularity {
    /// What it is, in one line.
    pub fn text(&self) -> String {
        match self {
            Self::Random { spectrum, .. } => spectrum.text(),
            Self::Given { text, .. } => text.clone(),
        }
    }

    /// Smallest and largest wavenumber [rad/m].
    fn wavenumbers(&self) -> (f64, f64) {
        match self {
            Self::Random { wavelengths, .. } => (TAU / wavelengths.1, TAU / wavelengths.0),
            Self::Given { profile, .. } => profile
                .components()
                .iter()
                .fold((f64::INFINITY, 0.0), |(low, high), c| (c.wavenumber.min(low), c.wavenumber.max(high))),
        }
    }

    /// Standard deviation [m].
    fn rms(&self) -> f64 {
        match self {
            Self::Random { spectrum, wavelengths, .. } => spectrum.band_rms(wavelengths.0, wavelengths.1),
            Self::Given { profile, .. } => profile.rms(),
        }
    }
}

/// Wheels that follow a rough rail.
#[derive(Clone, Debug, PartialEq)]
pub struct Roughness {
    /// The whole train; its wheelsets stand where the axles of [`Train`] do, in their order.
    pub bodies: Multibody,
    /// k_H of each wheelset [N/m].
    pub contact: f64,
    /// The profile, or what is known of it.
    pub irregularity: Irregularity,
}

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
    /// Third-octave bands, one after another.
    pub bands: Vec<Band>,
    /// None: the quasi-static part alone.
    pub roughness: Option<Roughness>,
    /// What answers for the ground across the track, many β and receivers at one ω; None: the solver of the model. Modes do that in
    /// closed form, solvers without them by quadrature, which takes ten times as long far from the track.
    pub sections: Option<Solver>,
}

/// What the parts of the study share.
struct Pass<'a> {
    study: &'a FreeField,
    railway: &'a Railway,
    train: &'a Train,
    strip: Strip,
    /// T [s]
    passage_time: f64,
}

/// Integrals that missed their accuracy, and contact forces that could not be followed.
fn missed(converged: bool, followed: bool) -> Vec<Concern> {
    let integrals = || {
        Concern::new(
            "quadrature",
            "some wavenumber integrals of the free field missed their accuracy (1e-3)",
            "poles lie too close to the real axis (more damping helps), or the track spreads the load too little",
        )
    };
    let forces = || {
        Concern::new(
            "contact-forces",
            "contact forces between the frequencies asked are not known to 1 %, or a receptance of the rail missed 1e-4",
            "a resonance of wheels on the track is very sharp: damping of pads, ballast or ground helps",
        )
    };
    (!converged).then(integrals).into_iter().chain((!followed).then(forces)).collect()
}

impl FreeField {
    /// Third-octave r.m.s. velocities of the pass, quasi-static, dynamic and total; its histories, and what people make of them.
    ///
    /// Accuracy: 1 % of each dynamic band, 1e-3 of the energy of quasi-static bands that are not negligible beside the largest (tests
    /// `cross_solver::free_field`, `cross_solver::passage`); histories: see `passes`.
    ///
    /// # Errors
    /// No layered ground, no train, wheels that are not those of the train, a receiver on the track, undamped waves.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let train = self.train(railway)?;
        let strip = railway.ground()?.strip()?;
        let passage_time = self.passage_time.unwrap_or((train.length() + 2.0 * self.farthest()) / self.speed);
        let pass = Pass { study: self, railway, train, strip, passage_time };
        let times = pass.times();
        let Ground { profile, solver, .. } = railway.ground()?;
        // each β along ω̃ − βv has its own ω
        let soil = LayeredSoil::new(profile.clone(), pointwise(*solver), strip)?;
        let track = TrackOnFoundation::new(railway.stack(), &soil, 0.0);
        let quasi_static = pass.quasi_static(&track, times, observer)?;
        // loads slower than the waves on a smooth rail ask for β = ω/v alone, of the exact ground
        let fast = self.speed >= profile.slowest_rayleigh_speed();
        let sections =
            if fast || self.roughness.is_some() { Some(pass.sections(times, observer)?) } else { None };
        let energies = bands::Energies::quasi_static(&pass, sections.as_ref().filter(|_| fast))?;
        let met = sections.as_ref().is_none_or(|sections| sections.converged);
        let converged = quasi_static.converged && met && energies.converged;
        let smooth = Shaken {
            energies,
            histories: vec![quasi_static.velocity.clone()],
            driven: Vec::new(),
            followed: true,
        };
        let Shaken { energies, histories, driven, followed } = match (&self.roughness, &sections) {
            (Some(roughness), Some(sections)) => {
                pass.shaken(smooth, roughness, (&track, sections), times, observer)?
            }
            _ => smooth,
        };
        let metrics = metrics::Metrics::of(&histories, times)?;
        let answer = Answered {
            pass: &pass,
            energies,
            quasi_static,
            histories,
            times,
            metrics,
            driven,
            sections: pass.ground()?.1.name(),
        };
        let mut concerns = self.concerns(railway);
        concerns.extend(answer.concerns());
        concerns.extend(answer.contradictions()?);
        concerns.extend(missed(converged, followed));
        let velocities = answer.energies.velocities(passage_time)?;
        Ok(Outcome {
            group: answer.group(&velocities),
            figures: answer.figures(&velocities),
            answers: answer.answers(&velocities)?,
            concerns,
        })
    }

    /// [m]
    fn farthest(&self) -> f64 {
        self.receivers.iter().copied().fold(0.0, f64::max)
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
        self.train(railway)?;
        railway.check_receivers(&self.receivers)?;
        railway.track()?;
        let Contact::Strip(strip) = railway.ground()?.contact()? else {
            return Err(RailwayError::NoTrack.into());
        };
        let pass = Pass { study: self, railway, train: railway.train()?, strip, passage_time: 1.0 };
        let profiles = match self.roughness.as_ref().map(|r| &r.irregularity) {
            Some(Irregularity::Random { count, .. }) => *count,
            _ => 1,
        };
        // a history, and an eighth of it as complex harmonics, for each profile and receiver
        let (samples, histories) = (pass.times().count, profiles * self.receivers.len());
        check_memory("histories", (samples, histories), 16 * (samples as u64) * (histories as u64))
    }
}

/// What shakes the ground, and how strongly: of a smooth rail, or of a rough one.
struct Shaken {
    energies: bands::Energies,
    /// Total velocity [m/s] of each profile, receivers × times.
    histories: Vec<ndarray::Array2<f64>>,
    driven: Vec<Driven>,
    /// False where the contact forces are not known well enough.
    followed: bool,
}

/// Force of the leading wheelset at one driving frequency.
struct Driven {
    /// f̃ = Ωv/2π [Hz]
    frequency: f64,
    /// √ of the one-sided density [N/√Hz] on a random profile, the amplitude [N] on a given one.
    force: f64,
}

/// All that was computed.
struct Answered<'a> {
    pass: &'a Pass<'a>,
    energies: bands::Energies,
    quasi_static: passes::QuasiStatic,
    /// Total velocity [m/s] of each profile, receivers × times.
    histories: Vec<ndarray::Array2<f64>>,
    times: passes::Times,
    metrics: metrics::Metrics,
    driven: Vec<Driven>,
    /// Name of the solver that answered across the track.
    sections: &'static str,
}

impl Pass<'_> {
    /// What wheels on a rough rail add to the `smooth` one.
    fn shaken(
        &self,
        smooth: Shaken,
        roughness: &Roughness,
        (track, sections): (&TrackOnFoundation, &Sections),
        times: passes::Times,
        observer: &dyn Observer,
    ) -> Result<Shaken, StudyError> {
        let speed = self.study.speed;
        let contact = vec![roughness.contact; roughness.bodies.wheelset_count()];
        let wheels = WheelRail { track, bodies: &roughness.bodies, contact: &contact, speed };
        // shorter waves make nothing that reaches a receiver within the bands: |Ω − ω/v| is too large
        let highest = self.study.bands.iter().map(|band| band.upper()).fold(0.0, f64::max);
        let heard = TAU * highest / speed + sections.reach();
        let (least, most) = roughness.irregularity.wavenumbers();
        let range = (least, most.min(heard).max(least));
        let mut forces = ContactForces::new(&wheels, range, observer)?;
        if let Irregularity::Given { profile, carrier: Carrier::Wheels { seed }, .. } =
            &roughness.irregularity
        {
            let starts = random_starts(roughness.bodies.wheelset_count(), profile.repeat_length(), *seed);
            forces = forces.on_profiles_of_their_own(starts);
        }
        let profiles = self.profiles(&roughness.irregularity, TAU / range.1, times)?;
        let Shaken { mut energies, histories: quasi_static, .. } = smooth;
        let histories: Vec<_> = self
            .dynamic(sections, &forces, &profiles, times, observer)
            .into_iter()
            .map(|dynamic| dynamic + &quasi_static[0])
            .collect();
        let driven = match &roughness.irregularity {
            Irregularity::Random { spectrum, wavelengths, .. } => {
                let wavelengths = (TAU / range.1, wavelengths.1);
                let components = self.components(spectrum, wavelengths, &forces);
                energies.add_expected(self, sections, &components, observer);
                components.into_iter().map(|c| c.driven(speed)).collect()
            }
            Irregularity::Given { .. } => {
                energies.add_given(self, &histories[0], &quasi_static[0], times)?;
                let force = |c: &crate::irregularity::Component| Driven {
                    frequency: c.wavenumber * speed / TAU,
                    force: c.amplitude * forces.at(c.wavenumber)[0].norm(),
                };
                profiles[0].components().iter().map(force).collect()
            }
        };
        Ok(Shaken { energies, histories, driven, followed: forces.converged })
    }

    /// Sections of the ground from the lowest frequency of the histories to the upper end of the bands.
    fn sections(&self, times: passes::Times, observer: &dyn Observer) -> Result<Sections, StudyError> {
        let (profile, solver) = self.ground()?;
        let bands = &self.study.bands;
        let lowest = bands.iter().map(|b| b.lower()).fold(1.0 / times.period(), f64::min);
        let highest = bands.iter().map(|b| b.upper()).fold(0.0, f64::max);
        let slowest = profile.slowest_rayleigh_speed();
        let section = |omega: f64| {
            let ground = solver.prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)?;
            Ok(Section::new(self.railway.stack(), ground.as_ref(), self.strip, omega, &self.study.receivers))
        };
        let range = (TAU * lowest, TAU * highest);
        Sections::new(range, &self.study.receivers, 1.0 / slowest, section, observer)
    }

    /// The ground and what answers for it across the track.
    fn ground(&self) -> Result<(&Profile, Solver), StudyError> {
        let Ground { profile, solver, .. } = self.railway.ground()?;
        Ok((profile, self.study.sections.unwrap_or(*solver)))
    }

    /// e^{−iωa_i/v} for ω = `omega`, a_i from the leading axle.
    fn phases(&self, omega: f64) -> Vec<Complex64> {
        let lead = self.train.axles()[0].position;
        let phase = |position: f64| Complex64::cis(-omega * (position - lead) / self.study.speed);
        self.train.axles().iter().map(|a| phase(a.position)).collect()
    }
}
