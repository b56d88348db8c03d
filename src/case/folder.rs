//! The output folder: appears whole, and replaces only what this program wrote.

use super::RunError;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What a results folder holds: how the program knows its own again.
pub(super) const MANIFEST: &str = "manifest.json";
const PROGRAM: &str = "groundwave";

/// Prefix of the folder in which results are gathered, beside the output folder; with the process number, so that an
/// interrupted run can be swept up.
pub fn staging_prefix() -> String {
    format!(".groundwave-{}-", std::process::id())
}

fn unwritable(path: &Path, reason: impl ToString) -> RunError {
    RunError::Unwritable { path: path.to_owned(), reason: reason.to_string() }
}

/// `out` from the root, links and `..` of what exists resolved: it means the same wherever the program stands, even in the folder
/// that it moves.
///
/// # Errors
/// `Unwritable`: no folder named, a link, a working folder that is gone.
pub fn resolve(out: &Path) -> Result<PathBuf, RunError> {
    let whole = std::path::absolute(out).map_err(|e| unwritable(out, e))?;
    if whole.symlink_metadata().is_ok_and(|m| m.is_symlink()) {
        return Err(unwritable(out, "it is a link"));
    }
    let Some(existing) = whole.ancestors().find(|a| a.exists()) else {
        return Err(unwritable(out, "no part of the path exists"));
    };
    let rest = whole.strip_prefix(existing).unwrap_or(Path::new("")).to_owned();
    if rest.components().any(|part| part == std::path::Component::ParentDir) {
        return Err(unwritable(out, "`..` after a folder that does not exist"));
    }
    let existing = existing.canonicalize().map_err(|e| unwritable(out, e))?;
    let resolved = if rest.as_os_str().is_empty() { existing } else { existing.join(rest) };
    if resolved.file_name().is_none() {
        return Err(unwritable(out, "the path names no folder"));
    }
    Ok(resolved)
}

/// What stands in `folder` that this program did not write there, by its manifest; all of it where there is none.
fn foreign(folder: &Path) -> std::io::Result<Vec<String>> {
    let read = || -> Option<BTreeSet<String>> {
        let text = std::fs::read_to_string(folder.join(MANIFEST)).ok()?;
        let manifest: serde_json::Value = serde_json::from_str(&text).ok()?;
        let files = manifest.get("files")?.as_array()?.iter();
        let own = manifest.get("program")?.as_str()? == PROGRAM;
        own.then(|| files.filter_map(|f| f.as_str().map(str::to_owned)).collect())
    };
    let written = read().unwrap_or_default();
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !(entry.file_type()?.is_file() && written.contains(&name)) {
            found.push(name);
        }
    }
    found.sort();
    Ok(found)
}

/// Refuses an output folder that exists, unless it is to be replaced and holds nothing but results of this program; or that cannot
/// be made. Before anything is computed; leaves nothing behind. Returns the folder from the root.
///
/// # Errors
/// `Exists`, `Foreign`, `Unwritable`.
pub fn check_output(out: &Path, overwrite: bool) -> Result<PathBuf, RunError> {
    let path = resolve(out)?;
    if path.is_file() {
        return Err(unwritable(out, "it is a file"));
    }
    if path.exists() {
        if !overwrite {
            return Err(RunError::Exists { path: out.to_owned() });
        }
        let foreign = foreign(&path).map_err(|e| unwritable(out, e))?;
        if !foreign.is_empty() {
            return Err(RunError::Foreign { path: out.to_owned(), foreign });
        }
    }
    // the nearest folder above it must take a new one
    let above = path.ancestors().skip(1).find(|a| a.exists()).unwrap_or(Path::new("/"));
    tempfile::Builder::new().prefix(&staging_prefix()).tempdir_in(above).map_err(|e| unwritable(out, e))?;
    Ok(path)
}

/// Writes the manifest of all files in `folder`; their names, itself among them.
///
/// # Errors
/// A folder that cannot be read or written.
pub(super) fn sign(folder: &Path) -> std::io::Result<Vec<String>> {
    let mut files = vec![MANIFEST.to_owned()];
    for entry in std::fs::read_dir(folder)? {
        files.push(entry?.file_name().to_string_lossy().into_owned());
    }
    files.sort();
    let manifest =
        serde_json::json!({ "program": PROGRAM, "version": env!("CARGO_PKG_VERSION"), "files": files });
    std::fs::write(folder.join(MANIFEST), format!("{manifest:#}\n"))?;
    Ok(files)
}

/// Puts the finished folder `staging` in the place of `out`. An old one goes when the new one stands there, and comes back if it
/// cannot.
///
/// # Errors
/// `Foreign` where something was put there meanwhile; a folder that cannot be moved.
pub(super) fn install(staging: &Path, out: &Path) -> Result<(), RunError> {
    let failed = |e: std::io::Error| unwritable(out, e);
    if out.symlink_metadata().is_err() {
        return std::fs::rename(staging, out).map_err(failed);
    }
    let foreign = foreign(out).map_err(failed)?;
    if !foreign.is_empty() {
        return Err(RunError::Foreign { path: out.to_owned(), foreign });
    }
    // not by the prefix that an interrupted run sweeps up
    let aside = tempfile::Builder::new()
        .prefix(".groundwave-replaced-")
        .tempdir_in(out.parent().unwrap_or(Path::new("/")))
        .map_err(failed)?;
    let old = aside.path().join("old");
    std::fs::rename(out, &old).map_err(failed)?;
    if let Err(error) = std::fs::rename(staging, out) {
        if std::fs::rename(&old, out).is_err() {
            // better left aside than lost
            let kept = aside.keep();
            return Err(unwritable(out, format!("{error}; what stood there is in {}", kept.display())));
        }
        return Err(failed(error));
    }
    Ok(())
}
