//! The command from outside, and the parts of a quick case.

use std::path::Path;
use std::process::{Command, Output};

/// Two metres of soft soil over a half-space.
pub const LAYERS: &str = r#"[[soil.layer]]
thickness = 2.0
young = 60e6
poisson = 0.35
density = 1500.0
loss_factor = 0.06
[soil.half_space]
young = 200e6
poisson = 0.35
density = 1800.0
loss_factor = 0.06
"#;

/// A beam and one axle.
pub const TRACK: &str = r#"[track]
kind = "beam"
beam.bending_stiffness = 1.0e8
beam.mass = 2000.0
contact.half_width = 1.25
contact.compatibility = "centre"
[train]
axles = [{ position = 0.0, load = 150e3 }]
"#;

/// A whole case: `[soil]` with the lines `soil`, then `rest`.
pub fn case(soil: &str, rest: &str) -> String {
    format!("title = \"A quick case\"\n[soil]\n{soil}{rest}")
}

/// The command with `arguments`, run in `folder`.
pub fn groundwave(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_groundwave")).args(arguments).current_dir(folder).output().unwrap()
}

/// The message on one line: a wrapped one reads the same.
pub fn flat(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace(|c| "│╰╭─┬▲·×".contains(c), " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
