//! What a page may ask: the library, the answers to a case, what stands in a case file.

use crate::opened;
use groundwave::case::library::{ENTRIES, Entry};
use groundwave::case::{Case, CaseError, Solved};
use groundwave::study::Outcome;
use groundwave::{Concern, Silent};
use serde_json::{Value, json};

/// Answers `request`: `{"ask": "library"}`, `{"ask": "solve", "case": …}`, `{"ask": "open", "case": …, "name": …}`.
pub fn to(request: &[u8]) -> Value {
    let request: Value = match serde_json::from_slice(request) {
        Ok(request) => request,
        Err(error) => return failed(&format!("the page asks what is no JSON: {error}")),
    };
    let text = |key: &str| request[key].as_str().unwrap_or_default();
    let name = request["name"].as_str().unwrap_or("case.toml");
    match text("ask") {
        "library" => library(),
        "solve" => read(text("case"), name).map_or_else(|faults| faults, |case| solved(&case)),
        "open" => read(text("case"), name).map_or_else(|faults| faults, |case| opened::told(&case)),
        other => failed(&format!("the page asks for `{other}`")),
    }
}

/// What cannot be answered, and why.
pub fn failed(why: &str) -> Value {
    json!({ "failed": why })
}

/// The case `text`, or its faults.
fn read(text: &str, name: &str) -> Result<Case, Value> {
    let beside = |file: &str| Err(format!("a page reads one file, and {file} lies beside it"));
    Case::parse(text, name, &beside)
        .map_err(|faults| json!({ "faults": faults.each().into_iter().map(fault).collect::<Vec<_>>() }))
}

fn fault(fault: CaseError) -> Value {
    let message = fault.to_string();
    match fault {
        CaseError::Invalid { key, text, span, help, .. } => {
            let line = span.map(|span| 1 + text.inner()[..span.offset()].matches('\n').count());
            json!({ "file": text.name(), "key": key, "line": line, "message": message, "help": help })
        }
        _ => json!({ "key": "", "message": message }),
    }
}

/// Titles and sources of what ships with the program; of soils their layers too.
fn library() -> Value {
    let of = |kind: &str| -> Vec<Value> { ENTRIES.iter().filter(|e| e.kind == kind).map(entry).collect() };
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "soils": of("soils"), "tracks": of("tracks"), "vehicles": of("vehicles"),
    })
}

fn entry(entry: &Entry) -> Value {
    let mut told =
        json!({ "name": entry.name, "title": entry.text_of("title"), "source": entry.text_of("source") });
    if entry.kind == "soils" {
        told["soil"] = opened::library_soil(entry.name);
    }
    told
}

/// Every study of `case`: its arrays, answers and concerns, and the axles that stand on the rail.
fn solved(case: &Case) -> Value {
    match Solved::of(case, &Silent) {
        Err(error) => failed(&error.to_string()),
        Ok(solved) => {
            let studies: serde_json::Map<String, Value> =
                solved.outcomes.iter().map(|(name, one)| ((*name).to_owned(), outcome(one))).collect();
            let axles = case.railway.train().map_or(&[][..], |train| train.axles());
            let axles: Vec<[f64; 2]> = axles.iter().map(|axle| [axle.position, axle.load]).collect();
            json!({ "studies": studies, "concerns": concerns(&case.concerns), "axles": axles })
        }
    }
}

fn outcome(outcome: &Outcome) -> Value {
    let array = |v: &groundwave::dataset::Variable| (v.name.clone(), json!(v.to_vec()));
    let arrays: serde_json::Map<String, Value> = outcome.group.variables.iter().map(array).collect();
    let answers: Vec<Value> = outcome
        .answers
        .iter()
        .map(|a| json!({ "key": a.key, "what": a.what, "value": a.value, "unit": a.unit, "shown": a.shown }))
        .collect();
    json!({ "arrays": arrays, "answers": answers, "concerns": concerns(&outcome.concerns) })
}

fn concerns(concerns: &[Concern]) -> Vec<Value> {
    concerns.iter().map(|c| json!({ "code": c.code, "message": c.message, "remedy": c.remedy })).collect()
}
