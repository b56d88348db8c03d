//! One row of a study: a case, and what its questions answer.

use crate::case::Case;
use crate::progress::Observer;
use crate::study::Outcome;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Curves over these are kept; histories and maps are too much for thousands of samples.
const OVER: [&str; 3] = ["speed", "frequency", "band"];

/// What a number or a curve is.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Described {
    /// SI unit.
    pub unit: String,
    /// In words; empty of an answer, whose words may hold numbers of its sample.
    pub what: String,
    /// Of a curve: its coordinate.
    pub over: Option<String>,
}

/// What a row has left. Numbers that are none are gaps.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Row {
    /// Its number.
    pub number: usize,
    /// The numbers that vary [SI]; empty of a step.
    pub values: Vec<f64>,
    /// Why there are no answers, where there are none.
    pub refused: Option<String>,
    /// Answers [SI] by `<study>.<key>`.
    pub answers: BTreeMap<String, Option<f64>>,
    /// Arrays along one dimension by `<study>/<name>`, their coordinates among them.
    pub curves: BTreeMap<String, Vec<Option<f64>>>,
    /// Codes of the concerns.
    pub concerns: Vec<String>,
}

/// Listens for a call to stop, and to nothing else.
struct Quiet<'a>(&'a dyn Observer);

impl Observer for Quiet<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

/// A number, if it is one.
fn number(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

impl Row {
    /// Takes what `study` has found, and tells `described` what it is.
    fn take(&mut self, study: &str, outcome: &Outcome, described: &mut BTreeMap<String, Described>) {
        for answer in &outcome.answers {
            let name = format!("{study}.{}", answer.key);
            described
                .insert(name.clone(), Described { unit: answer.unit.to_owned(), ..Described::default() });
            self.answers.insert(name, number(answer.value));
        }
        let kept = |over: &String| OVER.contains(&over.as_str());
        for variable in outcome.group.variables.iter().filter(|v| v.dims.len() == 1 && kept(&v.dims[0])) {
            let name = format!("{study}/{}", variable.name);
            let of = Described {
                unit: variable.units.clone(),
                what: variable.long_name.clone(),
                over: Some(format!("{study}/{}", variable.dims[0])),
            };
            described.insert(name.clone(), of);
            self.curves.insert(name, variable.values.iter().copied().map(number).collect());
        }
        self.concerns.extend(outcome.concerns.iter().map(|concern| concern.code.to_owned()));
    }

    /// Runs every question of the case `text`, whose files are those of `whole`. None where it is told to stop.
    pub(super) fn run(
        (number, values, text): (usize, Vec<f64>, &str),
        whole: &Case,
        described: &mut BTreeMap<String, Described>,
        observer: &dyn Observer,
    ) -> Option<Self> {
        let mut row = Self { number, values, ..Self::default() };
        let open =
            |name: &str| whole.files.get(name).cloned().ok_or_else(|| "not stored with the study".to_owned());
        let case = match Case::parse(text, "the sample", &open) {
            Ok(case) => case,
            Err(error) => return Some(Self { refused: Some(error.to_string()), ..row }),
        };
        row.concerns.extend(case.concerns.iter().map(|concern| concern.code.to_owned()));
        for study in &case.studies {
            let quiet = Quiet(observer);
            // one ground in ten thousand that meets a fault of the program must not end the others
            let solved = catch_unwind(AssertUnwindSafe(|| study.run(&case.railway, &quiet)));
            let reason = match solved {
                Ok(Ok(outcome)) => {
                    row.take(study.name(), &outcome, described);
                    continue;
                }
                Ok(Err(error)) if error.is_cancelled() => return None,
                Ok(Err(error)) => error.to_string(),
                Err(_) => "a fault of the program: please report it with the case of this sample".to_owned(),
            };
            return Some(Self {
                refused: Some(format!("{}: {reason}", study.name())),
                number,
                values: row.values,
                ..Self::default()
            });
        }
        Some(row)
    }
}
