//! What a case file may say, its checks, the library of named parameter sets, and the runner.

mod checks;
pub mod error;
mod faults;
mod files;
mod folder;
mod ground;
mod irregularity;
pub mod library;
mod load;
mod loader;
mod passage;
mod plausible;
mod rail_studies;
mod ranges;
mod read;
mod report;
mod roughness;
mod runner;
pub mod schema;
mod studies;
mod track;
mod train;
pub mod values;
mod verification;

pub use error::CaseError;
pub use folder::{FolderError, check_output, sweep};
pub use load::Case;
pub use runner::{RunError, RunOptions, Summary, run};
pub use verification::{Verification, Verified};

/// A commented case file to start from: what `groundwave new` writes.
pub const TEMPLATE: &str = include_str!("template.toml");
