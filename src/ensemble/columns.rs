//! The table of a study as arrays: `/study` over the samples, and a group of curves for every question.

use super::table::Table;
use crate::case::{Case, Uncertain};
use crate::dataset::Group;
use crate::sampling::{GENERATOR, SamplingMethod};
use ndarray::Array1;

/// A unit as CF conventions write it: `N s/m²` → `N s m-2`, a plain number `1`.
fn cf(unit: &str) -> String {
    let part = |text: &str, sign: &str| {
        let factor = |one: &str| {
            let (name, power) = match one.strip_suffix('²') {
                Some(name) => (name, "2"),
                None => one
                    .strip_suffix('³')
                    .map_or((one, if sign.is_empty() { "" } else { "1" }), |name| (name, "3")),
            };
            format!("{name}{sign}{power}")
        };
        text.split_whitespace().map(factor).collect::<Vec<_>>()
    };
    let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
    let factors = [part(above, ""), part(below, "-")].concat().join(" ");
    if factors.is_empty() { "1".to_owned() } else { factors }
}

/// The name of a method in a case file.
pub(super) fn method_name(method: SamplingMethod) -> &'static str {
    match method {
        SamplingMethod::MonteCarlo => "monte-carlo",
        SamplingMethod::LatinHypercube => "latin-hypercube",
        SamplingMethod::Grid => "grid",
        SamplingMethod::OneAtATime => "one-at-a-time",
    }
}

fn numbered(name: &str, samples: usize) -> Group {
    let numbers: Vec<f64> = (0..samples).map(|i| i as f64).collect();
    Group::new(name).coordinate("sample", &numbers, "1", "number of the sample")
}

/// `/study`: every number that varies and every answer over the samples; those without an answer are gaps, `refused` is 1 there.
pub(super) fn study_group(study: &Uncertain, table: &Table) -> Group {
    let samples = table.values.len();
    let mut refused = vec![0.0; samples];
    table.refused.iter().for_each(|(i, _)| refused[*i] = 1.0);
    let over = |group: Group, name: &str, values: Vec<f64>, unit: &str, what: &str| {
        group.variable(name, &["sample"], Array1::from(values).into_dyn(), unit, what)
    };
    let mut group =
        over(numbered("study", samples), "refused", refused, "1", "1 where the sample has no answer");
    for (j, varied) in study.varied.iter().enumerate() {
        let values = table.values.iter().map(|row| row.get(j).copied().unwrap_or(f64::NAN)).collect();
        group = over(group, &varied.key, values, &cf(varied.unit), "number of the case that varies");
    }
    for (key, (unit, values)) in &table.answers {
        group = over(group, key, values.clone(), &cf(unit), "answer");
    }
    let reasons: serde_json::Map<String, serde_json::Value> =
        table.refused.iter().map(|(i, reason)| (i.to_string(), reason.clone().into())).collect();
    group
        .attribute("method", method_name(study.design.method()))
        .attribute("generator", GENERATOR)
        .attribute("refused_reasons", serde_json::Value::from(reasons).to_string())
}

/// A group for every question of `case` that has curves, over the samples and what they are over: as in `results.h5`, with the
/// sample in front.
pub(super) fn curve_groups(case: &Case, table: &Table) -> Vec<(&'static str, Group)> {
    let of = |name: &'static str| {
        let mut group = numbered(name, table.values.len());
        for (path, curves) in &table.curves {
            let Some(own) = path.strip_prefix(name).and_then(|rest| rest.strip_prefix('/')) else { continue };
            let over = curves.over.0.rsplit('/').next().unwrap_or_default();
            if group.get(over).is_none() {
                group =
                    group.coordinate(over, &curves.over.1, &curves.coordinate.unit, &curves.coordinate.what);
            }
            let values = curves.values.clone().into_dyn();
            group = group.variable(
                own,
                &["sample", over],
                values,
                &curves.described.unit,
                &curves.described.what,
            );
        }
        (group.variables.len() > 1).then_some((name, group))
    };
    case.studies.iter().filter_map(|study| of(study.name())).collect()
}

#[cfg(test)]
mod tests {
    use super::cf;

    #[test]
    fn units_are_those_of_cf() {
        let all = [
            ("m/s", "m s-1"),
            ("kg/m³", "kg m-3"),
            ("N s/m²", "N s m-2"),
            ("kg m²", "kg m2"),
            ("", "1"),
            ("m s-1", "m s-1"),
        ];
        assert!(all.iter().all(|(unit, expected)| cf(unit) == *expected));
    }
}
