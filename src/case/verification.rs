//! Every study answered a second time by another solver, and what that leaves in each output.

use super::Case;
use crate::concern::Concern;
use crate::dataset::Attribute;
use crate::output::ReportTable;
use crate::progress::Observer;
use crate::railway::Railway;
use crate::study::Outcome;
use crate::study::comparison::{Comparison, Difference};
use serde_json::{Map, Value};

/// What a second solver says to the answers of the first.
#[derive(Clone, Debug)]
pub struct Verification {
    /// Name of the second solver.
    pub solver: &'static str,
    /// Both compared, by study.
    pub studies: Vec<(&'static str, Comparison)>,
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
    fn end(&self) {
        self.0.end();
    }
}

impl Verification {
    /// Runs every study of `case` for its `witness` and compares; what is to be doubted joins the `outcomes`. A study that the
    /// second solver cannot answer is a concern, not a failure: the first answer stands.
    pub(super) fn run(
        case: &Case,
        witness: &Railway,
        outcomes: &mut [(&'static str, Outcome)],
        observer: &dyn Observer,
    ) -> Self {
        let (first, solver) = (case.railway.solver_name(), witness.solver_name());
        let mut studies = Vec::new();
        for (study, (name, outcome)) in case.studies.iter().zip(outcomes) {
            let comparison = match study.run(witness, &Verifying(observer)) {
                Ok(second) => {
                    let comparison = Comparison::new(outcome, &second);
                    let known: Vec<&str> = outcome.concerns.iter().map(|c| c.code).collect();
                    let new = second.concerns.into_iter().filter(|c| !known.contains(&c.code));
                    outcome.concerns.extend(new.map(|c| Concern {
                        message: format!("verifying with {solver}: {}", c.message),
                        ..c
                    }));
                    comparison
                }
                Err(error) => {
                    observer.end();
                    Comparison::none(error.to_string())
                }
            };
            outcome.concerns.extend(comparison.concerns(name, first, solver));
            studies.push((*name, comparison));
        }
        Self { solver, studies }
    }

    /// The largest relative difference of all; None if nothing could be compared.
    pub fn largest(&self) -> Option<f64> {
        self.studies.iter().filter_map(|(_, c)| c.largest()).map(|d| d.relative).reduce(f64::max)
    }

    /// `verification` of `summary.json`: relative differences by study, dataset and answer.
    pub(super) fn json(&self) -> Value {
        let mut root = Map::new();
        root.insert("solver".into(), self.solver.into());
        if let Some(largest) = self.largest() {
            root.insert("largest".into(), largest.into());
        }
        let relative = |all: &[Difference]| -> Map<String, Value> {
            all.iter().map(|d| (d.name.clone(), d.relative.into())).collect()
        };
        for (study, comparison) in &self.studies {
            let mut of = Map::new();
            of.insert("datasets".into(), relative(&comparison.datasets).into());
            of.insert("answers".into(), relative(&comparison.answers).into());
            if !comparison.skipped.is_empty() {
                of.insert("not_compared".into(), comparison.skipped.clone().into());
            }
            root.insert((*study).into(), of.into());
        }
        root.into()
    }

    /// Root attributes of `results.h5`.
    pub(super) fn attributes(&self) -> Vec<(String, Attribute)> {
        let mut all: Vec<(String, Attribute)> = vec![("verified_with".into(), self.solver.into())];
        all.extend(self.largest().map(|d| ("verification_largest_difference".into(), d.into())));
        all.extend(
            self.studies.iter().map(|(study, c)| (format!("verification_{study}"), c.to_string().into())),
        );
        all
    }

    /// The table of the report.
    pub(super) fn table(&self) -> ReportTable {
        let row = |study: &str, name: String, d: &Difference| {
            let unit = if d.unit == "1" { String::new() } else { format!(" {}", d.unit) };
            let number = |x: f64| if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") };
            vec![study.to_owned(), name, number(d.absolute) + &unit, number(d.relative)]
        };
        let mut rows = Vec::new();
        for (study, comparison) in &self.studies {
            rows.extend(comparison.datasets.iter().map(|d| row(study, d.name.clone(), d)));
            rows.extend(comparison.answers.iter().map(|d| row(study, format!("answer {}", d.name), d)));
            let skipped = comparison.skipped.iter();
            rows.extend(
                skipped.map(|s| vec![(*study).to_owned(), s.clone(), "not compared".into(), String::new()]),
            );
        }
        let header = ["study", "quantity", "largest difference", "relative to the largest value of its kind"];
        ReportTable {
            title: format!("Verification with {}", self.solver),
            header: header.map(str::to_owned).to_vec(),
            rows,
        }
    }
}
