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
    entry!("tracks", "zhai2004_ballasted"),
    entry!("vehicles", "antolin2013_pioneer_motor_car"),
    entry!("vehicles", "antolin2013_pioneer_trailer"),
    entry!("vehicles", "domenech2014_eurostar_power_car"),
    entry!("vehicles", "en1991_d10_motor_car"),
    entry!("vehicles", "en1991_d10_trailer"),
    entry!("vehicles", "en1991_d10_train"),
    entry!("vehicles", "en1991_d11_train"),
    entry!("vehicles", "en1991_d11_wagon"),
    entry!("vehicles", "en1991_d12_train"),
    entry!("vehicles", "en1991_d12_wagon"),
    entry!("vehicles", "en1991_d1_coach"),
    entry!("vehicles", "en1991_d1_locomotive"),
    entry!("vehicles", "en1991_d1_train"),
    entry!("vehicles", "en1991_d2_coach"),
    entry!("vehicles", "en1991_d2_locomotive"),
    entry!("vehicles", "en1991_d2_train"),
    entry!("vehicles", "en1991_d3_coach"),
    entry!("vehicles", "en1991_d3_power_car"),
    entry!("vehicles", "en1991_d3_train"),
    entry!("vehicles", "en1991_d4_coach"),
    entry!("vehicles", "en1991_d4_end_coach"),
    entry!("vehicles", "en1991_d4_power_car"),
    entry!("vehicles", "en1991_d4_train"),
    entry!("vehicles", "en1991_d5_locomotive"),
    entry!("vehicles", "en1991_d5_train"),
    entry!("vehicles", "en1991_d5_wagon"),
    entry!("vehicles", "en1991_d6_train"),
    entry!("vehicles", "en1991_d6_wagon_a"),
    entry!("vehicles", "en1991_d6_wagon_b"),
    entry!("vehicles", "en1991_d6_wagon_c"),
    entry!("vehicles", "en1991_d7_train"),
    entry!("vehicles", "en1991_d7_wagon"),
    entry!("vehicles", "en1991_d8_train"),
    entry!("vehicles", "en1991_d8_wagon"),
    entry!("vehicles", "en1991_d9_motor_car"),
    entry!("vehicles", "en1991_d9_trailer"),
    entry!("vehicles", "en1991_d9_train"),
    entry!("vehicles", "en1991_hslm_a1"),
    entry!("vehicles", "en1991_hslm_a10"),
    entry!("vehicles", "en1991_hslm_a2"),
    entry!("vehicles", "en1991_hslm_a3"),
    entry!("vehicles", "en1991_hslm_a4"),
    entry!("vehicles", "en1991_hslm_a5"),
    entry!("vehicles", "en1991_hslm_a6"),
    entry!("vehicles", "en1991_hslm_a7"),
    entry!("vehicles", "en1991_hslm_a8"),
    entry!("vehicles", "en1991_hslm_a9"),
    entry!("vehicles", "froseth2018_freight_wagon_empty"),
    entry!("vehicles", "froseth2018_freight_wagon_full"),
    entry!("vehicles", "froseth2018_locomotive_bobo"),
    entry!("vehicles", "froseth2018_locomotive_coco"),
    entry!("vehicles", "goicolea2014_ice3"),
    entry!("vehicles", "goicolea2014_ice3_end"),
    entry!("vehicles", "goicolea2014_ice3_trailer"),
    entry!("vehicles", "goicolea2014_ice3_train"),
    entry!("vehicles", "iwnicki1998_manchester_benchmark"),
    entry!("vehicles", "kaynia2000_x2000"),
    entry!("vehicles", "lamprea2022_axle"),
    entry!("vehicles", "wu2003_shinkansen_s300"),
    entry!("vehicles", "zhai2009_china_star_power_car"),
    entry!("vehicles", "zhai2009_double_deck_coach"),
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
