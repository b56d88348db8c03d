//! `[report]`: for whom a report is, and by whom.

use super::error::Finding;
use schemars::JsonSchema;
use serde::Deserialize;

/// What stands at the head of a report, beside its title.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Report")]
pub struct About {
    /// Name of the project.
    pub project: Option<String>,
    /// For whom.
    pub client: Option<String>,
    /// By whom.
    pub author: Option<String>,
    /// Of the report, as it shall be printed: "2026-11-27", "27 November 2026".
    pub date: Option<String>,
    /// Number of the document or of its revision.
    pub reference: Option<String>,
}

/// Longest line of a head.
const LONGEST: usize = 200;

impl About {
    fn named(&self) -> [(&'static str, Option<&String>); 5] {
        [
            ("project", self.project.as_ref()),
            ("client", self.client.as_ref()),
            ("author", self.author.as_ref()),
            ("date", self.date.as_ref()),
            ("reference", self.reference.as_ref()),
        ]
    }

    /// Refuses what is empty, or no line of a head.
    pub fn faults(&self) -> Vec<Finding> {
        let mut faults = Vec::new();
        for (key, text) in self.named() {
            let Some(text) = text else { continue };
            let message = if text.trim().is_empty() {
                "the text is empty"
            } else if text.chars().count() > LONGEST || text.contains(['\n', '\r']) {
                "the text is no single line of at most 200 characters"
            } else {
                continue;
            };
            faults.push(Finding::new(format!("report.{key}"), message).help("give it, or remove the key"));
        }
        faults
    }

    /// What there is, as rows of a head.
    pub fn rows(&self) -> Vec<(String, String)> {
        let capital = |key: &str| key[..1].to_uppercase() + &key[1..];
        self.named().into_iter().filter_map(|(key, text)| Some((capital(key), text?.clone()))).collect()
    }
}
