//! A measured history: read, assessed as a computed free field is, written as a run is.

use super::StudyFailed;
use super::runner::{Beside, Page, RunError, RunOptions, Summary, leave};
use crate::study::{Assessment, MeasuredHistory, RecordError};
use std::path::Path;
use thiserror::Error;

/// Lines of the record that stand in its report.
const SHOWN: usize = 12;

/// Why a record cannot be assessed.
#[derive(Debug, Error)]
pub enum AssessError {
    /// The file cannot be read.
    #[error("cannot read {path}: {reason}")]
    File {
        /// As given.
        path: String,
        /// Why.
        reason: String,
    },
    /// The file is no record.
    #[error("{path}: {source}")]
    Record {
        /// As given.
        path: String,
        /// Why.
        source: RecordError,
    },
    /// It could not be assessed, or written.
    #[error(transparent)]
    Run(#[from] RunError),
}

/// All measures of the record at `path`, held against `assessment`, left in a folder.
///
/// # Errors
/// A file that cannot be read or is no record; a folder that cannot be made. Then nothing is left behind.
pub fn assess(path: &Path, assessment: Assessment, options: &RunOptions) -> Result<Summary, AssessError> {
    let name = path.display().to_string();
    let text = std::fs::read_to_string(path)
        .map_err(|error| AssessError::File { path: name.clone(), reason: error.to_string() })?;
    let record = MeasuredHistory::parse(&text, assessment)
        .map_err(|source| AssessError::Record { path: name.clone(), source })?;
    let outcome = record.run().map_err(|source| RunError::from(StudyFailed { study: "record", source }))?;
    let file = path.file_name().map_or(name.clone(), |file| file.to_string_lossy().into_owned());
    let mut input: String = text.lines().take(SHOWN).map(|line| format!("{line}\n")).collect();
    if text.lines().count() > SHOWN {
        input += &format!("… ({} lines in all)\n", text.lines().count());
    }
    let mut assumptions = vec![
        "The mean of each direction is taken away; nothing else is done to the record before the filters of the measures.".to_owned(),
        "Third octaves: Butterworth filters of third order, running r.m.s. FAST; the passage lasts while the running r.m.s. of all frequencies is above a quarter of its largest value.".to_owned(),
        "Guide values hold inside buildings: what was measured elsewhere is compared, not judged.".to_owned(),
    ];
    if record.integrated {
        assumptions.push("Velocities are integrated from accelerations above 0.4 Hz.".to_owned());
    }
    let page = Page { title: format!("Measured history {file}"), input, assumptions, tables: Vec::new() };
    Ok(leave(vec![("record", outcome)], page, Beside::default(), options)?)
}
