//! The two waves of a beam on springs that a force sends out, Σ a_j e^{−iγ_j|x|}.

use crate::math::complex::{I, sign};
use crate::track::Member;
use num_complex::Complex64;

/// û(x) = Σ_j a_j e^{−iγ_j|x|} under a unit force at x = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamWaves {
    /// γ_j [rad/m] with Im γ < 0; where nothing is lost, the wave that leaves.
    pub gamma: [Complex64; 2],
    /// a_j [m/N]
    pub amplitude: [Complex64; 2],
}

impl BeamWaves {
    /// The waves of `beam` at `omega` ≠ 0 [rad/s] on springs of `support` = K [N/m²] per metre; K = 0 for the bare beam.
    ///
    /// ũ = n(X)/d(X), X = β²: γ² are the roots of d, a = −i n/(2γ d′) by residues. One lossless wave at X > 0 leaves as
    /// η → 0⁺: γ > 0 for ω > 0.
    ///
    /// Accuracy: rounding. Source: Eqs (30)–(32), (51), (90)–(93), corrected.
    pub fn new(beam: &Member, omega: f64, support: Complex64) -> Self {
        let (n, d) = beam.rational(omega, support);
        // the larger root without cancellation, the other by Vieta
        let root = (d[1] * d[1] - 4.0 * d[0] * d[2]).sqrt();
        let root = if (root * d[1].conj()).re < 0.0 { -root } else { root };
        let q = -0.5 * (d[1] + root);
        let mut squares = [q / d[2], d[0] / q];
        // γ₁ is the one that travels
        if squares[0].re < squares[1].re {
            squares.swap(0, 1);
        }
        let gamma = squares.map(|square| leaving(square, omega));
        let amplitude = [0, 1].map(|j| {
            let x = squares[j];
            -I * (n[0] + n[1] * x) / (2.0 * gamma[j] * (d[1] + 2.0 * d[2] * x))
        });
        Self { gamma, amplitude }
    }

    /// û [m/N] at `x` [m] from the force.
    pub fn at(&self, x: f64) -> Complex64 {
        let wave = |j: usize| self.amplitude[j] * (-I * self.gamma[j] * x.abs()).exp();
        wave(0) + wave(1)
    }
}

/// √X with Im < 0, or of the sign of ω where it is real: e^{i(ωt − γ|x|)} decays or leaves.
pub(super) fn leaving(square: Complex64, omega: f64) -> Complex64 {
    let root = square.sqrt();
    if root.im == 0.0 {
        return Complex64::new(root.re.abs() * if sign(omega) < 0.0 { -1.0 } else { 1.0 }, 0.0);
    }
    if root.im > 0.0 { -root } else { root }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_those_of_the_beams_in_closed_form() {
        let (ei, ga, rho_i, m, omega) = (6.38e6, 2.364e8, 0.239, 60.23, 1500.0f64);
        let k = Complex64::new(4.5e8, 9e7);
        // EB: γ⁴ = (mω² − K)/EI, a = −i/(4EIγ³)
        let waves = BeamWaves::new(&Member::beam(ei, m, 0.0).unwrap(), omega, k);
        for (gamma, a) in waves.gamma.iter().zip(&waves.amplitude) {
            let fourth = (m * omega * omega - k) / ei;
            assert!((gamma.powi(4) - fourth).norm() < 1e-13 * fourth.norm() && gamma.im < 0.0);
            assert!((a + I / (4.0 * ei * gamma.powi(3))).norm() < 1e-13 * a.norm());
        }
        // T: γ⁴ + A₂γ² + A₃ = 0, a = −i(γ² + A₁)/(κGA(4γ³ + 2A₂γ))
        let waves = BeamWaves::new(&Member::timoshenko(ei, m, ga, rho_i, 0.0).unwrap(), omega, k);
        let w2 = omega * omega;
        let a1 = (ga - rho_i * w2) / ei;
        let a2 = (k - m * w2) / ga - rho_i * w2 / ei;
        let a3 = (k - m * w2) / ei * (1.0 - rho_i * w2 / ga);
        for (gamma, a) in waves.gamma.iter().zip(&waves.amplitude) {
            let g2 = gamma * gamma;
            assert!((g2 * g2 + a2 * g2 + a3).norm() < 1e-13 * a3.norm() && gamma.im < 0.0);
            let exact = -I * (g2 + a1) / (ga * (4.0 * gamma * g2 + 2.0 * a2 * gamma));
            assert!((a - exact).norm() < 1e-13 * exact.norm());
        }
        // nothing lost, bare: one wave leaves, one decays
        let bare = BeamWaves::new(&Member::beam(ei, m, 0.0).unwrap(), omega, Complex64::ZERO);
        assert!(bare.gamma[0].re > 0.0 && bare.gamma[0].im == 0.0 && bare.gamma[1].im < 0.0);
        assert!(bare.gamma[1].re.abs() < 1e-12);
    }
}
