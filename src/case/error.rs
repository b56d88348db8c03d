//! One clear message for bad input: file, line, key, what was found, what is allowed, the nearest spelling.

use crate::quantity::OutOfRange;
use miette::{Diagnostic, NamedSource, SourceSpan};
use std::path::PathBuf;
use thiserror::Error;
use toml::de::{DeTable, DeValue};

/// Why a case cannot be used.
#[derive(Debug, Diagnostic, Error)]
pub enum CaseError {
    /// The file cannot be read.
    #[error("cannot read {path}: {reason}", path = path.display())]
    Read {
        /// Which.
        path: PathBuf,
        /// Why.
        reason: String,
        /// What to do.
        #[help]
        help: String,
    },
    /// Something in the file is wrong.
    #[error("{message}")]
    Invalid {
        /// What is wrong.
        message: String,
        /// The file.
        #[source_code]
        text: NamedSource<String>,
        /// Where.
        #[label("{label}")]
        span: Option<SourceSpan>,
        /// What stands there.
        label: String,
        /// What is allowed.
        #[help]
        help: Option<String>,
    },
}

/// A fault found at a key path such as `soil.layer[1].poisson`.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Key path.
    pub path: String,
    /// What is wrong.
    pub message: String,
    /// What is allowed.
    pub help: Option<String>,
}

impl Finding {
    /// A finding without advice.
    pub fn new(path: impl Into<String>, message: impl ToString) -> Self {
        Self { path: path.into(), message: message.to_string(), help: None }
    }

    /// A number out of its range, in the table at `path` (empty for the file itself).
    pub fn out_of_range(path: &str, error: OutOfRange) -> Self {
        Self::new([path, error.key].join(if path.is_empty() { "" } else { "." }), error)
    }

    /// The same with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The finding as an error of the file `name` with contents `text`.
    pub fn at(self, name: &str, text: &str) -> CaseError {
        let span = locate(text, &self.path).map(SourceSpan::from);
        let message =
            if self.path.is_empty() { self.message } else { format!("{}: {}", self.path, self.message) };
        CaseError::Invalid {
            message,
            text: NamedSource::new(name, text.to_owned()),
            span,
            label: "here".into(),
            help: self.help,
        }
    }
}

/// Where the value at a key path stands: the longest part of the path that exists.
fn locate(text: &str, path: &str) -> Option<std::ops::Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let mut span = None;
    let mut table = Some(document.get_ref());
    let mut value: Option<&DeValue> = None;
    for step in path.split(['.', '[']).map(|s| s.trim_end_matches(']')).filter(|s| !s.is_empty()) {
        let next = match (table, value, step.parse::<usize>()) {
            (_, Some(DeValue::Array(array)), Ok(index)) => array.get(index)?,
            (Some(table), _, _) => match table.get_key_value(step) {
                Some((_, next)) => next,
                None => break,
            },
            _ => break,
        };
        span = Some(next.span());
        value = Some(next.get_ref());
        table = next.get_ref().as_table();
    }
    span
}

/// "did you mean `young`?", or nothing near enough.
fn nearest(found: &str, allowed: &[&str]) -> Option<String> {
    allowed
        .iter()
        .map(|a| (strsim::damerau_levenshtein(found, a), *a))
        .min()
        .filter(|(distance, a)| *distance <= 2.max(a.len() / 3))
        .map(|(_, a)| format!("did you mean `{a}`? "))
}

/// Advice from the names of what is allowed.
pub fn spelling(found: &str, allowed: &[&str]) -> String {
    format!("{}allowed: {}", nearest(found, allowed).unwrap_or_default(), allowed.join(", "))
}

/// A file that is no TOML.
pub fn syntax(error: &toml::de::Error, name: &str, text: &str) -> CaseError {
    CaseError::Invalid {
        message: error.message().trim_end().to_owned(),
        text: NamedSource::new(name, text.to_owned()),
        span: error.span().map(SourceSpan::from),
        label: "here".into(),
        help: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_values_by_path() {
        let text = "[soil]\nx = 1\n[[soil.layer]]\nyoung = 3\n[[soil.layer]]\nyoung = 42\n";
        let span = locate(text, "soil.layer[1].young").unwrap();
        assert_eq!(&text[span], "42");
        assert!(locate(text, "soil.layer[1].poisson").is_some());
    }

    #[test]
    fn suggests_the_nearest_spelling() {
        assert!(spelling("youngs", &["young", "poisson"]).starts_with("did you mean `young`?"));
        assert!(spelling("zzz", &["young", "poisson"]).starts_with("allowed"));
    }
}
