//! The bodies of a train in steps of time, copy by copy of a vehicle.

use crate::rail::fem::{Scheme, State};
use crate::vehicle::Multibody;
use nalgebra::{DMatrix, DVector};

/// Copies of a vehicle under their weights, not coupled to one another.
pub(super) struct Vehicles<'a> {
    pub bodies: &'a Multibody,
    scheme: Scheme,
    /// S⁻¹, S = M + (1 + α)(γΔt C + βΔt² K)
    inverse: DMatrix<f64>,
    /// w of each copy.
    weights: Vec<DVector<f64>>,
    pub states: Vec<State>,
}

impl<'a> Vehicles<'a> {
    pub fn new(bodies: &'a Multibody, scheme: Scheme) -> Self {
        let (m, c, k) = (bodies.mass(), bodies.damping(), bodies.stiffness());
        let weigh = 1.0 + scheme.alpha;
        let s = m + weigh * (scheme.gamma() * scheme.step * c + scheme.per_acceleration() * k);
        // positive definite: masses are above zero
        let inverse = s.try_inverse().unwrap_or_else(|| DMatrix::zeros(m.nrows(), m.nrows()));
        let weights = (0..bodies.copies()).map(|copy| bodies.weights(copy)).collect();
        let states = vec![State::at_rest(vec![0.0; m.nrows()]); bodies.copies()];
        Self { bodies, scheme, inverse, weights, states }
    }

    /// Copy and degree of freedom of wheel `i`.
    fn place(&self, i: usize) -> (usize, usize) {
        let wheels = self.bodies.wheels();
        (i / wheels.len(), wheels[i % wheels.len()])
    }

    /// Number of displacements of all copies.
    pub fn size(&self) -> usize {
        self.states.len() * self.bodies.mass().nrows()
    }

    /// Number of the displacement of wheel `i` among those of all copies.
    pub fn unknown(&self, i: usize) -> usize {
        let (copy, freedom) = self.place(i);
        copy * self.bodies.mass().nrows() + freedom
    }

    /// Displacement of wheel `i` [m].
    pub fn wheel(&self, i: usize) -> f64 {
        let (copy, freedom) = self.place(i);
        self.states[copy].u[freedom]
    }

    /// w − L P of `copy`
    pub fn load(&self, copy: usize, forces: &[f64]) -> DVector<f64> {
        let mut load = self.weights[copy].clone();
        let wheels = self.bodies.wheels();
        for (j, &wheel) in wheels.iter().enumerate() {
            load[wheel] -= forces[copy * wheels.len() + j];
        }
        load
    }

    /// Moves all on as if no wheel pressed on the rail at the end of the step, `old` forces having pressed at its beginning.
    pub fn free(&mut self, old: &[f64]) {
        let (scheme, weigh) = (self.scheme, 1.0 + self.scheme.alpha);
        for copy in 0..self.states.len() {
            let state = &self.states[copy];
            let (u, v) = (DVector::from_column_slice(&state.u), DVector::from_column_slice(&state.v));
            let resist =
                |v: &DVector<f64>, u: &DVector<f64>| self.bodies.damping() * v + self.bodies.stiffness() * u;
            let mut sum = weigh * &self.weights[copy];
            if scheme.alpha != 0.0 {
                sum += scheme.alpha * (resist(&v, &u) - self.load(copy, old));
            }
            let (mut u_next, mut v_next) = (u, v);
            for i in 0..state.u.len() {
                (u_next[i], v_next[i]) = scheme.predict(state.u[i], state.v[i], state.a[i]);
            }
            sum -= weigh * resist(&v_next, &u_next);
            let a = &self.inverse * sum;
            u_next += scheme.per_acceleration() * &a;
            v_next += scheme.gamma() * scheme.step * &a;
            self.states[copy] = State {
                u: u_next.as_slice().to_vec(),
                v: v_next.as_slice().to_vec(),
                a: a.as_slice().to_vec(),
            };
        }
    }

    /// Displacement of wheel `i` per force of the wheels on the rail at wheel `j` [m/N], by the end of a step: what it rises.
    pub fn per_force(&self, i: usize, j: usize) -> f64 {
        let ((copy, a), (other, b)) = (self.place(i), self.place(j));
        if copy != other {
            return 0.0;
        }
        (1.0 + self.scheme.alpha) * self.scheme.per_acceleration() * self.inverse[(a, b)]
    }

    /// Where wheel `i` would be under `forces` [N] on the rail.
    pub fn wheel_under(&self, i: usize, forces: &[f64]) -> f64 {
        let count = self.bodies.wheels().len();
        let first = i / count * count;
        let raised: f64 = (first..first + count).map(|j| self.per_force(i, j) * forces[j]).sum();
        self.wheel(i) - raised
    }

    /// Adds what the `forces` of the rail do by the end of a step.
    pub fn press(&mut self, forces: &[f64]) {
        let wheels = self.bodies.wheels();
        let (to_u, to_v) = (self.scheme.per_acceleration(), self.scheme.gamma() * self.scheme.step);
        for (copy, state) in self.states.iter_mut().enumerate() {
            for (j, &wheel) in wheels.iter().enumerate() {
                let force = (1.0 + self.scheme.alpha) * forces[copy * wheels.len() + j];
                for i in 0..state.u.len() {
                    let a = self.inverse[(i, wheel)] * force;
                    state.a[i] -= a;
                    state.v[i] -= to_v * a;
                    state.u[i] -= to_u * a;
                }
            }
        }
    }

    /// Equilibrium of all bodies, wheels `approaches` [m] below a rigid rail.
    pub fn stand_on(&mut self, approaches: &[f64]) {
        let wheels = self.bodies.wheels();
        let k = self.bodies.stiffness();
        for copy in 0..self.states.len() {
            // K u = w − L P with the wheels held: their rows say where they are
            let (mut held, mut known) = (k.clone(), self.weights[copy].clone());
            for (j, &wheel) in wheels.iter().enumerate() {
                held.row_mut(wheel).fill(0.0);
                held[(wheel, wheel)] = 1.0;
                known[wheel] = approaches[copy * wheels.len() + j];
            }
            if let Some(u) = held.lu().solve(&known) {
                self.states[copy] = State::at_rest(u.as_slice().to_vec());
            }
        }
    }

    /// Rows K u + L P − w of all bodies and their derivatives by all displacements, then by P.
    pub fn at_rest(&self, forces: &[f64], residual: &mut DVector<f64>, jacobian: &mut DMatrix<f64>) {
        let (size, k, wheels) = (self.bodies.mass().nrows(), self.bodies.stiffness(), self.bodies.wheels());
        for copy in 0..self.states.len() {
            let u = DVector::from_column_slice(&self.states[copy].u);
            let rest = k * u - self.load(copy, forces);
            let from = copy * size;
            residual.rows_mut(from, size).copy_from(&rest);
            jacobian.view_mut((from, from), (size, size)).copy_from(k);
            for (j, &wheel) in wheels.iter().enumerate() {
                jacobian[(from + wheel, self.size() + copy * wheels.len() + j)] = 1.0;
            }
        }
    }

    /// Takes `change` from all displacements.
    pub fn shift(&mut self, change: &[f64]) {
        let size = self.bodies.mass().nrows();
        for (state, change) in self.states.iter_mut().zip(change.chunks(size)) {
            state.u.iter_mut().zip(change).for_each(|(u, d)| *u -= d);
        }
    }
}
