//! How often the dearest functions are called in a few studies: a count that grows by more than 5 % is noticed.
//!
//! `cargo test --release --features count --test counts`; with `GROUNDWAVE_BLESS=1` it rewrites `counts.json`, whose difference is
//! reviewed like code. Counts do not depend on the machine, but for a few integrals that stop one halving sooner or later, nor on the
//! number of threads.

use groundwave::{Case, Silent, Study, count};
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

/// Case and study.
const STUDIES: &[(&str, &str)] = &[
    ("lamprea2022_ballasted", "critical_speed"),
    ("lamprea2022_ballasted", "dispersion"),
    ("lamprea2022_ballasted", "contour"),
    ("lamprea2022_ballasted", "equivalent_stiffness"),
    ("lamprea2022_slab", "track_response"),
    ("lamprea2022_receptance_ballasted", "receptance"),
    ("lamprea2022_free_field", "free_field"),
    ("kaynia2000_ledsgard_185", "critical_speed"),
    ("mezher2016_profile3_ballasted", "dispersion"),
];

/// What a count may grow by before it is noticed.
const TOLERANCE: f64 = 0.05;

fn at(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The same study, small enough to run often.
fn shrink(study: &mut Study) {
    match study {
        Study::CriticalSpeed(study) => study.speeds = study.speeds.iter().copied().step_by(5).collect(),
        Study::Contour(study) => study.speeds.truncate(1),
        Study::Receptance(study) => {
            study.frequencies = study.frequencies.iter().copied().step_by(20).collect();
        }
        Study::FreeField(study) => study.bands = study.bands[8..10].to_vec(),
        _ => {}
    }
}

#[test]
fn counts_do_not_grow() {
    let mut found = Map::new();
    for (name, question) in STUDIES {
        let case = Case::load(&at("soil_cases").join(name).join("case.toml")).unwrap();
        let study = case.studies.iter().find(|study| study.name() == *question);
        let mut study = study.unwrap_or_else(|| panic!("{name} has no {question}")).clone();
        shrink(&mut study);
        count::take();
        study.run(&case.railway, &Silent).unwrap();
        let counts = count::take().into_iter().filter(|(_, count)| *count > 0);
        let counts: Map<_, _> = counts.map(|(work, count)| (work.to_owned(), count.into())).collect();
        found.insert(format!("{name}/{question}"), counts.into());
    }
    let file = at("tests/counts/counts.json");
    if std::env::var_os("GROUNDWAVE_BLESS").is_some() {
        std::fs::write(&file, serde_json::to_string_pretty(&found).unwrap() + "\n").unwrap();
        return;
    }
    let blessed: Map<String, Value> = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    let count = |of: &Map<String, Value>, study: &str, work: &str| of.get(study)?.get(work)?.as_f64();
    let mut changes = Vec::new();
    for (study, works) in &found {
        for work in works.as_object().unwrap().keys() {
            let new = count(&found, study, work).unwrap_or(0.0);
            let old = count(&blessed, study, work).unwrap_or(0.0);
            println!("{study} {work}: {new}, was {old}");
            if new > (1.0 + TOLERANCE) * old {
                changes
                    .push(format!("{study}: {new} {work}, was {old} ({:+.0} %)", 100.0 * (new / old - 1.0)));
            }
        }
    }
    assert!(
        changes.is_empty(),
        "{} counts have grown; if that is intended, run with GROUNDWAVE_BLESS=1 and review the difference:\n{}",
        changes.len(),
        changes.join("\n")
    );
}
