//! Numbers of a case by the paths of their keys, `soil.layer[0].young`: found, read in SI, and put in.

use super::keys;
use super::units::{Misread, Unit};
use std::collections::BTreeMap;
use toml::Value;

/// The number [SI] that `value` says where `unit` is asked for.
///
/// # Errors
/// What is wrong, and advice.
pub fn number(value: &Value, unit: &Unit) -> Result<f64, Misread> {
    match value {
        Value::Float(number) => Ok(*number),
        Value::Integer(number) => Ok(*number as f64),
        Value::String(text) => unit.read(text),
        other => {
            Err((format!("found {other}, wanted a number"), "write a number, or one with its unit".into()))
        }
    }
}

/// Every number of `case` whose unit is known [SI], by its path.
pub fn numbers(case: &Value) -> BTreeMap<String, f64> {
    fn walk(value: &Value, path: &str, found: &mut BTreeMap<String, f64>) {
        match value {
            Value::Table(table) => table.iter().for_each(|(key, value)| {
                let below = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                walk(value, &below, found);
            }),
            Value::Array(list) => {
                list.iter().enumerate().for_each(|(i, value)| walk(value, &format!("{path}[{i}]"), found));
            }
            value => {
                let read = keys::unit(path).and_then(|unit| number(value, unit).ok());
                found.extend(read.map(|number| (path.to_owned(), number)));
            }
        }
    }
    let mut found = BTreeMap::new();
    walk(case, "", &mut found);
    found
}

/// The path that `written` means in `case`: places of lists as `[0]`, `.0`, or by the `name` of what stands there.
pub fn meant(written: &str, case: &Value) -> String {
    let (mut path, mut at) = (String::new(), Some(case));
    for step in written.split(['.', '[', ']']).map(str::trim).filter(|step| !step.is_empty()) {
        if let Some(Value::Array(list)) = at {
            let named =
                || list.iter().position(|item| item.get("name").and_then(Value::as_str) == Some(step));
            let place = step.parse().ok().or_else(named);
            at = place.and_then(|place: usize| list.get(place));
            path += &format!("[{}]", place.map_or_else(|| step.to_owned(), |place| place.to_string()));
        } else {
            at = at.and_then(|value| value.get(step));
            path += if path.is_empty() { "" } else { "." };
            path += step;
        }
    }
    path
}

/// What stands at `path`, which [`meant`] or [`numbers`] has given.
pub fn at<'a>(case: &'a mut Value, path: &str) -> Option<&'a mut Value> {
    let mut steps = path.split(['.', '[']);
    steps.try_fold(case, |value, step| match step.strip_suffix(']') {
        Some(place) => value.get_mut(place.parse::<usize>().ok()?),
        None => value.get_mut(step),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> Value {
        let text = "title = \"t\"\n[[soil.layer]]\nname = \"clay\"\nyoung = \"60 MPa\"\n[[soil.layer]]\nyoung = 5\n[train]\ncount = 3";
        Value::Table(text.parse().unwrap())
    }

    #[test]
    fn paths_are_written_in_three_ways() {
        for written in ["soil.layer[0].young", "soil.layer.0.young", "soil.layer.clay.young"] {
            assert_eq!(meant(written, &case()), "soil.layer[0].young");
        }
        assert_eq!(meant("soil.layer.peat.young", &case()), "soil.layer[peat].young");
    }

    #[test]
    fn numbers_are_found_and_put_in() {
        let mut case = case();
        let found: Vec<(String, f64)> = numbers(&case).into_iter().collect();
        assert_eq!(
            found,
            [("soil.layer[0].young".to_owned(), 60e6), ("soil.layer[1].young".to_owned(), 5.0)]
        );
        *at(&mut case, "soil.layer[1].young").unwrap() = Value::Float(7.0);
        assert_eq!(numbers(&case)["soil.layer[1].young"], 7.0);
        assert!(at(&mut case, "soil.layer[2].young").is_none());
    }
}
