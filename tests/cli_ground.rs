//! The command from outside: cases of the ground alone, and all that the other studies then lack.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use serde_json::Value;
use std::path::Path;

const COMPLIANCE: &str = "[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [0.0, 20.0]\n";
const DISPERSION: &str = "[dispersion]\nfrequencies = [5.0, 20.0, 40.0]\n";
const STIFFNESS: &str = "[equivalent_stiffness]\nbeta = [0.2, 1.0]\nfrequencies = [5.0, 20.0]\n";
const CONTACT: &str = "[track]\nkind = \"none\"\ncontact = { half_width = 1.25, compatibility = \"mean\" }\n";

/// Exit code and messages of a run into `out` beside the case.
fn run(text: &str, folder: &Path) -> (i32, String) {
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let output = groundwave(&["run", "case.toml", "--out", "out", "--overwrite"], folder);
    (output.status.code().expect("the command ends by itself"), flat(&output.stderr))
}

fn table(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join("out").join(name)).unwrap()
}

#[test]
fn the_ground_alone_needs_neither_track_nor_train() {
    let folder = tempfile::tempdir().unwrap();
    let (code, err) = run(&case(LAYERS, &format!("{COMPLIANCE}{DISPERSION}")), folder.path());
    assert_eq!(code, 0, "{err}");
    let alone = table(folder.path(), "surface_compliance.csv");
    let summary: Value = serde_json::from_str(&table(folder.path(), "summary.json")).unwrap();
    assert!(summary["concerns"].as_array().unwrap().is_empty(), "{summary}");
    let html = table(folder.path(), "report.html");
    assert!(html.contains("Horizontally layered") && !html.contains("presses on the ground"));
    // what lies on the ground does not change what it is
    let (code, err) = run(&case(LAYERS, &format!("{TRACK}{COMPLIANCE}{DISPERSION}")), folder.path());
    assert_eq!(code, 0, "{err}");
    assert_eq!(table(folder.path(), "surface_compliance.csv"), alone);
}

#[test]
fn equivalent_stiffness_needs_a_contact_only() {
    let folder = tempfile::tempdir().unwrap();
    let stiffness = || {
        let values = table(folder.path(), "equivalent_stiffness.csv");
        assert!(values.lines().count() > 4, "{values}");
        values
    };
    let (code, err) = run(&case(LAYERS, &format!("{CONTACT}{STIFFNESS}")), folder.path());
    assert_eq!(code, 0, "{err}");
    let alone = stiffness();
    // that of the track's own contact
    let contact = TRACK.lines().filter(|line| line.starts_with("contact.")).collect::<Vec<_>>().join("\n");
    let bare = format!("[track]\nkind = \"none\"\n{contact}\n");
    assert_eq!(run(&case(LAYERS, &format!("{bare}{STIFFNESS}")), folder.path()).0, 0);
    let bare = stiffness();
    assert_eq!(run(&case(LAYERS, &format!("{TRACK}{STIFFNESS}")), folder.path()).0, 0);
    assert_eq!(stiffness(), bare);
    // and of a patch as wide, as always
    let patch = "[track]\nkind = \"none\"\nload = { kind = \"patch\", half_length = 0.5, half_width = 1.25, compatibility = \"mean\" }\n";
    assert_eq!(run(&case(LAYERS, &format!("{patch}{STIFFNESS}")), folder.path()).0, 0);
    assert_eq!(stiffness(), alone);
}

#[test]
fn all_that_is_lacking_is_told_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |rest: &str, says: &[&str]| {
        let (code, err) = run(&case(LAYERS, rest), folder.path());
        assert_eq!(code, 2, "{rest}\n{err}");
        says.iter().for_each(|part| assert!(err.contains(part), "{part}: {err}"));
    };
    let speeds = "[critical_speed]\nspeeds = [100.0]\n";
    refused(speeds, &["it needs a track", "it needs a load", "critical_speed"]);
    refused(STIFFNESS, &["equivalent_stiffness", "kind = \"none\", contact.half_width"]);
    let both = format!("{speeds}{STIFFNESS}{COMPLIANCE}");
    refused(&both, &["it needs a track", "it needs a load", "it needs to know how the ground is loaded"]);
    // a strip without a track has no rail
    refused(&format!("{CONTACT}[receptance]\nfrequencies = [5.0]\n"), &["receptance", "it needs a track"]);
    let point = "[track]\nkind = \"none\"\nload.kind = \"point\"\n";
    refused(&format!("{point}{STIFFNESS}"), &["equivalent_stiffness", "no finite deflection"]);
    let twice = format!("{point}contact = {{ half_width = 1.25, compatibility = \"mean\" }}\n");
    refused(&format!("{twice}{STIFFNESS}"), &["track.contact", "load and contact are both given"]);
    refused(&format!("[track]\nkind = \"none\"\n{STIFFNESS}"), &["needs `load`", "without [track]"]);
}
