//! What documents name exists: paths and functions in CONTRIBUTING.md and README.md, tests cited in documentation of code.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every file of the project, relative to its root, with its text where it is code.
fn files() -> Vec<(String, String)> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.file_name().and_then(|n| n.to_str()) {
                Some("target" | ".git") | None => {}
                Some(_) if path.is_dir() => walk(&path, found),
                Some(_) => found.push(path),
            }
        }
    }
    let mut found = Vec::new();
    walk(root(), &mut found);
    let name = |path: &Path| path.strip_prefix(root()).unwrap().to_str().unwrap().to_owned();
    let is_code =
        |path: &Path| path.extension().is_some_and(|e| ["rs", "js", "py"].iter().any(|code| e == *code));
    let text =
        |path: &Path| if is_code(path) { std::fs::read_to_string(path).unwrap() } else { String::new() };
    found.iter().map(|path| (name(path), text(path))).collect()
}

/// What stands between backticks in `text`, code blocks left out.
fn quoted(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect::<Vec<_>>().join(" ");
    prose.split('`').skip(1).step_by(2).map(|word| word.replace('\n', " ")).collect()
}

/// `a/{b,c}` → `a/b`, `a/c`.
fn written_out(path: &str) -> Vec<String> {
    let Some((before, rest)) = path.split_once('{') else { return vec![path.to_owned()] };
    let Some((group, after)) = rest.split_once('}') else { return vec![path.to_owned()] };
    group.split(',').map(|part| format!("{before}{}{after}", part.trim())).collect()
}

/// Whether `path` is a file or folder, at its place or, without a slash, anywhere; up to the first placeholder.
fn is_path(path: &str, files: &[(String, String)]) -> bool {
    let named = path.split(['<', '*']).next().unwrap_or(path);
    let folder = if named == path { path } else { named.rsplit_once('/').map_or("", |(folder, _)| folder) };
    let folder = folder.trim_end_matches('/');
    files.iter().any(|(file, _)| {
        file == folder
            || file.starts_with(&format!("{folder}/"))
            || file.ends_with(&format!("/{folder}"))
            || file.contains(&format!("/{folder}/"))
            || folder.is_empty()
    })
}

/// Words of all code but this file, and names of files.
fn words(files: &[(String, String)]) -> BTreeSet<&str> {
    let word = |c: char| !(c.is_alphanumeric() || c == '_');
    let others = files.iter().filter(|(file, _)| !file.ends_with("documents.rs"));
    others.flat_map(|(file, code)| code.split(word).chain(file.split(word))).collect()
}

/// What of `text` names nothing.
fn missing(text: &str, files: &[(String, String)], words: &BTreeSet<&str>) -> Vec<String> {
    let ends = [".rs", ".md", ".toml", ".json", ".csv", ".py"];
    let is_identifier = |name: &str| {
        name.starts_with(|c: char| c.is_alphabetic())
            && name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == ':')
    };
    let mut faults = Vec::new();
    for name in quoted(text) {
        let signature = name.split('(').next().unwrap_or(&name).to_owned();
        if (name.contains('/') || ends.iter().any(|end| name.ends_with(end))) && !name.contains([' ', '=']) {
            let paths = written_out(&name);
            faults.extend(paths.into_iter().filter(|path| !is_path(path, files)));
        } else if is_identifier(&signature)
            && !signature.split("::").filter(|n| !n.is_empty()).all(|n| words.contains(n))
        {
            faults.push(name);
        }
    }
    faults
}

#[test]
fn contributing_names_what_exists() {
    let files = files();
    let text = std::fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
    let faults = missing(&text, &files, &words(&files));
    assert!(faults.is_empty(), "{faults:#?}");
}

/// The tests cited in the documentation of `code`: `tier::file`, `tier::file::function`, `tests::function`
/// of the file's own, or `neighbour::tests::function`.
fn cited(code: &str) -> Vec<String> {
    let comments: String = code
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("//"))
        .map(|line| format!("{} ", line.trim_start_matches(['/', '!']).trim()))
        .collect();
    let mut found = Vec::new();
    for word in ["test `", "tests `", "Test: `", "Tests: `"] {
        for (at, _) in comments.match_indices(word) {
            // `a::b`, `c` and `d`
            for (i, part) in comments[at..].split('`').skip(1).enumerate() {
                match i % 2 {
                    0 => found.push(part.to_owned()),
                    _ if [", ", " and "].contains(&part) => {}
                    _ => break,
                }
            }
        }
    }
    found
}

/// Whether the test `name`, cited in `file`, exists.
fn exists(name: &str, file: &str, files: &[(String, String)]) -> bool {
    let code = |wanted: &str| files.iter().find(|(file, _)| file == wanted).map(|(_, code)| code.as_str());
    let has = |code: &str, function: &str| code.contains(&format!("fn {function}("));
    let steps: Vec<&str> = name.split("::").collect();
    match steps[..] {
        [.., "tests", function] if steps.len() == 3 => {
            let other = format!("{}/{}.rs", file.rsplit_once('/').map_or("", |(folder, _)| folder), steps[0]);
            code(&other).is_some_and(|code| has(code, function))
        }
        ["tests", function] => code(file).is_some_and(|code| has(code, function)),
        [tier] if files.iter().any(|(f, _)| f.starts_with(&format!("tests/{tier}/"))) => true,
        [function] => code(file).is_some_and(|code| has(code, function)),
        [tier, part] => [format!("tests/{tier}.rs"), format!("tests/{tier}/main.rs")]
            .iter()
            .find_map(|f| code(f))
            .is_some_and(|main| has(main, part) || code(&format!("tests/{tier}/{part}.rs")).is_some()),
        [tier, part, function] => {
            code(&format!("tests/{tier}/{part}.rs")).is_some_and(|code| has(code, function))
        }
        _ => false,
    }
}

#[test]
fn cited_tests_exist() {
    let files = files();
    let faults: Vec<String> = files
        .iter()
        .filter(|(file, _)| file.starts_with("src/"))
        .flat_map(|(file, code)| cited(code).into_iter().map(move |name| (file, name)))
        .filter(|(file, name)| !exists(name, file, &files))
        .map(|(file, name)| format!("{file} cites the test {name}"))
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn the_rules_can_fail() {
    let files = files();
    let words = words(&files);
    let text = "`src/soil/mod.rs`, `tests/{laws,papers}`, `LayeredSoil`, `src/tunnel/mod.rs`, `src/{soil,moon}/`, `fly_to_moon()`";
    assert_eq!(missing(text, &files, &words), ["src/tunnel/mod.rs", "src/moon/", "fly_to_moon()"]);
    assert_eq!(
        cited("/// 1e-3 (tests `laws`, `papers::moon`).\n//! Test: `up`."),
        ["laws", "papers::moon", "up"]
    );
    assert!(exists("laws", "src/lib.rs", &files) && !exists("papers::moon", "src/lib.rs", &files));
}

/// The jobs of `docs/jobs.md`, and what the variants differ in.
#[test]
fn jobs_are_cases() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("docs/jobs")).unwrap() {
        let path = entry.unwrap().path();
        let case = groundwave::case::Case::load(&path).unwrap_or_else(|error| panic!("{error:?}"));
        assert!(!case.studies.is_empty() && !case.about.rows().is_empty(), "{}", path.display());
        count += 1;
    }
    assert_eq!(count, 5);
    let read = |name: &str| std::fs::read_to_string(root().join("docs/jobs").join(name)).unwrap();
    let (a, b) = (read("variant_a.toml"), read("variant_b.toml"));
    let changed = a.lines().zip(b.lines()).filter(|(a, b)| a != b).count();
    // title, name and speed of one layer
    assert_eq!((a.lines().count(), changed), (b.lines().count(), 3));
}
