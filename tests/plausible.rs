//! Numbers in the wrong unit are refused, or raise a concern that names their key.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use groundwave::case::Case;
use groundwave::case::library::ENTRIES;
use std::path::Path;

const ASKED: &str = "[track_response]\nspeeds = [50.0]\n";

const BALLASTED: &str = r#"[track]
kind = "ballasted"
rail.bending_stiffness = 1.276e7
rail.mass = 120.46
pad.stiffness = 7.0e8
pad.damping = 3.84e4
sleeper.mass = 490.0
ballast.kind = "bars"
ballast.young = 1.4e8
ballast.height = 0.35
ballast.density = 1700.0
ballast.alpha = 0.5
contact.half_width = 1.25
contact.compatibility = "centre"
"#;

const SLAB: &str = r#"[track]
kind = "slab"
rail.bending_stiffness = 1.276e7
rail.mass = 120.46
pad.stiffness = 7.0e8
slab.bending_stiffness = 9.77e7
slab.mass = 1250.0
contact.half_width = 1.25
contact.compatibility = "mean"
"#;

const BOGIES: &str = r#"[train]
model = "ten"
body = { mass = 47800.0, pitch_inertia = 1.957888e6, bogie_centres = 17.375 }
bogie = { mass = 3500.0, pitch_inertia = 1715.0, wheelbase = 2.5 }
wheelset.mass = 1800.0
primary = { stiffness = 2.4e6, damping = 20e3 }
secondary = { stiffness = 0.7e6, damping = 40e3 }
wheel_rail.radius = 0.46
"#;

const WHEELS: &str = r#"[train]
axles = [{ position = 0.0, load = 150e3 }]
unsprung_mass = 1800.0
wheel_rail.stiffness = 1.94e9
[free_field]
speed = "200 km/h"
receivers = [8.0]
[irregularity]
"#;

/// Ground, the ballasted track, an axle, a question.
fn ballasted() -> String {
    case(LAYERS, &format!("{BALLASTED}[train]\naxles = [{{ position = 0.0, load = 150e3 }}]\n{ASKED}"))
}

fn slab() -> String {
    ballasted().replace(BALLASTED, SLAB)
}

fn beam() -> String {
    case(&LAYERS.replace("loss_factor", "damping_ratio"), &format!("{TRACK}{ASKED}"))
}

fn bogies() -> String {
    case(LAYERS, &format!("{BALLASTED}{BOGIES}{ASKED}"))
}

fn rough(irregularity: &str) -> String {
    case(LAYERS, &format!("{BALLASTED}{WHEELS}{irregularity}"))
}

/// What is said of `text`: its fault, or its concerns.
fn said(text: &str, file: &str) -> String {
    let open = |_: &str| Ok(file.to_owned());
    match Case::parse(text, "case.toml", &open) {
        Ok(case) => case.concerns.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"),
        Err(error) => {
            format!("{error}; {}", miette::Diagnostic::help(&error).map_or(String::new(), |h| h.to_string()))
        }
    }
}

#[test]
fn slips_of_unit_are_noticed() {
    let (ballasted, slab, beam, bogies) = (ballasted(), slab(), beam(), bogies());
    let sine = rough("kind = \"sinusoidal\"\nwavelength = 2.0\namplitude = 1e-4\n");
    let wheels =
        rough("kind = \"out-of-round\"\nradius = 0.46\norders = [{ order = 3, amplitude = 1e-4 }]\n");
    let road = rough("kind = \"iso8608\"\nroughness = 1e-8\nwavelengths = { from = 1.0, to = 50.0 }\n");
    let springs =
        format!("title = \"x\"\n[foundation]\nkind = \"winkler\"\nstiffness = 1e8\n{}{ASKED}", TRACK);
    let shear = springs.replace("winkler\"\nstiffness", "pasternak\"\nshear = 2e7\nstiffness");
    for text in [&ballasted, &slab, &beam, &bogies, &sine, &wheels, &road, &springs, &shear] {
        assert_eq!(said(text, ""), "", "{text}");
    }
    let slips: &[(&str, &str, &str, &str)] = &[
        (&ballasted, "load = 150e3", "load = 15", "train.axles[0].load"),
        (&ballasted, "load = 150e3", "load = 150.0", "train.axles[0].load"),
        (&ballasted, "thickness = 2.0", "thickness = 2000", "soil.layer[0].thickness"),
        (&ballasted, "density = 1500.0", "density = 1.5", "soil.layer[0].density"),
        (&ballasted, "density = 1500.0", "density = 15", "soil.layer[0].density"),
        (&ballasted, "density = 1800.0", "density = 18", "soil.half_space.density"),
        (&beam, "damping_ratio = 0.06", "damping_ratio = 3", "soil.layer[0].damping_ratio"),
        (&ballasted, "loss_factor = 0.06", "loss_factor = 6", "soil.layer[0].loss_factor"),
        (&ballasted, "young = 60e6", "young = 60e3", "soil.layer[0].young"),
        (&ballasted, "half_width = 1.25", "half_width = 1250", "track.contact.half_width"),
        (&ballasted, "half_width = 1.25", "half_width = 125", "track.contact.half_width"),
        (&ballasted, "pad.stiffness = 7.0e8", "pad.stiffness = 700", "track.pad.stiffness"),
        (&ballasted, "pad.damping = 3.84e4", "pad.damping = 38.4", "track.pad.damping"),
        (
            &ballasted,
            "rail.bending_stiffness = 1.276e7",
            "rail.bending_stiffness = 12.76",
            "track.rail.bending_stiffness",
        ),
        (&ballasted, "rail.mass = 120.46", "rail.mass = 0.12", "track.rail.mass"),
        (&ballasted, "sleeper.mass = 490.0", "sleeper.mass = 0.49", "track.sleeper.mass"),
        (&ballasted, "ballast.young = 1.4e8", "ballast.young = 140", "track.ballast.young"),
        (&ballasted, "ballast.height = 0.35", "ballast.height = 350", "track.ballast.height"),
        (&ballasted, "ballast.height = 0.35", "ballast.height = 35", "track.ballast.height"),
        (&ballasted, "ballast.density = 1700.0", "ballast.density = 1.7", "track.ballast.density"),
        (&ballasted, "ballast.alpha = 0.5", "ballast.alpha = 50", "track.ballast.alpha"),
        (&slab, "slab.mass = 1250.0", "slab.mass = 1.25", "track.slab.mass"),
        (
            &slab,
            "slab.bending_stiffness = 9.77e7",
            "slab.bending_stiffness = 97.7",
            "track.slab.bending_stiffness",
        ),
        (&beam, "beam.mass = 2000.0", "beam.mass = 2", "track.beam.mass"),
        (
            &beam,
            "beam.bending_stiffness = 1.0e8",
            "beam.bending_stiffness = 100",
            "track.beam.bending_stiffness",
        ),
        (&springs, "stiffness = 1e8", "stiffness = 100", "foundation.stiffness"),
        (&shear, "shear = 2e7", "shear = 20", "foundation.shear"),
        (&bogies, "mass = 47800.0", "mass = 47.8", "train.body.mass"),
        (&bogies, "pitch_inertia = 1.957888e6", "pitch_inertia = 1957.9", "train.body.pitch_inertia"),
        (&bogies, "mass = 3500.0", "mass = 3.5", "train.bogie.mass"),
        (&bogies, "wheelset.mass = 1800.0", "wheelset.mass = 1.8", "train.wheelset.mass"),
        (&bogies, "stiffness = 2.4e6", "stiffness = 2.4", "train.primary.stiffness"),
        (&bogies, "stiffness = 0.7e6", "stiffness = 0.7", "train.secondary.stiffness"),
        (&bogies, "damping = 20e3", "damping = 20", "train.primary.damping"),
        (&bogies, "radius = 0.46", "radius = 460", "train.wheel_rail.radius"),
        (&sine, "unsprung_mass = 1800.0", "unsprung_mass = 1.8", "train.unsprung_mass"),
        (&sine, "stiffness = 1.94e9", "stiffness = 1.94", "train.wheel_rail.stiffness"),
        (&sine, "amplitude = 1e-4", "amplitude = 0.1", "irregularity.amplitude"),
        (&sine, "amplitude = 1e-4", "amplitude = 100", "irregularity.amplitude"),
        (&sine, "speed = \"200 km/h\"", "speed = 250", "free_field.speed"),
        (&wheels, "radius = 0.46", "radius = 460", "irregularity.radius"),
        (&wheels, "amplitude = 1e-4", "amplitude = 0.1", "irregularity.orders[0].amplitude"),
        (&road, "roughness = 1e-8", "roughness = 16", "irregularity.roughness"),
        (&ballasted, "speeds = [50.0]", "speeds = [50.0, 250.0]", "track_response.speeds[1]"),
    ];
    assert!(slips.len() >= 31);
    let mut missed = Vec::new();
    for (text, from, to, key) in slips {
        assert!(text.contains(from), "{from}");
        let said = said(&text.replacen(from, to, 1), "");
        if !said.contains(key) {
            missed.push(format!("{to}: {said:?} does not name {key}"));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    let load = said(&ballasted.replace("load = 150e3", "load = 150"), "");
    assert!(load.contains("150 kN = 1.5e5 N"), "{load}");
    let speed = said(&ballasted.replace("speeds = [50.0]", "speeds = [250.0]"), "");
    assert!(speed.contains("250 km/h = 69.44 m/s"), "{speed}");
}

#[test]
fn slips_in_a_file_beside_the_case_are_noticed() {
    let vehicle = "title = \"x\"\naxles = [{ position = 0.0, load = 150 }]\n";
    let text = ballasted().replace("axles = [{ position = 0.0, load = 150e3 }]", "vehicle = \"mine.toml\"");
    let found = said(&text, vehicle);
    assert!(found.contains("axles[0].load in mine.toml is 150 N") && found.contains("150 kN"), "{found}");
}

#[test]
fn what_ships_with_the_program_is_usual() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("soil_cases");
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path().join("case.toml");
        if path.is_file() {
            let case = Case::load(&path).unwrap();
            // a bridge on next to no springs, under a mass on a soft one, is none of a railway's numbers
            let bridge = path.to_string_lossy().contains("cantero2022_sprung_mass");
            let said: Vec<&str> = case.concerns.iter().filter_map(|c| c.message.split(' ').next()).collect();
            let expected: &[&str] =
                if bridge { &["foundation.stiffness", "train.wheel_rail.stiffness"] } else { &[] };
            assert_eq!(said, expected, "{}: {:?}", path.display(), case.concerns);
            count += 1;
        }
    }
    assert!(count > 10 && ENTRIES.len() > 10, "{count}");
    let template = Case::parse(groundwave::case::TEMPLATE, "new", &|_| Err(String::new())).unwrap();
    assert!(template.concerns.is_empty(), "{:?}", template.concerns);
}

/// A profile of 100 m, two waves, in metres times `factor` under `header`.
fn profile(header: &str, between: &str, factor: f64) -> String {
    let r = |x: f64| 3e-3 * (std::f64::consts::TAU * x / 20.0).sin();
    (0..400).fold(format!("{header}\n"), |text, i| {
        let x = 0.25 * f64::from(i);
        text + &format!("{x}{between}{:.9}\n", factor * r(x))
    })
}

#[test]
fn the_unit_in_a_header_is_obeyed_and_odd_profiles_are_told() {
    let text = rough("kind = \"measured\"\nfile = \"rail.csv\"\n");
    for csv in [
        profile("x,r", ",", 1.0),
        profile("x [m], r [mm]", ",", 1e3),
        profile("x (m);r (µm)", ";", 1e6),
        profile("x\tr_um", "\t", 1e6),
    ] {
        assert_eq!(said(&text, &csv), "", "{csv}");
    }
    // millimetres and micrometres that no header names
    for factor in [1e3, 1e6] {
        let found = said(&text, &profile("x,r", ",", factor));
        assert!(found.contains("steep-rail") && found.contains("rough-rail"), "{found}");
        assert!(found.contains("irregularity.file") && found.contains("rail.csv"), "{found}");
    }
    let whole = profile("x,r", ",", 1.0);
    let cut: Vec<&str> =
        whole.lines().enumerate().filter(|(i, _)| !(200..205).contains(i)).map(|l| l.1).collect();
    let found = said(&text, &cut.join("\n"));
    assert!(
        found.contains("gap-in-profile") && found.contains("from x = 49.5 to 51 m (line 201)"),
        "{found}"
    );
    let unknown = said(&text, &profile("x [m], r [in]", ",", 1.0));
    assert!(unknown.contains("irregularity.file") && unknown.contains("\"in\""), "{unknown}");
}

#[test]
fn a_record_in_millimetres_is_noticed() {
    let record = "[[track_response.measured]]\nspeed = 50.0\nfile = \"r.csv\"\nlabel = \"measured\"\n";
    let text = ballasted() + record;
    assert_eq!(said(&text, "x [m]; deflection [mm]\n-10; 0,5\n0; 4\n10; 0,5\n"), "");
    let found = said(&text, "x, deflection\n-10, 0.5\n0, 4\n10, 0.5\n");
    assert!(found.contains("track_response.measured[0].file: r.csv has a deflection of 4.000 m"), "{found}");
}

#[test]
fn concerns_of_a_case_reach_every_output() {
    let folder = tempfile::tempdir().unwrap();
    let text = case(LAYERS, &format!("{TRACK}{ASKED}")).replace("load = 150e3", "load = 150");
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let check = groundwave(&["check", "case.toml"], folder.path());
    assert_eq!(check.status.code(), Some(0));
    let run = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    assert_eq!(run.status.code(), Some(0), "{}", flat(&run.stderr));
    let out = folder.path().join("out");
    let stored = groundwave::output::hdf5::read_text_attribute(&out.join("results.h5"), "concerns").unwrap();
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    for text in [flat(&check.stdout), flat(&run.stdout), read("summary.json"), read("report.html"), stored] {
        assert!(text.contains("unusual-value") && text.contains("train.axles[0].load"), "{text}");
    }
    let strict = groundwave(&["run", "case.toml", "--out", "again", "--strict"], folder.path());
    assert_eq!(strict.status.code(), Some(1));
    assert!(flat(&strict.stderr).contains("unusual-value"), "{}", flat(&strict.stderr));
}
