//! Waves from bay to bay in closed form, and the receptance of all bays by their residues: Eqs (71)–(74), corrected.

use super::cell::{Cell, Support};
use super::span::{Pair, Span};
use crate::foundation::Foundation;
use crate::math::polynomial::{plus, roots, times, value_and_slope};
use crate::rail::{Answer, RailError, Receptance};
use crate::track::Supports;
use num_complex::Complex64;

/// |λ| nearer to 1 than this says nothing about where a wave goes.
const UNDECIDED: f64 = 1e-6;

/// A wave that is the same from bay to bay but for the factor λ, with 1/λ the one that runs the other way.
#[derive(Clone, Copy, Debug)]
pub struct FreeWave {
    /// λ from one bay to the next on the right; |λ| < 1, or of what carries power to the right where nothing is lost.
    pub lambda: Complex64,
    /// c = (λ + 1/λ)/2 = cos βL
    pub c: Complex64,
    /// h_j(cos γ_jL − c)
    pub(super) delta: [Complex64; 2],
    /// dR/dc of the dispersion R(c) = 0
    slope: Complex64,
    /// The support in this wave, D = P/Q.
    pub(super) support: (Complex64, Complex64),
}

impl FreeWave {
    /// β [rad/m] of e^{iβx}, λ = e^{iβL}, −π < Re βL ≤ π.
    pub fn wavenumber(&self, spacing: f64) -> Complex64 {
        let log = self.lambda.ln();
        Complex64::new(log.im, -log.re) / spacing
    }

    /// Attenuation [dB/m]: −(20/ln 10) ln |λ|/L. Source: Eq. (94), exact.
    pub fn decay_rate(&self, spacing: f64) -> f64 {
        -20.0 * self.lambda.norm().log10() / spacing
    }
}

/// The waves of one frequency.
#[derive(Clone, Debug)]
pub struct FreeWaves {
    pub(super) span: Span,
    /// The slowest decaying first.
    pub waves: Vec<FreeWave>,
}

impl FreeWaves {
    /// Free waves 1 + DS = 0 of a rail on supports D = P(y)/Q(y), a polynomial in c:
    ///
    ///   R(c) = Qδ₁δ₂ + P(s₁δ₂ + s₂δ₁),   δ_j = cos γ_jL − c,   y = 2(1 − c):
    ///
    /// two waves on supports for themselves, one more for every link between neighbours.
    ///
    /// Accuracy: λ to rounding, also where weak supports hardly part c from cos γ_jL (test `analytic::periodic`).
    pub(super) fn new(span: Span, p: &[Complex64], q: &[Complex64]) -> Self {
        let in_c = |polynomial: &[Complex64]| {
            let y = [Complex64::from(2.0), Complex64::from(-2.0)];
            polynomial.iter().rev().fold(vec![], |sum, a| plus(&times(&sum, &y), &[*a]))
        };
        let (mut p, mut q) = (in_c(p), in_c(q));
        trim(&mut p);
        trim(&mut q);
        // supports that never yield: 1e-15 of the rail's own compliance gives their near field a wave of its own
        let hard = 1e-15 * (span.s[0].norm() + span.s[1].norm()) * largest(&p);
        if largest(&q) < hard {
            q = vec![hard.into()];
        }
        let delta = [0, 1].map(|j| [span.delta(Complex64::ZERO)[j], -span.h[j]]);
        let joined = plus(&times(&delta[1], &[span.s[0]]), &times(&delta[0], &[span.s[1]]));
        let dispersion = plus(&times(&q, &times(&delta[0], &delta[1])), &times(&p, &joined));
        let mut waves: Vec<FreeWave> = roots(&dispersion)
            .into_iter()
            .map(|c| {
                let (p, q) = (value_and_slope(&p, c), value_and_slope(&q, c));
                wave(&span, c, p, q)
            })
            .collect();
        waves.sort_by(|a, b| b.lambda.norm().total_cmp(&a.lambda.norm()));
        Self { span, waves }
    }

    /// The parts of the field [m/N] ahead of a unit force for places of the bay in `pair`, with their λ: u = Σ_q λ_qⁿ u_q n bays ahead
    /// (n ≥ 0, without bays to ≥ from),
    ///
    ///   u_q = N_q/(½(λ − 1/λ) dR/dc)_q,   the residues within |λ| = 1 of (1/2πi)∮ λⁿ (N/R) dλ/λ
    pub(super) fn parts(&self, pair: Pair) -> impl Iterator<Item = (Complex64, Complex64)> {
        self.waves.iter().map(move |wave| {
            let (numerator, _) = self.span.quotient(&pair, wave.lambda, wave.support, wave.delta);
            (wave.lambda, numerator / (0.5 * (wave.lambda - 1.0 / wave.lambda) * wave.slope))
        })
    }

    /// K_q of u_q = K_q ψ(x; λ) ψ(x₀; 1/λ), ψ = A₁δ₂ + A₂δ₁: −P/(δ₁δ₂ ½(λ − 1/λ) dR/dc), where supports carry at all.
    pub(super) fn product(wave: &FreeWave) -> Complex64 {
        let [d1, d2] = wave.delta;
        -wave.support.0 / (d1 * d2 * 0.5 * (wave.lambda - 1.0 / wave.lambda) * wave.slope)
    }

    /// The field [m/N] `bays` ≥ 0 bays ahead of a unit force.
    pub(super) fn ahead(&self, pair: &Pair, bays: i32) -> Answer {
        let mut answer = Answer { value: Complex64::ZERO, error: 0.0 };
        for (lambda, part) in self.parts(*pair) {
            let term = part * lambda.powi(bays);
            answer.value += term;
            // one rounding per bay of the phase
            answer.error += 1e-14 * (1.0 + 0.05 * f64::from(bays)) * term.norm();
        }
        answer
    }

    /// Least attenuation of all waves [dB/m]. Source: Eq. (94), exact.
    pub fn decay_rate(&self) -> f64 {
        let least = self.waves.iter().map(|wave| wave.decay_rate(self.span.length));
        least.fold(f64::INFINITY, f64::min)
    }

    /// Waves that travel without attenuation, to 1e-9 a bay.
    pub fn propagating(&self) -> usize {
        self.waves.iter().filter(|wave| (wave.lambda.norm() - 1.0).abs() < 1e-9).count()
    }
}

fn largest(p: &[Complex64]) -> f64 {
    p.iter().map(|c| c.norm()).fold(0.0, f64::max)
}

/// Leaves out leading coefficients that are the rounding of nothing.
fn trim(p: &mut Vec<Complex64>) {
    let least = 1e-16 * largest(p);
    while p.len() > 1 && p.last().is_some_and(|c| c.norm() <= least) {
        p.pop();
    }
}

/// The wave of the root `c`, with P, Q and their slopes there.
fn wave(span: &Span, c: Complex64, p: (Complex64, Complex64), q: (Complex64, Complex64)) -> FreeWave {
    let (s, h) = (span.s, span.h);
    let mut delta = span.delta(c);
    // the one that is a small difference from the other: δ_j = −P s_jδ_k/(Qδ_k + P s_k)
    let small = |j: usize| delta[j].norm() / (1.0 + (h[j] * c).norm());
    let (j, k) = if small(0) < small(1) { (0, 1) } else { (1, 0) };
    let refined = -p.0 * s[j] * delta[k] / (q.0 * delta[k] + p.0 * s[k]);
    if refined.is_finite() && (refined - delta[j]).norm() < 1e-3 * (1.0 + (h[j] * c).norm()) {
        delta[j] = refined;
    }
    // the larger of c ± √(c² − 1), inverted
    let root = (c * c - 1.0).sqrt();
    let large = if (root * c.conj()).re < 0.0 { c - root } else { c + root };
    let mut lambda = 1.0 / large;
    let joined = s[0] * delta[1] + s[1] * delta[0];
    let slope = q.1 * delta[0] * delta[1] + p.1 * joined
        - q.0 * (h[0] * delta[1] + h[1] * delta[0])
        - p.0 * (s[0] * h[1] + s[1] * h[0]);
    if (lambda.norm() - 1.0).abs() < UNDECIDED {
        // H = S + 1/D = R/(Pδ₁δ₂) grows with ω, so that power goes where H grows with β: Im λ dH/dλ < 0
        let along = 0.5 * (lambda - 1.0 / lambda) * slope / (p.0 * delta[0] * delta[1]);
        if along.im > 0.0 {
            lambda = 1.0 / lambda;
        }
    }
    FreeWave { lambda, c, delta, slope, support: (p.0, q.0) }
}

/// A rail on equal supports by its free waves: exact, at any distance.
///
/// Accuracy: 1e-9 and better of published numbers, over 200 bays too (tests `analytic::periodic`).
/// Source: Eqs (71)–(74) with errata.
#[derive(Clone, Copy)]
pub struct Floquet<'a> {
    cell: Cell<'a>,
}

/// What may stand under a method that needs every support for itself.
pub(super) fn uncoupled(cell: &Cell, method: &'static str) -> Result<(), RailError> {
    if cell.coupled() {
        let track = "supports that the ground joins: its waves have no closed form";
        return Err(RailError::Method { method, track, able: "dirac-comb, point-source" });
    }
    Ok(())
}

/// Bays and place in the bay of `x` [m], 0 ≤ place < L.
pub(super) fn place(x: f64, spacing: f64) -> (i64, f64) {
    let bay = (x / spacing).floor();
    // rounding of the division must not put it outside
    let within = (x - bay * spacing).clamp(0.0, spacing);
    if within == spacing { (bay as i64 + 1, 0.0) } else { (bay as i64, within) }
}

/// Bays ≥ 0 from a force at `from` to `x` [m], and both places in their bay, mirrored where `x` lies behind.
pub(super) fn ahead(x: f64, from: f64, spacing: f64) -> (i64, f64, f64) {
    // reciprocity: α(x, x₀) = α(x₀, x)
    let (low, high) = (place(x.min(from), spacing), place(x.max(from), spacing));
    (high.0 - low.0, high.1, low.1)
}

impl<'a> Floquet<'a> {
    /// `supports` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Ground that joins the supports; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        let cell = Cell::new(supports, on)?;
        uncoupled(&cell, "floquet")?;
        Ok(Self { cell })
    }

    /// The bay.
    pub fn cell(&self) -> &Cell<'a> {
        &self.cell
    }

    /// The free waves at `omega` > 0 [rad/s].
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn waves(&self, omega: f64) -> Result<FreeWaves, RailError> {
        let span = Span::new(self.cell.rail(), self.cell.spacing(), omega);
        let (p, q) = match self.cell.support(omega)? {
            Support::Local { p, q } => (p, q),
            // refused at the door
            Support::Coupled { .. } => (vec![], vec![]),
        };
        Ok(FreeWaves::new(span, &p, &q))
    }
}

impl Receptance for Floquet<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        let waves = self.waves(omega)?;
        let spacing = self.cell.spacing();
        let answer = |x: &f64| {
            let (bays, high, low) = ahead(*x, from, spacing);
            waves.ahead(&waves.span.pair(high, low), bays as i32)
        };
        Ok(x.iter().map(answer).collect())
    }

    fn period(&self) -> Option<f64> {
        Some(self.cell.spacing())
    }
}
