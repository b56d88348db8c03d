//! The rules of the house, read from the source: ranks, dependencies, printing, panics, length of files, case folders.

use groundwave::case::library::ENTRIES;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// DESIGN 3: a file uses only modules of lower rank, or its own folder.
const RANKS: &[&[&str]] = &[
    &["math", "memory", "quantity", "columns", "count"],
    &[
        "soil",
        "track",
        "vehicle",
        "irregularity",
        "signal",
        "sampling",
        "dataset",
        "concern",
        "figure",
        "progress",
    ],
    &["foundation", "assessment", "output"],
    &["rail"],
    &["field", "contact"],
    &["railway"],
    &["study"],
    &["case"],
    &["ensemble"],
    &["cli", "main", "lib"],
];

/// Heavy dependencies and the files or folders they may be named in.
const BEHIND: &[(&str, &[&str])] = &[
    ("hdf5", &["output/hdf5.rs", "output/error.rs"]),
    ("resvg", &["output/bitmap.rs"]),
    ("ttf_parser", &["output/lettering.rs"]),
    ("rustfft", &["math/fourier.rs"]),
    ("realfft", &["math/fourier.rs"]),
    ("png", &["output/bitmap.rs", "output/image.rs"]),
    ("miette", &["case/error.rs", "cli/"]),
    ("clap", &["cli/"]),
    ("indicatif", &["cli/progress.rs"]),
    ("ctrlc", &["cli/run.rs"]),
    ("sysinfo", &["memory.rs"]),
    ("rand_chacha", &["sampling/generator.rs"]),
    ("libm", &["math/normal.rs"]),
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

/// `use` and inline paths of a piece of code, groups in braces written out: `crate::a::b`, `super::c`.
fn paths(code: &str) -> BTreeSet<String> {
    fn expand(prefix: &str, rest: &str, found: &mut BTreeSet<String>) {
        let word = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        let end = rest.find(|c| !word(c)).unwrap_or(rest.len());
        let (path, rest) = (format!("{prefix}{}", &rest[..end]), &rest[end..]);
        let Some(group) = rest.strip_prefix('{').filter(|_| path.ends_with("::")) else {
            found.insert(path.trim_end_matches("::").to_owned());
            return;
        };
        // the parts of the group, at its own depth
        let (mut depth, mut start) = (0, 0);
        for (at, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth > 0 => depth -= 1,
                ',' | '}' if depth == 0 => {
                    expand(&path, group[start..at].trim(), found);
                    start = at + 1;
                    if c == '}' {
                        return;
                    }
                }
                _ => {}
            }
        }
    }
    let mut found = BTreeSet::new();
    for door in ["crate::", "super::"] {
        for (at, _) in code.match_indices(door) {
            // the beginning of a path, not a later `super::` in it
            if !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':') {
                expand("", &code[at..], &mut found);
            }
        }
    }
    found
}

/// The module that is a file: `soil/mod.rs` → soil, `soil/strip.rs` → soil::strip.
fn module_path(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    if path == "lib" || path == "main" { Vec::new() } else { path.split('/').map(str::to_owned).collect() }
}

/// The file in which `path`, written in the module `from`, is defined: names that a `mod.rs` hands on are followed.
fn defined_in(path: &str, from: &[String], files: &[(Vec<String>, String, String)]) -> Option<String> {
    let mut place = from.to_vec();
    let mut left = Vec::new();
    for step in path.split("::") {
        match step {
            "crate" => place.clear(),
            "super" => drop(place.pop()),
            "self" | "" => {}
            step => left.push(step.to_owned()),
        }
    }
    while let Some(step) = left.first() {
        let deeper = [place.as_slice(), std::slice::from_ref(step)].concat();
        if !files.iter().any(|f| f.0 == deeper) {
            break;
        }
        (place, left) = (deeper, left[1..].to_vec());
    }
    let (_, file, code) = files.iter().find(|f| f.0 == place)?;
    let name = left.first();
    // pub use child::{…, Name, …};
    let handed_on = code.split("pub use ").skip(1).find_map(|text| {
        let text = format!("crate::{}", text.split(';').next()?);
        paths(&text).into_iter().find(|p| p.rsplit("::").next() == name.map(String::as_str))
    });
    match handed_on {
        Some(path) => {
            let child = path.trim_start_matches("crate::");
            let absolute = if child.starts_with("crate") || place.is_empty() {
                path.clone()
            } else {
                format!("crate::{}::{child}", place.join("::"))
            };
            if absolute == format!("crate::{}", [place.clone(), left.clone()].concat().join("::")) {
                return Some(file.clone());
            }
            defined_in(&absolute, &[], files)
        }
        None => Some(file.clone()),
    }
}

/// Sets of files that use each other in a circle. A `mod.rs` is the door of its folder: its enums name what lies behind, and do
/// not count.
fn circles(sources: &[(String, String)]) -> Vec<BTreeSet<String>> {
    let files: Vec<(Vec<String>, String, String)> =
        sources.iter().map(|(file, code)| (module_path(file), file.clone(), code.clone())).collect();
    let used = |file: &str, code: &str| -> BTreeSet<String> {
        let is_door = file.ends_with("mod.rs") || file == "lib.rs";
        let all = if is_door { BTreeSet::new() } else { paths(code) };
        let targets = all.iter().filter_map(|p| defined_in(p, &module_path(file), &files));
        targets.filter(|target| target != file).collect()
    };
    let edges: BTreeMap<&String, BTreeSet<String>> =
        sources.iter().map(|(f, code)| (f, used(f, code))).collect();
    let reach = |from: &String| {
        let mut seen = BTreeSet::new();
        let mut next: Vec<&String> = edges[from].iter().collect();
        while let Some(file) = next.pop() {
            if seen.insert(file.clone()) {
                next.extend(&edges[file]);
            }
        }
        seen
    };
    let reached: BTreeMap<&String, BTreeSet<String>> = edges.keys().map(|f| (*f, reach(f))).collect();
    let circle = |f: &String| -> BTreeSet<String> {
        reached[f].iter().filter(|other| reached[*other].contains(f)).cloned().collect()
    };
    let all: BTreeSet<BTreeSet<String>> = edges.keys().map(|f| circle(f)).filter(|c| !c.is_empty()).collect();
    all.into_iter().collect()
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let sources: Vec<(String, String)> = sources().into_iter().map(|(file, _, code)| (file, code)).collect();
    let found = circles(&sources);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_rules_can_fail() {
    assert_eq!(rank_faults("soil/material.rs", "use crate::study::Study;"), ["soil/material.rs uses study"]);
    assert_eq!(rank_faults("soil/material.rs", "use crate::{math::complex, track::{Link, Stack}};").len(), 1);
    assert_eq!(rank_faults("soil/material.rs", "use super::super::case::Case;").len(), 1);
    assert_eq!(rank_faults("tunnel/mod.rs", ""), ["tunnel/mod.rs: tunnel has no rank"]);
    assert!(rank_faults("study/model.rs", "use crate::soil::Profile; use super::StudyError;").is_empty());
    assert!(names("let plan = rustfft::FftPlanner::new();", "rustfft"));
    assert!(!names("use crate::output::hdf5::write;", "hdf5"));
    // through a name handed on by a mod.rs, and through a group
    let two = [
        ("soil/mod.rs", "mod a; mod b; pub use a::{Alpha, Other}; pub use b::Beta;"),
        ("soil/a.rs", "use super::{Beta, x::{y, z}}; pub struct Alpha;"),
        ("soil/b.rs", "use crate::soil::Alpha; pub struct Beta;"),
        ("soil/c.rs", "use super::a::Alpha;"),
    ];
    let two = two.map(|(file, code)| (file.to_owned(), code.to_owned()));
    assert_eq!(circles(&two), [BTreeSet::from(["soil/a.rs".to_owned(), "soil/b.rs".to_owned()])]);
    assert!(circles(&two[2..]).is_empty());
    assert!(code_of("a // .unwrap()\n#[cfg(test)]\nb.unwrap()").trim() == "a");
}
