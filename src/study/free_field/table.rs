//! One table of answers: receivers down, measures across, limits met or not beside each.

use super::PassVelocities;
use super::metrics::{MEASURES, significant, told};
use crate::output::ReportTable;
use ndarray::Array2;

impl PassVelocities<'_> {
    /// Velocity, measures of one pass and of whole days at each receiver, in the building where there are tables for it.
    pub(super) fn tables(&self, velocities: &[Array2<f64>; 3]) -> Vec<ReportTable> {
        let (place, metrics) = self.judged();
        let measures = told(&self.study.assessment.guides);
        let mut header = vec!["distance [m]".to_owned(), "v_rms [mm/s]".to_owned()];
        for m in &measures {
            let unit = match MEASURES[*m].unit() {
                "1" => "-",
                "m/s" => "mm/s",
                unit => unit,
            };
            header.push(format!("{} [{unit}]", MEASURES[*m].symbol));
        }
        let mut rows: Vec<Vec<String>> = Vec::new();
        for (r, y) in self.study.receivers.iter().enumerate() {
            let rms = velocities[2].row(r).iter().map(|v| v * v).sum::<f64>().sqrt();
            let mut row = vec![format!("{y}"), significant(1e3 * rms)];
            row.extend(measures.iter().map(|m| MEASURES[*m].number(metrics.spread(*m, r).0)));
            let days = self.day_answers(r, *y);
            if r == 0 {
                header.extend(days.iter().map(|day| day.what.split(" at ").next().unwrap_or("").to_owned()));
            }
            row.extend(days.into_iter().map(|day| day.shown));
            rows.push(row);
        }
        let title = match place {
            "" => "Free field, receivers down: open ground".to_owned(),
            place => format!(
                "Free field, receivers down: v_rms of the open ground, measures on the {place}, estimated"
            ),
        };
        vec![ReportTable { title, header, rows }]
    }
}
