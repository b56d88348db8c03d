//! The ground across the track at any frequency: h(β, ω) between sections at some.

use super::section::Heard;
use super::{Channel, Section};
use crate::math::interpolation::lagrange_within;
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
    channels: Vec<Channel>,
    /// Of the slowest wave [s/m].
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
    /// Largest slowness that reaches each channel [s/m].
    reach: Vec<f64>,
}

/// h(β) at one ω, for many β.
pub struct Tables(Vec<Heard>);

impl Tables {
    /// h(β) of channel number `channel` [m per N/m] for many β; 0 where β is too short a wave to arrive.
    pub fn transfers(&self, channel: usize, beta: impl Iterator<Item = f64>) -> Vec<Complex64> {
        self.0[channel].at_many(beta)
    }

    /// Largest β that reaches a channel [rad/m].
    pub fn reach(&self) -> f64 {
        self.0.iter().map(|heard| heard.reach).fold(0.0, f64::max)
    }
}

impl Sections {
    /// Sections for frequencies `range` (lowest, highest) [rad/s], above zero, and `channels`; `slowness` [s/m] is that of the
    /// slowest wave, `section` makes one.
    ///
    /// At one slowness s = β/ω the waves of a half-space keep their places and e^{−iωτ(s)}, τ = y√(s_R² − s²), is all that changes. It
    /// is taken out and put back; other waves and layers leave some of it. Sections stand 4/τ(0) apart, are halved once
    /// everywhere, and again where that told something new.
    ///
    /// Accuracy: measured while halving, better than 1e-3 of the largest h of each channel (test
    /// `cross_solver::free_field::between_sections`).
    ///
    /// # Errors
    /// The first one of `section`; told to stop.
    pub fn new<E: From<Cancelled> + Send>(
        range: (f64, f64),
        channels: &[Channel],
        slowness: f64,
        section: impl Fn(f64) -> Result<Section, E> + Sync,
        observer: &dyn Observer,
    ) -> Result<Self, E> {
        let time = slowness * channels.iter().map(|c| c.y).fold(0.0, f64::max);
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
        let channels = channels.to_vec();
        let mut result = Self { omega, sections, channels, slowness, worst: 0.0 };
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
            |c: usize| parts.iter().map(|(omega, section, _)| section.reach(c) / omega).fold(0.0, f64::max);
        let reach = (0..self.channels.len()).map(reach).collect();
        Between { of: self, omega, parts, reach }
    }

    /// Largest β that reaches a channel at any of them [rad/m].
    pub fn reach(&self) -> f64 {
        let channels = 0..self.channels.len();
        let of = |section: &Section| channels.clone().map(|c| section.reach(c)).fold(0.0, f64::max);
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
    /// The same as a table for each channel, on the pieces of the nearest section: quicker from some hundred β on.
    pub fn tables(&self) -> Tables {
        let apart = |part: &&(f64, &Section, f64)| (part.0 - self.omega).abs();
        let nearest =
            self.parts.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(&self.parts[0]);
        let stretch = self.omega / nearest.0;
        let heard = |c: usize| Heard {
            table: nearest.1.alike(c, stretch, |beta| self.transfers(c, beta)),
            reach: (self.reach[c] * self.omega).min(stretch * nearest.1.reach(c)),
            motion: self.of.channels[c].motion,
        };
        Tables((0..self.of.channels.len()).map(heard).collect())
    }

    /// h(β) of channel number `channel` [m per N/m].
    pub fn transfer(&self, channel: usize, beta: f64) -> Complex64 {
        self.transfers(channel, &[beta])[0]
    }

    /// The same at many β.
    pub fn transfers(&self, channel: usize, beta: &[f64]) -> Vec<Complex64> {
        let (slowest, distance) = (self.of.slowness, self.of.channels[channel].y);
        let slownesses: Vec<f64> = beta.iter().map(|beta| beta / self.omega).collect();
        // τ(s); evanescent waves have no phase to take out
        let time = |s: &f64| (slowest * slowest - s * s).max(0.0).sqrt() * distance;
        let times: Vec<f64> = slownesses.iter().map(time).collect();
        let mut sums = vec![Complex64::ZERO; beta.len()];
        for &(omega, section, weight) in &self.parts {
            let values = section.transfers(channel, slownesses.iter().map(|s| s * omega));
            let later = omega - self.omega;
            dispatch!(Level::new(), simd => add_turned(simd, &mut sums, &values, &times, (weight, later)));
        }
        for (sum, _) in sums.iter_mut().zip(&slownesses).filter(|(_, s)| s.abs() > self.reach[channel]) {
            *sum = Complex64::ZERO;
        }
        sums
    }

    /// How far `section`, at this ω, is from what its neighbours say, over what is allowed.
    fn miss(&self, section: &Section) -> f64 {
        let apart = (0..self.of.channels.len()).map(|c| {
            let (mut largest, mut difference) = (0.0f64, 0.0f64);
            for i in 0..PROBES {
                let beta = 1.2 * self.of.slowness * self.omega * (i as f64 + 0.5) / PROBES as f64;
                let h = section.transfer(c, beta);
                largest = largest.max(h.norm());
                difference = difference.max((self.transfer(c, beta) - h).norm());
            }
            miss(difference, PREDICTED * largest)
        });
        apart.fold(0.0, f64::max)
    }
}
