//! What a run leaves behind: HDF5, CSV, JSON and VTK files, pictures, and a report.
//!
//! Exporters take a [`Dataset`](crate::dataset::Dataset), a [`Figure`](crate::figure::Figure) or plain values and know
//! nothing of soils or tracks. They write in place: the runner gathers all files in a folder that appears whole.

#[cfg(feature = "pictures")]
mod axis;
#[cfg(feature = "pictures")]
mod bars;
#[cfg(feature = "pictures")]
mod bitmap;
#[cfg(feature = "pictures")]
mod canvas;
#[cfg(feature = "pictures")]
mod colours;
pub mod csv;
#[cfg(feature = "pictures")]
mod curves;
mod error;
#[cfg(feature = "pictures")]
mod frame;
#[cfg(feature = "files")]
pub mod hdf5;
#[cfg(feature = "pictures")]
mod image;
pub mod json;
#[cfg(feature = "pictures")]
mod lettering;
#[cfg(feature = "pictures")]
mod levels;
#[cfg(feature = "pictures")]
mod lines;
#[cfg(feature = "pictures")]
mod map;
#[cfg(feature = "pictures")]
mod markers;
#[cfg(feature = "pictures")]
mod markup;
#[cfg(feature = "pictures")]
mod overlay;
#[cfg(feature = "pictures")]
mod page;
#[cfg(feature = "pictures")]
pub mod plot;
#[cfg(feature = "pictures")]
mod readout;
#[cfg(feature = "pictures")]
pub mod report;
#[cfg(feature = "pictures")]
mod sketch;
mod table;
#[cfg(feature = "pictures")]
pub mod vti;

pub use error::OutputError;
#[cfg(feature = "pictures")]
pub use report::Report;
pub use table::ReportTable;

use std::path::Path;

/// Writes `bytes` to `path`.
///
/// # Errors
/// [`OutputError::Write`] naming the file.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    std::fs::write(path, bytes).map_err(|source| OutputError::Write { path: path.to_owned(), source })
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_missing_folder_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let error = super::save(&dir.path().join("no/a.txt"), b"x").unwrap_err();
        assert!(error.to_string().contains("a.txt"), "{error}");
    }
}
