//! One folder per question an engineer asks: its `solve` answers with a typed result, its `shown` turns that into arrays, pictures,
//! answers and concerns.

pub mod comparison;
mod contour;
mod critical_speed;
mod dispersion;
mod doubts;
mod equivalent_stiffness;
mod free_field;
mod model;
mod receptance;
mod surface_compliance;
mod track_response;

pub use comparison::Comparison;
pub use contour::{Contour, GroundMaps};
pub use critical_speed::{CriticalSpeed, Hump, Peak, Plateau, SpeedCurve, SpeedCurves};
pub use dispersion::{Crossing, Dispersion, DispersionCurves};
pub use equivalent_stiffness::{EquivalentStiffness, StiffnessTable};
pub use free_field::{Carrier, FreeField, Irregularity, Roughness};
pub use model::{Contact, Model, Support};
pub use receptance::{Receptance, ReceptanceMap, Receptances, Surface};
pub use surface_compliance::{Compliances, SurfaceComplianceTable};
pub use track_response::{Record, TrackResponse, TrackShapes, same_speed, tag};

use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::GroundFieldError;
use crate::figure::Figure;
use crate::foundation::FoundationError;
use crate::progress::Observer;
use crate::rail::InteractionError;
use crate::soil::SoilError;
use thiserror::Error;

/// One number a reader came for.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Key in `summary.json`.
    pub key: String,
    /// What it is, in words.
    pub what: String,
    /// Its value, SI.
    pub value: f64,
    /// SI unit.
    pub unit: &'static str,
    /// The value as a report shows it, with unit.
    pub shown: String,
}

impl Answer {
    /// An answer from its parts.
    pub fn new(key: &str, what: impl Into<String>, value: f64, unit: &'static str, shown: String) -> Self {
        Self { key: key.to_owned(), what: what.into(), value, unit, shown }
    }
}

/// What a study leaves.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Arrays for HDF5 and CSV.
    pub group: Group,
    /// Pictures with a caption each.
    pub figures: Vec<(Figure, String)>,
    /// The numbers a reader came for.
    pub answers: Vec<Answer>,
    /// What the result may be doubted for.
    pub concerns: Vec<Concern>,
}

/// A question with its settings.
#[derive(Clone, Debug, PartialEq)]
pub enum Study {
    /// At which speed does the track move most?
    CriticalSpeed(CriticalSpeed),
    /// Which waves travel along the ground and along the track by themselves?
    Dispersion(Dispersion),
    /// What shape has the rail?
    TrackResponse(TrackResponse),
    /// What does the ground around the train do?
    Contour(Contour),
    /// How much do rail and ground move under a standing harmonic load?
    Receptance(Receptance),
    /// How much does a passing train shake the ground beside the track?
    FreeField(Box<FreeField>),
    /// k_eq(β, ω)
    EquivalentStiffness(EquivalentStiffness),
    /// G(k, ω)
    SurfaceCompliance(SurfaceComplianceTable),
}

impl Study {
    /// Name of the study: its table in the case file, its group in the HDF5 file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::CriticalSpeed(_) => "critical_speed",
            Self::Dispersion(_) => "dispersion",
            Self::TrackResponse(_) => "track_response",
            Self::Contour(_) => "contour",
            Self::Receptance(_) => "receptance",
            Self::FreeField(_) => "free_field",
            Self::EquivalentStiffness(_) => "equivalent_stiffness",
            Self::SurfaceCompliance(_) => "surface_compliance",
        }
    }

    /// Answers the question for `model`.
    ///
    /// # Errors
    /// A response that diverges, a grid beyond the memory, a question the model has no answer to.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        match self {
            Self::CriticalSpeed(study) => study.run(model, observer),
            Self::Dispersion(study) => study.run(model, observer),
            Self::TrackResponse(study) => study.run(model, observer),
            Self::Contour(study) => study.run(model, observer),
            Self::Receptance(study) => study.run(model, observer),
            Self::FreeField(study) => study.run(model, observer),
            Self::EquivalentStiffness(study) => study.run(model, observer),
            Self::SurfaceCompliance(study) => study.run(model, observer),
        }
    }

    /// Refuses, before anything is computed, what cannot be answered.
    ///
    /// # Errors
    /// As `run`, where it can be known beforehand.
    pub fn check(&self, model: &Model) -> Result<(), StudyError> {
        match self {
            Self::CriticalSpeed(study) => {
                model.track()?;
                model.train(self.name())?;
                model.check_damping(study.speeds.iter().copied())
            }
            Self::TrackResponse(study) => {
                model.track()?;
                model.train(self.name())?;
                model.check_damping(study.speeds.iter().copied())
            }
            Self::Contour(study) => {
                study.check(model)?;
                model.check_damping(study.speeds.iter().copied())
            }
            Self::Receptance(study) => {
                model.track()?;
                if !study.receivers.is_empty() {
                    model.receivers(&study.receivers)?;
                }
                if let Some(map) = &study.map {
                    map.check(model)?;
                }
                // a standing load feels waves of every phase speed
                model.check_damping(std::iter::once(f64::INFINITY))
            }
            Self::FreeField(study) => study.check(model),
            Self::EquivalentStiffness(study) => {
                model.foundation()?;
                let omega = std::f64::consts::TAU * study.frequencies.iter().copied().fold(0.0, f64::max);
                model.check_damping(study.beta.iter().map(|beta| omega / beta))
            }
            Self::Dispersion(_) => model.ground("dispersion").map(|_| ()),
            Self::SurfaceCompliance(_) => model.ground("surface_compliance").map(|_| ()),
        }
    }
}

/// Why a study has no answer.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StudyError {
    /// The moving response failed.
    #[error(transparent)]
    Interaction(#[from] InteractionError),
    /// The foundation failed.
    #[error(transparent)]
    Foundation(#[from] FoundationError),
    /// The ground failed.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// A vehicle failed.
    #[error(transparent)]
    Vehicle(#[from] crate::vehicle::BodyError),
    /// A profile failed.
    #[error(transparent)]
    Irregularity(#[from] crate::irregularity::IrregularityError),
    /// A history failed.
    #[error(transparent)]
    Signal(#[from] crate::signal::SignalError),
    /// A measure of vibration failed.
    #[error(transparent)]
    Assessment(#[from] crate::assessment::AssessmentError),
    /// The field failed.
    #[error(transparent)]
    Field(#[from] GroundFieldError),
    /// The study needs layered ground.
    #[error("the study {study} needs layered ground: give [soil] instead of [foundation]")]
    NeedsGround {
        /// Its name.
        study: &'static str,
    },
    /// The study needs a train.
    #[error("the study {study} needs a load: give [train] with at least one axle")]
    NeedsTrain {
        /// Its name.
        study: &'static str,
    },
    /// Bodies that do not stand on the axles of the train.
    #[error(
        "the vehicle model has {wheelsets} wheelsets, the train {axles} axles, or they stand elsewhere: build both from the same \
         positions"
    )]
    OtherWheels {
        /// Axles of the train.
        axles: usize,
        /// Wheelsets of the model.
        wheelsets: usize,
    },
    /// The study needs a track.
    #[error("the study {study} needs a track: track.kind = \"none\" has no rail for wheels to run on")]
    NeedsTrack {
        /// Its name.
        study: &'static str,
    },
    /// A receiver on the track.
    #[error(
        "the receiver at {distance} m stands on the track, whose half-width is {half_width} m: receivers are distances from the          centre line of the track"
    )]
    OnTrack {
        /// From the centre line [m].
        distance: f64,
        /// [m]
        half_width: f64,
    },
    /// Ground under a point load sinks without end.
    #[error(
        "the ground under a point load has no finite deflection: give track.load.kind = \"patch\" with half_length \
         and half_width, or ask for a contour only"
    )]
    PointLoad,
    /// The grid does not fit into memory.
    #[error(
        "the {what} grid of {columns} × {rows} samples needs {needed_gb:.1} GB and the machine has {available_gb:.1} GB free: \
         use a larger spacing, a smaller window or fewer quantities"
    )]
    Memory {
        /// The grid of what.
        what: &'static str,
        /// Samples along x.
        columns: usize,
        /// Samples along y.
        rows: usize,
        /// [GB]
        needed_gb: f64,
        /// [GB]
        available_gb: f64,
    },
}

/// A number for a legend: at most four decimals, no trailing zeros.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// "137.0 m/s (493 km/h)"
fn speed_text(speed: f64) -> String {
    format!("{speed:.1} m/s ({:.0} km/h)", 3.6 * speed)
}
