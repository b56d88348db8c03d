//! A load that oscillates while it moves, and k along the line ω = ω̃ − βv on which it meets the waves, as finely as the rail feels
//! it: the panels of the integral then cost no ground.

use super::TrackOnFoundation;
use super::track_on_foundation::{ACCURACY, BETA_MIN, Extent, Quiet};
use crate::foundation::{Among, Asked, Foundation, FoundationError, Grain, Stiffness};
use crate::math::complex::reciprocal;
use crate::math::interpolation::{Interpolant, NODES};
use num_complex::Complex64;
use std::cell::{Cell, RefCell};

/// Speeds [m/s] at which waves of soils may meet the line: ends of the first pieces, which are halved where needed. They save a
/// quarter of the values and change nothing else.
const MEETING: [f64; 7] = [450.0, 300.0, 220.0, 170.0, 120.0, 60.0, 0.0];
/// Wanted error of the integral of a harmonic load relative to the receptance under it.
pub(super) const HARMONIC_ACCURACY: f64 = 1e-4;
/// Evaluations of G after which a line is refined no further: ground that hardly damps asks for ever more of them as the load outruns its
/// waves. A line of the paper's ground takes 5e4, one of the four layers of `laws::light_damping` at 109.6 m/s 1e7.
const MOST: usize = 3_000_000;

/// e^{iω̃t} at constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// ω̃ [rad/s], seen by one who moves with it; 0 for a constant load.
    pub omega: f64,
    /// v [m/s]; 0 for a load that stands.
    pub speed: f64,
}

impl Drive {
    /// ω = ω̃ − βv [rad/s] at `beta` [rad/m].
    #[inline]
    pub fn at(self, beta: f64) -> f64 {
        self.omega - beta * self.speed
    }
}

/// k(β, ω̃ − βv), where the rail feels it.
pub(super) struct Line<'a> {
    drive: Drive,
    source: Source<'a>,
    /// Error over what was allowed, where it is largest: at most 1 where the accuracy was reached everywhere.
    pub worst: f64,
    /// Evaluations of the ground it took.
    pub count: usize,
}

enum Source<'a> {
    Formula(&'a dyn Foundation),
    /// 1/k [m²/N] over the axis.
    Table(Interpolant, Axis),
}

/// Over what a table is even.
#[derive(Clone, Copy)]
enum Axis {
    /// x = ln β + shift, on which wave and layer features of a constant load have even widths; ln ω where modes are shared.
    Logarithm { shift: f64 },
    /// x = asinh(β/unit): even in β where waves meet the line, in ln β beyond.
    Both { unit: f64 },
}

impl Axis {
    fn x(self, beta: f64) -> f64 {
        match self {
            Self::Logarithm { shift } => beta.ln() + shift,
            Self::Both { unit } => (beta / unit).asinh(),
        }
    }

    fn beta(self, x: f64) -> f64 {
        match self {
            Self::Logarithm { shift } => (x - shift).exp(),
            Self::Both { unit } => unit * x.sinh(),
        }
    }
}

impl Line<'_> {
    /// Ends of the pieces of its table.
    pub fn pieces(&self) -> &[f64] {
        match &self.source {
            Source::Formula(_) => &[],
            Source::Table(table, _) => table.ends(),
        }
    }

    /// k [N/m²] at `beta` [rad/m]; beyond a table its last value, of which the rail feels nothing.
    pub fn stiffness(&self, beta: f64) -> Complex64 {
        match &self.source {
            // it answered everywhere when the extent of the load was found
            Source::Formula(foundation) => {
                foundation.stiffness(beta, self.drive.at(beta)).map_or(f64::NAN.into(), |k| k.value)
            }
            Source::Table(compliance, axis) => reciprocal(compliance.at(axis.x(beta))),
        }
    }
}

impl TrackOnFoundation<'_> {
    /// Error of 1/k [m²/N] at `beta` that changes the rail by `share` [m/N] in a unit of ln β.
    ///
    /// Reciprocity: δu_rail = q² δ(1/k), q the force handed down; its share of the integral is ∝ |β| in ln |β|.
    fn bearable(&self, drive: Drive, beta: f64, stiffness: Complex64, share: f64) -> f64 {
        let q = self.stack.respond(beta, drive.at(beta), stiffness).force;
        share / (q.norm_sqr() * beta.abs()).max(f64::MIN_POSITIVE)
    }

    fn formula(&self, drive: Drive) -> Line<'_> {
        Line { drive, source: Source::Formula(self.foundation), worst: 0.0, count: 0 }
    }

    /// k along ω = −βv of a constant load for β > 0 within its `extent`, interpolated piecewise; its logarithmic growth as β → 0 is
    /// nearly a straight line in ln β. It begins with the `pieces` of a line `near` by, where there is one.
    ///
    /// Accuracy: the table's error is at most the `accuracy` of ∫ |ũ_r| dβ, a thousand times as much on foundations that are computed in
    /// pieces: no more is asked of thin layers than their own accuracy is worth.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub(super) fn constant_line(
        &self,
        speed: f64,
        extent: &Extent,
        near: Option<&[f64]>,
    ) -> Result<Line<'_>, FoundationError> {
        let drive = Drive { omega: 0.0, speed };
        let Some(plan) = Plan::new(self.foundation.grain(), drive, (extent.end, self.accuracy), near) else {
            return Ok(self.formula(drive));
        };
        let Plan { axis, shared, .. } = plan;
        let allowed = |beta: f64, stiffness| match beta > extent.felt {
            true => f64::INFINITY,
            false => self.bearable(drive, beta, stiffness, self.accuracy * extent.sum),
        };
        let count = Cell::new(0);
        let asker =
            Asker { foundation: self.foundation, missed: 0.0, count: &count, known: Known::default() };
        let asker = RefCell::new(asker);
        let (mut highest, mut last) = (f64::NEG_INFINITY, Complex64::ONE);
        let compliance = |x: f64, asked: Asked| -> Result<Complex64, FoundationError> {
            let wanted = |k: Complex64| (0.1 * allowed(asked.beta, k) * k.norm()).clamp(1e-8, plan.loosest);
            Ok(1.0 / asker.borrow_mut().as_felt(x, asked, wanted)?)
        };
        // what is kept by ω is asked at its own ω alone
        let control = |x: f64| (!shared).then(|| compliance(x, plan.asked(x, x))).transpose();
        let compliances = |nodes: &[f64; NODES]| -> Result<[Complex64; NODES], FoundationError> {
            if shared && allowed(axis.beta(nodes[0]), 1.0 / last).is_infinite() {
                // any error is borne: the last one will do
                return Ok([last; NODES]);
            }
            let asked = nodes.map(|x| plan.asked(x, nodes[0]));
            self.foundation.begin(&asked);
            let mut values = [Complex64::ONE; NODES];
            for ((x, asked), value) in nodes.iter().zip(asked).zip(&mut values) {
                *value = compliance(*x, asked)?;
            }
            if nodes[NODES - 1] > highest {
                (highest, last) = (nodes[NODES - 1], values[NODES - 1]);
            }
            Ok(values)
        };
        let error = |x: f64, compliance: Complex64| plan.looser * allowed(axis.beta(x), 1.0 / compliance);
        let table =
            Interpolant::controlled(compliances, control, &plan.points, error, || count.get() < MOST)?;
        Ok(Line {
            drive,
            worst: table.worst.max(asker.borrow().missed),
            source: Source::Table(table, axis),
            count: count.get(),
        })
    }

    /// k for a harmonic load of ω̃ > 0, standing or moving forward, as finely as the rail feels it: 300 to 400 values where the integral
    /// for wheels 50 m apart has 3500 nodes.
    ///
    /// Accuracy: the table's error is at most that of harmonic loads times ∫ |ũ_r| dβ for moving loads, a tenth of it for standing ones.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub(super) fn harmonic_line(&self, drive: Drive) -> Result<Line<'_>, FoundationError> {
        if self.foundation.grain() == Grain::Formula {
            // refused here, if at all
            self.foundation.stiffness(1.0, drive.at(1.0))?;
            return Ok(self.formula(drive));
        }
        let Drive { omega, speed } = drive;
        // receptances are wanted for themselves; moving loads are asked at hundreds of frequencies, for forces
        let (accuracy, table) = if speed == 0.0 { (0.1, 0.1) } else { (0.5, 1.0) };
        let (accuracy, table) = (accuracy * HARMONIC_ACCURACY, table * HARMONIC_ACCURACY);
        let (high, mut sum) = self.felt_extent(drive, accuracy)?;
        let mut low = 0.0;
        if speed != 0.0 {
            // β < 0 is β > 0 of a load that runs the other way
            let (extent, more) = self.felt_extent(Drive { omega, speed: -speed }, accuracy)?;
            (low, sum) = (-extent, sum + more);
        }
        let axis = Axis::Both { unit: (omega / (speed + MEETING[2])).max(1e-3) };
        let points = meeting(drive, low, high).iter().map(|beta| axis.x(*beta)).collect::<Vec<_>>();
        let (missed, count) = (Cell::new(0.0f64), Cell::new(0));
        let compliance = |x: f64| -> Result<Complex64, FoundationError> {
            let k = self.felt(drive, axis.beta(x), accuracy)?;
            missed.set(missed.get().max(k.miss(HARMONIC_ACCURACY)));
            count.set(count.get() + k.count);
            Ok(reciprocal(k.value))
        };
        let compliances = |nodes: &[f64; NODES]| -> Result<_, FoundationError> {
            let mut values = [Complex64::ONE; NODES];
            for (x, value) in nodes.iter().zip(&mut values) {
                *value = compliance(*x)?;
            }
            Ok(values)
        };
        let error =
            |x: f64, compliance: Complex64| self.bearable(drive, axis.beta(x), 1.0 / compliance, table * sum);
        let control = |x: f64| compliance(x).map(Some);
        let table = Interpolant::controlled(compliances, control, &points, error, || true)?;
        let (missed, count) = (missed.get(), count.get());
        Ok(Line { drive, worst: table.worst.max(missed), source: Source::Table(table, axis), count })
    }

    /// How far from β = 0 upward the rail feels the foundation [rad/m], and ∫ |ũ_r| dβ on the way.
    fn felt_extent(&self, drive: Drive, accuracy: f64) -> Result<(f64, f64), FoundationError> {
        const RATIO: f64 = 1.5;
        let enough = self.enough();
        let (mut beta, mut extent, mut sum) = (0.01, 0.01, 0.0);
        let (mut last, mut faded) = (None, Quiet::default());
        loop {
            let stiffness = match last {
                Some(stiffness) => stiffness,
                None => self.felt(drive, beta, accuracy)?.value,
            };
            let u = self.stack.respond(beta, drive.at(beta), stiffness);
            sum += u.rail.norm() * beta * RATIO.ln();
            // what the foundation adds to the rail's deflection, q²/k: while it counts the foundation is asked again
            let counts = u.force.norm_sqr() / stiffness.norm() * beta > 0.1 * HARMONIC_ACCURACY * sum;
            last = if counts { None } else { Some(stiffness) };
            if counts {
                extent = RATIO * beta;
            }
            faded.step(beta, u.rail.norm() * beta < HARMONIC_ACCURACY * sum);
            if beta > enough || faded.since().is_some() {
                return Ok((extent, sum));
            }
            beta *= RATIO;
        }
    }

    /// k at `beta` to `accuracy`.
    fn felt(&self, drive: Drive, beta: f64, accuracy: f64) -> Result<Stiffness, FoundationError> {
        // at β = 0 the strip on a half-space has no static stiffness
        self.foundation.stiffness_to(beta.abs().max(BETA_MIN), drive.at(beta), accuracy)
    }
}

/// How the line of a constant load is asked.
struct Plan {
    drive: Drive,
    /// Largest β [rad/m].
    end: f64,
    axis: Axis,
    /// Ends of the first pieces on the axis.
    points: Vec<f64>,
    /// Whether what is dear at one ω is kept for all speeds.
    shared: bool,
    /// Relative accuracy asked first, and the least that is ever asked.
    first: f64,
    loosest: f64,
    /// What the table's error may be over what is felt.
    looser: f64,
}

impl Plan {
    /// As the `grain` of a foundation has it, for deflections of an `accuracy`, up to β = `end`, from the pieces of a line `near` by where there is one; None of a formula.
    fn new(grain: Grain, drive: Drive, (end, accuracy): (f64, f64), near: Option<&[f64]>) -> Option<Self> {
        let ends = match grain {
            Grain::Formula => return None,
            Grain::Smooth => None,
            Grain::Pieces(ends) => Some(ends),
        };
        let share = accuracy / ACCURACY;
        let (first, looser, loosest) = match ends {
            Some(_) => (1e-2, 1000.0, 1.0),
            None => ((1e-4 * share).min(1e-2), 1.0, (1e-3 * share).min(0.1)),
        };
        // at rest there are no frequencies to share
        let ends = ends.filter(|_| drive.speed != 0.0);
        let shared = ends.is_some();
        let axis = Axis::Logarithm { shift: if shared { drive.speed.abs().ln() } else { 0.0 } };
        let (low, high) = (axis.x(BETA_MIN), axis.x(end));
        let points = match (ends, near) {
            (Some(ends), _) => covering(&ends, low, high),
            (None, Some(near)) if near.len() > 1 => {
                near.iter().copied().filter(|end| *end < high - 0.1).chain([high]).collect()
            }
            (None, _) => four_pieces(low, high),
        };
        Some(Self { drive, end, axis, points, shared, first, loosest, looser })
    }

    /// The question at `x` of the axis, among those of the piece around `of`.
    fn asked(&self, x: f64, of: f64) -> Asked {
        let beta = self.axis.beta(x);
        if !self.shared {
            let among = Among { omega: (0.0, 0.0), beta: self.end };
            return Asked { beta, omega: self.drive.at(beta), relative: self.first, among: Some(among) };
        }
        // bit by bit the same ω at all speeds
        let omega = -self.drive.speed.signum() * x.exp();
        let among = piece(&self.points, of, self.axis);
        Asked { beta, omega, relative: self.first, among: Some(among) }
    }
}

/// Pieces to start with, in ln β: static far field, layers, contact width, beyond.
fn four_pieces(low: f64, high: f64) -> Vec<f64> {
    let middle = [0.01f64, 0.1, 1.0].iter().map(|b| b.ln());
    let middle = middle.filter(|b| *b > low + 0.5 && *b < high - 0.5);
    std::iter::once(low).chain(middle).chain([high]).collect()
}

/// Those of `ends` that cover `low` to `high`.
fn covering(ends: &[f64], low: f64, high: f64) -> Vec<f64> {
    let from = ends.partition_point(|end| *end <= low).saturating_sub(1);
    let to = ends.partition_point(|end| *end < high).min(ends.len() - 1);
    ends[from..=to].to_vec()
}

/// What is asked in the piece of `points` around `x` = ln ω.
fn piece(points: &[f64], x: f64, axis: Axis) -> Among {
    let above = points.partition_point(|end| *end < x).clamp(1, points.len() - 1);
    let (from, to) = (points[above - 1], points[above]);
    Among { omega: (from.exp(), to.exp()), beta: axis.beta(to) }
}

/// Wavenumbers [rad/m] from `low` to `high` at which waves of speed c meet the line, ahead of the load and behind it; damping changes its
/// sign where c = 0.
fn meeting(drive: Drive, low: f64, high: f64) -> Vec<f64> {
    let Drive { omega, speed } = drive;
    let mut points = vec![low, 0.0, high];
    points.extend(MEETING.iter().map(|c| omega / (speed + c)).filter(|beta| *beta < high));
    points.extend(MEETING.iter().map(|c| omega / (speed - c)).filter(|beta| low < *beta && *beta < 0.0));
    points.sort_by(f64::total_cmp);
    points.dedup_by(|a, b| *a - *b < 1e-6 * (omega / (speed + MEETING[2])).max(1e-3));
    points
}

/// Asks a foundation as exactly as the answers are felt.
struct Asker<'a> {
    foundation: &'a dyn Foundation,
    /// Error over what was wanted, where it is largest and was missed.
    missed: f64,
    count: &'a Cell<usize>,
    known: Known,
}

impl Asker<'_> {
    /// k as well as its neighbours on the table needed it, and once more where less is `wanted` of its value: a tenth of the error
    /// allowed there.
    fn as_felt(
        &mut self,
        x: f64,
        asked: Asked,
        wanted: impl Fn(Complex64) -> f64,
    ) -> Result<Complex64, FoundationError> {
        let mut relative = self.known.near(x).unwrap_or(asked.relative);
        loop {
            let k = self.foundation.answer(Asked { relative, ..asked })?;
            self.count.set(self.count.get() + k.count);
            let wanted = wanted(k.value);
            if wanted >= 0.1 * relative || k.relative_error <= 3.0 * wanted || !k.converged {
                self.missed = self.missed.max(k.miss(relative));
                self.known.insert(x, wanted);
                return Ok(k.value);
            }
            relative = wanted;
        }
    }
}

/// What relative accuracy was wanted where.
#[derive(Default)]
struct Known(Vec<(f64, f64)>);

impl Known {
    /// The finer of the neighbours of `x`; None where there are none.
    fn near(&self, x: f64) -> Option<f64> {
        let above = self.0.partition_point(|known| known.0 < x);
        let below = above.checked_sub(1).and_then(|i| self.0.get(i));
        below.into_iter().chain(self.0.get(above)).map(|known| known.1).min_by(f64::total_cmp)
    }

    fn insert(&mut self, x: f64, wanted: f64) {
        let above = self.0.partition_point(|known| known.0 < x);
        self.0.insert(above, (x, wanted));
    }
}
