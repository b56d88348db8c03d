//! The bare rail between two supports at one frequency, in waves that repeat from bay to bay.

use crate::math::complex::I;
use crate::rail::BeamWaves;
use crate::track::Member;
use num_complex::Complex64;

/// The two waves of the bare rail over one bay. With λ the factor from bay to bay, c = (λ + 1/λ)/2, and unit forces λⁿ at x = nL,
///
///   φ(x; λ) = Σ_n λⁿ g(x − nL) = Σ_j A_j(x; λ)/δ_j,   A_j = i a_j [sin γ_j(L − x) + λ sin γ_j x],   δ_j = cos γ_jL − c,   0 ≤ x ≤ L;
///
/// all of them times h_j = 2e^{−iγ_jL}, so that nothing grows with the decaying wave.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    /// L [m]
    pub length: f64,
    pub waves: BeamWaves,
    /// h_j = 2e^{−iγ_jL}
    pub h: [Complex64; 2],
    /// h_j cos γ_jL
    cos: [Complex64; 2],
    /// h_j i a_j sin γ_jL [m/N], what A_j is at a support.
    pub s: [Complex64; 2],
}

impl Span {
    /// The bare `rail` over `length` [m] at `omega` [rad/s].
    pub fn new(rail: &Member, length: f64, omega: f64) -> Self {
        let waves = BeamWaves::new(rail, omega, Complex64::ZERO);
        let turn = waves.gamma.map(|gamma| (-I * gamma * length).exp());
        let h = turn.map(|e| 2.0 * e);
        let cos = turn.map(|e| 1.0 + e * e);
        let mut span = Self { length, waves, h, cos, s: [Complex64::ZERO; 2] };
        span.s = [0, 1].map(|j| span.sine(j, length));
        span
    }

    /// h_j i a_j sin γ_j`x` [m/N], 0 ≤ x ≤ L.
    fn sine(&self, j: usize, x: f64) -> Complex64 {
        let (gamma, a) = (self.waves.gamma[j], self.waves.amplitude[j]);
        // e^{−iγ(L − x)} − e^{−iγ(L + x)}
        let ends = [self.length - x, self.length + x].map(|d| (-I * gamma * d).exp());
        a * (ends[0] - ends[1])
    }

    /// Whether wave `j` dies out within a bay, so far that b ≠ ±γ_j for all real b.
    pub fn decays(&self, j: usize) -> bool {
        (self.waves.gamma[j] * self.length).im < -1.0
    }

    /// h_j(cos γ_jL − c) for `c`.
    pub fn delta(&self, c: Complex64) -> [Complex64; 2] {
        [0, 1].map(|j| self.cos[j] - self.h[j] * c)
    }

    /// h_j(cos γ_jL − cos θ) for real θ = `theta`: h_j 2 sin((θ + γ_jL)/2) sin((θ − γ_jL)/2), exact where it is small.
    pub fn delta_at(&self, theta: f64) -> [Complex64; 2] {
        [0, 1].map(|j| {
            let phase = self.waves.gamma[j] * self.length;
            if self.decays(j) {
                return self.cos[j] - self.h[j] * theta.cos();
            }
            2.0 * self.h[j] * (0.5 * (theta + phase)).sin() * (0.5 * (theta - phase)).sin()
        })
    }

    /// h_j A_j at `x` [m] of the bay for the factor `lambda`.
    pub fn shape(&self, x: f64, lambda: Complex64) -> [Complex64; 2] {
        [0, 1].map(|j| self.sine(j, self.length - x) + lambda * self.sine(j, x))
    }

    /// Amplitudes of e^{−iγ_jx} and of e^{−iγ_j(L − x)}, for j = 1 and 2, in h₁h₂(A₁δ₂ + A₂δ₁), a wave with the factor `lambda`.
    pub fn ways(&self, lambda: Complex64, delta: [Complex64; 2]) -> [[Complex64; 2]; 2] {
        [0, 1].map(|j| {
            let (a, turn) = (self.waves.amplitude[j] * delta[1 - j], 0.5 * self.h[j]);
            [a * (1.0 - lambda * turn), a * (lambda - turn)]
        })
    }
}

/// Two places of a bay, and what is the same for all waves between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    from: f64,
    to: f64,
    /// h_j 2a_j² sin γ_j(L − larger) sin γ_j smaller
    inner: [Complex64; 2],
    /// B_j of the distance: the sines of L − d and of d.
    distance: [[Complex64; 2]; 2],
    /// Those of the places: of L − x and of x.
    sines: [[[Complex64; 2]; 2]; 2],
}

impl Span {
    /// The places `to` and `from` [m] of a bay.
    pub fn pair(&self, to: f64, from: f64) -> Pair {
        let (low, high) = (to.min(from), to.max(from));
        let both = |x: f64| [0, 1].map(|j| [self.sine(j, self.length - x), self.sine(j, x)]);
        let inner = [0, 1].map(|j| -2.0 * self.sine(j, self.length - high) * self.sine(j, low) / self.h[j]);
        Pair { from, to, inner, distance: both(high - low), sines: [both(to), both(from)] }
    }

    /// N and R, both times h₁h₂, whose quotient is the field at `to` of the bay of a unit force at `from`, of all bays with factor
    /// `lambda`, on supports D = `p`/`q`; δ_j of the same wave in `delta`.
    ///
    /// S(x − x₀) − S(x)S(−x₀)/(1/D + S(0)), S = φ: over the common denominator the bare rail's poles cancel,
    ///
    ///   N = Q(B₁δ₂ + B₂δ₁) + P[B₁s₂ + B₂s₁ − A₁A₂′ − A₂A₁′ − 2Σ_j a_j²δ_k sin γ_j(L − x₊) sin γ_j x₋],   R = Qδ₁δ₂ + P(s₁δ₂ + s₂δ₁)
    ///
    /// with B of the distance, A of x, A′ of x₀ for 1/λ, x₋ and x₊ the smaller and the larger of both.
    pub fn quotient(
        &self,
        pair: &Pair,
        lambda: Complex64,
        (p, q): (Complex64, Complex64),
        delta: [Complex64; 2],
    ) -> (Complex64, Complex64) {
        let back = 1.0 / lambda;
        let join = |sines: &[[Complex64; 2]; 2], lambda: Complex64| {
            [0, 1].map(|j| sines[j][0] + lambda * sines[j][1])
        };
        let b = join(&pair.distance, if pair.to >= pair.from { lambda } else { back });
        let (a, a_back) = (join(&pair.sines[0], lambda), join(&pair.sines[1], back));
        let s = self.s;
        let crossed = b[0] * s[1] + b[1] * s[0] - a[0] * a_back[1] - a[1] * a_back[0];
        let inner = pair.inner[0] * delta[1] + pair.inner[1] * delta[0];
        let numerator = q * (b[0] * delta[1] + b[1] * delta[0]) + p * (crossed - inner);
        (numerator, q * delta[0] * delta[1] + p * (s[0] * delta[1] + s[1] * delta[0]))
    }
}
