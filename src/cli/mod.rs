//! The command: the only place that prints. Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.

mod args;
mod assess;
mod compare;
mod list;
mod progress;
mod run;
mod study;

use clap::Parser;
use std::process::ExitCode;

/// Done.
const DONE: u8 = 0;
/// The computation or the writing failed.
const FAILED: u8 = 1;
/// The input is wrong.
const BAD_INPUT: u8 = 2;

/// Runs the command line `argv` and returns its exit code.
pub fn main(argv: impl Iterator<Item = std::ffi::OsString>) -> ExitCode {
    let arguments = match args::Arguments::try_parse_from(argv) {
        Ok(arguments) => arguments,
        Err(error) => {
            // clap prints help and version to stdout with code 0, faults to stderr with code 2
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { BAD_INPUT } else { DONE });
        }
    };
    let code = match arguments.command {
        args::Command::Run(options) => run::run(&options),
        args::Command::Assess(options) => assess::assess(&options),
        args::Command::Compare(options) => compare::compare(&options),
        args::Command::Study(options) => study::study(&options),
        args::Command::Gather(options) => study::gather(&options),
        args::Command::Check { case } => run::check(&case),
        args::Command::List { what } => list::list(what),
        args::Command::Show { name } => list::show(&name),
        args::Command::New { file } => list::new(file.as_deref()),
        args::Command::Schema => list::schema(),
    };
    ExitCode::from(code)
}

/// Prints to stdout; a closed pipe (`groundwave list | head`) is not an error.
fn say(text: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// Prints an error with its source lines.
fn complain(report: &miette::Report) {
    eprintln!("{report:?}");
}
