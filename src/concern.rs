//! Adequacy as a first-class value: what a result may be doubted for, with numbers and a remedy.

use serde::Serialize;

/// One reason to doubt a result. Shown, stored in every output, exit code 1 under `--strict`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Concern {
    /// Short stable name, kebab-case, e.g. `wrap-around`.
    pub code: &'static str,
    /// What was found, with the number and the limit.
    pub message: String,
    /// What the user can do about it.
    pub remedy: String,
}

impl Concern {
    /// A concern from its parts.
    pub fn new(code: &'static str, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { code, message: message.into(), remedy: remedy.into() }
    }
}

impl std::fmt::Display for Concern {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {} ({})", self.code, self.message, self.remedy)
    }
}
