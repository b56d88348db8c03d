//! The railway a case describes: ground or springs, track, train.

use super::{StudyError, speed_text};
use crate::concern::Concern;
use crate::foundation::{Foundation, FoundationError, LayeredSoil, Springs};
use crate::rail::TrackOnFoundation;
use crate::soil::{Base, Compatibility, Profile, Solver, Strip};
use crate::track::Stack;
use crate::vehicle::Train;

/// How the track, or the load without a track, touches the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// A track over a strip.
    Strip(Strip),
    /// No track: every axle presses on a rectangle of 2 × `half_length` along the track and the strip's width.
    Patch {
        /// [m]
        half_length: f64,
        /// Width and compatibility.
        strip: Strip,
    },
    /// No track: every axle is a point load on the ground.
    Point,
}

impl Contact {
    /// The loaded strip; None for a point.
    pub fn strip(&self) -> Option<Strip> {
        match self {
            Self::Strip(strip) | Self::Patch { strip, .. } => Some(*strip),
            Self::Point => None,
        }
    }

    /// Half-length of the load along the track [m].
    pub fn half_length(&self) -> f64 {
        match self {
            Self::Patch { half_length, .. } => *half_length,
            _ => 0.0,
        }
    }

    /// Name of the compatibility: `centre`, `mean`.
    pub fn compatibility(&self) -> &'static str {
        match self.strip().map(|s| s.compatibility) {
            Some(Compatibility::Centre) => "centre",
            Some(Compatibility::Mean) => "mean",
            None => "point",
        }
    }
}

/// What carries the track.
#[derive(Clone, Debug, PartialEq)]
pub enum Support {
    /// Layered ground with its solver.
    Ground(Profile, Solver),
    /// Springs.
    Springs(Springs),
}

/// Ground, track and train, checked.
#[derive(Debug)]
pub struct Model {
    support: Support,
    contact: Contact,
    stack: Stack,
    train: Option<Train>,
    foundation: Option<FoundationChoice>,
}

/// The built foundation; None for a point load.
#[derive(Debug)]
enum FoundationChoice {
    Ground(LayeredSoil),
    Springs(Springs),
}

impl Model {
    /// A model from its parts.
    ///
    /// # Errors
    /// A contact width that is not positive.
    pub fn new(
        support: Support,
        contact: Contact,
        stack: Stack,
        train: Option<Train>,
    ) -> Result<Self, StudyError> {
        let foundation = match (&support, contact.strip()) {
            (Support::Springs(springs), _) => Some(FoundationChoice::Springs(springs.clone())),
            (Support::Ground(profile, solver), Some(strip)) => {
                Some(FoundationChoice::Ground(LayeredSoil::new(profile.clone(), *solver, strip)?))
            }
            (Support::Ground(..), None) => None,
        };
        Ok(Self { support, contact, stack, train, foundation })
    }

    /// The same track, train and profile with another `solver` of the ground; on springs nothing changes.
    ///
    /// # Errors
    /// None that the model itself did not have.
    pub fn with_solver(&self, solver: Solver) -> Result<Self, StudyError> {
        let support = match &self.support {
            Support::Ground(profile, _) => Support::Ground(profile.clone(), solver),
            Support::Springs(springs) => Support::Springs(springs.clone()),
        };
        Self::new(support, self.contact, self.stack.clone(), self.train.clone())
    }

    /// What carries the track.
    pub fn support(&self) -> &Support {
        &self.support
    }

    /// How it touches the ground.
    pub fn contact(&self) -> &Contact {
        &self.contact
    }

    /// The track without what it stands on; empty for loads straight on the ground.
    pub fn stack(&self) -> &Stack {
        &self.stack
    }

    /// The foundation k(β, ω).
    ///
    /// # Errors
    /// A point load has none.
    pub fn foundation(&self) -> Result<&dyn Foundation, StudyError> {
        match &self.foundation {
            Some(FoundationChoice::Ground(soil)) => Ok(soil),
            Some(FoundationChoice::Springs(springs)) => Ok(springs),
            None => Err(StudyError::PointLoad),
        }
    }

    /// The track on its foundation.
    ///
    /// # Errors
    /// A point load on the ground deflects without end.
    pub fn track(&self) -> Result<TrackOnFoundation<'_>, StudyError> {
        Ok(TrackOnFoundation::new(&self.stack, self.foundation()?, self.contact.half_length()))
    }

    /// The layered ground, wanted by `study`.
    ///
    /// # Errors
    /// The model stands on springs.
    pub fn ground(&self, study: &'static str) -> Result<(&Profile, Solver), StudyError> {
        match &self.support {
            Support::Ground(profile, solver) => Ok((profile, *solver)),
            Support::Springs(_) => Err(StudyError::NeedsGround { study }),
        }
    }

    /// Refuses receivers, at `distances` [m] from the centre line, without layered ground or on the track.
    ///
    /// # Errors
    /// `NeedsGround`, `OnTrack`.
    pub fn receivers(&self, distances: &[f64]) -> Result<(), StudyError> {
        self.ground("of receivers")?;
        let half_width = self.contact.strip().map_or(0.0, |s| s.half_width);
        match distances.iter().find(|y| y.abs() <= half_width) {
            Some(&distance) => Err(StudyError::OnTrack { distance, half_width }),
            None => Ok(()),
        }
    }

    /// Refuses phase speeds [m/s] at which undamped ground has a wave, and the integral over wavenumbers no value.
    ///
    /// # Errors
    /// `FoundationError::Undamped` for the largest of `phase_speeds`.
    pub fn check_damping(&self, phase_speeds: impl Iterator<Item = f64>) -> Result<(), StudyError> {
        let Support::Ground(profile, _) = &self.support else { return Ok(()) };
        let phase_speed = phase_speeds.map(f64::abs).fold(0.0, f64::max);
        let slowest = profile.slowest_rayleigh_speed();
        if profile.is_undamped() && phase_speed >= slowest {
            return Err(FoundationError::Undamped { phase_speed, slowest }.into());
        }
        Ok(())
    }

    /// A concern if a load at `speed` [m/s] outruns every shear wave of the ground: only far-reaching Mach waves are left.
    pub fn outruns_waves(&self, speed: f64) -> Option<Concern> {
        let Support::Ground(profile, _) = &self.support else { return None };
        let fastest = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
        (speed > fastest).then(|| {
            Concern::new(
                "faster-than-waves",
                format!(
                    "{} is faster than every shear wave of the ground ({fastest:.1} m/s)",
                    speed_text(speed)
                ),
                "check the speed and the soil; the response is then governed by material damping",
            )
        })
    }

    /// A concern if rock lies deeper than waves of the lowest of `frequencies` [Hz] above zero reach and come back from:
    /// e^{−2 Σ h ηω/(2c_s)} below 1e-3.
    pub fn deep_rock(&self, frequencies: &[f64]) -> Option<Concern> {
        let Support::Ground(profile, _) = &self.support else { return None };
        let lowest = frequencies.iter().copied().filter(|f| *f > 0.0).reduce(|a: f64, b: f64| a.min(b))?;
        let decay: f64 = profile
            .layers()
            .iter()
            .map(|l| {
                l.thickness * l.material.loss_factor() * std::f64::consts::TAU * lowest / l.material.c_s()
            })
            .sum();
        (profile.base() == Base::Rigid && decay > 1e3f64.ln()).then(|| {
            Concern::new(
                "deep-rock",
                format!(
                    "the rigid base at {:.1} m is deeper than waves reach: at {lowest} Hz they come back with {:.0e} of their \
                     amplitude",
                    profile.depth(),
                    (-decay).exp()
                ),
                "a half-space of the lowest layer gives the same answer with less work",
            )
        })
    }

    /// The train, wanted by `study`.
    ///
    /// # Errors
    /// There is none.
    pub fn train(&self, study: &'static str) -> Result<&Train, StudyError> {
        self.train.as_ref().ok_or(StudyError::NeedsTrain { study })
    }
}
