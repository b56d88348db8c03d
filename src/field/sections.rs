//! The ground across the track at any frequency: h(β, ω) between sections at some.

use super::Section;
use super::section::cut_off;
use crate::math::interpolation::{Interpolant, lagrange_within};
use crate::math::lanes::{LANES, sin_cos};
use crate::math::quadrature::miss;
use crate::progress::{Cancelled, Observer};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;
use rayon::prelude::*;

/// Sections that make one value.
const NODES: usize = 6;
/// Difference of a new section from what the old ones say, relative to its largest value, below which the new ones are dense
/// enough; six points twice as dense are 2⁶ times as good.
const PREDICTED: f64 = 3e-2;
/// How often a distance between sections may be halved.
const HALVINGS: usize = 5;
/// Slownesses at which sections are compared, up to 1.2 times the slowest wave.
const PROBES: usize = 24;

/// Sections at ascending frequencies, dense enough for what lies between them.
pub struct Sections {
    omega: Vec<f64>,
    sections: Vec<Section>,
    /// Distances of the receivers [m] and the slowness of the slowest wave [s/m].
    receivers: Vec<f64>,
    slowness: f64,
    /// Error over what was allowed, of a section or of what lies between two, where it is largest: at most 1 where the accuracy was
    /// reached.
    pub worst: f64,
}

/// h(β) at one ω between the sections.
pub struct Between<'a> {
    of: &'a Sections,
    omega: f64,
    /// ω of a section, the section, its weight.
    parts: [(f64, &'a Section, f64); NODES],
    /// Largest slowness that reaches each receiver [s/m].
    reach: Vec<f64>,
}

/// h(β) at one ω, for many β.
pub struct Tables(Vec<(f64, Interpolant)>);

impl Tables {
    /// h(β) at receiver number `receiver` [m per N/m] for many β; 0 where β is too short a wave to arrive.
    pub fn transfers(&self, receiver: usize, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
        let (reach, table) = &self.0[receiver];
        cut_off(table, *reach, beta)
    }

    /// Largest β that reaches a receiver [rad/m].
    pub fn reach(&self) -> f64 {
        self.0.iter().map(|table| table.0).fold(0.0, f64::max)
    }
}

impl Sections {
    /// Sections for frequencies `range` (lowest, highest) [rad/s], above zero, and `receivers` [m]; `slowness` [s/m] is that of the
    /// slowest wave, `section` makes one.
    ///
    /// At one slowness s = β/ω the waves of a half-space keep their places and e^{−iωτ(s)}, τ = y√(s_R² − s²), is all that changes. It
    /// is taken out and put back; other waves and layers leave some of it. Sections stand 4/τ(0) apart, are halved once
    /// everywhere, and again where that told something new.
    ///
    /// Accuracy: measured while halving, better than 1e-3 of the largest h of each receiver (test
    /// `cross_solver::free_field::between_sections`).
    ///
    /// # Errors
    /// The first one of `section`; told to stop.
    pub fn new<E: From<Cancelled> + Send>(
        range: (f64, f64),
        receivers: &[f64],
        slowness: f64,
        section: impl Fn(f64) -> Result<Section, E> + Sync,
        observer: &dyn Observer,
    ) -> Result<Self, E> {
        let time = slowness * receivers.iter().copied().fold(0.0, f64::max);
        let mut omega = vec![range.0];
        while omega[omega.len() - 1] < range.1 || omega.len() < NODES {
            let last = omega[omega.len() - 1];
            // long waves and layers: their fields change with ω itself
            omega.push(last + (4.0 / time).min(0.3 * last));
        }
        let make = |omega: &[f64]| -> Result<Vec<Section>, E> {
            observer.begin("ground", omega.len() as u64);
            let one = |w: &f64| {
                let section = section(*w)?;
                observer.done()?;
                Ok(section)
            };
            let sections = omega.par_iter().map(one).collect();
            observer.end();
            sections
        };
        let sections = make(&omega)?;
        let receivers = receivers.to_vec();
        let mut result = Self { omega, sections, receivers, slowness, worst: 0.0 };
        // whether the interval above each section is to be halved
        let mut halve = vec![true; result.omega.len() - 1];
        let mut between = 0.0;
        for _ in 0..HALVINGS {
            let middles: Vec<f64> = (0..halve.len())
                .filter(|i| halve[*i])
                .map(|i| 0.5 * (result.omega[i] + result.omega[i + 1]))
                .collect();
            if middles.is_empty() {
                break;
            }
            let new = make(&middles)?;
            let apart: Vec<f64> =
                middles.iter().zip(&new).map(|(w, section)| result.at(*w).miss(section)).collect();
            between = apart.iter().copied().fold(0.0, f64::max);
            let told = apart.iter().map(|apart| *apart > 1.0).collect();
            halve = result.merge(&halve, (middles, new, told));
        }
        result.worst = result.sections.iter().map(|section| section.worst).fold(between, f64::max);
        Ok(result)
    }

    /// Takes the middles of the intervals marked in `halved` in; which of the new intervals to halve: those about a middle that
    /// told something new.
    fn merge(&mut self, halved: &[bool], new: (Vec<f64>, Vec<Section>, Vec<bool>)) -> Vec<bool> {
        let old = std::mem::take(&mut self.omega).into_iter().zip(std::mem::take(&mut self.sections));
        let mut middles = new.0.into_iter().zip(new.1).zip(new.2);
        let mut again = Vec::new();
        for (i, (omega, section)) in old.enumerate() {
            self.omega.push(omega);
            self.sections.push(section);
            if halved.get(i) == Some(&true) {
                if let Some(((omega, section), told)) = middles.next() {
                    self.omega.push(omega);
                    self.sections.push(section);
                    again.extend([told, told]);
                }
            } else if i < halved.len() {
                again.push(false);
            }
        }
        again
    }

    /// h at `omega` > 0 [rad/s]; beyond the sections it is no number, as a polynomial knows nothing there.
    pub fn at(&self, omega: f64) -> Between<'_> {
        let above = self.omega.partition_point(|w| *w < omega);
        let first = above.saturating_sub(NODES / 2).min(self.omega.len() - NODES);
        let nodes: [f64; NODES] = std::array::from_fn(|i| self.omega[first + i]);
        let weights = lagrange_within(&nodes, omega, (self.omega[0], self.omega[self.omega.len() - 1]));
        let parts: [(f64, &Section, f64); NODES] =
            std::array::from_fn(|i| (nodes[i], &self.sections[first + i], weights[i]));
        let reach =
            |r: usize| parts.iter().map(|(omega, section, _)| section.reach(r) / omega).fold(0.0, f64::max);
        let reach = (0..self.receivers.len()).map(reach).collect();
        Between { of: self, omega, parts, reach }
    }

    /// Largest β that reaches a receiver at any of them [rad/m].
    pub fn reach(&self) -> f64 {
        let receivers = 0..self.receivers.len();
        let of = |section: &Section| receivers.clone().map(|r| section.reach(r)).fold(0.0, f64::max);
        self.sections.iter().map(of).fold(0.0, f64::max)
    }

    /// Whether all were found on lifted paths.
    pub fn lifted(&self) -> bool {
        self.sections.iter().all(|section| section.lifted)
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.omega.len()
    }
}

/// Adds `values` times weight e^{iφ}, φ = `later` τ of the `times` τ, to `sums`.
#[inline(always)]
fn add_turned<S: Simd>(
    simd: S,
    sums: &mut [Complex64],
    values: &[Complex64],
    times: &[f64],
    (weight, later): (f64, f64),
) {
    let eights = sums.chunks_mut(LANES).zip(values.chunks(LANES)).zip(times.chunks(LANES));
    for ((sums, values), times) in eights {
        let (sin, cos) = sin_cos(f64x8::from_fn(simd, |i| times.get(i).map_or(0.0, |time| later * time)));
        for (i, (sum, value)) in sums.iter_mut().zip(values).enumerate() {
            *sum += value * Complex64::new(weight * cos[i], weight * sin[i]);
        }
    }
}

impl Between<'_> {
    /// The same as a table for each receiver, on the pieces of the nearest section: quicker from some hundred β on.
    pub fn tables(&self) -> Tables {
        let apart = |part: &&(f64, &Section, f64)| (part.0 - self.omega).abs();
        let nearest =
            self.parts.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(&self.parts[0]);
        let stretch = self.omega / nearest.0;
        let table = |r: usize| {
            let reach = self.reach[r] * self.omega;
            (
                reach.min(stretch * nearest.1.reach(r)),
                nearest.1.alike(r, stretch, |beta| self.transfers(r, beta)),
            )
        };
        Tables((0..self.of.receivers.len()).map(table).collect())
    }

    /// h(β) at receiver number `receiver` [m per N/m].
    pub fn transfer(&self, receiver: usize, beta: f64) -> Complex64 {
        self.transfers(receiver, &[beta])[0]
    }

    /// The same at many β.
    pub fn transfers(&self, receiver: usize, beta: &[f64]) -> Vec<Complex64> {
        let (slowest, distance) = (self.of.slowness, self.of.receivers[receiver]);
        let slownesses: Vec<f64> = beta.iter().map(|beta| beta.abs() / self.omega).collect();
        // τ(s); evanescent waves have no phase to take out
        let time = |s: &f64| (slowest * slowest - s * s).max(0.0).sqrt() * distance;
        let times: Vec<f64> = slownesses.iter().map(time).collect();
        let mut sums = vec![Complex64::ZERO; beta.len()];
        for &(omega, section, weight) in &self.parts {
            let values = section.transfers(receiver, slownesses.iter().map(|s| s * omega));
            let later = omega - self.omega;
            dispatch!(Level::new(), simd => add_turned(simd, &mut sums, &values, &times, (weight, later)));
        }
        for (sum, _) in sums.iter_mut().zip(&slownesses).filter(|(_, s)| **s > self.reach[receiver]) {
            *sum = Complex64::ZERO;
        }
        sums
    }

    /// How far `section`, at this ω, is from what its neighbours say, over what is allowed.
    fn miss(&self, section: &Section) -> f64 {
        let apart = (0..self.of.receivers.len()).map(|r| {
            let (mut largest, mut difference) = (0.0f64, 0.0f64);
            for i in 0..PROBES {
                let beta = 1.2 * self.of.slowness * self.omega * (i as f64 + 0.5) / PROBES as f64;
                let h = section.transfer(r, beta);
                largest = largest.max(h.norm());
                difference = difference.max((self.transfer(r, beta) - h).norm());
            }
            miss(difference, PREDICTED * largest)
        });
        apart.fold(0.0, f64::max)
    }
}
