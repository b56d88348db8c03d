//! Wrong input, and grounds that cannot be.

use crate::common::cli::{flat, groundwave};
use crate::{parsed, uncertain, wrong};
use groundwave::ensemble::{self, EnsembleError, Shard};
use groundwave::{Observer, Silent};

const SPEEDS: &str = "[100.0, 140.0, 180.0]";

/// The study with one piece of its text replaced.
fn with(old: &str, new: &str) -> String {
    let text = uncertain(SPEEDS, 30, "");
    assert!(text.contains(old), "{old}");
    text.replace(old, new)
}

#[test]
fn what_cannot_vary_is_refused_at_its_key() {
    for (old, new, words) in [
        (
            "layer[0].shear_speed",
            "layer[0].shear_sped",
            "study.vary[0].key: the case has no number at `soil.layer[0].shear_sped`; did you mean `soil.layer[0].",
        ),
        (
            "layer[0].shear_speed",
            "layer[7].shear_speed",
            "the case has no number at `soil.layer[7].shear_speed`",
        ),
        ("soil.layer.0.thickness", "track.beam.masss", "did you mean `track.beam.mass`?"),
        (
            "soil.layer.0.thickness",
            "soil.half_space.young",
            "study.vary[2].key: `soil.half_space.young` varies twice",
        ),
        (
            "\"150 MPa\"",
            "\"150 km/h\"",
            "study.vary[1].from: found \"150 km/h\", a speed, wanted a modulus in Pa",
        ),
        ("to = 250e6", "to = 100e6", "study.vary[1].to: 100000000 comes after 150000000"),
        (
            "sigma_ln = 0.2",
            "sigma_ln = -0.2",
            "study.vary[0].sigma_ln: sigma_ln is -0.2: it must be finite and not negative",
        ),
        (
            "sigma_ln = 0.2",
            "cov = 0.2",
            "study.vary[0]: a lognormal distribution has one centre and one width; give median and sigma_ln, or mean and cov",
        ),
        ("kind = \"uniform\"", "kind = \"unifrom\"", "did you mean `uniform`?"),
        ("samples = 30", "samples = 0", "study.samples: 0 samples: there must be at least 1"),
        ("samples = 30\n", "", "missing key `samples`"),
        ("samples = 30", "samples = 30\nmethod = \"grid\"", "study.samples: this method draws nothing"),
        ("mode = 2.0", "mode = 2.0\npoints = 4", "study.vary[2].points: points belong to a grid"),
        (
            "mode = 2.0",
            "mode = 2.0\nmin = 5.0",
            "study.vary[2]: the distribution has nothing between 5 and inf",
        ),
    ] {
        let said = wrong(&with(old, new));
        assert!(said.contains(words), "{new}: {said}");
    }
    let pair = |keys: &str, value: f64| {
        wrong(
            &(uncertain(SPEEDS, 30, "")
                + &format!("[[study.correlation]]\nkeys = {keys}\nvalue = {value}\n")),
        )
    };
    let both = "[\"soil.layer[0].thickness\", \"soil.layer[0].shear_speed\"]";
    assert!(
        pair(both, 1.5)
            .contains("study.correlation[0].value: value is 1.5: it must lie above -1 and below 1")
    );
    let other = pair("[\"soil.layer[0].thickness\", \"soil.layer[0].density\"]", 0.5);
    assert!(other.contains("study.correlation[0].keys[1]: `soil.layer[0].density` does not vary"), "{other}");
    assert!(pair("[\"soil.layer[0].thickness\"]", 0.5).contains("1 keys: a correlation is of two"));
}

#[test]
fn grounds_that_cannot_be_are_rows_with_their_reason() {
    // a third of the thicknesses lies below zero
    let text = with(
        "kind = \"triangular\"\nfrom = 1.0\nmode = 2.0\nto = 4.0",
        "kind = \"normal\"\nmean = 1.0\nstandard_deviation = 2.0",
    );
    let case = parsed(&text);
    let folder = tempfile::tempdir().unwrap();
    ensemble::run(&case, folder.path(), Shard::WHOLE, &Silent).unwrap();
    let (_, table) = ensemble::table(folder.path(), &Silent).unwrap();
    let below = table.values.iter().filter(|row| row[2] < 1e-3).count();
    assert!((5..15).contains(&below) && table.refused.len() == below, "{below} {}", table.refused.len());
    assert!(
        table.refused.iter().all(|(i, why)| table.values[*i][2] < 1e-3 && why.contains("thickness")),
        "{:?}",
        table.refused
    );
    assert_eq!(table.of("critical_speed.critical_speed").len(), 30 - below);
    let (_, summary) = ensemble::gather(folder.path(), false, &Silent).unwrap();
    let concern = summary.concerns.iter().find(|c| c.code == "refused-samples").unwrap();
    assert!(concern.message.starts_with(&format!("{below} of 30 samples have no answer")), "{concern}");
    let refused = summary.answers[0].1.iter().find(|answer| answer.key == "refused").unwrap();
    assert_eq!(refused.value, below as f64);
}

#[test]
fn folders_of_other_things_are_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let case = parsed(&uncertain(SPEEDS, 60, "derivatives = false"));
    let run = |case: &groundwave::Case, shard| ensemble::run(case, folder.path(), shard, &Silent);
    std::fs::write(folder.path().join("notes.txt"), "mine").unwrap();
    let foreign = run(&case, Shard::WHOLE).unwrap_err().to_string();
    assert!(foreign.contains("holds no study, but notes.txt"), "{foreign}");
    assert!(
        ensemble::gather(folder.path(), false, &Silent)
            .unwrap_err()
            .to_string()
            .contains("there is no study.json in it")
    );
    std::fs::remove_file(folder.path().join("notes.txt")).unwrap();

    run(&case, Shard::new(2, 3).unwrap()).unwrap();
    let incomplete = ensemble::gather(folder.path(), false, &Silent).unwrap_err().to_string();
    assert!(incomplete.contains("2 of 3 chunks lack: 0, 2"), "{incomplete}");

    let other = parsed(&uncertain(SPEEDS, 61, "derivatives = false"));
    let mixed = run(&other, Shard::WHOLE).unwrap_err().to_string();
    assert!(
        mixed.contains("holds another study")
            && mixed.contains("is `samples = 60`, of this one `samples = 61`"),
        "{mixed}"
    );

    // a chunk of another study
    run(&case, Shard::WHOLE).unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    ensemble::run(&other, elsewhere.path(), Shard::WHOLE, &Silent).unwrap();
    std::fs::copy(elsewhere.path().join("chunks/00001.json"), folder.path().join("chunks/00001.json"))
        .unwrap();
    let strange = ensemble::gather(folder.path(), false, &Silent).unwrap_err().to_string();
    assert!(strange.contains("00001.json holds another study"), "{strange}");
    // and half a one
    std::fs::write(folder.path().join("chunks/00001.json"), "{\"fingerprint\":").unwrap();
    let half = ensemble::gather(folder.path(), false, &Silent).unwrap_err().to_string();
    assert!(half.contains("remove it, and run its part of the study again"), "{half}");

    // another version of the program
    let study = std::fs::read_to_string(folder.path().join("study.json")).unwrap();
    let old =
        study.replace(&format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION")), "\"version\":\"0.0.1\"");
    assert_ne!(old, study);
    std::fs::write(folder.path().join("study.json"), old).unwrap();
    let version = run(&case, Shard::WHOLE).unwrap_err().to_string();
    assert!(version.contains("its version is 0.0.1, this one"), "{version}");
}

#[test]
fn a_call_to_stop_ends_a_study() {
    struct Stop;
    impl Observer for Stop {
        fn cancelled(&self) -> bool {
            true
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let case = parsed(&uncertain(SPEEDS, 30, ""));
    assert!(matches!(
        ensemble::run(&case, folder.path(), Shard::WHOLE, &Stop),
        Err(EnsembleError::Cancelled)
    ));
    assert!(crate::files(&folder.path().join("chunks")).is_empty());
}

#[test]
fn shards_and_cases_without_a_study_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("case.toml"), uncertain(SPEEDS, 30, "")).unwrap();
    let code = |arguments: &[&str]| {
        let output = groundwave(arguments, folder.path());
        (output.status.code().unwrap(), flat(&output.stderr))
    };
    let (exit, said) = code(&["study", "case.toml", "--shard", "4/3"]);
    assert!(exit == 2 && said.contains("shard 4/3: shards are counted from 1 to 3"), "{said}");
    let (exit, said) = code(&["study", "case.toml", "--shard", "two"]);
    assert!(exit == 2 && said.contains("wanted i/n, such as 2/5"), "{said}");
    let plain = uncertain(SPEEDS, 30, "").split("[study]").next().unwrap().to_owned();
    std::fs::write(folder.path().join("case.toml"), plain).unwrap();
    let (exit, said) = code(&["study", "case.toml"]);
    assert!(exit == 2 && said.contains("the case has no [study]"), "{said}");
    let (exit, said) = code(&["gather", "nowhere"]);
    assert!(exit == 2 && said.contains("nowhere holds no study: there is no such folder"), "{said}");
}
