//! Every case of `soil_cases` against its publication. Nothing is reduced: what is asserted is what a user gets.
//!
//! Measured values stand beside the tolerances; all lengths in millimetres, speeds in m/s unless named km/h.

mod application3;
mod closed_forms;
mod dispersion;
mod lamprea;
mod ledsgard;
mod mezher;
mod passages;
mod rolling_noise;
mod six_layers;
mod standing_load;

use groundwave::dataset::Attribute;
use groundwave::{Case, Outcome, Silent};
use std::path::{Path, PathBuf};

/// A case with everything its studies left.
struct Run {
    case: Case,
    outcomes: Vec<(&'static str, Outcome)>,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("soil_cases")
}

/// Loads and runs a case as it stands, without writing files. It may leave no concern.
fn run(name: &str) -> Run {
    run_with(name, &[])
}

/// The same; it leaves the concerns with these `codes` and no other.
fn run_with(name: &str, codes: &[&str]) -> Run {
    let case = Case::load(&folder().join(name).join("case.toml")).unwrap();
    let run = compute(case);
    assert_eq!(run.codes(), codes, "{}", run.case.title);
    run
}

fn run_case(case: Case) -> Run {
    let run = compute(case);
    assert_eq!(run.codes(), [""; 0], "{}", run.case.title);
    run
}

fn compute(case: Case) -> Run {
    let outcomes = case.studies.iter().map(|s| (s.name(), s.run(&case.railway, &Silent).unwrap())).collect();
    Run { case, outcomes }
}

impl Run {
    fn outcome(&self, study: &str) -> &Outcome {
        &self.outcomes.iter().find(|(name, _)| *name == study).unwrap().1
    }

    /// Codes of the concerns of all studies.
    fn codes(&self) -> Vec<&'static str> {
        self.outcomes.iter().flat_map(|(_, o)| o.concerns.iter().map(|c| c.code)).collect()
    }

    /// An answer in SI units.
    fn answer(&self, study: &str, key: &str) -> f64 {
        self.outcome(study).answers.iter().find(|a| a.key == key).unwrap_or_else(|| panic!("{key}")).value
    }

    fn critical_speed(&self) -> f64 {
        self.answer("critical_speed", "critical_speed")
    }

    /// An answer of the critical speed study in mm.
    fn critical_mm(&self, key: &str) -> f64 {
        1e3 * self.answer("critical_speed", key)
    }

    /// A variable of a study, flattened.
    fn values(&self, study: &str, variable: &str) -> Vec<f64> {
        self.outcome(study).group.get(variable).unwrap_or_else(|| panic!("{variable}")).to_vec()
    }

    /// The largest downward deflection [mm] at `speed`, one of the speeds of the curve.
    fn curve_mm(&self, speed: f64) -> f64 {
        let speeds = self.values("critical_speed", "speed");
        let i = speeds.iter().position(|v| (v - speed).abs() < 1e-6).unwrap();
        1e3 * self.values("critical_speed", "max_down")[i]
    }
}

/// Asserts |got − wanted| ≤ tolerance and prints both.
#[track_caller]
fn near(what: &str, got: f64, wanted: f64, tolerance: f64) {
    println!("{what}: {got:.5}, wanted {wanted} ± {tolerance}");
    assert!((got - wanted).abs() <= tolerance, "{what}: {got} is not {wanted} ± {tolerance}");
}

/// Asserts a relative difference.
#[track_caller]
fn relative(what: &str, got: f64, wanted: f64, tolerance: f64) {
    println!("{what}: {got:.5}, wanted {wanted}, difference {:+.4} %", 100.0 * (got / wanted - 1.0));
    assert!((got / wanted - 1.0).abs() <= tolerance, "{what}: {got} is not {wanted} within {tolerance}");
}

/// Cases without published results to compare with.
const NOTHING_PUBLISHED: &[&str] = &["goicolea2014_ice3_free_field", "lamprea2022_uncertain"];

#[test]
fn no_case_is_forgotten() {
    let mut found: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.join("case.toml").is_file())
        .map(|p| {
            assert!(p.join("README.md").metadata().is_ok_and(|m| m.len() > 0), "{}: README.md", p.display());
            p.file_name().unwrap().to_str().unwrap().to_owned()
        })
        .collect();
    found.sort();
    let mut tested = [
        application3::CASES,
        lamprea::CASES,
        ledsgard::CASES,
        mezher::CASES,
        passages::CASES,
        rolling_noise::CASES,
        standing_load::CASES,
        NOTHING_PUBLISHED,
    ]
    .concat();
    tested.sort_unstable();
    assert_eq!(found, tested);
}

#[test]
fn answers_and_arrays_tell_the_same() {
    let case = &*lamprea::BALLASTED;
    let attribute = |name: &str| {
        let attributes = &case.outcome("critical_speed").group.attributes;
        match attributes.iter().find(|(key, _)| key == name).unwrap().1 {
            Attribute::Number(value) => value,
            ref other => panic!("{other:?}"),
        }
    };
    for key in ["critical_speed", "max_down", "reference_deflection", "amplification"] {
        assert_eq!(attribute(key), case.answer("critical_speed", key), "{key}");
    }
    assert_eq!(case.case.title, "Ballasted track on layered ground");
}
