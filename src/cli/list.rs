//! `list`, `show`, `new`, `schema`.

use super::args::Kind;
use super::{BAD_INPUT, DONE, FAILED, complain, say};
use groundwave::case::{TEMPLATE, library};
use std::io::Write;
use std::path::Path;

pub fn list(what: Option<Kind>) -> u8 {
    for kind in ["soils", "tracks", "vehicles"] {
        let wanted = match what {
            None => true,
            Some(Kind::Soils) => kind == "soils",
            Some(Kind::Tracks) => kind == "tracks",
            Some(Kind::Vehicles) => kind == "vehicles",
        };
        if !wanted {
            continue;
        }
        let key = kind.trim_end_matches('s').replace("vehicle", "train");
        say(&format!("{kind} (in a case: {key} = \"name\")"));
        for entry in library::ENTRIES.iter().filter(|e| e.kind == kind) {
            say(&format!("  {:34} {}", entry.name, entry.text_of("title").unwrap_or_default()));
        }
    }
    DONE
}

pub fn show(name: &str) -> u8 {
    match groundwave::case::show(name) {
        Ok(lines) => {
            say(lines.trim_end());
            DONE
        }
        Err(error) => {
            complain(&error.into());
            BAD_INPUT
        }
    }
}

pub fn new(file: Option<&Path>) -> u8 {
    let Some(path) = file else {
        say(TEMPLATE.trim_end());
        return DONE;
    };
    // never over an existing file
    match std::fs::File::create_new(path) {
        Ok(mut file) => match file.write_all(TEMPLATE.as_bytes()) {
            Ok(()) => {
                say(&format!("wrote {0}; edit it, then: groundwave run {0}", path.display()));
                DONE
            }
            Err(error) => {
                eprintln!("error: cannot write {}: {error}", path.display());
                FAILED
            }
        },
        Err(error) => {
            eprintln!("error: cannot write {}: {error}", path.display());
            BAD_INPUT
        }
    }
}

pub fn schema() -> u8 {
    match serde_json::to_string_pretty(&groundwave::case::json_schema()) {
        Ok(text) => {
            say(&text);
            DONE
        }
        Err(error) => {
            eprintln!("error: {error}");
            FAILED
        }
    }
}
