//! Sections of supports one after another, every support a force on the bare rail: a witness that knows no waves from bay to bay.

use super::cell::Cell;
use super::floquet::uncoupled;
use super::point_source::{NAME, doubled};
use super::span::Span;
use crate::foundation::Foundation;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::Section;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// Supports of the first and of the last section beyond the farthest place, at first and at most.
const FIRST: usize = 30;
const MOST: usize = 240;
/// A change by one doubling of the field at the force, after which truncation is over.
const SETTLED: f64 = 1e-9;

/// One rail over sections by the forces f_m of so many of its supports:
///
///   Σ_n [δ_mn/D_m + g(x_m − x_n)] f_n = g(x_m − x₀),   u(x) = g(x − x₀) − Σ_n g(x − x_n) f_n
///
/// Supports stand in the middle of their bays; x = 0 is where the first section ends.
///
/// Accuracy: 1e-8 of the field at the force where the supports absorb the waves that run into them (test `cross_solver::sections`).
/// Source: Eqs (50)–(55), corrected, with a stiffness of its own for every support.
pub struct SectionForces<'a> {
    cells: Vec<Cell<'a>>,
    /// Bays of the sections between the first and the last.
    bays: Vec<usize>,
}

impl<'a> SectionForces<'a> {
    /// `sections` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Rails that differ, supports joined by links or by the ground; a foundation that cannot answer.
    pub fn new(sections: &'a [Section], on: &'a dyn Foundation) -> Result<Self, RailError> {
        let cells =
            sections.iter().map(|section| Cell::new(&section.supports, on)).collect::<Result<Vec<_>, _>>()?;
        let refused = |track| Err(RailError::Method { method: NAME, track, able: "coupled" });
        for cell in &cells {
            uncoupled(cell, NAME)?;
            if cell.joined() {
                return refused("sections with links between supports");
            }
            if cell.rail() != cells[0].rail() {
                return refused("sections whose rails differ");
            }
        }
        let inner = sections.get(1..sections.len().saturating_sub(1)).unwrap_or_default();
        Ok(Self { cells, bays: inner.iter().map(|section| section.bays.unwrap_or(0)).collect() })
    }

    /// Place and section of the supports, `side` and more of them on either side beyond `low` and `high` [m].
    fn supports(&self, (low, high): (f64, f64), side: usize) -> Vec<(f64, usize)> {
        let last = self.cells.len() - 1;
        let row = |from: f64, section: usize, bays: usize, way: f64| {
            let length = self.cells[section].spacing();
            (0..bays).map(move |n| (from + way * (n as f64 + 0.5) * length, section)).collect::<Vec<_>>()
        };
        let beyond = |distance: f64, section: usize| {
            side + (distance.max(0.0) / self.cells[section].spacing()).ceil() as usize
        };
        let mut all = row(0.0, 0, beyond(-low, 0), -1.0);
        let mut end = 0.0;
        for (i, bays) in self.bays.iter().enumerate() {
            all.extend(row(end, i + 1, *bays, 1.0));
            end += *bays as f64 * self.cells[i + 1].spacing();
        }
        all.extend(row(end, last, beyond(high - end, last), 1.0));
        all
    }

    /// Fields at `x` and, last, at the force; None where the forces have no solution.
    fn fields(
        &self,
        (x, from): (&[f64], f64),
        omega: f64,
        side: usize,
    ) -> Result<Option<Vec<Complex64>>, RailError> {
        let waves = Span::new(self.cells[0].rail(), self.cells[0].spacing(), omega).waves;
        let ends = x.iter().chain([&from]).fold((from, from), |(low, high), x| (low.min(*x), high.max(*x)));
        let supports = self.supports(ends, side);
        let own = self.cells.iter().map(|cell| Ok(cell.support(omega)?.compliance(0.0)));
        let own = own.collect::<Result<Vec<_>, RailError>>()?;
        let matrix = DMatrix::from_fn(supports.len(), supports.len(), |m, n| {
            let alone = if m == n { own[supports[m].1] } else { Complex64::ZERO };
            alone + waves.at(supports[m].0 - supports[n].0)
        });
        let driven = DVector::from_iterator(supports.len(), supports.iter().map(|s| waves.at(s.0 - from)));
        let field = |forces: &DVector<Complex64>, x: f64| {
            let held: Complex64 = forces.iter().zip(&supports).map(|(f, s)| f * waves.at(x - s.0)).sum();
            waves.at(x - from) - held
        };
        let forces = matrix.lu().solve(&driven);
        Ok(forces.map(|forces| x.iter().chain([&from]).map(|x| field(&forces, *x)).collect()))
    }
}

impl Receptance for SectionForces<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let remedy = "waves decay too little for so many supports: ask \"coupled\"";
        doubled(|side| self.fields((x, from), omega, side), (FIRST, MOST), SETTLED, omega, remedy)
    }

    fn period(&self) -> Option<f64> {
        None
    }
}
