//! What a reader sees of the table of k_eq.

use super::StiffnessTable;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::foundation::ACCURACY;
use crate::study::doubts::by_up_to;
use crate::study::{Outcome, trimmed};
use std::f64::consts::TAU;

impl StiffnessTable {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        let caption = "Modulus of the equivalent stiffness, one curve per frequency.";
        Outcome {
            group: self.group(),
            figures: vec![(self.figure(), caption.into())],
            answers: Vec::new(),
            concerns: self.concern().into_iter().collect(),
        }
    }

    fn group(&self) -> Group {
        let dims = ["omega", "beta"];
        let what = "equivalent stiffness of the ground under the track";
        let error = self.k_eq.mapv(|k| k.relative_error).into_dyn();
        Group::new("equivalent_stiffness")
            .coordinate("omega", &self.omega, "rad s-1", "circular frequency")
            .coordinate("beta", &self.beta, "rad m-1", "wavenumber along the track")
            .complex("k_eq", &dims, &self.k_eq.mapv(|k| k.value).into_dyn(), "N m-2", what)
            .variable("relative_error", &dims, error, "1", "estimated relative error of k_eq")
    }

    fn figure(&self) -> Figure {
        let several = self.beta.len() > 1;
        let curve = |(omega, row): (&f64, ndarray::ArrayView1<crate::foundation::Stiffness>)| Series {
            name: format!("{} Hz", trimmed(omega / TAU)),
            x: self.beta.clone(),
            y: row.iter().map(|k| 1e-6 * k.value.norm()).collect(),
            stroke: if several { Stroke::Solid } else { Stroke::Points },
        };
        Figure::Lines(LineFigure {
            log_x: several,
            log_y: true,
            series: self.omega.iter().zip(self.k_eq.rows()).map(curve).collect(),
            ..LineFigure::new(
                "equivalent_stiffness",
                "Equivalent stiffness of the ground",
                "wavenumber β [rad/m]",
                "|k_eq| [MN/m²]",
            )
        })
    }

    /// One concern for all values that missed their accuracy.
    fn concern(&self) -> Option<Concern> {
        let misses = self.k_eq.indexed_iter().map(|(at, k)| (at, k.relative_error, k.miss(ACCURACY)));
        let missed: Vec<_> = misses.filter(|(_, _, factor)| *factor > 1.0).collect();
        let ((i, j), error, factor) = missed.iter().max_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(Concern::new(
            "quadrature",
            format!(
                "k_eq missed its accuracy ({ACCURACY:e}) at {} of {} points, {} (at β = {} rad/m, {} Hz, where its relative error is \
                 {error:.1e})",
                missed.len(),
                self.k_eq.len(),
                by_up_to(*factor),
                self.beta[*j],
                trimmed(self.omega[*i] / TAU),
            ),
            "a pole lies too close to the real axis (more damping helps), or a layer is very thin; every error is in relative_error of the results",
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foundation::Stiffness;
    use ndarray::Array2;

    #[test]
    fn one_concern_quotes_the_worst_of_all() {
        let table = |errors: [f64; 4]| StiffnessTable {
            beta: vec![0.2, 1.0],
            omega: vec![TAU * 5.0, TAU * 12.0],
            k_eq: Array2::from_shape_fn((2, 2), |(i, j)| {
                let relative_error = errors[2 * i + j];
                Stiffness {
                    value: 1e8.into(),
                    relative_error,
                    converged: relative_error <= ACCURACY,
                    count: 15,
                }
            }),
        };
        assert!(table([1e-9, 1e-12, 0.0, 1e-8]).concern().is_none());
        let told = table([1e-9, 1.2e-8, 2.3e-8, 0.0]).concern().unwrap().message;
        let wanted =
            "missed its accuracy (1e-8) at 2 of 4 points, by up to a factor of 2.3 (at β = 0.2 rad/m, 12 Hz,";
        assert!(told.contains(wanted), "{told}");
        let told = table([f64::NAN, 0.0, 0.0, 0.0]).concern().unwrap().message;
        assert!(told.contains("at 1 of 4 points, by an unknown factor (at β = 0.2 rad/m, 5 Hz"), "{told}");
    }
}
