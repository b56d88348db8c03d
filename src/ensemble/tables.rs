//! The tables of a study's report.

use super::columns::method_name;
use super::statistics::{SHARES, least_correlation, quantile, sorted};
use super::view::View;
use crate::output::ReportTable;

/// Refused samples that a report lists.
const LISTED: usize = 20;

/// A value to four digits.
fn digits(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if size.is_nan() => "-".into(),
        size if (1e-3..1e5).contains(&size) => {
            let decimals = (3 - size.log10().floor() as i32).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.3e}"),
    }
}

fn table(title: String, header: &[&str], rows: Vec<Vec<String>>) -> ReportTable {
    ReportTable { title, header: header.iter().map(|&h| h.to_owned()).collect(), rows }
}

fn unit(unit: &str) -> String {
    if unit.is_empty() { "-".to_owned() } else { unit.to_owned() }
}

/// All of them, in the order of a report; those without rows are left out.
pub(super) fn tables(view: &View) -> Vec<ReportTable> {
    let all =
        [varied(view), answers(view), correlations(view), derivatives(view), worst(view), refused(view)];
    all.into_iter().filter(|table| !table.rows.is_empty()).collect()
}

fn varied(view: &View) -> ReportTable {
    let rows = view.study.varied.iter().enumerate().map(|(j, varied)| {
        let values = sorted(view.table.values.iter().filter_map(|row| row.get(j).copied()));
        let quantiles = [0.05, 0.5, 0.95].map(|p| digits(quantile(&values, p)));
        let own = vec![varied.key.clone(), unit(varied.unit), varied.text(), digits(varied.stands)];
        [own, quantiles.to_vec()].concat()
    });
    table(
        format!("What varies, {} samples, {}", view.rows.samples, method_name(view.study.design.method())),
        &["key", "unit", "distribution", "in the case", "5 %", "50 %", "95 %"],
        rows.collect(),
    )
}

fn answers(view: &View) -> ReportTable {
    let rows = view.table.answers.iter().map(|(key, (of, values))| {
        let values = sorted(values.iter().copied());
        let central = view.table.central.as_ref().ok().and_then(|central| central.get(key));
        let quantiles = SHARES.map(|p| digits(quantile(&values, p))).to_vec();
        let rest = vec![digits(central.copied().unwrap_or(f64::NAN)), values.len().to_string()];
        [vec![key.clone(), unit(of)], quantiles, rest].concat()
    });
    table(
        "Answers: values that a share of the samples stays below".into(),
        &["answer", "unit", "5 %", "25 %", "50 %", "75 %", "95 %", "as it stands", "samples"],
        rows.collect(),
    )
}

fn correlations(view: &View) -> ReportTable {
    let least = least_correlation(view.main_values().len());
    let title = format!(
        "Rank correlations with {}; below {least:.2} they cannot be told from chance",
        view.label().0
    );
    let rows = view.correlations.iter().map(|(key, r)| vec![key.clone(), format!("{r:.3}")]).collect();
    table(title, &["key", "Spearman"], rows)
}

fn derivatives(view: &View) -> ReportTable {
    let rows = view.derivatives.iter();
    let rows = rows.map(|d| vec![d.key.clone(), unit(d.unit), digits(d.stands), format!("{:.3}", d.value)]);
    let title = format!("Logarithmic derivatives of {}: per cent per per cent", view.label().0);
    table(title, &["key", "unit", "in the case", "derivative"], rows.collect())
}

fn worst(view: &View) -> ReportTable {
    let (label, scale) = view.label();
    let rows = view.worst.iter();
    let rows = rows.map(|one| vec![one.sample.to_string(), digits(scale * one.value), one.file.clone()]);
    table("Worst samples, ready to run alone".into(), &["sample", &label, "case file"], rows.collect())
}

fn refused(view: &View) -> ReportTable {
    let all = &view.table.refused;
    let rows = all.iter().take(LISTED).map(|(i, reason)| vec![i.to_string(), reason.clone()]);
    table(format!("Samples without an answer, {} in all", all.len()), &["sample", "why"], rows.collect())
}
