//! `[track] library = "…"`: a library track with any of its keys changed, put together before the case is read.

use super::error::{CaseError, Finding, spelling};
use super::library;
use toml::{Table, Value};

/// A case whose track is one of the library, changed.
pub struct Changed {
    /// The case with the whole track in its place.
    pub text: String,
    /// The file of the track: its name and text.
    pub file: (String, String),
    /// What it is and where it comes from; none of a file beside the case.
    pub reference: Option<String>,
}

/// The case `text`, called `name`, with the keys of its library track; None where it names none.
///
/// # Errors
/// At `track.library`, or at the `kind` of a track that is another one.
pub fn track(
    (text, name): (&str, &str),
    open: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Option<Changed>, CaseError> {
    let Ok(mut case) = text.parse::<Table>() else { return Ok(None) };
    let Some(Value::Table(change)) = case.get_mut("track") else { return Ok(None) };
    let Some(named) = change.remove("library") else { return Ok(None) };
    let fault = |finding: Finding| finding.at(name, text);
    let Value::String(wanted) = named else {
        let message = format!("found {named}, wanted the name of a library track");
        return Err(fault(Finding::new("track.library", message)));
    };
    let change = std::mem::take(change);
    let (file, reference) = match library::find("tracks", &wanted, "track.library") {
        Ok(entry) => {
            let said = |key| entry.text_of(key).unwrap_or_default();
            let reference = format!("{wanted}: {}, with changes. {}", said("title"), said("source"));
            ((format!("library/tracks/{wanted}.toml"), entry.text.to_owned()), Some(reference))
        }
        Err(mut finding) => {
            let beside = if wanted.ends_with(".toml") { wanted } else { format!("{wanted}.toml") };
            let text = open(&beside).map_err(|reason| {
                finding.message += &format!("; {beside} beside the case: {reason}");
                fault(finding)
            })?;
            ((beside, text), None)
        }
    };
    let unread = |error: toml::de::Error| {
        fault(Finding::new("track.library", format!("{}: {}", file.0, error.message())))
    };
    let mut track: Table = file.1.parse().map_err(unread)?;
    track.remove("title");
    track.remove("source");
    if let (Some(own), Some(kind)) =
        (track.get("kind"), change.get("kind").filter(|kind| Some(*kind) != track.get("kind")))
    {
        let finding =
            Finding::new("track.kind", format!("found {kind}: the track of the library is of kind {own}"));
        let help = own.as_str().map_or(String::new(), |own| spelling(own, &[own]));
        return Err(fault(finding.help(format!("remove it, or library; {help}"))));
    }
    overlay(&mut track, change);
    case.insert("track".into(), Value::Table(track));
    Ok(Some(Changed { text: case.to_string(), file, reference }))
}

/// Keys that say the same of a table, each in its own way.
const INSTEAD: [&[&str]; 3] = [
    &["stiffness", "element", "piece", "bedding_modulus"],
    &["mass", "piece"],
    &["section", "bending_stiffness"],
];

/// Whether the table `new` says in another way what `old` says.
fn replaces(old: &Table, new: &Table) -> bool {
    let other = |ways: &&[&str]| {
        let said = |table: &Table| ways.iter().position(|way| table.contains_key(*way));
        said(new).is_some_and(|way| !old.contains_key(ways[way]) && said(old).is_some())
    };
    ["kind", "element", "section"].iter().any(|key| new.contains_key(*key)) || INSTEAD.iter().any(other)
}

/// `change` laid over `table` key by key; a table of another kind, or that says what it says in another way, replaces.
pub fn overlay(table: &mut Table, change: Table) {
    for (key, value) in change {
        match (table.get_mut(&key), value) {
            (Some(Value::Table(old)), Value::Table(new)) if !replaces(old, &new) => overlay(old, new),
            (_, value) => {
                table.insert(key, value);
            }
        }
    }
}
