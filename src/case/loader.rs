//! The tables of a case: written out, by library name, or from files beside it, with every fault at its place.

use super::error::{CaseError, Finding};
use super::values::Named;
use super::{faults, library, profile_csv};
use serde::de::DeserializeOwned;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// A table in full, by library name, or from a TOML file beside the case: the table, the path prefix of its keys,
/// and the file they stand in.
pub struct Resolved<T> {
    pub table: T,
    pub prefix: String,
    pub name: String,
    pub text: String,
    /// What it was read from: the text, or that with what a library brings.
    pub read: String,
}

impl<T> Resolved<T> {
    /// Path of its key `rest`.
    pub fn at(&self, rest: &str) -> String {
        match (self.prefix.as_str(), rest) {
            (prefix, "") => prefix.to_owned(),
            ("", rest) => rest.to_owned(),
            (prefix, rest) => format!("{prefix}.{rest}"),
        }
    }

    /// A `message` about its key `rest`.
    pub fn fault(&self, rest: &str, message: impl ToString) -> CaseError {
        Finding::new(self.at(rest), message).at(&self.name, &self.text)
    }

    /// The same with advice.
    pub fn advise(&self, rest: &str, message: impl ToString, help: impl Into<String>) -> CaseError {
        Finding::new(self.at(rest), message).help(help).at(&self.name, &self.text)
    }
}

/// The table of a case that an entry on the shelf `kind` of the library stands for.
pub fn root(kind: &str) -> &'static str {
    match kind {
        "soils" => "soil",
        "tracks" => "track",
        _ => "train",
    }
}

/// The case file and what was read beside it.
pub struct Loader<'a> {
    /// What messages call the case file.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
    /// The same with the keys of a library track that it changes.
    pub read: &'a str,
    /// Reads a file beside the case.
    pub open: &'a dyn Fn(&str) -> Result<String, String>,
    /// What was read, by name.
    pub files: RefCell<BTreeMap<String, String>>,
    /// What every file beside the case that stands for a table stands for, its name and text.
    pub tables: RefCell<Vec<(&'static str, String, String)>>,
    /// Sources of library entries.
    pub references: RefCell<Vec<String>>,
    /// Tables of the case that hold faults, or are meant by misspelt ones.
    pub spoilt: BTreeSet<String>,
    /// Every fault found so far.
    pub faults: RefCell<Vec<CaseError>>,
}

impl<'a> Loader<'a> {
    /// A loader of the file `name` with contents `text`, beside which `open` reads others.
    pub fn of(name: &'a str, text: &'a str, open: &'a dyn Fn(&str) -> Result<String, String>) -> Self {
        Self {
            name,
            text,
            read: text,
            open,
            files: RefCell::default(),
            tables: RefCell::default(),
            references: RefCell::default(),
            spoilt: BTreeSet::new(),
            faults: RefCell::default(),
        }
    }

    /// A fault of the case file.
    pub fn fault(&self, finding: Finding) -> CaseError {
        finding.at(self.name, self.text)
    }

    /// What there is of `result`; its faults are kept.
    pub fn keep<T>(&self, result: Result<T, CaseError>) -> Option<T> {
        result.map_err(|fault| self.faults.borrow_mut().extend(fault.each())).ok()
    }

    /// Whether the case says nothing, not even something faulty, of the table `key`, which was not read.
    pub fn lacks(&self, key: &str) -> bool {
        !self.spoilt.contains(key)
    }

    /// The text of the file `name` beside the case, remembered.
    pub fn file(&self, name: &str) -> Result<String, String> {
        let text = (self.open)(name)?;
        self.files.borrow_mut().insert(name.to_owned(), text.clone());
        Ok(text)
    }

    /// The table that `named` is or stands for, at `key` of the case; `kind` is its shelf in the library.
    pub fn resolve<T: DeserializeOwned + Clone>(
        &self,
        named: &Named<T>,
        key: &str,
        kind: &str,
    ) -> Result<Resolved<T>, CaseError> {
        let wanted = match named {
            Named::Table(table) => {
                return Ok(Resolved {
                    table: table.clone(),
                    prefix: key.to_owned(),
                    name: self.name.to_owned(),
                    text: self.text.to_owned(),
                    read: self.read.to_owned(),
                });
            }
            Named::Name(wanted) => wanted,
        };
        let profile = kind == "soils" && wanted.ends_with(".csv");
        let (name, text) = if profile || wanted.ends_with(".toml") {
            let mut text = self.file(wanted).map_err(|reason| {
                self.fault(
                    Finding::new(key, format!("cannot read \"{wanted}\": {reason}"))
                        .help("the path is relative to the case file"),
                )
            })?;
            if profile {
                text = profile_csv::toml(&text).map_err(|finding| finding.at(wanted, &text))?;
            }
            (wanted.clone(), self.table(kind, wanted, text))
        } else {
            match library::find(kind, wanted, key) {
                Ok(entry) => {
                    let name = format!("library/{kind}/{wanted}.toml");
                    self.files.borrow_mut().insert(name.clone(), entry.text.to_owned());
                    let title = entry.text_of("title").unwrap_or_default();
                    let source = entry.text_of("source").unwrap_or_default();
                    let reference = format!("{wanted}: {title}. {source}");
                    let mut references = self.references.borrow_mut();
                    if !references.contains(&reference) {
                        references.push(reference);
                    }
                    (name, entry.text.to_owned())
                }
                Err(mut finding) => {
                    let beside = format!("{wanted}.toml");
                    let text = self.file(&beside).map_err(|reason| {
                        finding.message += &format!("; {beside} beside the case: {reason}");
                        self.fault(finding)
                    })?;
                    (beside.clone(), self.table(kind, &beside, text))
                }
            }
        };
        let table = faults::whole(&text, &name, root(kind))?;
        Ok(Resolved { table, prefix: String::new(), name, read: text.clone(), text })
    }

    /// The `text` of the file `name` beside the case, remembered as a table of `kind`.
    fn table(&self, kind: &str, name: &str, text: String) -> String {
        let table = (root(kind), name.to_owned(), text.clone());
        let mut tables = self.tables.borrow_mut();
        if !tables.contains(&table) {
            tables.push(table);
        }
        text
    }
}
