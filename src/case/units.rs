//! Units that may stand behind a number, "150 kN": the one list of them, by what a key takes.

use std::borrow::Cow;
use std::f64::consts::PI;

/// What a number measures, in SI, and the units that may be written instead.
#[derive(Debug)]
pub struct Unit {
    /// The SI unit, as the documentation of a key has it in brackets; empty of a plain number.
    pub name: &'static str,
    /// What is measured, in words.
    pub what: &'static str,
    /// Other units, and their size in the SI unit.
    pub others: &'static [(&'static str, f64)],
}

const fn unit(name: &'static str, what: &'static str, others: &'static [(&'static str, f64)]) -> Unit {
    Unit { name, what, others }
}

/// Standard gravity of masses that stand for forces [m/s²], as of axle loads.
const G: f64 = crate::vehicle::GRAVITY;

pub const RATIO: Unit = unit("", "a plain number", &[("%", 1e-2), ("‰", 1e-3)]);
pub const METRE: Unit = unit("m", "a length", &[("mm", 1e-3), ("cm", 1e-2), ("µm", 1e-6), ("km", 1e3)]);
pub const SPEED: Unit = unit("m/s", "a speed", &[("km/h", 1.0 / 3.6), ("km/s", 1e3), ("mm/s", 1e-3)]);
pub const SECOND: Unit = unit("s", "a time", &[("ms", 1e-3), ("min", 60.0), ("h", 3600.0)]);
pub const HERTZ: Unit = unit("Hz", "a frequency", &[("kHz", 1e3)]);
pub const RADIAN: Unit = unit("rad", "an angle", &[("mrad", 1e-3), ("°", PI / 180.0)]);
pub const WAVENUMBER: Unit = unit("rad/m", "a wavenumber", &[("1/m", 1.0)]);
pub const DENSITY: Unit =
    unit("kg/m³", "a density", &[("t/m³", 1e3), ("g/cm³", 1e3), ("kN/m³", 1e3 / G), ("kg/dm³", 1e3)]);
pub const PRESSURE: Unit = unit(
    "Pa",
    "a modulus",
    &[("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("N/mm²", 1e6), ("kN/m²", 1e3), ("MN/m²", 1e6)],
);
pub const NEWTON: Unit = unit("N", "a force", &[("kN", 1e3), ("MN", 1e6), ("t", 1e3 * G)]);
pub const KILOGRAM: Unit = unit("kg", "a mass", &[("t", 1e3)]);
pub const INERTIA: Unit = unit("kg m²", "a moment of inertia", &[("t m²", 1e3)]);
pub const LINE_MASS: Unit = unit("kg/m", "a mass per metre", &[("t/m", 1e3)]);
pub const ROTARY: Unit = unit("kg m", "a rotary inertia per metre", &[("t m", 1e3)]);
pub const BENDING: Unit =
    unit("N m²", "a bending stiffness", &[("kN m²", 1e3), ("MN m²", 1e6), ("GN m²", 1e9)]);
pub const LINE_SPRING: Unit = unit(
    "N/m²",
    "a stiffness per metre",
    &[("kN/m²", 1e3), ("MN/m²", 1e6), ("GN/m²", 1e9), ("N/mm²", 1e6), ("kN/mm/m", 1e6), ("MPa", 1e6)],
);
pub const LINE_DAMPER: Unit =
    unit("N s/m²", "a viscosity per metre", &[("kN s/m²", 1e3), ("MN s/m²", 1e6), ("kN s/m/m", 1e3)]);
pub const SPRING: Unit = unit(
    "N/m",
    "a stiffness",
    &[("kN/m", 1e3), ("MN/m", 1e6), ("GN/m", 1e9), ("N/mm", 1e3), ("kN/mm", 1e6), ("MN/mm", 1e9)],
);
pub const DAMPER: Unit =
    unit("N s/m", "a viscosity", &[("kN s/m", 1e3), ("MN s/m", 1e6), ("N s/mm", 1e3), ("kN s/mm", 1e6)]);
pub const BEDDING: Unit = unit(
    "N/m³",
    "a bedding modulus",
    &[("N/mm³", 1e9), ("kN/m³", 1e3), ("MN/m³", 1e6), ("N/cm³", 1e6), ("GN/m³", 1e9)],
);
pub const AREA: Unit = unit("m²", "an area", &[("cm²", 1e-4), ("mm²", 1e-6)]);
pub const ROUGHNESS: Unit = unit("m³", "a spectrum", &[("cm³", 1e-6)]);

/// All of them.
const ALL: &[Unit] = &[
    RATIO,
    METRE,
    SPEED,
    SECOND,
    HERTZ,
    RADIAN,
    WAVENUMBER,
    DENSITY,
    PRESSURE,
    NEWTON,
    KILOGRAM,
    INERTIA,
    LINE_MASS,
    ROTARY,
    BENDING,
    LINE_SPRING,
    LINE_DAMPER,
    SPRING,
    DAMPER,
    BEDDING,
    AREA,
    ROUGHNESS,
];

/// The one called `name`.
pub fn named(name: &str) -> Option<&'static Unit> {
    ALL.iter().find(|unit| unit.name == name)
}

/// Why a text is not the number that is wanted: what is wrong, and advice.
pub type Misread = (String, String);

/// A unit without the ways it can be spaced and typed: "kN·s/m^2" as "kNs/m²".
fn plain(unit: &str) -> String {
    let kept = unit.chars().filter(|c| !c.is_whitespace() && !"·⋅*^".contains(*c));
    let typed: String = kept
        .map(|c| match c {
            '2' => '²',
            '3' => '³',
            'μ' => 'µ',
            c => c,
        })
        .collect();
    match typed.strip_prefix("um") {
        Some("") => "µm".into(),
        _ => typed,
    }
}

/// "150 kN" → 150 and "kN"; none without a number in front.
fn split(text: &str) -> Option<(f64, &str)> {
    let digits = text.find(|c: char| !"+-.0123456789eE".contains(c)).unwrap_or(text.len());
    // an e may belong to the unit
    (1..=digits).rev().find_map(|end| Some((text[..end].parse().ok()?, text[end..].trim())))
}

impl Unit {
    /// The size of the unit `name` in this one.
    fn size(&self, name: &str) -> Option<f64> {
        let name = plain(name);
        let own = std::iter::once((self.name, 1.0)).chain(self.others.iter().copied());
        own.filter(|(other, _)| !other.is_empty())
            .find(|(other, _)| plain(other) == name)
            .map(|(_, size)| size)
    }

    /// Every unit that may stand there.
    pub fn names(&self) -> Vec<&'static str> {
        let own = std::iter::once(self.name).chain(self.others.iter().map(|(name, _)| *name));
        own.filter(|name| !name.is_empty()).collect()
    }

    /// "a force in N"
    fn wanted(&self) -> Cow<'static, str> {
        if self.name.is_empty() { self.what.into() } else { format!("{} in {}", self.what, self.name).into() }
    }

    /// The number [SI] that `text` says with its unit.
    ///
    /// # Errors
    /// No number, no unit, a unit of something else, or none at all.
    pub fn read(&self, text: &str) -> Result<f64, Misread> {
        let text = text.trim();
        let names = self.names();
        let allowed = format!("allowed: {}", names.join(", "));
        let example = self.others.first().map_or(self.name, |(name, _)| name);
        let Some((value, unit)) = split(text) else {
            let message = format!("found the text \"{text}\", wanted {}", self.wanted());
            return Err((
                message,
                format!("write a number, or one with its unit such as \"12 {example}\"; {allowed}"),
            ));
        };
        match self.size(unit) {
            Some(size) => Ok(value * size),
            None if unit.is_empty() => Err((
                format!("found the text \"{text}\", wanted a number"),
                format!("remove the quotes, or write its unit behind it; {allowed}"),
            )),
            None if unit.starts_with(',') => Err((
                format!("found the text \"{text}\", wanted {}", self.wanted()),
                "decimals have a point: 0.35, not 0,35".into(),
            )),
            None => {
                let alike = |name: &&str| plain(name).to_lowercase() == plain(unit).to_lowercase();
                let meant = names.iter().find(|name| alike(name));
                let meant = meant.map_or(String::new(), |name| format!("did you mean `{name}`? "));
                // a pad by the piece where the key is per metre of track
                let piece = match self.name {
                    "N/m²" if SPRING.size(unit).is_some() => "; of one pad or mat: `piece.stiffness` [N/m]",
                    "kg/m" if KILOGRAM.size(unit).is_some() => "; of one sleeper: `piece.mass` [kg]",
                    _ => "",
                };
                let message = match ALL.iter().find(|other| other.size(unit).is_some()) {
                    Some(other) => format!("found \"{text}\", {}, wanted {}", other.what, self.wanted()),
                    None => {
                        format!("found \"{text}\" with the unknown unit `{unit}`, wanted {}", self.wanted())
                    }
                };
                Err((message, format!("{meant}{allowed}{piece}")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fields_own_symbols() {
        for (unit, text, value) in [
            (&SPEED, "250 km/h", 250.0 / 3.6),
            (&SPEED, "36km/h", 10.0),
            (&SPEED, "1e2 m/s", 100.0),
            (&NEWTON, "150 kN", 150e3),
            (&NEWTON, "15 t", 147_150.0),
            (&KILOGRAM, "1.8 t", 1800.0),
            (&PRESSURE, "60 MPa", 60e6),
            (&PRESSURE, "60 N/mm^2", 60e6),
            (&METRE, "300 mm", 0.3),
            (&METRE, "5 um", 5e-6),
            (&METRE, "5 μm", 5e-6),
            (&SPRING, "18 kN/mm", 18e6),
            (&DAMPER, "4kN·s/m", 4e3),
            (&LINE_DAMPER, "4 kN s/m2", 4e3),
            (&INERTIA, "1.2 t m²", 1200.0),
            (&HERTZ, "25 Hz", 25.0),
            (&RATIO, "5 %", 0.05),
            (&RADIAN, "180 °", PI),
            (&NEWTON, "-1.5e2 kN", -150e3),
            (&SECOND, "16 h", 57_600.0),
        ] {
            let read = unit.read(text).unwrap();
            // the product is rounded once
            assert!((read - value).abs() <= 2e-16 * value.abs(), "{text}: {read}");
        }
    }

    #[test]
    fn says_what_was_found_what_is_wanted_and_what_is_allowed() {
        let said = |unit: &Unit, text: &str| {
            let (message, help) = unit.read(text).unwrap_err();
            format!("{message}: {help}")
        };
        let force = "allowed: N, kN, MN, t";
        assert_eq!(
            said(&NEWTON, "250 km/h"),
            format!("found \"250 km/h\", a speed, wanted a force in N: {force}")
        );
        assert!(
            said(&SPEED, "250 mph")
                .starts_with("found \"250 mph\" with the unknown unit `mph`, wanted a speed")
        );
        assert!(said(&PRESSURE, "60 Mpa").contains("did you mean `MPa`?"));
        assert!(said(&LINE_SPRING, "150 kN/mm").ends_with("of one pad or mat: `piece.stiffness` [N/m]"));
        assert!(said(&NEWTON, "150").contains("remove the quotes"));
        assert!(said(&NEWTON, "heavy").contains("found the text \"heavy\", wanted a force in N"));
        assert!(said(&METRE, "0,3 m").contains("decimals have a point"));
        assert_eq!(said(&RATIO, "5 kN"), "found \"5 kN\", a force, wanted a plain number: allowed: %, ‰");
        assert!(said(&METRE, "nan m").contains("wanted a length") && METRE.read("").is_err());
    }

    #[test]
    fn no_unit_stands_twice_in_a_row_and_each_has_a_size() {
        for unit in ALL {
            let names: Vec<String> = unit.names().iter().map(|name| plain(name)).collect();
            let mut once = names.clone();
            once.sort();
            once.dedup();
            assert_eq!(once.len(), names.len(), "{}", unit.name);
            assert!(unit.others.iter().all(|(name, size)| *size > 0.0 && unit.size(name) == Some(*size)));
        }
    }
}
