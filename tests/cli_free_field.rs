//! The command from outside: receptance and free field, and what they refuse.

mod common;

use common::cli::{LAYERS, flat, groundwave};
use serde_json::Value;

const TRACK: &str = "[track]\nkind = \"slab\"\nrail.bending_stiffness = 1.276e7\nrail.mass = 120.46\npad.stiffness = 7e8\n\
pad.damping = 3.84e4\nslab.bending_stiffness = 9.77e7\nslab.mass = 1250.0\ncontact.half_width = 1.25\n\
contact.compatibility = \"mean\"\n";
const TRAIN: &str = "[train]\naxles = [{ position = 0.0, load = 150e3 }, { position = 2.5, load = 120e3 }]\n\
unsprung_mass = 1800.0\nwheel_rail.radius = 0.46\n";
const ROUGH: &str =
    "[irregularity]\nkind = \"german\"\nquality = \"low\"\nwavelengths = { from = 3.0, to = 100.0 }\n";
const FIELD: &str = "[free_field]\nspeed = \"216 km/h\"\nreceivers = [8.0, 16.0]\n\
                     frequencies = { from = 2.0, to = 10.0 }\n";

fn run(parts: &[&str]) -> (i32, String, String, tempfile::TempDir) {
    run_beside("", parts)
}

/// With a file "rail.csv" beside the case.
fn run_beside(csv: &str, parts: &[&str]) -> (i32, String, String, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    if !csv.is_empty() {
        std::fs::write(folder.path().join("rail.csv"), csv).unwrap();
    }
    let text = format!("title = \"t\"\n[soil]\nsolver.kind = \"thin-layer\"\n{LAYERS}\n{}", parts.concat());
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    (output.status.code().unwrap(), flat(&output.stdout), flat(&output.stderr), folder)
}

#[test]
fn a_free_field_leaves_what_it_promises() {
    let (code, out, err, folder) = run(&[TRACK, TRAIN, ROUGH, FIELD]);
    assert_eq!(code, 0, "{err}");
    for said in
        ["R.m.s. velocity at 8 m", "dB re 1e-9 m/s", "KB_Fmax at 16 m", "in 10 profiles", "VdB re 2.54e-8"]
    {
        assert!(out.contains(said), "no \"{said}\" in: {out}");
    }
    let at = |name: &str| folder.path().join("out").join(name);
    let summary: Value = serde_json::from_slice(&std::fs::read(at("summary.json")).unwrap()).unwrap();
    assert!(summary.to_string().contains("v_rms_16"), "{summary}");
    for picture in [
        "free_field_8",
        "free_field_16",
        "free_field_receivers",
        "free_field_distance",
        "free_field_history_8",
        "free_field_history_16",
        "free_field_kb",
        "free_field_kb_distance",
        "free_field_level_distance",
        "free_field_vdv_distance",
        "contact_force",
    ] {
        for end in ["svg", "png"] {
            assert!(at(&format!("{picture}.{end}")).metadata().unwrap().len() > 1000, "{picture}.{end}");
        }
    }
    let report = std::fs::read_to_string(at("report.html")).unwrap();
    for said in [
        "expected value over all profiles",
        "per rad/m",
        "no coupling loss",
        "3 to 100 m",
        "10 of these profiles (seeds from 1)",
        "to compare, not to judge",
        "DIN 4150-2:1999, A_u residential, night: 0.1",
        "n like passes have n^¼ times the dose of one",
    ] {
        assert!(report.contains(said), "{said}");
    }
    // guide values are the dashed lines: KB has some, the dose of one pass none
    let drawn = |name: &str| std::fs::read_to_string(at(name)).unwrap().contains("stroke-dasharray");
    assert!(drawn("free_field_kb_distance.svg") && !drawn("free_field_vdv_distance.svg"));
}

#[test]
fn without_roughness_there_is_the_quasi_static_part() {
    let (code, out, err, _folder) = run(&[TRACK, TRAIN, FIELD]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("dynamic 0)"), "{out}");
}

/// Far from a slow axle next to nothing arrives in the bands: it is said, drawn beside its own scale, and ends no run.
#[test]
fn a_slow_axle_is_quiet_far_away() {
    let soil = "solver.kind = \"direct-stiffness\"\n[[soil.layer]]\nthickness = 4.234\nshear_speed = 173.6\npoisson = 0.22\n\
                density = 856.0\nloss_factor = 0.0216\n[soil.half_space]\nshear_speed = 238.5\npoisson = 0.48\n\
                density = 1548.0\nloss_factor = 0.0271\n";
    let rest = "[train]\naxles = [{ position = 0.0, load = 100e3 }]\n[free_field]\nspeed = 10.58\nreceivers = [3.65, 16.62]\n\
                frequencies = { from = 2.0, to = 50.0 }\n";
    let folder = tempfile::tempdir().unwrap();
    let text = format!("title = \"t\"\ntrack = \"lamprea2022_ballasted\"\n[soil]\n{soil}{rest}");
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    assert_eq!(output.status.code(), Some(0), "{}", flat(&output.stderr));
    let at = folder.path().join("out").join("summary.json");
    let summary: Value = serde_json::from_slice(&std::fs::read(at).unwrap()).unwrap();
    let rms = |y: &str| summary["free_field"][format!("v_rms_{y}")].as_f64().unwrap();
    // the history between the same frequencies: 6.272e-6 m/s; far away 2 Hz is e^{−16} of the load's own place
    assert!((rms("3.65") / 6.272e-6 - 1.0).abs() < 1e-3, "{}", rms("3.65"));
    assert!(0.0 < rms("16.62") && rms("16.62") < 1e-12, "{}", rms("16.62"));
}

/// Three waves over 200 m, every 0.5 m.
fn rail() -> String {
    let height = |x: f64| 1e-3 * ((0.5 * x).sin() + 0.5 * (1.1 * x).cos() + 0.2 * (2.3 * x).sin());
    (0..400)
        .map(|i| 0.5 * f64::from(i))
        .fold("x_m,r_m\n".into(), |csv, x| csv + &format!("{x},{:e}\n", height(x)))
}

const MEASURED: &str = "[irregularity]\nkind = \"measured\"\nfile = \"rail.csv\"\n\
                        wavelengths = { from = 2.0, to = 50.0 }\n";
const WAVE: &str = "[irregularity]\nkind = \"sinusoidal\"\nwavelength = 8.0\namplitude = 1e-3\n";
const WHEELS: &str =
    "[irregularity]\nkind = \"out-of-round\"\nradius = 0.46\norders = [{ order = 1, amplitude = 2e-4 }]\n";

#[test]
fn given_profiles_shake_the_ground() {
    let field = FIELD.replace("to = 10.0", "to = 31.5").replace("[8.0, 16.0]", "[8.0]");
    let rms = |profile: &str, csv: &str| -> f64 {
        let (code, _, err, folder) = run_beside(csv, &[TRACK, TRAIN, profile, &field]);
        assert_eq!(code, 0, "{err}");
        let at = folder.path().join("out").join("summary.json");
        let summary: Value = serde_json::from_slice(&std::fs::read(at).unwrap()).unwrap();
        summary["free_field"]["v_rms_8"].as_f64().unwrap()
    };
    let smooth = rms("", "");
    for (profile, csv) in [(MEASURED, rail()), (WAVE, String::new()), (WHEELS, String::new())] {
        let rough = rms(profile, &csv);
        assert!(rough > 1.01 * smooth, "{profile}: {rough:e} {smooth:e}");
    }
    // linear: the dynamic energy is a hundredfold, but for its product with the quasi-static part in the total; measured 98.9
    let dynamic = |amplitude: &str| rms(&WAVE.replace("1e-3", amplitude), "").powi(2) - smooth.powi(2);
    let ratio = dynamic("1e-2") / dynamic("1e-3");
    assert!((ratio / 100.0 - 1.0).abs() < 0.05, "{ratio}");
}

#[test]
fn a_profile_without_roughness_leaves_results_and_no_picture_of_forces() {
    let flat = (0..400).map(|i| format!("{},0.0\n", 0.5 * f64::from(i))).collect::<String>();
    let (code, out, err, folder) = run_beside(&format!("x_m,r_m\n{flat}"), &[TRACK, TRAIN, MEASURED, FIELD]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("no-picture: there is no picture `contact_force`"), "{out}");
    let at = |name: &str| folder.path().join("out").join(name);
    assert!(
        at("results.h5").exists() && at("free_field_8.png").exists() && !at("contact_force.png").exists()
    );
}

#[test]
fn bands_too_small_for_a_picture_are_gaps_in_its_curves() {
    // a short sinusoid drives few bands, far apart from those of the axle loads
    let field =
        FIELD.replace("from = 2.0, to = 10.0", "from = 1.0, to = 63.0").replace("216 km/h", "100 km/h");
    let wave = WAVE.replace("wavelength = 8.0", "wavelength = 0.7");
    let (code, _, err, folder) = run(&[TRACK, TRAIN, &wave, &field]);
    assert_eq!(code, 0, "{err}");
    let at = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let table = at("free_field_receiver_band.csv");
    let mut rows = table.lines().filter(|l| !l.starts_with('#')).map(|l| l.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let total = header.iter().position(|h| h.starts_with("v_rms_total")).unwrap();
    let values: Vec<f64> = rows.filter(|r| r[0] == "8").map(|r| r[total].parse().unwrap()).collect();
    let largest = values.iter().copied().fold(0.0, f64::max);
    let seen: Vec<bool> = values.iter().map(|v| *v > 1e-4 * largest).collect();
    let pieces = seen.split(|s| !s).filter(|run| !run.is_empty()).count();
    assert!(pieces > 1, "no gap to be seen: {values:?}");
    // the total is the third curve; each piece is one path, or a circle where it is one point; one more path is in the legend
    let svg = at("free_field_8.svg");
    // marks along it are thinner
    let curve =
        |l: &&str| (l.contains("<path") && l.contains("stroke-width=\"2.2\"")) || l.contains("<circle");
    let drawn = svg.lines().filter(curve).filter(|l| l.contains("#009e73"));
    assert_eq!(drawn.count(), pieces + 1, "{values:?}");
}

#[test]
fn faults_of_profiles_are_named_at_their_key() {
    let long = MEASURED.replace("to = 50.0", "to = 500.0");
    let beyond = format!("{MEASURED}abreast = 300.0\n");
    let unfit = format!("{MEASURED}class = 5\n");
    let bare = MEASURED.replace("file = \"rail.csv\"\n", "");
    let order = WHEELS.replace("order = 1", "order = 0");
    let flat = WAVE.replace("1e-3", "0.0");
    let bare_wave = WAVE.replace("amplitude = 1e-3\n", "");
    let none = format!("{ROUGH}profiles = 0\n");
    let text = WHEELS.replace("order = 1", "order = \"one\"");
    let family = |kind: &str| {
        format!("[irregularity]\nkind = \"{kind}\"\nwavelengths = {{ from = 3.0, to = 50.0 }}\n")
    };
    let (grade, grade_8) = (family("fra-corner") + "class = 7\n", family("fra-corner") + "class = 8.5\n");
    let road = family("iso8608") + "roughness = -1e-8\n";
    let misspelt = family("german") + "quality = \"low\"\nprofils = 3\n";
    let seeded = format!("{WAVE}seed = 3\n");
    let broken = rail().replace("3.5,", "3.4.5,");
    let whole = rail();
    for (csv, profile, says) in [
        (whole.as_str(), long.as_str(), vec!["irregularity.wavelengths.to", "500", "200 m long"]),
        (&whole, &beyond, vec!["irregularity.abreast", "300 m", "0 to 200 m"]),
        (&whole, &unfit, vec!["irregularity.class", "measured", "file, rail, abreast, wavelengths"]),
        (&whole, &bare, vec!["irregularity: missing key `file`, needed by kind = \"measured\""]),
        ("", MEASURED, vec!["irregularity.file", "rail.csv"]),
        (&broken, MEASURED, vec!["irregularity.file", "line 9", "3.4.5"]),
        ("", &order, vec!["irregularity.orders[0].order", "found 0"]),
        ("", &flat, vec!["irregularity.amplitude", "above zero"]),
        ("", &bare_wave, vec!["missing key `amplitude`, needed by kind = \"sinusoidal\""]),
        ("", &text, vec!["case.toml:", "irregularity.orders[0].order", "the text \"one\"", "a whole number"]),
        ("", &grade, vec!["case.toml:", "irregularity.class", "no class 7", "1 to 6"]),
        ("", &grade_8, vec!["irregularity.class", "the number 8.5", "a whole number from 0 to 255"]),
        ("", &road, vec!["irregularity.roughness", "-0.00000001 m³", "above zero"]),
        (
            "",
            &misspelt,
            vec!["irregularity.profils", "kind = \"german\"", "did you mean `profiles`?", "quality"],
        ),
        ("", &seeded, vec!["irregularity.seed", "of kind = \"sinusoidal\"", "wavelength, amplitude, phase"]),
        ("", "[irregularity]\nkind = \"low\"\n", vec!["irregularity.kind", "\"low\"", "german", "measured"]),
        ("", &none, vec!["irregularity.profiles", "between 1 and 1000"]),
    ] {
        let (code, out, err, folder) = run_beside(csv, &[TRACK, TRAIN, profile, FIELD]);
        assert_eq!(code, 2, "{says:?}: {out} {err}");
        for said in &says {
            assert!(err.contains(said), "no \"{said}\" in: {err}");
        }
        assert!(!folder.path().join("out").exists(), "{says:?}");
    }
}

#[test]
fn faults_are_named_at_their_key() {
    let bare = "[train]\naxles = [{ position = 0.0, load = 150e3 }]\n";
    let mass = "[train]\naxles = [{ position = 0.0, load = 150e3 }]\nunsprung_mass = 1800.0\n";
    let negative = TRAIN.replace("1800.0", "-1800.0");
    let both = TRAIN.replace("wheel_rail.radius = 0.46", "wheel_rail = { radius = 0.46, stiffness = 1e9 }");
    let class = ROUGH.replace("quality = \"low\"", "class = 5");
    let quality = ROUGH.replace("\"low\"", "\"lowest\"");
    let kind = ROUGH.replace("\"german\"", "\"germn\"");
    let short = ROUGH.replace("from = 3.0", "from = 0.001");
    let on_track = FIELD.replace("[8.0, 16.0]", "[1.0, 16.0]");
    let unsorted = FIELD.replace("[8.0, 16.0]", "[16.0, 8.0]");
    let none = FIELD.replace("[8.0, 16.0]", "[]");
    let still = FIELD.replace("\"216 km/h\"", "0.0");
    let bands = FIELD.replace("from = 2.0", "from = 20.0");
    let creeping = FIELD.replace("\"216 km/h\"", "0.1");
    let bare_ground = "[track]\nkind = \"none\"\nload = { kind = \"patch\", half_length = 0.5, half_width = 0.5, \
                       compatibility = \"mean\" }\n";
    let receptance = "[receptance]\nfrequencies = [0.0, 10.0]\n";
    for (parts, says) in [
        (vec![TRACK, bare, ROUGH, FIELD], vec!["train", "unsprung_mass"]),
        (vec![TRACK, mass, ROUGH, FIELD], vec!["unsprung_mass needs wheel_rail"]),
        (vec![TRACK, &negative, ROUGH, FIELD], vec!["train.unsprung_mass", "-1800"]),
        (vec![TRACK, &both, ROUGH, FIELD], vec!["train.wheel_rail", "stiffness stands alone"]),
        (vec![TRACK, TRAIN, &class, FIELD], vec!["irregularity.class", "quality"]),
        (vec![TRACK, TRAIN, &quality, FIELD], vec!["irregularity.quality", "lowest", "low, high"]),
        (vec![TRACK, TRAIN, &kind, FIELD], vec!["germn", "german"]),
        (vec![TRACK, TRAIN, &short, FIELD], vec!["irregularity.wavelengths.from", "0.001"]),
        (vec![TRACK, TRAIN, ROUGH, &on_track], vec!["free_field", "1 m stands on the track", "1.25 m"]),
        (vec![TRACK, TRAIN, ROUGH, &unsorted], vec!["free_field.receivers[1]", "ascend"]),
        (vec![TRACK, TRAIN, ROUGH, &none], vec!["free_field.receivers", "empty"]),
        (vec![TRACK, TRAIN, ROUGH, &still], vec!["free_field.speed", "above zero"]),
        (vec![TRACK, TRAIN, ROUGH, &bands], vec!["free_field.frequencies", "20"]),
        (vec![bare_ground, TRAIN, ROUGH, FIELD], vec!["free_field", "needs a track"]),
        (vec![TRACK, TRAIN, ROUGH, &creeping], vec!["free_field.speed", "at least 1 m/s"]),
        (vec![TRACK, TRAIN, ROUGH, receptance], vec!["receptance.frequencies", "above zero"]),
        (
            vec![TRACK, TRAIN, ROUGH, "[critical_speed]\nspeeds = [50.0]\n"],
            vec!["no study uses the roughness"],
        ),
    ] {
        let (code, out, err, folder) = run(&parts);
        assert_eq!(code, 2, "{says:?}: {out} {err}");
        for said in &says {
            assert!(err.contains(said), "no \"{said}\" in: {err}");
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "{says:?}");
    }
}

/// A wave of 5 mm over 2 m at 216 km/h throws the wheel off the rail, which the linear contact does not know.
#[test]
fn a_wheel_that_would_lift_is_told() {
    let steep = "[irregularity]\nkind = \"sinusoidal\"\nwavelength = 2.0\namplitude = 5e-3\n";
    let field = FIELD.replace("to = 10.0", "to = 40.0");
    let (code, out, err, _folder) = run(&[TRACK, TRAIN, steep, &field]);
    assert_eq!(code, 0, "{err}");
    for said in
        ["wheel-lifts", "the wheel would lift", "the linear contact then pulls", "static load is 1.500e2 kN"]
    {
        assert!(out.contains(said), "no \"{said}\" in: {out}");
    }
    let (_, out, _, _folder) = run(&[TRACK, TRAIN, WAVE, FIELD]);
    assert!(!out.contains("wheel-lifts"), "{out}");
}
