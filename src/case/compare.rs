//! Two cases, or the folders of two runs, against one another.

use super::runner::{Beside, Page, RunError, RunOptions, Summary, leave};
use super::{Case, CaseError, StudyFailed};
use crate::output::{ReportTable, hdf5};
use crate::progress::Observer;
use crate::study::{Against, Left, Results, Told};
use std::path::Path;
use thiserror::Error;

/// Why two results cannot be compared.
#[derive(Debug, Error)]
pub enum CompareError {
    /// A folder that holds no results.
    #[error("{path}: {reason}; give a case file, or the folder of an earlier run")]
    Folder {
        /// As given.
        path: String,
        /// Why.
        reason: String,
    },
    /// A case that is refused.
    #[error(transparent)]
    Case(#[from] Box<CaseError>),
    /// A study that failed, or files that cannot be written.
    #[error(transparent)]
    Run(#[from] RunError),
}

/// The results at `path`: of a folder as they stand there, of a case file computed.
fn results(path: &Path, observer: &dyn Observer) -> Result<(Results, String), CompareError> {
    if path.is_dir() {
        let told = |reason| CompareError::Folder { path: path.display().to_string(), reason };
        return of_folder(path).map_err(told);
    }
    let case = Case::load(path).map_err(Box::new)?;
    let mut studies = Vec::new();
    for study in &case.studies {
        let run = study.run(&case.railway, observer);
        let outcome = run.map_err(|source| RunError::from(StudyFailed { study: study.name(), source }))?;
        let answers = outcome.answers.iter().map(Told::from).collect();
        studies.push(Left { study: study.name().to_owned(), group: outcome.group, answers });
    }
    Ok((Results { title: case.title, studies }, case.text))
}

fn of_folder(folder: &Path) -> Result<(Results, String), String> {
    let file = folder.join("results.h5");
    let groups = hdf5::read(&file).map_err(|e| format!("results.h5: {e}"))?;
    let text =
        std::fs::read_to_string(folder.join("summary.json")).map_err(|e| format!("summary.json: {e}"))?;
    let summary: serde_json::Value = serde_json::from_str(&text).map_err(|e| format!("summary.json: {e}"))?;
    let title = summary["title"].as_str().unwrap_or_default().to_owned();
    let studies = groups.into_iter().map(|group| {
        let study = group.name.clone();
        let numbers = summary[&study].as_object().into_iter().flatten();
        let told = |(key, value): (&String, &serde_json::Value)| {
            let unit = summary["units"][&study][key].as_str().unwrap_or_default().to_owned();
            Some(Told { key: key.clone(), what: key.clone(), value: value.as_f64()?, unit })
        };
        let answers = numbers.filter_map(told).collect();
        Left { study, group, answers }
    });
    let studies = studies.collect();
    let input = hdf5::read_text_attribute(&file, "case_text").unwrap_or_default();
    Ok((Results { title, studies }, input))
}

/// What `second` is against `first`, left in a folder: answers, curves, insertion losses, one report.
///
/// Each is a case file, which is computed, or the folder of an earlier run, which is read.
///
/// # Errors
/// A case that is refused or fails, a folder without results, a folder that cannot be made. Then nothing is left behind.
pub fn compare(
    first: &Path,
    second: &Path,
    options: &RunOptions,
    observer: &dyn Observer,
) -> Result<Summary, CompareError> {
    super::check_output(&options.out, options.overwrite).map_err(RunError::from)?;
    let ((a, text_a), (b, text_b)) = (results(first, observer)?, results(second, observer)?);
    let against = Against::new(&a, &b);
    let outcome = against.shown();
    let rows = against.largest.iter().flat_map(|(study, comparison)| {
        comparison.datasets.iter().map(move |d| {
            let [absolute, relative] = [d.absolute, d.relative].map(|v| format!("{v:.3e}"));
            vec![study.clone(), d.name.clone(), absolute, d.unit.clone(), relative]
        })
    });
    let header = ["study", "dataset", "largest difference", "unit", "of the largest value"];
    let largest = ReportTable {
        title: "Largest differences of every dataset".into(),
        header: header.map(str::to_owned).to_vec(),
        rows: rows.collect(),
    };
    let [one, two] = [first, second].map(|path| path.display().to_string());
    let page = Page {
        title: format!("{} against {}", b.title, a.title),
        input: format!("# ======== first: {one} ========\n\n{text_a}\n\n# ======== second: {two} ========\n\n{text_b}"),
        assumptions: vec![
            format!("First: {} ({one}). Second: {} ({two}).", a.title, b.title),
            "Differences are second less first; insertion losses are 20 lg of the velocity of the first over that of the second.".to_owned(),
        ],
        tables: vec![largest],
    };
    Ok(leave(vec![("comparison", outcome)], page, Beside::default(), options)?)
}
