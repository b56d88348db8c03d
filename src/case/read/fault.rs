//! What of a document does not fit the type that is read, and where.

use super::{KIND, REST};
use crate::case::error::{Finding, nearest, spelling};
use crate::case::units::Misread;
use crate::quantity::KEY_ENDS;
use serde::de::{Error, Expected, Unexpected};
use std::borrow::Cow;
use std::fmt;

/// What does not fit.
#[derive(Debug)]
pub enum What {
    /// A key that is not there to be had.
    Key { found: String, allowed: Vec<&'static str> },
    /// A name among other names.
    Name { found: String, allowed: Vec<&'static str> },
    /// A key that is needed, and what it may be.
    Missing { key: &'static str, allowed: Vec<&'static str> },
    /// Anything else, in words, with advice.
    Other(String, Option<Cow<'static, str>>),
}

/// What does not fit, and where.
#[derive(Debug)]
pub struct Fault {
    /// Below the value in hand.
    pub path: String,
    /// The `kind` of the table it stands in.
    pub kind: Option<String>,
    pub what: What,
}

impl Fault {
    pub fn new(what: What) -> Self {
        Self { path: String::new(), kind: None, what }
    }

    pub fn wrong(found: impl fmt::Display, wanted: impl fmt::Display) -> Self {
        Self::new(What::Other(format!("found {found}, wanted {wanted}"), None))
    }

    /// A text that is not the number wanted.
    pub fn misread((message, help): Misread) -> Self {
        Self::new(What::Other(message, Some(help.into())))
    }

    /// The same with advice.
    pub fn help(mut self, advice: impl Into<Cow<'static, str>>) -> Self {
        if let What::Other(_, help) = &mut self.what {
            *help = Some(advice.into());
        }
        self
    }

    /// The same, seen from the table that has `key`.
    pub fn below(mut self, key: &str) -> Self {
        self.path = join(key, &self.path);
        self
    }

    /// The same, if it is one of the table in hand, as one of its `kind`.
    pub fn of(mut self, kind: &str) -> Self {
        if self.path.is_empty() && self.kind.is_none() && !kind.starts_with('$') {
            self.kind = Some(kind.to_owned());
        }
        self
    }

    /// The same, where the table has the `keys` besides those it knows.
    pub fn beside_keys(mut self, keys: &[&'static str]) -> Self {
        match &mut self.what {
            What::Key { allowed, .. } if self.path.is_empty() => allowed.extend(plain(keys)),
            _ => {}
        }
        self
    }

    /// The same, where `kind` may be one of `kinds` besides those it knows.
    pub fn beside_kinds(mut self, kinds: &[&'static str]) -> Self {
        match &mut self.what {
            What::Name { allowed, .. } if self.path == KIND => allowed.extend(plain(kinds)),
            _ => {}
        }
        self
    }

    /// The same in the words of this program.
    pub fn finding(self) -> Finding {
        match self.what {
            What::Key { found, allowed } => {
                let of = self.kind.map_or(String::new(), |kind| format!(" of kind = \"{kind}\""));
                let path = if self.path.is_empty() { found.clone() } else { join(&self.path, &found) };
                let help = if allowed.is_empty() { "remove it".into() } else { spelling(&found, &allowed) };
                let finding = Finding::new(path, format!("unknown key `{found}`{of}")).help(help);
                finding.of_key(nearest(&found, &allowed))
            }
            What::Name { found, allowed } => {
                Finding::new(self.path, format!("unknown value \"{found}\"")).help(spelling(&found, &allowed))
            }
            What::Missing { key, allowed } => {
                let by = self.kind.map_or(String::new(), |kind| format!(", needed by kind = \"{kind}\""));
                let of = if allowed.is_empty() { String::new() } else { format!(": {}", allowed.join(", ")) };
                Finding::new(self.path, format!("missing key `{key}`{by}"))
                    .help(format!("add `{key} = …`{of}"))
                    .lacking(key)
            }
            What::Other(message, help) => {
                let finding = Finding::new(self.path, message);
                match help {
                    Some(help) => finding.help(help.into_owned()),
                    None => finding,
                }
            }
        }
    }
}

/// The path of `rest` below `key`, either of which may be empty.
pub fn join(key: &str, rest: &str) -> String {
    match rest {
        "" => key.to_owned(),
        rest if key.is_empty() => rest.to_owned(),
        rest if rest.starts_with('[') => format!("{key}{rest}"),
        rest => format!("{key}.{rest}"),
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {:?}", self.path, self.what)
    }
}

impl std::error::Error for Fault {}

/// A value in plain words.
pub fn words(found: Unexpected) -> String {
    match found {
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Unsigned(value) => format!("the number {value}"),
        Unexpected::Signed(value) => format!("the number {value}"),
        Unexpected::Float(value) => format!("the number {value}"),
        Unexpected::Str(text) => format!("the text \"{text}\""),
        Unexpected::Seq => "a list".into(),
        Unexpected::Map => "a table".into(),
        other => other.to_string(),
    }
}

impl Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        // `{:#}` puts the key in front of what a constructor refuses
        let text = format!("{message:#}");
        match text.split_once(KEY_ENDS) {
            Some((key, message)) => Self::new(What::Other(message.to_owned(), None)).below(key),
            None => Self::new(What::Other(text, None)),
        }
    }
    fn invalid_type(found: Unexpected, wanted: &dyn Expected) -> Self {
        Self::wrong(words(found), wanted)
    }
    fn invalid_value(found: Unexpected, wanted: &dyn Expected) -> Self {
        Self::wrong(words(found), wanted)
    }
    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(What::Name { found: found.to_owned(), allowed: plain(allowed) })
    }
    fn unknown_field(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(What::Key { found: found.to_owned(), allowed: plain(allowed) })
    }
    fn missing_field(key: &'static str) -> Self {
        let key = match key.strip_prefix(REST) {
            Some("") => KIND,
            Some(needed) => needed.trim_start_matches(':'),
            None => key,
        };
        Self::new(What::Missing { key, allowed: Vec::new() })
    }
}

/// Names that a file may say.
pub fn plain(names: &[&'static str]) -> Vec<&'static str> {
    names.iter().copied().filter(|name| !name.starts_with('$')).collect()
}

#[cfg(test)]
mod tests {
    use super::super::of_table;
    use serde::Deserialize;
    use toml::de::DeTable;

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(deny_unknown_fields)]
    struct Case {
        shape: Vec<Beside>,
    }

    #[derive(Debug, Deserialize, PartialEq)]
    struct Beside {
        name: Option<String>,
        #[serde(rename = "$rest")]
        shape: Shape,
    }

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(rename_all = "kebab-case", deny_unknown_fields)]
    enum Shape {
        Point,
        Circle {
            radius: f64,
        },
        Several(Inner),
        #[serde(rename = "$other")]
        Other(Solid),
    }

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(deny_unknown_fields)]
    struct Inner {
        sides: Count,
        count: u8,
    }

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(rename_all = "kebab-case", deny_unknown_fields)]
    enum Solid {
        Cube { edge: f64 },
    }

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(expecting = "a list, or a table with `from` and `to`", deny_unknown_fields)]
    enum Count {
        #[serde(rename = "$list")]
        List(Vec<u8>),
        #[serde(rename = "$table")]
        Range { from: u8, to: u8 },
    }

    fn reading(text: &str) -> Result<Case, (String, String, Option<String>)> {
        let table = DeTable::parse(text).unwrap();
        of_table(table.get_ref(), "").map_err(|f| (f.path, f.message, f.help))
    }

    #[test]
    fn reads_what_is_there() {
        let text = "[[shape]]\nkind = \"point\"\n[[shape]]\nname = \"a\"\nkind = \"circle\"\nradius = 1\n[[shape]]\n\
                    kind = \"several\"\nsides = [3, 4]\ncount = 2\n[[shape]]\nkind = \"cube\"\nedge = 0.5\n";
        let shapes = reading(text).unwrap().shape;
        let of = |i: usize| &shapes[i].shape;
        assert_eq!(*of(0), Shape::Point);
        assert_eq!((of(1), shapes[1].name.as_deref()), (&Shape::Circle { radius: 1.0 }, Some("a")));
        assert_eq!(*of(2), Shape::Several(Inner { sides: Count::List(vec![3, 4]), count: 2 }));
        assert_eq!(*of(3), Shape::Other(Solid::Cube { edge: 0.5 }));
    }

    #[test]
    fn every_fault_at_its_key() {
        let several = "kind = \"several\"\ncount = 1\nsides";
        for (text, path, message, help) in [
            ("kind = \"circle\"\nradius = \"1\"", "shape[0].radius", "text \"1\", wanted a number", ""),
            (
                "kind = \"circle\"",
                "shape[0]",
                "missing key `radius`, needed by kind = \"circle\"",
                "radius = …",
            ),
            (
                "kind = \"circle\"\nradius = 1\nraduis = 1",
                "shape[0].raduis",
                "unknown key `raduis` of kind = \"circle\"",
                "did you mean `radius`? allowed: radius, name",
            ),
            (
                "kind = \"point\"\nsize = 1",
                "shape[0].size",
                "unknown key `size` of kind = \"point\"",
                "allowed: name",
            ),
            (
                "kind = \"circel\"",
                "shape[0].kind",
                "unknown value \"circel\"",
                "did you mean `circle`? allowed: cube, point, circle, several",
            ),
            ("radius = 1", "shape[0]", "missing key `kind`", "point, circle, several"),
            ("kind = 3", "shape[0].kind", "found the number 3, wanted one of point", ""),
            ("kind = \"cube\"\nedge = true", "shape[0].edge", "found true, wanted a number", ""),
            (&format!("{several} = [1, -2]"), "shape[0].sides[1]", "found the number -2", ""),
            (&format!("{several} = [1, 300]"), "shape[0].sides[1]", "from 0 to 255", ""),
            (&format!("{several} = 3"), "shape[0].sides", "wanted a list, or a table with `from`", ""),
            (
                &format!("{several} = {{ from = 1, two = 2 }}"),
                "shape[0].sides.two",
                "unknown key `two`",
                "from, to",
            ),
        ] {
            let (at, said, advice) = reading(&format!("[[shape]]\n{text}\n")).unwrap_err();
            assert_eq!(at, path, "{text}: {said}");
            assert!(said.contains(message), "{text}: {said}");
            assert!(advice.unwrap_or_default().contains(help), "{text}: {said}");
        }
        assert_eq!(reading("shape = 1").unwrap_err().0, "shape");
        assert_eq!(reading("shap = []").unwrap_err().1, "unknown key `shap`");
    }
}
