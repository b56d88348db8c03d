//! `compare`.

use super::args::CompareArguments;
use super::progress::Bar;
use super::run::{default_out, print, ready};
use super::{BAD_INPUT, FAILED, complain};
use groundwave::case::{CompareError, RunError, RunOptions};
use groundwave::progress::Observer;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// results/<second>_against_<first>
fn out_of(arguments: &CompareArguments) -> PathBuf {
    let name = |path: &Path| default_out(path).file_name().map(|name| name.to_string_lossy().into_owned());
    let [first, second] = [&arguments.first, &arguments.second].map(|path| name(path).unwrap_or_default());
    Path::new("results").join(format!("{second}_against_{first}"))
}

pub fn compare(arguments: &CompareArguments) -> u8 {
    let out = arguments.out.clone().unwrap_or_else(|| out_of(arguments));
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
    let bar = Bar::new();
    let result = groundwave::case::compare(&arguments.first, &arguments.second, &options, &bar);
    bar.end();
    match result {
        Ok(summary) => {
            let title = format!("{} against {}", arguments.second.display(), arguments.first.display());
            print(&title, &summary, (&out, started), false)
        }
        Err(CompareError::Case(error)) => {
            error.each().into_iter().for_each(|fault| complain(&fault.into()));
            BAD_INPUT
        }
        Err(error @ (CompareError::Folder { .. } | CompareError::Run(RunError::Folder(_)))) => {
            eprintln!("error: {error}");
            BAD_INPUT
        }
        Err(error) => {
            eprintln!("error: {error}");
            FAILED
        }
    }
}
