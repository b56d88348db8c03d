//! `assess`.

use super::args::AssessArguments;
use super::run::{default_out, print, ready};
use super::{BAD_INPUT, FAILED};
use groundwave::assessment::{Area, Guide, Line};
use groundwave::case::{AssessError, RunError, RunOptions};
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
    if let Err(code) = ready(&out, arguments.overwrite) {
        return code;
    }
    let started = Instant::now();
    let options = RunOptions {
        out: out.clone(),
        overwrite: arguments.overwrite,
        pictures: !arguments.no_pictures,
        csv_maps: false,
        vti: false,
    };
    match groundwave::case::assess(&arguments.record, assessment(arguments), &options) {
        Ok(summary) => {
            let title = format!("Measured history {}", arguments.record.display());
            print(&title, &summary, (&out, started), arguments.strict)
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
