//! Why a study cannot be run or gathered.

use crate::case::{CaseError, RunError};
use crate::output::OutputError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a study cannot be run or gathered.
#[derive(Debug, Error)]
pub enum EnsembleError {
    /// Nothing is uncertain.
    #[error("the case has no [study]: add one, with samples and [[study.vary]], or use `groundwave run`")]
    NoStudy,
    /// A shard that is none.
    #[error("shard {number}/{of}: shards are counted from 1 to {of}, as in --shard 1/3, 2/3, 3/3")]
    Shard {
        /// Which.
        number: usize,
        /// Of how many.
        of: usize,
    },
    /// The folder holds something else.
    #[error("{} holds no study, but {found}: give another --out", path.display())]
    Foreign {
        /// Which.
        path: PathBuf,
        /// What stands there.
        found: String,
    },
    /// There is no study to gather.
    #[error("{} holds no study: {why}; name the folder that `groundwave study` has put its chunks in", path.display())]
    Nothing {
        /// Which folder.
        path: PathBuf,
        /// What is missing.
        why: &'static str,
    },
    /// The folder holds another study.
    #[error("{} holds another study: {difference}; give another --out, or remove that folder", path.display())]
    Mixed {
        /// The folder, or the chunk.
        path: PathBuf,
        /// How it differs.
        difference: String,
    },
    /// Some chunks are not there.
    #[error(
        "the study in {} is not complete: {} of {of} chunks lack: {}; run `groundwave study` again with the same case and --out, or the \
         shards that have not ended",
        path.display(), missing.len(), listed(missing)
    )]
    Incomplete {
        /// Which folder.
        path: PathBuf,
        /// Numbers of the chunks.
        missing: Vec<usize>,
        /// How many there should be.
        of: usize,
    },
    /// A file of the study cannot be read.
    #[error("cannot read {}: {reason}", path.display())]
    Read {
        /// Which.
        path: PathBuf,
        /// Why, and what to do.
        reason: String,
    },
    /// A file of the study cannot be written.
    #[error("cannot write to {}: {source}; the same command goes on from what is there", path.display())]
    Write {
        /// Where.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The case of the study cannot be read.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The results cannot be left.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A picture or a table cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Told to stop.
    #[error("cancelled; the same command goes on from what is there")]
    Cancelled,
}

/// "3, 7 to 12, 20 and 5 more"
fn listed(numbers: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for &number in numbers {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => runs.push((number, number)),
        }
    }
    let text =
        |(from, to): &(usize, usize)| if from == to { format!("{from}") } else { format!("{from} to {to}") };
    let shown: Vec<String> = runs.iter().take(8).map(text).collect();
    let rest: usize = runs.iter().skip(8).map(|(from, to)| to - from + 1).sum();
    let more = if rest == 0 { String::new() } else { format!(" and {rest} more") };
    format!("{}{more}", shown.join(", "))
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn chunks_are_listed_in_runs() {
        assert_eq!(listed(&[0, 1, 2, 7, 9, 10]), "0 to 2, 7, 9 to 10");
        let odd: Vec<usize> = (0..12).map(|i| 2 * i).collect();
        assert_eq!(listed(&odd), "0, 2, 4, 6, 8, 10, 12, 14 and 4 more");
    }
}
