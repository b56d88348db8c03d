//! `groundwave study` and `groundwave gather` from outside.

use crate::common::cli::{flat, groundwave};
use crate::{files, uncertain};
use groundwave::sampling::uniform;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const SPEEDS: &str = "{ from = 80.0, to = 220.0, step = 10.0 }";

/// A folder with the case `text`.
fn folder_with(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    folder
}

fn begin(folder: &Path) -> Child {
    Command::new(env!("CARGO_BIN_EXE_groundwave"))
        .args(["study", "case.toml", "--out", "out", "--threads", "2", "--no-pictures"])
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

#[test]
fn killed_ten_times_nothing_is_lost_and_nothing_doubled() {
    let text = uncertain("{ from = 100.0, to = 220.0, step = 20.0 }", 120, "derivatives = false");
    let [whole, killed] = [(); 2].map(|()| folder_with(&text));
    let started = Instant::now();
    assert!(begin(whole.path()).wait().unwrap().success());
    let took = started.elapsed();
    let mut running = 0;
    for kill in 0..10 {
        let mut child = begin(killed.path());
        std::thread::sleep(took.mul_f64(0.3 * uniform(1, "moments of kills", kill)));
        running += u32::from(child.try_wait().unwrap().is_none());
        child.kill().unwrap();
        child.wait().unwrap();
    }
    assert!(running >= 3, "{running} of 10 kills came in time");
    assert!(begin(killed.path()).wait().unwrap().success());
    let chunks = [&whole, &killed].map(|folder| files(&folder.path().join("out/chunks")));
    assert_eq!(chunks[0], chunks[1]);
    // no half-written file is left, and what was gathered is the same
    assert!(chunks[1].iter().all(|(name, _)| !name.starts_with('.')));
    for name in ["study.h5", "study.csv", "summary.json"] {
        let [a, b] = [&whole, &killed]
            .map(|folder| std::fs::read(folder.path().join("out/gathered").join(name)).unwrap());
        assert!(a == b, "{name}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_study_ends_within_a_second_and_goes_on() {
    let folder = folder_with(&uncertain(SPEEDS, 5000, ""));
    let mut child = begin(folder.path());
    std::thread::sleep(Duration::from_millis(1500));
    assert!(child.try_wait().unwrap().is_none(), "the study was to be longer");
    let asked = Instant::now();
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(asked.elapsed() < Duration::from_secs(1), "{:?}", asked.elapsed());
    assert_eq!(output.status.code(), Some(130));
    assert!(flat(&output.stderr).contains("whole chunks are kept"));
    let left = files(&folder.path().join("out/chunks"));
    assert!(left.iter().all(|(name, text)| !name.starts_with('.') && text.ends_with(b"]}")), "half-written");
}

#[test]
fn the_worst_samples_run_alone_and_say_the_same() {
    let folder = folder_with(&uncertain(SPEEDS, 60, "derivatives = false"));
    let output = groundwave(&["study", "case.toml", "--out", "out", "--no-pictures"], folder.path());
    let said = flat(&output.stdout);
    assert!(output.status.success(), "{}", flat(&output.stderr));
    for words in [
        "61 rows computed, 0 found",
        "5 % of the grounds stay below",
        "Probability that the critical speed lies below the line speed, 250 km/h",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    // again: nothing to compute
    let again = groundwave(&["study", "case.toml", "--out", "out", "--no-pictures"], folder.path());
    assert!(flat(&again.stdout).contains("0 rows computed, 61 found"));
    let gathered = folder.path().join("out/gathered");
    let worst = files(&gathered).into_iter().find(|(name, _)| name.starts_with("worst_sample_")).unwrap().0;
    let number: usize = worst.trim_start_matches("worst_sample_").trim_end_matches(".toml").parse().unwrap();
    let run = groundwave(
        &["run", gathered.join(&worst).to_str().unwrap(), "--out", "single", "--no-pictures"],
        folder.path(),
    );
    assert!(run.status.success(), "{}", flat(&run.stderr));
    let summary = std::fs::read(folder.path().join("single/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_slice(&summary).unwrap();
    let groups = groundwave::output::hdf5::read(&gathered.join("study.h5")).unwrap();
    let study = groups.iter().find(|group| group.name == "study").unwrap();
    for key in ["critical_speed", "max_down", "line_speed_amplification"] {
        let stored = study.get(&format!("critical_speed.{key}")).unwrap().to_vec()[number];
        assert_eq!(summary["critical_speed"][key].as_f64().unwrap().to_bits(), stored.to_bits(), "{key}");
    }
    let curves = groups.iter().find(|group| group.name == "critical_speed").unwrap();
    assert_eq!(curves.get("max_down").unwrap().dims, ["sample", "speed"]);
}

#[test]
fn run_and_check_say_that_there_is_a_study() {
    let folder = folder_with(&uncertain("[100.0, 140.0, 180.0]", 12, ""));
    let check = groundwave(&["check", "case.toml"], folder.path());
    assert!(flat(&check.stdout).contains("[study]: 12 samples of 3 numbers"), "{}", flat(&check.stdout));
    let run = groundwave(&["run", "case.toml", "--no-pictures"], folder.path());
    assert!(flat(&run.stdout).contains("its [study] is run by: groundwave study case.toml"));
}
