//! What a case may ask of a passage, and what it is refused for, at its key.

mod common;

use common::tracks::TRACK_IN_TIME as TRACK;
use groundwave::case::{Case, CaseError};
use groundwave::progress::Cancelled;
use groundwave::study::StudyError;
use groundwave::{Observer, Silent};
use miette::Diagnostic;

const WHEEL: &str = r#"
[train]
axles = [{ position = 0.0, load = 150e3 }]
unsprung_mass = 1200.0
wheel_rail.radius = 0.46
"#;
const LOADS: &str = "[train]\naxles = [{ position = 0.0, load = 150e3 }]\n";

/// A case with this passage, less its speed and way.
fn case(train: &str, passage: &str) -> String {
    format!("title = \"passage\"\n{TRACK}{train}[passage]\nspeed = 40.0\nfrom = 0.0\nto = 12.0\n{passage}")
}

fn faults(text: &str) -> Vec<CaseError> {
    match Case::parse(text, "case.toml", &|_| Err("there is no such file".to_owned())) {
        Ok(_) => Vec::new(),
        Err(error) => error.each(),
    }
}

#[test]
fn is_refused_at_its_key() {
    let defect = |keys: &str| format!("[[passage.defect]]\nat = 6.0\n{keys}");
    for (train, passage, key, said) in [
        (WHEEL, "step = 0.0\n".to_owned(), "passage.step", "above zero"),
        (WHEEL, "step = 1e-4\nstep_length = 1e-3\n".into(), "passage.step_length", "both given"),
        (WHEEL, "alpha = -0.5\n".into(), "passage.alpha", "between -1/3 and 0"),
        (WHEEL, "elements_per_bay = 0\n".into(), "passage.elements_per_bay", "between 1 and 64"),
        (WHEEL, "ends = \"pined\"\n".into(), "passage.ends", "pinned"),
        (WHEEL, "ends = \"absorbing\"\n".into(), "passage.ends", "length"),
        (
            WHEEL,
            "ends = { kind = \"absorbing\", length = 9.0, damping = -1.0 }\n".into(),
            "passage.ends.damping",
            "above zero",
        ),
        (WHEEL, "track = { from = 3.0, to = 40.0 }\n".into(), "passage.track", "run from 0 to 12 m"),
        (WHEEL, "speeds = [40.0]\n".into(), "passage.speeds", "both given"),
        (WHEEL, "ramp = 6.0\nstart = \"static\"\n".into(), "passage.ramp", "no ramp"),
        (
            WHEEL,
            "hanging_sleeper = [{ sleepers = [9, 10], gap = -1e-3 }]\n".into(),
            "passage.hanging_sleeper[0].gap",
            "not negative",
        ),
        (
            WHEEL,
            "missing_sleepers = [-3, 9]\nhanging_sleeper = [{ sleepers = [9], gap = 1e-3 }]\n".into(),
            "passage.hanging_sleeper[0].sleepers[0]",
            "twice",
        ),
        (
            WHEEL,
            defect("wheels = [1]\nkind = \"fresh-flat\"\nradius = 0.46\nlength = 0.95\n"),
            "passage.defect[0].length",
            "shorter than 0.92 m",
        ),
        (
            WHEEL,
            defect("wheels = [2]\nkind = \"fresh-flat\"\nradius = 0.46\nlength = 0.05\n"),
            "passage.defect[0].wheels[0]",
            "wheels 1 to 1",
        ),
        (
            WHEEL,
            defect("kind = \"fresh-flat\"\nradius = 0.46\nlength = 0.05\n"),
            "passage.defect[0]",
            "which wheels",
        ),
        (
            WHEEL,
            defect("wheels = [1]\nkind = \"ramp\"\ndepth = 0.002\nlength = 0.6\n"),
            "passage.defect[0].wheels",
            "lies in the rail",
        ),
        (
            WHEEL,
            defect("kind = \"step\"\nradius = 0.46\ndepth = 0.5\n"),
            "passage.defect[0].depth",
            "rolls over steps",
        ),
        (
            WHEEL,
            defect("kind = \"dipped-joint\"\nshape = \"v\"\nangle = 5.0\nlength = 0.5\n"),
            "passage.defect[0].angle",
            "mrad",
        ),
        (
            WHEEL,
            defect("kind = \"dipped-joint\"\nshape = \"u\"\nangle = 5e-3\nlength = 0.5\n"),
            "passage.defect[0].shape",
            "quadratic",
        ),
        (
            WHEEL,
            defect("kind = \"rounded-flat\"\nradius = 0.46\nlength = 0.05\n"),
            "passage.defect[0]",
            "depth",
        ),
        (LOADS, "contact = \"linear\"\n".into(), "passage.contact", "have no mass"),
        ("", "contact = \"linear\"\n".into(), "passage", "give [train]"),
        (
            WHEEL,
            defect("kind = \"dip\"\nlength = 1.0\ndepth = 0.34\n"),
            "passage.defect[0].depth",
            "0.34 mm",
        ),
        (
            WHEEL,
            "damping = { frequencies = [50.0], ratios = [0.02, 0.03] }\n".into(),
            "passage.damping",
            "each mode has one",
        ),
        (
            WHEEL,
            "damping = { frequencies = [50.0, 500.0], ratios = [0.02, -0.03] }\n".into(),
            "passage.damping.ratios[1]",
            "not negative",
        ),
        (
            WHEEL,
            "track = { from = -60.0, to = 72.0 }\ndamping = { frequencies = [50.0, 500.0, 900.0], ratios = [0.02, 0.02, 0.02] }\n".into(),
            "passage.damping",
            "unknowns",
        ),
        (
            LOADS,
            defect("kind = \"ramp\"\ndepth = 0.002\nlength = 0.6\n"),
            "passage.defect[0]",
            "have no mass",
        ),
        (WHEEL, "frequencies = { from = 500.0, to = 5.0 }\n".into(), "passage.frequencies", "500"),
    ] {
        let found = faults(&case(train, &passage));
        let [fault] = &found[..] else { panic!("{passage}: {found:?}") };
        let help = fault.help().map_or(String::new(), |help| help.to_string());
        let text = format!("{fault} {help}");
        assert!(fault.key() == key && text.contains(said), "{key}: {} {text}", fault.key());
    }
}

/// What the track cannot do is said before anything is computed.
#[test]
fn tracks_that_cannot_pass_are_refused() {
    let hysteretic = TRACK.replace("pad.damping = 1.92e4", "pad.loss_factor = 0.15");
    let continuous = TRACK.replace("support.spacing = 0.6\n", "");
    let hanging = "hanging_sleeper = [{ sleepers = [9], gap = 1e-3 }]\n";
    for (track, passage, key, said) in [
        (hysteretic.as_str(), "", "passage", "Kelvin"),
        (TRACK, "at = [400.0]\n", "passage.at", "does not lie on the track"),
        (TRACK, "missing_sleepers = [9, 999]\n", "passage.missing_sleepers", "1 of 2 sleepers"),
        (&continuous, hanging, "passage.hanging_sleeper", "0 of 1 sleepers"),
    ] {
        let text = case(WHEEL, passage).replace(TRACK, track);
        let found = faults(&text);
        let [fault] = &found[..] else { panic!("{passage}: {found:?}") };
        assert!(fault.key() == key && fault.to_string().contains(said), "{key}: {} {fault}", fault.key());
    }
    for fine in [
        hanging,
        "missing_sleepers = [-3, 9]\n",
        "ends = { kind = \"absorbing\", length = 9.0, damping = 1e5 }\n",
    ] {
        let found = faults(&case(WHEEL, fine));
        assert!(found.is_empty(), "{fine}: {found:?}");
    }
}

/// Both rails with whole axles, or one rail with half of each: one answer, per wheel.
#[test]
fn one_rail_is_half_of_two() {
    let numbers = |text: &str| {
        let case = Case::parse(text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap();
        let outcome = case.studies[0].run(&case.railway, &Silent).unwrap();
        let of = |key: &str| outcome.answers.iter().find(|a| a.key == key).unwrap().value;
        [of("max_force_40"), of("min_force_40"), of("max_down_40")]
    };
    let passage = "step = 1e-4\nelements_per_bay = 4\n[[passage.defect]]\nkind = \"dip\"\nat = 3.0\ndepth = 1e-3\nlength = 1.5\n";
    let one = case(WHEEL, passage);
    let two = one
        .replace("rails = 1", "rails = 2")
        .replace("6.38e6", "12.76e6")
        .replace("60.23", "120.46")
        .replace("3.5e8", "7.0e8")
        .replace("1.92e4", "3.84e4")
        .replace("245.0", "490.0")
        .replace("1.8e8", "3.6e8")
        .replace("2.34e5", "4.68e5");
    for (a, b) in numbers(&one).into_iter().zip(numbers(&two)) {
        // rounding of the march
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
}

/// An observer that has enough at once.
struct Enough;

impl Observer for Enough {
    fn cancelled(&self) -> bool {
        true
    }
}

#[test]
fn it_can_be_cancelled() {
    let text = case(WHEEL, "");
    let case = Case::parse(&text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap();
    assert_eq!(case.studies[0].run(&case.railway, &Enough).unwrap_err(), StudyError::Cancelled(Cancelled));
}

/// What is too coarse, too long, too short or too deep is doubted, each once.
#[test]
fn doubts_are_said() {
    let passage = r#"
elements_per_bay = 2
step = 1e-3
contact = "linear"
start = "ramp"
track = { from = -6.0, to = 18.0 }
[[passage.defect]]
kind = "rounded-flat"
at = 6.0
wheels = [1]
radius = 0.46
length = 0.05
depth = 1e-3
"#;
    let text = case(WHEEL, passage)
        .replace("rail.mass = 60.23", "rail.mass = 60.23\nrail.shear_stiffness = 2.364e8");
    let case = Case::parse(&text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap();
    let outcome = case.studies[0].run(&case.railway, &Silent).unwrap();
    let codes: Vec<&str> = outcome.concerns.iter().map(|concern| concern.code).collect();
    let all = [
        "coarse-elements",
        "shearing-rail",
        "long-ramp",
        "deep-flat",
        "long-steps",
        "short-track",
        "pulling-contact",
    ];
    assert_eq!(codes, all);
}

/// Sleepers that hang by next to nothing are sleepers that do not; by more, the bed pushes less, and its neighbours carry the rest.
#[test]
fn hanging_sleepers() {
    let outcome = |passage: &str| {
        let text = case(LOADS, &format!("step = 5e-4\nelements_per_bay = 4\nat = [6.0, 6.6]\n{passage}"));
        let case = Case::parse(&text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap();
        case.studies[0].run(&case.railway, &Silent).unwrap()
    };
    let largest = |outcome: &groundwave::Outcome, name: &str, row: usize| {
        let values = &outcome.group.get(name).unwrap().values;
        values.index_axis(ndarray::Axis(0), row).iter().copied().fold(0.0, f64::max)
    };
    let (whole, loose) = (outcome(""), outcome("hanging_sleeper = [{ sleepers = [10], gap = 1e-3 }]\n"));
    // over the sleeper and over its neighbour the rail goes down further
    assert!(largest(&loose, "rail", 0) > 1.3 * largest(&whole, "rail", 0));
    assert!(largest(&loose, "sleeper", 1) > 1.1 * largest(&whole, "sleeper", 1));
    let bed = largest(&loose, "bed_force", 0);
    assert!(bed < 20e3, "{bed}");
}
