//! Trains on six soft layers: what is called critical is a matter of ground and track, whatever runs on them.

use crate::{Run, compute, near};
use groundwave::Case;
use groundwave::figure::Figure;
use std::fmt::Write;

/// Thickness [m], c_s [m/s], the other elastic constant, ρ [kg/m³], damping ratio.
const LAYERS: [(f64, f64, &str, f64, f64); 5] = [
    (1.0, 120.0, "poisson = 0.35", 1800.0, 0.03),
    (4.0, 70.0, "pressure_speed = 1500.0", 1550.0, 0.03),
    (5.0, 95.0, "pressure_speed = 1500.0", 1650.0, 0.025),
    (6.0, 160.0, "pressure_speed = 1550.0", 1850.0, 0.02),
    (10.0, 240.0, "pressure_speed = 1650.0", 1950.0, 0.02),
];

/// A slab track on the layers, with `damping` times their damping; `train` runs at `speeds`.
fn run(train: &str, speeds: &str, damping: f64) -> Run {
    let mut text = "title = \"Six layers\"\ntrack = \"lamprea2022_slab\"\n[soil]\n".to_owned();
    for (thickness, c_s, elastic, rho, xi) in LAYERS {
        writeln!(
            text,
            "[[soil.layer]]\nthickness = {thickness:?}\nshear_speed = {c_s:?}\n{elastic}\ndensity = {rho:?}\ndamping_ratio = {:?}",
            xi * damping
        )
        .unwrap();
    }
    writeln!(
        text,
        "[soil.half_space]\nshear_speed = 400.0\npressure_speed = 1900.0\ndensity = 2050.0\ndamping_ratio = {:?}\n[train]\n{train}\n\
         [critical_speed]\nspeeds = {speeds}",
        0.015 * damping
    )
    .unwrap();
    compute(Case::parse(&text, "six layers", &|_| Err(String::new())).unwrap())
}

/// Captions of the pictures.
fn captions(run: &Run) -> String {
    run.outcome("critical_speed").figures.iter().map(|f| f.1.as_str()).collect()
}

/// What used to be called critical speed: 314, 346, 367 and 394 km/h for 1, 2, 4 and 8 ICE 3; one axle 286 km/h.
#[test]
fn the_critical_speed_is_that_of_one_axle() {
    for (count, largest) in [(1, 314.4), (8, 393.6)] {
        let speeds = "{ from = 70.0, to = 118.0, step = 4.0 }";
        let case = run(&format!("vehicle = \"goicolea2014_ice3\"\ncount = {count}"), speeds, 1.0);
        let answer = |key: &str| case.answer("critical_speed", key);
        // 285.8 for both
        near("critical speed [km/h]", 3.6 * answer("critical_speed"), 285.8, 0.5);
        assert_eq!(answer("critical_speed"), answer("single_axle_critical_speed"));
        // 314.3 and 393.6
        near("this train [km/h]", 3.6 * answer("train_largest_speed"), largest, 0.5);
        assert!(answer("max_down") > 1.9 * answer("single_axle_max_down"));
        assert!(case.codes().contains(&"train-above-critical"), "{:?}", case.codes());
        let outcome = case.outcome("critical_speed");
        // first what is safe; the train's number is called critical nowhere
        assert_eq!(outcome.answers[0].key, "critical_speed");
        let of_train: Vec<_> = outcome.answers.iter().filter(|a| a.what.contains("this train")).collect();
        assert!(of_train.len() >= 4, "{of_train:?}");
        assert!(of_train.iter().all(|a| !a.what.to_lowercase().contains("critical")), "{of_train:?}");
        for (figure, _) in &outcome.figures {
            let Figure::Lines(lines) = figure else { panic!("a map") };
            let marks: Vec<&str> = lines.marks.iter().map(|m| m.1.as_str()).collect();
            assert!(
                marks[0].starts_with("critical speed 286 km/h") && marks[1].starts_with("train's largest")
            );
        }
    }
}

/// Towards speed 0 the curve of a train tends to 1.019, that of one axle to 0.998: hysteresis, in proportion to the loss factors.
#[test]
fn a_train_that_creeps_is_not_one_that_stands() {
    let eight = "vehicle = \"goicolea2014_ice3\"\ncount = 8";
    let ratio = |case: &Run| {
        case.values("critical_speed", "max_down")[0] / case.answer("critical_speed", "reference_deflection")
    };
    let damped = run(eight, "[0.2, 0.4]", 1.0);
    let light = run(eight, "[0.2, 0.4]", 0.1);
    let alone = run("axles = [{ position = 0.0, load = 150e3 }]", "[0.2, 0.4]", 1.0);
    // 1.01850, 1.00209 and 0.99796: 8.9 times less damping makes 8.9 times less
    near("eight", ratio(&damped), 1.0185, 2e-4);
    near("a tenth of the damping", ratio(&light), 1.0021, 2e-4);
    near("one axle", ratio(&alone), 0.9980, 2e-4);
    assert!(captions(&damped).contains("tends to 1.019, not to 1"), "{}", captions(&damped));
    assert!(!captions(&light).contains("not to 1") && !captions(&alone).contains("not to 1"));
}

/// One axle: its keys, words and marks are as they were.
#[test]
fn one_axle_has_one_number() {
    let case = run("axles = [{ position = 0.0, load = 150e3 }]", "[75.0, 80.0, 85.0]", 1.0);
    let outcome = case.outcome("critical_speed");
    let keys: Vec<&str> = outcome.answers.iter().map(|a| a.key.as_str()).collect();
    let levels = ["speed_at_amplification_1.2", "speed_at_amplification_1.5"];
    assert_eq!(keys[..4], ["critical_speed", "max_down", "reference_deflection", "amplification"]);
    assert_eq!(keys[4..], levels);
    assert_eq!(outcome.answers[0].what, "Critical speed");
}
