//! Forces of wheels and hanging supports in equilibrium with what they move: at the end of a step, and at rest.

use super::march::{March, MarchError, Place, value};
use super::vehicles::Vehicles;
use nalgebra::{DMatrix, DVector};

/// Newton's iterations a step, and the error left, of the largest static load.
const ITERATIONS: usize = 60;
const SETTLED: f64 = 1e-12;

/// The end of a step: P − law(δ) = 0 of every wheel with a law, R − max(0, k(Δ − g) + c Δ̇) = 0 of every support that hangs. Unknown are
/// the P, then the R.
struct Equations<'s> {
    march: &'s March<'s>,
    places: &'s [Place],
    /// Displacement of each place per unit of force on each [m/N].
    answers: &'s DMatrix<f64>,
    /// s
    share: f64,
    /// Number of wheels whose force is unknown, of places whose force is known.
    wheels: usize,
    known: usize,
    /// Displacement and velocity of each place under the known forces alone.
    free: Vec<(f64, f64)>,
    /// γ/(βΔt): velocity per displacement of the end of a step.
    to_velocity: f64,
}

impl<'s> Equations<'s> {
    fn new(march: &'s March<'s>, places: &'s [Place], answers: &'s DMatrix<f64>) -> Self {
        let share = march.share();
        let wheels = if march.vehicles.is_some() { march.loads.len() } else { 0 };
        let known = march.loads.len() - wheels;
        let scheme = march.newmark.scheme();
        let to_velocity = scheme.gamma() * scheme.step / scheme.per_acceleration();
        let free = |a: usize| {
            let pressed: f64 = (0..known).map(|b| answers[(a, b)] * share * march.forces[b]).sum();
            let (u, v) = (value(&places[a].shape, &march.track.u), value(&places[a].shape, &march.track.v));
            (u + pressed, v + to_velocity * pressed)
        };
        let free = (0..places.len()).map(free).collect();
        Self { march, places, answers, share, wheels, known, free, to_velocity }
    }

    /// Displacement of place `a` per unit of unknown `j`.
    fn per_unknown(&self, a: usize, j: usize) -> f64 {
        let sign = if j < self.wheels { self.share } else { -1.0 };
        self.answers[(a, self.known + j)] * sign
    }

    /// Residual of equation `i`, how much of it is rounding, and its derivatives by all unknowns.
    fn equation(&self, i: usize, unknown: &[f64]) -> (f64, f64, Vec<f64>) {
        let a = self.known + i;
        let moved: f64 = unknown.iter().enumerate().map(|(j, f)| self.per_unknown(a, j) * f).sum();
        let (residual, slope, argument) = match &self.march.vehicles {
            Some(vehicles) if i < self.wheels => self.wheel(vehicles, i, moved, unknown),
            _ => self.gap(i, moved, unknown),
        };
        let own = |j: usize| if i == j { 1.0 } else { 0.0 };
        // a stiff contact feels the last digits of what it lies between
        let rounding = slope * 8.0 * f64::EPSILON * (self.free[a].0.abs() + moved.abs());
        (residual, rounding, (0..unknown.len()).map(|j| own(j) - slope * argument(j)).collect())
    }

    /// P − law(δ), law′(δ) and ∂δ/∂(unknown).
    fn wheel<'a>(
        &'a self,
        vehicles: &'a Vehicles,
        i: usize,
        moved: f64,
        unknown: &[f64],
    ) -> (f64, f64, Box<dyn Fn(usize) -> f64 + 'a>) {
        let (place, law) = (&self.places[i], &self.march.laws[i]);
        let rail = self.free[i].0 + moved + self.share * place.held * unknown[i];
        let delta = vehicles.wheel_under(i, &unknown[..self.wheels]) - self.share * (rail + place.rough);
        let argument = move |j: usize| {
            let risen = if j < self.wheels { vehicles.per_force(i, j) } else { 0.0 };
            let held = if i == j { self.share * place.held } else { 0.0 };
            -risen - self.share * (self.per_unknown(i, j) + held)
        };
        (unknown[i] - law.force(delta), law.slope(delta), Box::new(argument))
    }

    /// R − max(0, k(Δ − g) + c Δ̇), whether it pushes, and the derivatives of what it pushes with.
    fn gap<'a>(
        &'a self,
        i: usize,
        moved: f64,
        unknown: &[f64],
    ) -> (f64, f64, Box<dyn Fn(usize) -> f64 + 'a>) {
        let a = self.known + i;
        let gap = &self.march.model.mesh.gaps[i - self.wheels];
        let (displaced, speed) = (self.free[a].0 + moved, self.free[a].1 + self.to_velocity * moved);
        let push = gap.stiffness * (displaced - gap.gap) + gap.damping * speed;
        let closed = displaced > gap.gap && push > 0.0;
        let stiff = gap.stiffness + gap.damping * self.to_velocity;
        let argument = move |j: usize| stiff * self.per_unknown(a, j);
        (unknown[i] - if closed { push } else { 0.0 }, f64::from(u8::from(closed)), Box::new(argument))
    }

    /// Newton's rule from `unknown` on: how many iterations it took, None where they were not enough.
    fn solve(&self, unknown: &mut [f64], scale: f64) -> Option<usize> {
        let n = unknown.len();
        for iteration in 1..=ITERATIONS {
            let rows: Vec<_> = (0..n).map(|i| self.equation(i, unknown)).collect();
            if rows.iter().all(|(residual, rounding, _)| residual.abs() <= SETTLED * scale + rounding) {
                return Some(iteration);
            }
            let residual = DVector::from_fn(n, |i, _| rows[i].0);
            let change = DMatrix::from_fn(n, n, |i, j| rows[i].2[j]).lu().solve(&residual)?;
            // gaps that open and close in turn settle by smaller changes
            let part = if iteration < ITERATIONS / 3 { 1.0 } else { 0.5 };
            unknown.iter_mut().zip(change.iter()).for_each(|(f, d)| *f -= part * d);
        }
        None
    }
}

impl March<'_> {
    /// The largest static load [N].
    fn scale(&self) -> f64 {
        self.loads.iter().map(|axle| axle.load.abs()).fold(1.0, f64::max)
    }

    fn unbalanced(&self) -> MarchError {
        let (step, time, x) = (self.steps, self.time(), self.x(0));
        MarchError::NoEquilibrium { step, time, x, iterations: ITERATIONS }
    }

    /// Finds the forces of the end of a step.
    pub(super) fn balance(&mut self, places: &[Place], answers: &DMatrix<f64>) -> Result<(), MarchError> {
        let equations = Equations::new(self, places, answers);
        let (known, wheels, scale) = (equations.known, equations.wheels, self.scale());
        let mut unknown: Vec<f64> = self.forces[known..].iter().chain(&self.gaps).copied().collect();
        let iterations = equations.solve(&mut unknown, scale).ok_or_else(|| self.unbalanced())?;
        self.iterations += iterations;
        self.forces[known..].copy_from_slice(&unknown[..wheels]);
        self.gaps.copy_from_slice(&unknown[wheels..]);
        self.sane(scale)
    }

    /// Finds displacements of all bodies and forces at rest: K u + L P = w of the bodies, u_w − u_r − r − δ(P) = 0 of the wheels,
    /// R = max(0, k(Δ − g)) of supports that hang. `influence` is what a unit force on each place does to the track.
    pub(super) fn balance_at_rest(
        &mut self,
        places: &[Place],
        influence: &[Vec<f64>],
    ) -> Result<(), MarchError> {
        let answers =
            DMatrix::from_fn(places.len(), places.len(), |a, b| value(&places[a].shape, &influence[b]));
        let bodies = self.vehicles.as_ref().map_or(0, Vehicles::size);
        let wheels = if bodies > 0 { self.loads.len() } else { 0 };
        let scale = self.scale();
        for _ in 0..ITERATIONS {
            let (residual, jacobian) = self.at_rest(places, &answers);
            // rows of bodies and gaps are forces, those of wheels displacements: under the slope of a contact
            let size =
                |i: usize| residual[i].abs() * if (bodies..bodies + wheels).contains(&i) { 1e9 } else { 1.0 };
            if (0..residual.len()).map(size).fold(0.0, f64::max) <= SETTLED * scale {
                return Ok(());
            }
            let Some(change) = jacobian.lu().solve(&residual) else { break };
            if let Some(vehicles) = &mut self.vehicles {
                vehicles.shift(&change.as_slice()[..bodies]);
                self.forces.iter_mut().zip(&change.as_slice()[bodies..]).for_each(|(p, d)| *p -= d);
            }
            self.gaps.iter_mut().zip(&change.as_slice()[bodies + wheels..]).for_each(|(r, d)| *r -= d);
        }
        Err(self.unbalanced())
    }

    /// Residuals at rest and their derivatives by the displacements of all bodies, P and R.
    fn at_rest(&self, places: &[Place], answers: &DMatrix<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let loads = self.loads.len();
        let bodies = self.vehicles.as_ref().map_or(0, Vehicles::size);
        let wheels = if bodies > 0 { loads } else { 0 };
        let n = bodies + wheels + self.gaps.len();
        let (mut residual, mut jacobian) = (DVector::zeros(n), DMatrix::zeros(n, n));
        let acting = self.acting();
        let displaced = |a: usize| (0..places.len()).map(|b| answers[(a, b)] * acting[b]).sum::<f64>();
        // unknowns of the forces, with their signs; loads without laws are known
        let unknown = |b: usize| match b.checked_sub(loads) {
            Some(gap) => Some((bodies + wheels + gap, -1.0)),
            None => (wheels > 0).then_some((bodies + b, 1.0)),
        };
        let unknowns: Vec<_> = (0..places.len()).filter_map(|b| Some((b, unknown(b)?))).collect();
        if let Some(vehicles) = &self.vehicles {
            vehicles.at_rest(&self.forces, &mut residual, &mut jacobian);
            for (i, (place, law)) in places.iter().zip(&self.laws).enumerate() {
                let row = bodies + i;
                // a wheel that would be off the rail at rest has no approach
                let approach = law.approach(self.forces[i].max(1e-6 * self.scale()));
                let rail = displaced(i) + place.held * self.forces[i] + place.rough;
                residual[row] = vehicles.wheel(i) - rail - approach;
                jacobian[(row, vehicles.unknown(i))] = 1.0;
                unknowns.iter().for_each(|&(b, (j, sign))| jacobian[(row, j)] -= answers[(i, b)] * sign);
                jacobian[(row, row)] -= place.held + 1.0 / law.slope(approach);
            }
        }
        for (g, gap) in self.model.mesh.gaps.iter().enumerate() {
            let (a, row) = (loads + g, bodies + wheels + g);
            let push = gap.stiffness * (displaced(a) - gap.gap);
            residual[row] = self.gaps[g] - push.max(0.0);
            jacobian[(row, row)] = 1.0;
            if push > 0.0 {
                unknowns
                    .iter()
                    .for_each(|&(b, (j, sign))| jacobian[(row, j)] -= gap.stiffness * answers[(a, b)] * sign);
            }
        }
        (residual, jacobian)
    }
}
