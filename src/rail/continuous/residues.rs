//! Contour integration: the residues of ũ(β) at its poles, all of them roots of one polynomial, for loads that stand or move.
//!
//! ```text
//! û(x) = Σ a_j e^{−iγ_j|x|},  a = −i n/(2γ d′),  ũ = n(X)/d(X), X = β² = γ²                    standing
//! w(x′) = ±i Σ n/d′ e^{iβ_j x′},  ũ(β, ω̃ − βv) = n(β)/d(β), Im β_j ≷ 0 for x′ ≷ 0              moving
//! ```
//!
//! Source: Eqs (43)–(48), corrected.

use super::uniform::Uniform;
use crate::math::complex::I;
use crate::math::expression::Polynomial;
use crate::rail::beam_waves::leaving;
use crate::rail::{Answer, Drive, Moving, RailError, Receptance};
use crate::track::{Ratio, Tower};
use num_complex::Complex64;

const NAME: &str = "residues";

/// The waves a standing force sends out.
#[derive(Clone, Debug, PartialEq)]
pub struct Departing {
    /// γ_j [rad/m] with Im γ < 0; where nothing is lost, those that leave.
    pub gamma: Vec<Complex64>,
    /// a_j [m/N]
    pub amplitude: Vec<Complex64>,
    /// Rounding errors of a root X_j, relative: Σ|d_k||X|ᵏ/|X d′|, times 1e-16.
    condition: Vec<f64>,
}

impl Departing {
    /// Those along `tower` at `omega` [rad/s].
    pub fn new(tower: &Tower, omega: f64) -> Option<Self> {
        let Ratio { numerator, denominator } =
            tower.compliance(&Polynomial::variable(), &Polynomial::constant(omega))?;
        let squares = denominator.roots();
        let slopes: Vec<Complex64> = squares.iter().map(|x| denominator.at(*x).1).collect();
        let condition = squares.iter().zip(&slopes).map(|(x, d)| denominator.size(*x) / (x * d).norm());
        let gamma: Vec<Complex64> = squares.iter().map(|x| leaving(*x, omega)).collect();
        let amplitude =
            (0..gamma.len()).map(|j| -I * numerator.at(squares[j]).0 / (2.0 * gamma[j] * slopes[j]));
        Some(Self { condition: condition.collect(), amplitude: amplitude.collect(), gamma })
    }

    /// û [m/N] at `x` [m] from the force, with amplitudes of its own, and how rounding may have changed it.
    pub(super) fn at(&self, amplitude: &[Complex64], x: f64) -> Answer {
        let mut answer = Answer { value: Complex64::ZERO, error: 0.0 };
        for ((gamma, a), condition) in self.gamma.iter().zip(amplitude).zip(&self.condition) {
            let wave = a * (-I * gamma * x.abs()).exp();
            answer.value += wave;
            answer.error += 2e-16 * wave.norm() * (4.0 + condition * (2.0 + (gamma * x).norm()));
        }
        answer
    }
}

/// A rail on springs that answers by residues.
pub struct Residues<'a>(pub(super) Uniform<'a>);

impl Receptance for Residues<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        self.0.check(Drive { omega, speed: 0.0 })?;
        let waves = Departing::new(self.0.tower(NAME)?, omega).ok_or(self.0.unknown(NAME))?;
        Ok(x.iter().map(|x| waves.at(&waves.amplitude, x - from)).collect())
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}

impl Moving for Residues<'_> {
    fn under(&self, drive: Drive, _phase: f64, x: &[f64]) -> Result<Vec<Answer>, RailError> {
        self.0.check(drive)?;
        let ratio = along(self.0.tower(NAME)?, drive);
        let Ratio { numerator, denominator } = ratio.ok_or(RailError::Method {
            method: NAME,
            track: "hysteretic loss or bars under a load that moves",
            able: "adaptive",
        })?;
        let poles: Vec<Pole> = denominator
            .roots()
            .into_iter()
            .map(|beta| Pole::new(beta, &numerator, &denominator, drive))
            .collect();
        Ok(x.iter()
            .map(|&x| {
                let mut answer = Answer { value: Complex64::ZERO, error: 0.0 };
                for pole in poles.iter().filter(|pole| pole.ahead == (x >= 0.0)) {
                    let wave = if pole.ahead { I } else { -I } * pole.residue * (I * pole.beta * x).exp();
                    answer.value += wave;
                    answer.error +=
                        2e-16 * wave.norm() * (4.0 + pole.condition * (2.0 + (pole.beta * x).norm()));
                }
                answer
            })
            .collect())
    }
}

/// ũ(β, ω̃ − βv) as a ratio of polynomials in β; None where it is none.
pub(in crate::rail) fn along(tower: &Tower, drive: Drive) -> Option<Ratio> {
    let beta = Polynomial::variable();
    let omega = Polynomial::new(vec![drive.omega.into(), (-drive.speed).into()]);
    tower.compliance(&(&beta * &beta), &omega)
}

/// A pole of ũ(β, ω̃ − βv).
struct Pole {
    beta: Complex64,
    residue: Complex64,
    /// Its wave is found ahead of the load.
    ahead: bool,
    condition: f64,
}

impl Pole {
    fn new(beta: Complex64, numerator: &Polynomial, denominator: &Polynomial, drive: Drive) -> Self {
        let (n, d) = (numerator.at(beta).0, denominator.at(beta).1);
        // on the real axis: a little loss iη sgn ω added to 1/ũ moves the pole by −iη sgn ω n/d′
        let side =
            if beta.im.abs() > 1e-12 * beta.norm() { beta.im } else { -drive.at(beta.re) * (n / d).re };
        Self {
            beta,
            residue: n / d,
            ahead: side > 0.0,
            condition: denominator.size(beta) / (beta * d).norm(),
        }
    }
}
