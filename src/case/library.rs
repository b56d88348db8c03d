//! Named, citable parameter sets that ship with the program.

use super::error::{Finding, spelling};

/// A named set: its kind, its name, its TOML text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// `soils`, `tracks` or `vehicles`.
    pub kind: &'static str,
    /// Name, as a case file says it.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

/// One line per file of `soil_cases/library`.
macro_rules! entry {
    ($kind:literal, $name:literal) => {
        Entry {
            kind: $kind,
            name: $name,
            text: include_str!(concat!("../../soil_cases/library/", $kind, "/", $name, ".toml")),
        }
    };
}

/// Every set, sorted by kind and name.
pub const ENTRIES: &[Entry] = &[
    entry!("soils", "kaynia2000_ledsgard_high_speed"),
    entry!("soils", "kaynia2000_ledsgard_low_speed"),
    entry!("soils", "lamprea2022_half_space"),
    entry!("soils", "lamprea2022_layered"),
    entry!("soils", "mezher2016_profile3"),
    entry!("tracks", "kaynia2000_embankment_high_speed"),
    entry!("tracks", "kaynia2000_embankment_low_speed"),
    entry!("tracks", "lamprea2022_ballasted"),
    entry!("tracks", "lamprea2022_slab"),
    entry!("tracks", "mezher2016_ballasted"),
    entry!("tracks", "mezher2016_slab"),
    entry!("tracks", "sheng1999_ballasted"),
    entry!("vehicles", "goicolea2014_ice3"),
    entry!("vehicles", "iwnicki1998_manchester_benchmark"),
    entry!("vehicles", "kaynia2000_x2000"),
    entry!("vehicles", "lamprea2022_axle"),
    entry!("vehicles", "wu2003_shinkansen_s300"),
];

/// The entry called `name` among those of `kind`.
///
/// # Errors
/// A finding at `path` with the nearest spelling.
pub fn find(kind: &str, name: &str, path: &str) -> Result<Entry, Finding> {
    let of_kind: Vec<&Entry> = ENTRIES.iter().filter(|e| e.kind == kind).collect();
    of_kind.iter().find(|e| e.name == name).map(|e| **e).ok_or_else(|| {
        let names: Vec<&str> = of_kind.iter().map(|e| e.name).collect();
        Finding::new(path, format!("the library has no entry \"{name}\" among its {kind}"))
            .help(spelling(name, &names))
    })
}

impl Entry {
    /// Value of a top-level text key such as `title` or `source`, for listings.
    pub fn text_of(&self, key: &str) -> Option<String> {
        let table: toml::Table = self.text.parse().ok()?;
        table.get(key)?.as_str().map(str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_has_a_title_and_a_source() {
        for entry in ENTRIES {
            assert!(entry.text_of("title").is_some(), "{}", entry.name);
            assert!(entry.text_of("source").is_some(), "{}", entry.name);
        }
    }
}
