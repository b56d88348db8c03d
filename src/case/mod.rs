//! What a case file may say, its checks, the library of named parameter sets, and the runner.

mod about;
mod answers;
mod assessment;
mod changed;
mod checks;
mod compare;
mod consist;
pub mod error;
mod faults;
mod files;
mod folder;
mod ground;
mod ground_at_depth;
mod irregularity;
mod keys;
pub mod library;
mod load;
mod loader;
mod passage;
mod plausible;
mod rail_studies;
mod ranges;
mod read;
mod record;
mod report;
mod roughness;
mod roughness_table;
mod runner;
pub mod schema;
mod show;
mod sketch;
mod studies;
mod track;
mod track_table;
mod train;
mod units;
pub mod values;
mod vehicle;
mod verification;

pub use about::About;
pub use compare::{CompareError, compare};
pub use error::CaseError;
pub use folder::{FolderError, check_output, sweep};
pub use keys::json_schema;
pub use load::Case;
pub use record::{AssessError, assess};
pub use runner::{RunError, RunOptions, Summary, run};
pub use show::show;
pub use verification::{Verification, Verified};

/// A commented case file to start from: what `groundwave new` writes.
pub const TEMPLATE: &str = include_str!("template.toml");
