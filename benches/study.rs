//! How many grounds in an hour, how much memory, and are they the numbers of a plain loop: the paper's track, 40 speeds.
//!
//! Not by divan: what is asked is thousands of samples once, not the time of one.

use groundwave::ensemble::{self, Shard, statistics};
use groundwave::{Case, Silent};
use std::path::Path;
use std::time::Instant;

const CRITICAL: &str = "critical_speed.critical_speed";

/// The uncertain case of `soil_cases` with 40 speeds and so many samples, without derivatives.
fn case(samples: usize) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("soil_cases/lamprea2022_uncertain/case.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let text = text
        .replace(
            "{ from = \"100 km/h\", to = \"860 km/h\", step = \"40 km/h\" }",
            "{ from = 27.5, to = 242.0, step = 5.5 }",
        )
        .replace("samples = 100", &format!("samples = {samples}\nderivatives = false"));
    Case::parse(&text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap()
}

/// Largest memory of this process so far [MB].
fn peak() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes =
        line.and_then(|rest| rest.split_whitespace().next()).and_then(|number| number.parse::<f64>().ok());
    kilobytes.unwrap_or(f64::NAN) / 1e3
}

/// Processor time of all threads of this process so far [s].
fn processor() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    // utime and stime in hundredths of a second
    let ticks = |i: usize| fields.get(i).and_then(|field| field.parse::<f64>().ok()).unwrap_or(f64::NAN);
    0.01 * (ticks(11) + ticks(12))
}

/// Runs `samples` on so many threads into a new folder.
fn run(samples: usize, threads: usize) -> tempfile::TempDir {
    let (case, folder) = (case(samples), tempfile::tempdir().unwrap());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let (started, before) = (Instant::now(), processor());
    pool.install(|| ensemble::run(&case, folder.path(), Shard::WHOLE, &Silent)).unwrap();
    let (wall, used) = (started.elapsed().as_secs_f64(), processor() - before);
    println!(
        "{samples:5} samples, {threads} threads: {wall:6.1} s, {:.0} samples in an hour, {:.0} in a core-hour; peak {:.1} MB",
        3600.0 * samples as f64 / wall,
        3600.0 * samples as f64 / used,
        peak()
    );
    folder
}

fn main() {
    run(100, 1);
    run(100, 2);
    let folder = run(1000, 2);
    let started = Instant::now();
    let (case, table) = ensemble::table(folder.path(), &Silent).unwrap();
    println!("gathered in {:.2} s, peak {:.1} MB", started.elapsed().as_secs_f64(), peak());
    let study = case.study.unwrap();
    let single = |i: usize| {
        let case = Case::parse(&study.text(&study.values(i)), "sample", &|_| Err(String::new())).unwrap();
        let outcome = case.studies[0].run(&case.railway, &Silent).unwrap();
        let curve = outcome.group.get("max_down").unwrap().to_vec();
        assert_eq!(table.curves["critical_speed/max_down"].values.row(i).to_vec(), curve, "sample {i}");
        outcome.answers.iter().find(|answer| answer.key == "critical_speed").unwrap().value
    };
    let speeds: Vec<f64> = (0..1000).map(single).collect();
    assert_eq!(speeds, table.answers[CRITICAL].1);
    let sorted = statistics::sorted(speeds.iter().copied());
    let [p5, p50, p95] = [0.05, 0.5, 0.95].map(|p| statistics::quantile(&sorted, p));
    let mean = speeds.iter().sum::<f64>() / 1000.0;
    println!(
        "1000 samples x 40 speeds equal a plain loop, bit for bit: mean {mean:.2}, P5 {p5:.2}, P50 {p50:.2}, P95 {p95:.2} m/s"
    );
}
