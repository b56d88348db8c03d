//! JSON documents such as `summary.json`.

use super::{OutputError, save};
use serde_json::Value;
use std::path::Path;

/// Writes `value` to `path`, indented, ending in a newline.
///
/// serde_json turns a NaN or an infinity into `null`; a summary with a hole in it must not pass for a result.
///
/// # Errors
/// [`OutputError::NotFinite`] naming the first key that is null; [`OutputError::Write`] if the file cannot be written.
pub fn write(value: &Value, path: &Path) -> Result<(), OutputError> {
    if let Some(key) = null_key(value) {
        return Err(OutputError::NotFinite { path: path.to_owned(), key });
    }
    save(path, format!("{value:#}\n").as_bytes())
}

/// The path of the first null within `value`, e.g. `a.b[2]`; empty for a document that is null.
fn null_key(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some(String::new()),
        Value::Array(items) => items
            .iter()
            .enumerate()
            .find_map(|(index, item)| null_key(item).map(|rest| join(&format!("[{index}]"), &rest))),
        Value::Object(map) => map.iter().find_map(|(key, item)| null_key(item).map(|rest| join(key, &rest))),
        _ => None,
    }
}

fn join(head: &str, rest: &str) -> String {
    let dot = if rest.is_empty() || rest.starts_with('[') { "" } else { "." };
    format!("{head}{dot}{rest}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_written_reads_back() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("summary.json");
        let value = json!({"speed": 0.1 + 0.2, "names": ["a", "b"], "ok": true});
        write(&value, &path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
        assert!(text.contains("\n  \"speed\": 0.30000000000000004"), "{text}");
    }

    #[test]
    fn a_number_that_is_not_finite_is_refused_by_name() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("summary.json");
        let value = json!({"a": {"b": [1.0, f64::NAN]}});
        let error = write(&value, &path).unwrap_err();
        assert!(error.to_string().contains("`a.b[1]`"), "{error}");
        assert!(!path.exists());
    }
}
