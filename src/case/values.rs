//! What may stand for numbers and tables at the door: ranges, names of library entries.

use schemars::JsonSchema;
use serde::Deserialize;

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

/// From one position, wavelength or frequency to another.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpanInput {
    /// The lower end.
    pub from: f64,
    /// The upper end.
    pub to: f64,
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
