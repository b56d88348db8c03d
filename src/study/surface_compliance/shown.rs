//! What a reader sees of the table of compliances.

use super::Compliances;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::soil::SurfaceCompliance;
use crate::study::{Outcome, trimmed};
use ndarray::Array2;
use num_complex::Complex64;

/// Components of the compliance: name, value, what it is.
type Component = (&'static str, fn(&SurfaceCompliance) -> Complex64, &'static str);
const COMPONENTS: [Component; 4] = [
    ("u_zz", |g| g.u_zz, "vertical displacement per vertical traction"),
    ("u_xx", |g| g.u_xx, "displacement per traction along the direction of propagation"),
    ("u_xz", |g| g.u_xz, "displacement along the direction of propagation per vertical traction"),
    ("u_yy", |g| g.u_yy, "transverse displacement per transverse traction"),
];

impl Compliances {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        let column = self.k.len() == 1 && self.frequencies.len() > 1;
        let (figure, caption) = if column {
            let waves = if self.k[0] == 0.0 { ": vertical incidence, P and S waves of a column" } else { "" };
            (
                self.over_frequency(),
                format!("Modulus of the compliances at k = {} rad/m{waves}.", trimmed(self.k[0])),
            )
        } else {
            (self.figure(), "Modulus of the vertical compliance, one curve per frequency.".into())
        };
        Outcome { group: self.group(), figures: vec![(figure, caption)], ..Outcome::default() }
    }

    fn group(&self) -> Group {
        let shape = (self.rows.len(), self.k.len());
        let group = Group::new("surface_compliance")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .coordinate("k", &self.k, "rad m-1", "radial wavenumber");
        COMPONENTS.iter().fold(group, |group, (name, of, what)| {
            let table = Array2::from_shape_fn(shape, |(i, j)| of(&self.rows[i][j])).into_dyn();
            group.complex(name, &["frequency", "k"], &table, "m Pa-1", what)
        })
    }

    /// At one wavenumber.
    fn over_frequency(&self) -> Figure {
        let curve = |(name, of, _): &Component, stroke| Series {
            name: format!("|{name}|"),
            x: self.frequencies.clone(),
            y: self.rows.iter().map(|row| of(&row[0]).norm()).collect(),
            stroke,
        };
        Figure::Lines(LineFigure {
            log_y: true,
            series: vec![
                curve(&COMPONENTS[0], Stroke::Solid),
                curve(&COMPONENTS[1], Stroke::Solid),
                curve(&COMPONENTS[3], Stroke::Dashed),
            ],
            ..LineFigure::new(
                "surface_compliance",
                format!("Compliance of the ground's surface at k = {} rad/m", trimmed(self.k[0])),
                "frequency [Hz]",
                "compliance [m/Pa]",
            )
        })
    }

    fn figure(&self) -> Figure {
        let several = self.k.len() > 1;
        let log_x = several && self.k.iter().all(|k| *k > 0.0);
        let curve = |(f, row): (&f64, &Vec<SurfaceCompliance>)| Series {
            name: format!("{} Hz", trimmed(*f)),
            x: self.k.clone(),
            y: row.iter().map(|g| g.u_zz.norm()).collect(),
            stroke: if several { Stroke::Solid } else { Stroke::Points },
        };
        Figure::Lines(LineFigure {
            log_x,
            log_y: true,
            series: self.frequencies.iter().zip(&self.rows).map(curve).collect(),
            ..LineFigure::new(
                "surface_compliance",
                "Vertical compliance of the ground's surface",
                "wavenumber k [rad/m]",
                "|u_zz| [m/Pa]",
            )
        })
    }
}
