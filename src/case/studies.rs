//! Study tables → studies, with every fault at its key.

use super::checks::{FARTHEST, ascending, distinct, span};
use super::error::Finding;
use super::irregularity;
use super::ranges::{MOST, NOT_NEGATIVE, POSITIVE, numbers, speeds};
use super::schema::{
    BesideInput, CaseInput, ContourInput, CriticalSpeedInput, DecayRateInput, DispersionInput,
    EquivalentStiffnessInput, FreeFieldInput, MeasuredInput, ReceptanceInput, SoilInput, SpanInput,
    SurfaceComplianceInput, TrackResponseInput, TransitionInput,
};
use super::train::Wheels;
use super::values::{Named, Range};
use crate::assessment::Band;
use crate::columns::{self, Columns};
use crate::field::{Quantity, Window};
use crate::quantity::positive;
use crate::rail::Method;
use crate::soil::{Solver, ThinLayer};
use crate::study::{
    Beside, Contour, CriticalSpeed, DecayRate, Dispersion, EquivalentStiffness, FreeField, Irregularity,
    Receptance, ReceptanceMap, Record, Roughness, Study, SurfaceComplianceTable, TrackResponse, Transition,
    same_speed,
};
use std::collections::BTreeSet;

/// Least distance to the periodic images of a contour [m].
const LEAST_CLEARANCE: f64 = 20.0;

/// Two columns of the CSV `file` that the key at `at` names.
fn columns_of(
    file: &str,
    at: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
    wanted: &str,
) -> Result<Columns, Finding> {
    let text = files(file).map_err(|reason| {
        Finding::new(at, format!("cannot read \"{file}\": {reason}"))
            .help("the path is relative to the case file")
    })?;
    let wanted = format!("a header line, then {wanted}");
    let columns =
        columns::read(&text).map_err(|e| Finding::new(at, format!("{file}, {e}")).help(wanted.as_str()))?;
    if columns.x.is_empty() {
        return Err(Finding::new(at, format!("{file} has no numbers")).help(wanted));
    }
    Ok(columns)
}

/// A record's CSV: x′ and deflection.
fn record(
    input: &MeasuredInput,
    path: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Record, Finding> {
    let at = format!("{path}.file");
    let Columns { x, values: deflection, .. } =
        columns_of(&input.file, &at, files, "x′ [m], deflection [m]")?;
    Ok(Record { speed: input.speed.0, label: input.label.clone(), x, deflection })
}

fn track_response(
    input: &TrackResponseInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<TrackResponse, Finding> {
    let x = input.x.map(|x| span(x, "track_response.x")).transpose()?;
    let records = input
        .measured
        .iter()
        .enumerate()
        .map(|(i, m)| record(m, &format!("track_response.measured[{i}]"), files))
        .collect::<Result<_, _>>()?;
    let spacing = input.spacing.map(|spacing| positive("spacing", spacing, "m")).transpose();
    let spacing = spacing.map_err(|e| Finding::out_of_range("track_response", e))?;
    let length = x.map_or(1000.0, |(from, to)| to - from);
    if let Some(spacing) = spacing
        && length / spacing >= MOST as f64
    {
        let found =
            format!("a spacing of {spacing} m makes {:.0} positions, more than {MOST}", length / spacing);
        return Err(Finding::new("track_response.spacing", found).help("use a larger spacing"));
    }
    let speeds = speeds(&input.speeds, "track_response.speeds")?;
    distinct(&speeds, "track_response.speeds", "m/s")?;
    for (i, measured) in input.measured.iter().enumerate() {
        if !speeds.iter().any(|v| same_speed(*v, measured.speed.0)) {
            let message =
                format!("the record is for {} m/s, which is not among the speeds", measured.speed.0);
            return Err(Finding::new(format!("track_response.measured[{i}].speed"), message)
                .help("add the speed to track_response.speeds"));
        }
    }
    let frequencies = input.frequencies.as_ref().map(|frequencies| {
        let path = "track_response.frequencies";
        let frequencies = numbers(frequencies, path, "Hz", POSITIVE)?;
        ascending(&frequencies, path)?;
        Ok(frequencies)
    });
    if let Some(harmonic) = input.harmonic {
        positive("harmonic", harmonic, "Hz").map_err(|e| Finding::out_of_range("track_response", e))?;
    }
    let spectra = beside(&input.spectra, "track_response.spectra", files)?;
    let at = if input.at.is_empty() { Vec::new() } else { places(&input.at, "track_response.at")? };
    Ok(TrackResponse {
        speeds,
        x,
        spacing,
        records,
        at,
        harmonic: input.harmonic,
        frequencies: frequencies.transpose()?.unwrap_or_default(),
        beside: spectra,
        method: input.method,
        verify: input.verify,
    })
}

/// The part of the surface to map, of the study `path`.
fn window(x: SpanInput, y: SpanInput, spacing: f64, path: &str) -> Result<Window, Finding> {
    let (x, y) = (span(x, &format!("{path}.x"))?, span(y, &format!("{path}.y"))?);
    let spacing = positive("spacing", spacing, "m").map_err(|e| Finding::out_of_range(path, e))?;
    let least = (x.1 - x.0).min(y.1 - y.0);
    if spacing > least {
        let message = format!("spacing is {spacing} m, wider than the window of {least} m");
        return Err(
            Finding::new(format!("{path}.spacing"), message).help("a map has two points each way at least")
        );
    }
    Ok(Window { x, y, spacing })
}

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
    Ok(Dispersion { frequencies, modes, wave: input.wave.unwrap_or_default() })
}

/// Distances from the centre line, ascending.
fn receivers(values: &[f64], path: &str) -> Result<Vec<f64>, Finding> {
    if values.is_empty() {
        return Ok(Vec::new());
    }
    let values = numbers(&Range::List(values.to_vec()), path, "m", POSITIVE)?;
    ascending(&values, path)?;
    match values.iter().position(|y| *y > FARTHEST) {
        Some(i) => {
            let message = format!("{} m: farther than {FARTHEST} m", values[i]);
            Err(Finding::new(format!("{path}[{i}]"), message))
        }
        None => Ok(values),
    }
}

/// Curves to draw beside the computed ones, of the list at `path`.
fn beside(
    input: &[BesideInput],
    path: &str,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Vec<Beside>, Finding> {
    let one = |(i, beside): (usize, &BesideInput)| {
        let at = format!("{path}[{i}].file");
        let Columns { x, values, .. } = columns_of(&beside.file, &at, files, "frequency [Hz], value")?;
        Ok(Beside { label: beside.label.clone(), x, values })
    };
    input.iter().enumerate().map(one).collect()
}

/// A second method that is another one.
fn another(method: Option<Method>, verify: Option<Method>, path: &str) -> Result<(), Finding> {
    if verify.is_some() && method == verify {
        return Err(Finding::new(format!("{path}.verify"), "it is the method itself")
            .help("name another method, or remove it"));
    }
    Ok(())
}

/// A place along the rail.
fn place(x: f64, path: &str) -> Result<f64, Finding> {
    if x.abs() <= FARTHEST {
        return Ok(x);
    }
    Err(Finding::new(path, format!("found {x} m: it must be finite and within 10 km")))
}

/// Places along the rail.
fn places(x: &[f64], path: &str) -> Result<Vec<f64>, Finding> {
    let finite = |v: f64| v.abs() <= FARTHEST;
    let x = numbers(&Range::List(x.to_vec()), path, "m", (finite, "within 10 km"))?;
    distinct(&x, path, "m")?;
    Ok(x)
}

fn receptance(
    input: &ReceptanceInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Receptance, Finding> {
    let frequencies = numbers(&input.frequencies, "receptance.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "receptance.frequencies")?;
    let receivers = receivers(&input.receivers, "receptance.receivers")?;
    let map = input.map.as_ref().map(|map| {
        let path = "receptance.map.frequencies";
        let frequencies = numbers(&map.frequencies, path, "Hz", POSITIVE)?;
        ascending(&frequencies, path)?;
        distinct(&frequencies, path, "Hz")?;
        let window = window(map.x, map.y, map.spacing, "receptance.map")?;
        Ok(ReceptanceMap { frequencies, window })
    });
    another(input.method, input.verify, "receptance")?;
    let from = place(input.from.unwrap_or(0.0), "receptance.from")?;
    Ok(Receptance {
        frequencies,
        from,
        x: input.x.as_ref().map(|x| places(x, "receptance.x")).transpose()?,
        method: input.method,
        verify: input.verify,
        receivers,
        map: map.transpose()?,
        beside: beside(&input.measured, "receptance.measured", files)?,
    })
}

fn decay_rate(
    input: &DecayRateInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<DecayRate, Finding> {
    let frequencies = numbers(&input.frequencies, "decay_rate.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "decay_rate.frequencies")?;
    another(input.rail, input.verify, "decay_rate")?;
    let from = input.from.map(|x| place(x, "decay_rate.from")).transpose()?;
    Ok(DecayRate {
        frequencies,
        definition: input.method.unwrap_or_default(),
        from,
        rail: input.rail,
        verify: input.verify,
        beside: beside(&input.measured, "decay_rate.measured", files)?,
    })
}

fn transition(input: &TransitionInput) -> Result<Transition, Finding> {
    let frequencies = numbers(&input.frequencies, "transition.frequencies", "Hz", POSITIVE)?;
    ascending(&frequencies, "transition.frequencies")?;
    let along = input.along.as_ref().map(|along| {
        let along = numbers(&Range::List(along.clone()), "transition.along", "Hz", POSITIVE)?;
        distinct(&along, "transition.along", "Hz")?;
        Ok(along)
    });
    let x = input.x.map(|x| span(x, "transition.x")).transpose()?.unwrap_or((-15.0, 15.0));
    let spacing = positive("spacing", input.spacing.unwrap_or(0.05), "m")
        .map_err(|e| Finding::out_of_range("transition", e))?;
    if (x.1 - x.0) / spacing >= MOST as f64 {
        let message = format!(
            "a spacing of {spacing} m makes {:.0} positions, more than {MOST}",
            (x.1 - x.0) / spacing
        );
        return Err(Finding::new("transition.spacing", message).help("use a larger spacing"));
    }
    let from = input.from.unwrap_or(-0.5);
    place(from, "transition.from")?;
    let along = along.transpose()?.unwrap_or_default();
    if input.verify.is_some() && along.is_empty() {
        return Err(Finding::new(
            "transition.verify",
            "it is the receptances along the rail that are verified",
        )
        .help("add transition.along = [frequencies], or remove it"));
    }
    Ok(Transition { frequencies, along, from, x, spacing, method: input.method, verify: input.verify })
}

/// Farthest receiver of a free field [m].
const FAR_FIELD: f64 = 500.0;
/// Slowest train whose vibration is worth asking for [m/s].
const SLOWEST: f64 = 1.0;
/// Longest passage a case may ask for [s].
const LONGEST_PASSAGE: f64 = 3600.0;

/// The free field, still of a smooth rail.
fn free_field(input: &FreeFieldInput, case: &CaseInput) -> Result<FreeField, Finding> {
    let speed = speeds(&Range::List(vec![input.speed]), "free_field.speed").map_err(|_| {
        Finding::new("free_field.speed", format!("{} m/s: it must be above zero", input.speed.0))
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
    Ok(FreeField { speed, receivers, passage_time, bands, roughness: None, sections })
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
        Some(Wheels { bodies: Some(bodies), contact: Some(contact) }) => {
            Ok(Roughness { bodies: bodies.clone(), contact: *contact, irregularity })
        }
    }
}

fn critical_speed(input: &CriticalSpeedInput) -> Result<CriticalSpeed, Finding> {
    let speeds = speeds(&input.speeds, "critical_speed.speeds")?;
    ascending(&speeds, "critical_speed.speeds")?;
    Ok(CriticalSpeed { speeds })
}

fn equivalent_stiffness(input: &EquivalentStiffnessInput) -> Result<EquivalentStiffness, Finding> {
    Ok(EquivalentStiffness {
        beta: numbers(&input.beta, "equivalent_stiffness.beta", "rad/m", POSITIVE)?,
        frequencies: numbers(&input.frequencies, "equivalent_stiffness.frequencies", "Hz", NOT_NEGATIVE)?,
    })
}

fn surface_compliance(input: &SurfaceComplianceInput) -> Result<SurfaceComplianceTable, Finding> {
    Ok(SurfaceComplianceTable {
        k: numbers(&input.k, "surface_compliance.k", "rad/m", POSITIVE)?,
        frequencies: numbers(&input.frequencies, "surface_compliance.frequencies", "Hz", NOT_NEGATIVE)?,
    })
}

/// Names of the tables that ask for something.
const STUDIES: [&str; 10] = [
    "critical_speed",
    "dispersion",
    "track_response",
    "contour",
    "receptance",
    "decay_rate",
    "transition",
    "free_field",
    "equivalent_stiffness",
    "surface_compliance",
];

/// The studies a case asks for, in the order of this list, and the fault of each that cannot be; `wheels` are None where the train
/// is faulty, `spoilt` the tables that were not read.
pub fn studies(
    input: &CaseInput,
    wheels: Option<Option<&Wheels>>,
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
        let smooth = free_field(study, input)?;
        Ok(Study::FreeField(Box::new(FreeField { roughness: on_rail.cloned(), ..smooth })))
    };
    let asked: [Option<Result<Study, Finding>>; 10] = [
        input.critical_speed.as_ref().map(|s| critical_speed(s).map(Study::CriticalSpeed)),
        input.dispersion.as_ref().map(|s| dispersion(s).map(Study::Dispersion)),
        input.track_response.as_ref().map(|s| track_response(s, files).map(Study::TrackResponse)),
        input.contour.as_ref().map(|s| contour(s).map(Study::Contour)),
        input.receptance.as_ref().map(|s| receptance(s, files).map(Study::Receptance)),
        input.decay_rate.as_ref().map(|s| decay_rate(s, files).map(Study::DecayRate)),
        input.transition.as_ref().map(|s| transition(s).map(Study::Transition)),
        input.free_field.as_ref().map(free),
        input.equivalent_stiffness.as_ref().map(|s| equivalent_stiffness(s).map(Study::EquivalentStiffness)),
        input.surface_compliance.as_ref().map(|s| surface_compliance(s).map(Study::SurfaceCompliance)),
    ];
    let none = asked.iter().all(Option::is_none) && !STUDIES.iter().any(|name| spoilt.contains(*name));
    let unused = irregularity.is_some() && input.free_field.is_none() && !spoilt.contains("free_field");
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
        faults.push(finding.help("add [free_field], or remove [irregularity]"));
    }
    (studies, faults)
}
