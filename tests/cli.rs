//! The command from outside: exit codes, messages, files written.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;
use tempfile::TempDir;

/// A whole case that runs in a moment. Line numbers in the tests count from its first line.
static CASE: LazyLock<String> = LazyLock::new(|| {
    let soil = format!("solver.kind = \"direct-stiffness\"\n{LAYERS}");
    case(&soil, &format!("{TRACK}[track_response]\nspeeds = [50.0, \"250 km/h\"]\n"))
});

fn code(output: &Output) -> i32 {
    output.status.code().expect("the command ends by itself")
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn folder_with(case: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, case).unwrap();
    (folder, path)
}

fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// `run` on the case with `from` replaced by `to` must end with code 2, one message that holds every one of `says`, and nothing
/// written.
fn refused(from: &str, to: &str, says: &[&str]) -> Result<(), String> {
    assert!(CASE.contains(from), "{from}");
    refused_case(&CASE.replacen(from, to, 1), says)
}

fn refused_case(case: &str, says: &[&str]) -> Result<(), String> {
    let (folder, _) = folder_with(case);
    let mut faults = Vec::new();
    for command in [&["check", "case.toml"][..], &["run", "case.toml", "--out", "out"]] {
        let output = groundwave(command, folder.path());
        let message = flat(&output.stderr);
        if code(&output) != 2 {
            faults.push(format!("{} exits {}", command[0], code(&output)));
        }
        if !output.stdout.is_empty() || names_in(folder.path()) != ["case.toml"] {
            faults.push(format!("{} wrote something", command[0]));
        }
        let count = err(&output).lines().filter(|line| line.trim_start().starts_with('×')).count();
        if count != 1 && !(count > 1 && message.ends_with(&format!("{count} faults"))) {
            faults.push(format!("{}: neither one message nor several and their number", command[0]));
        }
        for said in says {
            if !message.contains(said) {
                faults.push(format!("{}: no \"{said}\" in: {message}", command[0]));
            }
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

#[test]
fn bad_input_is_refused_in_one_message() {
    let rail = "axles = [{ position = 0.0, load = 150e3 }]";
    let asked = "[track_response]\nspeeds = [50.0, \"250 km/h\"]";
    let contour = "[contour]\nspeeds = [50.0]\nx = { from = -40.0, to = 20.0 }\ny = { from = -30.0, to = 30.0 }\nspacing = ";
    let (tiny, hopeless) = (format!("{contour}1e-3"), format!("{contour}1e-12"));
    let undamped = CASE.replace("loss_factor = 0.06", "loss_factor = 0.0");
    let critical = |speeds: &str| undamped.replace(asked, &format!("[critical_speed]\nspeeds = {speeds}"));
    let point = "[track]\nkind = \"none\"\nload.kind = \"point\"\n[train]";
    let mut point_case = CASE.replace(asked, "[critical_speed]\nspeeds = [10.0, 20.0, 30.0]");
    let (a, b) = (point_case.find("[track]").unwrap(), point_case.find("[train]").unwrap());
    point_case.replace_range(a..b + "[train]".len(), point);
    let springs = "title = \"x\"\n[foundation]\nkind = \"winkler\"\nstiffness = 1e8\n[track]\nkind = \"beam\"\n\
                   beam.bending_stiffness = 1e8\nbeam.mass = 2e3\n[dispersion]\nfrequencies = [10.0]\n";
    let cases: Vec<(&str, Result<(), String>)> = vec![
        (
            "unknown key",
            refused(
                "young = 60e6",
                "yuong = 60e6",
                &["case.toml:6", "yuong", "did you mean `young`?", "allowed"],
            ),
        ),
        ("missing key", refused("density = 1500.0\n", "", &["case.toml", "missing key `density`"])),
        (
            "missing thickness",
            refused("thickness = 2.0\n", "", &["case.toml", "soil.layer[0]", "missing key `thickness`"]),
        ),
        (
            "wrong type",
            refused(
                "young = 60e6",
                "young = \"60e6\"",
                &["case.toml:6", "young", "the text \"60e6\"", "wanted a number"],
            ),
        ),
        ("unknown unit", refused("250 km/h", "250 mph", &["case.toml:24", "mph", "km/h", "track_response"])),
        ("NaN", refused("young = 60e6", "young = nan", &["case.toml:6", "young", "NaN", "above zero"])),
        (
            "infinite",
            refused("density = 1500.0", "density = inf", &["case.toml:8", "density", "inf", "finite"]),
        ),
        (
            "negative",
            refused(
                "mass = 2000.0",
                "mass = -1.0",
                &["case.toml:18", "track.beam.mass", "-1", "not negative"],
            ),
        ),
        (
            "ν = 0.5",
            refused(
                "poisson = 0.35",
                "poisson = 0.5",
                &["case.toml:7", "soil.layer[0].poisson", "0.5", "0.499"],
            ),
        ),
        (
            "ν = -1",
            refused("poisson = 0.35", "poisson = -1.0", &["case.toml:7", "soil.layer[0].poisson", "-1"]),
        ),
        (
            "η < 0",
            refused("loss_factor = 0.06", "loss_factor = -0.06", &["case.toml:9", "loss_factor", "-0.06"]),
        ),
        (
            "zero thickness",
            refused(
                "thickness = 2.0",
                "thickness = 0",
                &["case.toml:5", "soil.layer[0].thickness", "above zero"],
            ),
        ),
        ("no axles", refused(rail, "axles = []", &["case.toml:22", "train.axles", "at least one axle"])),
        (
            "no load",
            refused("load = 150e3", "load = 0.0", &["case.toml:22", "train.axles", "at least one axle"]),
        ),
        ("NaN load", refused("load = 150e3", "load = nan", &["case.toml:22", "train.axles[0].load", "NaN"])),
        ("no train", refused(&format!("[train]\n{rail}\n"), "", &["case.toml", "track_response", "[train]"])),
        (
            "no base",
            refused(
                "[soil.half_space]\nyoung = 200e6\npoisson = 0.35\ndensity = 1800.0\nloss_factor = 0.06\n",
                "",
                &["case.toml", "no base", "rigid"],
            ),
        ),
        (
            "two bases",
            refused("[soil]", "[soil]\nbase = \"rigid\"", &["case.toml:3", "soil.base", "two bases"]),
        ),
        (
            "reversed speeds",
            refused(
                "[50.0, \"250 km/h\"]",
                "{ from = 200.0, to = 10.0, step = 2.0 }",
                &["case.toml:24", "track_response.speeds", "200", "swap"],
            ),
        ),
        (
            "descending list",
            refused(
                asked,
                "[critical_speed]\nspeeds = [10.0, 30.0, 20.0]",
                &["case.toml:24", "critical_speed.speeds[2]", "must ascend"],
            ),
        ),
        (
            "unknown soil",
            refused_case(
                "title = \"x\"\nsoil = \"lamprea2022_layerd\"\ntrack = \"lamprea2022_slab\"\n[track_response]\nspeeds = [10.0]\n",
                &["case.toml:2", "lamprea2022_layerd", "did you mean `lamprea2022_layered`?"],
            ),
        ),
        ("too large a grid", refused(asked, &tiny, &["case.toml", "contour", "GB", "larger spacing"])),
        ("a hopeless grid", refused(asked, &hopeless, &["case.toml", "contour", "GB", "larger spacing"])),
        (
            "undamped, supercritical",
            refused_case(
                &critical("[50.0, 100.0, 200.0]"),
                &["case.toml", "critical_speed", "no damping", "0.001"],
            ),
        ),
        (
            "descending frequencies",
            refused(
                asked,
                "[dispersion]\nfrequencies = [10.0, 30.0, 20.0]",
                &["case.toml:24", "dispersion.frequencies[2]", "must ascend"],
            ),
        ),
        (
            "frequency zero",
            refused(
                asked,
                "[dispersion]\nfrequencies = { from = 0.0, to = 20.0, step = 1.0 }",
                &["case.toml:24", "dispersion.frequencies", "found 0 Hz", "above zero"],
            ),
        ),
        (
            "kilohertz",
            refused(
                asked,
                "[dispersion]\nfrequencies = [2e4]",
                &["dispersion.frequencies[0]", "20000 Hz", "10 kHz"],
            ),
        ),
        (
            "no modes",
            refused(
                asked,
                "[dispersion]\nfrequencies = [10.0]\nmodes = 0",
                &["case.toml:25", "dispersion.modes", "between 1 and 20"],
            ),
        ),
        (
            "unknown wave",
            refused(
                asked,
                "[dispersion]\nfrequencies = [10.0]\nwave = \"stoneley\"",
                &["case.toml:25", "stoneley", "rayleigh", "love"],
            ),
        ),
        (
            "dispersion of springs",
            refused_case(springs, &["case.toml", "dispersion", "layered ground", "[soil]"]),
        ),
        ("point load", refused_case(&point_case, &["case.toml", "critical_speed", "point load", "patch"])),
        (
            "misspelt solver",
            refused(
                "\"direct-stiffness\"",
                "\"direct-stifness\"",
                &[
                    "case.toml:3",
                    "soil.solver.kind",
                    "did you mean `direct-stiffness`?",
                    "matrix, flexibility",
                ],
            ),
        ),
        (
            "misspelt witness",
            refused(
                "solver.kind = \"direct-stiffness\"",
                "solver.verify = \"flexibilty\"",
                &["case.toml:3", "soil.solver.verify", "did you mean `flexibility`?"],
            ),
        ),
        (
            "its own witness",
            refused(
                "solver.kind = \"direct-stiffness\"",
                "solver.verify = \"direct-stiffness\"",
                &["case.toml:3", "soil.solver.verify", "cannot verify itself", "name another solver"],
            ),
        ),
        (
            "witness of springs",
            refused_case(
                "title = \"x\"\nfoundation.kind = \"winkler\"\nfoundation.verify = \"flexibility\"\n",
                &["case.toml:3", "foundation", "unknown key `verify`"],
            ),
        ),
        ("syntax", refused("poisson = 0.35", "poisson = = 0.35", &["case.toml:7"])),
        ("empty", refused_case("", &["missing key `title`"])),
        ("nothing asked", refused(asked, "", &["asks for nothing", "[critical_speed]"])),
    ];
    let faults: Vec<String> =
        cases.into_iter().filter_map(|(name, result)| result.err().map(|e| format!("{name}: {e}"))).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// Slips that would run for hours, or answer another question than the one asked.
#[test]
fn slips_are_refused_at_their_key() {
    let rail = "axles = [{ position = 0.0, load = 150e3 }]";
    let speeds = "speeds = [50.0, \"250 km/h\"]";
    let measured =
        format!("{speeds}\n[[track_response.measured]]\nspeed = 52.0\nfile = \"r.csv\"\nlabel = \"r\"");
    let far = format!("{speeds}\nx = {{ from = -1e6, to = 20.0 }}");
    let length_missing = format!("{rail}\ncount = 8");
    let train = |axles: &str| format!("axles = [{{ position = 0.0, load = 150e3 }}, {axles}]");
    let cases: [(&str, &str, &[&str]); 11] = [
        ("young = 60e6", "young = 60", &["soil.layer[0].young", "case.toml:6", "1.217e-1 m/s", "Pa"]),
        ("thickness = 2.0", "thickness = 2e-6", &["soil.layer[0].thickness", "case.toml:5", "metres"]),
        (
            "bending_stiffness = 1.0e8",
            "bending_stiffness = 0.0",
            &["track.beam.bending_stiffness", "above zero"],
        ),
        (speeds, "speeds = [50.0, 50.001]", &["track_response.speeds[1]", "twice"]),
        (speeds, &measured, &["cannot read \"r.csv\"", "track_response.measured[0].file"]),
        (speeds, &far, &["track_response.x", "metres"]),
        (rail, &length_missing, &["train.count", "no `length`"]),
        (rail, "vehicle = \"lamprea2022_axle\"\ncount = 2", &["train.count", "no `length`"]),
        (rail, "vehicle = \"lamprea2022_axle\"\ncount = 0", &["train.count", "between 1 and 1000"]),
        (rail, &train("{ position = 2900.0, load = 150e3 }"), &["train.axles", "2900 m", "metres"]),
        (rail, &train("{ position = 2.9, load = 1e300 }"), &["train.axles", "newtons"]),
    ];
    let faults: Vec<String> =
        cases.iter().filter_map(|(from, to, says)| refused(from, to, says).err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A foundation has the keys of its kind, and no other.
#[test]
fn foundations_have_the_keys_of_their_kind() {
    let springs = |foundation: &str| {
        format!(
            "title = \"x\"\n[track]\nkind = \"beam\"\nbeam.bending_stiffness = 1e7\nbeam.mass = 120.0\n\
             [foundation]\n{foundation}\n[receptance]\nfrequencies = [10.0]\n"
        )
    };
    for foundation in [
        "kind = \"winkler\"\nstiffness = 1e8",
        "kind = \"filonenko-borodich\"\nstiffness = 1e8\ntension = 2e7",
        "kind = \"hetenyi\"\nstiffness = 1e8\nbending_stiffness = 1.5e6\nloss_factor = 0.1",
        "kind = \"pasternak\"\nstiffness = 1e8\nshear = 2e7\ndamping = 1e5",
        "kind = \"kerr\"\nstiffness = 1e8\nshear = 2e7\nupper_stiffness = 5e8",
    ] {
        let (folder, _) = folder_with(&springs(foundation));
        let check = groundwave(&["check", "case.toml"], folder.path());
        assert_eq!(code(&check), 0, "{foundation}: {}", err(&check));
    }
    let faults: Vec<String> = [
        refused_case(
            &springs("kind = \"winkler\"\nstiffness = 1e8\nshear = 2e7"),
            &["case.toml:9", "foundation.shear", "unknown key `shear`", "winkler"],
        ),
        refused_case(
            &springs("kind = \"pasternak\"\nstiffness = 1e8"),
            &["case.toml:6", "foundation", "missing key `shear`", "pasternak"],
        ),
        refused_case(
            &springs("kind = \"pasternak\"\nstiffness = 1e8\nshear = \"2e7\""),
            &["case.toml:9", "foundation.shear", "the text \"2e7\"", "a number"],
        ),
        refused_case(
            &springs("kind = \"pasternack\"\nstiffness = 1e8\nshear = 2e7"),
            &["case.toml:7", "foundation.kind", "did you mean `pasternak`?", "kerr"],
        ),
        refused_case(
            &springs("kind = \"kerr\"\nstiffness = 1e8\nshear = -2e7\nupper_stiffness = 5e8"),
            &["case.toml:9", "foundation.shear", "-20000000 N", "not negative"],
        ),
        refused_case(
            &springs("kind = \"kerr\"\nstiffness = 1e8\nshear = 2e7\nupper_stiffness = 0"),
            &["case.toml:10", "foundation.upper_stiffness", "above zero"],
        ),
    ]
    .into_iter()
    .filter_map(Result::err)
    .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// So has a track, and its ballast.
#[test]
fn tracks_have_the_keys_of_their_kind() {
    let track = |track: &str| {
        format!(
            "title = \"x\"\nsoil = \"lamprea2022_layered\"\n[receptance]\nfrequencies = [10.0]\n[track]\n{track}\n"
        )
    };
    let contact = "contact = { half_width = 1.25, compatibility = \"mean\" }";
    let beam = "beam = { bending_stiffness = 1e7, mass = 120.0 }";
    let ballasted = |ballast: &str| {
        track(&format!(
            "kind = \"ballasted\"\n{contact}\nrail = {{ bending_stiffness = 1.28e7, mass = 120.0 }}\n\
             pad.stiffness = 7e8\nsleeper.mass = 490.0\n[track.ballast]\n{ballast}"
        ))
    };
    let bars = "kind = \"bars\"\nyoung = 1.4e8\nheight = 0.35\nalpha = 0.5";
    let faults: Vec<String> = [
        refused_case(
            &track(&format!("kind = \"beam\"\n{contact}\n{beam}\nsleeper.mass = 490.0")),
            &["case.toml:9", "track.sleeper", "unknown key `sleeper`", "beam"],
        ),
        refused_case(
            &track(&format!("kind = \"slap\"\n{contact}")),
            &["case.toml:6", "track.kind", "did you mean `slab`?"],
        ),
        refused_case(
            &track(&format!("kind = \"beam\"\n{contact}\nbeam.mass = 120.0")),
            &["case.toml:8", "track.beam", "missing key `bending_stiffness`"],
        ),
        refused_case(
            &track(&format!("kind = \"beam\"\n{contact}\nbeam.mass = 120.0\nbeam.bending_stiffness = 0")),
            &["case.toml:9", "track.beam.bending_stiffness", "above zero"],
        ),
        refused_case(&track("kind = \"none\""), &["case.toml:5", "track", "needs `load`"]),
        refused_case(
            &track(&format!("kind = \"none\"\nload.kind = \"point\"\n{contact}")),
            &["case.toml:8", "track.contact", "both given"],
        ),
        refused_case(
            &track(&format!("kind = \"beam\"\n{contact}\nload.kind = \"point\"\n{beam}")),
            &["case.toml:8", "track.load", "kind = \"none\" has a `load`"],
        ),
        refused_case(
            &ballasted(&format!("{bars}\nmass = 1700.0\nwave_speed = 333.0")),
            &["case.toml:16", "track.ballast.mass", "unknown key `mass`", "bars"],
        ),
        refused_case(
            &ballasted(bars),
            &["case.toml:11", "track.ballast", "wave speed of the ballast is missing"],
        ),
        refused_case(
            &ballasted(&format!("{bars}\nwave_speed = 333.0\ndensity = 1700.0")),
            &["case.toml:16", "track.ballast.wave_speed", "given twice"],
        ),
        refused_case(
            &ballasted(&format!("{bars}\ndensity = 1700.0\npoisson = 0.5")),
            &["case.toml:17", "track.ballast.poisson", "0.5"],
        ),
        refused_case(
            &ballasted(&format!("{bars}\nwave_speed = [333.0]")),
            &["case.toml:16", "track.ballast.wave_speed", "a list", "a number"],
        ),
        refused_case(
            &ballasted(&format!("{bars}\nwave_speed = 333.0")).replace("mass = 490.0", "mass = -490.0"),
            &["case.toml:10", "track.sleeper.mass", "not negative"],
        ),
    ]
    .into_iter()
    .filter_map(Result::err)
    .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The schema forbids what a kind does not have.
#[test]
fn the_schema_knows_kinds() {
    let folder = tempfile::tempdir().unwrap();
    let schema = groundwave(&["schema"], folder.path());
    let schema: serde_json::Value = serde_json::from_slice(&schema.stdout).unwrap();
    let kinds = |family: &str| {
        let rows = schema["$defs"][family]["oneOf"].as_array().unwrap();
        let row = |row: &serde_json::Value| {
            let keys: Vec<String> = row["properties"].as_object().unwrap().keys().cloned().collect();
            (row["properties"]["kind"]["const"].as_str().unwrap().to_owned(), keys.join(" "))
        };
        rows.iter().map(row).collect::<Vec<_>>()
    };
    let has = |family: &str, kind: &str, keys: &str| {
        assert!(kinds(family).contains(&(kind.into(), keys.into())), "{family}: {:?}", kinds(family));
    };
    has("FoundationModel", "winkler", "damping element kind loss_factor stiffness");
    has("FoundationModel", "pasternak", "damping element kind loss_factor shear stiffness");
    has("FoundationModel", "rigid", "kind");
    has("Ballast", "block", "damping element kind link loss_factor mass stiffness");
    has("SpringElement", "zener", "damping kind second_stiffness stiffness");
    has("Ballast", "consistent-mass", "damping kind loss_factor mass stiffness");
    // keys of the track that are no kind's own stand beside the kinds
    has("TrackInput", "slab", "kind load mat pad rail rails slab");
    has("TrackInput", "none", "kind");
    assert_eq!(schema["$defs"]["TrackInput"]["unevaluatedProperties"], false);
    assert_eq!(schema["$defs"]["TrackInput"]["oneOf"][1]["properties"]["load"], false);
    assert_eq!(schema["$defs"]["FoundationModel"]["oneOf"][0]["additionalProperties"], false);
    assert_eq!(schema["$defs"]["Ballast"]["oneOf"][0]["additionalProperties"], false);
}

/// A number out of its range is named as the file spells it, with the value that stands there.
#[test]
fn out_of_range_is_refused_at_its_own_key() {
    let layer = "loss_factor = 0.06";
    let beam = "mass = 2000.0";
    let springs = |more: &str| {
        format!(
            "title = \"x\"\n[track]\nkind = \"beam\"\nbeam.bending_stiffness = 1e8\nbeam.mass = 2e3\n\
             [foundation]\nkind = \"winkler\"\n{more}\n[receptance]\nfrequencies = [10.0]\n"
        )
    };
    let wheels =
        "axles = [{ position = 0.0, load = 150e3 }]\nunsprung_mass = 1800.0\nwheel_rail.radius = 0.46";
    let free_field = "[irregularity]\nkind = \"out-of-round\"\nradius = 0.46\n\
                      orders = [{ order = 1, amplitude = 1e-4, phase = nan }]\n\
                      [free_field]\nspeed = 60.0\nreceivers = [8.0]";
    let rough = CASE
        .replace("axles = [{ position = 0.0, load = 150e3 }]", wheels)
        .replace("[track_response]\nspeeds = [50.0, \"250 km/h\"]", free_field);
    let faults: Vec<String> = [
        // it was called the loss factor, -0.06
        refused(
            layer,
            "damping_ratio = -0.03",
            &["case.toml:9", "layer[0].damping_ratio", "damping_ratio is -0.03:"],
        ),
        refused(
            layer,
            "loss_factor = 0.06\nloss_factor_pressure = -1",
            &["case.toml:10", "loss_factor_pressure is -1:"],
        ),
        refused(
            beam,
            "mass = 2000.0\nbeam.loss_factor = -1",
            &["case.toml:19", "track.beam.loss_factor", "is -1:"],
        ),
        refused("half_width = ", "half_width = -", &["contact.half_width: half_width is -", "above zero"]),
        refused_case(
            &springs("stiffness = 0.0"),
            &["case.toml:8", "foundation.stiffness", "0 N/m²", "above zero"],
        ),
        refused_case(
            &springs("stiffness = 1e8\ndamping = -1"),
            &["case.toml:9", "foundation.damping", "-1 N s/m²"],
        ),
        refused_case(
            &springs("stiffness = 1e8\nloss_factor = nan"),
            &["case.toml:9", "foundation.loss_factor", "NaN"],
        ),
        // it was said of all orders
        refused_case(&rough, &["irregularity.orders[0].phase", "phase is NaN rad"]),
    ]
    .into_iter()
    .filter_map(Result::err)
    .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn axles_repeat_by_count_and_length() {
    let rail = "axles = [{ position = 0.0, load = 150e3 }]";
    let written = "axles = [{ position = 0.0, load = 150e3 }, { position = 20.0, load = 150e3 }]";
    let summary = |train: &str| {
        let (folder, _) = folder_with(&CASE.replace(rail, train));
        let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
        assert_eq!(code(&output), 0, "{}", err(&output));
        std::fs::read_to_string(folder.path().join("out/summary.json")).unwrap()
    };
    assert_eq!(summary(&format!("{rail}\ncount = 2\nlength = 20.0")), summary(written));
}

/// An ICE 3 on two bogies, at the top of `[train]`.
const BOGIES: &str = r#"model = "ten"
body = { mass = 47800.0, pitch_inertia = 1.957888e6, bogie_centres = 17.375 }
bogie = { mass = 3500.0, pitch_inertia = 1715.0, wheelbase = 2.5 }
wheelset.mass = 1800.0
primary = { stiffness = 2.4e6, damping = 20e3 }
secondary = { stiffness = 0.7e6, damping = 40e3 }"#;

#[test]
fn vehicles_on_two_bogies_are_refused_at_their_key() {
    let rail = "axles = [{ position = 0.0, load = 150e3 }]";
    let changed = |from: &str, to: &str| {
        assert!(BOGIES.contains(from), "{from}");
        BOGIES.replacen(from, to, 1)
    };
    let vehicle = |more: &str| format!("vehicle = \"goicolea2014_ice3\"\n{more}");
    let cases: [(String, &[&str]); 14] = [
        (changed("47800.0", "-47800.0"), &["train.body.mass", "body.mass is -47800 kg", "above zero"]),
        (changed("20e3", "-20e3"), &["train.primary.damping", "-20000 N s/m", "not negative"]),
        (changed("wheelbase = 2.5", "wheelbase = 25.0"), &["train.bogie.wheelbase", "25 m", "17.375 m"]),
        (changed("wheelset.mass = 1800.0", ""), &["train.body", "also needs wheelset"]),
        (changed("model = \"ten\"", ""), &["train", "missing key `model`", "\"unsprung\""]),
        (changed("\"ten\"", "\"tem\""), &["train.model", "\"tem\"", "did you mean `ten`?"]),
        (changed("pitch_inertia = 1715.0", "pitch = 1715.0"), &["unknown key `pitch`", "pitch_inertia"]),
        (format!("{BOGIES}\n{rail}"), &["train.axles", "brings its own", "remove axles"]),
        (format!("{BOGIES}\ncount = 8"), &["train.count", "no `length`"]),
        (format!("{BOGIES}\ncount = 8\nlength = 19.0"), &["train.length", "19 m", "19.875 m apart"]),
        (format!("model = \"four\"\n{rail}"), &["train.model", "\"four\" needs body, bogie, wheelset"]),
        (format!("model = \"unsprung\"\n{rail}"), &["train.model", "needs unsprung_mass"]),
        (vehicle("unsprung_mass = 1800.0"), &["train.unsprung_mass", "\"ten\"", "wheelset.mass"]),
        (vehicle("wheel_rail.radius = -0.46"), &["train.wheel_rail.radius", "-0.46 m", "above zero"]),
    ];
    let faults: Vec<String> = cases.iter().filter_map(|(to, says)| refused(rail, to, says).err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Results of a case by key, less what is text.
fn numbers(train: &str, studies: &str) -> serde_json::Value {
    let asked = "[track_response]\nspeeds = [50.0, \"250 km/h\"]\n";
    let rail = "axles = [{ position = 0.0, load = 150e3 }]";
    assert!(CASE.contains(asked) && CASE.contains(rail));
    let (folder, _) = folder_with(&CASE.replace(rail, train).replace(asked, studies));
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    assert_eq!(code(&output), 0, "{}", err(&output));
    serde_json::from_str(&std::fs::read_to_string(folder.path().join("out/summary.json")).unwrap()).unwrap()
}

const FREE_FIELD: &str = r#"[irregularity]
kind = "german"
quality = "low"
wavelengths = { from = 3.0, to = 30.0 }
[free_field]
speed = 60.0
receivers = [8.0]
frequencies = { from = 5.0, to = 16.0 }
"#;

#[test]
fn models_share_loads_and_differ_on_a_rough_rail() {
    let of = |more: &str| {
        let train = format!("vehicle = \"goicolea2014_ice3\"\nwheel_rail.radius = 0.46\n{more}");
        numbers(&train, FREE_FIELD)["free_field"]["v_rms_8"].as_f64().unwrap()
    };
    let (ten, unsprung) = (of(""), of("model = \"unsprung\""));
    // the bogies at and above their bounce on the primary suspension at 8 Hz; size not asserted closer than this
    assert!((unsprung / ten - 1.0).abs() > 0.005, "{ten} {unsprung}");
    assert!((unsprung / ten - 1.0).abs() < 0.3, "{ten} {unsprung}");
    // front and rear alike: the same wheels either way
    assert!((of("reversed = true") / ten - 1.0).abs() < 1e-6);

    // the loads are those of axles written out: 62 000 kg · 9.81/4
    let response = "[track_response]\nspeeds = [50.0]\n";
    let written = "axles = [{ position = 0.0, load = 152055.0 }, { position = 2.5, load = 152055.0 }, \
                   { position = 17.375, load = 152055.0 }, { position = 19.875, load = 152055.0 }]";
    let axles = numbers(written, response);
    for model in ["", "model = \"unsprung\"", "model = \"four\""] {
        let vehicle = numbers(&format!("vehicle = \"goicolea2014_ice3\"\n{model}"), response);
        assert_eq!(vehicle["track_response"], axles["track_response"], "{model}");
    }
}

#[test]
fn bad_files_and_folders_are_refused() {
    let (folder, _) = folder_with(&CASE);
    let here = folder.path();
    std::fs::write(here.join("garbage.toml"), [0u8, 159, 146, 150, 255, 1, 2]).unwrap();
    std::fs::write(here.join("garbage.h5"), [0u8, 159, 146, 150, 255, 1, 2]).unwrap();
    std::fs::write(here.join("a_file"), "x").unwrap();
    std::fs::create_dir(here.join("a_folder")).unwrap();
    let before = names_in(here);
    for (arguments, says) in [
        (&["run", "missing.toml"][..], "missing.toml"),
        (&["run", "a_folder"], "folder"),
        (&["run", "garbage.toml"], "garbage.toml"),
        (&["run", "garbage.h5"], "garbage.h5"),
        (&["run", "case.toml", "--out", "a_file/out"], "a_file"),
        (&["run", "case.toml", "--out", "a_folder"], "--overwrite"),
        (&["run", "case.toml", "--out", "a_file"], "a_file"),
        (&["run", "case.toml", "--threads", "0"], "threads"),
        (&["run"], "CASE"),
        (&["rum", "case.toml"], "run"),
        (&["list", "soil"], "soils"),
        (&["new", "case.toml"], "case.toml"),
    ] {
        let output = groundwave(arguments, here);
        assert_eq!(code(&output), 2, "{arguments:?}: {}", err(&output));
        assert!(flat(&output.stderr).contains(says), "{arguments:?}: {}", err(&output));
        assert!(!err(&output).contains("panicked"), "{arguments:?}");
        assert_eq!(names_in(here), before, "{arguments:?}");
        assert_eq!(names_in(&here.join("a_folder")).len(), 0, "{arguments:?}");
    }
}

#[test]
fn check_list_and_schema() {
    let (folder, _) = folder_with(&CASE);
    let check = groundwave(&["check", "case.toml"], folder.path());
    assert_eq!(code(&check), 0, "{}", err(&check));
    let told = String::from_utf8_lossy(&check.stdout).into_owned();
    assert!(
        told.contains("track_response") && told.contains("\nTime: ") && told.contains(" thread"),
        "{told}"
    );
    let list = groundwave(&["list", "soils"], folder.path());
    let text = String::from_utf8_lossy(&list.stdout).into_owned();
    assert!(code(&list) == 0 && text.contains("kaynia2000_ledsgard_high_speed") && !text.contains("x2000"));
    let schema = groundwave(&["schema"], folder.path());
    let schema: serde_json::Value = serde_json::from_slice(&schema.stdout).unwrap();
    for key in ["title", "soil", "track", "train", "critical_speed", "contour"] {
        assert!(schema["properties"].get(key).is_some(), "{key}");
    }
    for key in ["half_space", "loss_factor", "half_width", "axles", "spacing"] {
        assert!(schema["$defs"].to_string().contains(&format!("\"{key}\"")), "{key}");
    }
    for (table, kind, keys) in [
        ("SolversInput", "flexibility", vec!["kind"]),
        (
            "SolversInput",
            "thin-layer",
            vec!["accuracy", "element", "half_space", "kind", "sublayers_per_wavelength"],
        ),
        ("IrregularityInput", "sinusoidal", vec!["amplitude", "kind", "phase", "wavelength"]),
        ("IrregularityInput", "german", vec!["kind", "quality"]),
        ("IrregularityInput", "fra-corner", vec!["class", "kind"]),
    ] {
        assert_eq!(
            keys_of(&schema["$defs"][table], kind),
            Some(keys),
            "{table} {kind}: {}",
            schema["$defs"][table]
        );
    }
    assert_eq!(schema["$defs"]["SolversInput"]["unevaluatedProperties"], false);
    assert_eq!(names_in(folder.path()), ["case.toml"]);
}

/// Keys that a schema allows where `kind` is this one, besides those of the table it stands in.
fn keys_of<'a>(schema: &'a serde_json::Value, kind: &str) -> Option<Vec<&'a str>> {
    if schema["properties"]["kind"]["const"] == kind {
        return Some(schema["properties"].as_object()?.keys().map(String::as_str).collect());
    }
    let inner: Vec<&serde_json::Value> = match schema {
        serde_json::Value::Object(keys) => keys.values().collect(),
        serde_json::Value::Array(items) => items.iter().collect(),
        _ => return None,
    };
    inner.into_iter().find_map(|inner| keys_of(inner, kind))
}

#[test]
fn a_run_leaves_what_it_promises() {
    let (folder, _) = folder_with(&CASE);
    let here = folder.path();
    let run = |arguments: &[&str]| {
        let output = groundwave(arguments, here);
        assert_eq!(code(&output), 0, "{arguments:?}: {}", err(&output));
        output
    };
    let output = run(&["run", "case.toml", "--out", "a", "--threads", "1"]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("Largest downward rail deflection"));
    let names = names_in(&here.join("a"));
    for name in ["results.h5", "summary.json", "report.html"] {
        assert!(names.iter().any(|n| n == name), "{names:?}");
    }
    assert!(
        names.iter().any(|n| n.ends_with(".svg")) && names.iter().any(|n| n.ends_with(".png")),
        "{names:?}"
    );
    assert!(names.iter().any(|n| n.ends_with(".csv")), "{names:?}");
    let summary = |of: &str| std::fs::read(here.join(of).join("summary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&summary("a")).unwrap();
    assert!(json["track_response"]["max_down_50"].as_f64().unwrap() > 1e-4);
    // whatever the threads, and from the stored case
    run(&["run", "case.toml", "--out", "b", "--threads", "2"]);
    assert!(summary("a") == summary("b"));
    run(&["run", "a/results.h5", "--out", "c"]);
    assert!(summary("a") == summary("c"));
    // a second time only when told to
    assert_eq!(code(&groundwave(&["run", "case.toml", "--out", "a"], here)), 2);
    run(&["run", "case.toml", "--out", "a", "--overwrite"]);
    assert_eq!(names_in(&here.join("a")), names);
    assert_eq!(names_in(here), ["a", "b", "c", "case.toml"]);
}

#[test]
fn only_results_of_the_program_are_replaced() {
    let (folder, _) = folder_with(&CASE);
    let here = folder.path();
    let run = |from: &Path, arguments: &[&str], wanted: i32| {
        let output = groundwave(arguments, from);
        assert_eq!(code(&output), wanted, "{arguments:?}: {}", err(&output));
        flat(&output.stderr)
    };
    // a project with the case and a file of its own
    let project = here.join("p");
    std::fs::create_dir(&project).unwrap();
    std::fs::rename(here.join("case.toml"), project.join("B.toml")).unwrap();
    std::fs::write(project.join("m.csv"), "mine").unwrap();
    let said = run(here, &["run", "p/B.toml", "--out", "p", "--overwrite"], 2);
    assert!(said.contains("B.toml") && said.contains("m.csv"), "{said}");
    run(&project, &["run", "B.toml", "--out", ".", "--overwrite"], 2);
    run(&project, &["run", "B.toml", "--out", "../../", "--overwrite"], 2);
    run(&project, &["run", "B.toml", "--out", "../p/", "--overwrite"], 2);
    assert_eq!(names_in(&project), ["B.toml", "m.csv"]);
    // a folder of results, from inside itself
    run(&project, &["run", "B.toml", "--out", "out"], 0);
    let out = project.join("out");
    let names = names_in(&out);
    run(&out, &["run", "../B.toml", "--out", "../out", "--overwrite"], 0);
    assert_eq!(names_in(&out), names);
    assert_eq!(names_in(&project), ["B.toml", "m.csv", "out"]);
    // with a foreign file, a foreign folder, a manifest that is gone
    for name in ["notes.txt", "drawings"] {
        let foreign = out.join(name);
        if name == "drawings" { std::fs::create_dir(&foreign) } else { std::fs::write(&foreign, "mine") }
            .unwrap();
        let said = run(&project, &["run", "B.toml", "--out", "out", "--overwrite"], 2);
        assert!(said.contains(name), "{said}");
        assert!(foreign.exists());
        if name == "drawings" { std::fs::remove_dir(&foreign) } else { std::fs::remove_file(&foreign) }
            .unwrap();
    }
    std::fs::remove_file(out.join("manifest.json")).unwrap();
    run(&project, &["run", "B.toml", "--out", "out", "--overwrite"], 2);
    assert_eq!(names_in(&project), ["B.toml", "m.csv", "out"]);
    assert_eq!(names_in(&out).len(), names.len() - 1);
}

/// Every study but the contour, in a moment.
fn questions() -> String {
    let asked = "[critical_speed]\nspeeds = [40.0, 80.0, 120.0]\n[equivalent_stiffness]\nbeta = [0.2, 1.0]\n\
                 frequencies = [0.0, 20.0]\n[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [0.0, 20.0]\n";
    CASE.replace("[track_response]", &format!("{asked}[track_response]"))
}

#[test]
fn a_receptance_map_is_written_and_its_faults_are_named() {
    let asked = "[track_response]\nspeeds = [50.0, \"250 km/h\"]";
    let map = "[receptance]\nfrequencies = [20.0]\n[receptance.map]\nfrequencies = [12.5]\n\
               x = { from = -10.0, to = 10.0 }\ny = { from = 0.0, to = 6.0 }\nspacing = 1.0\n";
    let (folder, _) = folder_with(&CASE.replace(asked, map));
    let output = groundwave(&["run", "case.toml", "--out", "out", "--csv-maps", "--vti"], folder.path());
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("--csv-maps"));
    let out = folder.path().join("out");
    for picture in ["modulus", "real"] {
        let file = out.join(format!("receptance_map_{picture}_12.5.png"));
        assert!(file.metadata().unwrap().len() > 1000, "{picture}");
    }
    let table = std::fs::read_to_string(out.join("receptance_map_frequency_y_x.csv")).unwrap();
    let rows: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(rows[0], "map_frequency [Hz],y [m],x [m],map_re [m N-1],map_im [m N-1]");
    assert_eq!(rows.len(), 1 + 7 * 21);
    let grid = std::fs::read_to_string(out.join("receptance_map_re.vti")).unwrap();
    assert!(grid.contains("WholeExtent=\"0 20 0 6 0 0\"") && grid.contains("map_re_map_frequency_12.5"));
    assert!(std::fs::read_to_string(out.join("summary.json")).unwrap().contains("max_map_12.5"));
    // not asked for as a table, the map is in results.h5, and every reader is told so
    let output = groundwave(&["run", "case.toml", "--out", "short", "--no-pictures"], folder.path());
    assert_eq!(code(&output), 0, "{}", err(&output));
    let short = folder.path().join("short");
    assert!(!short.join("receptance_map_frequency_y_x.csv").exists());
    assert!(names_in(&short).iter().any(|name| name.ends_with(".csv")));
    assert!(!names_in(&short).iter().any(|name| name.ends_with(".vti")));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("receptance/map_re, receptance/map_im; as tables too with --csv-maps"), "{said}");
    let json = std::fs::read(short.join("summary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&json).unwrap();
    assert_eq!(json["maps_in_results_h5"], serde_json::json!(["receptance/map_re", "receptance/map_im"]));
    let report = std::fs::read_to_string(short.join("report.html")).unwrap();
    assert!(report.contains("<td>receptance/map_re</td><td>map_frequency (1) × y (7) × x (21)</td>"));
    let mut faults = Vec::new();
    for (from, to, says) in [
        ("[12.5]", "[0.0]", vec!["case.toml:", "receptance.map.frequencies[0]", "found 0 Hz", "above zero"]),
        ("[12.5]", "[12.5, 12.4]", vec!["receptance.map.frequencies[1]", "12.4 follows 12.5", "ascend"]),
        ("[12.5]", "[12.5, 12.501]", vec!["receptance.map.frequencies[1]", "twice, to 0.01 Hz"]),
        ("to = 10.0", "to = -10.0", vec!["receptance.map.x", "`to` must lie above `from`"]),
        ("to = 6.0", "to = 6e6", vec!["receptance.map.y", "farther than 10000 m"]),
        ("spacing = 1.0", "spacing = 0.0", vec!["receptance.map.spacing", "spacing is 0 m", "above zero"]),
        ("spacing = 1.0", "spacing = 8.0", vec!["receptance.map.spacing", "wider than the window of 6 m"]),
        ("spacing = 1.0", "spacing = 1e-9", vec!["receptance", "map grid", "GB", "larger spacing"]),
        ("spacing = 1.0", "spacng = 1.0", vec!["spacng", "did you mean `spacing`?"]),
        ("spacing = 1.0", "", vec!["receptance.map", "missing key `spacing`"]),
    ] {
        if let Err(fault) = refused(asked, &map.replace(from, to), &says) {
            faults.push(format!("{to}: {fault}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_second_solver_verifies() {
    let case = questions().replace("solver.kind = \"direct-stiffness\"", "solver.verify = \"flexibility\"");
    let (folder, _) = folder_with(&case);
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    assert_eq!(code(&output), 0, "{}", err(&output));
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(printed.matches("verified with flexibility: largest difference").count(), 4, "{printed}");
    assert!(!printed.contains("disagree") && !printed.contains("not-verified"), "{printed}");
    let out = folder.path().join("out");
    let summary: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
    let verification = &summary["verification"];
    assert_eq!(verification["solver"], "flexibility");
    // exact solvers; measured 1e-13: both take the same steps
    let largest = verification["largest"].as_f64().unwrap();
    assert!(largest > 0.0 && largest < 1e-5, "{largest:e}");
    let of = |study: &str, kind: &str, name: &str| verification[study][kind][name].as_f64().unwrap();
    for (study, kind, name) in [
        ("critical_speed", "datasets", "max_down"),
        ("critical_speed", "answers", "critical_speed"),
        ("track_response", "datasets", "rail"),
        ("equivalent_stiffness", "datasets", "k_eq"),
        ("surface_compliance", "datasets", "u_xz"),
    ] {
        assert!(of(study, kind, name) <= largest, "{study} {name}");
    }
    assert!(of("surface_compliance", "datasets", "u_zz") < 1e-13);
    let file = out.join("results.h5");
    let attribute = |name: &str| groundwave::output::hdf5::read_text_attribute(&file, name).unwrap();
    assert_eq!(attribute("solver"), "direct-stiffness");
    assert_eq!(attribute("verified_with"), "flexibility");
    assert!(attribute("verification_track_response").starts_with("largest difference "));
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(
        report.contains("<h2>Verification with flexibility</h2>") && report.contains("<td>max_down</td>")
    );
    assert!(report.contains("direct stiffness method"));
    // the stored case verifies again
    let again = groundwave(&["run", "out/results.h5", "--out", "again"], folder.path());
    assert_eq!(code(&again), 0, "{}", err(&again));
    let read = |of: &str| std::fs::read(folder.path().join(of).join("summary.json")).unwrap();
    assert!(read("out") == read("again"));
}

#[test]
fn every_solver_answers_every_study() {
    let mut speeds = Vec::new();
    for kind in ["direct-stiffness", "transfer-matrix", "flexibility"] {
        let contour = "[contour]\nspeeds = [50.0]\nx = { from = -4.0, to = 4.0 }\ny = { from = -4.0, to = 4.0 }\n\
                       spacing = 1.0\nclearance = 20.0\n[track_response]";
        let case = questions().replace("direct-stiffness", kind).replace("[track_response]", contour);
        let (folder, _) = folder_with(&case);
        let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
        assert_eq!(code(&output), 0, "{kind}: {}", err(&output));
        let out = folder.path().join("out");
        let summary: serde_json::Value =
            serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
        assert!(summary.get("verification").is_none());
        speeds.push(summary["critical_speed"]["critical_speed"].as_f64().unwrap());
        let solver =
            groundwave::output::hdf5::read_text_attribute(&out.join("results.h5"), "solver").unwrap();
        assert_eq!(solver, kind);
        let report = std::fs::read_to_string(out.join("report.html")).unwrap();
        assert_eq!(report.contains("by the direct stiffness method"), kind == "direct-stiffness");
    }
    // measured 0 to the last digits; the maximum is refined to 0.1 m/s
    assert!(speeds.iter().all(|v| (v - speeds[0]).abs() < 0.1), "{speeds:?}");
}

#[test]
fn the_template_runs() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&groundwave(&["new", "mine.toml"], folder.path())), 0);
    assert_eq!(code(&groundwave(&["check", "mine.toml"], folder.path())), 0);
    // the whole curve and map take longer than a test may
    let path = folder.path().join("mine.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let short = text
        .replace("{ from = \"50 km/h\", to = \"700 km/h\", step = \"10 km/h\" }", "[100.0, 137.0, 170.0]")
        .replace("{ from = -40.0, to = 20.0 }", "{ from = -4.0, to = 4.0 }")
        .replace("{ from = -30.0, to = 30.0 }", "{ from = -4.0, to = 4.0 }")
        .replace("spacing = 0.5", "spacing = 1.0\nclearance = 20.0");
    assert!(short.len() < text.len());
    std::fs::write(&path, short).unwrap();
    let run = groundwave(&["run", "mine.toml", "--out", "out"], folder.path());
    assert_eq!(code(&run), 0, "{}", err(&run));
    let summary: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("out/summary.json")).unwrap()).unwrap();
    assert!(summary["critical_speed"]["critical_speed"].as_f64().unwrap() > 90.0);
}

#[test]
fn dispersion_curves_stand_beside_the_full_answer() {
    let asked = "[track_response]\nspeeds = [50.0, \"250 km/h\"]";
    let run = |studies: &str| {
        let (folder, _) = folder_with(&CASE.replace(asked, studies));
        let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
        assert_eq!(code(&output), 0, "{}", err(&output));
        (folder, String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let frequencies = "[dispersion]\nfrequencies = { from = 5.0, to = 80.0, step = 5.0 }";
    let (folder, said) = run(&format!("[critical_speed]\nspeeds = [120.0, 150.0, 180.0]\n{frequencies}"));
    let out = folder.path().join("out");
    let summary: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
    let crossing = summary["dispersion"]["crossing_speed"].as_f64().unwrap();
    let critical = summary["critical_speed"]["critical_speed"].as_f64().unwrap();
    // measured 167.0 against 180.0 m/s, the end of the range
    assert!((crossing / critical - 1.0).abs() < 0.2, "{crossing} {critical}");
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    for text in ["Critical speed", "an estimate", &format!("{crossing:.1} m/s")] {
        assert!(said.contains(text) && report.contains(text), "{text}: {said}");
    }
    // what is not there is not a number, and told as not found
    let table = std::fs::read_to_string(out.join("dispersion_frequency_mode.csv")).unwrap();
    assert!(table.contains("\n5,0,1,") && table.contains("\n5,2,0,NaN,NaN,NaN,NaN\n"), "{table}");
    // waves across know no track; a single frequency has no map
    let (folder, _) = run("[dispersion]\nfrequencies = [40.0]\nmodes = 1\nwave = \"love\"");
    let names = names_in(&folder.path().join("out"));
    assert!(
        names.contains(&"group_velocity.png".to_owned()) && !names.contains(&"dispersion.png".to_owned())
    );
    // stiff ground over soft keeps no wave near the surface

    let case = CASE.replace("young = 200e6", "young = 5e6").replace(asked, frequencies);
    let (folder, _) = folder_with(&case);
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    assert!(String::from_utf8_lossy(&output.stdout).contains("no-trapped-mode"), "{}", err(&output));
}

#[test]
fn concerns_are_fatal_under_strict() {
    // the deflection still rises at the end of the range
    let case = CASE.replace(
        "[track_response]\nspeeds = [50.0, \"250 km/h\"]",
        "[critical_speed]\nspeeds = [20.0, 40.0, 60.0]",
    );
    let (folder, _) = folder_with(&case);
    let strict = groundwave(&["run", "case.toml", "--out", "out", "--strict"], folder.path());
    assert_eq!(code(&strict), 1, "{}", err(&strict));
    assert!(err(&strict).contains("maximum-at-end"), "{}", err(&strict));
    // the results are there all the same
    let lenient = groundwave(&["run", "case.toml", "--out", "lenient"], folder.path());
    assert_eq!(code(&lenient), 0);
    assert_eq!(names_in(&folder.path().join("out")), names_in(&folder.path().join("lenient")));
    assert!(String::from_utf8_lossy(&lenient.stdout).contains("maximum-at-end"));
    // and no picture calls the end of the range the critical speed
    let picture = std::fs::read_to_string(folder.path().join("lenient/critical_speed.svg")).unwrap();
    assert!(picture.contains("largest downward") && !picture.contains("critical speed"), "{picture}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing() {
    let speeds = "[critical_speed]\nspeeds = { from = 10.0, to = 200.0, step = 0.01 }";
    let (folder, _) = folder_with(&CASE.replace("[track_response]\nspeeds = [50.0, \"250 km/h\"]", speeds));
    let mut child = Command::new(env!("CARGO_BIN_EXE_groundwave"))
        .args(["run", "case.toml", "--out", "deep/out"])
        .current_dir(folder.path())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(500));
    assert!(child.try_wait().unwrap().is_none(), "the run was to be longer");
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", err(&output));
    assert_eq!(names_in(folder.path()), ["case.toml"]);
}
