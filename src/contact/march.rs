//! Wheels that roll over finite elements, step by step of time: the force of each contact is found to equilibrium in every step,
//! lift-off included.
//!
//! ```text
//! δᵢ = u_w,i − s(u_r(xᵢ) + r(xᵢ))    P = law(δ)    track: M a + C v + K u = Σ s Pᵢ N(xᵢ)    vehicle: M a + C v + K u = w − L P
//! ```
//!
//! What moves freely is one solution of each factor; the answers yᵢ = S⁻¹N(xᵢ) of the places of contact reach a few metres. Then
//! P − law(δ_free − A P) = 0 is left, as many equations as wheels, A positive definite: Newton from the last forces. Displacements are
//! taken at the new place, so that what convection adds (2v ∂²w/∂x∂t, v² w″) is there by itself.
//!
//! Source: Eqs (26), (27), (83), (84).

use super::account::Ledger;
use super::law::Law;
use super::vehicles::Vehicles;
use crate::rail::fem::{FemError, Model, Newmark, Scheme, State};
use crate::vehicle::{Axle, Multibody};
use nalgebra::DMatrix;
use thiserror::Error;

/// What rolls.
#[derive(Clone, Debug)]
pub enum Rolling<'a> {
    /// Constant loads, at their places behind the first.
    Loads(&'a [Axle]),
    /// Wheelsets under bodies, each pressing by its law.
    Bodies(&'a Multibody, Vec<Law>),
}

/// r [m, positive down] under a wheel, counted from 0, that stands at x [m] on the rail.
pub type Rough<'a> = &'a (dyn Fn(usize, f64) -> f64 + Sync);

/// How it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// In equilibrium, at rest, then at once at full speed.
    Static,
    /// The track not deformed, vehicles in equilibrium on a rigid rail; s = t³(10 − 15t + 6t²) grows from 0 to 1 in this time [s] and
    /// multiplies the force on the rail, its displacement and r under the wheels.
    Ramp(f64),
}

/// Why a march stops.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MarchError {
    /// The track has no finite elements.
    #[error(transparent)]
    Elements(#[from] FemError),
    /// No equilibrium was found.
    #[error(
        "step {step} (t = {time:.6} s, leading wheel at {x:.3} m): the contact forces found no equilibrium within {iterations} iterations; \
         take shorter steps, or look whether the profile jumps there"
    )]
    NoEquilibrium {
        /// Counted from 1; 0 is the start.
        step: usize,
        /// [s]
        time: f64,
        /// [m]
        x: f64,
        /// Tried.
        iterations: usize,
    },
    /// Something grew beyond all bounds.
    #[error(
        "step {step} (t = {time:.6} s, leading wheel at {x:.3} m): the march diverges (a contact force of {force:.3e} N, {times:.0} times the \
         largest static one); take shorter steps"
    )]
    Diverged {
        /// Counted from 1.
        step: usize,
        /// [s]
        time: f64,
        /// [m]
        x: f64,
        /// [N]
        force: f64,
        /// Of the static one.
        times: f64,
    },
}

/// Contact force over the static one that no wheel survives.
const ABSURD: f64 = 1e4;

/// What presses on the track at one moment.
#[derive(Clone, Debug, Default)]
pub(super) struct Pressed {
    /// Unknowns of the track and forces on them.
    pub forces: Vec<(usize, f64)>,
    /// s
    pub share: f64,
    /// Of each wheel: P, xᵢ.
    pub wheels: Vec<(f64, f64)>,
}

/// A train on its way over a track.
pub struct March<'a> {
    pub(super) model: &'a Model,
    pub(super) newmark: Newmark,
    pub(super) loads: Vec<Axle>,
    pub(super) vehicles: Option<Vehicles<'a>>,
    pub(super) laws: Vec<Law>,
    pub(super) rough: Rough<'a>,
    /// v [m/s]
    pub(super) speed: f64,
    /// Where position 0 of the train stands at t = 0 [m].
    from: f64,
    start: Start,
    pub(super) steps: usize,
    pub(super) track: State,
    /// P of each wheel [N].
    pub(super) forces: Vec<f64>,
    /// R of each support that hangs [N].
    pub(super) gaps: Vec<f64>,
    pub(super) pressed: Pressed,
    pub(super) ledger: Option<Ledger>,
    pub(super) iterations: usize,
}

impl<'a> March<'a> {
    /// `rolling` at `speed` v [m/s] over `model` and the profile `rough` in steps of `scheme`; position 0 of it stands at `from` [m] at t = 0.
    ///
    /// # Errors
    /// A track that is not held, a start without equilibrium.
    pub fn new(
        model: &'a Model,
        scheme: Scheme,
        rolling: Rolling<'a>,
        speed: f64,
        from: f64,
        rough: Rough<'a>,
        start: Start,
    ) -> Result<Self, MarchError> {
        let (loads, vehicles, laws) = match rolling {
            Rolling::Loads(axles) => (axles.to_vec(), None, Vec::new()),
            Rolling::Bodies(bodies, laws) => {
                (bodies.axles().to_vec(), Some(Vehicles::new(bodies, scheme)), laws)
            }
        };
        let forces = loads.iter().map(|axle| axle.load).collect();
        let mut march = Self {
            model,
            newmark: Newmark::new(model, scheme)?,
            loads,
            vehicles,
            laws,
            rough,
            speed,
            from,
            start,
            steps: 0,
            track: State::at_rest(vec![0.0; model.mesh.size()]),
            forces,
            gaps: vec![0.0; model.mesh.gaps.len()],
            pressed: Pressed::default(),
            ledger: None,
            iterations: 0,
        };
        march.begin()?;
        Ok(march)
    }

    /// The account of energy, if it is kept.
    pub fn ledger(&self) -> Option<&Ledger> {
        self.ledger.as_ref()
    }

    /// t [s]
    pub fn time(&self) -> f64 {
        self.newmark.scheme().step * self.steps as f64
    }

    /// Steps taken.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Newton's iterations since the start.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// Where wheel `i` stands [m].
    pub fn x(&self, i: usize) -> f64 {
        self.from - self.loads[i].position + self.speed * self.time()
    }

    /// P of each wheel [N], as large as its load where loads roll.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }

    /// R of each support that hangs [N], in the order of the mesh.
    pub fn hanging(&self) -> &[f64] {
        &self.gaps
    }

    /// The track.
    pub fn track(&self) -> &State {
        &self.track
    }

    /// Bodies of copy `i` of the vehicle; None where loads roll.
    pub fn vehicle(&self, i: usize) -> Option<&State> {
        self.vehicles.as_ref().map(|vehicles| &vehicles.states[i])
    }

    /// Displacement of the rail at `x` [m], without what it gives way within an element under a wheel.
    pub fn rail(&self, x: f64) -> f64 {
        value(&self.model.mesh.rail_at(x).0, &self.track.u)
    }

    /// Displacement of the rail under wheel `i` [m].
    pub fn rail_under(&self, i: usize) -> f64 {
        let (shape, held) = self.model.mesh.rail_at(self.x(i));
        value(&shape, &self.track.u) + held * self.pressed.share * self.forces[i]
    }

    /// Approach δ of wheel `i` and rail [m], negative where they are apart; None where loads roll.
    pub fn approach(&self, i: usize) -> Option<f64> {
        let vehicles = self.vehicles.as_ref()?;
        let share = self.pressed.share;
        Some(vehicles.wheel(i) - share * (self.rail_under(i) + (self.rough)(i, self.x(i))))
    }

    /// s(t)
    pub(super) fn share(&self) -> f64 {
        match self.start {
            Start::Static => 1.0,
            Start::Ramp(duration) => {
                let t = (self.time() / duration).min(1.0);
                t * t * t * (10.0 - 15.0 * t + 6.0 * t * t)
            }
        }
    }

    /// One step of time.
    ///
    /// # Errors
    /// No equilibrium, or none to be had any more.
    pub fn step(&mut self) -> Result<(), MarchError> {
        let before = self
            .ledger
            .is_some()
            .then(|| (self.track.clone(), self.vehicles.as_ref().map(|v| v.states.clone())));
        self.newmark.free(&mut self.track, &self.pressed.forces);
        if let Some(vehicles) = &mut self.vehicles {
            vehicles.free(&self.forces);
        }
        self.steps += 1;
        let places = self.places();
        let units: Vec<_> = places.iter().map(|place| self.newmark.unit(&place.shape)).collect();
        if self.vehicles.is_some() || !self.gaps.is_empty() {
            let answers = self.answers(&places, &units);
            self.balance(&places, &answers)?;
        }
        let acting = self.acting();
        for (unit, force) in units.iter().zip(&acting) {
            self.newmark.press(&mut self.track, unit, *force);
        }
        if let Some(vehicles) = &mut self.vehicles {
            vehicles.press(&self.forces);
        }
        let pressed = self.pressing(&places, &acting);
        let old = std::mem::replace(&mut self.pressed, pressed);
        if let (Some((track, vehicles)), Some(mut ledger)) = (before, self.ledger.take()) {
            self.enter(&mut ledger, &track, vehicles.as_deref(), &old);
            self.ledger = Some(ledger);
        }
        Ok(())
    }

    /// Where forces act now: each wheel, then each support that hangs.
    fn places(&self) -> Vec<Place> {
        let wheel = |i: usize| {
            let x = self.x(i);
            let (shape, held) = self.model.mesh.rail_at(x);
            Place { shape: shape.to_vec(), held, rough: (self.rough)(i, x) }
        };
        let gap = |gap: &crate::rail::fem::Gap| {
            let (upper, lower) = gap.unknowns;
            let shape = [(upper, 1.0)].into_iter().chain(lower.map(|lower| (lower, -1.0))).collect();
            Place { shape, held: 0.0, rough: 0.0 }
        };
        (0..self.loads.len()).map(wheel).chain(self.model.mesh.gaps.iter().map(gap)).collect()
    }

    /// Forces on the track at those places: s P of wheels, −R of supports.
    pub(super) fn acting(&self) -> Vec<f64> {
        let share = self.share();
        self.forces.iter().map(|p| share * p).chain(self.gaps.iter().map(|r| -r)).collect()
    }

    fn pressing(&self, places: &[Place], acting: &[f64]) -> Pressed {
        let forces = places
            .iter()
            .zip(acting)
            .flat_map(|(place, f)| place.shape.iter().map(move |&(i, n)| (i, n * f)));
        let wheels = (0..self.loads.len()).map(|i| (self.forces[i], self.x(i))).collect();
        Pressed { forces: forces.collect(), share: self.share(), wheels }
    }

    /// Displacement of each place per unit of force on each, by the end of a step [m/N].
    fn answers(&self, places: &[Place], units: &[(usize, Vec<f64>)]) -> DMatrix<f64> {
        let per_acceleration = self.newmark.scheme().per_acceleration();
        DMatrix::from_fn(places.len(), places.len(), |a, b| {
            let (first, unit) = &units[b];
            let at = |i: usize| i.checked_sub(*first).and_then(|i| unit.get(i)).copied().unwrap_or(0.0);
            per_acceleration * places[a].shape.iter().map(|&(i, n)| n * at(i)).sum::<f64>()
        })
    }

    /// Refuses forces beyond all bounds.
    pub(super) fn sane(&self, scale: f64) -> Result<(), MarchError> {
        let force = self.forces.iter().fold(0.0f64, |most, p| most.max(p.abs()));
        if force.is_finite() && force < ABSURD * scale {
            return Ok(());
        }
        let (step, time, x) = (self.steps, self.time(), self.x(0));
        Err(MarchError::Diverged { step, time, x, force, times: force / scale })
    }

    /// Places everything as it stands at t = 0.
    fn begin(&mut self) -> Result<(), MarchError> {
        let places = self.places();
        if self.start == Start::Static {
            let influence: Vec<Vec<f64>> =
                places.iter().map(|place| self.model.at_rest(&place.shape)).collect::<Result<_, _>>()?;
            self.balance_at_rest(&places, &influence)?;
            for (u, force) in influence.iter().zip(self.acting()) {
                self.track.u.iter_mut().zip(u).for_each(|(sum, u)| *sum += force * u);
            }
        } else if let Some(vehicles) = &mut self.vehicles {
            let approaches: Vec<f64> =
                self.laws.iter().zip(&self.loads).map(|(law, axle)| law.approach(axle.load)).collect();
            vehicles.stand_on(&approaches);
        }
        self.pressed = self.pressing(&places, &self.acting());
        Ok(())
    }
}

/// Where a force acts on the track.
pub(super) struct Place {
    /// Unknowns and what each of them gives.
    pub shape: Vec<(usize, f64)>,
    /// Flexibility of the held element there [m/N].
    pub held: f64,
    /// r [m]
    pub rough: f64,
}

/// Σ N u
pub(super) fn value(shape: &[(usize, f64)], u: &[f64]) -> f64 {
    shape.iter().map(|&(i, n)| n * u[i]).sum()
}
