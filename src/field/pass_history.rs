//! Histories of a pass: of the constant axle loads exactly, of a rough rail for single profiles by inverse transform.
//!
//! ```text
//! û_dyn(ω) = (1/2v) Σ_j a_j ( e^{iθ_j} H_j⁺ + e^{−iθ_j} H_j⁻ )            r(x) = Σ_j a_j cos(Ω_j x + θ_j)
//! H_j^± = h(±Ω_j − ω/v, ω) Σ_i p_i(±Ω_j) e^{−iωa_i/v}
//! ```
//!
//! with h the ground's displacement per unit force on the rail, p_i the force of wheel i per metre of a profile e^{iΩx}, against the
//! profile under its own wheel, a_i behind the leading one.

use super::pass::{Pass, pointwise};
use super::{Sections, Tables};
use crate::irregularity::{Component, Realisation};
use crate::math::complex::I;
use crate::math::fourier::{fast_size, from_half_spectrum};
use crate::progress::{Cancelled, Observer};
use crate::rail::{InteractionError, TrackOnFoundation};
use crate::soil::{Profile, Solver, Strip};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Way of the train before and behind the receivers that belongs to a pass at least [m].
const APPROACH: f64 = 150.0;
/// Samples of the shortest period.
const SAMPLES: f64 = 8.0;

/// Times of the samples.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Of the first sample, after the leading axle was abreast of the receivers [s].
    pub first: f64,
    /// Δt [s]
    pub step: f64,
    /// N
    pub count: usize,
}

impl Times {
    /// N Δt [s]
    pub fn period(self) -> f64 {
        self.step * self.count as f64
    }

    /// All of them [s].
    pub fn values(self) -> Vec<f64> {
        (0..self.count).map(|i| self.first + self.step * i as f64).collect()
    }
}

/// The part of the constant axle loads.
#[derive(Clone, Debug)]
pub struct QuasiStatic {
    /// [m/s], positive down, in the direction of travel, away from the track, channels × times.
    pub velocity: Array2<f64>,
    /// Error of an integral over what was allowed, where it is largest: at most 1 where the accuracy was reached.
    pub worst: f64,
}

impl Pass<'_> {
    /// From long before the train to long after it, eight samples of the shortest period.
    pub fn times(&self) -> Times {
        let step = 1.0 / (SAMPLES * self.highest());
        let before = (APPROACH.max(4.0 * self.farthest()) / self.speed).max(0.5);
        let count = fast_size(((self.train.length() / self.speed + 2.0 * before) / step).ceil() as usize);
        Times { first: -before, step, count }
    }

    /// Velocity of the quasi-static part at the receivers, of `track` on the `strip` of a ground and its solver.
    ///
    /// Accuracy: 1e-3 of the largest (test `cross_solver::passage`).
    ///
    /// # Errors
    /// A ground that cannot answer; a response that diverges.
    pub fn quasi_static(
        &self,
        track: &TrackOnFoundation,
        (profile, solver): (&Profile, Solver),
        strip: Strip,
        times: Times,
        observer: &dyn Observer,
    ) -> Result<QuasiStatic, InteractionError> {
        let ground = (profile, pointwise(solver));
        let reach = self.speed * times.period().max(times.first.abs());
        let channels = self.channels();
        observer.begin("quasi-static", channels.len() as u64);
        let spectrum = track.spectrum(self.speed)?;
        let rows: Vec<(Vec<f64>, f64)> = channels
            .par_iter()
            .map(|&channel| {
                let one = spectrum.passage(ground, strip, channel, reach)?;
                let velocities =
                    one.of_train(self.train.axles()).velocities(times.first, times.step, times.count);
                observer.done()?;
                Ok((velocities, one.worst))
            })
            .collect::<Result<_, InteractionError>>()?;
        observer.end();
        Ok(QuasiStatic {
            velocity: Array2::from_shape_fn((rows.len(), times.count), |(r, i)| rows[r].0[i]),
            worst: rows.iter().map(|row| row.1).fold(0.0, f64::max),
        })
    }

    /// Velocity [m/s], channels × times, that each of the `profiles` makes; they have their wavenumbers Ω in common,
    /// at which `forces` gives p(Ω) [N/m] of all wheels.
    ///
    /// The spectrum is exact at the harmonics of the period N Δt: what the train does earlier or later comes back in it, small
    /// as it is 150 m away.
    ///
    /// Accuracy: 1.4e-2 of the largest value at the worst instant (test `cross_solver::free_field`).
    ///
    /// # Errors
    /// Told to stop.
    pub fn dynamic(
        &self,
        sections: &Sections,
        profiles: &[Realisation],
        forces: &(dyn Fn(f64) -> Vec<Complex64> + Sync),
        times: Times,
        observer: &dyn Observer,
    ) -> Result<Vec<Array2<f64>>, Cancelled> {
        let Some(first) = profiles.first() else { return Ok(Vec::new()) };
        let wheels: Vec<(f64, Vec<Complex64>)> =
            first.components().par_iter().map(|c| (c.wavenumber, forces(c.wavenumber))).collect();
        // ½ a e^{iθ}/v
        let wave = |c: &Component| Complex64::from_polar(0.5 * c.amplitude / self.speed, c.phase);
        let of = |j: usize| profiles.iter().map(|p| wave(&p.components()[j])).collect();
        let waves: Vec<Vec<Complex64>> = (0..wheels.len()).map(of).collect();
        let harmonics = (self.highest() * times.period()).floor() as usize;
        observer.begin("dynamic", harmonics as u64);
        let shape = (profiles.len(), self.channels().len());
        // v̂ of each profile and channel, at each harmonic
        let spectra: Vec<Array2<Complex64>> = (0..=harmonics)
            .into_par_iter()
            .map(|m| {
                if m == 0 {
                    return Ok(Array2::zeros(shape));
                }
                let omega = TAU * m as f64 / times.period();
                let u = self.spectrum(&sections.at(omega).tables(), omega, &wheels, &waves, profiles.len());
                observer.done()?;
                // e^{iωt} of the first sample
                Ok(u * (I * omega * Complex64::cis(omega * times.first)))
            })
            .collect::<Result<_, _>>()?;
        observer.end();
        let history = |i: usize, r: usize| {
            let spectrum: Vec<Complex64> = spectra.iter().map(|v| v[(i, r)]).collect();
            from_half_spectrum(&spectrum, times.step, times.count)
        };
        Ok((0..shape.0)
            .into_par_iter()
            .map(|i| {
                let rows: Vec<Vec<f64>> = (0..shape.1).map(|r| history(i, r)).collect();
                Array2::from_shape_fn((shape.1, times.count), |(r, t)| rows[r][t])
            })
            .collect())
    }

    /// û_dyn at one ω = `omega`, profiles × channels: `ground` there, Ω and p of all `wheels`, ½ a e^{iθ}/v of every one of the `waves` in
    /// each of so many `profiles`.
    fn spectrum(
        &self,
        ground: &Tables,
        omega: f64,
        wheels: &[(f64, Vec<Complex64>)],
        waves: &[Vec<Complex64>],
        profiles: usize,
    ) -> Array2<Complex64> {
        let channels = self.channels().len();
        let mut u = Array2::zeros((profiles, channels));
        let (phases, shift) = (self.phases(omega), omega / self.speed);
        // where Ω + ω/v arrives Ω − ω/v does
        let heard = |j: &usize| (wheels[*j].0 - shift).abs() <= ground.reach();
        let heard: Vec<usize> = (0..wheels.len()).filter(heard).collect();
        // p(−Ω) = conj p(Ω)
        let up = |j: &usize| -> Complex64 { wheels[*j].1.iter().zip(&phases).map(|(p, c)| p * c).sum() };
        let down =
            |j: &usize| -> Complex64 { wheels[*j].1.iter().zip(&phases).map(|(p, c)| p.conj() * c).sum() };
        let passed: Vec<[Complex64; 2]> = heard.iter().map(|j| [up(j), down(j)]).collect();
        for r in 0..channels {
            let near = ground.transfers(r, heard.iter().map(|j| wheels[*j].0 - shift));
            let far = ground.transfers(r, heard.iter().map(|j| -wheels[*j].0 - shift));
            for (((j, [up, down]), near), far) in heard.iter().zip(&passed).zip(near).zip(far) {
                let (near, far) = (up * near, down * far);
                for (u, wave) in u.column_mut(r).iter_mut().zip(&waves[*j]) {
                    *u += wave * near + wave.conj() * far;
                }
            }
        }
        u
    }
}
