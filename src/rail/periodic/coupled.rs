//! Sections of equal supports one after another: their waves meet where they end, Eqs (75)–(79), corrected.

use super::cell::{Cell, Support};
use super::floquet::{FreeWaves, uncoupled};
use super::section::{Field, Waves};
use super::span::Span;
use crate::foundation::Foundation;
use crate::rail::{Answer, RailError, Receptance};
use crate::track::Section;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// Two sections or more, the first and the last without end, between them zones of so many bays. x = 0 is where the first one ends;
/// cells are cut in the middle between supports.
///
/// In every section waves run both ways, referred to the end they come from, so that none grows; where sections meet w, φ, −Q, −M are
/// the same on both sides. A force adds the waves of an endless track of its section.
///
/// Accuracy: 1e-11 of the receptance (test `analytic::transition`). Source: Eqs (75)–(79) with errata.
pub struct Coupled<'a> {
    cells: Vec<Cell<'a>>,
    /// Where each section begins and ends [m].
    ends: Vec<(f64, f64)>,
}

/// What becomes of a wave at a change of sections.
#[derive(Clone, Debug)]
pub struct Scattering {
    /// λ of the wave that comes.
    pub lambda: Complex64,
    /// The waves that return, in the order of [`FreeWaves::waves`]: displacement at the change for 1 of the wave that comes.
    pub reflected: [Complex64; 2],
    /// The waves that go on, displacement at the start of the last section.
    pub transmitted: [Complex64; 2],
    /// Share of the power that comes, of each wave that returns; where waves lose power these shares do not add up to 1.
    pub reflected_power: [f64; 2],
    /// Share of the power that comes, of each wave that goes on.
    pub transmitted_power: [f64; 2],
}

/// The waves of all sections at one frequency, ready for any source.
struct Solved {
    waves: Vec<Waves>,
    matrix: nalgebra::linalg::LU<Complex64, nalgebra::Dyn, nalgebra::Dyn>,
    /// What rotations, forces and moments are measured in.
    scale: [f64; 4],
}

impl<'a> Coupled<'a> {
    /// `sections` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Fewer than two sections, or supports joined by links or by the ground; a foundation that cannot answer.
    pub fn new(sections: &'a [Section], on: &'a dyn Foundation) -> Result<Self, RailError> {
        let cells =
            sections.iter().map(|section| Cell::new(&section.supports, on)).collect::<Result<Vec<_>, _>>()?;
        for cell in &cells {
            uncoupled(cell, "coupled")?;
            if cell.joined() {
                let track =
                    "sections with links between supports: a bay hands on more than the state of its rail";
                return Err(RailError::Method { method: "coupled", track, able: "none" });
            }
        }
        let endless = |section: Option<&Section>| section.is_none_or(|section| section.bays.is_none());
        let inner = sections.get(1..sections.len().saturating_sub(1)).unwrap_or_default();
        let bounded = inner.iter().all(|section| section.bays.is_some_and(|bays| bays > 0));
        if sections.len() < 2 || !endless(sections.first()) || !endless(sections.last()) || !bounded {
            let track = "sections of which not the first and the last alone are endless, the others of one bay or more";
            return Err(RailError::Method { method: "coupled", track, able: "none" });
        }
        let mut ends = vec![(f64::NEG_INFINITY, 0.0)];
        for section in inner {
            let from = ends[ends.len() - 1].1;
            ends.push((from, from + section.bays.unwrap_or(0) as f64 * section.supports.spacing));
        }
        ends.push((ends[ends.len() - 1].1, f64::INFINITY));
        Ok(Self { cells, ends })
    }

    /// Number of the section in which `x` [m] lies, of two that meet there the left one.
    fn section(&self, x: f64) -> usize {
        self.ends.iter().position(|(_, end)| x <= *end).unwrap_or(self.ends.len() - 1)
    }

    /// Where the cells of section `i` are counted from: the end it has, the left one if both.
    fn origin(&self, i: usize) -> f64 {
        if i == 0 { self.ends[0].1 } else { self.ends[i].0 }
    }

    fn solve(&self, omega: f64) -> Result<Solved, RailError> {
        let mut waves = Vec::new();
        for cell in &self.cells {
            let (p, q) = match cell.support(omega)? {
                Support::Local { p, q } => (p, q),
                // refused at the door
                Support::Coupled { .. } => (vec![], vec![]),
            };
            let span = Span::new(cell.rail(), cell.spacing(), omega);
            let Some(section) = Waves::new(cell.rail(), omega, FreeWaves::new(span, &p, &q)) else {
                return Err(Self::unsettled(omega));
            };
            waves.push(section);
        }
        let scale = waves[0].scale();
        let meetings = waves.len() - 1;
        let mut matrix = DMatrix::zeros(4 * meetings, 4 * meetings);
        for meeting in 0..meetings {
            for (section, side) in [(meeting, 1.0), (meeting + 1, -1.0)] {
                for (column, state) in self.outgoing(&waves, section, self.ends[meeting].1) {
                    for row in 0..4 {
                        matrix[(4 * meeting + row, column)] = side * state[row] / scale[row];
                    }
                }
            }
        }
        let matrix = matrix.lu();
        if !matrix.is_invertible() {
            return Err(Self::unsettled(omega));
        }
        Ok(Solved { waves, matrix, scale })
    }

    /// Unknown waves of `section` and their states at `x` [m], a cell's end: leftward ones from its right end, rightward ones from its
    /// left end. The first section has leftward ones alone, the last rightward ones.
    fn outgoing(&self, waves: &[Waves], section: usize, x: f64) -> Vec<(usize, [Complex64; 4])> {
        let last = waves.len() - 1;
        let spacing = self.cells[section].spacing();
        let mut states = Vec::new();
        for q in 0..2 {
            if section > 0 {
                let bays = ((x - self.ends[section].0) / spacing).round() as i32;
                let column = 4 * (section - 1) + 2 + q;
                states.push((column, waves[section].state(q, true, bays)));
            }
            if section < last {
                let bays = ((self.ends[section].1 - x) / spacing).round() as i32;
                states.push((4 * section + q, waves[section].state(q, false, bays)));
            }
        }
        states
    }

    fn unsettled(omega: f64) -> RailError {
        RailError::Unsettled {
            method: "coupled",
            frequency: omega / std::f64::consts::TAU,
            error: f64::INFINITY,
            remedy: "the waves of two sections are one there: a little damping tells them apart",
        }
    }

    /// What becomes of wave number `wave` (0: the one that decays least) that comes to the changes of section at `omega` > 0 [rad/s]
    /// from the left, or from the right.
    ///
    /// Accuracy: 1e-11 (test `analytic::transition`); no change gives 0 and 1 to 1e-12, and without damping the shares of power add
    /// up to 1 to 1e-10.
    ///
    /// # Errors
    /// A foundation that cannot answer; waves that cannot be told apart.
    pub fn scattering(&self, omega: f64, wave: usize, from_left: bool) -> Result<Scattering, RailError> {
        let solved = self.solve(omega)?;
        let last = self.cells.len() - 1;
        let (source, target) = if from_left { (0, last) } else { (last, 0) };
        let meeting = if from_left { 0 } else { last - 1 };
        let comes = solved.waves[source].state(wave, from_left, 0);
        let mut known = DVector::zeros(4 * last);
        let side = if from_left { -1.0 } else { 1.0 };
        (0..4).for_each(|row| known[4 * meeting + row] = side * comes[row] / solved.scale[row]);
        let amplitudes = solved.matrix.solve(&known).ok_or_else(|| Self::unsettled(omega))?;
        let column = |section: usize, q: usize| if section == 0 { q } else { 4 * (section - 1) + 2 + q };
        let state = |section: usize, q: usize| {
            let state = solved.waves[section].state(q, section != 0, 0);
            state.map(|part| part * amplitudes[column(section, q)])
        };
        let power = |state: [Complex64; 4]| power(&state, omega) / power(&comes, omega);
        let of = |section: usize| [state(section, 0), state(section, 1)];
        Ok(Scattering {
            lambda: solved.waves[source].lambda(wave),
            reflected: of(source).map(|state| state[0] / comes[0]),
            transmitted: of(target).map(|state| state[0] / comes[0]),
            reflected_power: of(source).map(|state| -power(state)),
            transmitted_power: of(target).map(power),
        })
    }
}

/// ½Re(F conj(iωw) + M conj(iωφ)) of a state (w, φ, F, M): power to the right [W].
fn power(state: &[Complex64; 4], omega: f64) -> f64 {
    let speed = |part: Complex64| crate::math::complex::I * omega * part;
    0.5 * (state[2] * speed(state[0]).conj() + state[3] * speed(state[1]).conj()).re
}

impl Receptance for Coupled<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let solved = self.solve(omega)?;
        let own = self.section(from);
        let source = from - self.origin(own);
        let endless = &solved.waves[own];
        let last = self.cells.len() - 1;
        let mut known = DVector::zeros(4 * last);
        // what it sends to the right end of its section, and to the left one
        for (meeting, side) in [(own.checked_sub(1), -1.0), ((own < last).then_some(own), 1.0)] {
            let Some(meeting) = meeting else { continue };
            let end = self.ends[meeting].1 - self.origin(own);
            let state = endless.driven(end, source).ok_or_else(|| Self::unsettled(omega))?;
            (0..4).for_each(|row| known[4 * meeting + row] -= side * state[row] / solved.scale[row]);
        }
        let amplitudes = solved.matrix.solve(&known).ok_or_else(|| Self::unsettled(omega))?;
        let answer = |x: &f64| {
            let i = self.section(*x);
            let waves = &solved.waves[i];
            let mut field = Field::default();
            for q in 0..2 {
                if i > 0 {
                    field.add(amplitudes[4 * (i - 1) + 2 + q] * waves.field(q, x - self.ends[i].0));
                }
                if i < last {
                    field.add(amplitudes[4 * i + q] * waves.field(q, self.ends[i].1 - x));
                }
            }
            if i == own {
                field.add(waves.receptance(x - self.origin(i), source));
            }
            Answer { value: field.value, error: 1e-12 * field.size }
        };
        Ok(x.iter().map(answer).collect())
    }

    fn period(&self) -> Option<f64> {
        None
    }
}
