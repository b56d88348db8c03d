//! G(k, ω) of the surface as a table for researchers.

use super::{Model, Outcome, StudyError, trimmed};
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::progress::Observer;
use crate::soil::{GroundSolver, SurfaceCompliance};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Wavenumbers and frequencies of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceComplianceTable {
    /// k [rad/m], above zero.
    pub k: Vec<f64>,
    /// f [Hz]
    pub frequencies: Vec<f64>,
}

impl SurfaceComplianceTable {
    /// u_zz, u_xx, u_xz, u_yy (frequency, k).
    ///
    /// # Errors
    /// A model on springs.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let (profile, solver) = model.ground("surface_compliance")?;
        observer.begin("surface compliance", self.frequencies.len() as u64);
        let rows = self
            .frequencies
            .par_iter()
            .map(|f| {
                let row = solver.prepare(profile, TAU * f, &[]).map(|ground| ground.batch(&self.k));
                observer.advance();
                row
            })
            .collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let table = |f: fn(&SurfaceCompliance) -> Complex64| {
            Array2::from_shape_fn((rows.len(), self.k.len()), |(i, j)| f(&rows[i][j])).into_dyn()
        };
        let dims = ["frequency", "k"];
        let group = Group::new("surface_compliance")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .coordinate("k", &self.k, "rad m-1", "radial wavenumber")
            .complex(
                "u_zz",
                &dims,
                &table(|g| g.u_zz),
                "m Pa-1",
                "vertical displacement per vertical traction",
            )
            .complex(
                "u_xx",
                &dims,
                &table(|g| g.u_xx),
                "m Pa-1",
                "displacement per traction along the direction of propagation",
            )
            .complex(
                "u_xz",
                &dims,
                &table(|g| g.u_xz),
                "m Pa-1",
                "displacement along the direction of propagation per vertical traction",
            )
            .complex(
                "u_yy",
                &dims,
                &table(|g| g.u_yy),
                "m Pa-1",
                "transverse displacement per transverse traction",
            );
        let series = self
            .frequencies
            .iter()
            .zip(&rows)
            .map(|(f, row)| Series {
                name: format!("{} Hz", trimmed(*f)),
                x: self.k.clone(),
                y: row.iter().map(|g| g.u_zz.norm()).collect(),
                stroke: if self.k.len() > 1 { Stroke::Solid } else { Stroke::Points },
            })
            .collect();
        let figure = Figure::Lines(LineFigure {
            name: "surface_compliance".into(),
            title: "Vertical compliance of the ground's surface".into(),
            x_label: "wavenumber k [rad/m]".into(),
            y_label: "|u_zz| [m/Pa]".into(),
            second_x: None,
            y_down: false,
            log_x: self.k.len() > 1,
            log_y: true,
            series,
            marks: Vec::new(),
        });
        Ok(Outcome {
            group,
            figures: vec![(figure, "Modulus of the vertical compliance, one curve per frequency.".into())],
            answers: Vec::new(),
            concerns: model.deep_rock(&self.frequencies).into_iter().collect(),
        })
    }
}
