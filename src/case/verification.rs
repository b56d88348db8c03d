//! Every study answered a second time, by another solver of the ground or another method for the rail, and what that leaves in each
//! output.

use super::Case;
use crate::concern::Concern;
use crate::dataset::Attribute;
use crate::output::ReportTable;
use crate::progress::Observer;
use crate::railway::Railway;
use crate::study::comparison::{Comparison, Difference};
use crate::study::{Outcome, Study, StudyError};
use serde_json::{Map, Value};

/// What second answers say to the first.
#[derive(Clone, Debug, Default)]
pub struct Verification {
    /// Both compared, by study.
    pub studies: Vec<Verified>,
}

/// A study answered twice.
#[derive(Clone, Debug)]
pub struct Verified {
    /// Its name.
    pub study: &'static str,
    /// Name of the solver, or of the method, that answered second.
    pub solver: &'static str,
    /// Both compared.
    pub comparison: Comparison,
}

/// Tells of the second run as such.
struct Verifying<'a>(&'a dyn Observer);

impl Observer for Verifying<'_> {
    fn begin(&self, what: &str, steps: u64) {
        self.0.begin(&format!("verifying {what}"), steps);
    }
    fn advance(&self) {
        self.0.advance();
    }
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
    fn end(&self) {
        self.0.end();
    }
}

impl Verification {
    /// Runs every study of `case` once more for its witness, and where it names a second method by that, and compares; what is to be
    /// doubted joins the `outcomes`. A study that has no second answer is a concern, not a failure: the first stands. None where
    /// nothing is to be verified.
    pub(super) fn run(
        case: &Case,
        outcomes: &mut [(&'static str, Outcome)],
        observer: &dyn Observer,
    ) -> Option<Self> {
        let mut all = Self::default();
        for (study, (name, outcome)) in case.studies.iter().zip(outcomes) {
            let mut compare = |study: &Study, railway: &Railway, [first, second]: [&'static str; 2]| {
                let second_answer = study.run(railway, &Verifying(observer));
                if second_answer.is_err() {
                    observer.end();
                }
                let comparison = compared(outcome, second_answer, second);
                outcome.concerns.extend(comparison.concerns(name, first, second));
                all.studies.push(Verified { study: name, solver: second, comparison });
            };
            if let Some(witness) = &case.witness {
                compare(study, witness, [case.railway.solver_name(), witness.solver_name()]);
            }
            if let Some((second, methods)) = study.witness(&case.railway) {
                compare(&second, &case.railway, methods);
            }
        }
        (!all.studies.is_empty()).then_some(all)
    }

    /// The largest relative difference of all; None if nothing could be compared.
    pub fn largest(&self) -> Option<f64> {
        self.studies.iter().filter_map(|v| v.comparison.largest()).map(|d| d.relative).reduce(f64::max)
    }

    /// Key of each: its study, and with the second answerer where the study was answered before.
    fn keyed(&self) -> impl Iterator<Item = (String, &Verified)> {
        self.studies.iter().enumerate().map(|(i, v)| {
            let again = self.studies[..i].iter().any(|before| before.study == v.study);
            (if again { format!("{}_{}", v.study, v.solver) } else { v.study.to_owned() }, v)
        })
    }

    /// Names of the solvers and methods that answered second.
    pub fn solver(&self) -> String {
        let mut names: Vec<&str> = self.studies.iter().map(|verified| verified.solver).collect();
        names.dedup();
        names.join(", ")
    }

    /// `verification` of `summary.json`: relative differences by study, dataset and answer.
    pub fn json(&self) -> Value {
        let mut root = Map::new();
        root.insert("solver".into(), self.solver().into());
        if let Some(largest) = self.largest() {
            root.insert("largest".into(), largest.into());
        }
        let relative = |all: &[Difference]| -> Map<String, Value> {
            all.iter().map(|d| (d.name.clone(), d.relative.into())).collect()
        };
        for (study, Verified { comparison, .. }) in self.keyed() {
            let mut of = Map::new();
            of.insert("datasets".into(), relative(&comparison.datasets).into());
            of.insert("answers".into(), relative(&comparison.answers).into());
            if !comparison.skipped.is_empty() {
                of.insert("not_compared".into(), comparison.skipped.clone().into());
            }
            root.insert(study, of.into());
        }
        root.into()
    }

    /// Root attributes of `results.h5`.
    pub fn attributes(&self) -> Vec<(String, Attribute)> {
        let mut all: Vec<(String, Attribute)> = vec![("verified_with".into(), self.solver().into())];
        all.extend(self.largest().map(|d| ("verification_largest_difference".into(), d.into())));
        all.extend(
            self.keyed().map(|(study, v)| (format!("verification_{study}"), v.comparison.to_string().into())),
        );
        all
    }

    /// The table of the report.
    pub fn table(&self) -> ReportTable {
        let row = |study: &str, name: String, d: &Difference| {
            let unit = if d.unit == "1" { String::new() } else { format!(" {}", d.unit) };
            let number = |x: f64| if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") };
            vec![study.to_owned(), name, number(d.absolute) + &unit, number(d.relative)]
        };
        let mut rows = Vec::new();
        for Verified { study, comparison, .. } in &self.studies {
            rows.extend(comparison.datasets.iter().map(|d| row(study, d.name.clone(), d)));
            rows.extend(comparison.answers.iter().map(|d| row(study, format!("answer {}", d.name), d)));
            let skipped = comparison.skipped.iter();
            rows.extend(
                skipped.map(|s| vec![(*study).to_owned(), s.clone(), "not compared".into(), String::new()]),
            );
        }
        let header = ["study", "quantity", "largest difference", "relative to the largest value of its kind"];
        ReportTable {
            title: format!("Verification with {}", self.solver()),
            header: header.map(str::to_owned).to_vec(),
            rows,
        }
    }
}

/// The first answer beside the second, whose concerns join it.
fn compared(outcome: &mut Outcome, second: Result<Outcome, StudyError>, solver: &str) -> Comparison {
    match second {
        Ok(second) => {
            let comparison = Comparison::new(outcome, &second);
            let known: Vec<&str> = outcome.concerns.iter().map(|c| c.code).collect();
            let new = second.concerns.into_iter().filter(|c| !known.contains(&c.code));
            outcome.concerns.extend(
                new.map(|c| Concern { message: format!("verifying with {solver}: {}", c.message), ..c }),
            );
            comparison
        }
        Err(error) => Comparison::none(error.to_string()),
    }
}
