//! Files beside a case, and what keeps them from being read, in plain words.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

/// The text of the file at `path`.
///
/// # Errors
/// Why there is none.
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

/// Case text and files stored in the `results.h5` at `path`.
///
/// # Errors
/// No such file, or not one of this program.
#[cfg(feature = "files")]
pub fn stored(path: &Path) -> Result<(String, BTreeMap<String, String>), String> {
    let read = |name: &str| crate::output::hdf5::read_text_attribute(path, name);
    let files = serde_json::from_str(&read("case_files")?).map_err(|e| e.to_string())?;
    Ok((read("case_text")?, files))
}

/// Nothing: HDF5 is not among the features.
///
/// # Errors
/// Always.
#[cfg(not(feature = "files"))]
pub fn stored(_: &Path) -> Result<(String, BTreeMap<String, String>), String> {
    Err("this build of groundwave reads no HDF5 (feature `files`)".to_owned())
}
