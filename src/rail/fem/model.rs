//! Mass, damping and stiffness of a track in time.

use super::FemError;
use super::assembly::{Given, Pair, assemble};
use super::mesh::Mesh;
use super::shape::GAUSS;
use crate::math::banded::Banded;
use crate::track::{Caughey, Element, Link, Member};
use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::Deserialize;

/// How the ends of the rail are held.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum Ends {
    /// w = 0.
    #[default]
    Pinned,
    /// w = θ = 0.
    Clamped,
    /// Nothing.
    Free,
    /// Free, with dashpots on the rail that rise with the cube of the depth into both end zones.
    Absorbing {
        /// Of each zone [m].
        length: f64,
        /// At the very end [N s/m²].
        damping: f64,
    },
}

/// A track in time: M a + C v + K u = f.
#[derive(Clone, Debug)]
pub struct Model {
    /// Its elements.
    pub mesh: Mesh,
    /// M
    pub mass: Banded<f64>,
    /// C
    pub damping: Banded<f64>,
    /// K
    pub stiffness: Banded<f64>,
}

impl Model {
    /// Most unknowns of a full matrix of damping: 32 MB each, a second to factorise.
    pub const FULL: usize = 2000;

    /// Of `mesh`, whose columns are in time ([`super::Form::Time`]).
    pub fn new(mut mesh: Mesh, ends: Ends) -> Self {
        let mut mass = assemble(&mesh, &inertia, &|link| between(link, |_, _| 0.0, 1.0));
        let mut stiffness = assemble(&mesh, &resistance, &|link| between(link, |k, _| k, 0.0));
        let mut damping = assemble(&mesh, &loss, &|link| between(link, |_, c| c, 0.0));
        if let Ends::Absorbing { length, damping: most } = ends {
            sponge(&mesh, &mut damping, length, most);
        }
        let [first, last] = [0, mesh.rail.len() - 1].map(|node| mesh.rail[node]);
        mesh.held = match ends {
            Ends::Pinned => vec![first, last],
            Ends::Clamped => vec![first, first + 1, last, last + 1],
            Ends::Free | Ends::Absorbing { .. } => vec![],
        };
        for &unknown in &mesh.held {
            mass.fix(unknown);
            stiffness.fix(unknown);
            damping.fix(unknown);
        }
        Self { mesh, mass, damping, stiffness }
    }

    /// The same with the damping C = M Σ αⱼ(M⁻¹K)ʲ besides its own: α₀M + α₁K of two modes (Rayleigh), a full matrix of more (Caughey).
    ///
    /// # Errors
    /// Three modes or more on a track of more than [`Model::FULL`] unknowns, or with displacements that have no mass.
    pub fn damped(mut self, damping: &Caughey) -> Result<Self, FemError> {
        if let [of_mass, rest @ ..] = &damping.alpha[..]
            && rest.len() < 2
        {
            let of_stiffness = rest.first().copied().unwrap_or(0.0);
            self.damping = self.damping.plus(*of_mass, &self.mass).plus(of_stiffness, &self.stiffness);
            return Ok(self);
        }
        let size = self.mesh.size();
        if size > Self::FULL {
            return Err(FemError::Full { size, most: Self::FULL });
        }
        let dense = |banded: &Banded<f64>| DMatrix::from_fn(size, size, |i, j| banded.get(i, j));
        let full = damping.matrix(&dense(&self.mass), &dense(&self.stiffness)).ok_or(FemError::Massless)?;
        self.mass = self.mass.widened(size - 1);
        self.stiffness = self.stiffness.widened(size - 1);
        self.damping = self.damping.widened(size - 1);
        for i in 0..size {
            // symmetric but for rounding
            (0..=i).for_each(|j| self.damping.add(i, j, 0.5 * (full[(i, j)] + full[(j, i)])));
        }
        Ok(self)
    }

    /// Displacements [m] at rest under `forces` (unknown, N).
    ///
    /// # Errors
    /// A track that is not held.
    pub fn at_rest(&self, forces: &[(usize, f64)]) -> Result<Vec<f64>, FemError> {
        let factor = self.stiffness.factor().ok_or(FemError::Singular)?;
        let mut u = vec![0.0; self.mesh.size()];
        forces.iter().for_each(|&(i, force)| u[i] += force);
        factor.solve(&mut u);
        Ok(u)
    }
}

/// What a member gives to M.
fn inertia(m: &Member) -> Given<f64> {
    Given { mass: m.mass, rotary: m.rotary_inertia, ..NOTHING }
}

/// To K.
fn resistance(m: &Member) -> Given<f64> {
    Given {
        bend: m.bending_stiffness,
        shear: if m.shears() { 1.0 / m.shear_compliance } else { 0.0 },
        tension: m.tension.map_or(0.0, |tension| spring_and_dashpot(&tension).0),
        ..NOTHING
    }
}

/// To C: α₁ of its inertia, α₂ of its stiffness, and the dashpot of its tension.
fn loss(m: &Member) -> Given<f64> {
    let (a, b) = (m.rayleigh.of_mass, m.rayleigh.of_stiffness);
    let (inertia, resistance) = (inertia(m), resistance(m));
    Given {
        bend: b * resistance.bend,
        shear: b * resistance.shear,
        tension: m.tension.map_or(0.0, |tension| spring_and_dashpot(&tension).1),
        mass: a * inertia.mass,
        rotary: a * inertia.rotary,
    }
}

const NOTHING: Given<f64> = Given { bend: 0.0, shear: 0.0, tension: 0.0, mass: 0.0, rotary: 0.0 };

/// k and c of what the column left of an element.
fn spring_and_dashpot(element: &Element) -> (f64, f64) {
    match *element {
        Element::Spring { stiffness, damping, .. } => (stiffness, damping),
        // refused or taken apart by the column
        _ => (0.0, 0.0),
    }
}

/// What a link gives: `pick` of its k and c, and its mass times `inertia`.
fn between(link: &Link, pick: fn(f64, f64) -> f64, inertia: f64) -> Pair<f64> {
    let (k, mass) = match link {
        Link::Element(element) => {
            let (k, c) = spring_and_dashpot(element);
            (pick(k, c), 0.0)
        }
        Link::ConsistentMass { stiffness, damping, mass, .. } => (pick(*stiffness, *damping), inertia * mass),
        // refused by the column
        Link::Bars { .. } => (0.0, 0.0),
    };
    [k + mass / 3.0, mass / 6.0 - k, k + mass / 3.0]
}

/// Dashpots c(s) = `most` s³ [N s/m²] on the rail, s from 0 to 1 over the last `length` [m] before each end.
fn sponge(mesh: &Mesh, damping: &mut Banded<f64>, length: f64, most: f64) {
    let (first, last) = (mesh.x[0], mesh.x[mesh.x.len() - 1]);
    for (beam, x) in mesh.elements.iter().zip(&mesh.x) {
        for (xi, weight) in GAUSS {
            let depth = 1.0 - (x + xi * beam.h - first).min(last - x - xi * beam.h) / length;
            let c = most * depth.max(0.0).powi(3) * weight * beam.h;
            let n = beam.shapes[0].displacement(xi);
            for (i, a) in beam.unknowns[0].iter().zip(n) {
                for (j, b) in beam.unknowns[0].iter().zip(n) {
                    if j <= i && c > 0.0 {
                        damping.add(*i, *j, c * a * b);
                    }
                }
            }
        }
    }
}
