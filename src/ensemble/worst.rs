//! The samples that matter most, as case files that run by themselves.

use super::rows::Rows;
use super::table::Table;
use crate::case::{Case, Uncertain};

/// How many of them.
const MANY: usize = 10;

/// A sample that matters.
pub(super) struct Worst {
    /// Its number.
    pub sample: usize,
    /// Its answer [SI].
    pub value: f64,
    /// Name of its case file.
    pub file: String,
}

/// The samples with the least `answer`, or with the largest.
pub(super) fn worst(table: &Table, answer: &str, least: bool) -> Vec<Worst> {
    let mut all = table.of(answer);
    all.sort_by(|a, b| a.1.total_cmp(&b.1));
    if !least {
        all.reverse();
    }
    let file = |sample: usize| format!("worst_sample_{sample:05}.toml");
    all.into_iter().take(MANY).map(|(sample, value)| Worst { sample, value, file: file(sample) }).collect()
}

/// Their case files, and the files beside the case, by name.
pub(super) fn files(case: &Case, study: &Uncertain, rows: &Rows, worst: &[Worst]) -> Vec<(String, String)> {
    let own = worst.iter().map(|one| {
        let (_, text) = rows.case_of(one.sample, study);
        let head = format!("# sample {} of the study \"{}\"\n", one.sample, case.title);
        (one.file.clone(), head + &text)
    });
    // ground and track are written out; records lie beside the case
    let beside = case.files.iter().filter(|(name, _)| !name.contains(['/', '\\']));
    own.chain(beside.map(|(name, text)| (name.clone(), text.clone()))).collect()
}
