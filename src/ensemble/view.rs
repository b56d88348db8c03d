//! A study seen from its main answer: the critical speed where there is one.

use super::derivative::{Derivative, derivatives};
use super::figures::KMH;
use super::rows::Rows;
use super::statistics::{rank_correlation, sorted};
use super::table::Table;
use super::worst::{Worst, worst};
use crate::case::{Case, Uncertain, Varied};
use crate::sampling::SamplingMethod;
use crate::study::{CriticalSpeed, Study};

/// The answer a study with a speed curve is about.
pub(super) const CRITICAL: &str = "critical_speed.critical_speed";

/// One study, and what its numbers say of the main answer.
pub(super) struct View<'a> {
    pub case: &'a Case,
    pub study: &'a Uncertain,
    pub table: &'a Table,
    pub rows: Rows,
    /// Main answer, where there is one.
    pub main: Option<String>,
    /// Rank correlation of everything that varies with it, the largest first.
    pub correlations: Vec<(String, f64)>,
    /// Its derivatives, the largest first.
    pub derivatives: Vec<Derivative>,
    /// The samples that matter most.
    pub worst: Vec<Worst>,
}

impl<'a> View<'a> {
    /// The study of `case` with all rows in `table`.
    pub fn new(case: &'a Case, study: &'a Uncertain, table: &'a Table) -> Self {
        let first = || {
            let asked = case.studies.first().map_or("", Study::name);
            table.answers.keys().find(|key| key.starts_with(asked)).or(table.answers.keys().next()).cloned()
        };
        let main = if table.answers.contains_key(CRITICAL) { Some(CRITICAL.to_owned()) } else { first() };
        let (correlations, derivatives, worst) = (Vec::new(), Vec::new(), Vec::new());
        let mut view =
            Self { case, study, table, rows: Rows::of(study), main, correlations, derivatives, worst };
        view.correlations = view.correlated();
        if let Some(main) = &view.main {
            view.derivatives = self::derivatives(table, &study.parameters, main);
            view.worst = self::worst(table, main, view.is_critical());
        }
        view
    }

    pub fn is_critical(&self) -> bool {
        self.main.as_deref() == Some(CRITICAL)
    }

    /// Whether shares of samples are probabilities with an error of drawing.
    pub fn drawn(&self) -> bool {
        matches!(self.study.design.method(), SamplingMethod::MonteCarlo | SamplingMethod::LatinHypercube)
    }

    /// The question for the speed curve.
    fn asked(&self) -> Option<&CriticalSpeed> {
        self.case.studies.iter().find_map(|study| match study {
            Study::CriticalSpeed(study) => Some(study),
            _ => None,
        })
    }

    /// The speed of the line [m/s].
    pub fn line_speed(&self) -> Option<f64> {
        self.asked()?.line_speed
    }

    /// The lowest and the highest speed asked [m/s]: a critical speed there is a bound, not a maximum.
    pub fn ends(&self) -> (f64, f64) {
        let speeds = self.asked().map_or(&[][..], |asked| &asked.speeds);
        let end = |speed: Option<&f64>, none| speed.copied().unwrap_or(none);
        (end(speeds.first(), f64::NEG_INFINITY), end(speeds.last(), f64::INFINITY))
    }

    /// The values of the main answer, ascending.
    pub fn main_values(&self) -> Vec<f64> {
        let of = self.main.as_ref().map_or_else(Vec::new, |main| self.table.of(main));
        sorted(of.into_iter().map(|(_, value)| value))
    }

    /// Whether shares of samples mean anything: not where one number moves at a time.
    pub fn spread(&self) -> bool {
        self.study.design.method() != SamplingMethod::OneAtATime
    }

    /// Rank correlation of everything that varies with the main answer, the largest first.
    fn correlated(&self) -> Vec<(String, f64)> {
        let Some(main) = self.main.as_ref().filter(|_| self.spread()) else {
            return Vec::new();
        };
        let of = self.table.of(main);
        let y: Vec<f64> = of.iter().map(|(_, value)| *value).collect();
        let one = |(j, varied): (usize, &Varied)| {
            let x: Vec<f64> = of.iter().map(|(i, _)| self.table.values[*i][j]).collect();
            Some((varied.key.clone(), rank_correlation(&x, &y)?))
        };
        let mut all: Vec<(String, f64)> = self.study.varied.iter().enumerate().filter_map(one).collect();
        all.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        all
    }

    /// Label of the main answer, with unit, and what of its SI value is drawn.
    pub fn label(&self) -> (String, f64) {
        let Some(main) = &self.main else { return (String::new(), 1.0) };
        if self.is_critical() {
            return ("critical speed [km/h]".into(), KMH);
        }
        let unit = self.table.answers.get(main).map_or("", |(unit, _)| unit);
        (format!("{main} [{unit}]"), 1.0)
    }

    /// Changes with one number at a time against all at their medians, the largest first.
    pub fn swings(&self) -> Vec<(String, [f64; 2])> {
        let column = self.main.as_ref().and_then(|main| self.table.answers.get(main));
        let Some((_, column)) = column.filter(|_| !self.spread()) else {
            return Vec::new();
        };
        let change = |i: usize| column[i] - column[0];
        let keys = self.study.varied.iter().enumerate();
        let mut all: Vec<(String, [f64; 2])> =
            keys.map(|(j, varied)| (varied.key.clone(), [change(1 + 2 * j), change(2 + 2 * j)])).collect();
        let width = |ends: &[f64; 2]| {
            ends.iter().copied().filter(|end| end.is_finite()).fold(0.0, |w: f64, end| w.max(end.abs()))
        };
        all.sort_by(|a, b| width(&b.1).total_cmp(&width(&a.1)));
        all
    }
}
