//! What can go wrong while writing results.

use std::path::PathBuf;

/// A result that could not be written, with what to do about it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The operating system refused a file.
    #[error(
        "cannot write {}: {source}; check that its folder exists and is writable and that the disk is not full",
        path.display()
    )]
    Write {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: std::io::Error,
    },
    /// The HDF5 library refused an object.
    #[cfg(feature = "files")]
    #[error(
        "cannot write {object} into {}: {source}; names must be unique within their group and free of '/'",
        path.display()
    )]
    Hdf5 {
        /// The file.
        path: PathBuf,
        /// Group, dataset or attribute.
        object: String,
        /// The reason given.
        source: Box<hdf5::Hdf5Error>,
    },
    /// A variable lies along a dimension that its group lacks, or has with another length.
    #[error(
        "cannot write {group}/{variable} into {}: its dimension `{dimension}` has {found} values, the coordinate {}; \
         add a coordinate of that name and length to the group",
        path.display(),
        expected.map_or("is missing".to_owned(), |n| format!("has {n}"))
    )]
    Dimension {
        /// The file.
        path: PathBuf,
        /// Group name.
        group: String,
        /// Variable name.
        variable: String,
        /// The dimension at fault.
        dimension: String,
        /// Length of the variable along it.
        found: usize,
        /// Length of the coordinate, if there is one.
        expected: Option<usize>,
    },
    /// A number of a JSON document is not finite (JSON has no word for it).
    #[error(
        "cannot write {}: `{key}` is null, which is how a number that is not finite arrives in JSON; leave the key out \
         or say in words why there is no number",
        path.display()
    )]
    NotFinite {
        /// The file.
        path: PathBuf,
        /// Path of the key, e.g. `critical_speed.max_down[3]`.
        key: String,
    },
    /// A figure holds nothing that can be drawn.
    #[error("there is no picture `{figure}`: {reason}; it needs {needed}")]
    Figure {
        /// File stem of the figure.
        figure: String,
        /// What is wrong with it.
        reason: String,
        /// What it needs.
        needed: String,
    },
}
