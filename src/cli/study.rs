//! `study` and `gather`.

use super::args::{GatherArguments, StudyArguments};
use super::progress::Bar;
use super::run::{default_out, load, on_interrupt, print, use_threads};
use super::{BAD_INPUT, DONE, FAILED, complain, say};
use groundwave::ensemble::{self, Done, EnsembleError, Shard, sweep};
use groundwave::progress::Observer;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// results/<name>_study
fn out_of(arguments: &StudyArguments) -> PathBuf {
    arguments.out.clone().unwrap_or_else(|| {
        let mut out = default_out(&arguments.case).into_os_string();
        out.push("_study");
        out.into()
    })
}

fn refused(error: EnsembleError) -> u8 {
    match error {
        EnsembleError::Case(error) => {
            error.each().into_iter().for_each(|fault| complain(&fault.into()));
            BAD_INPUT
        }
        error => {
            eprintln!("error: {error}");
            match error {
                EnsembleError::Write { .. }
                | EnsembleError::Output(_)
                | EnsembleError::Run(_)
                | EnsembleError::Cancelled => FAILED,
                _ => BAD_INPUT,
            }
        }
    }
}

pub fn study(arguments: &StudyArguments) -> u8 {
    let case = match load(&arguments.case).and_then(|case| use_threads(arguments.threads).map(|()| case)) {
        Ok(case) => case,
        Err(code) => return code,
    };
    let (number, of) = arguments.shard.unwrap_or((1, 1));
    let shard = match Shard::new(number, of) {
        Ok(shard) => shard,
        Err(error) => return refused(error),
    };
    let (out, started) = (out_of(arguments), Instant::now());
    let whole = out.clone();
    on_interrupt(move || {
        sweep(&whole, false);
        eprintln!("\ninterrupted: whole chunks are kept, the same command goes on from there");
    });
    let bar = Bar::new();
    let done = ensemble::run(&case, &out, shard, &bar);
    bar.end();
    match done {
        Ok(done) => {
            let Done { rows, found, chunks, of } = done;
            say(&format!(
                "{rows} rows computed, {found} found ({:.1} s); {chunks} of {of} chunks in {}",
                started.elapsed().as_secs_f64(),
                out.display()
            ));
            if chunks == of {
                return leave(&out, !arguments.no_pictures, arguments.strict);
            }
            say(&format!("when the other shards have ended: groundwave gather {}", out.display()));
            DONE
        }
        Err(error) => refused(error),
    }
}

pub fn gather(arguments: &GatherArguments) -> u8 {
    leave(&arguments.dir, !arguments.no_pictures, arguments.strict)
}

fn leave(out: &Path, pictures: bool, strict: bool) -> u8 {
    let (bar, started) = (Bar::new(), Instant::now());
    let gathered = ensemble::gather(out, pictures, &bar);
    bar.end();
    match gathered {
        Ok((case, mut summary)) => {
            // they stand in study.h5
            summary.only_in_hdf5.clear();
            print(&case.title, &summary, (&out.join("gathered"), started), strict)
        }
        Err(error) => refused(error),
    }
}
