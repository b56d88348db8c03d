//! `run` and `check`.

use super::args::RunArguments;
use super::progress::Bar;
use super::{BAD_INPUT, DONE, FAILED, complain, say};
use groundwave::case::{
    Case, Known, RunError, RunOptions, StudyTime, Summary, about, check_output, run as run_case, sweep,
};
use groundwave::progress::Observer;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The case at `path`, or its faults on the screen.
pub fn load(path: &Path) -> Result<Case, u8> {
    Case::load(path).map_err(|error| {
        let faults = error.each();
        let count = faults.len();
        faults.into_iter().for_each(|fault| complain(&fault.into()));
        if count > 1 {
            eprintln!("{count} faults");
        }
        BAD_INPUT
    })
}

/// How long each study may be tried to tell how long it takes.
const TRIAL: Duration = Duration::from_secs(1);

pub fn check(path: &Path) -> u8 {
    match load(path) {
        Ok(case) => {
            let studies: Vec<&str> = case.studies.iter().map(|s| s.name()).collect();
            say(&format!("{}: {}; studies: {}", path.display(), case.title, studies.join(", ")));
            if let Some(study) = &case.study {
                let (samples, varied, steps) =
                    (study.design.samples(), study.varied.len(), 2 * study.parameters.len());
                say(&format!("[study]: {samples} samples of {varied} numbers, {steps} runs for derivatives"));
            }
            for concern in &case.concerns {
                say(&format!("Concern: {concern}"));
            }
            match case.estimate(TRIAL) {
                Ok(times) => {
                    time_told(&case, &times).iter().for_each(|line| say(line));
                    DONE
                }
                Err(error) => {
                    eprintln!("error: {error}");
                    FAILED
                }
            }
        }
        Err(code) => code,
    }
}

/// What a case takes on the threads there are, and the samples of its `[study]`.
fn time_told(case: &Case, times: &[StudyTime]) -> Vec<String> {
    let whole: Duration = times.iter().map(|time| time.time).sum();
    let threads = match rayon::current_num_threads() {
        1 => "1 thread".to_owned(),
        count => format!("{count} threads"),
    };
    // those that matter
    let parts =
        times.iter().filter(|time| times.len() > 1 && time.time > Duration::from_secs(1).max(whole / 20));
    let again = |time: &StudyTime| if time.verifying { " again to verify it" } else { "" };
    let more = |time: &StudyTime| if time.known == Known::More { "more than " } else { "" };
    let one = |t: &StudyTime| format!("{}{} {}{}", t.study, again(t), more(t), about(t.time));
    let parts: Vec<String> = parts.map(one).collect();
    let at_least = if times.iter().any(|t| t.known == Known::More) { "more than " } else { "" };
    let of = if parts.is_empty() { String::new() } else { format!(": {}", parts.join(", ")) };
    let mut lines =
        vec![format!("Time: {at_least}{} on {threads}{of}; besides pictures and files", about(whole))];
    if let Some(study) = &case.study {
        let runs = study.design.samples() + 2 * study.parameters.len();
        lines.push(format!(
            "      {at_least}{} for all samples by `groundwave study`",
            about(whole * runs as u32)
        ));
    }
    lines
}

/// results/<name>: the file's stem, or its folder's name where the file is called case.toml or results.h5.
pub fn default_out(case: &Path) -> PathBuf {
    let stem = case.file_stem().and_then(|s| s.to_str()).unwrap_or("case");
    let folder = std::path::absolute(case).ok();
    let folder = folder.as_deref().and_then(Path::parent).and_then(Path::file_name).and_then(|s| s.to_str());
    let name = match (stem, folder) {
        ("case" | "results", Some(folder)) => folder,
        _ => stem,
    };
    // a re-run from results/x/results.h5 must not fall upon the folder it reads from
    let name = if stem == "results" { format!("{name}_again") } else { name.to_owned() };
    Path::new("results").join(name)
}

/// Looks whether results may go to `out`, and from then on removes what an interrupted run leaves beside it.
pub fn ready(out: &Path, overwrite: bool) -> Result<(), u8> {
    let whole = check_output(out, overwrite).map_err(|error| {
        eprintln!("error: {error}");
        BAD_INPUT
    })?;
    on_interrupt(move || {
        sweep(&whole);
        eprintln!("\ninterrupted: nothing written");
    });
    Ok(())
}

/// Cleans up by `last` and ends where the user interrupts.
pub fn on_interrupt(last: impl Fn() + Send + 'static) {
    let _ = ctrlc::set_handler(move || {
        last();
        std::process::exit(130);
    });
}

/// Uses as many threads as asked for.
pub fn use_threads(threads: Option<u16>) -> Result<(), u8> {
    let Some(threads) = threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads)).build_global().map_err(|error| {
        eprintln!("error: cannot start {threads} threads: {error}");
        FAILED
    })
}

pub fn run(arguments: &RunArguments) -> u8 {
    let case = match load(&arguments.case).and_then(|case| use_threads(arguments.threads).map(|()| case)) {
        Ok(case) => case,
        Err(code) => return code,
    };
    let out = arguments.out.clone().unwrap_or_else(|| default_out(&arguments.case));
    if let Err(code) = ready(&out, arguments.overwrite) {
        return code;
    }
    let started = Instant::now();
    let bar = Bar::new();
    let options = RunOptions {
        out: out.clone(),
        overwrite: arguments.overwrite,
        pictures: !arguments.no_pictures,
        csv_maps: arguments.csv_maps,
        vti: arguments.vti,
    };
    let result = run_case(&case, &options, &bar);
    bar.end();
    match result {
        Ok(summary) => {
            let code = print(&case.title, &summary, (&out, started), arguments.strict);
            if case.study.is_some() {
                say(&format!(
                    "This is the case as it stands; its [study] is run by: groundwave study {}",
                    arguments.case.display()
                ));
            }
            code
        }
        Err(error @ RunError::Folder(_)) => {
            eprintln!("error: {error}");
            BAD_INPUT
        }
        Err(error) => {
            eprintln!("error: {error}");
            FAILED
        }
    }
}

/// The answers of a run called `title`, its concerns, where its files are and since when it ran; concerns are failures if `strict`.
pub fn print(title: &str, summary: &Summary, (out, started): (&Path, Instant), strict: bool) -> u8 {
    say(title);
    for (study, answers) in &summary.answers {
        let see = if answers.is_empty() { ": see the tables" } else { "" };
        say(&format!("\n{study}{see}"));
        for answer in answers {
            say(&format!("  {:62} {}", answer.what, answer.shown));
        }
        if let Some(verification) = &summary.verification {
            for verified in verification.studies.iter().filter(|verified| verified.study == *study) {
                say(&format!("  verified with {}: {}", verified.solver, verified.comparison));
            }
        }
    }
    say("");
    if summary.concerns.is_empty() {
        say("No concerns.");
    }
    for concern in &summary.concerns {
        say(&format!("Concern: {concern}"));
    }
    if !summary.only_in_hdf5.is_empty() {
        say(&format!(
            "Maps in results.h5 alone: {}; as tables too with --csv-maps, for ParaView with --vti",
            summary.only_in_hdf5.join(", ")
        ));
    }
    say(&format!(
        "{} files in {} ({:.1} s), start with {}",
        summary.files.len(),
        out.display(),
        started.elapsed().as_secs_f64(),
        out.join("report.html").display()
    ));
    if strict && !summary.concerns.is_empty() {
        let codes: Vec<&str> = summary.concerns.iter().map(|c| c.code).collect();
        eprintln!("error: concerns under --strict: {}", codes.join(", "));
        return FAILED;
    }
    DONE
}
