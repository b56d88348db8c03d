//! What makes two studies the same: case, files, program, generator.

use crate::case::Case;
use crate::sampling::{GENERATOR, fingerprint};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What `study.json` says.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct Identity {
    pub program: String,
    pub version: String,
    pub generator: String,
    /// Rows of a chunk.
    pub chunk: usize,
    pub case_text: String,
    pub case_files: BTreeMap<String, String>,
}

impl Identity {
    pub fn of(case: &Case) -> Self {
        Self {
            program: "groundwave".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            generator: GENERATOR.into(),
            chunk: super::CHUNK,
            case_text: case.text.clone(),
            case_files: case.files.clone(),
        }
    }

    /// Sixteen digits that tell it from others.
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", fingerprint(format!("{self:?}").as_bytes()))
    }

    /// How `other` differs, in words; None where it does not.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let texts = [
            ("its program is", &self.program, &other.program),
            ("its version is", &self.version, &other.version),
            ("its generator is", &self.generator, &other.generator),
        ];
        if let Some((what, mine, theirs)) = texts.into_iter().find(|(_, mine, theirs)| mine != theirs) {
            return Some(format!("{what} {theirs}, this one {mine}"));
        }
        if self.chunk != other.chunk {
            return Some(format!("its chunks have {} rows, these {}", other.chunk, self.chunk));
        }
        if self.case_text != other.case_text {
            let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
            let (mine, theirs) = (lines(&self.case_text), lines(&other.case_text));
            let same = mine.iter().zip(&theirs).take_while(|(a, b)| a == b).count();
            let line = |of: &[String]| {
                of.get(same).map_or("nothing".to_owned(), |line| format!("`{}`", line.trim()))
            };
            let (mine, theirs) = (line(&mine), line(&theirs));
            return Some(format!("line {} of its case is {theirs}, of this one {mine}", same + 1));
        }
        let names = self.case_files.keys().chain(other.case_files.keys());
        let file = names.into_iter().find(|name| self.case_files.get(*name) != other.case_files.get(*name));
        file.map(|name| format!("the file {name} beside its case is another one"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_told() {
        let one = Identity {
            program: "groundwave".into(),
            version: "1".into(),
            generator: "g".into(),
            chunk: 25,
            case_text: "a\nb\nc".into(),
            case_files: BTreeMap::from([("x.csv".into(), "1".into())]),
        };
        let said = |other: Identity| one.difference(&other).unwrap();
        assert_eq!(one.difference(&one.clone()), None);
        assert!(said(Identity { version: "2".into(), ..one.clone() }).contains("version is 2, this one 1"));
        let other = said(Identity { case_text: "a\nB\nc".into(), ..one.clone() });
        assert_eq!(other, "line 2 of its case is `B`, of this one `b`");
        let longer = said(Identity { case_text: "a\nb\nc\nd".into(), ..one.clone() });
        assert_eq!(longer, "line 4 of its case is `d`, of this one nothing");
        assert!(said(Identity { case_files: BTreeMap::new(), ..one.clone() }).contains("x.csv"));
        assert_ne!(one.fingerprint(), Identity { version: "2".into(), ..one.clone() }.fingerprint());
    }
}
