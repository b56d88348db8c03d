//! Energy of a pass in third octaves.

use super::passes::Times;
use super::{Driven, Pass, StudyError};
use crate::assessment::rms;
use crate::contact::{COUPLED, ContactForces};
use crate::field::{Sections, Transfer};
use crate::irregularity::Spectrum;
use crate::math::interpolation::cubic_weights;
use crate::progress::Observer;
use crate::railway::Ground;
use crate::signal::{EnergySpectrum, History};
use crate::soil::{GroundSolver, Profile, Solver};
use crate::vehicle::Axle;
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Cells of a band, of equal width in ln f.
const PER_BAND: usize = 8;
/// Components of the profile at least, per factor e of wavelength.
const COMPONENTS: f64 = 200.0;

/// Energy [m²/s² s] of the velocity, receivers × bands.
pub struct Energies {
    pub quasi_static: Array2<f64>,
    pub dynamic: Array2<f64>,
    pub total: Array2<f64>,
    /// False where an integral missed its accuracy.
    pub converged: bool,
}

/// One component of the profile: Ω, ½ S dΩ/v² and the forces p_i = P_i e^{iΩa_i} it makes, each against the profile under its
/// wheel: they are smooth in Ω, however long the train.
pub struct Component {
    wavenumber: f64,
    weight: f64,
    /// S(Ω) [m²/(rad/m)]
    density: f64,
    forces: Vec<Complex64>,
}

impl Component {
    /// What it does to the leading wheelset: one-sided in f̃ = Ωv/2π, S_P = |P|² S dΩ/df̃.
    pub fn driven(&self, speed: f64) -> Driven {
        Driven {
            frequency: self.wavenumber * speed / TAU,
            force: self.forces[0].norm() * (self.density * TAU / speed).sqrt(),
        }
    }
}

/// |Σ_i p_i e^{−iωa_i/v}|² averaged over a cell. Wheels on one profile pass a receiver one after the other with the same forces, so
/// this turns within v/length [Hz] for constant loads and for a rough rail alike.
struct Rows {
    /// Two wheels i > j and the mean of e^{−iω(a_i − a_j)/v}.
    pairs: Vec<(usize, usize, Complex64)>,
}

impl Rows {
    /// Wheels on `axles` at `speed` [m/s], over the cell of centre and width `cell` [Hz].
    fn new(axles: &[Axle], speed: f64, cell: (f64, f64)) -> Self {
        let pair = |i: usize, j: usize| {
            let delay = (axles[i].position - axles[j].position) / speed;
            let half = 0.5 * TAU * cell.1 * delay;
            let sinc = if half.abs() < 1e-8 { 1.0 } else { half.sin() / half };
            (i, j, Complex64::cis(-TAU * cell.0 * delay) * sinc)
        };
        Self { pairs: (0..axles.len()).flat_map(|i| (0..i).map(move |j| pair(i, j))).collect() }
    }

    /// The mean of forces p, and that of their conjugates.
    fn means(&self, forces: &[Complex64]) -> (f64, f64) {
        // Σ|p_i|² + 2 Re Σ_{i>j} p_i p̄_j c_ij
        let alone: f64 = forces.iter().map(|p| p.norm_sqr()).sum();
        let (mut even, mut odd) = (0.0, 0.0);
        for &(i, j, c) in &self.pairs {
            let q = forces[i] * forces[j].conj();
            even += q.re * c.re;
            odd += q.im * c.im;
        }
        (alone + 2.0 * (even - odd), alone + 2.0 * (even + odd))
    }
}

/// |h|² along β = ω/v of loads slower than the waves: there it falls over tens of decades, where its logarithm is smooth.
struct Slow {
    /// ln f of the first value and the step between them.
    low: f64,
    step: f64,
    /// ln |h|² of each frequency and receiver; None where nothing arrives that the integral could tell from its rounding.
    logarithms: Vec<Vec<Option<f64>>>,
    converged: bool,
}

/// Error of h from which on it counts as missed.
const LEAST: f64 = 1e-3;

impl Slow {
    /// Of `pass` between the frequencies `range` [Hz], on a ground with its exact solver: each β has its own ω.
    fn new(
        pass: &Pass,
        (profile, solver): (&Profile, Solver),
        range: (f64, f64),
    ) -> Result<Self, StudyError> {
        let study = pass.study;
        let (low, high) = (range.0.ln(), range.1.ln());
        let count = 4 * study.bands.len() + 1;
        let step = (high - low) / (count - 1) as f64;
        let rows: Vec<Vec<Option<(Complex64, bool)>>> = (0..count)
            .into_par_iter()
            .map(|i| {
                let omega = TAU * (low + step * i as f64).exp();
                let ground = solver.prepare(profile, omega, &[])?;
                let transfer = Transfer::new(pass.railway.stack(), ground.as_ref(), pass.strip, omega);
                let h = |y: &f64| transfer.exact(omega / study.speed, *y, LEAST);
                Ok(study.receivers.iter().map(h).collect())
            })
            .collect::<Result<_, StudyError>>()?;
        // velocities ω|h| of less than 1e-3 of a receiver's largest add 1e-6 of its energy: what is known of them does not count
        let velocity =
            |i: usize, r: usize| rows[i][r].map_or(0.0, |h| h.0.norm() * (low + step * i as f64).exp());
        let converged = (0..study.receivers.len()).all(|r| {
            let largest = (0..count).map(|i| velocity(i, r)).fold(0.0, f64::max);
            (0..count).all(|i| rows[i][r].is_none_or(|h| h.1) || velocity(i, r) < 1e-3 * largest)
        });
        let logarithm = |h: Option<(Complex64, bool)>| h.map(|h| h.0.norm_sqr().ln());
        let logarithms = rows.into_iter().map(|row| row.into_iter().map(logarithm).collect()).collect();
        Ok(Self { low, step, logarithms, converged })
    }

    /// |h|² at receiver number `receiver` and `f` [Hz]: a cubic through four logarithms; 0 where one of them is not known.
    fn square(&self, receiver: usize, f: f64) -> f64 {
        let place = (f.ln() - self.low) / self.step;
        let i = (place.floor() as isize).clamp(1, self.logarithms.len() as isize - 3) as usize;
        let weights = cubic_weights(place - i as f64);
        let sum: Option<f64> =
            (0..4).map(|m| self.logarithms[i + m - 1][receiver].map(|l| weights[m] * l)).sum();
        sum.map_or(0.0, f64::exp)
    }
}

/// What knows h along β = ω/v.
enum Along<'a> {
    Slow(Slow),
    Fast(&'a Sections),
}

impl Energies {
    /// Of the axle loads alone: ∫ 2ω² |h|² |Σ P_i e^{−iωa_i/v}|²/v² df, sampled as finely as the phases turn; `fast`
    /// are the sections that answer where the loads outrun a wave, None where they are slower than all of them.
    ///
    /// # Errors
    /// A ground that cannot answer.
    pub fn quasi_static(pass: &Pass, fast: Option<&Sections>) -> Result<Self, StudyError> {
        let study = pass.study;
        let Ground { profile, solver, .. } = pass.railway.ground()?;
        let (Some(first), Some(last)) = (study.bands.first(), study.bands.last()) else {
            let nothing = Array2::zeros((study.receivers.len(), 0));
            return Ok(Self {
                quasi_static: nothing.clone(),
                dynamic: nothing.clone(),
                total: nothing,
                converged: true,
            });
        };
        let along = match fast {
            Some(sections) => Along::Fast(sections),
            None => {
                let range = (first.lower(), last.upper());
                Along::Slow(Slow::new(pass, (profile, super::pointwise(*solver)), range)?)
            }
        };
        let converged = !matches!(&along, Along::Slow(slow) if !slow.converged);
        let squares = |f: f64| -> Vec<f64> {
            let receivers = 0..study.receivers.len();
            match &along {
                Along::Slow(slow) => receivers.map(|r| slow.square(r, f)).collect(),
                Along::Fast(sections) => {
                    let ground = sections.at(TAU * f);
                    receivers.map(|r| ground.transfer(r, TAU * f / study.speed).norm_sqr()).collect()
                }
            }
        };
        let mut energies = Array2::zeros((study.receivers.len(), study.bands.len()));
        for (b, band) in study.bands.iter().enumerate() {
            let (from, to) = (band.lower(), band.upper());
            // fields of fast loads beat with the receiver's distance
            let turns = (to - from) * (pass.train.length() + study.farthest()) / study.speed;
            let samples = 16 + (8.0 * turns).ceil() as usize;
            let width = (to - from) / samples as f64;
            let rows: Vec<Vec<f64>> = (0..samples)
                .into_par_iter()
                .map(|s| {
                    let f = from + width * (s as f64 + 0.5);
                    let phases = pass.phases(TAU * f);
                    let loads: Complex64 =
                        pass.train.axles().iter().zip(phases).map(|(a, phase)| a.load * phase).sum();
                    let scale = 2.0 * (TAU * f / study.speed).powi(2) * loads.norm_sqr() * width;
                    squares(f).iter().map(|h| scale * h).collect()
                })
                .collect();
            for (r, slot) in energies.column_mut(b).iter_mut().enumerate() {
                *slot = rows.iter().map(|row| row[r]).sum();
            }
        }
        Ok(Self {
            dynamic: Array2::zeros(energies.raw_dim()),
            total: energies.clone(),
            quasi_static: energies,
            converged,
        })
    }

    /// Adds the expected energy of the profiles with these `components`, cell by cell, the passage of the wheels averaged over
    /// each.
    pub fn add_expected(
        &mut self,
        pass: &Pass,
        sections: &Sections,
        components: &[Component],
        observer: &dyn Observer,
    ) {
        let study = pass.study;
        let count = study.bands.len() * PER_BAND;
        observer.begin("bands", count as u64);
        let cells: Vec<Vec<f64>> = (0..count)
            .into_par_iter()
            .map(|i| {
                let band = study.bands[i / PER_BAND];
                let ratio = (band.upper() / band.lower()).ln() / PER_BAND as f64;
                let from = band.lower() * (ratio * (i % PER_BAND) as f64).exp();
                let (f, width) = (from * (0.5 * ratio).exp(), from * (ratio.exp() - 1.0));
                let omega = TAU * f;
                let (ground, shift) = (sections.at(omega), omega / study.speed);
                let rows = Rows::new(pass.train.axles(), study.speed, (f, width));
                let mut energy = vec![0.0; study.receivers.len()];
                for component in components {
                    // P(−Ω) = conj P(Ω)
                    let (up, down) = rows.means(&component.forces);
                    for (r, slot) in energy.iter_mut().enumerate() {
                        let near = ground.transfer(r, component.wavenumber - shift).norm_sqr();
                        let far = ground.transfer(r, component.wavenumber + shift).norm_sqr();
                        *slot += 2.0 * omega * omega * width * component.weight * (up * near + down * far);
                    }
                }
                observer.advance();
                energy
            })
            .collect();
        observer.end();
        for (i, energy) in cells.iter().enumerate() {
            for (r, e) in energy.iter().enumerate() {
                self.dynamic[(r, i / PER_BAND)] += e;
            }
        }
        // without a phase between them, the parts add in the mean
        self.total = &self.quasi_static + &self.dynamic;
    }

    /// Sets the energy of one profile from histories [m/s], receivers × times: its own without the quasi-static part, and all of it.
    ///
    /// # Errors
    /// Velocities that are not numbers; bands beyond the samples.
    pub fn add_given(
        &mut self,
        pass: &Pass,
        total: &Array2<f64>,
        quasi_static: &Array2<f64>,
        times: Times,
    ) -> Result<(), StudyError> {
        let bands = |velocity: &Array2<f64>, energies: &mut Array2<f64>| -> Result<(), StudyError> {
            for (row, mut energies) in velocity.rows().into_iter().zip(energies.rows_mut()) {
                let spectrum = EnergySpectrum::of(&History::new(times.step, row.to_vec())?);
                for (band, slot) in pass.study.bands.iter().zip(&mut energies) {
                    *slot = band.energy(&spectrum)?;
                }
            }
            Ok(())
        };
        bands(&(total - quasi_static), &mut self.dynamic)?;
        // a history ends, and what is cut off there leaks into bands where the quasi-static part is next to nothing: only its
        // product with the dynamic part is taken from histories
        let mut cut = self.quasi_static.clone();
        bands(quasi_static, &mut cut)?;
        bands(total, &mut self.total)?;
        let product = &self.total - &cut - &self.dynamic;
        self.total = (&self.quasi_static + &self.dynamic + product).mapv(|energy| energy.max(0.0));
        Ok(())
    }

    /// r.m.s. velocities [m/s] over the passage time: quasi-static, dynamic, total.
    ///
    /// # Errors
    /// A passage time that is not positive.
    pub fn velocities(&self, passage_time: f64) -> Result<[Array2<f64>; 3], StudyError> {
        let velocity = |energies: &Array2<f64>| {
            let mut v = energies.clone();
            for slot in &mut v {
                *slot = rms(*slot, passage_time)?;
            }
            Ok::<_, StudyError>(v)
        };
        Ok([velocity(&self.quasi_static)?, velocity(&self.dynamic)?, velocity(&self.total)?])
    }
}

impl Pass<'_> {
    /// Components of `spectrum` between `wavelengths` (shortest, longest) [m], in equal steps of ln Ω.
    pub fn components(
        &self,
        spectrum: &Spectrum,
        wavelengths: (f64, f64),
        forces: &ContactForces,
    ) -> Vec<Component> {
        let speed = self.study.speed;
        let (low, high) = ((TAU / wavelengths.1).ln(), (TAU / wavelengths.0).ln());
        // fine enough for the phases between wheels that feel one another
        let phase = high.exp() * self.train.length().clamp(1.0, COUPLED) / (0.25 * TAU);
        // slow wheels: waves of all phase speeds meet within Ω (1 ± v/c)
        let fastest = self
            .railway
            .ground()
            .map_or(0.0, |ground| ground.profile.materials().map(|m| m.c_s()).fold(0.0, f64::max));
        // within which a branch point is blurred by damping alone
        let least = self
            .railway
            .ground()
            .map_or(1.0, |ground| ground.profile.materials().map(|m| m.loss_factor()).fold(1.0, f64::min));
        let narrow = least.max(1e-3).recip().max(20.0) * fastest / speed;
        let count = ((high - low) * COMPONENTS.max(phase).max(narrow)).ceil() as usize;
        let width = (high - low) / count as f64;
        (0..count)
            .into_par_iter()
            .map(|j| {
                let wavenumber = (low + width * (j as f64 + 0.5)).exp();
                let density = spectrum.one_sided(wavenumber);
                Component {
                    wavenumber,
                    weight: 0.5 * density * wavenumber * width / speed.powi(2),
                    density,
                    forces: forces.at(wavenumber),
                }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_passage_is_the_mean_over_its_cell() {
        let axles: Vec<Axle> =
            [0.0, 2.5, 17.4, 19.9, 193.0].map(|position| Axle { position, load: 1.0 }).into();
        let forces: Vec<Complex64> =
            (0..5).map(|i| Complex64::from_polar(1.0 + f64::from(i), 0.7 * f64::from(i * i))).collect();
        let conjugates: Vec<Complex64> = forces.iter().map(|p| p.conj()).collect();
        let (speed, cell) = (67.5, (25.0, 1.4));
        let mean = |forces: &[Complex64]| {
            let samples = 20_000;
            let at = |s: usize| cell.0 + cell.1 * ((s as f64 + 0.5) / samples as f64 - 0.5);
            let sum = |f: f64| -> Complex64 {
                forces
                    .iter()
                    .zip(&axles)
                    .map(|(p, a)| p * Complex64::cis(-TAU * f * a.position / speed))
                    .sum()
            };
            (0..samples).map(|s| sum(at(s)).norm_sqr()).sum::<f64>() / samples as f64
        };
        let (up, down) = Rows::new(&axles, speed, cell).means(&forces);
        // midpoint rule: measured below 1e-7
        assert!((up / mean(&forces) - 1.0).abs() < 1e-6, "{up} {}", mean(&forces));
        assert!((down / mean(&conjugates) - 1.0).abs() < 1e-6, "{down} {}", mean(&conjugates));
    }
}
