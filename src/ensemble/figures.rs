//! Pictures of a study: fan of curves, histogram, sensitivities, scatter.

use super::derivative::Derivative;
use super::statistics::{SHARES, quantile, sorted};
use super::table::Table;
use super::worst::Worst;
use crate::figure::{BarFigure, Figure, LineFigure, SecondAxis, Series, Stroke};

/// km/h in a m/s.
pub(super) const KMH: f64 = 3.6;
/// Bars of a picture, the largest ones.
const MANY: usize = 20;
/// Points of a scatter: more are a blot.
const POINTS: usize = 2000;

/// A picture and its caption.
pub(super) type Shown = (Figure, String);

/// Quantiles of the speed curves, at every speed by itself.
pub(super) fn fan(table: &Table, name: &str, title: &str, marks: &[(f64, String)]) -> Option<Shown> {
    let curves = table.curves.get(name)?;
    let columns: Vec<Vec<f64>> =
        curves.values.columns().into_iter().map(|c| sorted(c.iter().copied())).collect();
    let series = SHARES.iter().rev().map(|p| Series {
        name: format!("{:.0} %", 100.0 * p),
        x: curves.over.1.iter().map(|v| KMH * v).collect(),
        y: columns.iter().map(|column| 1e3 * quantile(column, *p)).collect(),
        stroke: if *p == 0.5 { Stroke::Solid } else { Stroke::Dashed },
    });
    let figure = LineFigure {
        second_x: Some(SecondAxis { label: "speed [m/s]".into(), factor: 1.0 / KMH }),
        series: series.collect(),
        marks: marks.to_vec(),
        ..LineFigure::new(name.replace('/', "_") + "_fan", title, "speed [km/h]", "rail deflection [mm]")
    };
    let caption = "Largest downward deflection of the rail: the value that 5, 25, 50, 75 and 95 % of the samples stay below, at every speed \
                   by itself; none of these curves is that of one ground.";
    Some((Figure::Lines(figure), caption.into()))
}

/// How many samples have which value: `scale` times the SI value, in parts as wide as all values over √n.
pub(super) fn histogram(
    values: &[f64],
    (label, scale): (&str, f64),
    marks: Vec<(f64, String)>,
) -> Option<Shown> {
    let values = sorted(values.iter().map(|value| scale * value));
    let (low, high) = (*values.first()?, *values.last()?);
    let parts = (values.len() as f64).sqrt().clamp(5.0, 40.0) as usize;
    let width = (high - low) / parts as f64;
    if width <= 0.0 {
        return None;
    }
    let mut counts = vec![0usize; parts];
    values.iter().for_each(|value| counts[(((value - low) / width) as usize).min(parts - 1)] += 1);
    let (mut x, mut y) = (vec![low], vec![0.0]);
    for (i, count) in counts.iter().enumerate() {
        let share = 100.0 * *count as f64 / values.len() as f64;
        x.extend([low + i as f64 * width, low + (i + 1) as f64 * width]);
        y.extend([share; 2]);
    }
    x.push(high);
    y.push(0.0);
    let series = vec![Series { name: "samples".into(), x, y, stroke: Stroke::Solid }];
    let title = format!("Histogram of {} samples", values.len());
    let figure = LineFigure { series, marks, ..LineFigure::new("histogram", title, label, "samples [%]") };
    Some((
        Figure::Lines(figure),
        "How many of the samples have which value; samples without an answer are left out.".into(),
    ))
}

fn bars(
    name: &str,
    title: &str,
    label: &str,
    rows: Vec<(String, Vec<f64>)>,
    series: &[&str],
) -> Option<Figure> {
    let rows: Vec<_> = rows.into_iter().take(MANY).collect();
    if rows.is_empty() {
        return None;
    }
    let of = |i: usize| rows.iter().map(|row| row.1[i]).collect();
    Some(Figure::Bars(BarFigure {
        name: name.into(),
        title: title.into(),
        x_label: label.into(),
        labels: rows.iter().map(|row| row.0.clone()).collect(),
        series: series.iter().enumerate().map(|(i, name)| ((*name).to_owned(), of(i))).collect(),
    }))
}

/// Rank correlations with what varies.
pub(super) fn correlations(all: &[(String, f64)], answer: &str) -> Option<Shown> {
    let rows = all.iter().map(|(key, r)| (key.clone(), vec![*r])).collect();
    let title = format!("What the scatter of {answer} comes from");
    let caption = "Spearman's rank correlation of what varies with the answer, over all samples: 1 or −1 where it alone decides, 0 where it \
                   does not matter. Numbers that vary together share it.";
    bars("rank_correlations", &title, "rank correlation [-]", rows, &[""])
        .map(|figure| (figure, caption.into()))
}

/// Derivatives by numbers of ground and track.
pub(super) fn derivatives(all: &[Derivative], answer: &str) -> Option<Shown> {
    let rows = all.iter().map(|d| (d.key.clone(), vec![d.value])).collect();
    let title = format!("What moves {answer}, around the case as it stands");
    let caption = "By how many per cent the answer changes where one number of ground or track is one per cent larger, all others as they \
                   stand in the case: central differences over 5 % to either side. Layers keep their shear wave speed where their density changes.";
    bars("derivatives", &title, "per cent per per cent [-]", rows, &[""])
        .map(|figure| (figure, caption.into()))
}

/// Changes of the answer with one number at a time, `scale` times the SI value.
pub(super) fn swings(all: &[(String, [f64; 2])], (label, scale): (&str, f64)) -> Option<Shown> {
    let rows = all.iter().map(|(key, ends)| (key.clone(), ends.map(|end| scale * end).to_vec())).collect();
    let caption = "Change of the answer where one number is at its 5 % or its 95 % quantile and all others at their medians.";
    let title = "One number at a time";
    bars("one_at_a_time", title, &format!("change of {label}"), rows, &["at 5 %", "at 95 %"])
        .map(|figure| (figure, caption.into()))
}

/// The answer of every sample over the number that matters most, the worst ones by themselves.
pub(super) fn scatter(
    table: &Table,
    (j, x_label): (usize, &str),
    (answer, y_label, scale): (&str, &str, f64),
    worst: &[Worst],
) -> Shown {
    let value = |sample: usize| table.values[sample].get(j).copied().unwrap_or(f64::NAN);
    let is_worst = |sample: usize| worst.iter().any(|one| one.sample == sample);
    let (few, many): (Vec<(usize, f64)>, Vec<_>) =
        table.of(answer).into_iter().partition(|(i, _)| is_worst(*i));
    let series = |name: &str, points: &[(usize, f64)]| Series {
        name: name.into(),
        x: points.iter().map(|(i, _)| value(*i)).collect(),
        y: points.iter().map(|(_, y)| scale * y).collect(),
        stroke: Stroke::Points,
    };
    let many = &many[..many.len().min(POINTS)];
    let figure = LineFigure {
        series: vec![series("samples", many), series("worst, with case files", &few)],
        ..LineFigure::new("scatter", "The number that matters most", x_label, y_label)
    };
    let caption = format!(
        "Samples over the number with the largest rank correlation, at most {POINTS} of them; the worst have case files."
    );
    (Figure::Lines(figure), caption)
}
