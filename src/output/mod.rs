//! What a run leaves behind: HDF5, CSV and JSON files, pictures, and a report.
//!
//! Exporters take a [`Dataset`](crate::dataset::Dataset), a [`Figure`](crate::figure::Figure) or plain values and know
//! nothing of soils or tracks. Files appear whole: written aside, then renamed.

mod axis;
mod canvas;
mod colours;
pub mod csv;
mod curves;
mod error;
pub mod hdf5;
pub mod json;
mod lines;
mod map;
mod overlay;
pub mod plot;
mod raster;
pub mod report;
mod whole;

pub use error::OutputError;
pub use report::{Report, ReportTable};
