//! The waves of one section of equal supports, cells cut in the middle between them: fields, states, what a force sends out.

use super::floquet::{FreeWaves, ahead, place};
use super::span::Span;
use crate::math::complex::I;
use crate::track::Member;
use nalgebra::{Matrix4, Vector4};
use num_complex::Complex64;

/// A displacement [m], and what it is the sum of.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Field {
    pub value: Complex64,
    pub size: f64,
}

impl Field {
    /// One more part.
    pub fn add(&mut self, part: Complex64) {
        self.value += part;
        self.size += part.norm();
    }
}

/// w, φ, −Q, −M: displacement, rotation, and what the left part does to the right one.
pub(super) type State = [Complex64; 4];

/// One wave to the right, as it is behind a support.
#[derive(Clone, Copy, Debug)]
struct Shape {
    lambda: Complex64,
    /// Amplitudes of e^{−iγ_jx} and e^{−iγ_j(L − x)}.
    parts: [[Complex64; 2]; 2],
}

/// All waves of a section at one frequency.
pub(super) struct Waves {
    free: FreeWaves,
    shapes: [Shape; 2],
    /// φ, −Q, −M per displacement of e^{iγ_jx}; the first and the second change their sign for e^{−iγ_jx}.
    carried: [[Complex64; 3]; 2],
}

/// The same state seen in a mirror.
fn mirrored(state: State) -> State {
    [state[0], -state[1], -state[2], state[3]]
}

impl Waves {
    /// Those of a `rail` on supports with the waves `free` at `omega` [rad/s]; None unless there are two of them.
    pub fn new(rail: &Member, omega: f64, free: FreeWaves) -> Option<Self> {
        let [a, b] = free.waves[..] else { return None };
        let span = &free.span;
        let carried = [0, 1].map(|j| rail.carried(span.waves.gamma[j], omega));
        let shapes = [a, b].map(|wave| {
            let parts = span.ways(wave.lambda, wave.delta);
            Shape { lambda: wave.lambda, parts }
        });
        let mut waves = Self { shapes, carried, free };
        let half = 0.5 * waves.span().length;
        for q in 0..2 {
            // of the size of one displacement or rotation in the middle
            let state = waves.after(q, half);
            let size = state[0].norm() + half * state[1].norm();
            waves.shapes[q].parts.iter_mut().flatten().for_each(|part| *part /= size);
        }
        Some(waves)
    }

    fn span(&self) -> &Span {
        &self.free.span
    }

    /// λ of wave `q`.
    pub fn lambda(&self, q: usize) -> Complex64 {
        self.shapes[q].lambda
    }

    /// What w, φ, −Q, −M are measured in.
    pub fn scale(&self) -> [f64; 4] {
        let [a, b] = self.carried;
        let largest = [0, 1, 2].map(|part| a[part].norm().max(b[part].norm()));
        [1.0, largest[0], largest[1], largest[2]]
    }

    /// The state of wave `q` to the right at `x` [m] behind a support, 0 ≤ x ≤ L.
    fn after(&self, q: usize, x: f64) -> State {
        let mut state = [Complex64::ZERO; 4];
        for j in 0..2 {
            let gamma = self.span().waves.gamma[j];
            let [right, left] = self.shapes[q].parts[j];
            let right = right * (-I * gamma * x).exp();
            let left = left * (-I * gamma * (self.span().length - x)).exp();
            let [rotation, force, moment] = self.carried[j];
            let parts =
                [left + right, (left - right) * rotation, (left - right) * force, (left + right) * moment];
            (0..4).for_each(|part| state[part] += parts[part]);
        }
        state
    }

    /// The state of wave `q`, to the right or to the left, so many `bays` from where it has its unit, at a cell's end.
    pub fn state(&self, q: usize, rightward: bool, bays: i32) -> State {
        let state = self.after(q, 0.5 * self.span().length).map(|part| part * self.lambda(q).powi(bays));
        if rightward { state } else { mirrored(state) }
    }

    /// The displacement of wave `q` at the distance `d` ≥ 0 [m], along its way, from where it has its unit. A mirror makes one to the left
    /// of one to the right.
    pub fn field(&self, q: usize, d: f64) -> Complex64 {
        let length = self.span().length;
        let (bays, x) = place(d + 0.5 * length, length);
        self.after(q, x)[0] * self.lambda(q).powi(bays as i32)
    }

    /// The displacement [m/N] at `x` [m] of an endless section under a unit force at `from`, both from a cell's end.
    pub fn receptance(&self, x: f64, from: f64) -> Complex64 {
        let length = self.span().length;
        let (bays, high, low) = ahead(x + 0.5 * length, from + 0.5 * length, length);
        self.free.ahead(&self.span().pair(high, low), bays as i32).value
    }

    /// The state at `x` [m], a cell's end, of an endless section under a unit force at `from`, both from a cell's end: the waves that leave
    /// the force, by the jump (0, 0, 1, 0) there. At the force itself that on its right.
    pub fn driven(&self, x: f64, from: f64) -> Option<State> {
        let length = self.span().length;
        let (bay, within) = place(from + 0.5 * length, length);
        let scale = self.scale();
        let scaled = |state: State| Vector4::from_fn(|row, _| state[row] / scale[row]);
        let right = [0, 1].map(|q| scaled(self.after(q, within)));
        let left = [0, 1].map(|q| scaled(mirrored(self.after(q, length - within))));
        let jump = scaled([Complex64::ZERO, Complex64::ZERO, Complex64::ONE, Complex64::ZERO]);
        let leaving = Matrix4::from_columns(&[right[0], right[1], -left[0], -left[1]]).lu().solve(&jump)?;
        let bays = (x / length).round() as i64 - bay;
        let rightward = x >= from;
        // to the left the phase of a wave falls the same way
        let distance = if rightward { bays } else { -bays } as i32;
        let mut state = [Complex64::ZERO; 4];
        for q in 0..2 {
            let amplitude = leaving[if rightward { q } else { 2 + q }];
            let part = self.state(q, rightward, distance);
            (0..4).for_each(|row| state[row] += amplitude * part[row]);
        }
        Some(state)
    }
}
