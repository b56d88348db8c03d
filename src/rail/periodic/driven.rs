//! The rail on equal supports at one frequency of a moving load, in images of the wavenumber, Eqs (57)–(61), corrected.

use super::cell::Cell;
use super::floquet::place;
use super::span::Span;
use crate::foundation::FoundationError;
use crate::math::complex::I;
use crate::rail::Drive;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A unit load e^{iω̃t} that stands over the support x = 0 at t = 0, as far as it is heard at one ω.
pub(super) struct Driven {
    span: Span,
    /// b₀ = (ω̃ − ω)/v [rad/m]
    pub b: f64,
    /// D = P/Q in the wave of b₀.
    support: (Complex64, Complex64),
    /// n₀, n₁, d₂ of 1/D_r = (n₀ + n₁b²)/(d₂(b² − γ₁²)(b² − γ₂²)).
    rail: [Complex64; 3],
    /// h₁h₂R
    dispersion: Complex64,
    /// Δ_j = h_j(cos γ_jL − cos b₀L)/(b₀² − γ_j²)
    smooth: [Complex64; 2],
}

/// sin z/z.
fn sinc(z: Complex64) -> Complex64 {
    if z.norm_sqr() < 1e-8 { 1.0 - z * z / 6.0 } else { z.sin() / z }
}

impl Driven {
    /// The track of `cell` under `drive` at `omega` ≠ 0 [rad/s].
    pub fn new(cell: &Cell, drive: Drive, omega: f64) -> Result<Self, FoundationError> {
        let length = cell.spacing();
        let b = (drive.omega - omega) / drive.speed;
        let span = Span::new(cell.rail(), length, omega);
        let theta = b * length;
        let support = cell.support(omega)?.at(theta);
        let (n, d) = cell.rail().rational(omega, Complex64::ZERO);
        let delta = span.delta_at(theta);
        let joined = span.s[0] * delta[1] + span.s[1] * delta[0];
        let smooth = [0, 1].map(|j| {
            let gamma = span.waves.gamma[j];
            let (sum, rest) = (b + gamma, b - gamma);
            if span.decays(j) {
                return delta[j] / (sum * rest);
            }
            // cos γL − cos bL = 2 sin((b + γ)L/2) sin((b − γ)L/2)
            span.h[j] * (0.5 * length * length) * sinc(0.5 * length * sum) * sinc(0.5 * length * rest)
        });
        let dispersion = support.1 * delta[0] * delta[1] + support.0 * joined;
        Ok(Self { span, b, support, rail: [n[0], n[1], d[2]], dispersion, smooth })
    }

    /// Ψ_j = h_j i a_j [sin γ_jL e^{ibx} − sin γ_j(L − x) − e^{ibL} sin γ_jx]/(b² − γ_j²), smooth where b = ±γ_j.
    fn between(&self, j: usize, x: f64) -> Complex64 {
        let (gamma, length, b) = (self.span.waves.gamma[j], self.span.length, self.b);
        let turn = |x: f64| Complex64::cis(b * x);
        if self.span.decays(j) {
            let held = self.span.shape(x, turn(length))[j];
            return (self.span.s[j] * turn(x) - held) / ((b + gamma) * (b - gamma));
        }
        // odd in γ: of ±γ the one nearer to b; e^{ibx} − e^{iγx} = 2i sin((b − γ)x/2) e^{i(b + γ)x/2}
        let nearer = (b + gamma).norm() < (b - gamma).norm();
        let (near, sign) = if nearer { (-gamma, -1.0) } else { (gamma, 1.0) };
        let (sum, rest) = (b + near, b - near);
        let rise = |x: f64| I * x * sinc(0.5 * rest * x) * (I * (0.5 * sum * x)).exp();
        let bracket = (near * length).sin() * rise(x) - (near * x).sin() * rise(length);
        sign * I * self.span.waves.amplitude[j] * self.span.h[j] * bracket / sum
    }

    /// v û(x, ω) [m²/N]:
    ///
    ///   G₀[e^{ib₀x} − S(x)/(1/D + S(0))] = (n/d₂) [QΔ₁Δ₂e^{ib₀x} + P(Ψ₁Δ₂ + Ψ₂Δ₁)]/R,   G = 1/D_r
    ///
    /// where the bare rail's waves, b = ±γ, are no poles.
    pub fn at(&self, x: f64) -> Complex64 {
        let (bays, x) = place(x, self.span.length);
        let ((p, q), [d1, d2]) = (self.support, self.smooth);
        let held = self.between(0, x) * d2 + self.between(1, x) * d1;
        let field = q * d1 * d2 * Complex64::cis(self.b * x) + p * held;
        let turn = Complex64::cis((self.b * self.span.length * bays as f64) % TAU);
        turn * self.numerator(self.b) * field / self.dispersion
    }

    /// n(b²)/d₂
    fn numerator(&self, b: f64) -> Complex64 {
        (self.rail[0] + self.rail[1] * b * b) / self.rail[2]
    }

    /// What 2πW_j is the integral of over b₀ [m²/N]: (δ_j0 − G_j/(L(1/D + S(0)))) G₀, G_j at b₀ + 2πj/L.
    ///
    /// W₀ as the mean of `at` over a bay, in which G₀ does not cancel: that of Ψ_j is h_j i a_j [sin γ_jL − 2γ_jΔ_j/L]/(b² − γ_j²).
    pub fn harmonic(&self, order: i32) -> Complex64 {
        let [g1, g2] = self.span.waves.gamma;
        let ((p, q), [d1, d2], length) = (self.support, self.smooth, self.span.length);
        if order == 0 {
            let mean = |j: usize| {
                let gamma = self.span.waves.gamma[j];
                let share = I * self.span.waves.amplitude[j] * 2.0 * gamma / length;
                (self.span.s[j] - share * self.smooth[j]) / ((self.b + gamma) * (self.b - gamma))
            };
            let field = q * d1 * d2 + p * (mean(0) * d2 + mean(1) * d1);
            return self.numerator(self.b) * field / self.dispersion;
        }
        // G₀/(1/D + S) = (n/d₂)Δ₁Δ₂P/R
        let force = self.numerator(self.b) * d1 * d2 * p / self.dispersion;
        let b = self.b + TAU * f64::from(order) / length;
        -self.numerator(b) / ((b + g1) * (b - g1) * (b + g2) * (b - g2)) * force / length
    }
}
