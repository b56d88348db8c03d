//! Steps of time by Newmark's rule, with the damping of Hilber, Hughes and Taylor as an option.
//!
//! ```text
//! u* = u + Δt v + Δt²(½ − β)a     v* = v + Δt(1 − γ)a     u⁺ = u* + βΔt²a⁺     v⁺ = v* + γΔt a⁺
//! M a⁺ + (1 + α)(C v⁺ + K u⁺ − f⁺) − α(C v + K u − f) = 0
//! ```
//!
//! α = 0: β = ¼, γ = ½, average acceleration: second order, no damping of its own, and an exact balance of energy,
//! Σ Δt v̄ᵀ(f + f⁺)/2 = Δ(½vᵀMv + ½uᵀKu) + Σ Δt v̄ᵀCv̄, v̄ = (v + v⁺)/2. α from −⅓ to 0: β = (1 − α)²/4, γ = ½ − α.
//! Source: Newmark 1959; Hilber, Hughes & Taylor 1977; Eq. (26).

use super::FemError;
use super::model::Model;
use crate::math::banded::{Banded, Diagonals, Factor};
use crate::quantity::{Bound, OutOfRange, positive};

/// Step and parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Δt [s]
    pub step: f64,
    /// α
    pub alpha: f64,
}

impl Scheme {
    /// Steps of `step` Δt [s] with `alpha` α.
    ///
    /// # Errors
    /// A step that is not positive, α outside −⅓ … 0.
    pub fn new(step: f64, alpha: f64) -> Result<Self, OutOfRange> {
        positive("step", step, "s")?;
        if !(-1.0 / 3.0..=0.0).contains(&alpha) {
            return Err(OutOfRange {
                key: "alpha",
                value: alpha,
                unit: "",
                bound: Bound::Within(-1.0 / 3.0, 0.0),
            });
        }
        Ok(Self { step, alpha })
    }

    /// β
    pub fn beta(&self) -> f64 {
        0.25 * (1.0 - self.alpha).powi(2)
    }

    /// γ
    pub fn gamma(&self) -> f64 {
        0.5 - self.alpha
    }

    /// βΔt² [s²]: displacement per acceleration of the end of a step.
    pub fn per_acceleration(&self) -> f64 {
        self.beta() * self.step * self.step
    }

    /// u* and v* of one unknown from its `u`, `v`, `a`.
    pub fn predict(&self, u: f64, v: f64, a: f64) -> (f64, f64) {
        let t = self.step;
        (u + t * v + t * t * (0.5 - self.beta()) * a, v + t * (1.0 - self.gamma()) * a)
    }
}

/// Displacement, velocity, acceleration of all unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// u
    pub u: Vec<f64>,
    /// v
    pub v: Vec<f64>,
    /// a
    pub a: Vec<f64>,
}

impl State {
    /// At rest, displaced by `u`.
    pub fn at_rest(u: Vec<f64>) -> Self {
        let zero = vec![0.0; u.len()];
        Self { u, v: zero.clone(), a: zero }
    }
}

/// A track that moves on step by step.
pub struct Newmark {
    scheme: Scheme,
    /// S = M + (1 + α)(γΔt C + βΔt² K)
    factor: Factor<f64>,
    damping: Diagonals<f64>,
    stiffness: Diagonals<f64>,
    /// C v* + K u*
    work: Vec<f64>,
}

impl Newmark {
    /// The steps of `scheme` on `model`.
    ///
    /// # Errors
    /// A track that is not held.
    pub fn new(model: &Model, scheme: Scheme) -> Result<Self, FemError> {
        let weigh = 1.0 + scheme.alpha;
        let s: Banded<f64> = (model.mass.clone())
            .plus(weigh * scheme.gamma() * scheme.step, &model.damping)
            .plus(weigh * scheme.per_acceleration(), &model.stiffness);
        let factor = s.factor().ok_or(FemError::Singular)?;
        let (damping, stiffness) = (model.damping.diagonals(), model.stiffness.diagonals());
        Ok(Self { scheme, factor, damping, stiffness, work: vec![0.0; model.mesh.size()] })
    }

    /// Its step and parameters.
    pub fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// Moves `state` on as if nothing pressed at its end, `old` (unknown, force) having pressed at its beginning: what presses at the end
    /// is added by [`Newmark::press`].
    pub fn free(&mut self, state: &mut State, old: &[(usize, f64)]) {
        let Self { scheme, factor, damping, stiffness, work } = self;
        work.fill(0.0);
        if scheme.alpha != 0.0 {
            // α(C v + K u − f), less what (1 + α)(…) is divided by below
            let share = scheme.alpha / (1.0 + scheme.alpha);
            let scaled = |x: &[f64]| x.iter().map(|x| -share * x).collect::<Vec<f64>>();
            damping.multiply(&scaled(&state.v), work);
            stiffness.multiply(&scaled(&state.u), work);
            old.iter().for_each(|&(i, force)| work[i] += share * force);
        }
        for i in 0..state.u.len() {
            (state.u[i], state.v[i]) = scheme.predict(state.u[i], state.v[i], state.a[i]);
        }
        damping.multiply(&state.v, work);
        stiffness.multiply(&state.u, work);
        let weigh = -(1.0 + scheme.alpha);
        state.a.iter_mut().zip(work.iter()).for_each(|(a, r)| *a = weigh * r);
        factor.solve(&mut state.a);
        let (to_u, to_v) = (scheme.per_acceleration(), scheme.gamma() * scheme.step);
        for ((u, v), a) in state.u.iter_mut().zip(&mut state.v).zip(&state.a) {
            *u += to_u * a;
            *v += to_v * a;
        }
    }

    /// Acceleration of the end of a step per unit of force there, (1 + α) S⁻¹N: where its first value stands and all of them, to 1e-18.
    pub fn unit(&self, shape: &[(usize, f64)]) -> (usize, Vec<f64>) {
        let (first, mut near) = self.factor.solve_near(shape, 1e-18);
        near.iter_mut().for_each(|y| *y *= 1.0 + self.scheme.alpha);
        (first, near)
    }

    /// Adds what `force` does with the answer `unit` of its place.
    pub fn press(&self, state: &mut State, (first, unit): &(usize, Vec<f64>), force: f64) {
        let (to_u, to_v) = (self.scheme.per_acceleration(), self.scheme.gamma() * self.scheme.step);
        for (i, y) in unit.iter().enumerate() {
            let a = y * force;
            state.a[first + i] += a;
            state.u[first + i] += to_u * a;
            state.v[first + i] += to_v * a;
        }
    }
}
