//! `[soil]`, `[foundation]`, `[track]` and `[train]` by themselves, read and checked as those of a case are.

use super::error::CaseError;
use super::faults::{self, Read};
use super::loader::Loader;
use super::schema::{SoilInput, TrackInput, TrainInput};
use super::track::{self, Carried};
use super::values::Named;
use super::{changed, plausible, train};
use crate::concern::Concern;
use crate::foundation::Springs;
use crate::railway::Ground;
use crate::track::{Layout, Track};
use crate::vehicle::Train;
use serde::Deserialize;

/// Tables of a case without a question.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct TablesInput {
    soil: Option<Named<SoilInput>>,
    foundation: Option<Springs>,
    track: Option<Named<TrackInput>>,
    train: Option<Named<TrainInput>>,
}

/// What tables of a case stand for, as far as they are given.
#[derive(Clone, Debug)]
pub struct Tables {
    /// `[soil]` with its solver.
    pub ground: Option<Ground>,
    /// `[foundation]`
    pub springs: Option<Springs>,
    /// `[track]`; what it stands on is not judged.
    pub layout: Option<Layout>,
    /// `[train]`
    pub train: Option<Train>,
    /// What their numbers may be doubted for.
    pub concerns: Vec<Concern>,
}

impl Tables {
    /// Reads the TOML `text`, called `name` in messages, that holds some of the four tables; `open` reads files beside it.
    ///
    /// # Errors
    /// Everything wrong with it, at its line and key.
    pub fn parse(
        text: &str,
        name: &str,
        open: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Self, CaseError> {
        let changed = changed::track((text, name), open)?;
        let whole = changed.as_ref().map_or(text, |changed| &changed.text);
        let Read { said, spoilt, faults } = faults::read::<TablesInput>(whole, (name, text), "", None);
        let Some(input) = said else { return Err(CaseError::all(faults, name)) };
        let loader = Loader { read: whole, spoilt, faults: faults.into(), ..Loader::of(name, text, open) };
        let ground = input.soil.and_then(|soil| loader.keep(loader.soil(&soil)));
        let layout = input.track.and_then(|track| loader.keep(layout(&loader, &track)));
        let train = input.train.and_then(|train| loader.keep(train::train(&loader, &train)));
        let (refused, concerns) = plausible::review("", name, text);
        let mut faults = loader.faults.take();
        faults.extend(refused);
        if !faults.is_empty() {
            return Err(CaseError::all(faults, name));
        }
        let (ground, train) = (ground.map(|(ground, _)| ground), train.map(|(train, _)| train));
        Ok(Self { ground, springs: input.foundation, layout, train, concerns })
    }
}

/// The layout of a track: on ground if it says how it touches it, otherwise on whatever carries it.
fn layout(loader: &Loader, named: &Named<TrackInput>) -> Result<Layout, CaseError> {
    let resolved = loader.resolve(named, "track", "tracks")?;
    let touches = resolved.table.contact.is_some() || resolved.table.track == Track::None;
    let on = if touches { Carried::Ground } else { Carried::Apart };
    let (layout, _) = track::track(&resolved, on).map_err(|f| f.at(&resolved.name, &resolved.text))?;
    Ok(layout)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nothing(_: &str) -> Result<String, String> {
        Err("there is no such file".to_owned())
    }

    #[test]
    fn tables_of_the_library_stand_by_themselves() {
        for entry in super::super::library::ENTRIES {
            let key = super::super::loader::root(entry.kind);
            let text = format!("{key} = \"{}\"", entry.name);
            let tables = Tables::parse(&text, "tables", &nothing).unwrap();
            let found = [tables.ground.is_some(), tables.layout.is_some(), tables.train.is_some()];
            assert_eq!(found.iter().filter(|there| **there).count(), 1, "{text}");
        }
    }

    #[test]
    fn faults_are_said_at_their_keys() {
        let text = "[soil]\nbase = \"rigid\"\n[[soil.layer]]\nthickness = -1.0\nshear_sped = 100.0\n[trak]\n";
        let faults = Tables::parse(text, "tables", &nothing).unwrap_err().each();
        let keys: Vec<&str> = faults.iter().map(CaseError::key).collect();
        assert_eq!(keys, ["soil.layer[0]", "soil.layer[0].shear_sped", "trak"]);
    }
}
