//! What a case file may say, its checks, the library of named parameter sets, and the runner.

mod about;
#[cfg(all(feature = "files", feature = "pictures"))]
mod answers;
mod assessment;
mod changed;
mod checks;
#[cfg(all(feature = "files", feature = "pictures"))]
mod compare;
mod consist;
mod distribution;
pub mod error;
mod estimate;
mod faults;
mod files;
#[cfg(all(feature = "files", feature = "pictures"))]
mod folder;
mod ground;
mod ground_at_depth;
mod irregularity;
mod key_path;
mod keys;
pub mod library;
mod load;
mod loader;
mod passage;
mod plausible;
mod profile_csv;
mod rail_studies;
mod ranges;
mod read;
#[cfg(all(feature = "files", feature = "pictures"))]
mod record;
#[cfg(all(feature = "files", feature = "pictures"))]
mod report;
mod roughness;
mod roughness_table;
#[cfg(all(feature = "files", feature = "pictures"))]
mod runner;
pub mod schema;
mod show;
#[cfg(all(feature = "files", feature = "pictures"))]
mod sketch;
mod solved;
mod studies;
mod study_table;
mod tables;
mod track;
#[cfg(all(feature = "files", feature = "pictures"))]
mod track_table;
mod train;
mod uncertain;
mod units;
pub mod values;
mod vehicle;
mod verification;

pub use about::About;
#[cfg(all(feature = "files", feature = "pictures"))]
pub use compare::{CompareError, compare};
pub use error::CaseError;
pub use estimate::{Known, StudyTime, about};
pub use files::text as read_beside;
#[cfg(all(feature = "files", feature = "pictures"))]
pub use folder::{FolderError, check_output, sweep};
pub use keys::json_schema;
pub use load::Case;
#[cfg(all(feature = "files", feature = "pictures"))]
pub use record::{AssessError, assess};
#[cfg(all(feature = "files", feature = "pictures"))]
pub(crate) use runner::{Beside, Page, leave};
#[cfg(all(feature = "files", feature = "pictures"))]
pub use runner::{RunError, RunOptions, Summary, keep, run};
pub use show::show;
pub use solved::{Solved, StudyFailed};
pub use tables::Tables;
pub use uncertain::{Parameter, Uncertain, Varied};
pub use verification::{Verification, Verified};

/// A commented case file to start from: what `groundwave new` writes.
pub const TEMPLATE: &str = include_str!("template.toml");
