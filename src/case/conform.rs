//! A document against the schema of what it may say: every fault at its key, however many there are, in plain words.
//!
//! The schema is the one `groundwave schema` prints, made from the structures the document is read into, so that it cannot say
//! anything else than they do. Of JSON schema it knows what those structures use: `$ref`, `anyOf`, `oneOf`, `const`, `enum`, types,
//! properties, items, and bounds of whole numbers.

use super::error::{Finding, nearest, spelling};
use serde_json::Value as Schema;
use std::collections::BTreeSet;
use toml::{Table, Value};

/// What is wrong in a document.
#[derive(Default)]
pub struct Faults {
    /// Each fault.
    pub findings: Vec<Finding>,
    /// Keys of the document itself that hold a fault, or are probably meant by a misspelt one.
    pub spoilt: BTreeSet<String>,
}

/// One reading of a place: every part of the schema that applies to it.
type Reading<'a> = Vec<&'a Schema>;

/// Every fault of `document` against `schema`.
pub fn faults(document: &Table, schema: &Schema) -> Faults {
    let mut walk = Walk { root: schema, found: Faults::default() };
    if let Some(reading) = walk.readings(schema, &[]).first() {
        walk.table(document, reading, "");
    }
    walk.found
}

struct Walk<'a> {
    root: &'a Schema,
    found: Faults,
}

impl<'a> Walk<'a> {
    /// The ways `schema` can be read, below the parts `above` of it.
    fn readings(&self, schema: &'a Schema, above: &[&'a Schema]) -> Vec<Reading<'a>> {
        let parts: Reading = above.iter().copied().chain([schema]).collect();
        let reference = schema["$ref"].as_str().and_then(|path| path.strip_prefix('#'));
        if let Some(target) = reference.and_then(|path| self.root.pointer(path)) {
            return self.readings(target, &parts);
        }
        match schema["anyOf"].as_array().or(schema["oneOf"].as_array()) {
            Some(ways) => ways.iter().flat_map(|way| self.readings(way, &parts)).collect(),
            None if kind(&parts) == "null" => Vec::new(),
            None => vec![parts],
        }
    }

    fn fault(&mut self, finding: Finding) {
        let first = finding.path.split(['.', '[']).next().unwrap_or_default();
        self.found.spoilt.insert(first.to_owned());
        self.found.findings.push(finding);
    }

    fn value(&mut self, value: &Value, schema: &'a Schema, path: &str) {
        let readings = self.readings(schema, &[]);
        let words: Vec<&str> = readings.iter().flat_map(words).collect();
        let free_text = readings.iter().any(|r| kind(r) == "string" && self::words(r).is_empty());
        if let (Some(text), false, false) = (value.as_str(), words.is_empty(), free_text) {
            if !words.contains(&text) {
                self.fault(
                    Finding::new(path, format!("unknown value \"{text}\"")).help(spelling(text, &words)),
                );
            }
            return;
        }
        let fitting: Vec<Reading> = readings.iter().filter(|r| fits(value, kind(r))).cloned().collect();
        match (value, fitting.first()) {
            (_, None) => self.fault(wrong_kind(value, &readings, path)),
            (Value::Table(table), _) => self.one_of(table, &fitting, path),
            (Value::Array(list), Some(reading)) => {
                let items = reading.iter().find_map(|part| part.get("items"));
                for (i, value) in list.iter().enumerate() {
                    items.into_iter().for_each(|items| self.value(value, items, &format!("{path}[{i}]")));
                }
            }
            (Value::Integer(number), Some(reading)) if !within(*number, reading) => {
                self.fault(wrong_kind(value, &readings, path));
            }
            _ => {}
        }
    }

    /// A table that may be read in several ways, told apart by a key such as `kind`.
    fn one_of(&mut self, table: &Table, readings: &[Reading<'a>], path: &str) {
        let tags: Vec<(&str, &str)> = readings.iter().filter_map(tag).collect();
        let Some((key, _)) = tags.first().filter(|_| tags.len() == readings.len()) else {
            return readings.iter().take(1).for_each(|reading| self.table(table, reading, path));
        };
        let words: Vec<&str> = tags.iter().map(|(_, word)| *word).collect();
        let at = join(path, key);
        match table.get(*key) {
            None => {
                let help = format!("add `{key} = …`, one of {}", quoted(&words));
                self.fault(Finding::new(path, format!("missing key `{key}`")).help(help));
            }
            Some(Value::String(text)) => match words.iter().position(|word| word == text) {
                Some(i) => self.table(table, &readings[i], path),
                None => self.fault(
                    Finding::new(at, format!("unknown value \"{text}\"")).help(spelling(text, &words)),
                ),
            },
            Some(value) => {
                let message = format!("found {}, wanted one of {}", shown(value), quoted(&words));
                self.fault(Finding::new(at, message));
            }
        }
    }

    fn table(&mut self, table: &Table, reading: &Reading<'a>, path: &str) {
        let allowed: Vec<(&str, &'a Schema)> = reading
            .iter()
            .filter_map(|part| part["properties"].as_object())
            .flat_map(|properties| properties.iter().map(|(key, schema)| (key.as_str(), schema)))
            .collect();
        let names: Vec<&str> = allowed.iter().map(|(key, _)| *key).collect();
        let open = reading
            .iter()
            .all(|part| part["additionalProperties"] != false && part["unevaluatedProperties"] != false);
        let mut meant = BTreeSet::new();
        for (key, value) in table {
            let at = join(path, key);
            match allowed.iter().find(|(name, _)| name == key) {
                Some((_, schema)) => self.value(value, schema, &at),
                None if open => {}
                None => {
                    meant.extend(nearest(key, &names));
                    let message = format!("unknown key `{key}`");
                    self.fault(Finding::new(at, message).on_key().help(spelling(key, &names)));
                }
            }
        }
        if path.is_empty() {
            self.found.spoilt.extend(meant.iter().map(|key| (*key).to_owned()));
        }
        let required = reading.iter().filter_map(|part| part["required"].as_array()).flatten();
        for key in required.filter_map(Schema::as_str).collect::<BTreeSet<_>>() {
            if table.contains_key(key) || meant.contains(key) {
                continue;
            }
            let schema = allowed.iter().find(|(name, _)| *name == key).map(|(_, schema)| *schema);
            let about = schema.and_then(|schema| self.readings(schema, &[]).first().and_then(about));
            let about = about.map(|text| format!(": {text}")).unwrap_or_default();
            let help = format!("add `{key} = …`{about}");
            self.fault(Finding::new(path, format!("missing key `{key}`")).help(help));
        }
    }
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// The JSON type of a reading, and "" where any will do.
fn kind<'a>(reading: &Reading<'a>) -> &'a str {
    let of_part = |part: &&'a Schema| match &part["type"] {
        Schema::String(kind) => Some(kind.as_str()),
        // an optional value: its type, or null
        Schema::Array(kinds) => kinds.iter().filter_map(Schema::as_str).find(|kind| *kind != "null"),
        _ if part.get("const").is_some() || part.get("enum").is_some() => Some("string"),
        _ if part.get("properties").is_some() => Some("object"),
        _ => None,
    };
    reading.iter().rev().find_map(of_part).unwrap_or_default()
}

/// The words a reading stands for, if it stands for words.
fn words<'a>(reading: &Reading<'a>) -> Vec<&'a str> {
    let of_part = |part: &&'a Schema| {
        let several = part["enum"].as_array().into_iter().flatten();
        part.get("const").into_iter().chain(several).filter_map(Schema::as_str)
    };
    reading.iter().flat_map(of_part).collect()
}

/// The key that tells a reading from others, and its word.
fn tag<'a>(reading: &Reading<'a>) -> Option<(&'a str, &'a str)> {
    let properties = reading.iter().rev().filter_map(|part| part["properties"].as_object());
    properties.flatten().find_map(|(key, schema)| Some((key.as_str(), schema["const"].as_str()?)))
}

/// What a reading is about: its longest description.
fn about<'a>(reading: &Reading<'a>) -> Option<&'a str> {
    let texts = reading.iter().filter_map(|part| part["description"].as_str());
    // names of tables stand in back-quotes
    texts.filter(|text| !text.starts_with('`')).max_by_key(|text| text.len())
}

fn fits(value: &Value, kind: &str) -> bool {
    match value {
        Value::Integer(_) => matches!(kind, "number" | "integer" | ""),
        Value::Float(_) => matches!(kind, "number" | ""),
        Value::String(_) => matches!(kind, "string" | ""),
        Value::Boolean(_) => matches!(kind, "boolean" | ""),
        Value::Array(_) => matches!(kind, "array" | ""),
        Value::Table(_) => matches!(kind, "object" | ""),
        Value::Datetime(_) => kind.is_empty(),
    }
}

/// Least and largest whole number of a reading.
fn bounds(reading: &Reading) -> (i64, i64) {
    let bound = |key| reading.iter().find_map(|part| part[key].as_i64());
    let format = reading.iter().find_map(|part| part["format"].as_str()).unwrap_or_default();
    let most = if format == "uint32" { i64::from(u32::MAX) } else { i64::MAX };
    (bound("minimum").unwrap_or(i64::MIN), bound("maximum").unwrap_or(most))
}

fn within(number: i64, reading: &Reading) -> bool {
    let (least, most) = bounds(reading);
    kind(reading) != "integer" || (least..=most).contains(&number)
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}

/// A value as a message names it.
fn shown(value: &Value) -> String {
    match value {
        Value::String(text) => format!("the text \"{text}\""),
        Value::Array(_) => "a list".into(),
        Value::Table(_) => "a table".into(),
        Value::Datetime(_) => "a date".into(),
        value => value.to_string(),
    }
}

/// What a reading asks for.
fn wanted(reading: &Reading) -> String {
    match kind(reading) {
        "number" => "a number".into(),
        "integer" => match bounds(reading) {
            (i64::MIN, _) => "a whole number".into(),
            (least, i64::MAX) => format!("a whole number from {least} on"),
            (least, most) => format!("a whole number from {least} to {most}"),
        },
        "string" if words(reading).is_empty() => "text in quotes".into(),
        "string" => quoted(&words(reading)),
        "array" => "a list".into(),
        "object" => "a table".into(),
        "boolean" => "true or false".into(),
        _ => "something else".into(),
    }
}

fn wrong_kind(value: &Value, readings: &[Reading], path: &str) -> Finding {
    let mut ways: Vec<String> = Vec::new();
    for way in readings.iter().map(wanted) {
        if !ways.contains(&way) {
            ways.push(way);
        }
    }
    let finding = Finding::new(path, format!("found {}, wanted {}", shown(value), ways.join(", or ")));
    let tables = |reading: &Reading| {
        let items = reading.iter().find_map(|part| part.get("items"));
        items.is_some_and(|items| items.get("$ref").is_some() || items.get("properties").is_some())
    };
    let name = path.rsplit('.').next().unwrap_or(path);
    match (value, readings.first()) {
        (Value::String(text), _) if text.trim().parse::<f64>().is_ok() => finding.help("remove the quotes"),
        (Value::Table(_), Some(reading)) if kind(reading) == "array" && tables(reading) => {
            finding.help(format!("write [[{path}]], with double brackets, above each of them"))
        }
        (Value::Array(_), Some(reading)) if kind(reading) == "object" => {
            finding.help(format!("write [{path}], with single brackets, or {name} = {{ … }}"))
        }
        (_, Some(reading)) => match about(reading) {
            Some(about) => finding.help(format!("{name}: {about}")),
            None => finding,
        },
        _ => finding,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use schemars::JsonSchema;

    #[derive(JsonSchema)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Document {
        spring: Spring,
        size: Option<u8>,
    }

    #[derive(JsonSchema)]
    #[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
    #[allow(dead_code)]
    enum Spring {
        Plain { stiffness: f64 },
        Damped(Damped),
    }

    #[derive(JsonSchema)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Damped {
        stiffness: f64,
        /// c [N s/m]
        damping: f64,
    }

    /// Path and message of every fault in `text`.
    fn found(text: &str) -> Vec<(String, String)> {
        let schema = schemars::schema_for!(Document);
        let findings = faults(&text.parse().unwrap(), schema.as_value()).findings;
        findings.into_iter().map(|f| (f.path, f.message)).collect()
    }

    #[test]
    fn kinds_are_told_by_their_key() {
        assert_eq!(found("spring = { kind = \"plain\", stiffness = 1 }"), []);
        assert_eq!(found("spring = { kind = \"damped\", stiffness = 1, damping = 2.0 }"), []);
        let one = |text: &str, path: &str, message: &str| {
            assert_eq!(found(text), [(path.to_owned(), message.to_owned())], "{text}");
        };
        one(
            "spring = { kind = \"plain\", stiffness = [] }",
            "spring.stiffness",
            "found a list, wanted a number",
        );
        one(
            "spring = { kind = \"plain\", stiffness = 1, damping = 2 }",
            "spring.damping",
            "unknown key `damping`",
        );
        one("spring = { kind = \"damped\", stiffness = 1 }", "spring", "missing key `damping`");
        one("spring = { kind = \"dumped\", stiffness = 1 }", "spring.kind", "unknown value \"dumped\"");
        one("spring = { stiffness = 1 }", "spring", "missing key `kind`");
        one("spring = { kind = 1 }", "spring.kind", "found 1, wanted one of \"plain\", \"damped\"");
        one("spring = 1", "spring", "found 1, wanted a table");
        one("sprang = { kind = \"plain\" }", "sprang", "unknown key `sprang`");
    }

    #[test]
    fn whole_numbers_have_bounds() {
        let spring = "spring = { kind = \"plain\", stiffness = 1 }\n";
        assert_eq!(found(&format!("{spring}size = 255")), []);
        for size in ["256", "-1", "1.0"] {
            let message = format!("found {size}, wanted a whole number from 0 to 255");
            assert_eq!(found(&format!("{spring}size = {size}")), [("size".to_owned(), message)]);
        }
    }
}
