//! A moving load as one standing force after another, Eqs (62)–(64), corrected.

use super::floquet::{Floquet, FreeWaves, place};
use super::passing::{accuracy, gently, longest, settle};
use super::span::Span;
use super::tail::Tail;
use crate::foundation::Foundation;
use crate::math::complex::{I, one_minus_exp_over};
use crate::rail::{Answer, Drive, Moving, RailError, Receptance};
use crate::track::Supports;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A rail on equal supports under a load that moves, by its receptance at all places of the load:
///
///   û(x, ω) = (1/v) ∫ α(x, x₀; ω) e^{ib₀x₀} dx₀,   b₀ = (ω̃ − ω)/v
///
/// over one bay wave by wave, α = Σ_q K_q ψ(x; λ)ψ(x₀; 1/λ) with ψ of the waves e^{±iγx} of the bare rail, over all others as geometric
/// sums. It shares nothing with images in the wavenumber, and checks them.
///
/// Accuracy: 1e-9 of the spectrum, 1e-12 of what its parts are where they cancel (test `cross_solver::periodic_moving`).
/// Source: Eqs (62)–(64).
#[derive(Clone, Copy)]
pub struct MovingGreen<'a> {
    floquet: Floquet<'a>,
}

impl<'a> MovingGreen<'a> {
    /// `supports` on `on`, whose k is per metre of track.
    ///
    /// # Errors
    /// Ground that joins the supports; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        Ok(Self { floquet: Floquet::new(supports, on)? })
    }

    /// û(x, ω) [m s/N] at `x` [m] of a unit load e^{iω̃t} that moves as `drive`, over the support x = 0 at t = 0, for `omega` ≠ 0
    /// [rad/s].
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn spectrum(&self, drive: Drive, x: f64, omega: f64) -> Result<Complex64, RailError> {
        Ok(self.heard(drive, x, omega)? / drive.speed)
    }

    /// v û(x, ω).
    fn heard(&self, drive: Drive, x: f64, omega: f64) -> Result<Complex64, RailError> {
        if omega < 0.0 {
            // α(−ω) is the conjugate of α(ω)
            return Ok(self.heard(Drive { omega: -drive.omega, ..drive }, x, -omega)?.conj());
        }
        let length = self.floquet.cell().spacing();
        let b = (drive.omega - omega) / drive.speed;
        let waves = self.floquet.waves(omega)?;
        let (bay, place) = place(x, length);
        let span = &waves.span;
        let mut sum = Complex64::ZERO;
        for wave in &waves.waves {
            let [ahead, back] = [wave.lambda, 1.0 / wave.lambda].map(|lambda| span.ways(lambda, wave.delta));
            // forces in this bay at y ≤ x and in all before, z = λe^{−ibL}; at y ≥ x and in all behind, z = λe^{ibL}
            let rest = |turn: f64| {
                let z = wave.lambda * Complex64::cis(turn * b * length);
                z / (1.0 - z)
            };
            let before =
                over(span, &back, b, (0.0, length)) * rest(-1.0) + over(span, &back, b, (0.0, place));
            let behind =
                over(span, &ahead, b, (0.0, length)) * rest(1.0) + over(span, &ahead, b, (place, length));
            let here = [ahead, back].map(|ways| at(span, &ways, place));
            sum += FreeWaves::product(wave) * (here[0] * before + here[1] * behind);
        }
        Ok(sum * Complex64::cis((b * length * bay as f64) % TAU))
    }
}

/// A wave of these `ways` at `x` [m] of the bay.
fn at(span: &Span, ways: &[[Complex64; 2]; 2], x: f64) -> Complex64 {
    let wave = |j: usize| {
        let turn = |d: f64| (-I * span.waves.gamma[j] * d).exp();
        ways[j][0] * turn(x) + ways[j][1] * turn(span.length - x)
    };
    wave(0) + wave(1)
}

/// Its integral times e^{ibx} between two places: ∫e^{−iγx + ibx} from the lower one on, ∫e^{−iγ(L − x) + ibx} from the upper one back.
fn over(span: &Span, ways: &[[Complex64; 2]; 2], b: f64, (from, to): (f64, f64)) -> Complex64 {
    let d = to - from;
    let part = |j: usize| {
        let gamma = span.waves.gamma[j];
        let rise = |z: Complex64| d * one_minus_exp_over(z, (-z).exp());
        let right = (I * (b - gamma) * from).exp() * rise(I * (gamma - b) * d);
        let left = (I * b * to - I * gamma * (span.length - to)).exp() * rise(I * (gamma + b) * d);
        ways[j][0] * right + ways[j][1] * left
    };
    part(0) + part(1)
}

impl Moving for MovingGreen<'_> {
    fn under(&self, drive: Drive, phase: f64, x: &[f64]) -> Result<Vec<Answer>, RailError> {
        if drive.speed == 0.0 {
            let at: Vec<f64> = x.iter().map(|x| phase + x).collect();
            return self.floquet.at(&at, phase, drive.omega);
        }
        let cell = self.floquet.cell();
        cell.check(drive.omega)?;
        let tail = Tail::new(cell.rail(), drive, cell.spacing())?;
        let half = drive.omega == 0.0;
        let share = if half { 2.0 } else { 1.0 };
        let asked = (drive, longest(cell, drive));
        let one = |x: &f64| {
            let mut failure = None;
            let mut integrand = |b: f64| {
                let beside = |omega: f64| {
                    let b = (drive.omega - omega) / drive.speed;
                    let field = self.heard(drive, phase + x, omega)? * Complex64::cis(-b * (phase + x));
                    Ok((field - tail.at(b)) * Complex64::cis(b * x))
                };
                gently(asked, b, beside).unwrap_or_else(|error: RailError| {
                    failure = Some(error);
                    Complex64::ZERO
                })
            };
            let goal = (x.abs(), TAU / share * tail.field(*x), accuracy(&tail));
            let settled = settle(&mut integrand, (drive, cell.spacing()), half, goal);
            if let Some(error) = failure {
                return Err(error);
            }
            let value = settled.value * share / TAU + tail.field(*x);
            Ok(Answer {
                value: if half { value.re.into() } else { value },
                error: settled.error * share / TAU,
            })
        };
        x.iter().map(one).collect()
    }
}
