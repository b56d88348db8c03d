//! Frequencies that mark a track on equal supports, without damping: resonances of the supports, pinned–pinned modes, stop bands.

use super::floquet::FreeWaves;
use super::span::Span;
use super::{Floquet, Support};
use crate::foundation::FoundationError;
use crate::math::polynomial::value;
use crate::math::root::bracketed;
use crate::rail::RailError;
use crate::track::{Member, Supports};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Steps in which changes of sign are looked for: at least so many Hz, and this share of the frequency.
const LEAST: f64 = 0.5;
const STEP: f64 = 2e-3;
/// Bands narrower than this [Hz] are not told.
const NARROW: f64 = 1e-4;

/// What lies at a frequency.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Landmark {
    /// The rail starts to move with its supports as masses on springs: K(ω) = mω² of the track as if continuous.
    CutOn,
    /// The supports hold the rail still: D = ∞.
    Antiresonance,
    /// Half waves of the rail between supports that it does not move, γL = π, 2π, …: without loss in the rail itself its receptance
    /// in the middle of a bay has no bound there.
    PinnedPinned,
    /// A range ends in which so many waves travel.
    BandEdge,
}

/// A range of frequencies, and how many waves travel there without damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// [Hz]
    pub from: f64,
    /// [Hz]
    pub to: f64,
    /// Waves that travel either way; 0 in a stop band.
    pub waves: usize,
}

/// Undamped landmarks of a rail on equal supports.
pub struct Undamped<'a> {
    floquet: &'a Floquet<'a>,
    supports: Supports,
}

impl<'a> Undamped<'a> {
    /// Those of the track of `floquet`, all loss taken out.
    pub fn new(floquet: &'a Floquet<'a>) -> Self {
        Self { floquet, supports: floquet.cell().undamped() }
    }

    /// P, Q of a support at `omega` [rad/s].
    fn support(&self, omega: f64) -> Result<(Vec<Complex64>, Vec<Complex64>), FoundationError> {
        let ground = self.floquet.cell().ground(omega)?;
        Ok(self.supports.rational(omega, ground.re.into()))
    }

    /// Cut-ons, antiresonances and pinned–pinned frequencies below `highest` [Hz], ascending.
    ///
    /// Cut-ons are zeros of P − mLω²Q and antiresonances those of Q, at β = 0, where D = P/Q.
    ///
    /// Accuracy: rounding of the springs (test `analytic::periodic_bands`).
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn landmarks(&self, highest: f64) -> Result<Vec<(Landmark, f64)>, RailError> {
        let rail = |omega: f64| self.supports.rail.stiffness(Complex64::ZERO, omega).re;
        let at = |omega: f64, with_rail: bool| -> Result<f64, FoundationError> {
            let (p, q) = self.support(omega)?;
            let (p, q) = (value(&p, Complex64::ZERO).re, value(&q, Complex64::ZERO).re);
            Ok(if with_rail { p + self.supports.spacing * rail(omega) * q } else { q })
        };
        let cut_ons = changes(|omega| at(omega, true), highest)?;
        let still = changes(|omega| at(omega, false), highest)?;
        let mut marks: Vec<(Landmark, f64)> = Vec::new();
        marks.extend(cut_ons.into_iter().map(|f| (Landmark::CutOn, f)));
        marks.extend(still.into_iter().map(|f| (Landmark::Antiresonance, f)));
        let pinned = (1..).map(|n| pinned_pinned(&self.supports.rail, self.supports.spacing, n));
        let pinned = pinned.map_while(|f| f.filter(|f| *f < highest));
        marks.extend(pinned.map(|f| (Landmark::PinnedPinned, f)));
        marks.sort_by(|a, b| a.1.total_cmp(&b.1));
        Ok(marks)
    }

    /// How many waves travel, from 0 to `highest` [Hz]: pass and stop bands.
    ///
    /// Edges are where a wave meets its own return, R(c = ±1) = 0, or another one, the discriminant of R.
    ///
    /// Accuracy: edges to 1e-9 (test `analytic::periodic_bands`); bands narrower than 1e-4 Hz are left out.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn bands(&self, highest: f64) -> Result<Vec<Band>, RailError> {
        let mut edges = Vec::new();
        for edge in [Edge::Same, Edge::Opposite, Edge::Double] {
            edges.extend(changes(|omega| self.edge(edge, omega), highest)?);
        }
        edges.sort_by(f64::total_cmp);
        let mut bands: Vec<Band> = Vec::new();
        let ends = edges.iter().copied().chain([highest]);
        let mut from = 0.0;
        for to in ends.filter(|to| *to > 0.0) {
            if to - from < NARROW && to < highest {
                continue;
            }
            let waves = self.waves(TAU * 0.5 * (from + to))?.propagating();
            match bands.last_mut() {
                Some(last) if last.waves == waves => last.to = to,
                _ => bands.push(Band { from, to, waves }),
            }
            from = to;
        }
        Ok(bands)
    }

    fn waves(&self, omega: f64) -> Result<FreeWaves, FoundationError> {
        let (p, q) = self.support(omega)?;
        Ok(FreeWaves::new(Span::new(&self.supports.rail, self.supports.spacing, omega), &p, &q))
    }

    /// What changes its sign where bands end.
    fn edge(&self, edge: Edge, omega: f64) -> Result<f64, FoundationError> {
        let (p, q) = self.support(omega)?;
        let span = Span::new(&self.supports.rail, self.supports.spacing, omega);
        // R/(h₁h₂), real without damping, of the phase 0 or π
        let dispersion = |theta: f64| {
            let (p, q) = Support::Local { p: p.clone(), q: q.clone() }.at(theta);
            let delta = span.delta_at(theta);
            let joined = span.s[0] * delta[1] + span.s[1] * delta[0];
            ((q * delta[0] * delta[1] + p * joined) / (span.h[0] * span.h[1])).re
        };
        Ok(match edge {
            Edge::Same => dispersion(0.0),
            Edge::Opposite => dispersion(PI),
            Edge::Double => {
                let waves = FreeWaves::new(span, &p, &q).waves;
                let pairs = (0..waves.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
                pairs.map(|(i, j)| (waves[i].c - waves[j].c).powi(2)).product::<Complex64>().re
            }
        })
    }
}

#[derive(Clone, Copy)]
enum Edge {
    /// Neighbouring bays move alike, c = 1.
    Same,
    /// They move against one another, c = −1.
    Opposite,
    /// Two waves are one.
    Double,
}

/// Frequencies [Hz] below `highest` where `f`(ω) changes its sign.
fn changes(
    f: impl Fn(f64) -> Result<f64, FoundationError> + Sync,
    highest: f64,
) -> Result<Vec<f64>, FoundationError> {
    let mut ends = vec![LEAST];
    while ends[ends.len() - 1] < highest {
        let last = ends[ends.len() - 1];
        ends.push((last + LEAST.max(STEP * last)).min(highest));
    }
    let values: Vec<f64> = ends.par_iter().map(|frequency| f(TAU * frequency)).collect::<Result<_, _>>()?;
    let mut found = Vec::new();
    for (ends, values) in ends.windows(2).zip(values.windows(2)) {
        if values[0] * values[1] < 0.0 {
            let mut failure = None;
            let root = bracketed(
                |omega| {
                    f(omega).unwrap_or_else(|error| {
                        failure = Some(error);
                        0.0
                    })
                },
                TAU * ends[0],
                TAU * ends[1],
                1e-14,
            );
            if let Some(error) = failure {
                return Err(error);
            }
            found.extend(root.map(|omega| omega / TAU));
        }
    }
    Ok(found)
}

/// The frequency [Hz] at which `half_waves` half waves of `rail` stand between supports `spacing` [m] apart that do not yield,
/// γL = nπ: EB ω = q √(EI/m), q = (nπ/L)²; T (ρIm/EIκGA)ω⁴ − (m/EI + qm/κGA + qρI/EI)ω² + q² = 0. None for a rail without mass.
///
/// Accuracy: rounding (test `analytic::periodic_bands`). Source: Eqs (71)–(74), corrected.
pub fn pinned_pinned(rail: &Member, spacing: f64, half_waves: u32) -> Option<f64> {
    let q = Complex64::from((PI * f64::from(half_waves) / spacing).powi(2));
    let undamped = rail.undamped();
    // d(q, ω) = 0, the numerator of the beam's own stiffness, falls from EIq² at ω = 0
    let stiffness = |omega: f64| {
        let (_, d) = undamped.rational(omega, Complex64::ZERO);
        (d[0] + (d[1] + d[2] * q) * q).re
    };
    let mut high = 1.0;
    while stiffness(high) > 0.0 {
        high *= 1.2;
        if high > 1e9 {
            return None;
        }
    }
    bracketed(stiffness, high / 1.2, high, 1e-15).map(|omega| omega / TAU)
}
