//! Ten thousand grounds: samples of an uncertain case, run in chunks that survive any end, and gathered into one result.
//!
//! ```text
//! Case with [study] ─► Rows: samples, the case as it stands, steps for derivatives ─► chunks/00012.json, each whole or not there
//!                                    shards on many machines                                          │ gather
//!                                                                                                     ▼
//!                                         Table ─► quantiles, probabilities, sensitivities, worst samples, study.h5, report
//! ```

mod chunk;
mod columns;
mod derivative;
mod error;
mod figures;
mod gather;
mod identity;
mod place;
mod row;
mod rows;
mod shown;
pub mod statistics;
mod table;
mod tables;
mod view;
mod worst;

pub use chunk::Chunk;
pub use derivative::{Derivative, derivatives};
pub use error::EnsembleError;
pub use gather::{gather, outcomes, table};
pub use place::sweep;
pub use row::{Described, Row};
pub use rows::{CHUNK, Kind, Rows, STEP};
pub use table::{Curves, Table};

use crate::case::Case;
use crate::progress::Observer;
use identity::Identity;
use place::Place;
use rayon::prelude::*;
use std::path::Path;

/// Which part of a study one process runs: every `of`-th chunk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: usize,
    of: usize,
}

impl Shard {
    /// The whole study.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Number `number` of `of`, counted from 1.
    ///
    /// # Errors
    /// A number that is not among them.
    pub fn new(number: usize, of: usize) -> Result<Self, EnsembleError> {
        if (1..=of).contains(&number) {
            Ok(Self { number, of })
        } else {
            Err(EnsembleError::Shard { number, of })
        }
    }

    /// Whether a chunk belongs to it.
    fn has(self, chunk: usize) -> bool {
        chunk % self.of == self.number - 1
    }
}

/// What a process has done for a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Done {
    /// Rows it computed.
    pub rows: usize,
    /// Rows of its shard that were there.
    pub found: usize,
    /// Chunks of the whole study that are there now.
    pub chunks: usize,
    /// Chunks of the whole study.
    pub of: usize,
}

/// Runs the rows of the study of `case` that belong to `shard` and are not yet in the folder `out`, chunk by chunk.
///
/// Chunks and their rows run on all threads; what they hold does not depend on threads, shards, or how often it was begun.
///
/// # Errors
/// A case without `[study]`, a folder of another study or of something else, a disk that is full, a call to stop. A row that
/// cannot be computed is none: it says why, in its place.
pub fn run(case: &Case, out: &Path, shard: Shard, observer: &dyn Observer) -> Result<Done, EnsembleError> {
    let study = case.study.as_ref().ok_or(EnsembleError::NoStudy)?;
    let rows = Rows::of(study);
    let identity = Identity::of(case);
    let place = Place::claim(out, &identity)?;
    let (missing, found): (Vec<usize>, Vec<usize>) =
        (0..rows.chunks()).filter(|chunk| shard.has(*chunk)).partition(|chunk| !place.holds(*chunk));
    let count = |chunks: &[usize]| chunks.iter().map(|chunk| rows.of_chunk(*chunk).len()).sum();
    observer.begin("samples", count(&missing) as u64);
    missing.par_iter().try_for_each(|number| {
        let chunk =
            Chunk::run(case, study, (&rows, *number), &identity, observer).ok_or(EnsembleError::Cancelled)?;
        place.write(*number, &chunk)
    })?;
    observer.end();
    let chunks = (0..rows.chunks()).filter(|chunk| place.holds(*chunk)).count();
    Ok(Done { rows: count(&missing), found: count(&found), chunks, of: rows.chunks() })
}
