//! A few norms per case, to notice change: answers and the L2 norm of every array, to 1e-6.
//!
//! Small versions of the cases: every fifth speed of a curve, coarse contours. `GROUNDWAVE_BLESS=1` rewrites
//! `norms.json`; its difference is reviewed like code.

use groundwave::study::Step;
use groundwave::{Case, Silent, Study};
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

const CASES: &[&str] = &[
    "kaynia2000_ledsgard_185",
    "kaynia2000_ledsgard_70",
    "kaynia2000_ledsgard_power_car_last",
    "lamprea2022_ballasted",
    "lamprea2022_free_field",
    "lamprea2022_half_space",
    "lamprea2022_receptance_ballasted",
    "lamprea2022_receptance_map_ballasted",
    "lamprea2022_receptance_slab",
    "lamprea2022_slab",
    "mezher2016_profile3_ballasted",
    "mezher2016_profile3_slab",
    "lamprea2022_noise_discrete_2layer",
    "lamprea2022_moving_load_over_supports",
    "lamprea2022_transition",
    "iwnicki1998_rough_track",
    "lamprea2022_dipped_joint",
    "lamprea2022_soft_to_stiff",
];

/// Relative change that is noticed. Results do not depend on the number of threads; 1e-6 leaves room for another
/// machine's sine and exponential, which move the places where adaptive integrals stop.
const TOLERANCE: f64 = 1e-6;

fn at(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The same study, small enough to run often.
fn shrink(study: &mut Study) {
    match study {
        Study::CriticalSpeed(study) => study.speeds = study.speeds.iter().copied().step_by(5).collect(),
        Study::TrackResponse(study) => study.spacing = Some(0.5),
        Study::Contour(study) => {
            study.window.spacing = 1.0;
            study.clearance = Some(60.0);
            study.speeds.truncate(1);
        }
        Study::Dispersion(study) => {
            study.frequencies = study.frequencies.iter().copied().step_by(5).collect();
        }
        Study::Receptance(study) => {
            study.frequencies = study.frequencies.iter().copied().step_by(20).collect();
            if let Some(map) = &mut study.map {
                map.window.spacing = 2.0;
            }
        }
        Study::Passage(study) => {
            study.speeds.truncate(1);
            study.elements_per_bay = 4;
            study.step = Step::Length(5e-3);
        }
        Study::FreeField(study) => study.bands = study.bands[8..12].to_vec(),
        Study::GroundAtDepth(study) => study.spacing = Some(2.0),
        Study::DecayRate(_)
        | Study::Transition(_)
        | Study::EquivalentStiffness(_)
        | Study::SurfaceCompliance(_) => {}
    }
}

/// Answers and norms of a study, by name.
fn norms(case: &Case, study: &Study) -> Map<String, Value> {
    let outcome = study.run(&case.railway, &Silent).unwrap();
    let mut found = Map::new();
    for answer in &outcome.answers {
        found.insert(answer.key.clone(), answer.value.into());
    }
    for variable in &outcome.group.variables {
        // absent modes are not a number
        let norm = variable.values.iter().filter(|v| v.is_finite()).map(|v| v * v).sum::<f64>().sqrt();
        found.insert(format!("norm of {}", variable.name), norm.into());
    }
    found
}

#[test]
fn norms_are_as_blessed() {
    let mut found = Map::new();
    for name in CASES {
        let mut case = Case::load(&at("soil_cases").join(name).join("case.toml")).unwrap();
        case.studies.iter_mut().for_each(shrink);
        let studies: Map<_, _> =
            case.studies.iter().map(|s| (s.name().to_owned(), norms(&case, s).into())).collect();
        found.insert((*name).to_owned(), studies.into());
    }
    let file = at("tests/golden/norms.json");
    if std::env::var_os("GROUNDWAVE_BLESS").is_some() {
        let text = serde_json::to_string_pretty(&found).unwrap();
        std::fs::write(&file, text + "\n").unwrap();
        return;
    }
    let blessed: Map<String, Value> =
        serde_json::from_str(&std::fs::read_to_string(&file).expect("tests/golden/norms.json")).unwrap();
    let mut changes = Vec::new();
    compare("", &found.into(), &blessed.into(), &mut changes);
    assert!(
        changes.is_empty(),
        "{} norms changed; if that is intended, run with GROUNDWAVE_BLESS=1 and review the difference:\n{}",
        changes.len(),
        changes.join("\n")
    );
}

/// Collects what is new, missing or different.
fn compare(path: &str, found: &Value, blessed: &Value, changes: &mut Vec<String>) {
    match (found, blessed) {
        (Value::Object(found), Value::Object(blessed)) => {
            for (key, value) in found {
                let path = format!("{path}/{key}");
                match blessed.get(key) {
                    Some(old) => compare(&path, value, old, changes),
                    None => changes.push(format!("{path}: new")),
                }
            }
            let gone = blessed.keys().filter(|key| !found.contains_key(*key));
            changes.extend(gone.map(|key| format!("{path}/{key}: missing")));
        }
        _ => {
            let (new, old) = (found.as_f64().unwrap_or(f64::NAN), blessed.as_f64().unwrap_or(f64::NAN));
            // the search for the maximum stops at a bracket of 0.1 m/s, and the curve is flat there
            let allowed = if path.ends_with("critical_speed") || path.ends_with("train_largest_speed") {
                0.1
            } else {
                TOLERANCE * new.abs().max(old.abs())
            };
            let same = (new - old).abs() <= allowed;
            if !same {
                changes.push(format!("{path}: {new:e}, was {old:e} ({:+.1e})", new / old - 1.0));
            }
        }
    }
}
