//! k_eq(β, ω) as a table for researchers.

use super::{Model, Outcome, StudyError, trimmed};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::progress::Observer;
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Wavenumbers and frequencies of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct EquivalentStiffness {
    /// β [rad/m], above zero.
    pub beta: Vec<f64>,
    /// f [Hz]
    pub frequencies: Vec<f64>,
}

impl EquivalentStiffness {
    /// k_eq (omega, beta) with its estimated error.
    ///
    /// # Errors
    /// A point load; undamped ground where waves exist.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let foundation = model.foundation()?;
        let omega: Vec<f64> = self.frequencies.iter().map(|f| TAU * f).collect();
        let pairs: Vec<(f64, f64)> =
            omega.iter().flat_map(|w| self.beta.iter().map(move |b| (*w, *b))).collect();
        observer.begin("equivalent stiffness", pairs.len() as u64);
        let values = pairs
            .par_iter()
            .map(|&(omega, beta)| {
                let stiffness = foundation.stiffness(beta, omega);
                observer.advance();
                stiffness
            })
            .collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let shape = (omega.len(), self.beta.len());
        let table =
            |f: &dyn Fn(usize) -> Complex64| Array2::from_shape_fn(shape, |(i, j)| f(i * shape.1 + j));
        let k_eq = table(&|n| values[n].value).into_dyn();
        let error = Array2::from_shape_fn(shape, |(i, j)| values[i * shape.1 + j].relative_error).into_dyn();
        let group = Group::new("equivalent_stiffness")
            .coordinate("omega", &omega, "rad s-1", "circular frequency")
            .coordinate("beta", &self.beta, "rad m-1", "wavenumber along the track")
            .complex(
                "k_eq",
                &["omega", "beta"],
                &k_eq,
                "N m-2",
                "equivalent stiffness of the ground under the track",
            )
            .variable("relative_error", &["omega", "beta"], error, "1", "estimated relative error of k_eq");
        let concerns: Vec<Concern> = pairs
            .iter()
            .zip(&values)
            .filter(|(_, v)| !v.converged)
            .map(|((omega, beta), v)| {
                Concern::new(
                    "quadrature",
                    format!(
                        "k_eq at β = {beta} rad/m, {:.3} Hz has a relative error of {:.1e}",
                        omega / TAU,
                        v.relative_error
                    ),
                    "a pole lies too close to the real axis (more damping helps), or a layer is very thin",
                )
            })
            .collect();
        let series = omega
            .iter()
            .enumerate()
            .map(|(i, omega)| Series {
                name: format!("{} Hz", trimmed(omega / TAU)),
                x: self.beta.clone(),
                y: (0..shape.1).map(|j| 1e-6 * values[i * shape.1 + j].value.norm()).collect(),
                stroke: if shape.1 > 1 { Stroke::Solid } else { Stroke::Points },
            })
            .collect();
        let figure = Figure::Lines(LineFigure {
            name: "equivalent_stiffness".into(),
            title: "Equivalent stiffness of the ground".into(),
            x_label: "wavenumber β [rad/m]".into(),
            y_label: "|k_eq| [MN/m²]".into(),
            second_x: None,
            y_down: false,
            log_x: shape.1 > 1,
            log_y: true,
            series,
            marks: Vec::new(),
        });
        Ok(Outcome {
            group,
            figures: vec![(figure, "Modulus of the equivalent stiffness, one curve per frequency.".into())],
            answers: Vec::new(),
            concerns: concerns.into_iter().chain(model.deep_rock(&self.frequencies)).collect(),
        })
    }
}
