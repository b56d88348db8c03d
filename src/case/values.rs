//! What may stand for a number at the door: speeds with units, ranges, names of library entries.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error, Visitor};
use std::borrow::Cow;
use std::fmt;

/// A speed [m/s]: a number, or text such as "250 km/h".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed(pub f64);

/// "250 km/h", "70 m/s" → m/s.
fn parse_speed(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let (number, factor) = if let Some(number) = text.strip_suffix("km/h") {
        (number, 1.0 / 3.6)
    } else if let Some(number) = text.strip_suffix("m/s") {
        (number, 1.0)
    } else {
        let unit = text.trim_start_matches(|c: char| "+-.0123456789 ".contains(c));
        return Err(format!("unknown unit of speed `{unit}`, allowed: m/s, km/h (as in \"250 km/h\")"));
    };
    let value: f64 = number
        .trim()
        .parse()
        .map_err(|_| format!("`{}` is not a number (write \"250 km/h\")", number.trim()))?;
    Ok(value * factor)
}

impl<'de> Deserialize<'de> for Speed {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Door;
        impl Visitor<'_> for Door {
            type Value = Speed;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a speed in m/s, or text such as \"250 km/h\"")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Speed, E> {
                Ok(Speed(value))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Speed, E> {
                Ok(Speed(value as f64))
            }
            fn visit_u64<E: Error>(self, value: u64) -> Result<Speed, E> {
                Ok(Speed(value as f64))
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Speed, E> {
                parse_speed(text).map(Speed).map_err(E::custom)
            }
        }
        deserializer.deserialize_any(Door)
    }
}

impl JsonSchema for Speed {
    fn schema_name() -> Cow<'static, str> {
        "Speed".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "a speed [m/s], or text such as \"250 km/h\"",
            "anyOf": [{ "type": "number" }, { "type": "string", "pattern": "^[-+0-9.eE ]+(km/h|m/s)$" }]
        })
    }
}

/// Frequencies that stand for a band each.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum Bands {
    /// The centres of the third-octave bands, exact to base ten.
    ThirdOctave,
}

/// Several values: a list, { from, to, step }, or of frequencies { from, to, bands }.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields, expecting = "a list [a, b, …] or a range { from = …, to = …, step = … }")]
#[schemars(untagged, rename = "Range_of_{T}")]
pub enum Range<T> {
    /// As listed.
    #[serde(rename = "$list")]
    List(#[schemars(length(min = 1))] Vec<T>),
    /// from, from + step, … up to `to`.
    #[serde(rename = "$table")]
    Steps {
        /// First value.
        from: T,
        /// Last value.
        to: T,
        /// Spacing.
        step: Option<T>,
        /// Instead of the spacing: centres of the bands of `from` to that of `to`.
        bands: Option<Bands>,
    },
}

/// A table, or the name of a library entry (or of a TOML file beside the case) that stands for it.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(expecting = "a table, or the name of a library entry")]
#[schemars(untagged, rename = "Named_{T}")]
pub enum Named<T> {
    /// By name.
    #[serde(rename = "$text")]
    Name(String),
    /// In full.
    #[serde(rename = "$table")]
    Table(T),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_with_units() {
        assert!((parse_speed("250 km/h").unwrap() - 69.444_444_444).abs() < 1e-6);
        assert!((parse_speed("36km/h").unwrap() - 10.0).abs() < 1e-12);
        assert_eq!(parse_speed("1e2 m/s").unwrap(), 100.0);
        assert!(parse_speed("250 mph").unwrap_err().contains("mph"));
        assert!(parse_speed("fast").is_err());
        assert!(parse_speed("250").is_err());
    }
}
