//! Loads that move over equal supports: spectra at a place, histories, harmonics under the load. Eqs (57)–(64), corrected.

use super::cell::Cell;
use super::dirac_comb::DiracComb;
use super::driven::Driven;
use super::landmarks::pinned_pinned;
use super::tail::Tail;
use crate::foundation::FoundationError;
use crate::math::interpolation::lagrange_within;
use crate::math::quadrature::{Adaptive, Rule, Tolerance, subdivided};
use crate::rail::{Answer, Drive, Moving, RailError, Receptance, Waves};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Wanted error relative to the deflection under the load.
const ACCURACY: f64 = 1e-9;
/// Zones of wavenumbers, 2π/L each way, at most.
const ZONES: usize = 200;
/// Share of the pinned–pinned frequency below which the bare rail's waves are so long, γL < 0.03, that little is left of their
/// differences: the spectrum goes on as the polynomial through five values above.
const LONG: f64 = 1e-4;
/// Evaluations allowed.
const MOST: usize = 600_000;

/// Wanted error of fields: those of a Timoshenko rail bend where the load passes a support, and fall as 1/β only.
pub(super) fn accuracy(tail: &Tail) -> f64 {
    if tail.bends() { 1e3 * ACCURACY } else { ACCURACY }
}

/// `at` of ω = ω̃ − bv, below `longest` [rad/s] by the polynomial through five values above.
pub(super) fn gently<E>(
    (drive, longest): (Drive, f64),
    b: f64,
    at: impl Fn(f64) -> Result<Complex64, E>,
) -> Result<Complex64, E> {
    let omega = drive.at(b);
    if omega.abs() >= longest {
        return at(omega);
    }
    let nodes = [1.0, 1.5, 2.0, 2.5, 3.0].map(|n: f64| n * longest);
    let weights = lagrange_within(&nodes, omega.abs(), (0.0, nodes[4]));
    nodes.iter().zip(weights).map(|(node, w)| Ok(at(node.copysign(omega))? * w)).sum()
}

/// ω [rad/s] below which the waves of the bare rail are too long for their differences, within 0.1 rad/m of a load's spectrum.
pub(super) fn longest(cell: &Cell, drive: Drive) -> f64 {
    let pinned = pinned_pinned(cell.rail(), cell.spacing(), 1);
    (LONG * TAU * pinned.unwrap_or(0.0)).min(0.1 * drive.speed)
}

/// An integral over b₀ settled zone by zone, its tail taken out.
pub(super) struct Settled {
    rule: Rule,
    pub value: Complex64,
    pub error: f64,
}

/// ∫ `f` db over all b, or b < 0 only where `half`, zones 2π/L wide until they add nothing; waves e^{ibx} for |x| ≤ `reach` [m] want
/// panels no wider than fifteen nodes can follow.
pub(super) fn settle(
    f: &mut impl FnMut(f64) -> Complex64,
    (drive, spacing): (Drive, f64),
    half: bool,
    (reach, offset, accuracy): (f64, Complex64, f64),
) -> Settled {
    let zone = TAU / spacing;
    let widest = (14.0 / reach.max(0.1)).min(0.25 * zone);
    let still = drive.omega / drive.speed;
    let mut integral = Adaptive::new();
    let (mut last, mut quiet) = (Complex64::ZERO, 0);
    let mut rest = f64::INFINITY;
    // where ω = 0 the loss of hysteretic springs jumps, and waves are long
    let near = |points: &mut Vec<f64>, from: f64, to: f64| {
        let close = (1..8).map(|i| zone * 0.3f64.powi(i)).flat_map(|d| [still - d, still + d]);
        points.extend(close.chain([still]).filter(|b| from < *b && *b < to));
        points.sort_by(f64::total_cmp);
    };
    for k in 0..ZONES {
        for side in if half { &[-1.0][..] } else { &[-1.0, 1.0][..] } {
            let (from, to) = (zone * k as f64, zone * (k + 1) as f64);
            let (from, to) = if *side > 0.0 { (from, to) } else { (-to, -from) };
            let mut points = vec![from, to];
            near(&mut points, from, to);
            integral.add(f, &subdivided(&points, widest));
        }
        let value = integral.value();
        // what falls at least as k⁻³ leaves k/2 of the last zone
        rest = (value - last).norm() * (k + 1) as f64;
        last = value;
        quiet = if rest < 0.3 * accuracy * (value + offset).norm() { quiet + 1 } else { 0 };
        if quiet >= 3 && zone * (k as f64) > 2.0 * still.abs() {
            break;
        }
    }
    let tolerance = Tolerance { relative: accuracy, absolute: 0.0, max_count: MOST };
    let estimate = integral.refine(f, offset, tolerance);
    Settled { value: estimate.value, error: rest + estimate.error, rule: integral.into_rule() }
}

/// How the rail at one place answers a unit load that passes: the nodes of one integral serve all times.
#[derive(Clone, Debug)]
pub struct Passage {
    drive: Drive,
    /// x [m]
    x: f64,
    /// ω [rad/s] and amplitudes [m/N].
    waves: Waves,
    tail: Tail,
    /// Estimated absolute error [m/N] of every sample.
    pub error: f64,
}

impl Passage {
    /// u(x, t) [m/N] at `t` [s], the load over the support x = 0 at t = 0.
    pub fn at(&self, t: f64) -> Complex64 {
        let tail = Complex64::cis(self.drive.omega * t) * self.tail.field(self.x - self.drive.speed * t);
        if self.drive.omega == 0.0 { (self.waves.at(t) + tail).re.into() } else { self.waves.at(t) + tail }
    }

    /// Re u(x, t) [m/N], the answer to cos ω̃t, at `count` times from `from` in steps of `step` [s].
    pub fn history(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        let mut history = self.waves.shape(from, step, count);
        for (i, u) in history.iter_mut().enumerate() {
            let t = from + step * i as f64;
            let field = self.tail.field(self.x - self.drive.speed * t);
            *u += (Complex64::cis(self.drive.omega * t) * field).re;
        }
        history
    }
}

impl<'a> DiracComb<'a> {
    fn tail(&self, drive: Drive) -> Result<Tail, RailError> {
        let cell = self.cell();
        if cell.coupled() {
            let track = "loads that move over supports that the ground joins";
            return Err(RailError::Method {
                method: "dirac-comb",
                track,
                able: "adaptive, on a continuous track",
            });
        }
        cell.check(drive.omega)?;
        Tail::new(cell.rail(), drive, cell.spacing())
    }

    /// û(x, ω) [m s/N] at `x` [m] of a unit load e^{iω̃t} that moves as `drive`, over the support x = 0 at t = 0, for `omega` ≠ 0
    /// [rad/s]: the spectrum seen by one beside the track, Fig. 27.
    ///
    /// Accuracy: 1e-8 and better of 32-digit numbers (test `analytic::periodic_moving`). Source: Eqs (60), (61).
    ///
    /// # Errors
    /// A load faster than the rail's shear waves; ground that joins the supports; springs that cannot carry a constant load.
    pub fn spectrum(&self, drive: Drive, x: f64, omega: f64) -> Result<Complex64, RailError> {
        self.tail(drive)?;
        Ok(Driven::new(self.cell(), drive, omega)?.at(x) / drive.speed)
    }

    /// The rail under the load and beside it, moving with it at `offset` [m]: f(b₀) less its tail.
    fn settled(
        &self,
        drive: Drive,
        reach: f64,
        (half, offset, accuracy): (bool, Complex64, f64),
        f: impl Fn(&Driven) -> Complex64,
    ) -> Result<Settled, RailError> {
        let mut failure = None;
        let asked = (drive, longest(self.cell(), drive));
        let mut integrand = |b: f64| {
            let at = |omega: f64| Ok(f(&Driven::new(self.cell(), drive, omega)?));
            gently(asked, b, at).unwrap_or_else(|error: FoundationError| {
                failure = Some(error);
                Complex64::ZERO
            })
        };
        let settled = settle(&mut integrand, (drive, self.cell().spacing()), half, (reach, offset, accuracy));
        match failure {
            Some(error) => Err(error.into()),
            None => Ok(settled),
        }
    }

    /// W_j [m/N] of u(vt, t) = e^{iω̃t} Σ_j W_j e^{2πijvt/L}, the rail under a unit load that moves as `drive`, for every j of `orders`:
    /// W₀ the mean, the others the passing of supports, at ω̃ + 2πjv/L for one who rides along.
    ///
    ///   W₀ = (1/2π)∫(1 + (D/L)Σ′G)/N db,   W_j = −(1/2π)∫(D/L)G_j/N db
    ///
    /// Accuracy: 1e-8 of W₀ (test `analytic::periodic_moving`). Source: Eqs (57)–(61), corrected.
    ///
    /// # Errors
    /// As [`spectrum`](Self::spectrum).
    pub fn harmonics(&self, drive: Drive, orders: &[i32]) -> Result<Vec<Answer>, RailError> {
        let tail = self.tail(drive)?;
        let mean = self.settled(drive, 0.0, (false, TAU * tail.field(0.0), ACCURACY), |driven| {
            driven.harmonic(0) - tail.at(driven.b)
        })?;
        let mean = Answer { value: mean.value / TAU + tail.field(0.0), error: mean.error / TAU };
        let one = |order: &i32| {
            if *order == 0 {
                return Ok(mean);
            }
            // as exact as the mean
            let settled = self
                .settled(drive, 0.0, (false, TAU * mean.value, ACCURACY), |driven| driven.harmonic(*order))?;
            Ok(Answer { value: settled.value / TAU, error: settled.error / TAU })
        };
        orders.iter().map(one).collect()
    }

    /// How the rail at `x` [m] answers a unit load that moves as `drive`, for times at which the load is no farther than `reach` [m].
    ///
    /// u(x, t) = (1/2π)∫û e^{iωt} dω, for a constant load (1/π)Re∫₀^∞; what the rail does at short waves in closed form.
    ///
    /// Accuracy: 1e-8 of the largest deflection for Euler–Bernoulli rails (test `analytic::periodic_moving`); the deflection of a
    /// Timoshenko rail has a bend when the load passes a support, and keeps an error that `error` tells. Viscous damping: the loss of
    /// hysteretic springs jumps at ω = 0, which a constant load meets. Source: Eqs (57)–(61), corrected.
    ///
    /// # Errors
    /// As [`spectrum`](Self::spectrum).
    pub fn passage(&self, drive: Drive, x: f64, reach: f64) -> Result<Passage, RailError> {
        let tail = self.tail(drive)?;
        let half = drive.omega == 0.0;
        // half of it is the integral over b < 0
        let share = if half { 2.0 } else { 1.0 };
        let settled =
            self.settled(drive, reach, (half, TAU / share * tail.field(0.0), accuracy(&tail)), |driven| {
                driven.at(x) * Complex64::cis(-driven.b * x) - tail.at(driven.b)
            })?;
        // e^{ib(x − vt)} = e^{ibx} e^{i(ω − ω̃)t}
        let waves = Waves::new(&settled.rule, share / TAU, |b, value| value * Complex64::cis(b * x));
        let waves = Waves { beta: waves.beta.iter().map(|b| drive.at(*b)).collect(), ..waves };
        Ok(Passage { drive, x, waves, tail, error: settled.error * share / TAU })
    }
}

impl Moving for DiracComb<'_> {
    fn under(&self, drive: Drive, phase: f64, x: &[f64]) -> Result<Vec<Answer>, RailError> {
        if drive.speed == 0.0 {
            let at: Vec<f64> = x.iter().map(|x| phase + x).collect();
            return self.at(&at, phase, drive.omega);
        }
        let tail = self.tail(drive)?;
        let reach = x.iter().fold(0.0f64, |reach, x| reach.max(x.abs()));
        let half = drive.omega == 0.0;
        let share = if half { 2.0 } else { 1.0 };
        let beside = |driven: &Driven, x: f64| {
            driven.at(phase + x) * Complex64::cis(-driven.b * (phase + x)) - tail.at(driven.b)
        };
        // the nodes of the field under the load serve all places
        let offset = TAU / share * tail.field(0.0);
        let settled =
            self.settled(drive, reach, (half, offset, accuracy(&tail)), |driven| beside(driven, 0.0))?;
        let mut fields = vec![Complex64::ZERO; x.len()];
        let asked = (drive, longest(self.cell(), drive));
        for node in &settled.rule.0 {
            let weight = node.weight * share / TAU;
            let driven = Driven::new(self.cell(), drive, drive.at(node.x))?;
            for (field, x) in fields.iter_mut().zip(x) {
                let value = gently::<FoundationError>(asked, node.x, |omega| {
                    if omega == drive.at(node.x) {
                        return Ok(beside(&driven, *x));
                    }
                    Ok(beside(&Driven::new(self.cell(), drive, omega)?, *x))
                })?;
                *field += weight * value * Complex64::cis(node.x * x);
            }
        }
        let error = settled.error * share / TAU;
        let answer = |(field, x): (Complex64, &f64)| {
            let value = field + tail.field(*x);
            Answer { value: if half { value.re.into() } else { value }, error }
        };
        Ok(fields.into_iter().zip(x).map(answer).collect())
    }
}
