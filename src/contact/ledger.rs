//! The account of energy of a march, from step to step.

use super::account::{Account, Ledger};
use super::law::Law;
use super::march::{March, Pressed, value};
use super::vehicles::Vehicles;
use crate::rail::fem::{Model, State};
use nalgebra::{DMatrix, DVector};

/// Length over which slopes of profiles and elements are taken [m].
const NEAR: f64 = 1e-7;

impl March<'_> {
    /// Keeps account of energy from here on.
    pub fn keep_ledger(&mut self) {
        let contact = self.in_contacts();
        let mut ledger = Ledger {
            track: of_track(self.model, &self.track),
            vehicles: Account::default(),
            contact,
            first: contact,
            drive: 0.0,
        };
        ledger.track.first = ledger.track.kinetic + ledger.track.strain;
        if let Some(vehicles) = &self.vehicles {
            (ledger.vehicles.kinetic, ledger.vehicles.strain) = of_vehicles(vehicles, &vehicles.states);
            ledger.vehicles.first = ledger.vehicles.kinetic + ledger.vehicles.strain;
        }
        self.ledger = Some(ledger);
    }

    /// Enters the step that began with `track`, `vehicles` and what was `pressed` then.
    pub(super) fn enter(
        &self,
        ledger: &mut Ledger,
        track: &State,
        vehicles: Option<&[State]>,
        pressed: &Pressed,
    ) {
        let step = self.newmark.scheme().step;
        let (old, new) = (pressed, &self.pressed);
        let mean: Vec<f64> = track.v.iter().zip(&self.track.v).map(|(a, b)| 0.5 * (a + b)).collect();
        let pressing = old.forces.iter().chain(&new.forces).map(|&(i, force)| 0.5 * force * mean[i]);
        ledger.track.work += step * pressing.sum::<f64>();
        ledger.track.dissipated += step * self.model.damping.quadratic(&mean);
        let held = of_track(self.model, &self.track);
        (ledger.track.kinetic, ledger.track.strain) = (held.kinetic, held.strain);
        if let (Some(now), Some(before)) = (&self.vehicles, vehicles) {
            let forces = |pressed: &Pressed| pressed.wheels.iter().map(|w| w.0).collect::<Vec<_>>();
            let (old, new) = (forces(old), forces(new));
            for (copy, before) in before.iter().enumerate() {
                let after = &now.states[copy];
                let mean = DVector::from_fn(before.v.len(), |i, _| 0.5 * (before.v[i] + after.v[i]));
                let load = 0.5 * (now.load(copy, &old) + now.load(copy, &new));
                ledger.vehicles.work += step * mean.dot(&load);
                ledger.vehicles.dissipated += step * mean.dot(&(now.bodies.damping() * &mean));
            }
            (ledger.vehicles.kinetic, ledger.vehicles.strain) = of_vehicles(now, &now.states);
        }
        ledger.contact = self.in_contacts();
        ledger.drive += 0.5 * step * (self.drive(old, track) + self.drive(new, &self.track));
    }

    /// v P(u_r′ + r′ + ½c′P) [W] of all wheels as they `pressed` on `track`; c is what the held element gives way.
    fn drive(&self, pressed: &Pressed, track: &State) -> f64 {
        let mesh = &self.model.mesh;
        let of = |(i, &(force, x)): (usize, &(f64, f64))| {
            let slope = value(&mesh.rail_slope_at(x), &track.u);
            let rough = ((self.rough)(i, x + NEAR) - (self.rough)(i, x - NEAR)) / (2.0 * NEAR);
            let held = (mesh.rail_at(x + NEAR).1 - mesh.rail_at(x - NEAR).1) / (2.0 * NEAR);
            self.speed * pressed.share * force * (slope + rough + 0.5 * held * pressed.share * force)
        };
        pressed.wheels.iter().enumerate().map(of).sum()
    }

    /// ∫ P dδ of all contacts, and what the elements held at their nodes store under them.
    fn in_contacts(&self) -> f64 {
        let of = |(i, law): (usize, &Law)| {
            let held = self.model.mesh.rail_at(self.x(i)).1 * (self.share() * self.forces[i]).powi(2);
            law.energy(self.approach(i).unwrap_or(0.0)) + 0.5 * held
        };
        self.laws.iter().enumerate().map(of).sum()
    }
}

fn of_track(model: &Model, state: &State) -> Account {
    let kinetic = 0.5 * model.mass.quadratic(&state.v);
    Account { kinetic, strain: 0.5 * model.stiffness.quadratic(&state.u), ..Account::default() }
}

fn of_vehicles(vehicles: &Vehicles, states: &[State]) -> (f64, f64) {
    let energy = |matrix: &DMatrix<f64>, x: &[f64]| {
        let x = DVector::from_column_slice(x);
        0.5 * x.dot(&(matrix * &x))
    };
    let sum = |pick: &dyn Fn(&State) -> f64| states.iter().map(pick).sum();
    let bodies = vehicles.bodies;
    (sum(&|s| energy(bodies.mass(), &s.v)), sum(&|s| energy(bodies.stiffness(), &s.u)))
}
