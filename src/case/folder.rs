//! The output folder: appears whole, and replaces only what this program wrote.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use thiserror::Error;

/// Why results cannot stand in a folder.
#[derive(Debug, Error)]
pub enum FolderError {
    /// The output folder exists.
    #[error("the output folder {path} exists: give another --out, or --overwrite to replace it", path = path.display())]
    Exists {
        /// Which.
        path: PathBuf,
    },
    /// The output folder holds what this program did not write.
    #[error(
        "the output folder {path} holds what groundwave did not write there ({what}), and is not replaced: give another --out, or move \
         it away",
        path = path.display(),
        what = named(foreign)
    )]
    Foreign {
        /// Which.
        path: PathBuf,
        /// Names in it.
        foreign: Vec<String>,
    },
    /// The output folder cannot be made.
    #[error("cannot write to {path}: {reason}; give another --out", path = path.display())]
    Unwritable {
        /// Which.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The new results could not be put in their place.
    #[error("{source}; the new results are in {kept}", kept = kept.display())]
    Kept {
        /// Why.
        source: Box<FolderError>,
        /// Where they are.
        kept: PathBuf,
    },
}

/// The first few names of a list.
fn named(names: &[String]) -> String {
    let more = names.len().saturating_sub(5);
    let first = names.iter().take(5).cloned().collect::<Vec<_>>().join(", ");
    if more == 0 { first } else { format!("{first} and {more} more") }
}

/// What a results folder holds: how the program knows its own again.
pub(super) const MANIFEST: &str = "manifest.json";
const PROGRAM: &str = "groundwave";

/// Prefix of the folder in which results are gathered, beside the output folder; with the process number, so that an
/// interrupted run can be swept up.
fn staging_prefix() -> String {
    format!(".groundwave-{}-", std::process::id())
}

/// The same for the folder that an old one is moved into until the new one stands.
fn replaced_prefix() -> String {
    format!(".groundwave-replaced-{}-", std::process::id())
}

/// Removes what this run, interrupted, leaves beside `out`; an old folder that was moved away stands again.
pub fn sweep(out: &Path) {
    let above = out.parent().unwrap_or(out);
    for entry in std::fs::read_dir(above).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let staged = name.starts_with(&staging_prefix());
        let replaced = name.starts_with(&replaced_prefix());
        // either folder stands there: what is left aside is no longer needed
        let restored = || out.exists() || std::fs::rename(entry.path().join("old"), out).is_ok();
        if staged || replaced && restored() {
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
}

fn unwritable(path: &Path, reason: impl ToString) -> FolderError {
    FolderError::Unwritable { path: path.to_owned(), reason: reason.to_string() }
}

/// `out` from the root, links and `..` of what exists resolved: it means the same wherever the program stands, even in the folder
/// that it moves.
///
/// # Errors
/// `Unwritable`: no folder named, a link, a working folder that is gone.
pub fn resolve(out: &Path) -> Result<PathBuf, FolderError> {
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
pub fn check_output(out: &Path, overwrite: bool) -> Result<PathBuf, FolderError> {
    let path = resolve(out)?;
    if path.is_file() {
        return Err(unwritable(out, "it is a file"));
    }
    if path.exists() {
        if !overwrite {
            return Err(FolderError::Exists { path: out.to_owned() });
        }
        let foreign = foreign(&path).map_err(|e| unwritable(out, e))?;
        if !foreign.is_empty() {
            return Err(FolderError::Foreign { path: out.to_owned(), foreign });
        }
    }
    // the nearest folder above it must take a new one
    let above = path.ancestors().skip(1).find(|a| a.exists()).unwrap_or(Path::new("/"));
    tempfile::Builder::new().prefix(&staging_prefix()).tempdir_in(above).map_err(|e| unwritable(out, e))?;
    Ok(path)
}

/// An empty folder beside `out`, in which its files are gathered; folders above are made.
///
/// # Errors
/// A folder that cannot be made.
pub(super) fn stage(out: &Path) -> Result<TempDir, FolderError> {
    let above = out.parent().unwrap_or(out);
    std::fs::create_dir_all(above)
        .and_then(|()| tempfile::Builder::new().prefix(&staging_prefix()).tempdir_in(above))
        .map_err(|e| unwritable(out, e))
}

/// Writes the manifest of all files in `folder`; their names, itself among them.
///
/// # Errors
/// A folder that cannot be read or written.
pub(super) fn sign(folder: &Path) -> Result<Vec<String>, FolderError> {
    let failed = |e: std::io::Error| unwritable(folder, e);
    let mut files = vec![MANIFEST.to_owned()];
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        files.push(entry.map_err(failed)?.file_name().to_string_lossy().into_owned());
    }
    files.sort();
    let manifest =
        serde_json::json!({ "program": PROGRAM, "version": env!("CARGO_PKG_VERSION"), "files": files });
    std::fs::write(folder.join(MANIFEST), format!("{manifest:#}\n")).map_err(failed)?;
    Ok(files)
}

/// Puts the finished folder `staging` in the place of `out`, as open to readers as any folder.
///
/// # Errors
/// `Kept`: something foreign was put there meanwhile, or a folder cannot be moved; old and new are both kept.
pub(super) fn install(staging: TempDir, out: &Path) -> Result<(), FolderError> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let _ = std::fs::set_permissions(staging.path(), std::fs::Permissions::from_mode(0o755));
    }
    replace(out, staging.path())
        .map_err(|source| FolderError::Kept { source: Box::new(source), kept: staging.keep() })
}

/// Moves `staging` to `out`. An old folder goes when the new one stands there, and comes back if it cannot.
fn replace(out: &Path, staging: &Path) -> Result<(), FolderError> {
    let failed = |e: std::io::Error| unwritable(out, e);
    if out.symlink_metadata().is_err() {
        return std::fs::rename(staging, out).map_err(failed);
    }
    let foreign = foreign(out).map_err(failed)?;
    if !foreign.is_empty() {
        return Err(FolderError::Foreign { path: out.to_owned(), foreign });
    }
    // not by the prefix that an interrupted run sweeps up
    let aside = tempfile::Builder::new()
        .prefix(&replaced_prefix())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interrupted_replacement_leaves_the_old_folder_and_nothing_else() {
        let above = tempfile::tempdir().unwrap();
        let place = |name: String| above.path().join(name);
        let out = place("out".into());
        // interrupted after the old folder was moved away, before the new one came
        let old = place(format!("{}x/old", replaced_prefix()));
        std::fs::create_dir_all(&old).unwrap();
        std::fs::write(old.join("results.h5"), "old").unwrap();
        std::fs::create_dir(place(format!("{}x", staging_prefix()))).unwrap();
        // what another run gathers is not ours
        std::fs::create_dir(place(".groundwave-0-x".into())).unwrap();
        sweep(&out);
        assert_eq!(std::fs::read_to_string(out.join("results.h5")).unwrap(), "old");
        let mut left: Vec<_> =
            std::fs::read_dir(above.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        left.sort();
        assert_eq!(left, [".groundwave-0-x", "out"]);
    }

    #[test]
    fn an_old_folder_comes_back_where_the_new_one_cannot_be_moved() {
        let above = tempfile::tempdir().unwrap();
        let out = above.path().join("out");
        std::fs::create_dir(&out).unwrap();
        sign(&out).unwrap();
        replace(&out, &above.path().join("missing")).unwrap_err();
        assert!(out.join(MANIFEST).exists());
        assert_eq!(std::fs::read_dir(above.path()).unwrap().count(), 1);
        // put there while the run computed: what is new is kept aside
        std::fs::write(out.join("notes.txt"), "mine").unwrap();
        let error = install(stage(&out).unwrap(), &out).unwrap_err();
        assert!(error.to_string().contains("notes.txt"), "{error}");
        let FolderError::Kept { kept, .. } = error else { panic!("{error}") };
        assert!(kept.is_dir() && out.join("notes.txt").exists());
    }
}
