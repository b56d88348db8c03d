//! Finite elements at one frequency, the track beyond both ends exact: its bays doubled until nothing comes back.

use super::FemError;
use super::assembly::{Given, assemble};
use super::column::Column;
use super::layouts::Form;
use super::mesh::{Mesh, Station};
use crate::foundation::{Foundation, Springs};
use crate::math::banded::Banded;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::{Layout, Link, Member};
use nalgebra::DMatrix;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Metres of a bay of a track without supports.
const BAY: f64 = 0.6;
/// Doublings of a bay: 2⁵⁰ bays.
const DOUBLINGS: usize = 50;

/// K + iωC − ω²M of `mesh` at `omega` [rad/s], of any element k*(ω). Source: Eq. (28).
pub fn dynamic_stiffness(mesh: &Mesh, omega: f64) -> Banded<Complex64> {
    let member = |m: &Member| {
        let (loss, inertia) = (m.loss(omega), m.inertia(omega));
        Given {
            bend: m.bending_stiffness * loss,
            shear: if m.shears() { loss / m.shear_compliance } else { Complex64::ZERO },
            tension: m.tension(omega),
            mass: -inertia * m.mass,
            rotary: -inertia * m.rotary_inertia,
        }
    };
    let link = |between: &Link| {
        let k = between.stiffness(omega);
        [k.upper, k.cross, k.lower]
    };
    assemble(mesh, &member, &link)
}

/// The receptance of an endless track by finite elements.
///
/// Accuracy: of h⁴ with Euler–Bernoulli rails, 2.4e-4, 1.5e-5, 9.5e-7 of the point receptance at 1000 Hz with 4, 8 and 16 elements in
/// 0.6 m; of h² with Timoshenko rails, 4.9e-2, 1.3e-2, 3.2e-3 (test `elements::receptance`). Its error is estimated from half as
/// many elements. Source: Eqs (26)–(28), Fig. 12a.
pub struct FiniteElements<'a> {
    layout: &'a Layout,
    on: &'a Springs,
    per_bay: usize,
}

impl<'a> FiniteElements<'a> {
    /// Elements a bay (0.6 m of a track without supports) where none are asked for.
    pub const PER_BAY: usize = 16;

    /// `layout` on `on`, a foundation of springs, with `per_bay` elements a bay, an even number.
    ///
    /// # Errors
    /// Ground; foundations that join supports.
    pub fn new(layout: &'a Layout, on: &'a dyn Foundation, per_bay: usize) -> Result<Self, RailError> {
        let Some(on) = on.springs() else {
            let track = "a track on layered ground";
            return Err(RailError::Method { method: METHOD, track, able: "adaptive, fourier, dirac-comb" });
        };
        let elements = Self { layout, on, per_bay: per_bay.next_multiple_of(2).max(2) };
        // whatever the frequency
        elements.mesh((0.0, 0.1), elements.per_bay)?;
        Ok(elements)
    }

    fn mesh(&self, range: (f64, f64), per_bay: usize) -> Result<Mesh, FemError> {
        Mesh::of(self.layout, self.on, range, (BAY, per_bay), Form::Frequency, &[])
    }

    /// One bay of the first or last part of the track, cut where its mesh is.
    fn cell(&self, last: bool, per_bay: usize) -> Result<Mesh, FemError> {
        match self.layout {
            Layout::Continuous(_) => self.mesh((0.0, BAY), per_bay),
            Layout::Discrete(supports) => {
                let mut mesh = self.mesh((0.0, supports.spacing), per_bay)?;
                mesh.halve_ends();
                Ok(mesh)
            }
            Layout::Varying(sections) => {
                let supports = if last { sections.last() } else { sections.first() };
                let Some(supports) = supports.map(|s| &s.supports) else { return Err(FemError::NoElement) };
                let (rail, under) = (Column::rail(supports.rail), Column::under(supports, self.on)?);
                let station =
                    |x: f64, under| Station { x, under, rail: rail.clone(), elements: per_bay.div_ceil(2) };
                let middle = station(0.5 * supports.spacing, Some((under, None)));
                Mesh::supported(&[station(0.0, None), middle, station(supports.spacing, None)])
            }
        }
    }

    fn solve(&self, x: &[f64], from: f64, omega: f64, per_bay: usize) -> Result<Vec<Complex64>, RailError> {
        let (low, high) = x.iter().fold((from, from), |(low, high), &x| (low.min(x), high.max(x)));
        let mut mesh = self.mesh((low - 1e-3, high + 1e-3), per_bay)?;
        if matches!(self.layout, Layout::Discrete(_)) {
            mesh.halve_ends();
        }
        let beyond = |last| -> Result<_, RailError> {
            let cell = self.cell(last, per_bay)?;
            let seen = endless(&cell, omega).ok_or(unsettled(omega))?;
            Ok(if last { seen } else { mirrored(seen, &cell) })
        };
        let matrix = with_ends(&mesh, omega, [beyond(false)?, beyond(true)?]);
        let (shape, held) = mesh.rail_at(from);
        let mut u = vec![Complex64::ZERO; mesh.size()];
        shape.iter().for_each(|&(i, n)| u[i] += n);
        matrix.factor().ok_or(unsettled(omega))?.solve(&mut u);
        let answer = |&x: &f64| {
            let nodal: Complex64 = mesh.rail_at(x).0.iter().map(|&(i, n)| u[i] * n).sum();
            nodal + if x == from { held } else { 0.0 }
        };
        Ok(x.iter().map(answer).collect())
    }
}

const METHOD: &str = "finite-elements";

fn unsettled(omega: f64) -> RailError {
    let remedy = "waves without loss run on for ever: give the track damping, or take another frequency";
    RailError::Unsettled { method: METHOD, frequency: omega / TAU, error: f64::INFINITY, remedy }
}

impl Receptance for FiniteElements<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let fine = self.solve(x, from, omega, self.per_bay)?;
        let coarse = self.solve(x, from, omega, (self.per_bay / 2).next_multiple_of(2).min(self.per_bay))?;
        // h⁴, h² with shear: 1/15, 1/3 of the difference, twice as much for safety
        let share = if self.shears() { 2.0 / 3.0 } else { 2.0 / 15.0 };
        let answer = |(fine, coarse): (&Complex64, Complex64)| Answer {
            value: *fine,
            error: share * (fine - coarse).norm() + 1e-9 * fine.norm(),
        };
        Ok(fine.iter().zip(coarse).map(answer).collect())
    }

    fn period(&self) -> Option<f64> {
        match self.layout {
            Layout::Continuous(_) => Some(0.0),
            Layout::Discrete(supports) => Some(supports.spacing),
            Layout::Varying(_) => None,
        }
    }
}

impl FiniteElements<'_> {
    fn shears(&self) -> bool {
        match self.layout {
            Layout::Continuous(stack) => stack.members().iter().any(Member::shears),
            Layout::Discrete(supports) => supports.rail.shears(),
            Layout::Varying(sections) => sections.iter().any(|section| section.supports.rail.shears()),
        }
    }
}

/// The dynamic stiffness with `ends` added at the first and the last cross-section.
fn with_ends(mesh: &Mesh, omega: f64, ends: [DMatrix<Complex64>; 2]) -> Banded<Complex64> {
    let mut matrix = dynamic_stiffness(mesh, omega);
    for (unknowns, end) in mesh.ends().iter().zip(&ends) {
        for (i, a) in unknowns.iter().enumerate() {
            for (j, b) in unknowns.iter().enumerate() {
                if b <= a {
                    matrix.add(*a, *b, end[(i, j)]);
                }
            }
        }
    }
    matrix
}

/// What an endless row of `cell`s to the right does to its left cross-section: two cells in a row are one, D₁₁ − D₁₂XD₂₁ with
/// X = (D₂₂ + D₁₁′)⁻¹, and so on until D₁₂ is nothing; None where waves lose nothing.
fn endless(cell: &Mesh, omega: f64) -> Option<DMatrix<Complex64>> {
    let [mut d11, mut d12, mut d22] = condensed(cell, omega)?;
    for _ in 0..DOUBLINGS {
        let joint = (&d22 + &d11).lu();
        let (right, left) = (joint.solve(&d12)?, joint.solve(&d12.transpose())?);
        // D₁₁ − D₁₂XD₂₁, −D₁₂XD₁₂, D₂₂ − D₂₁XD₁₂
        let next = [&d11 - &d12 * left, -&d12 * &right, &d22 - d12.transpose() * right];
        [d11, d12, d22] = next;
        let n = d11.nrows();
        let reach =
            (0..n * n).map(|i| d12[i].norm_sqr() / (d11[(i % n, i % n)] * d22[(i / n, i / n)]).norm());
        if reach.fold(0.0, f64::max) < 1e-36 {
            return Some(d11);
        }
    }
    None
}

/// [[D₁₁, D₁₂], [D₁₂ᵀ, D₂₂]] of the ends of `cell`, what lies between eliminated.
fn condensed(cell: &Mesh, omega: f64) -> Option<[DMatrix<Complex64>; 3]> {
    let matrix = dynamic_stiffness(cell, omega);
    let ends = cell.ends();
    let kept: Vec<usize> = ends.iter().flatten().copied().collect();
    let inner: Vec<usize> = (0..cell.size()).filter(|i| !kept.contains(i)).collect();
    let part = |rows: &[usize], columns: &[usize]| {
        DMatrix::from_fn(rows.len(), columns.len(), |i, j| matrix.get(rows[i], columns[j]))
    };
    let between = part(&inner, &kept);
    let d = part(&kept, &kept) - between.transpose() * part(&inner, &inner).lu().solve(&between)?;
    let n = ends[0].len();
    Some([(0, 0), (0, n), (n, n)].map(|start| d.view(start, (n, n)).into_owned()))
}

/// What goes on to the left is the mirror image of what goes on to the right: rotations change their sign.
fn mirrored(seen: DMatrix<Complex64>, cell: &Mesh) -> DMatrix<Complex64> {
    let turns = cell.turns();
    DMatrix::from_fn(seen.nrows(), seen.ncols(), |i, j| {
        if turns[i] == turns[j] { seen[(i, j)] } else { -seen[(i, j)] }
    })
}
