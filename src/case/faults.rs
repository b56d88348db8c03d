//! Every fault of a document at once: what does not fit is told, cut out, and what is left read again.

use super::error::{CaseError, Finding, syntax};
use super::read::of_table;
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// What a text says.
pub struct Read<T> {
    /// Without the spoilt tables; none where nothing can be said.
    pub said: Option<T>,
    /// Keys of the document itself that hold a fault, or are meant by misspelt ones: not to be judged further.
    pub spoilt: BTreeSet<String>,
    /// Each fault.
    pub faults: Vec<CaseError>,
}

/// Reads the TOML `read`, of which the user has written `text` in the file `name`, and which stands for the table `root` of a case
/// (empty for a whole one); `stand_in` is a key of the document, and text for it that lets the rest be read where it is missing.
pub fn read<T: DeserializeOwned>(
    read: &str,
    (name, text): (&str, &str),
    root: &str,
    stand_in: Option<(&str, &str)>,
) -> Read<T> {
    let (mut said, mut spoilt, mut faults) = (None, BTreeSet::new(), Vec::new());
    let mut document = match DeTable::parse(read) {
        Ok(document) => document.into_inner(),
        Err(error) => {
            faults.push(syntax(&error, name, text));
            return Read { said, spoilt, faults };
        }
    };
    let mut cuts = Cuts::default();
    while let Err(mut finding) = of_table(&document, root).map(|all| said = Some(all)) {
        let steps = steps(&finding.path);
        finding.path = cuts.original(&steps);
        let first = steps.first().map_or(String::new(), |step| step.name.clone());
        if !cuts.explain(&finding) {
            faults.push(finding.clone().at(name, text));
        }
        if first.is_empty() {
            match stand_in.filter(|(key, _)| finding.lacks() == Some(key)) {
                Some((key, value)) => set(&mut document, key, value),
                None => break,
            }
            continue;
        }
        if finding.on_key() && steps.len() == 1 {
            spoilt.extend(finding.wanted.map(str::to_owned));
        }
        cuts.cut(&mut document, &steps, &finding);
        spoilt.insert(first);
    }
    if said.is_some() && !spoilt.is_empty() {
        for key in &spoilt {
            document.remove(key.as_str());
        }
        if let Some((key, value)) = stand_in.filter(|(key, _)| spoilt.contains(*key)) {
            set(&mut document, key, value);
        }
        said = of_table(&document, root).ok();
    }
    Read { said, spoilt, faults }
}

/// The same of a file that stands for the table `root`.
///
/// # Errors
/// Its faults.
pub fn whole<T: DeserializeOwned>(text: &str, name: &str, root: &str) -> Result<T, CaseError> {
    match read(text, (name, text), root, None) {
        Read { said: Some(said), faults, .. } if faults.is_empty() => Ok(said),
        Read { faults, .. } => Err(CaseError::all(faults, name)),
    }
}

fn set<'i>(document: &mut DeTable<'i>, key: &'i str, value: &'i str) {
    let value = DeValue::String(Cow::Borrowed(value));
    document.insert(Spanned::new(0..0, Cow::Borrowed(key)), Spanned::new(0..0, value));
}

/// A key, or a place in a list.
struct Step {
    name: String,
    place: Option<usize>,
}

/// The steps of a path such as `soil.layer[1].young`.
fn steps(path: &str) -> Vec<Step> {
    let step = |text: &str| {
        let place = text.strip_suffix(']').and_then(|place| place.parse().ok());
        Step { name: text.trim_end_matches(']').to_owned(), place }
    };
    path.split(['.', '[']).filter(|text| !text.is_empty()).map(step).collect()
}

/// What was cut out of a document.
#[derive(Default)]
struct Cuts {
    /// Path of each cut, and the key that was probably meant.
    made: Vec<(String, Option<&'static str>)>,
    /// How many items are gone from the beginning of a list, by its path.
    gone: BTreeMap<String, usize>,
}

impl Cuts {
    /// The path of `steps` in the document as it was written.
    fn original(&self, steps: &[Step]) -> String {
        steps.iter().fold(String::new(), |path, step| match step.place {
            Some(place) => format!("{path}[{}]", place + self.gone.get(&path).unwrap_or(&0)),
            None if path.is_empty() => step.name.clone(),
            None => format!("{path}.{}", step.name),
        })
    }

    /// Whether `finding` only says that something is missing, or not right, where something was cut out.
    fn explain(&self, finding: &Finding) -> bool {
        // keys that stand for others of their table
        const INSTEAD: [&str; 2] = ["element", "section"];
        self.made.iter().any(|(path, meant)| {
            let (table, key) = path.rsplit_once('.').unwrap_or(("", path));
            let lacks = finding.lacks();
            let lost = |lacks| lacks == key || *meant == Some(lacks) || INSTEAD.contains(&key);
            table == finding.path && lacks.is_none_or(lost)
        })
    }

    /// Cuts what stands at `steps` of `document`, or the least that holds it.
    fn cut(&mut self, document: &mut DeTable, steps: &[Step], finding: &Finding) {
        self.made.push((finding.path.clone(), finding.wanted));
        for length in (1..=steps.len()).rev() {
            if self.cut_table(document, &steps[..length], String::new()) {
                return;
            }
        }
    }

    fn cut_table(&mut self, table: &mut DeTable, steps: &[Step], path: String) -> bool {
        let Some((step, rest)) = steps.split_first() else { return false };
        let path = if path.is_empty() { step.name.clone() } else { format!("{path}.{}", step.name) };
        match (table.get_mut(step.name.as_str()), rest) {
            (Some(_), []) => table.remove(step.name.as_str()).is_some(),
            (Some(value), rest) => self.cut_value(value.get_mut(), rest, path),
            (None, _) => false,
        }
    }

    fn cut_value(&mut self, value: &mut DeValue, steps: &[Step], path: String) -> bool {
        match value {
            DeValue::Table(table) => self.cut_table(table, steps, path),
            DeValue::Array(list) => {
                let Some((Step { place: Some(place), .. }, rest)) = steps.split_first() else { return false };
                let Some(item) = list.get_mut(*place) else { return false };
                let at = place + self.gone.get(&path).unwrap_or(&0);
                if !rest.is_empty() {
                    return self.cut_value(item.get_mut(), rest, format!("{path}[{at}]"));
                }
                // those before it are read, and sound
                self.gone.insert(path, at + 1);
                *list = std::mem::replace(list, DeArray::new()).into_iter().skip(place + 1).collect();
                true
            }
            _ => false,
        }
    }
}
