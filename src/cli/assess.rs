//! `assess`.

use super::args::AssessArguments;
use super::run::{default_out, print, sweep_on_interrupt};
use super::{BAD_INPUT, DONE, FAILED};
use groundwave::assessment::{Area, Guide, Line};
use groundwave::case::{AssessError, RunError, RunOptions, check_output};
use groundwave::study::{Assessment, Passes};
use std::time::Instant;

/// What the options ask the record to be held against.
fn assessment(arguments: &AssessArguments) -> Assessment {
    let passes = Passes { day: arguments.day.unwrap_or(0), night: arguments.night.unwrap_or(0) };
    Assessment {
        // clap has refused other names
        guides: Guide::ALL
            .into_iter()
            .filter(|g| arguments.guide.iter().any(|name| name == g.name()))
            .collect(),
        area: Area::ALL.into_iter().find(|a| a.name() == arguments.area).unwrap_or_default(),
        line: Line::ALL.into_iter().find(|l| l.name() == arguments.line).unwrap_or_default(),
        passes: (passes != Passes::default()).then_some(passes),
        ..Assessment::default()
    }
}

pub fn assess(arguments: &AssessArguments) -> u8 {
    let out = arguments.out.clone().unwrap_or_else(|| default_out(&arguments.record));
    match check_output(&out, arguments.overwrite) {
        Ok(whole) => sweep_on_interrupt(whole),
        Err(error) => {
            eprintln!("error: {error}");
            return BAD_INPUT;
        }
    }
    let started = Instant::now();
    let options = RunOptions {
        out: out.clone(),
        overwrite: arguments.overwrite,
        pictures: !arguments.no_pictures,
        csv_maps: false,
    };
    match groundwave::case::assess(&arguments.record, assessment(arguments), &options) {
        Ok(summary) => {
            print(&format!("Measured history {}", arguments.record.display()), &summary, &out, started);
            if arguments.strict && !summary.concerns.is_empty() {
                let codes: Vec<&str> = summary.concerns.iter().map(|c| c.code).collect();
                eprintln!("error: concerns under --strict: {}", codes.join(", "));
                return FAILED;
            }
            DONE
        }
        Err(
            error @ (AssessError::File { .. }
            | AssessError::Record { .. }
            | AssessError::Run(RunError::Folder(_))),
        ) => {
            eprintln!("error: {error}");
            BAD_INPUT
        }
        Err(error) => {
            eprintln!("error: {error}");
            FAILED
        }
    }
}
