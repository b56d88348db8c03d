//! A chunk: a few rows and what their numbers are, one file.

use super::identity::Identity;
use super::row::{Described, Row};
use super::rows::Rows;
use crate::case::{Case, Uncertain};
use crate::progress::Observer;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Rows that stand in one file.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Chunk {
    /// Of the study they belong to.
    pub fingerprint: String,
    /// What answers and curves are, by their names.
    pub described: BTreeMap<String, Described>,
    /// In the order of their numbers.
    pub rows: Vec<Row>,
}

impl Chunk {
    /// Runs chunk `number`; None where it is told to stop.
    pub(super) fn run(
        case: &Case,
        study: &Uncertain,
        (rows, number): (&Rows, usize),
        identity: &Identity,
        observer: &dyn Observer,
    ) -> Option<Self> {
        let one = |row: usize| {
            if observer.cancelled() {
                return None;
            }
            let (values, text) = rows.case_of(row, study);
            let mut described = BTreeMap::new();
            let done = Row::run((row, values, &text), case, &mut described, observer)?;
            observer.advance();
            Some((done, described))
        };
        let done: Vec<(Row, BTreeMap<String, Described>)> =
            rows.of_chunk(number).into_par_iter().map(one).collect::<Option<_>>()?;
        let mut described = BTreeMap::new();
        let rows = done.into_iter().map(|(row, of)| {
            described.extend(of);
            row
        });
        let rows = rows.collect();
        Some(Self { fingerprint: identity.fingerprint(), described, rows })
    }
}
