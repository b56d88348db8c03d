//! Histories of a pass: the constant loads exactly, the rough rail for single profiles by inverse transform.

use super::{Irregularity, Pass, StudyError};
use crate::contact::ContactForces;
use crate::field::Sections;
use crate::irregularity::{Component, Realisation};
use crate::math::complex::I;
use crate::math::fourier::{fast_size, from_half_spectrum};
use crate::progress::Observer;
use crate::rail::TrackOnFoundation;
use crate::railway::Ground;
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
pub struct QuasiStatic {
    /// [m/s], receivers × times.
    pub velocity: Array2<f64>,
    pub converged: bool,
}

impl Pass<'_> {
    /// From long before the train to long after it, eight samples of the shortest period.
    pub fn times(&self) -> Times {
        let (speed, length) = (self.study.speed, self.train.length());
        let highest = self.study.bands.iter().map(|band| band.upper()).fold(0.0, f64::max);
        let step = 1.0 / (SAMPLES * highest);
        let before = (APPROACH.max(4.0 * self.study.farthest()) / speed).max(0.5);
        let count = fast_size(((length / speed + 2.0 * before) / step).ceil() as usize);
        Times { first: -before, step, count }
    }

    /// Velocity of the quasi-static part at the receivers.
    ///
    /// Accuracy: 1e-3 of the largest (test `cross_solver::passage`).
    pub fn quasi_static(
        &self,
        track: &TrackOnFoundation,
        times: Times,
        observer: &dyn Observer,
    ) -> Result<QuasiStatic, StudyError> {
        let Ground { profile, solver, .. } = self.railway.ground()?;
        let solver = super::pointwise(*solver);
        let speed = self.study.speed;
        let reach = speed * times.period().max(times.first.abs());
        observer.begin("quasi-static", self.study.receivers.len() as u64);
        let rows: Vec<(Vec<f64>, bool)> = self
            .study
            .receivers
            .par_iter()
            .map(|&y| {
                let one = track.passage((profile, solver), self.strip, speed, y, reach)?;
                let all = one.of_train(self.train.axles());
                observer.advance();
                Ok((all.velocities(times.first, times.step, times.count), one.converged))
            })
            .collect::<Result<_, StudyError>>()?;
        observer.end();
        Ok(QuasiStatic {
            velocity: Array2::from_shape_fn((rows.len(), times.count), |(r, i)| rows[r].0[i]),
            converged: rows.iter().all(|row| row.1),
        })
    }

    /// The profiles to make histories of, their wavelengths from `shortest` [m] on. They have their wavenumbers in common, and do not repeat while the train passes.
    pub fn profiles(
        &self,
        irregularity: &Irregularity,
        shortest: f64,
        times: Times,
    ) -> Result<Vec<Realisation>, StudyError> {
        match irregularity {
            Irregularity::Given { profile, .. } => Ok(vec![profile.between(shortest, f64::INFINITY)]),
            Irregularity::Random { spectrum, wavelengths, seed, count } => {
                // eight components at least below twice the lowest wavenumber
                let way = self.study.speed * times.period() + self.train.length();
                let length = way.max(8.0 * wavelengths.1);
                let components = (length / wavelengths.0).ceil() as usize;
                let of = |i: usize| {
                    let seed = seed.wrapping_add(i as u64);
                    let whole = Realisation::of(spectrum, *wavelengths, components, seed)?;
                    Ok(whole.between(shortest, f64::INFINITY))
                };
                (0..*count).map(of).collect()
            }
        }
    }

    /// Velocity [m/s], receivers × times, that each of the `profiles` makes.
    ///
    /// The spectrum is exact at the harmonics of the period N Δt: what the train does earlier or later comes back in it, small
    /// as it is 150 m away.
    pub fn dynamic(
        &self,
        sections: &Sections,
        forces: &ContactForces,
        profiles: &[Realisation],
        times: Times,
        observer: &dyn Observer,
    ) -> Vec<Array2<f64>> {
        let (speed, receivers) = (self.study.speed, self.study.receivers.len());
        let components = profiles[0].components();
        let wheels: Vec<Vec<Complex64>> = components.par_iter().map(|c| forces.at(c.wavenumber)).collect();
        // ½ a e^{iθ}/v
        let wave = |c: &Component| Complex64::from_polar(0.5 * c.amplitude / speed, c.phase);
        let waves: Vec<Vec<Complex64>> =
            profiles.iter().map(|p| p.components().iter().map(wave).collect()).collect();
        let highest = self.study.bands.iter().map(|band| band.upper()).fold(0.0, f64::max);
        let harmonics = (highest * times.period()).floor() as usize;
        observer.begin("dynamic", harmonics as u64);
        // v̂ of each profile and receiver, at each harmonic
        let spectra: Vec<Array2<Complex64>> = (0..=harmonics)
            .into_par_iter()
            .map(|m| {
                let mut v = Array2::zeros((profiles.len(), receivers));
                if m == 0 {
                    return v;
                }
                let omega = TAU * m as f64 / times.period();
                let ground = sections.at(omega);
                let phases = self.phases(omega);
                let shift = omega / speed;
                for (j, (component, p)) in components.iter().zip(&wheels).enumerate() {
                    // P(−Ω) = conj P(Ω)
                    let up: Complex64 = p.iter().zip(&phases).map(|(p, c)| p * c).sum();
                    let down: Complex64 = p.iter().zip(&phases).map(|(p, c)| p.conj() * c).sum();
                    for r in 0..receivers {
                        let near = up * ground.transfer(r, component.wavenumber - shift);
                        let far = down * ground.transfer(r, component.wavenumber + shift);
                        for (i, waves) in waves.iter().enumerate() {
                            v[(i, r)] += waves[j] * near + waves[j].conj() * far;
                        }
                    }
                }
                observer.advance();
                // e^{iωt} of the first sample
                v * (I * omega * Complex64::cis(omega * times.first))
            })
            .collect();
        observer.end();
        let history = |i: usize, r: usize| {
            let spectrum: Vec<Complex64> = spectra.iter().map(|v| v[(i, r)]).collect();
            from_half_spectrum(&spectrum, times.step, times.count)
        };
        (0..profiles.len())
            .into_par_iter()
            .map(|i| {
                let rows: Vec<Vec<f64>> = (0..receivers).map(|r| history(i, r)).collect();
                Array2::from_shape_fn((receivers, times.count), |(r, t)| rows[r][t])
            })
            .collect()
    }
}
