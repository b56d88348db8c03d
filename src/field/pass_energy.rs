//! Energy of a pass in third octaves: of the constant axle loads, and of wheels on a rough rail.
//!
//! ```text
//! û_qs(ω) = (1/v) h(−ω/v, ω) Σ_i P_i e^{−iωa_i/v}
//! E|û_dyn(ω)|² = ∫ ½ S(Ω) ( |H⁺|² + |H⁻|² )/v² dΩ,   H^± = h(±Ω − ω/v, ω) Σ_i p_i(±Ω) e^{−iωa_i/v}
//! E_band = (1/π) ∫_band ω²|û|² dω
//! ```
//!
//! with h the ground's displacement per unit force on the rail, P_i the static load of axle i, a_i behind the leading one, and p_i its
//! force per metre of a profile e^{iΩx}, against the profile under its own wheel.

use super::pass::Pass;
use super::pass_history::Times;
use super::{ConstantLoad, Sections};
use crate::assessment::{AssessmentError, rms};
use crate::irregularity::Spectrum;
use crate::progress::{Cancelled, Observer};
use crate::signal::{EnergySpectrum, History};
use crate::soil::Profile;
use crate::vehicle::Axle;
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Cells of a band, of equal width in ln f.
const PER_BAND: usize = 8;
/// Components of the profile at least, per factor e of wavelength.
const COMPONENTS: f64 = 200.0;

/// Energy [m²/s² s] of the velocity, channels × bands.
#[derive(Clone, Debug)]
pub struct PassEnergy {
    /// Of the constant axle loads.
    pub quasi_static: Array2<f64>,
    /// Of the forces on a rough rail.
    pub dynamic: Array2<f64>,
    /// Of both.
    pub total: Array2<f64>,
}

/// One component of a random profile: Ω, ½ S dΩ/v² and the forces p_i it makes: they are smooth in Ω, however long the train.
#[derive(Clone, Debug)]
pub struct DrivingWave {
    /// Ω [rad/m]
    pub wavenumber: f64,
    weight: f64,
    /// S(Ω) [m²/(rad/m)]
    density: f64,
    forces: Vec<Complex64>,
}

impl DrivingWave {
    /// √ of the one-sided density [N/√Hz] of the force of the leading wheelset at f̃ = Ωv/2π: S_P = |p|² S dΩ/df̃, v = `speed` [m/s].
    pub fn force(&self, speed: f64) -> f64 {
        self.forces[0].norm() * (self.density * TAU / speed).sqrt()
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

impl PassEnergy {
    /// Of the axle loads alone: ∫ 2ω² |h|² |Σ P_i e^{−iωa_i/v}|²/v² df, |h|² of one `load`, sampled as finely as the phases turn.
    ///
    /// Accuracy: 1e-3 of the energy of bands that are not negligible beside the largest (test `cross_solver::passage`).
    pub fn quasi_static(pass: &Pass, load: &ConstantLoad) -> Self {
        let mut energies = Array2::zeros((pass.channels().len(), pass.bands.len()));
        for (b, band) in pass.bands.iter().enumerate() {
            let (from, to) = (band.lower(), band.upper());
            // fields of fast loads beat with the receiver's distance
            let turns = (to - from) * (pass.train.length() + pass.farthest()) / pass.speed;
            let samples = 16 + (8.0 * turns).ceil() as usize;
            let width = (to - from) / samples as f64;
            let rows: Vec<Vec<f64>> = (0..samples)
                .into_par_iter()
                .map(|s| {
                    let f = from + width * (s as f64 + 0.5);
                    let phases = pass.phases(TAU * f);
                    let loads: Complex64 =
                        pass.train.axles().iter().zip(phases).map(|(a, phase)| a.load * phase).sum();
                    let scale = 2.0 * (TAU * f / pass.speed).powi(2) * loads.norm_sqr() * width;
                    load.squares(pass, f).iter().map(|h| scale * h).collect()
                })
                .collect();
            for (r, slot) in energies.column_mut(b).iter_mut().enumerate() {
                *slot = rows.iter().map(|row| row[r]).sum();
            }
        }
        Self { dynamic: Array2::zeros(energies.raw_dim()), total: energies.clone(), quasi_static: energies }
    }

    /// Adds the expected energy of the random profiles with these `waves`, cell by cell, the passage of the wheels averaged over
    /// each.
    ///
    /// Accuracy: 1 % of each band (test `cross_solver::free_field`).
    ///
    /// # Errors
    /// Told to stop.
    pub fn add_expected(
        &mut self,
        pass: &Pass,
        sections: &Sections,
        waves: &[DrivingWave],
        observer: &dyn Observer,
    ) -> Result<(), Cancelled> {
        let count = pass.bands.len() * PER_BAND;
        observer.begin("bands", count as u64);
        let cells: Vec<Vec<f64>> = (0..count)
            .into_par_iter()
            .map(|i| {
                let band = pass.bands[i / PER_BAND];
                let ratio = (band.upper() / band.lower()).ln() / PER_BAND as f64;
                let from = band.lower() * (ratio * (i % PER_BAND) as f64).exp();
                let (f, width) = (from * (0.5 * ratio).exp(), from * (ratio.exp() - 1.0));
                let omega = TAU * f;
                let (ground, shift) = (sections.at(omega).tables(), omega / pass.speed);
                let rows = Rows::new(pass.train.axles(), pass.speed, (f, width));
                let mut energy = vec![0.0; pass.channels().len()];
                let arrives = |wave: &&DrivingWave| (wave.wavenumber - shift).abs() <= ground.reach();
                let heard: Vec<&DrivingWave> = waves.iter().filter(arrives).collect();
                // p(−Ω) = conj p(Ω)
                let means: Vec<(f64, f64)> = heard.iter().map(|wave| rows.means(&wave.forces)).collect();
                for (r, slot) in energy.iter_mut().enumerate() {
                    let near = ground.transfers(r, heard.iter().map(|wave| wave.wavenumber - shift));
                    let far = ground.transfers(r, heard.iter().map(|wave| -wave.wavenumber - shift));
                    for (((wave, (up, down)), near), far) in heard.iter().zip(&means).zip(near).zip(far) {
                        let squares = up * near.norm_sqr() + down * far.norm_sqr();
                        *slot += 2.0 * omega * omega * width * wave.weight * squares;
                    }
                }
                observer.done()?;
                Ok(energy)
            })
            .collect::<Result<_, _>>()?;
        observer.end();
        for (i, energy) in cells.iter().enumerate() {
            for (r, e) in energy.iter().enumerate() {
                self.dynamic[(r, i / PER_BAND)] += e;
            }
        }
        // without a phase between them, the parts add in the mean
        self.total = &self.quasi_static + &self.dynamic;
        Ok(())
    }

    /// Sets the energy of one profile from histories [m/s], channels × times: its own without the quasi-static part, and all of it.
    ///
    /// # Errors
    /// Velocities that are not numbers; bands beyond the samples.
    pub fn add_given(
        &mut self,
        pass: &Pass,
        total: &Array2<f64>,
        quasi_static: &Array2<f64>,
        times: Times,
    ) -> Result<(), AssessmentError> {
        let bands = |velocity: &Array2<f64>, energies: &mut Array2<f64>| -> Result<(), AssessmentError> {
            for (row, mut energies) in velocity.rows().into_iter().zip(energies.rows_mut()) {
                let spectrum = EnergySpectrum::of(&History::new(times.step, row.to_vec())?);
                for (band, slot) in pass.bands.iter().zip(&mut energies) {
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

    /// r.m.s. velocities [m/s] over `passage_time` T [s], √(E/T): quasi-static, dynamic, total.
    ///
    /// # Errors
    /// A passage time that is not positive.
    pub fn velocities(&self, passage_time: f64) -> Result<[Array2<f64>; 3], AssessmentError> {
        let velocity = |energies: &Array2<f64>| {
            let mut v = energies.clone();
            for slot in &mut v {
                *slot = rms(*slot, passage_time)?;
            }
            Ok::<_, AssessmentError>(v)
        };
        Ok([velocity(&self.quasi_static)?, velocity(&self.dynamic)?, velocity(&self.total)?])
    }
}

impl Pass<'_> {
    /// Components of `spectrum` between `wavelengths` (shortest, longest) [m], in equal steps of ln Ω, with the `forces` p(Ω) [N/m] of
    /// all wheels that feel one another up to `coupled` [m] apart, on the ground of `profile`.
    pub fn waves(
        &self,
        spectrum: &Spectrum,
        wavelengths: (f64, f64),
        forces: &(dyn Fn(f64) -> Vec<Complex64> + Sync),
        coupled: f64,
        profile: &Profile,
    ) -> Vec<DrivingWave> {
        let (low, high) = ((TAU / wavelengths.1).ln(), (TAU / wavelengths.0).ln());
        // fine enough for the phases between wheels that feel one another
        let phase = high.exp() * self.train.length().clamp(1.0, coupled) / (0.25 * TAU);
        // slow wheels: waves of all phase speeds meet within Ω (1 ± v/c), where a branch point is blurred by damping alone
        let fastest = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
        let least = profile.materials().map(|m| m.loss_factor()).fold(1.0, f64::min);
        let narrow = least.max(1e-3).recip().max(20.0) * fastest / self.speed;
        let count = ((high - low) * COMPONENTS.max(phase).max(narrow)).ceil() as usize;
        let width = (high - low) / count as f64;
        (0..count)
            .into_par_iter()
            .map(|j| {
                let wavenumber = (low + width * (j as f64 + 0.5)).exp();
                let density = spectrum.one_sided(wavenumber);
                DrivingWave {
                    wavenumber,
                    weight: 0.5 * density * wavenumber * width / self.speed.powi(2),
                    density,
                    forces: forces(wavenumber),
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
