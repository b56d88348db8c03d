//! Forces of wheels on a rough rail for any wavelength of it, from a table of the rail's receptances.
//!
//! α of all distances is tabulated against ln Ω and interpolated between six neighbours. Wherever the forces that follow half-way
//! between two entries are not those of the rail itself, the half-way is an entry too: the table is fine where wheels on the track
//! resonate and where e^{−ik|x|} between them turns, and coarse elsewhere.

use super::WheelRail;
use super::wheel_rail::Distances;
use crate::math::interpolation::lagrange_within;
use crate::math::quadrature::miss;
use crate::progress::Observer;
use crate::rail::InteractionError;
use num_complex::Complex64;
use rayon::prelude::*;

/// Entries per factor e to begin with, and how often a step is halved at most.
const PER_UNIT: f64 = 5.0;
const HALVINGS: u32 = 7;
/// Error of interpolated forces half-way between entries; with the half-ways in the table it is a tenth of that.
const ACCURACY: f64 = 1e-2;
/// Entries that an interpolated value follows.
const NEIGHBOURS: usize = 6;

/// α of all wheels against ln Ω, and what stands on them.
pub struct ContactForces<'a> {
    wheels: &'a WheelRail<'a>,
    distances: Distances,
    /// Where on the profile each wheel stands at t = 0 [m].
    starts: Vec<f64>,
    /// By ln Ω, ascending.
    table: Vec<Entry>,
    /// Error of a receptance or of the forces over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
}

/// α at one ln Ω.
struct Entry {
    place: f64,
    alpha: Vec<Complex64>,
    /// Its error over what was allowed.
    worst: f64,
}

impl<'a> ContactForces<'a> {
    /// For wavenumbers Ω between `range` (lowest, highest) [rad/m], both above zero.
    ///
    /// Accuracy: of each force, or of a tenth of the largest where it is smaller than that: 1.4e-3 for one
    /// wheel, 1e-3 for four (test `cross_solver::contact_forces`).
    ///
    /// # Errors
    /// A foundation that cannot answer; a response that diverges.
    pub fn new(
        wheels: &'a WheelRail<'a>,
        range: (f64, f64),
        observer: &dyn Observer,
    ) -> Result<Self, InteractionError> {
        let low = range.0.ln();
        let width = (range.1.ln() - low).max(1e-3);
        let count = ((width * PER_UNIT).ceil() as usize).max(NEIGHBOURS - 1);
        let places: Vec<f64> = (0..=count).map(|i| low + width * i as f64 / count as f64).collect();
        // on one rail
        let starts = wheels.bodies.axles().iter().map(|a| -a.position).collect();
        let mut forces =
            Self { wheels, distances: wheels.distances(), starts, table: Vec::new(), worst: 0.0 };
        forces.table = forces.ask(&places, observer)?;
        let mut steps: Vec<(f64, f64)> = places.windows(2).map(|pair| (pair[0], pair[1])).collect();
        let mut between = 0.0;
        for _ in 0..HALVINGS {
            let middles: Vec<f64> = steps.iter().map(|step| 0.5 * (step.0 + step.1)).collect();
            let entries = forces.ask(&middles, observer)?;
            let misses: Vec<f64> = entries.iter().map(|entry| forces.miss(entry)).collect();
            between = misses.iter().copied().fold(0.0, f64::max);
            steps = steps
                .into_iter()
                .zip(&entries)
                .zip(misses)
                .filter(|(_, miss)| *miss > 1.0)
                .map(|(step, _)| step)
                .flat_map(|((from, to), entry)| [(from, entry.place), (entry.place, to)])
                .collect();
            forces.table.extend(entries);
            forces.table.sort_by(|a, b| a.place.total_cmp(&b.place));
        }
        forces.worst = forces.table.iter().map(|entry| entry.worst).fold(between, f64::max);
        Ok(forces)
    }

    /// The rail at some ln Ω.
    fn ask(&self, places: &[f64], observer: &dyn Observer) -> Result<Vec<Entry>, InteractionError> {
        if places.is_empty() {
            return Ok(Vec::new());
        }
        observer.begin("contact forces", places.len() as u64);
        let entries = places
            .par_iter()
            .map(|&place| {
                let (alpha, worst) = self.wheels.rail_at(&self.distances, place.exp() * self.wheels.speed)?;
                observer.done()?;
                Ok(Entry { place, alpha, worst })
            })
            .collect();
        observer.end();
        entries
    }

    /// How far the forces of the table without `entry` are from those of it, over what is allowed.
    fn miss(&self, entry: &Entry) -> f64 {
        let (exact, guess) = (
            self.forces(&entry.alpha, entry.place),
            self.forces(&self.interpolated(entry.place), entry.place),
        );
        let largest = exact.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let misses = exact
            .iter()
            .zip(&guess)
            .map(|(p, q)| miss((q - p).norm(), ACCURACY * p.norm().max(0.1 * largest)));
        misses.fold(0.0, f64::max)
    }

    /// α at ln Ω = `place` from the polynomial through its neighbours; no number beyond the table.
    fn interpolated(&self, place: f64) -> Vec<Complex64> {
        let above = self.table.partition_point(|entry| entry.place < place);
        let first = above.saturating_sub(NEIGHBOURS / 2).min(self.table.len() - NEIGHBOURS);
        let near = &self.table[first..first + NEIGHBOURS];
        let nodes: [f64; NEIGHBOURS] = std::array::from_fn(|i| near[i].place);
        let ends = (self.table[0].place, self.table[self.table.len() - 1].place);
        let mut alpha = vec![Complex64::ZERO; near[0].alpha.len()];
        for (entry, weight) in near.iter().zip(lagrange_within(&nodes, place, ends)) {
            for (sum, value) in alpha.iter_mut().zip(&entry.alpha) {
                *sum += value * weight;
            }
        }
        alpha
    }

    /// The same for wheels each on a profile of its own, as one that is not round: wheel i meets e^{iΩ(vt + s_i)}, s_i = `starts`
    /// [m].
    pub fn on_profiles_of_their_own(self, starts: Vec<f64>) -> Self {
        Self { starts, ..self }
    }

    /// P_i from α of all distances at ln Ω = `place`.
    fn forces(&self, alpha: &[Complex64], place: f64) -> Vec<Complex64> {
        self.wheels.forces_from(&self.distances.matrix(alpha), place.exp() * self.wheels.speed, &self.starts)
    }

    /// p_i = P_i e^{iΩa_i} [N per metre of a profile e^{iΩx}], Ω = `wavenumber` [rad/m] within the range, no number beyond it: each force against the
    /// profile under its own wheel, so that p is smooth in Ω, however long the train (of wheels on one
    /// rail).
    pub fn at(&self, wavenumber: f64) -> Vec<Complex64> {
        let place = wavenumber.ln();
        let forces = self.forces(&self.interpolated(place), place);
        let axles = self.wheels.bodies.axles();
        forces.iter().zip(axles).map(|(p, a)| p * Complex64::cis(wavenumber * a.position)).collect()
    }
}
