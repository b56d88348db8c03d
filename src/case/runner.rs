//! Runs a case and leaves its results, whole or not at all.

use super::folder::{self, check_output, staging_prefix};
use super::{Case, Verification, report};
use crate::concern::Concern;
use crate::dataset::{Attribute, Dataset};
use crate::output::{OutputError, csv, hdf5, json, plot};
use crate::progress::Observer;
use crate::study::{Answer, Outcome, StudyError};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Where and how.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// Output folder; it appears when everything in it is written.
    pub out: PathBuf,
    /// Replace an existing folder.
    pub overwrite: bool,
    /// Concerns are failures.
    pub strict: bool,
}

/// What a run found.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Answers by study.
    pub answers: Vec<(&'static str, Vec<Answer>)>,
    /// What another solver says to them, where the case asks.
    pub verification: Option<Verification>,
    /// Every concern.
    pub concerns: Vec<Concern>,
    /// Files written, relative to the output folder.
    pub files: Vec<String>,
}

/// Why a run has no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// The output folder exists.
    #[error("the output folder {path} exists: give another --out, or --overwrite to replace it", path = path.display())]
    Exists {
        /// Which.
        path: PathBuf,
    },
    /// The output folder holds what this program did not write.
    #[error(
        "the output folder {path} holds what groundwave did not write there ({what}), and is not replaced: give another --out, or move \
         it away",
        path = path.display(),
        what = named(foreign)
    )]
    Foreign {
        /// Which.
        path: PathBuf,
        /// Names in it.
        foreign: Vec<String>,
    },
    /// The output folder cannot be made.
    #[error("cannot write to {path}: {reason}; give another --out", path = path.display())]
    Unwritable {
        /// Which.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// A study failed.
    #[error("{study}: {source}")]
    Study {
        /// Which.
        study: &'static str,
        /// Why.
        source: StudyError,
    },
    /// A file could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Concerns under `--strict`.
    #[error("{} concern(s) under --strict, nothing written:\n{}", concerns.len(), concerns.iter().map(|c| format!("  {c}")).collect::<Vec<_>>().join("\n"))]
    Strict {
        /// All of them.
        concerns: Vec<Concern>,
    },
}

/// The first few names of a list.
fn named(names: &[String]) -> String {
    let more = names.len().saturating_sub(5);
    let first = names.iter().take(5).cloned().collect::<Vec<_>>().join(", ");
    if more == 0 { first } else { format!("{first} and {more} more") }
}

/// Computes every study of `case`, a second time where it is to be verified, and writes HDF5, CSV, JSON, pictures and report.
///
/// # Errors
/// A folder that cannot be made, a study that fails, concerns under `strict`; then nothing is left behind.
pub fn run(case: &Case, options: &RunOptions, observer: &dyn Observer) -> Result<Summary, RunError> {
    let out = check_output(&options.out, options.overwrite)?;
    let mut outcomes: Vec<(&'static str, Outcome)> = Vec::new();
    for study in &case.studies {
        let outcome = study
            .run(&case.model, observer)
            .map_err(|source| RunError::Study { study: study.name(), source })?;
        outcomes.push((study.name(), outcome));
    }
    let verification =
        case.witness.as_ref().map(|witness| Verification::run(case, witness, &mut outcomes, observer));
    let concerns: Vec<Concern> = outcomes.iter().flat_map(|(_, o)| o.concerns.clone()).collect();
    if options.strict && !concerns.is_empty() {
        return Err(RunError::Strict { concerns });
    }
    let unwritable =
        |e: std::io::Error| RunError::Unwritable { path: options.out.clone(), reason: e.to_string() };
    let parent = out.parent().unwrap_or(&out);
    std::fs::create_dir_all(parent).map_err(unwritable)?;
    let staging =
        tempfile::Builder::new().prefix(&staging_prefix()).tempdir_in(parent).map_err(unwritable)?;
    observer.begin("writing", 1);
    write(case, &outcomes, verification.as_ref(), &concerns, staging.path())?;
    let files = folder::sign(staging.path()).map_err(unwritable)?;
    folder::install(staging.path(), &out)?;
    open_to_readers(&out);
    observer.advance();
    observer.end();
    let answers = outcomes.into_iter().map(|(name, o)| (name, o.answers)).collect();
    Ok(Summary { answers, verification, concerns, files })
}

/// A temporary folder is closed to others; a result is as open as any folder.
fn open_to_readers(folder: &Path) {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let _ = std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o755));
    }
    #[cfg(not(unix))]
    let _ = folder;
}

fn write(
    case: &Case,
    outcomes: &[(&'static str, Outcome)],
    verification: Option<&Verification>,
    concerns: &[Concern],
    folder: &Path,
) -> Result<(), RunError> {
    let mut attributes: Vec<(String, Attribute)> = vec![
        ("Conventions".into(), "CF-1.8".into()),
        ("title".into(), case.title.clone().into()),
        ("program".into(), "groundwave".into()),
        ("version".into(), env!("CARGO_PKG_VERSION").into()),
        ("solver".into(), report::solver(&case.model).into()),
        ("case_text".into(), case.text.clone().into()),
        ("case_files".into(), serde_json::json!(case.files).to_string().into()),
        ("concerns".into(), serde_json::json!(concerns).to_string().into()),
        (
            "axes".into(),
            "x along the track, positive in the direction of travel; y across it; z down; displacements and loads positive down"
                .into(),
        ),
    ];
    if let Some(source) = &case.source {
        attributes.push(("source".into(), source.clone().into()));
    }
    attributes.extend(verification.map(Verification::attributes).into_iter().flatten());
    let groups = outcomes.iter().map(|(_, o)| o.group.clone()).collect();
    hdf5::write(&Dataset { attributes, groups }, &folder.join("results.h5"))?;
    for (_, outcome) in outcomes {
        csv::write(&outcome.group, folder)?;
    }
    // drawing a PNG takes longer than computing it
    let pictures = outcomes
        .par_iter()
        .flat_map(|(_, outcome)| &outcome.figures)
        .map(|(figure, caption)| {
            plot::write(figure, folder)?;
            Ok((figure.title().to_owned(), caption.clone(), plot::svg(figure)?))
        })
        .collect::<Result<Vec<_>, OutputError>>()?;
    json::write(&summary(case, outcomes, verification, concerns), &folder.join("summary.json"))?;
    let html = report::report(case, outcomes, verification, concerns, pictures).html();
    let path = folder.join("report.html");
    std::fs::write(&path, html).map_err(|source| OutputError::Write { path, source })?;
    Ok(())
}

/// `summary.json`: one object per study with its answers as plain SI numbers, their units beside them.
fn summary(
    case: &Case,
    outcomes: &[(&'static str, Outcome)],
    verification: Option<&Verification>,
    concerns: &[Concern],
) -> serde_json::Value {
    let mut root = serde_json::Map::new();
    root.insert("program".into(), "groundwave".into());
    root.insert("version".into(), env!("CARGO_PKG_VERSION").into());
    root.insert("title".into(), case.title.clone().into());
    if let Some(source) = &case.source {
        root.insert("source".into(), source.clone().into());
    }
    let mut units = serde_json::Map::new();
    for (name, outcome) in outcomes {
        let numbers: serde_json::Map<_, _> =
            outcome.answers.iter().map(|a| (a.key.clone(), a.value.into())).collect();
        let of: serde_json::Map<_, _> =
            outcome.answers.iter().map(|a| (a.key.clone(), a.unit.into())).collect();
        root.insert((*name).into(), numbers.into());
        units.insert((*name).into(), of.into());
    }
    root.insert("units".into(), units.into());
    if let Some(verification) = verification {
        root.insert("verification".into(), verification.json());
    }
    root.insert("concerns".into(), serde_json::json!(concerns));
    root.into()
}

/// Case text and files stored in a `results.h5`.
pub(super) fn stored_case(path: &Path) -> Result<(String, BTreeMap<String, String>), String> {
    let read = |name: &str| hdf5::read_text_attribute(path, name);
    let files = serde_json::from_str(&read("case_files")?).map_err(|e| e.to_string())?;
    Ok((read("case_text")?, files))
}
