//! The unit of every key of a case file that takes a number, as its documentation has it in brackets: "E [Pa]".
//!
//! A key needs no second entry anywhere: what the schema tells an editor is what the reader of a number with a unit goes by.

use super::schema::CaseInput;
use super::units::{self, RATIO, Unit};
use schemars::{Schema, schema_for};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Every key that takes a number, `[]` for any place of a list, and its unit.
static NUMBERS: LazyLock<BTreeMap<String, &'static Unit>> = LazyLock::new(|| {
    let schema = schema_for!(CaseInput).to_value();
    let mut walk = Walk { definitions: &schema["$defs"], inside: Vec::new(), found: BTreeMap::new() };
    walk.visit(&schema, "", &RATIO);
    walk.found
});

/// The unit of the number at `path`, such as `soil.layer[1].young`; none where no number is known.
pub fn unit(path: &str) -> Option<&'static Unit> {
    let mut key = String::new();
    for part in path.split('[') {
        match part.split_once(']') {
            Some((_, rest)) => key += &format!("[]{rest}"),
            None => key += part,
        }
    }
    // a section has the keys of its track
    let key = match key.strip_prefix("track.section[].") {
        Some(rest) if rest != "length" => format!("track.{rest}"),
        _ => key,
    };
    NUMBERS.get(&key).copied()
}

/// The last known unit in brackets of a `description`.
fn documented(description: &Value) -> Option<&'static Unit> {
    let text = description.as_str()?;
    let brackets = text.split('[').skip(1).filter_map(|rest| rest.split_once(']'));
    brackets.filter_map(|(name, _)| units::named(name)).find(|unit| !unit.name.is_empty())
}

struct Walk<'a> {
    definitions: &'a Value,
    /// Definitions that are being read.
    inside: Vec<&'a str>,
    found: BTreeMap<String, &'static Unit>,
}

impl<'a> Walk<'a> {
    /// Numbers of the `schema` of what stands at `path`; `unit` is that of the table around it.
    fn visit(&mut self, schema: &'a Value, path: &str, unit: &'static Unit) {
        let unit = documented(&schema["description"]).unwrap_or(unit);
        if is_number(schema) {
            // springs between blocks under supports are no springs per metre
            let apart =
                path.starts_with("track.ballast.link.").then(|| unit.name.strip_suffix('²')).flatten();
            self.found.insert(path.to_owned(), apart.and_then(units::named).unwrap_or(unit));
        }
        if let Some(name) = schema["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/"))
            && !self.inside.contains(&name)
        {
            self.inside.push(name);
            self.visit(&self.definitions[name], path, unit);
            self.inside.pop();
        }
        for list in ["anyOf", "oneOf", "allOf"] {
            schema[list].as_array().into_iter().flatten().for_each(|one| self.visit(one, path, unit));
        }
        for (key, value) in schema["properties"].as_object().into_iter().flatten() {
            let below = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            self.visit(value, &below, unit);
        }
        if schema["items"].is_object() {
            self.visit(&schema["items"], &format!("{path}[]"), unit);
        }
    }
}

fn is_number(schema: &Value) -> bool {
    let kinds = &schema["type"];
    kinds == "number" || kinds.as_array().is_some_and(|kinds| kinds.contains(&json!("number")))
}

/// The JSON schema of case files, in which every number may be a text with its unit.
pub fn json_schema() -> Schema {
    let mut schema = schema_for!(CaseInput).to_value();
    allow_texts(&mut schema);
    Schema::try_from(schema).unwrap_or_default()
}

fn allow_texts(schema: &mut Value) {
    if is_number(schema) {
        let mut kinds = match schema["type"].take() {
            Value::Array(kinds) => kinds,
            kind => vec![kind],
        };
        kinds.push("string".into());
        schema["type"] = kinds.into();
        // lists and ranges serve several keys: their unit is known at the key
        let unit = documented(&schema["description"]);
        let names =
            unit.map_or(r"\S+".into(), |unit| unit.names().join("|").replace('(', r"\(").replace(')', r"\)"));
        schema["pattern"] = format!(r"^\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\s*({names})\s*$").into();
    }
    match schema {
        Value::Object(object) => object.values_mut().for_each(allow_texts),
        Value::Array(list) => list.iter_mut().for_each(allow_texts),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Every number that has no unit, by the end of its key.
    const BARE: &[&str] = &[
        "cycles[]",
        "decibels[]",
        "density[]",
        "factors[]",
        "kb_ftm[]",
        "level[]",
        "vdv[]",
        "abreast",
        "accuracy",
        "alpha",
        "damping_ratio",
        "threshold_strain",
        "damping_ratio_pressure",
        "loss_factor",
        "loss_factor_pressure",
        "poisson",
        "ratios[]",
        "sublayers_per_wavelength",
    ];

    #[test]
    fn every_number_has_the_unit_of_its_documentation() {
        let name = |path| unit(path).map(|unit| unit.name);
        for (path, wanted) in [
            ("soil.layer[3].young", "Pa"),
            ("soil.half_space.density", "kg/m³"),
            ("soil.layer[0].loss_factor", ""),
            ("track.pad.stiffness", "N/m²"),
            ("track.section[1].pad.stiffness", "N/m²"),
            ("track.section[1].length", "m"),
            ("track.ballast.link.stiffness", "N/m"),
            ("track.ballast.link.damping", "N s/m"),
            ("track.contact.half_width", "m"),
            ("train.axles[0].load", "N"),
            ("train.body.pitch_inertia", "kg m²"),
            ("train.primary.stiffness", "N/m"),
            ("critical_speed.speeds.from", "m/s"),
            ("critical_speed.speeds[2]", "m/s"),
            ("free_field.frequencies.to", "Hz"),
            ("free_field.receivers[0]", "m"),
            ("contour.x.from", "m"),
            ("equivalent_stiffness.beta[1]", "rad/m"),
            ("irregularity.wavelengths.from", "m"),
        ] {
            assert_eq!(name(path), Some(wanted), "{path}");
        }
        assert_eq!(name("title"), None);
    }

    #[test]
    fn numbers_without_a_unit_are_known_to_have_none() {
        let ends = NUMBERS
            .iter()
            // those of [study] have the unit of the key that varies
            .filter(|(path, unit)| unit.name.is_empty() && !path.starts_with("study."))
            .filter_map(|(path, _)| path.rsplit('.').next());
        let unknown: BTreeSet<&str> = ends.filter(|key| !BARE.contains(key)).collect();
        assert!(unknown.is_empty(), "{unknown:?}: give their units in brackets, or name them here");
    }
}
