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
    let folder = tempfile::tempdir().unwrap();
    let text = format!("title = \"t\"\n[soil]\nsolver.kind = \"thin-layer\"\n{LAYERS}\n{}", parts.concat());
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    (output.status.code().unwrap(), flat(&output.stdout), flat(&output.stderr), folder)
}

#[test]
fn a_free_field_leaves_what_it_promises() {
    let (code, out, err, folder) = run(&[TRACK, TRAIN, ROUGH, FIELD]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("R.m.s. velocity at 8 m") && out.contains("dB re 1e-9 m/s"), "{out}");
    let at = |name: &str| folder.path().join("out").join(name);
    let summary: Value = serde_json::from_slice(&std::fs::read(at("summary.json")).unwrap()).unwrap();
    assert!(summary.to_string().contains("v_rms_16"), "{summary}");
    for picture in
        ["free_field_8", "free_field_16", "free_field_receivers", "free_field_distance", "contact_force"]
    {
        for end in ["svg", "png"] {
            assert!(at(&format!("{picture}.{end}")).metadata().unwrap().len() > 1000, "{picture}.{end}");
        }
    }
    let report = std::fs::read_to_string(at("report.html")).unwrap();
    for said in ["expected value over all profiles", "per rad/m", "no coupling loss", "3 to 100 m"] {
        assert!(report.contains(said), "{said}");
    }
}

#[test]
fn without_roughness_there_is_the_quasi_static_part() {
    let (code, out, err, _folder) = run(&[TRACK, TRAIN, FIELD]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("dynamic 0.0000"), "{out}");
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
