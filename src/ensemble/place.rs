//! The folder of a study: `study.json` says which, `chunks/` holds what is done, each file whole or not there.

use super::chunk::Chunk;
use super::error::EnsembleError;
use super::identity::Identity;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::io::Write;
use std::path::{Path, PathBuf};

const STUDY: &str = "study.json";
const CHUNKS: &str = "chunks";
/// Where gathered results stand.
pub(super) const GATHERED: &str = "gathered";

/// A folder that holds one study.
pub(super) struct Place {
    root: PathBuf,
}

fn unwritable(path: &Path) -> impl FnOnce(std::io::Error) -> EnsembleError {
    move |source| EnsembleError::Write { path: path.to_owned(), source }
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, EnsembleError> {
    let failed = |reason: String| EnsembleError::Read { path: path.to_owned(), reason };
    let text = std::fs::read(path).map_err(|e| failed(e.to_string()))?;
    serde_json::from_slice(&text)
        .map_err(|e| failed(format!("{e}; remove it, and run its part of the study again")))
}

/// Beginning of the names of files that this process is writing.
fn prefix() -> String {
    format!(".{}-", std::process::id())
}

/// A file of `value` beside `path`, not yet in its place.
fn aside(path: &Path, value: &impl Serialize) -> Result<tempfile::NamedTempFile, EnsembleError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let beginning = prefix();
    let mut builder = tempfile::Builder::new();
    builder.prefix(&beginning);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // as open to readers as any file
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder).map_err(unwritable(folder))?;
    let text = serde_json::to_vec(value).map_err(|e| unwritable(path)(e.into()))?;
    file.write_all(&text).and_then(|()| file.as_file().sync_all()).map_err(unwritable(path))?;
    Ok(file)
}

impl Place {
    /// The folder `root` for the study `identity`: made, or found with that study in it.
    ///
    /// # Errors
    /// One with another study, or with something else.
    pub fn claim(root: &Path, identity: &Identity) -> Result<Self, EnsembleError> {
        let place = Self { root: root.to_owned() };
        if root.is_file() {
            return Err(EnsembleError::Foreign { path: root.to_owned(), found: "is a file".to_owned() });
        }
        std::fs::create_dir_all(root).map_err(unwritable(root))?;
        let study = root.join(STUDY);
        if !study.exists() {
            let foreign = std::fs::read_dir(root).map_err(unwritable(root))?.flatten().find_map(|entry| {
                let name = entry.file_name().to_string_lossy().into_owned();
                // other shards begin in the same moment
                (name != STUDY && name != CHUNKS && !name.starts_with('.')).then_some(name)
            });
            if let Some(found) = foreign {
                return Err(EnsembleError::Foreign { path: root.to_owned(), found });
            }
            // only the first of them puts its file there
            match aside(&study, identity)?.persist_noclobber(&study) {
                Err(error) if error.error.kind() != std::io::ErrorKind::AlreadyExists => {
                    return Err(unwritable(&study)(error.error));
                }
                _ => {}
            }
        }
        if let Some(difference) = identity.difference(&place.identity()?) {
            return Err(EnsembleError::Mixed { path: root.to_owned(), difference });
        }
        let chunks = root.join(CHUNKS);
        std::fs::create_dir_all(&chunks).map_err(unwritable(&chunks))?;
        Ok(place)
    }

    /// The folder `root`, in which a study stands.
    ///
    /// # Errors
    /// A folder without one.
    pub fn open(root: &Path) -> Result<Self, EnsembleError> {
        if root.join(STUDY).is_file() {
            return Ok(Self { root: root.to_owned() });
        }
        let why = if root.is_dir() { "there is no study.json in it" } else { "there is no such folder" };
        Err(EnsembleError::Nothing { path: root.to_owned(), why })
    }

    /// The study in it.
    ///
    /// # Errors
    /// A `study.json` that cannot be read.
    pub fn identity(&self) -> Result<Identity, EnsembleError> {
        read(&self.root.join(STUDY))
    }

    /// Where its results stand.
    pub fn gathered(&self) -> PathBuf {
        self.root.join(GATHERED)
    }

    fn chunk(&self, number: usize) -> PathBuf {
        self.root.join(CHUNKS).join(format!("{number:05}.json"))
    }

    /// Whether chunk `number` is there.
    pub fn holds(&self, number: usize) -> bool {
        self.chunk(number).is_file()
    }

    /// Chunk `number`, of the study with the `fingerprint`.
    ///
    /// # Errors
    /// A file that cannot be read, or belongs to another study.
    pub fn read(&self, number: usize, fingerprint: &str) -> Result<Chunk, EnsembleError> {
        let path = self.chunk(number);
        let chunk: Chunk = read(&path)?;
        if chunk.fingerprint != fingerprint {
            let difference =
                format!("its fingerprint is {}, that of study.json {fingerprint}", chunk.fingerprint);
            return Err(EnsembleError::Mixed { path, difference });
        }
        Ok(chunk)
    }

    /// Puts chunk `number` in its place, whole.
    ///
    /// # Errors
    /// A file that cannot be written; nothing is left of it.
    pub fn write(&self, number: usize, chunk: &Chunk) -> Result<(), EnsembleError> {
        let path = self.chunk(number);
        aside(&path, chunk)?.persist(&path).map(drop).map_err(|error| unwritable(&path)(error.error))
    }
}

/// Removes what processes that were ended have left half-written in the study folder `out`: of this process, or of `all`.
pub fn sweep(out: &Path, all: bool) {
    let beginning = if all { ".".to_owned() } else { prefix() };
    for entry in std::fs::read_dir(out.join(CHUNKS)).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(&beginning) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}
