//! TOML text → what it says, with every fault of its keys and types at once; files, with what keeps them from being read.

use super::conform;
use super::error::{CaseError, Finding, syntax};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::Path;

/// What a text says.
pub struct Read<T> {
    /// Without the spoilt tables; none where nothing can be said.
    pub said: Option<T>,
    /// Tables that hold a fault, or are probably meant by a misspelt name: not to be judged further.
    pub spoilt: BTreeSet<String>,
    /// Each fault.
    pub faults: Vec<CaseError>,
}

/// Reads the TOML `text`, called `name`; `stand_in` are a key and a value for it that let the rest be read where it is missing.
pub fn read<T: DeserializeOwned + JsonSchema>(
    text: &str,
    name: &str,
    stand_in: Option<(&str, &str)>,
) -> Read<T> {
    let mut table: toml::Table = match text.parse() {
        Ok(table) => table,
        Err(error) => {
            let faults = vec![syntax(&error, name, text)];
            return Read { said: None, spoilt: BTreeSet::new(), faults };
        }
    };
    let conform::Faults { findings, mut spoilt } =
        conform::faults(&table, schemars::schema_for!(T).as_value());
    let mut faults: Vec<CaseError> = findings.into_iter().map(|finding| finding.at(name, text)).collect();
    table.retain(|key, _| !spoilt.contains(key));
    if let Some((key, value)) = stand_in {
        table.entry(key).or_insert(value.into());
    }
    // what no schema can say, such as the unit of a speed
    let said = loop {
        let error = match serde_path_to_error::deserialize(table.clone()) {
            Ok(said) => break Some(said),
            Err(error) => error,
        };
        let path = error.path().to_string();
        let first = path.split(['.', '[']).next().unwrap_or_default().to_owned();
        let known = table.remove(&first).is_some();
        if known || faults.is_empty() {
            let path = if known { path } else { String::new() };
            faults.push(Finding::new(path, error.inner().message().trim_end()).at(name, text));
        }
        if !known {
            break None;
        }
        spoilt.insert(first);
    };
    Read { said, spoilt, faults }
}

/// The same of a file that stands for one table.
///
/// # Errors
/// Its faults.
pub fn whole<T: DeserializeOwned + JsonSchema>(text: &str, name: &str) -> Result<T, CaseError> {
    match read(text, name, None) {
        Read { said: Some(said), faults, .. } if faults.is_empty() => Ok(said),
        Read { faults, .. } => Err(CaseError::all(faults, name)),
    }
}

/// The text of the file at `path`.
///
/// # Errors
/// Why not, in plain words.
pub fn text(path: &Path) -> Result<String, String> {
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::PermissionDenied => "reading it is not permitted".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string(),
    })?;
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err("it is UTF-16 text: save it as UTF-8".to_owned());
    }
    String::from_utf8(bytes).map_err(|error| {
        let from = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let line = 1 + bytes[..from].iter().filter(|byte| **byte == b'\n').count();
        format!("line {line} is not UTF-8 text (byte {:02X}): save the file as UTF-8", bytes[from])
    })
}
