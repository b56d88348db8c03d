//! `assess` and `compare` from outside.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use serde_json::Value;
use std::path::Path;

fn summary(folder: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

/// Numbers of a study in `summary.json`.
fn numbers(of: &Value, study: &str) -> Vec<(String, f64)> {
    let found = of[study].as_object().unwrap();
    found.iter().map(|(key, value)| (key.clone(), value.as_f64().unwrap())).collect()
}

#[test]
fn a_record_is_assessed_as_a_free_field_is() {
    let folder = tempfile::tempdir().unwrap();
    // 16 Hz under a bell of 1 mm/s: KB_Fmax just below the 0.680 that a settled sine ripples to
    let record = (0..5000).fold("# site 4\nt [s];v_z [mm/s]\n".to_owned(), |text, i| {
        let t = 0.002 * f64::from(i);
        text + &format!("{t:.3};{:.6}\n", (-(t - 5.0).powi(2)).exp() * (100.53 * t).sin()).replace('.', ",")
    });
    std::fs::write(folder.path().join("record.csv"), record).unwrap();
    let asked = ["assess", "record.csv", "--out", "out", "--day", "60", "--night", "8", "--no-pictures"];
    let output = groundwave(&asked, folder.path());
    assert_eq!(output.status.code(), Some(0), "{}", flat(&output.stderr));
    let found = summary(&folder.path().join("out"));
    let of = |key: &str| found["record"][key].as_f64().unwrap_or(f64::NAN);
    assert!((0.6..0.68).contains(&of("kb_f_maximum_v_z")), "{found}");
    // one interval of 30 s a pass: KB_FTr = KB_Fmax √(60 · 30/57600), √(8 · 30/28800)
    assert!((of("kb_ftr_day") / of("kb_f_maximum_v_z") - (1800.0f64 / 57600.0).sqrt()).abs() < 1e-12);
    assert!((of("kb_ftr_night") / of("kb_f_maximum_v_z") - (240.0f64 / 28800.0).sqrt()).abs() < 1e-12);
    assert!((of("vdv_day") / of("vdv_wb_v_z") - 60f64.powf(0.25)).abs() < 1e-12);
    for file in ["results.h5", "report.html", "record_direction_band.csv"] {
        assert!(folder.path().join("out").join(file).exists(), "{file}");
    }
    // a guide that is none, and a record with a gap
    let output = groundwave(&["assess", "record.csv", "--guide", "din4150-4"], folder.path());
    assert_eq!(output.status.code(), Some(2));
    assert!(flat(&output.stderr).contains("din4150-2"), "{}", flat(&output.stderr));
    let text = std::fs::read_to_string(folder.path().join("record.csv")).unwrap();
    let gap: String =
        text.lines().enumerate().filter(|(i, _)| *i != 99).map(|(_, l)| format!("{l}\n")).collect();
    std::fs::write(folder.path().join("gap.csv"), gap).unwrap();
    let output = groundwave(&["assess", "gap.csv", "--out", "gap"], folder.path());
    assert_eq!(output.status.code(), Some(2));
    assert!(
        flat(&output.stderr).contains("gap.csv: line 100 stands at t = 0.196 s"),
        "{}",
        flat(&output.stderr)
    );
    assert!(!folder.path().join("gap").exists());
}

#[test]
fn a_case_against_itself_is_nothing_and_a_change_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let asked = "[track_response]\nspeeds = [50.0]\n[free_field]\nspeed = 40.0\nreceivers = [8.0, 16.0]\nfrequencies = { from = 2.0, to = 20.0 }\n";
    let text = case(&format!("solver.kind = \"direct-stiffness\"\n{LAYERS}"), &format!("{TRACK}{asked}"));
    std::fs::write(folder.path().join("a.toml"), &text).unwrap();
    let run = groundwave(&["run", "a.toml", "--out", "a", "--no-pictures"], folder.path());
    assert_eq!(run.status.code(), Some(0), "{}", flat(&run.stderr));
    // the folder of a run, and the case computed again, against each other and themselves
    // nothing; read from JSON, whose numbers are read to rounding, and computed: measured 1.7e-21
    for (first, second, out, most) in [("a", "a", "one", 0.0), ("a", "a.toml", "two", 1e-15)] {
        let output = groundwave(&["compare", first, second, "--out", out, "--no-pictures"], folder.path());
        assert_eq!(output.status.code(), Some(0), "{}", flat(&output.stderr));
        let changes = numbers(&summary(&folder.path().join(out)), "comparison");
        assert!(changes.len() > 10 && changes.iter().all(|(_, change)| change.abs() <= most), "{changes:?}");
        assert!(changes.iter().any(|(key, _)| key == "insertion_loss_8"));
    }
    // twice the load, twice the velocity of a smooth rail: −6.02 dB
    let heavier = text.replace("load = 150e3", "load = 300e3");
    assert_ne!(heavier, text, "the load of the common case");
    std::fs::write(folder.path().join("b.toml"), heavier).unwrap();
    let output = groundwave(&["compare", "a", "b.toml", "--out", "three"], folder.path());
    assert_eq!(output.status.code(), Some(0), "{}", flat(&output.stderr));
    let changes = numbers(&summary(&folder.path().join("three")), "comparison");
    let loss = changes.iter().find(|(key, _)| key == "insertion_loss_16").unwrap().1;
    assert!((loss + 20.0 * 2f64.log10()).abs() < 1e-9, "{loss}");
    assert!(folder.path().join("three/insertion_loss.png").exists());
    let output = groundwave(&["compare", "a", "nothing", "--out", "four"], folder.path());
    assert_eq!(output.status.code(), Some(2));
}
