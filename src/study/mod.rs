//! One folder per question an engineer asks: its `solve` answers with a typed result, its `shown` turns that into arrays, pictures,
//! answers and concerns.
//!
//! The file is long because every question has its arm in each of its matches.

mod against;
pub mod comparison;
mod contour;
mod critical_speed;
mod decay_rate;
mod dispersion;
mod doubts;
mod equivalent_stiffness;
mod free_field;
mod ground_at_depth;
mod landmarks;
mod passage;
mod receptance;
mod record;
mod surface_compliance;
mod track_response;
mod transition;
mod verified;

pub use against::{Against, AnswerChange, CurveChange, InsertionLoss, Left, Results, Told};
pub use comparison::Comparison;
pub use contour::{Contour, GroundMaps};
pub use critical_speed::{CriticalSpeed, Hump, LineSpeed, Peak, Plateau, Reached, SpeedCurve, SpeedCurves};
pub use decay_rate::{DecayRate, DecayRates};
pub use dispersion::{Crossing, Dispersion, DispersionCurves, Shapes, ShapesAt};
pub use equivalent_stiffness::{EquivalentStiffness, StiffnessTable};
pub use free_field::{
    Assessment, Building, Carrier, Components, FreeField, Horizontal, Irregularity, OneComponent, OtherTrain,
    PassVelocities, Passes, Roughness, SOUND, ThreeComponents,
};
pub use ground_at_depth::{GroundAtDepth, GroundStates, SHALLOWEST, THRESHOLD};
pub use passage::{ContactLaw, Passage, Passed, Running, Start, Step};
pub use receptance::{Receptance, ReceptanceMap, Receptances, Surface};
pub use record::{Channel, Judged, MeasuredHistory, RecordError};
pub use surface_compliance::{Compliances, SurfaceComplianceTable};
pub use track_response::{OverSupports, Record, TrackResponse, TrackShapes, same_speed, tag};
pub use transition::{Scattered, Transition};
pub use verified::Verified;

use crate::concern::Concern;
use crate::contact::MarchError;
use crate::dataset::Group;
use crate::field::GroundFieldError;
use crate::figure::{Figure, Series, Stroke};
use crate::foundation::FoundationError;
use crate::progress::{Cancelled, Observer};
use crate::rail::fem::FemError;
use crate::rail::{InteractionError, Method, RailError};
use crate::railway::{Ground, Railway, RailwayError};
use crate::soil::SoilError;
use thiserror::Error;
use verified::{known, only};

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
    /// Where it stands in a report that has many like it.
    pub cells: Option<Cells>,
}

/// Part of a row of a table of a report.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// Title of the table.
    pub table: String,
    /// What its rows are of, with unit.
    pub of: &'static str,
    /// Its row.
    pub row: String,
    /// Heading and text of each column.
    pub columns: Vec<(String, String)>,
}

impl Answer {
    /// An answer from its parts.
    pub fn new(key: &str, what: impl Into<String>, value: f64, unit: &'static str, shown: String) -> Self {
        Self { key: key.to_owned(), what: what.into(), value, unit, shown, cells: None }
    }

    /// The same, which a report shows in a table.
    pub fn in_table(self, cells: Cells) -> Self {
        Self { cells: Some(cells), ..self }
    }
}

/// A curve from elsewhere, to be drawn beside the computed one.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// Legend entry.
    pub label: String,
    /// Abscissae, SI.
    pub x: Vec<f64>,
    /// Values, SI.
    pub values: Vec<f64>,
}

impl Beside {
    /// As points of a picture, `scale` times its values.
    fn series(&self, scale: f64) -> Series {
        let y = self.values.iter().map(|value| scale * value).collect();
        Series { name: self.label.clone(), x: self.x.clone(), y, stroke: Stroke::Points }
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
    /// How much is the ground strained at depth?
    GroundAtDepth(GroundAtDepth),
    /// How much do rail and ground move under a standing harmonic load?
    Receptance(Receptance),
    /// How fast does vibration die away along the rail?
    DecayRate(DecayRate),
    /// What does a change of track do?
    Transition(Transition),
    /// What does a train do that passes in time?
    Passage(Box<Passage>),
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
            Self::GroundAtDepth(_) => "ground_at_depth",
            Self::Receptance(_) => "receptance",
            Self::DecayRate(_) => "decay_rate",
            Self::Transition(_) => "transition",
            Self::Passage(_) => "passage",
            Self::FreeField(_) => "free_field",
            Self::EquivalentStiffness(_) => "equivalent_stiffness",
            Self::SurfaceCompliance(_) => "surface_compliance",
        }
    }

    /// Answers the question for `railway`.
    ///
    /// # Errors
    /// A response that diverges, a grid beyond the memory, a question the model has no answer to.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        match self {
            Self::CriticalSpeed(study) => study.run(railway, observer),
            Self::Dispersion(study) => study.run(railway.ground()?, railway.stack().ok(), observer),
            Self::TrackResponse(study) => study.run(railway, observer),
            Self::Contour(study) => study.run(railway, observer),
            Self::GroundAtDepth(study) => study.run(railway, observer),
            Self::Receptance(study) => study.run(railway, observer),
            Self::DecayRate(study) => study.run(railway, observer),
            Self::Transition(study) => study.run(railway, observer),
            Self::Passage(study) => study.run(railway, observer),
            Self::FreeField(study) => study.run(railway, observer),
            Self::EquivalentStiffness(study) => study.run(railway, observer),
            Self::SurfaceCompliance(study) => study.run(railway.ground()?, observer),
        }
    }

    /// The same question asked another way, and how both are asked; None where it is asked once.
    pub fn witness(&self, railway: &Railway) -> Option<(Self, [&'static str; 2])> {
        let asked = |method, verify: Option<Method>| {
            let first = railway.method(method).ok()?;
            Some([first.name(), verify?.name()])
        };
        match self {
            Self::Receptance(study) => {
                let names = asked(study.method, study.verify)?;
                // the ground beside the track is asked in one way only
                let second =
                    Receptance { method: study.verify, receivers: Vec::new(), map: None, ..study.clone() };
                Some((Self::Receptance(second), names))
            }
            Self::DecayRate(study) => {
                let names = asked(study.rail, study.verify)?;
                Some((Self::DecayRate(DecayRate { rail: study.verify, ..study.clone() }), names))
            }
            _ => None,
        }
    }

    /// Refuses, before anything is computed, what cannot be answered: all that `railway` lacks, or else the first limit in the way.
    ///
    /// # Errors
    /// As `run`, where it can be known beforehand.
    pub fn check(&self, railway: &Railway) -> Result<(), Vec<StudyError>> {
        let lacks = self.lacks(railway);
        if lacks.is_empty() {
            self.check_limits(railway).map_err(|error| vec![error])
        } else {
            Err(lacks.into_iter().map(StudyError::from).collect())
        }
    }

    /// Key of its table that an `error` is about, empty for the table itself.
    pub fn key_of(&self, error: &StudyError) -> &'static str {
        let named = match error {
            StudyError::Railway(RailwayError::Rail(RailError::Method { method, .. })) => *method,
            StudyError::Railway(RailwayError::Itself { method }) => *method,
            StudyError::OffTrack { .. } => return "at",
            StudyError::NoSleeper { key, .. } => return key,
            StudyError::Soil(SoilError::Depth { .. }) => {
                return if matches!(self, Self::Dispersion(_)) { "shapes.z" } else { "z" };
            }
            StudyError::March(MarchError::Elements(FemError::Full { .. } | FemError::Massless)) => {
                return "damping";
            }
            StudyError::March(MarchError::Elements(FemError::NothingToHang)) => return "hanging_sleeper",
            StudyError::Railway(RailwayError::AtRest | RailwayError::Rail(RailError::TooFast { .. })) => {
                return "speeds";
            }
            _ => return "",
        };
        let (method, verify) = match self {
            Self::Receptance(study) => ((study.method, "method"), study.verify),
            Self::DecayRate(study) => ((study.rail, "rail"), study.verify),
            Self::TrackResponse(study) => ((study.method, "method"), study.verify),
            Self::Transition(study) => ((study.method, "method"), study.verify),
            _ => return "",
        };
        let is = |asked: Option<Method>| asked.is_some_and(|asked| asked.name() == named);
        if is(verify) {
            "verify"
        } else if is(method.0) {
            method.1
        } else {
            ""
        }
    }

    /// What `railway` lacks for an answer.
    fn lacks(&self, railway: &Railway) -> Vec<RailwayError> {
        let (ground, track, train) = (railway.ground(), railway.track().err(), railway.train().err());
        let [first, second] = match self {
            Self::CriticalSpeed(_) => [track, train],
            Self::TrackResponse(study) => {
                let rail = if railway.on_supports() { railway.foundation().err() } else { track };
                let own = if railway.on_supports() { Method::DiracComb } else { Method::Adaptive };
                // on springs without supports panels that ask at every node are another way
                let itself = study.verify.filter(|_| railway.on_supports() || railway.ground().is_ok());
                let rail = rail.or_else(|| only(own, study.method, itself));
                let verify = || study.verify.and_then(|method| railway.moving(method).err());
                [rail.or_else(|| study.speeds_lack(railway)).or_else(verify), train]
            }
            Self::Transition(_) if !railway.has_sections() => [Some(RailwayError::OneSection), None],
            Self::Transition(study) => {
                let methods = std::iter::once(Method::Coupled).chain(study.verify);
                let unknown = methods.filter_map(|method| railway.receptance(method).err()).next();
                [unknown.or_else(|| only(Method::Coupled, study.method, study.verify)), None]
            }
            Self::Receptance(study) => [study.lacks(railway), None],
            Self::DecayRate(study) => [study.lacks(railway), None],
            Self::Contour(_) | Self::GroundAtDepth(_) => {
                [ground.and_then(Ground::contact).err().or(railway.stack().err()), train]
            }
            Self::Passage(_) => {
                let bare = railway.is_bare().then_some(RailwayError::NoTrack);
                [railway.springs().err().or(bare), train]
            }
            Self::FreeField(_) => [ground.err().or(track), train],
            Self::EquivalentStiffness(_) => [railway.foundation().err(), None],
            Self::Dispersion(_) | Self::SurfaceCompliance(_) => [ground.err(), None],
        };
        first.into_iter().chain(second).collect()
    }

    /// Refuses phase speeds that undamped ground cannot bear, receivers on the track, grids beyond the memory.
    fn check_limits(&self, railway: &Railway) -> Result<(), StudyError> {
        let constant = match self {
            Self::CriticalSpeed(_) | Self::Contour(_) | Self::GroundAtDepth(_) => true,
            Self::TrackResponse(study) => study.harmonic.is_none(),
            _ => false,
        };
        if constant {
            railway.check_statics()?;
        }
        let speeds: Vec<f64> = match self {
            Self::CriticalSpeed(CriticalSpeed { speeds, line_speed, .. }) => {
                speeds.iter().chain(line_speed).copied().collect()
            }
            Self::TrackResponse(TrackResponse { speeds, .. }) => speeds.clone(),
            Self::Contour(study) => {
                study.check(railway)?;
                study.speeds.clone()
            }
            Self::GroundAtDepth(study) => {
                study.check(railway)?;
                study.speeds.clone()
            }
            // a standing load feels waves of every phase speed, and wheels shed them
            Self::Receptance(study) => {
                study.check(railway)?;
                vec![f64::INFINITY]
            }
            Self::DecayRate(_) | Self::Transition(_) => vec![f64::INFINITY],
            Self::Passage(study) => return study.check(railway),
            Self::FreeField(study) => {
                study.check(railway)?;
                vec![f64::INFINITY]
            }
            Self::Dispersion(study) => return Ok(study.check(&railway.ground()?.profile)?),
            // of undamped ground the limit is taken where there is one
            Self::EquivalentStiffness(_) | Self::SurfaceCompliance(_) => return Ok(()),
        };
        Ok(railway.check_damping(speeds.into_iter())?)
    }
}

/// Why a study has no answer.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StudyError {
    /// The moving response failed.
    #[error(transparent)]
    Interaction(#[from] InteractionError),
    /// The rail failed.
    #[error(transparent)]
    Rail(#[from] RailError),
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
    /// The railway lacks what the study needs.
    #[error(transparent)]
    Railway(#[from] RailwayError),
    /// Bodies that do not stand on the axles of the train.
    #[error(
        "the vehicle railway has {wheelsets} wheelsets, the train {axles} axles, or they stand elsewhere: build both from the same \
         positions"
    )]
    OtherWheels {
        /// Axles of the train.
        axles: usize,
        /// Wheelsets of the model.
        wheelsets: usize,
    },
    /// A march in time failed.
    #[error(transparent)]
    March(#[from] MarchError),
    /// A watched place beyond the track.
    #[error("the watched place {x} m does not lie on the track, which reaches from {from} to {to} m")]
    OffTrack {
        /// [m]
        x: f64,
        /// First end [m].
        from: f64,
        /// Last end [m].
        to: f64,
    },
    /// Sleepers that are not there to be faulty.
    #[error(
        "{found} of {wanted} sleepers stand on the track from {from} to {to} m: number n stands at n times the spacing, of sections 0 is the \
         first behind the first change; a track without support.spacing has none"
    )]
    NoSleeper {
        /// Key that names them.
        key: &'static str,
        /// How many are there.
        found: usize,
        /// How many are named.
        wanted: usize,
        /// First end of the track [m].
        from: f64,
        /// Last end [m].
        to: f64,
    },
    /// Told to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
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

impl StudyError {
    /// Whether it only says that the study was told to stop.
    pub fn is_cancelled(&self) -> bool {
        matches!(
            self,
            Self::Cancelled(_)
                | Self::Interaction(InteractionError::Cancelled(_))
                | Self::Field(GroundFieldError::Cancelled(_))
        )
    }
}

/// A number for a legend: at most four decimals, no trailing zeros.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// "493 km/h (137.0 m/s)": railways think in km/h.
fn speed_text(speed: f64) -> String {
    format!("{:.0} km/h ({speed:.1} m/s)", 3.6 * speed)
}
