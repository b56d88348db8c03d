//! What may be typed.

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Moving trains on layered ground: critical speed, track deflection, ground contours, vibration of the free field.
#[derive(Debug, Parser)]
#[command(name = "groundwave", version, about, arg_required_else_help = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a case: answers on screen; HDF5, CSV, JSON, pictures and a report in a folder
    Run(RunArguments),
    /// Check a case without running it
    Check {
        /// Case file (TOML)
        case: PathBuf,
    },
    /// List the library of soils, tracks and vehicles
    List {
        /// Only these
        what: Option<Kind>,
    },
    /// Write a commented case file to start from
    New {
        /// Where; printed if left out
        file: Option<PathBuf>,
    },
    /// Print the JSON schema of case files, for editors
    Schema,
}

#[derive(Args, Debug)]
pub struct RunArguments {
    /// Case file (TOML), or the results.h5 of an earlier run
    pub case: PathBuf,
    /// Output folder [default: results/<name of the case>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Threads to use [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Concerns about the result are failures: the results are written, the exit code is 1
    #[arg(long)]
    pub strict: bool,
    /// Draw no pictures: numbers and the report alone, many times as quick where answers are
    #[arg(long)]
    pub no_pictures: bool,
    /// Write maps (ground contours, receptances around a load) as CSV tables too; they stand in results.h5 all the same
    #[arg(long)]
    pub csv_maps: bool,
    /// Replace an existing output folder
    #[arg(long)]
    pub overwrite: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    Soils,
    Tracks,
    Vehicles,
}
