//! What a reader sees of the table of k_eq.

use super::StiffnessTable;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
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
            concerns: self.concerns(),
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

    fn concerns(&self) -> Vec<Concern> {
        let missed = self.k_eq.indexed_iter().filter(|(_, k)| !k.converged);
        missed
            .map(|((i, j), k)| {
                Concern::new(
                    "quadrature",
                    format!(
                        "k_eq at β = {} rad/m, {:.3} Hz has a relative error of {:.1e}",
                        self.beta[j],
                        self.omega[i] / TAU,
                        k.relative_error
                    ),
                    "a pole lies too close to the real axis (more damping helps), or a layer is very thin",
                )
            })
            .collect()
    }
}
