//! What a reader sees of a study: the safe numbers first, then where they come from.

use super::columns::study_group;
use super::derivative::Derivative;
use super::figures::{self, KMH};
use super::statistics::{quantile, quantile_interval, share_interval, sorted};
use super::table::Table;
use super::tables::tables;
use super::view::{CRITICAL, View};
use super::worst::Worst;
use crate::case::{Case, Uncertain};
use crate::concern::Concern;
use crate::output::ReportTable;
use crate::study::{Answer, Outcome};

/// Where the whole train moves the rail most.
const TRAIN: &str = "critical_speed.train_largest_speed";
/// Fewest samples of which the least is a lower bound of the 5 % quantile, with 95 %: 0.95ⁿ < 0.05 (Wilks 1941).
const FEW: usize = 59;

/// Everything a study says.
pub(super) struct Shown {
    pub outcome: Outcome,
    pub tables: Vec<ReportTable>,
    pub worst: Vec<Worst>,
    pub derivatives: Vec<Derivative>,
    pub correlations: Vec<(String, f64)>,
}

/// What `table` says of the study of `case`.
pub(super) fn shown(case: &Case, study: &Uncertain, table: &Table) -> Shown {
    let view = View::new(case, study, table);
    let outcome = Outcome {
        group: study_group(study, table),
        figures: view.figures(),
        answers: view.answers(),
        concerns: view.concerns(),
    };
    let tables = tables(&view);
    let View { worst, derivatives, correlations, .. } = view;
    Shown { outcome, tables, worst, derivatives, correlations }
}

fn kmh(speed: f64) -> String {
    format!("{:.0} km/h ({speed:.1} m/s)", KMH * speed)
}

/// A probability in per cent.
fn share(p: f64) -> String {
    format!("{:.1} %", 100.0 * p)
}

impl View<'_> {
    fn answers(&self) -> Vec<Answer> {
        let mut answers = Vec::new();
        let values = self.main_values();
        if self.is_critical() && self.spread() {
            answers.extend(self.critical_speeds(&values));
        }
        if let (true, Ok(central)) = (self.is_critical(), &self.table.central)
            && let Some(speed) = central.get(CRITICAL)
        {
            let what = "Critical speed of the case as it stands";
            answers.push(Answer::new("critical_speed_as_it_stands", what, *speed, "m/s", kmh(*speed)));
        }
        let count = |key: &str, what: &str, n: usize| Answer::new(key, what, n as f64, "1", n.to_string());
        answers.push(count("samples", "Samples", self.rows.samples));
        answers.push(count("refused", "Samples without an answer, left out above", self.table.refused.len()));
        answers
    }

    /// The quantile `p` of critical speeds `values`, as `what`; at an end of the range it is a bound.
    fn quantile(&self, values: &[f64], p: f64, (key, what): (&str, &str)) -> Answer {
        let (value, (low, high)) = (quantile(values, p), quantile_interval(values, p));
        let (first, last) = self.ends();
        let shown = if value <= first {
            format!("at or below {}, the lowest speed asked", kmh(value))
        } else if value >= last {
            format!("at or above {}, the highest speed asked", kmh(value))
        } else if self.drawn() {
            format!("{}, 95 %: {:.0} to {:.0} km/h", kmh(value), KMH * low, KMH * high)
        } else {
            kmh(value)
        };
        Answer::new(key, what, value, "m/s", shown)
    }

    /// Quantiles of the critical speed, the lowest first, and the probability that the line is faster.
    fn critical_speeds(&self, values: &[f64]) -> Vec<Answer> {
        if values.is_empty() {
            return Vec::new();
        }
        let at = |p: f64, key, what| self.quantile(values, p, (key, what));
        let mut answers =
            vec![at(0.05, "critical_speed_p5", "Critical speed that 5 % of the grounds stay below")];
        let train = sorted(self.table.of(TRAIN).into_iter().map(|(_, value)| value));
        if !train.is_empty() {
            let what = "Speed at which this train moves the rail most, that 5 % stay below";
            answers.push(self.quantile(&train, 0.05, ("train_largest_speed_p5", what)));
        }
        answers.extend(self.line_speed().into_iter().flat_map(|line| self.exceedance(values, line)));
        answers.push(at(0.5, "critical_speed_p50", "Critical speed that half of the grounds stay below"));
        answers.push(at(0.95, "critical_speed_p95", "Critical speed that 95 % of the grounds stay below"));
        answers
    }

    /// The share of critical speeds `values` below the `line`, and what it may be at most. A maximum at the lower end of the range counts
    /// as one below: it is nowhere above.
    fn exceedance(&self, values: &[f64], line: f64) -> Vec<Answer> {
        let hits = values.iter().filter(|value| **value < line || **value <= self.ends().0).count();
        let p = hits as f64 / values.len() as f64;
        let what = format!("Probability that the critical speed lies below the line speed, {}", kmh(line));
        if !self.drawn() {
            return vec![Answer::new("exceedance_probability", what, p, "1", share(p))];
        }
        let (low, high) = share_interval(hits, values.len());
        let shown = format!("{}, 95 %: {} to {}", share(p), share(low), share(high));
        let most = share_interval(hits + self.table.refused.len(), self.rows.samples).1;
        let at_most = "… at most, with 97.5 % confidence, samples without an answer counted in";
        vec![
            Answer::new("exceedance_probability", what, p, "1", shown),
            Answer::new("exceedance_probability_at_most", at_most, most, "1", share(most)),
        ]
    }

    fn concerns(&self) -> Vec<Concern> {
        let (mut concerns, samples) = (Vec::new(), self.rows.samples);
        if let Some((first, reason)) = self.table.refused.first() {
            let reason = reason.lines().next().unwrap_or_default();
            concerns.push(Concern::new(
                "refused-samples",
                format!("{} of {samples} samples have no answer; the first is sample {first}: {reason}", self.table.refused.len()),
                "quantiles and probabilities leave them out: where a distribution leaves the physical range, give it min and max, or one that stays inside",
            ));
        }
        // a line faster than a critical speed is what the first answers are about
        let mut all: Vec<_> =
            self.table.concerns.iter().filter(|(code, _)| *code != "line-speed-above-critical").collect();
        if !all.is_empty() {
            all.sort_by(|a, b| b.1.cmp(a.1));
            let all: Vec<String> = all.into_iter().map(|(code, n)| format!("{code} in {n}")).collect();
            concerns.push(Concern::new(
                "concerns-of-samples",
                format!("of {samples} samples: {}", all.join(", ")),
                "run one of the case files of single samples to read them; where maxima lie at the end of the range, widen critical_speed.speeds: such critical speeds are bounds only",
            ));
        }
        if self.drawn() && samples < FEW {
            concerns.push(Concern::new(
                "few-samples",
                format!("{samples} samples: of fewer than {FEW} not even the least is surely below the 5 % quantile"),
                "take more samples",
            ));
        }
        if let Err(reason) = &self.table.central {
            let reason = reason.lines().next().unwrap_or_default();
            concerns.push(Concern::new(
                "no-central-case",
                format!("the case as it stands has no answer: {reason}"),
                "run it by itself",
            ));
        }
        concerns
    }

    fn figures(&self) -> Vec<figures::Shown> {
        let (label, scale) = self.label();
        let values = self.main_values();
        let mut marks = Vec::new();
        if self.is_critical() {
            marks.extend(
                self.line_speed().map(|line| (KMH * line, format!("line speed {:.0} km/h", KMH * line))),
            );
            if self.spread() {
                let low = KMH * quantile(&values, 0.05);
                marks.push((low, format!("5 % {low:.0} km/h")));
            }
        }
        let about =
            if self.is_critical() { "the critical speed" } else { self.main.as_deref().unwrap_or_default() };
        let mut all = Vec::new();
        if self.spread() {
            let histogram = figures::histogram(&values, (&label, scale), marks.clone());
            all.extend(histogram);
            let title = "Rail deflection against speed, of all samples";
            all.extend(figures::fan(self.table, "critical_speed/max_down", title, &marks));
            let title = "Rail deflection under the heaviest axle alone, of all samples";
            all.extend(figures::fan(self.table, "critical_speed/single_axle_max_down", title, &marks));
        }
        all.extend(figures::correlations(&self.correlations, about));
        all.extend(figures::swings(&self.swings(), (&label, scale)));
        all.extend(figures::derivatives(&self.derivatives, about));
        let first = self
            .correlations
            .first()
            .and_then(|(key, _)| self.study.varied.iter().position(|v| v.key == *key));
        if let (Some(j), Some(main)) = (first, &self.main) {
            let varied = &self.study.varied[j];
            let x_label =
                format!("{} [{}]", varied.key, if varied.unit.is_empty() { "-" } else { varied.unit });
            all.push(figures::scatter(self.table, (j, &x_label), (main, &label, scale), &self.worst));
        }
        all
    }
}
