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
    /// Several faults, in the order of their lines, those of the case before those of other files.
    #[error("{count} faults:\n{list}", count = faults.len(), list = listed(faults))]
    Several {
        /// Each of them.
        faults: Vec<CaseError>,
    },
    /// Something in the file is wrong.
    #[error("{message}")]
    Invalid {
        /// Path of the key, such as `soil.layer[1].poisson`; empty for the file itself.
        key: String,
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

fn listed(faults: &[CaseError]) -> String {
    faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

impl CaseError {
    /// The faults one by one.
    pub fn each(self) -> Vec<CaseError> {
        match self {
            Self::Several { faults } => faults.into_iter().flat_map(Self::each).collect(),
            fault => vec![fault],
        }
    }

    /// `faults` as one error, in the order of their lines in `first`, then in other files; what has no line comes last.
    pub fn all(faults: impl IntoIterator<Item = CaseError>, first: &str) -> Self {
        let mut faults: Vec<CaseError> = faults.into_iter().flat_map(Self::each).collect();
        faults.sort_by_key(|fault| match fault {
            Self::Invalid { text, span, .. } => {
                let name = text.name().to_owned();
                (name != first, name, span.map_or(usize::MAX, |span| span.offset()))
            }
            _ => (true, String::new(), usize::MAX),
        });
        match (faults.pop(), faults.is_empty()) {
            (Some(only), true) => only,
            (last, _) => Self::Several { faults: faults.into_iter().chain(last).collect() },
        }
    }

    /// The key it is about.
    pub fn key(&self) -> &str {
        match self {
            Self::Invalid { key, .. } => key,
            _ => "",
        }
    }
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
    /// The key that is missing, or that is meant by a misspelt one.
    pub wanted: Option<&'static str>,
    /// Whether the key itself is wrong, not its value.
    on_key: bool,
}

impl Finding {
    /// A finding without advice.
    pub fn new(path: impl Into<String>, message: impl ToString) -> Self {
        Self { path: path.into(), message: message.to_string(), help: None, wanted: None, on_key: false }
    }

    /// A number out of its range, in the table at `path` (empty for the file itself).
    pub fn out_of_range(path: &str, error: OutOfRange) -> Self {
        Self::new([path, error.key].join(if path.is_empty() { "" } else { "." }), error)
    }

    /// The same about the key itself, which does not exist; `meant` is one that does.
    pub fn of_key(mut self, meant: Option<&'static str>) -> Self {
        (self.on_key, self.wanted) = (true, meant);
        self
    }

    /// The same about a table that lacks `key`.
    pub fn lacking(mut self, key: &'static str) -> Self {
        self.wanted = Some(key);
        self
    }

    /// Whether it is about a key that does not exist.
    pub fn on_key(&self) -> bool {
        self.on_key
    }

    /// The key that is missing, if it is about one.
    pub fn lacks(&self) -> Option<&'static str> {
        self.wanted.filter(|_| !self.on_key)
    }

    /// The same about a table at `path` in a larger one.
    pub fn below(mut self, path: &str) -> Self {
        self.path = if self.path.is_empty() { path.to_owned() } else { format!("{path}.{}", self.path) };
        self
    }

    /// The same with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The finding as an error of the file `name` with contents `text`.
    pub fn at(self, name: &str, text: &str) -> CaseError {
        let span = locate(text, &self.path, self.on_key).map(SourceSpan::from);
        let message = match (self.path.is_empty(), span) {
            (true, None) => format!("{name}: {}", self.message),
            (true, _) => self.message,
            (false, _) => format!("{}: {}", self.path, self.message),
        };
        CaseError::Invalid {
            key: self.path,
            message,
            text: NamedSource::new(name, text.to_owned()),
            span,
            label: "here".into(),
            help: self.help,
        }
    }
}

/// Where the value at a key path stands, or its key: the longest part of the path that exists.
fn locate(text: &str, path: &str, on_key: bool) -> Option<std::ops::Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let mut span = None;
    let mut table = Some(document.get_ref());
    let mut value: Option<&DeValue> = None;
    for step in path.split(['.', '[']).map(|s| s.trim_end_matches(']')).filter(|s| !s.is_empty()) {
        let (key, next) = match (table, value, step.parse::<usize>()) {
            (_, Some(DeValue::Array(array)), Ok(index)) => (None, array.get(index)?),
            (Some(table), _, _) => match table.get_key_value(step) {
                Some((key, next)) => (Some(key.span()), next),
                None => break,
            },
            _ => break,
        };
        span = Some(key.filter(|_| on_key).unwrap_or(next.span()));
        value = Some(next.get_ref());
        table = next.get_ref().as_table();
    }
    span
}

/// Which of `allowed` is probably meant by `found`, if any is near enough, or begins with it.
pub fn nearest<'a>(found: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let distance = |a: &str| match found.len() >= 3 && a.starts_with(found) {
        true => 1,
        false => strsim::damerau_levenshtein(found, a),
    };
    let near = allowed.iter().map(|a| (distance(a), *a)).min();
    near.filter(|(distance, a)| *distance <= 2.max(a.len() / 3)).map(|(_, a)| a)
}

/// Advice from the names of what is allowed.
pub fn spelling(found: &str, allowed: &[&str]) -> String {
    let meant = nearest(found, allowed).map(|a| format!("did you mean `{a}`? ")).unwrap_or_default();
    format!("{meant}allowed: {}", allowed.join(", "))
}

/// What keeps `text` from being TOML at all.
pub fn syntax(error: &toml::de::Error, name: &str, text: &str) -> CaseError {
    let span = error.span();
    let start = span.as_ref().map_or(0, |span| span.start.min(text.len()));
    let from = text[..start].rfind('\n').map_or(0, |end| end + 1);
    let line = text[from..].lines().next().unwrap_or_default();
    let (_, value) = line.split_once('=').unwrap_or_default();
    let decimal_comma = value.trim().split_once(',').is_some_and(|(whole, rest)| {
        whole.parse::<f64>().is_ok() && rest.starts_with(|c: char| c.is_ascii_digit())
    });
    let help = if decimal_comma {
        "decimals have a point: 0.35, not 0,35"
    } else {
        "a case file is TOML: key = number, key = \"text\", lists in [ ], tables under [name]; `groundwave new` writes one"
    };
    // without what the parser would have liked, in its own terms
    let reason = error.message().split(", expected").next().unwrap_or_default().trim_end();
    CaseError::Invalid {
        key: String::new(),
        message: format!("the file cannot be read from here on: {reason}"),
        text: NamedSource::new(name, text.to_owned()),
        span: span.map(SourceSpan::from),
        label: "here".into(),
        help: Some(help.into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_values_by_path() {
        let text = "[soil]\nx = 1\n[[soil.layer]]\nyoung = 3\n[[soil.layer]]\nyoung = 42\n";
        let span = locate(text, "soil.layer[1].young", false).unwrap();
        assert_eq!(&text[span], "42");
        assert!(locate(text, "soil.layer[1].poisson", false).is_some());
    }

    #[test]
    fn suggests_the_nearest_spelling() {
        assert!(spelling("youngs", &["young", "poisson"]).starts_with("did you mean `young`?"));
        assert!(spelling("pitch", &["mass", "pitch_inertia"]).starts_with("did you mean `pitch_inertia`?"));
        assert!(spelling("zzz", &["young", "poisson"]).starts_with("allowed"));
    }
}
