//! A railway: what carries it, the layers of its track, its train.

mod error;

pub use error::RailwayError;

use crate::foundation::{Foundation, FoundationError, Grain, LayeredSoil, Springs};
use crate::rail::periodic::{Floquet, Undamped};
use crate::rail::{self, Landmark, Method, Moving, Receptance, TrackOnFoundation};
use crate::soil::{Compatibility, Profile, Solver, Strip};
use crate::track::{Layout, Stack, Supports};
use crate::vehicle::Train;

/// How the track, or the load without a track, touches the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// A track over a strip; without one, the strip a track would lie on.
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

/// Layered ground, the solver that answers for it, and how it is loaded.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Layers and base.
    pub profile: Profile,
    /// Solver of the waves in them.
    pub solver: Solver,
    /// How track or axles touch it; None for the ground alone.
    pub contact: Option<Contact>,
    /// Names of its layers and of its half-space, as far as they have some, top first.
    pub names: Vec<Option<String>>,
}

impl Ground {
    /// `profile` loaded through `contact`, answered by `solver`.
    pub fn new(profile: Profile, solver: Solver, contact: Option<Contact>) -> Self {
        Self { profile, solver, contact, names: Vec::new() }
    }

    /// The same with `names` of its layers and of its half-space.
    #[must_use]
    pub fn named(self, names: Vec<Option<String>>) -> Self {
        Self { names, ..self }
    }

    /// How it is loaded.
    ///
    /// # Errors
    /// Nothing loads it.
    pub fn contact(&self) -> Result<Contact, RailwayError> {
        self.contact.ok_or(RailwayError::NoContact)
    }

    /// The strip a foundation k_eq(β, ω) is of.
    ///
    /// # Errors
    /// Nothing loads it, or points do, under which it sinks without end.
    pub fn strip(&self) -> Result<Strip, RailwayError> {
        self.contact()?.strip().ok_or(RailwayError::PointLoad)
    }
}

/// What carries the track.
#[derive(Clone, Debug, PartialEq)]
pub enum Support {
    /// Layered ground.
    Ground(Ground),
    /// Springs.
    Springs(Springs),
}

/// Support, track and train, checked. The ground alone is a railway too: without a track, without a train.
#[derive(Debug)]
pub struct Railway {
    support: Support,
    /// Keeps what its solver prepared; None where the ground has no strip, and on springs.
    soil: Option<LayeredSoil>,
    layout: Layout,
    train: Option<Train>,
}

impl Railway {
    /// A railway from its parts: the `layout` of its track, an empty stack for loads straight on the ground, and its `train`.
    ///
    /// # Errors
    /// A contact width that is not positive.
    pub fn new(
        support: Support,
        layout: impl Into<Layout>,
        train: Option<Train>,
    ) -> Result<Self, RailwayError> {
        let soil = match &support {
            Support::Ground(Ground { profile, solver, contact, .. }) => contact
                .and_then(|contact| contact.strip())
                .map(|strip| LayeredSoil::new(profile.clone(), *solver, strip))
                .transpose()?,
            Support::Springs(_) => None,
        };
        Ok(Self { support, soil, layout: layout.into(), train })
    }

    /// The same with another `solver` of the ground; on springs nothing changes.
    ///
    /// # Errors
    /// None that the railway itself did not have.
    pub fn with_solver(&self, solver: Solver) -> Result<Self, RailwayError> {
        let support = match &self.support {
            Support::Ground(ground) => Support::Ground(Ground { solver, ..ground.clone() }),
            Support::Springs(springs) => Support::Springs(springs.clone()),
        };
        Self::new(support, self.layout.clone(), self.train.clone())
    }

    /// What carries the track.
    pub fn support(&self) -> &Support {
        &self.support
    }

    /// Name of the ground's solver, for people and attributes.
    pub fn solver_name(&self) -> &'static str {
        match &self.support {
            Support::Ground(ground) => ground.solver.name(),
            Support::Springs(_) => "none (springs)",
        }
    }

    /// How the rail is carried along the track; an empty stack for loads straight on the ground.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The continuous track without what it stands on; empty for loads straight on the ground.
    ///
    /// # Errors
    /// Supports that stand apart.
    pub fn stack(&self) -> Result<&Stack, RailwayError> {
        match &self.layout {
            Layout::Continuous(stack) => Ok(stack),
            Layout::Discrete(_) | Layout::Varying(_) => Err(RailwayError::Apart),
        }
    }

    /// Whether the rail stands on equal supports.
    pub fn on_supports(&self) -> bool {
        matches!(self.layout, Layout::Discrete(_))
    }

    /// Whether there are sections one after another.
    pub fn has_sections(&self) -> bool {
        matches!(self.layout, Layout::Varying(_))
    }

    /// Whether loads stand straight on the ground.
    pub fn is_bare(&self) -> bool {
        self.stack().is_ok_and(Stack::is_empty)
    }

    /// The springs it stands on.
    ///
    /// # Errors
    /// It stands on layered ground.
    pub fn springs(&self) -> Result<&Springs, RailwayError> {
        match &self.support {
            Support::Springs(springs) => Ok(springs),
            Support::Ground(_) => Err(RailwayError::OnGround),
        }
    }

    /// The layered ground.
    ///
    /// # Errors
    /// The railway stands on springs.
    pub fn ground(&self) -> Result<&Ground, RailwayError> {
        match &self.support {
            Support::Ground(ground) => Ok(ground),
            Support::Springs(_) => Err(RailwayError::NoGround),
        }
    }

    /// The train.
    ///
    /// # Errors
    /// There is none.
    pub fn train(&self) -> Result<&Train, RailwayError> {
        self.train.as_ref().ok_or(RailwayError::NoTrain)
    }

    /// The foundation k(β, ω).
    ///
    /// # Errors
    /// Ground that nothing loads, or points, has none.
    pub fn foundation(&self) -> Result<&dyn Foundation, RailwayError> {
        match (&self.support, &self.soil) {
            (Support::Springs(springs), _) => Ok(springs),
            (Support::Ground(_), Some(soil)) => Ok(soil),
            (Support::Ground(ground), None) => Err(match ground.strip() {
                Err(error) => error,
                Ok(_) => RailwayError::NoContact,
            }),
        }
    }

    /// The track on its foundation, or a patch of load straight on it.
    ///
    /// # Errors
    /// No foundation; supports that stand apart; a strip of ground without a track, which under a point of it sinks without end.
    pub fn track(&self) -> Result<TrackOnFoundation<'_>, RailwayError> {
        let half_length = self.ground().and_then(Ground::contact).map_or(0.0, |c| c.half_length());
        // points are refused by what they lack
        let point = self.ground().is_ok_and(|ground| ground.contact == Some(Contact::Point));
        let stack = self.stack()?;
        if stack.is_empty() && half_length == 0.0 && !point {
            return Err(RailwayError::NoTrack);
        }
        Ok(TrackOnFoundation::new(stack, self.foundation()?, half_length))
    }

    /// `wanted`, or the best method for a standing force on its rail.
    ///
    /// # Errors
    /// No foundation.
    pub fn method(&self, wanted: Option<Method>) -> Result<Method, RailwayError> {
        Ok(wanted.unwrap_or(Method::standing(&self.layout, self.foundation()?)))
    }

    /// How its rail answers a standing force, by `method`.
    ///
    /// # Errors
    /// No track, no foundation, a method that does not know them.
    pub fn receptance(&self, method: Method) -> Result<Box<dyn Receptance + '_>, RailwayError> {
        let foundation = self.foundation()?;
        if method == Method::Adaptive && foundation.grain() != Grain::Formula && self.stack().is_ok() {
            // patches of load straight on the ground too
            return Ok(Box::new(self.track()?));
        }
        if self.is_bare() {
            return Err(RailwayError::NoTrack);
        }
        Ok(rail::rail(&self.layout, foundation, method)?)
    }

    /// How its rail answers a force that moves, by `method`.
    ///
    /// # Errors
    /// No track, no foundation, a method that does not know them.
    pub fn moving(&self, method: Method) -> Result<Box<dyn Moving + '_>, RailwayError> {
        if self.is_bare() {
            return Err(RailwayError::NoTrack);
        }
        Ok(rail::moving(&self.layout, self.foundation()?, method)?)
    }

    /// Decay [dB/m] of the free wave along its rail that decays least, at `omega` [rad/s].
    ///
    /// # Errors
    /// A track without free waves of its own: on layered ground, of sections.
    pub fn free_decay(&self, method: Option<Method>, omega: f64) -> Result<f64, RailwayError> {
        Ok(rail::free_decay(&self.layout, self.foundation()?, method, omega)?)
    }

    /// Frequencies up to `highest` [Hz] of the track on springs of its own, without loss, that explain its curves; none on ground and
    /// of sections.
    pub fn landmarks(&self, highest: f64) -> Vec<(Landmark, f64)> {
        let Support::Springs(springs) = &self.support else { return Vec::new() };
        let marks = |supports: &Supports| {
            let floquet = Floquet::new(supports, springs)?;
            Undamped::new(&floquet).landmarks(highest)
        };
        match &self.layout {
            Layout::Discrete(supports) => marks(supports).unwrap_or_default(),
            Layout::Continuous(stack) => {
                // at β = 0 all move alike, whatever the spacing
                let alike =
                    Supports::new(stack, 1.0, None, None).ok().and_then(|supports| marks(&supports).ok());
                let mut alike = alike.unwrap_or_default();
                alike.retain(|mark| mark.0 != Landmark::PinnedPinned);
                alike
            }
            Layout::Varying(_) => Vec::new(),
        }
    }

    /// Ranges up to `highest` [Hz] in which no wave travels along the rail on equal springs of its own, all loss taken out.
    pub fn stop_bands(&self, highest: f64) -> Vec<(f64, f64)> {
        let (Layout::Discrete(supports), Support::Springs(springs)) = (&self.layout, &self.support) else {
            return Vec::new();
        };
        let floquet = Floquet::new(supports, springs);
        let bands = floquet.and_then(|floquet| Undamped::new(&floquet).bands(highest)).unwrap_or_default();
        bands.iter().filter(|band| band.waves == 0).map(|band| (band.from, band.to)).collect()
    }

    /// Refuses receivers, at `distances` [m] from the centre line, without layered ground or on the track.
    ///
    /// # Errors
    /// `NoGround`, `OnTrack`.
    pub fn check_receivers(&self, distances: &[f64]) -> Result<(), RailwayError> {
        let strip = self.ground()?.contact.and_then(|contact| contact.strip());
        let half_width = strip.map_or(0.0, |s| s.half_width);
        match distances.iter().find(|y| y.abs() <= half_width) {
            Some(&distance) => Err(RailwayError::OnTrack { distance, half_width }),
            None => Ok(()),
        }
    }

    /// Refuses loads that last where a spring of the track, or under it, gives way without end.
    ///
    /// # Errors
    /// `TrackError::NoStatics`, `TrackError::Pushes`.
    pub fn check_statics(&self) -> Result<(), RailwayError> {
        let track = match &self.layout {
            Layout::Continuous(stack) => stack.check(0.0),
            Layout::Discrete(supports) => supports.under.check(0.0),
            Layout::Varying(sections) => sections.iter().try_for_each(|s| s.supports.under.check(0.0)),
        };
        track.map_err(FoundationError::from)?;
        match &self.support {
            Support::Springs(springs) => Ok(springs.check(0.0)?),
            Support::Ground(_) => Ok(()),
        }
    }

    /// Refuses phase speeds [m/s] at which undamped ground has a wave, and the integral over wavenumbers no value.
    ///
    /// # Errors
    /// `FoundationError::Undamped` for the largest of `phase_speeds`.
    pub fn check_damping(&self, phase_speeds: impl Iterator<Item = f64>) -> Result<(), RailwayError> {
        let Ok(Ground { profile, .. }) = self.ground() else { return Ok(()) };
        let phase_speed = phase_speeds.map(f64::abs).fold(0.0, f64::max);
        let slowest = profile.slowest_rayleigh_speed();
        if profile.is_undamped() && phase_speed >= slowest {
            return Err(FoundationError::Undamped { phase_speed, slowest }.into());
        }
        Ok(())
    }
}
