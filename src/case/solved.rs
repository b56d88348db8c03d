//! A case answered: what every study of it leaves, before anything is drawn or written.

use super::{Case, Verification};
use crate::concern::Concern;
use crate::dataset::Attribute;
use crate::progress::Observer;
use crate::study::{Outcome, StudyError};
use thiserror::Error;

/// A study that has no answer.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{study}: {source}")]
pub struct StudyFailed {
    /// Which.
    pub study: &'static str,
    /// Why.
    pub source: StudyError,
}

/// What the studies of a case leave.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Of each study, by its name.
    pub outcomes: Vec<(&'static str, Outcome)>,
    /// What another solver says to them, where the case asks.
    pub verification: Option<Verification>,
}

impl Solved {
    /// Computes every study of `case`, a second time where it is to be verified.
    ///
    /// # Errors
    /// A study that fails, or was told to stop.
    pub fn of(case: &Case, observer: &dyn Observer) -> Result<Self, StudyFailed> {
        let failed = |study, source| StudyFailed { study, source };
        let mut outcomes: Vec<(&'static str, Outcome)> = Vec::new();
        for study in &case.studies {
            let outcome =
                study.run(&case.railway, observer).map_err(|source| failed(study.name(), source))?;
            outcomes.push((study.name(), outcome));
        }
        let verification = Verification::run(case, &mut outcomes, observer);
        if observer.cancelled() {
            let last = case.studies.last().map_or("", |study| study.name());
            return Err(failed(last, crate::progress::Cancelled.into()));
        }
        outcomes.iter_mut().for_each(|(_, outcome)| name_answers(outcome));
        Ok(Self { outcomes, verification })
    }

    /// Every concern of `case` and its studies.
    pub fn concerns(&self, case: &Case) -> Vec<Concern> {
        let found = self.outcomes.iter().flat_map(|(_, outcome)| outcome.concerns.clone());
        case.concerns.iter().cloned().chain(found).collect()
    }

    /// Attributes of all results together: what was asked, by what it was answered, and `concerns`.
    pub fn attributes(&self, case: &Case, concerns: &[Concern]) -> Vec<(String, Attribute)> {
        let mut attributes: Vec<(String, Attribute)> = vec![
            ("Conventions".into(), "CF-1.8".into()),
            ("title".into(), case.title.clone().into()),
            ("program".into(), "groundwave".into()),
            ("version".into(), env!("CARGO_PKG_VERSION").into()),
            ("solver".into(), case.railway.solver_name().into()),
            ("case_text".into(), case.text.clone().into()),
            ("case_files".into(), serde_json::json!(case.files).to_string().into()),
            ("concerns".into(), serde_json::json!(concerns).to_string().into()),
            (
                "axes".into(),
                "x along the track, positive in the direction of travel; y across it; z down; displacements and loads positive down"
                    .into(),
            ),
        ];
        if let Some(source) = &case.source {
            attributes.push(("source".into(), source.clone().into()));
        }
        attributes.extend(self.verification.as_ref().map(Verification::attributes).into_iter().flatten());
        attributes
    }
}

/// Answers among the attributes as `answer_<key>`: an attribute with the name of a dataset is taken for it, by xarray above all.
pub(super) fn name_answers(outcome: &mut Outcome) {
    let Outcome { group, answers, .. } = outcome;
    group.attributes.retain(|(name, _)| answers.iter().all(|answer| answer.key != *name));
    let named = answers.iter().map(|answer| (format!("answer_{}", answer.key), answer.value.into()));
    group.attributes.extend(named);
}
