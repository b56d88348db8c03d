//! What does a train cost that passes in time: one wheel over 60 m, eight vehicles over 300 m of track?

#[path = "../tests/common/mod.rs"]
mod common;

use common::tracks::TRACK_IN_TIME;
use divan::{Bencher, black_box};
use groundwave::{Case, Silent};

fn main() {
    divan::main();
}

/// One rail on sleepers every 0.6 m, eight elements in a bay, steps of 0.1 ms at 40 m/s.
fn case(train: &str, to: f64) -> Case {
    let text = format!(
        r#"
title = "bench"
{TRACK_IN_TIME}[train]
wheel_rail.radius = 0.46
{train}
[passage]
speed = 40.0
from = 0.0
to = {to}
step = 1e-4
"#
    );
    Case::parse(&text, "bench.toml", &|_| Err("there is no such file".to_owned())).unwrap()
}

fn run(case: &Case) -> usize {
    black_box(case).studies[0].run(&case.railway, &Silent).unwrap().answers.len()
}

/// 15 000 steps over 96 m of track.
#[divan::bench(sample_count = 5)]
fn one_wheel(bencher: Bencher) {
    let case = case("axles = [{ position = 0.0, load = 150e3 }]\nunsprung_mass = 1200.0", 60.0);
    bencher.bench(|| run(&case));
}

/// 18 500 steps of eight vehicles with ten degrees of freedom over 300 m of rough track.
#[divan::bench(sample_count = 1)]
fn eight_vehicles(bencher: Bencher) {
    let train = "vehicle = \"iwnicki1998_manchester_benchmark\"\ncount = 8\nlength = 24.0\n[irregularity]\nkind = \"fra-break-wavenumber\"\nclass = 5\nwavelengths = { from = 1.0, to = 50.0 }";
    let case = case(train, 74.0);
    bencher.bench(|| run(&case));
}
