//! What may be typed.

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use groundwave::assessment::{Area, Guide, Line};
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
    /// Assess a measured history: all measures of a free field, of velocities or accelerations in a CSV file
    Assess(AssessArguments),
    /// Compare two cases, or the folders of two runs: insertion loss, every answer, every curve
    Compare(CompareArguments),
    /// Run the samples of an uncertain case ([study]), or what is left of them; gathered when all are there
    Study(StudyArguments),
    /// Gather the samples of a study that ran in shards: quantiles, probabilities, sensitivities, report
    Gather(GatherArguments),
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
    /// Show an entry of the library: source, keys with their units, axle loads, wave speeds, stiffness
    Show {
        /// Its name, as `list` prints it
        name: String,
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
    /// Write fields over the ground (contours, fields at depth, receptances around a load) as .vti files too, for ParaView
    #[arg(long)]
    pub vti: bool,
    /// Replace an existing output folder
    #[arg(long)]
    pub overwrite: bool,
}

#[derive(Args, Debug)]
pub struct StudyArguments {
    /// Case file (TOML) with [study]
    pub case: PathBuf,
    /// Folder of the study; one that holds it already is gone on with [default: results/<name of the case>_study]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Only part i of n, for as many machines
    #[arg(long, value_name = "i/n", value_parser = shard)]
    pub shard: Option<(usize, usize)>,
    /// Threads to use [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Draw no pictures
    #[arg(long)]
    pub no_pictures: bool,
    /// Concerns about the result are failures: the results are written, the exit code is 1
    #[arg(long)]
    pub strict: bool,
}

#[derive(Args, Debug)]
pub struct GatherArguments {
    /// Folder of the study
    pub dir: PathBuf,
    /// Draw no pictures
    #[arg(long)]
    pub no_pictures: bool,
    /// Concerns about the result are failures: the results are written, the exit code is 1
    #[arg(long)]
    pub strict: bool,
}

/// "2/5"
fn shard(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    numbers.ok_or_else(|| "wanted i/n, such as 2/5".to_owned())
}

#[derive(Args, Debug)]
pub struct CompareArguments {
    /// Case file, or folder of an earlier run: what things were before
    pub first: PathBuf,
    /// Case file, or folder of an earlier run: what they are held against
    pub second: PathBuf,
    /// Output folder [default: results/<name of the second>_against_<name of the first>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Draw no pictures
    #[arg(long)]
    pub no_pictures: bool,
    /// Replace an existing output folder
    #[arg(long)]
    pub overwrite: bool,
}

#[derive(Args, Debug)]
pub struct AssessArguments {
    /// CSV file: a header, then time [s] and velocity [mm/s] or acceleration [m/s²] in one to three directions
    pub record: PathBuf,
    /// Output folder [default: results/<name of the record>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Standards, with commas between them [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = PossibleValuesParser::new(Guide::ALL.map(Guide::name)))]
    pub guide: Vec<String>,
    /// Like passes by day
    #[arg(long, value_name = "N")]
    pub day: Option<u32>,
    /// Like passes by night
    #[arg(long, value_name = "N")]
    pub night: Option<u32>,
    /// Kind of area, after DIN 4150-2
    #[arg(long, default_value = "residential", value_parser = PossibleValuesParser::new(Area::ALL.map(Area::name)))]
    pub area: String,
    /// Kind of line, after DIN 4150-2
    #[arg(long, default_value = "surface", value_parser = PossibleValuesParser::new(Line::ALL.map(Line::name)))]
    pub line: String,
    /// Draw no pictures
    #[arg(long)]
    pub no_pictures: bool,
    /// Concerns about the result are failures: the results are written, the exit code is 1
    #[arg(long)]
    pub strict: bool,
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
