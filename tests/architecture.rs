//! The rules of the house, read from the source: ranks, dependencies, printing, panics, length of files, case folders.

use groundwave::case::library::ENTRIES;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// DESIGN 3: a file uses only modules of lower rank, or its own folder.
const RANKS: &[&[&str]] = &[
    &["math", "quantity"],
    &["soil", "track", "vehicle", "irregularity", "signal", "dataset", "concern", "figure", "progress"],
    &["foundation", "assessment", "output"],
    &["rail"],
    &["field", "contact"],
    &["study"],
    &["case"],
    &["cli", "main", "lib"],
];

/// Heavy dependencies and the files or folders they may be named in.
const BEHIND: &[(&str, &[&str])] = &[
    ("hdf5", &["output/hdf5.rs", "output/error.rs"]),
    ("kuva", &["output/"]),
    ("rustfft", &["math/fourier.rs"]),
    ("realfft", &["math/fourier.rs"]),
    ("png", &["output/"]),
    ("miette", &["case/error.rs", "cli/"]),
    ("clap", &["cli/"]),
    ("indicatif", &["cli/progress.rs"]),
    ("ctrlc", &["cli/run.rs"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files_in(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_in(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Every source file: its path below src, its text, and its code without comments and without what follows `#[cfg(test)]`.
fn sources() -> Vec<(String, String, String)> {
    let mut paths = Vec::new();
    files_in(&root().join("src"), &mut paths);
    paths.sort();
    assert!(paths.len() > 50, "the sources were not found");
    let below = root().join("src");
    paths
        .into_iter()
        .map(|path| {
            let text = std::fs::read_to_string(&path).unwrap();
            let name = path.strip_prefix(&below).unwrap().to_str().unwrap().replace('\\', "/");
            let code = code_of(&text);
            (name, text, code)
        })
        .collect()
}

/// The lines before the test module, less comments.
fn code_of(text: &str) -> String {
    text.lines()
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .map(|line| line.split("//").next().unwrap_or(""))
        .collect::<Vec<_>>()
        .join("\n")
}

fn module_of(file: &str) -> &str {
    file.split('/').next().unwrap().trim_end_matches(".rs")
}

fn rank(module: &str) -> Option<usize> {
    RANKS.iter().position(|modules| modules.contains(&module))
}

/// The modules named after `crate::` or `groundwave::`, groups in braces included.
fn modules_used(code: &str) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    for door in ["crate::", "groundwave::"] {
        for (at, _) in code.match_indices(door) {
            let rest = &code[at + door.len()..];
            if let Some(group) = rest.strip_prefix('{') {
                // the first word of each part of the group, inner braces skipped
                let (mut depth, mut word, mut fresh) = (0, String::new(), true);
                for c in group.chars() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => fresh = true,
                        c if depth == 0 && fresh && (c.is_alphanumeric() || c == '_') => word.push(c),
                        ':' | ' ' | '\n' if word.is_empty() => {}
                        _ if !word.is_empty() => {
                            used.insert(std::mem::take(&mut word));
                            fresh = false;
                        }
                        _ => {}
                    }
                }
                if !word.is_empty() {
                    used.insert(word);
                }
            } else {
                used.insert(rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
            }
        }
    }
    used
}

/// What breaks the order of ranks in one file.
fn rank_faults(file: &str, code: &str) -> Vec<String> {
    let own = module_of(file);
    let Some(own_rank) = rank(own) else { return vec![format!("{file}: {own} has no rank")] };
    let mut faults: Vec<String> = modules_used(code)
        .into_iter()
        .filter(|module| module != own)
        .filter(|module| rank(module).is_none_or(|rank| rank >= own_rank))
        .map(|module| format!("{file} uses {module}"))
        .collect();
    // the same step through the back door
    let depth = file.matches('/').count();
    if code.contains(&"super::".repeat(depth + 1)) {
        faults.push(format!("{file} leaves its folder by super::"));
    }
    faults
}

/// Names of `name::` or `::name` as a whole word.
fn names(code: &str, name: &str) -> bool {
    let word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    code.match_indices(name).any(|(at, _)| {
        let (before, after) = (&code[..at], &code[at + name.len()..]);
        let whole = !word(before.chars().last()) && !word(after.chars().next());
        // a path below crate:: or super:: is this crate's own module of that name
        let ours = ["crate::output::", "super::", "output::"].iter().any(|p| before.ends_with(p));
        whole && !ours && (after.starts_with("::") || before.ends_with("use "))
    })
}

#[test]
fn files_use_lower_ranks_only() {
    let faults: Vec<String> = sources().iter().flat_map(|(file, _, code)| rank_faults(file, code)).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn heavy_dependencies_stay_behind_their_files() {
    let mut faults = Vec::new();
    for (file, _, code) in sources() {
        // the runner and others name this crate's module output::hdf5 by the import `hdf5`
        let own_module = code.contains("crate::output::{") || code.contains("mod hdf5");
        for (name, allowed) in BEHIND {
            let allowed = allowed.iter().any(|a| file.starts_with(a)) || (*name == "hdf5" && own_module);
            if !allowed && names(&code, name) {
                faults.push(format!("{file} names {name}"));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn the_library_never_prints_nor_panics() {
    let mut faults = Vec::new();
    for (file, _, code) in sources() {
        if !file.starts_with("cli/") {
            for word in ["println!", "eprintln!", "print!(", "eprint!(", "dbg!"] {
                if code.contains(word) {
                    faults.push(format!("{file}: {word}"));
                }
            }
        }
        for word in [".unwrap()", ".expect(", "unsafe ", "todo!", "unimplemented!"] {
            if code.contains(word) {
                faults.push(format!("{file}: {word}"));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn long_files_say_why() {
    let faults: Vec<String> = sources()
        .iter()
        .filter(|(_, text, _)| text.lines().count() > 500)
        .filter(|(_, text, _)| {
            !text.lines().take_while(|l| l.starts_with("//!")).any(|l| l.contains("long because"))
        })
        .map(|(file, text, _)| format!("{file}: {} lines", text.lines().count()))
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn cases_are_complete() {
    let mut faults = Vec::new();
    for entry in std::fs::read_dir(root().join("soil_cases")).unwrap() {
        let folder = entry.unwrap().path();
        if folder.is_dir() && folder.file_name().is_some_and(|n| n != "library") {
            for file in ["case.toml", "README.md"] {
                if !folder.join(file).is_file() {
                    faults.push(format!("{} has no {file}", folder.display()));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn every_library_file_is_registered() {
    let mut found = BTreeSet::new();
    for kind in std::fs::read_dir(root().join("soil_cases/library")).unwrap() {
        let kind = kind.unwrap().path();
        for file in std::fs::read_dir(&kind).into_iter().flatten() {
            let file = file.unwrap().path();
            let part = |p: &Path| p.file_stem().unwrap().to_str().unwrap().to_owned();
            found.insert((part(&kind), part(&file)));
        }
    }
    let registered = ENTRIES.iter().map(|e| (e.kind.to_owned(), e.name.to_owned())).collect();
    assert_eq!(found, registered);
}

#[test]
fn the_rules_can_fail() {
    assert_eq!(rank_faults("soil/material.rs", "use crate::study::Model;"), ["soil/material.rs uses study"]);
    assert_eq!(rank_faults("soil/material.rs", "use crate::{math::complex, track::{Link, Stack}};").len(), 1);
    assert_eq!(rank_faults("soil/material.rs", "use super::super::case::Case;").len(), 1);
    assert_eq!(rank_faults("tunnel/mod.rs", ""), ["tunnel/mod.rs: tunnel has no rank"]);
    assert!(rank_faults("study/model.rs", "use crate::soil::Profile; use super::StudyError;").is_empty());
    assert!(names("let plan = rustfft::FftPlanner::new();", "rustfft"));
    assert!(!names("use crate::output::hdf5::write;", "hdf5"));
    assert!(code_of("a // .unwrap()\n#[cfg(test)]\nb.unwrap()").trim() == "a");
}
