//! Study tables → studies, with every fault at its key.

use super::assessment::{assessment, building};
use super::checks::{ascending, distinct, receivers, window};
use super::error::Finding;
use super::ground_at_depth::ground_at_depth;
use super::irregularity;
use super::passage::passage;
use super::rail_studies::{decay_rate, receptance, track_response, transition};
use super::ranges::{NOT_NEGATIVE, POSITIVE, line_speed, numbers, speeds};
use super::schema::{
    CaseInput, ContourInput, CriticalSpeedInput, DispersionInput, EquivalentStiffnessInput, FreeFieldInput,
    SoilInput, SurfaceComplianceInput,
};
use super::values::{Named, Range};
use super::vehicle::Wheels;
use crate::assessment::Band;
use crate::field::Quantity;
use crate::quantity::positive;
use crate::soil::{Solver, ThinLayer};
use crate::study::{
    Contour, CriticalSpeed, Dispersion, EquivalentStiffness, FreeField, Irregularity, Roughness, ShapesAt,
    Study, SurfaceComplianceTable,
};
use crate::track::Rails;
use std::collections::BTreeSet;

/// Least distance to the periodic images of a contour [m].
const LEAST_CLEARANCE: f64 = 20.0;

fn contour(input: &ContourInput) -> Result<Contour, Finding> {
    let quantities = match &input.quantities {
        None => vec![Quantity::Vertical],
        Some(list) if list.is_empty() => {
            return Err(Finding::new("contour.quantities", "the list is empty")
                .help("allowed: vertical, vertical-velocity, along, across"));
        }
        Some(list) => list.clone(),
    };
    let speeds = speeds(&input.speeds, "contour.speeds")?;
    distinct(&speeds, "contour.speeds", "m/s")?;
    let positive =
        |clearance| positive("clearance", clearance, "m").map_err(|e| Finding::out_of_range("contour", e));
    let clearance = input.clearance.map(positive).transpose()?;
    if let Some(clearance) = clearance.filter(|c| *c < LEAST_CLEARANCE) {
        let message = format!("clearance is {clearance} m: it must be at least {LEAST_CLEARANCE} m");
        return Err(Finding::new("contour.clearance", message));
    }
    Ok(Contour { speeds, window: window(input.x, input.y, input.spacing, "contour")?, quantities, clearance })
}

/// Beyond, layers are thousands of wavelengths thick.
const AUDIBLE: (fn(f64) -> bool, &str) = (|f| f > 0.0 && f <= 1e4, "above zero and at most 10 kHz");

/// Most modes a case may ask for.
const MOST_MODES: usize = 20;

fn dispersion(input: &DispersionInput) -> Result<Dispersion, Finding> {
    let frequencies = numbers(&input.frequencies, "dispersion.frequencies", "Hz", AUDIBLE)?;
    ascending(&frequencies, "dispersion.frequencies")?;
    let modes = input.modes.unwrap_or(3);
    if !(1..=MOST_MODES).contains(&modes) {
        let message = format!("modes is {modes}: it must lie between 1 and {MOST_MODES}");
        return Err(Finding::new("dispersion.modes", message));
    }
    let shapes = input.shapes.as_ref().map(|input| {
        let frequencies = numbers(&input.frequencies, "dispersion.shapes.frequencies", "Hz", AUDIBLE)?;
        ascending(&frequencies, "dispersion.shapes.frequencies")?;
        let depths = numbers(&input.z, "dispersion.shapes.z", "m", NOT_NEGATIVE)?;
        ascending(&depths, "dispersion.shapes.z")?;
        distinct(&frequencies, "dispersion.shapes.frequencies", "Hz")?;
        Ok(ShapesAt { frequencies, depths })
    });
    Ok(Dispersion { frequencies, modes, wave: input.wave.unwrap_or_default(), shapes: shapes.transpose()? })
}

/// Farthest receiver of a free field [m].
const FAR_FIELD: f64 = 500.0;
/// Slowest train whose vibration is worth asking for [m/s].
const SLOWEST: f64 = 1.0;
/// Longest passage a case may ask for [s].
const LONGEST_PASSAGE: f64 = 3600.0;

/// The free field, still of a smooth rail.
fn free_field(
    input: &FreeFieldInput,
    case: &CaseInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<FreeField, Finding> {
    let speed = speeds(&Range::List(vec![input.speed]), "free_field.speed").map_err(|_| {
        Finding::new("free_field.speed", format!("{} m/s: it must be above zero", input.speed))
    })?[0];
    if speed < SLOWEST {
        let message = format!("{speed} m/s: it must be above zero, and at least {SLOWEST} m/s");
        return Err(Finding::new("free_field.speed", message));
    }
    let receivers = receivers(&input.receivers, "free_field.receivers")?;
    if receivers.is_empty() {
        return Err(
            Finding::new("free_field.receivers", "the list is empty").help("give at least one distance [m]")
        );
    }
    if let Some(i) = receivers.iter().position(|y| *y > FAR_FIELD) {
        let message = format!("{} m: farther than {FAR_FIELD} m", receivers[i]);
        return Err(Finding::new(format!("free_field.receivers[{i}]"), message)
            .help("the waves of a train have died away there"));
    }
    let passage_time = input.passage_time;
    if let Some(time) = passage_time
        && !(time > 0.0 && time <= LONGEST_PASSAGE)
    {
        let message = format!("{time} s: it must lie above 0 and up to {LONGEST_PASSAGE} s");
        return Err(Finding::new("free_field.passage_time", message));
    }
    let (from, to) = input.frequencies.map_or((1.0, 80.0), |range| (range.from, range.to));
    if !(from >= 0.1 && to <= 1000.0) {
        let message = format!("from {from} to {to} Hz: they must lie between 0.1 and 1000 Hz");
        return Err(Finding::new("free_field.frequencies", message));
    }
    let bands = Band::range(from, to).map_err(|e| Finding::new("free_field.frequencies", e))?;
    // a case that says nothing of solvers gets the quick one where it matters
    let named = |soil: &Named<SoilInput>| matches!(soil, Named::Table(table) if table.solver.is_some());
    let sections = (!case.soil.as_ref().is_some_and(named)).then(|| Solver::ThinLayer(ThinLayer::default()));
    let whole = input.assessment.as_ref();
    let assessment = assessment(input.guide.as_ref(), input.levels, whole, input.receivers.len())?;
    let building = building(input.transfer.as_ref(), files)?;
    let components = input.components;
    Ok(FreeField {
        speed,
        receivers,
        passage_time,
        components,
        bands,
        roughness: None,
        sections,
        assessment,
        building,
    })
}

/// The wheels on an irregular rail.
fn roughness(irregularity: Irregularity, wheels: Option<&Wheels>) -> Result<Roughness, Finding> {
    match wheels {
        None | Some(Wheels { bodies: None, .. }) => {
            Err(Finding::new("train", "the wheels have no mass to follow the irregularity with").help(
                "add unsprung_mass [kg per wheelset] and wheel_rail.stiffness [N/m] or wheel_rail.radius [m]",
            ))
        }
        Some(Wheels { contact: None, .. }) => {
            Err(Finding::new("train", "the wheels have no contact with a rough rail")
                .help("add wheel_rail.stiffness [N/m per wheelset] or wheel_rail.radius [m]"))
        }
        Some(Wheels { bodies: Some(bodies), contact: Some(contact), .. }) => {
            let contact = contact.iter().map(|spring| spring.stiffness).collect();
            Ok(Roughness { bodies: bodies.clone(), contact, irregularity })
        }
    }
}

fn critical_speed(input: &CriticalSpeedInput) -> Result<CriticalSpeed, Finding> {
    let speeds = speeds(&input.speeds, "critical_speed.speeds")?;
    ascending(&speeds, "critical_speed.speeds")?;
    let line_speed = line_speed(input.line_speed, "critical_speed.line_speed")?;
    let accuracy = match input.accuracy {
        Some(a) if !(1e-8..=1e-2).contains(&a) => {
            let message = format!("found {a}: the accuracy must lie between 1e-8 and 0.01");
            let help = "leave it out for 1e-5; 1e-3 will do for searches and studies of many grounds";
            return Err(Finding::new("critical_speed.accuracy", message).help(help));
        }
        accuracy => accuracy,
    };
    Ok(CriticalSpeed { speeds, line_speed, accuracy })
}

fn equivalent_stiffness(input: &EquivalentStiffnessInput) -> Result<EquivalentStiffness, Finding> {
    Ok(EquivalentStiffness {
        beta: numbers(&input.beta, "equivalent_stiffness.beta", "rad/m", POSITIVE)?,
        frequencies: numbers(&input.frequencies, "equivalent_stiffness.frequencies", "Hz", NOT_NEGATIVE)?,
    })
}

fn surface_compliance(input: &SurfaceComplianceInput) -> Result<SurfaceComplianceTable, Finding> {
    let k = numbers(&input.k, "surface_compliance.k", "rad/m", NOT_NEGATIVE)?;
    let frequencies = numbers(&input.frequencies, "surface_compliance.frequencies", "Hz", NOT_NEGATIVE)?;
    if k.contains(&0.0) && frequencies.contains(&0.0) {
        let message =
            "k = 0 and f = 0 together: a half-space bears no load that reaches everywhere and lasts";
        return Err(Finding::new("surface_compliance.k", message).help("remove one of the two zeros"));
    }
    Ok(SurfaceComplianceTable { k, frequencies })
}

/// Names of the tables that ask for something.
const STUDIES: [&str; 12] = [
    "critical_speed",
    "dispersion",
    "track_response",
    "contour",
    "ground_at_depth",
    "receptance",
    "decay_rate",
    "transition",
    "passage",
    "free_field",
    "equivalent_stiffness",
    "surface_compliance",
];

/// The studies a case asks for, in the order of this list, and the fault of each that cannot be; `wheels` are None where the train
/// is faulty, `rails` how many the numbers of the track stand for, `spoilt` the tables that were not read.
pub fn studies(
    input: &CaseInput,
    (wheels, rails): (Option<Option<&Wheels>>, Rails),
    spoilt: &BTreeSet<String>,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> (Vec<Study>, Vec<Finding>) {
    let irregularity = input.irregularity.as_ref().map(|i| irregularity::irregularity(i, files));
    let rough = match (&irregularity, wheels) {
        (Some(Ok(irregularity)), Some(wheels)) if input.free_field.is_some() => {
            Some(roughness(irregularity.clone(), wheels))
        }
        _ => None,
    };
    let on_rail = rough.as_ref().and_then(|rough| rough.as_ref().ok());
    let free = |study| {
        let smooth = free_field(study, input, files)?;
        Ok(Study::FreeField(Box::new(FreeField { roughness: on_rail.cloned(), ..smooth })))
    };
    let passing = |study| {
        let uneven = irregularity.as_ref().and_then(|i| i.as_ref().ok()).cloned();
        passage(study, wheels.flatten(), uneven, rails).map(|passage| Study::Passage(Box::new(passage)))
    };
    let asked: [Option<Result<Study, Finding>>; 12] = [
        input.critical_speed.as_ref().map(|s| critical_speed(s).map(Study::CriticalSpeed)),
        input.dispersion.as_ref().map(|s| dispersion(s).map(Study::Dispersion)),
        input.track_response.as_ref().map(|s| track_response(s, files).map(Study::TrackResponse)),
        input.contour.as_ref().map(|s| contour(s).map(Study::Contour)),
        input.ground_at_depth.as_ref().map(|s| ground_at_depth(s).map(Study::GroundAtDepth)),
        input.receptance.as_ref().map(|s| receptance(s, files).map(Study::Receptance)),
        input.decay_rate.as_ref().map(|s| decay_rate(s, files).map(Study::DecayRate)),
        input.transition.as_ref().map(|s| transition(s).map(Study::Transition)),
        input.passage.as_ref().filter(|_| wheels.is_some()).map(passing),
        input.free_field.as_ref().map(free),
        input.equivalent_stiffness.as_ref().map(|s| equivalent_stiffness(s).map(Study::EquivalentStiffness)),
        input.surface_compliance.as_ref().map(|s| surface_compliance(s).map(Study::SurfaceCompliance)),
    ];
    let none = asked.iter().all(Option::is_none)
        && input.passage.is_none()
        && !STUDIES.iter().any(|name| spoilt.contains(*name));
    let unused = irregularity.is_some()
        && input.free_field.is_none()
        && input.passage.is_none()
        && !["free_field", "passage"].iter().any(|name| spoilt.contains(*name));
    let mut faults = Vec::new();
    let studies =
        asked.into_iter().flatten().filter_map(|study| study.map_err(|f| faults.push(f)).ok()).collect();
    faults.extend(irregularity.and_then(Result::err));
    faults.extend(rough.and_then(Result::err));
    if none {
        let all = STUDIES.map(|name| format!("[{name}]")).join(", ");
        faults.push(Finding::new("", "the case asks for nothing").help(format!("add at least one of {all}")));
    }
    if unused {
        let finding = Finding::new("irregularity", "no study uses the roughness of the rail");
        faults.push(finding.help("add [free_field] or [passage], or remove [irregularity]"));
    }
    (studies, faults)
}
