//! Files that appear whole or not at all.

use super::OutputError;
use std::path::Path;

/// Lets `fill` write a file aside, in the same folder, and renames it to `path` once it is complete.
///
/// A reader, or a run cut short, never meets half a file. What was left aside is removed when `fill` fails.
pub(super) fn whole(
    path: &Path,
    fill: impl FnOnce(&Path) -> Result<(), OutputError>,
) -> Result<(), OutputError> {
    let failed = |source| OutputError::Write { path: path.to_owned(), source };
    let Some(name) = path.file_name() else {
        return Err(failed(std::io::Error::other("the path names no file")));
    };
    let mut aside_name = std::ffi::OsString::from(".");
    aside_name.push(name);
    aside_name.push(format!(".{}.partial", std::process::id()));
    let aside = path.with_file_name(aside_name);
    let done = fill(&aside).and_then(|()| std::fs::rename(&aside, path).map_err(failed));
    if done.is_err() {
        // The first error is the one worth reporting.
        let _ = std::fs::remove_file(&aside);
    }
    done
}

/// Writes `bytes` to `path`, whole.
pub(super) fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    whole(path, |aside| {
        std::fs::write(aside, bytes).map_err(|source| OutputError::Write { path: path.to_owned(), source })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.txt");
        let result = whole(&path, |aside| {
            std::fs::write(aside, "half").unwrap();
            Err(OutputError::NotFinite { path: path.clone(), key: "x".into() })
        });
        assert!(result.is_err());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_missing_folder_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let error = write_bytes(&dir.path().join("no/a.txt"), b"x").unwrap_err();
        assert!(error.to_string().contains("a.txt"), "{error}");
    }
}
