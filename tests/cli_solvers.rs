//! The command from outside: thin layers as solver and as witness, their settings, library soils with a solver.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use serde_json::Value;
use tempfile::TempDir;

const QUESTIONS: &str = "[critical_speed]\nspeeds = [100.0, 200.0, 300.0]\n[equivalent_stiffness]\nbeta = [0.2, 1.0]\n\
                         frequencies = [0.0, 20.0]\n[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [0.0, 20.0]\n";

struct Run {
    folder: TempDir,
    code: i32,
    out: String,
    err: String,
}

fn run(case: &str) -> Run {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("case.toml"), case).unwrap();
    let output = groundwave(&["run", "case.toml", "--out", "out"], folder.path());
    let code = output.status.code().expect("the command ends by itself");
    Run { folder, code, out: flat(&output.stdout), err: flat(&output.stderr) }
}

impl Run {
    fn summary(&self) -> Value {
        assert_eq!(self.code, 0, "{}", self.err);
        serde_json::from_slice(&std::fs::read(self.folder.path().join("out/summary.json")).unwrap()).unwrap()
    }

    /// True if nothing stands beside the case file.
    fn wrote_nothing(&self) -> bool {
        std::fs::read_dir(self.folder.path()).unwrap().count() == 1
    }
}

/// The case must be refused with code 2 and every one of `says`, and nothing written.
fn refused(soil: &str, says: &[&str]) {
    let run = run(&case(soil, &format!("{TRACK}{QUESTIONS}")));
    assert_eq!(run.code, 2, "{soil}: {}", run.err);
    assert!(run.wrote_nothing(), "{soil}");
    for said in says {
        assert!(run.err.contains(said), "no \"{said}\" in: {}", run.err);
    }
}

fn with_layers(solver: &str) -> String {
    format!("{solver}\n{LAYERS}")
}

#[test]
fn thin_layers_answer_every_question() {
    let critical = |kind: &str| {
        let soil = with_layers(&format!("solver.kind = \"{kind}\""));
        let run = run(&case(&soil, &format!("{TRACK}{QUESTIONS}")));
        let summary = run.summary();
        let file = run.folder.path().join("out/results.h5");
        assert_eq!(groundwave::output::hdf5::read_text_attribute(&file, "solver").unwrap(), kind);
        for study in ["critical_speed", "equivalent_stiffness", "surface_compliance"] {
            assert!(summary.get(study).is_some(), "{study} in {summary}");
        }
        summary["critical_speed"]["critical_speed"].as_f64().unwrap()
    };
    let (exact, thin) = (critical("direct-stiffness"), critical("thin-layer"));
    println!("{exact} {thin}");
    // the maximum is refined to 0.1 m/s
    assert!((thin - exact).abs() < 0.1, "{exact} {thin}");
}

#[test]
fn thin_layers_verify() {
    // below the critical speed; 1.7e-4 where the speeds reach to 300 m/s
    let slow = QUESTIONS.replace("[100.0, 200.0, 300.0]", "[40.0, 80.0, 120.0]");
    let run = run(&case(&with_layers("solver.verify = \"thin-layer\""), &format!("{TRACK}{slow}")));
    let summary = run.summary();
    assert_eq!(summary["verification"]["solver"], "thin-layer");
    let largest = summary["verification"]["largest"].as_f64().unwrap();
    println!("largest difference {largest:e}");
    // measured 3.6e-5 of the amplifications; 1.4e-4 of the speed at which they pass 1.2, on a chord that rises slowly
    let curves = &summary["verification"]["critical_speed"]["datasets"];
    let curve = curves["amplification"].as_f64().unwrap();
    println!("{}", summary["verification"]);
    assert!(largest > 0.0 && largest < 2e-4 && curve < 1e-4, "{largest:e} {curve:e}");
    assert_eq!(run.out.matches("verified with thin-layer: largest difference").count(), 3, "{}", run.out);
    assert!(!run.out.contains("disagree") && !run.out.contains("not-verified"), "{}", run.out);
}

#[test]
fn settings_out_of_reach_are_refused() {
    let solver = |settings: &str| with_layers(&format!("solver.kind = \"thin-layer\"\n{settings}"));
    refused(
        &solver("solver.sublayers_per_wavelength = 4.0\nsolver.element = \"cubic\"\nsolver.accuracy = 1e-6"),
        &[
            "case.toml:",
            "soil.solver.sublayers_per_wavelength",
            "4 sublayers",
            "accuracy of 1e-6",
            ": 8 would",
        ],
    );
    refused(
        &solver("solver.elment = \"cubic\""),
        &[
            "case.toml:",
            "soil.solver.elment",
            "of kind = \"thin-layer\"",
            "did you mean `element`?",
            "half_space, verify",
        ],
    );
    refused(
        &solver("solver.element = 3"),
        &["soil.solver.element", "the number 3", "linear, quadratic, cubic"],
    );
    refused(
        &with_layers("solver.verify = { kind = \"thin-layer\", accuracy = \"high\" }"),
        &["case.toml:", "soil.solver.verify.accuracy", "the text \"high\"", "wanted a plain number"],
    );
    refused(
        &with_layers("solver.accuracy = 1e-6"),
        &["soil.solver", "missing key `kind`", "direct-stiffness, transfer-matrix, flexibility"],
    );
    refused(&solver("solver.accuracy = 0.5"), &["soil.solver.accuracy", "0.5", "between 1e-9 and 0.1"]);
    refused(
        &with_layers("solver.kind = \"direct-stiffness\"\nsolver.element = \"cubic\""),
        &[
            "case.toml:",
            "soil.solver.element",
            "unknown key `element` of kind = \"direct-stiffness\"",
            "allowed: verify",
        ],
    );
}

#[test]
fn library_soils_take_a_solver() {
    let soil = "library = \"lamprea2022_layered\"\nsolver.kind = \"thin-layer\"\n";
    let surface = "[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [0.0, 20.0]\n";
    let run = run(&case(soil, &format!("{TRACK}{surface}")));
    let summary = run.summary();
    assert!(summary.get("surface_compliance").is_some(), "{summary}");
    let file = run.folder.path().join("out/results.h5");
    assert_eq!(groundwave::output::hdf5::read_text_attribute(&file, "solver").unwrap(), "thin-layer");
    let both = format!("{soil}{LAYERS}");
    refused(
        &both,
        &["soil.library", "a library soil and layers of its own are both given", "remove library"],
    );
    refused(
        "library = \"lamprea2022_layerd\"\n",
        &["soil.library", "no entry \"lamprea2022_layerd\"", "did you mean `lamprea2022_layered`?"],
    );
}

/// 60 m of clay at 200 Hz, 240 wavelengths: too many sublayers for modes, so every wavenumber is answered by itself.
#[test]
fn many_sublayers_are_answered_without_modes() {
    let clay = "solver.kind = \"thin-layer\"\nsolver.verify = \"direct-stiffness\"\n[[soil.layer]]\nthickness = 60.0\n\
                shear_speed = 50.0\npoisson = 0.49\ndensity = 1600.0\nloss_factor = 0.05\n[soil.half_space]\n\
                shear_speed = 300.0\npoisson = 0.3\ndensity = 2000.0\nloss_factor = 0.05\n";
    let surface = "[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [200.0]\n";
    let run = run(&case(clay, &format!("{TRACK}{surface}")));
    assert_eq!(run.code, 0, "{}", run.err);
    let largest = run.summary()["verification"]["largest"].as_f64().unwrap();
    println!("{largest:e}");
    assert!(largest < 1e-4, "{largest:e}");
}

/// Rock under 60 m of soft damped clay: at 30 Hz nothing comes back from it.
#[test]
fn rock_below_reach_is_a_concern() {
    let clay = "base = \"rigid\"\n[[soil.layer]]\nthickness = 60.0\nshear_speed = 50.0\npoisson = 0.49\n\
                density = 1600.0\nloss_factor = 0.05\n";
    let surface = "[surface_compliance]\nk = [0.1, 1.0]\nfrequencies = [FREQUENCY]\n";
    for (frequency, concerned) in [("2.0", false), ("30.0", true)] {
        let surface = surface.replace("FREQUENCY", frequency);
        let run = run(&case(clay, &format!("{TRACK}{surface}")));
        assert_eq!(run.code, 0, "{}", run.err);
        assert_eq!(run.summary()["concerns"].to_string().contains("deep-rock"), concerned, "{frequency}");
    }
}
