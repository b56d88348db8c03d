//! What a passage is asked with.

use crate::irregularity::Defect;
use crate::rail::fem::Ends;
use crate::study::Irregularity;
use crate::track::{Caughey, Rails};
use crate::vehicle::{ContactSpring, Multibody};
use schemars::JsonSchema;
use serde::Deserialize;

/// How wheels press on the rail.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ContactLaw {
    /// P = K δ^{3/2}, none where they are apart.
    #[default]
    NonLinear,
    /// P = P₀ + k_H (δ − δ₀), also where that pulls.
    Linear,
}

impl ContactLaw {
    /// As a case file says it.
    pub fn name(self) -> &'static str {
        match self {
            Self::NonLinear => "non-linear",
            Self::Linear => "linear",
        }
    }
}

/// How a passage begins.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum Start {
    /// Everything at rest in equilibrium, then at full speed at once.
    Static,
    /// Forces, rail and profile take hold little by little.
    Ramp,
}

impl Start {
    /// As a case file says it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Static => "static",
            Self::Ramp => "ramp",
        }
    }
}

/// Δt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// [s]
    Time(f64),
    /// v Δt [m]
    Length(f64),
    /// What profiles and frequencies need.
    Chosen,
}

/// Wheels with a mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Running {
    /// The whole train; its wheelsets stand where its axles do, in their order.
    pub bodies: Multibody,
    /// Of each wheelset, in the same order.
    pub contact: Vec<ContactSpring>,
    /// How they press.
    pub law: ContactLaw,
    /// What they roll over besides defects.
    pub irregularity: Option<Irregularity>,
    /// Defects and where they lie [m], with the wheels (from 0) that have them, none for those of the rail.
    pub defects: Vec<(Defect, f64, Vec<usize>)>,
}

/// A train that passes in time over a track in finite elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// Where the leading axle stands at first and at last [m].
    pub run: (f64, f64),
    /// What of the track is computed [m].
    pub track: Option<(f64, f64)>,
    /// Finite elements between two supports.
    pub elements_per_bay: usize,
    /// Δt
    pub step: Step,
    /// How it begins; None: static with wheels that have a mass, by ramp without.
    pub start: Option<Start>,
    /// Way over which a start by ramp takes hold, or the irregularity under wheels that start at rest [m].
    pub ramp: f64,
    /// How the ends of the rail are held.
    pub ends: Ends,
    /// α of Hilber, Hughes & Taylor.
    pub alpha: f64,
    /// Damping of the track besides its own.
    pub damping: Option<Caughey>,
    /// How many rails the numbers of the track stand for.
    pub rails: Rails,
    /// Wheels, or None for the constant loads of the train.
    pub running: Option<Running>,
    /// Numbers of sleepers that hang, and the gap below each [m].
    pub hanging: Vec<(i64, f64)>,
    /// Numbers of sleepers that are not there.
    pub missing: Vec<i64>,
    /// Where rail and sleepers are watched [m].
    pub at: Vec<f64>,
    /// Lowest and highest frequency of interest [Hz].
    pub frequencies: (f64, f64),
}
