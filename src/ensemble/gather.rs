//! Chunks → one result: arrays, tables, pictures, a report, the worst samples as cases.

use super::columns::curve_groups;
use super::error::EnsembleError;
use super::place::{Place, sweep};
use super::rows::Rows;
use super::shown::{Shown, shown};
use super::table::Table;
use super::worst;
use crate::case::{Beside, Case, Page, RunOptions, Summary, leave};
use crate::progress::Observer;
use crate::sampling::GENERATOR;
use crate::study::Outcome;
use std::fmt::Write;
use std::path::Path;

/// All rows of the study in the folder `out`, and its case.
///
/// # Errors
/// A folder without a study, chunks that lack, or that belong to another study.
pub fn table(out: &Path, observer: &dyn Observer) -> Result<(Case, Table), EnsembleError> {
    let place = Place::open(out)?;
    let identity = place.identity()?;
    let open = |name: &str| {
        identity.case_files.get(name).cloned().ok_or_else(|| "not stored with the study".to_owned())
    };
    let case = Case::parse(&identity.case_text, "study.json", &open)?;
    if let Some(difference) = super::Identity::of(&case).difference(&identity) {
        return Err(EnsembleError::Mixed { path: out.to_owned(), difference });
    }
    let rows = Rows::of(case.study.as_ref().ok_or(EnsembleError::NoStudy)?);
    let missing: Vec<usize> = (0..rows.chunks()).filter(|chunk| !place.holds(*chunk)).collect();
    if !missing.is_empty() {
        return Err(EnsembleError::Incomplete { path: out.to_owned(), missing, of: rows.chunks() });
    }
    let fingerprint = identity.fingerprint();
    observer.begin("gathering", rows.chunks() as u64);
    let chunks = (0..rows.chunks()).map(|number| {
        observer.advance();
        let chunk = place.read(number, &fingerprint)?;
        if !chunk.rows.iter().map(|row| row.number).eq(rows.of_chunk(number)) {
            let reason =
                format!("chunk {number} has other rows; remove it, and run its part of the study again");
            return Err(EnsembleError::Read { path: out.to_owned(), reason });
        }
        Ok(chunk)
    });
    let table = Table::gather(&rows, chunks)?;
    observer.end();
    Ok((case, table))
}

/// Gathers the study in the folder `out` into `gathered` within it, which is replaced: `study.h5`, tables, pictures, report, and the
/// worst samples as case files.
///
/// # Errors
/// As [`table`]; files that cannot be written, then what stood there stays.
pub fn gather(out: &Path, pictures: bool, observer: &dyn Observer) -> Result<(Case, Summary), EnsembleError> {
    let (case, table) = table(out, observer)?;
    let study = case.study.as_ref().ok_or(EnsembleError::NoStudy)?;
    let Shown { outcome, tables, worst, derivatives, correlations } = shown(&case, study, &table);
    let mut files = worst::files(&case, study, &Rows::of(study), &worst);
    let derived = derivatives.iter().map(|d| format!("{},{},{},{}", d.key, d.unit, d.stands, d.value));
    files.push(lines("derivatives.csv", "key,unit,in the case,logarithmic derivative", derived));
    let ranked = correlations.iter().map(|(key, r)| format!("{key},{r}"));
    files.push(lines("rank_correlations.csv", "key,Spearman", ranked));
    let outcomes = with_curves(outcome, &case, &table);
    let page = Page {
        title: format!("{}: what is uncertain", case.title),
        input: case.text.clone(),
        assumptions: vec![
            format!("Samples are drawn by {GENERATOR}; each depends on the seed, its number and its key alone."),
            "Quantiles lie between the values of samples by the chord; samples without an answer are left out.".to_owned(),
            "Intervals are those of the sampling alone: the distributions, the model and its parameters that do not vary are taken as given."
                .to_owned(),
        ],
        tables,
    };
    let beside = Beside {
        arrays: "study.h5",
        about: case.about.rows(),
        attributes: vec![
            ("generator".into(), GENERATOR.into()),
            ("case_text".into(), case.text.clone().into()),
            ("case_files".into(), serde_json::json!(case.files).to_string().into()),
        ],
        files,
    };
    let options = RunOptions {
        out: Place::open(out)?.gathered(),
        overwrite: true,
        pictures,
        csv_maps: false,
        vti: false,
    };
    let summary = leave(outcomes, page, beside, &options)?;
    sweep(out, true);
    Ok((case, summary))
}

/// What is known of the samples, then their curves, study by study.
fn with_curves(samples: Outcome, case: &Case, table: &Table) -> Vec<(&'static str, Outcome)> {
    let curves = curve_groups(case, table).into_iter();
    std::iter::once(("study", samples))
        .chain(curves.map(|(name, group)| (name, Outcome { group, ..Outcome::default() })))
        .collect()
}

/// What [`gather`] writes of the study in the folder `out`, as arrays, answers and concerns; what ended processes have left half-written
/// is removed.
///
/// # Errors
/// As [`table`].
pub fn outcomes(out: &Path, observer: &dyn Observer) -> Result<Vec<(&'static str, Outcome)>, EnsembleError> {
    let (case, table) = table(out, observer)?;
    let study = case.study.as_ref().ok_or(EnsembleError::NoStudy)?;
    sweep(out, true);
    Ok(with_curves(shown(&case, study, &table).outcome, &case, &table))
}

/// A file of comma-separated lines.
fn lines(name: &str, head: &str, lines: impl Iterator<Item = String>) -> (String, String) {
    let mut text = format!("{head}\n");
    lines.for_each(|line| {
        let _ = writeln!(text, "{line}");
    });
    (name.to_owned(), text)
}
