//! How much does a passing train shake the ground beside the track?
//!
//! Quasi-static part: the axle loads, constant and moving. Dynamic part: forces of the wheels on a rough rail, the expected value
//! over all profiles of a spectrum. Both as energy of a pass in exact base-10 third octaves,
//!
//! ```text
//! û_qs(ω) = (1/v) h(−ω/v, ω) Σ_i P_i e^{−iωa_i/v}
//! E|û_dyn(ω)|² = ∫ ½ S(Ω) ( |H(Ω)|² + |H(−Ω)|² )/v² dΩ,   H(±Ω) = h(β, ω) Σ_i P_i(±Ω) e^{iβa_i},  β = ±Ω − ω/v
//! v_rms = √( (1/π) ∫_band ω²|û|² dω / T )
//! ```

use super::{Contact, Model, Outcome, StudyError};
use crate::assessment::{Band, rms};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::foundation::LayeredSoil;
use crate::interaction::{COUPLED, ContactForces, Section, TrackOnFoundation, WheelRail, transfer};
use crate::irregularity::Spectrum;
use crate::math::interpolation::cubic_weights;
use crate::progress::Observer;
use crate::soil::Solver;
use crate::vehicle::{Axle, Multibody, Train};
use ndarray::{Array1, Array2};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Frequencies in a band at which the ground is asked.
const PER_BAND: usize = 4;
/// Components of the profile at least, per factor e of wavelength.
const COMPONENTS: f64 = 200.0;
/// Accuracy of G, and the wavenumbers thin layers must resolve [rad/m].
const GROUND_ACCURACY: f64 = 1e-4;
const K_MAX: f64 = 30.0;

/// The solver for integrals whose every point has its own ω: modes would serve one point each.
fn pointwise(solver: Solver) -> Solver {
    if solver.has_modes() { Solver::DirectStiffness } else { solver }
}

/// Wheels that follow a rough rail.
#[derive(Clone, Debug, PartialEq)]
pub struct Roughness {
    /// The whole train; its wheelsets stand where the axles of [`Train`] do, in their order.
    pub bodies: Multibody,
    /// k_H of each wheelset [N/m].
    pub contact: f64,
    /// S(Ω) of the profile.
    pub spectrum: Spectrum,
    /// Shortest and longest wavelength [m].
    pub wavelengths: (f64, f64),
}

/// Velocity of the ground's surface at some receivers during one pass.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeField {
    /// v [m/s]
    pub speed: f64,
    /// Distances from the centre line of the track [m], ascending.
    pub receivers: Vec<f64>,
    /// T [s], over which the energy of the pass is averaged; None: the train's length and twice the farthest receiver's distance,
    /// over v.
    pub passage_time: Option<f64>,
    /// Third-octave bands, one after another.
    pub bands: Vec<Band>,
    /// None: the quasi-static part alone.
    pub roughness: Option<Roughness>,
}

/// The ground at one frequency, for each receiver.
struct Density {
    /// |h(−ω/v, ω)|²
    along: Vec<f64>,
    /// One-sided energy density of the dynamic velocity, E 2ω²|û|² [m²/s² s/Hz].
    dynamic: Vec<f64>,
    converged: bool,
}

/// One component of the profile: Ω, ½ S dΩ/v² and the forces p_i = P_i e^{iΩa_i} it makes, each against the profile under its
/// wheel: they are smooth in Ω, however long the train.
pub(super) struct Component {
    pub(super) wavenumber: f64,
    weight: f64,
    pub(super) forces: Vec<Complex64>,
}

/// |Σ_i p_i e^{−iωa_i/v}|² averaged over a cell. Wheels on one profile pass a receiver one after the other with the same forces, so
/// this turns within v/length [Hz] for constant loads and for a rough rail alike.
struct Passage {
    /// Two wheels i > j and the mean of e^{−iω(a_i − a_j)/v}.
    pairs: Vec<(usize, usize, Complex64)>,
}

impl Passage {
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

impl FreeField {
    /// Frequency f [Hz] and width [Hz] of the cells of the bands, `PER_BAND` each of equal width in ln f.
    fn cells(&self) -> Vec<(f64, f64)> {
        let cell = |band: &Band, i: usize| {
            let ratio = (band.upper() / band.lower()).ln() / PER_BAND as f64;
            let (from, to) = (ratio * i as f64, ratio * (i + 1) as f64);
            (band.lower() * (0.5 * (from + to)).exp(), band.lower() * (to.exp() - from.exp()))
        };
        self.bands.iter().flat_map(|band| (0..PER_BAND).map(move |i| cell(band, i))).collect()
    }

    /// Components of the profile with the forces they make, and whether the rail's receptance met its accuracy.
    fn components(
        &self,
        roughness: &Roughness,
        model: &Model,
        train: &Train,
        observer: &dyn Observer,
    ) -> Result<(Vec<Component>, bool), StudyError> {
        let (profile, solver) = model.ground("free_field")?;
        let strip = model.contact().strip().ok_or(StudyError::PointLoad)?;
        // each β along ω̃ − βv has its own ω
        let soil = LayeredSoil::new(profile.clone(), pointwise(solver), strip)?;
        let track = TrackOnFoundation::new(model.stack(), &soil, 0.0);
        let bodies = &roughness.bodies;
        let contact = vec![roughness.contact; bodies.wheelset_count()];
        let wheels = WheelRail { track: &track, bodies, contact: &contact, speed: self.speed };

        let (shortest, longest) = roughness.wavelengths;
        let range = (TAU / longest, TAU / shortest);
        let forces = ContactForces::new(&wheels, range, observer)?;
        let (low, high) = (range.0.ln(), range.1.ln());
        // fine enough for the phases between wheels that feel one another
        let phase = high.exp() * train.length().clamp(1.0, COUPLED) / (0.25 * TAU);
        // slow wheels: waves of all phase speeds meet within Ω (1 ± v/c)
        let fastest = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
        let narrow = 20.0 * fastest / self.speed;
        let components = ((high - low) * COMPONENTS.max(phase).max(narrow)).ceil() as usize;
        let width = (high - low) / components as f64;
        let components = (0..components)
            .into_par_iter()
            .map(|j| {
                let wavenumber = (low + width * (j as f64 + 0.5)).exp();
                let density = roughness.spectrum.one_sided(wavenumber);
                Component {
                    wavenumber,
                    weight: 0.5 * density * wavenumber * width / self.speed.powi(2),
                    forces: forces.at(wavenumber),
                }
            })
            .collect();
        Ok((components, forces.converged))
    }

    /// Energy [m²/s² s] of the axle loads in band number `band` at receiver `r`: ∫ 2ω² |h|² |Σ P_i e^{−iωa_i/v}|²/v² df, ln |h|² by cubics
    /// in ln f between `cells`, sampled as finely as the phases turn.
    fn quasi_static(
        &self,
        (band, r): (usize, usize),
        densities: &[Density],
        cells: &[(f64, f64)],
        train: &Train,
    ) -> f64 {
        let (low, step) = (cells[0].0.ln(), (cells[1].0 / cells[0].0).ln());
        let at = |f: f64| {
            let place = (f.ln() - low) / step;
            let i = (place.floor() as isize).clamp(1, cells.len() as isize - 3) as usize;
            let weights = cubic_weights(place - i as f64);
            // of what is nothing there is no logarithm
            (0..4).map(|m| weights[m] * densities[i + m - 1].along[r].max(1e-300).ln()).sum::<f64>().exp()
        };
        let (from, to) = (self.bands[band].lower(), self.bands[band].upper());
        let turns = (to - from) * train.length() / self.speed;
        let samples = 16 + (8.0 * turns).ceil() as usize;
        let width = (to - from) / samples as f64;
        (0..samples)
            .map(|s| {
                let f = from + width * (s as f64 + 0.5);
                let loads: Complex64 = train
                    .axles()
                    .iter()
                    .map(|a| a.load * Complex64::cis(-TAU * f * a.position / self.speed))
                    .sum();
                2.0 * (TAU * f / self.speed).powi(2) * at(f) * loads.norm_sqr() * width
            })
            .sum()
    }

    /// The ground at frequency `cell.0` [Hz] and what the components do to it, the passage of the wheels averaged over the cell's width
    /// `cell.1` [Hz].
    fn density(
        &self,
        cell: (f64, f64),
        components: &[Component],
        model: &Model,
        train: &Train,
    ) -> Result<Density, StudyError> {
        let (profile, solver) = model.ground("free_field")?;
        let strip = model.contact().strip().ok_or(StudyError::PointLoad)?;
        let omega = TAU * cell.0;
        let ground = solver.prepare_many(profile, omega, K_MAX, GROUND_ACCURACY)?;
        let section = Section::new(model.stack(), ground.as_ref(), strip, omega, &self.receivers);
        let passage = Passage::new(train.axles(), self.speed, cell);
        let scale = 2.0 * omega * omega;
        let mut dynamic = vec![0.0; self.receivers.len()];
        let shift = omega / self.speed;
        for component in components {
            // P(−Ω) = conj P(Ω)
            let (up, down) = passage.means(&component.forces);
            for (r, slot) in dynamic.iter_mut().enumerate() {
                let near = section.transfer(r, component.wavenumber - shift).norm_sqr();
                let far = section.transfer(r, component.wavenumber + shift).norm_sqr();
                *slot += scale * component.weight * (up * near + down * far);
            }
        }
        // small beside the largest h where the axles are slower than the waves: not from the table
        let h = |y: f64| transfer(model.stack(), ground.as_ref(), strip, (shift, omega), y);
        let along: Vec<(Complex64, bool)> = self.receivers.iter().map(|&y| h(y)).collect();
        let converged = section.converged() && along.iter().all(|h| h.1);
        Ok(Density { along: along.iter().map(|h| h.0.norm_sqr()).collect(), dynamic, converged })
    }

    /// Third-octave r.m.s. velocities of the pass, quasi-static, dynamic and total.
    ///
    /// Accuracy: 1 % of each dynamic band, 1e-3 of the energy of quasi-static bands that are not negligible beside the largest (tests
    /// `cross_solver::free_field`, `cross_solver::passage`).
    ///
    /// # Errors
    /// No layered ground, no train, wheels that are not those of the train, a receiver on the track, undamped waves.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let train = self.train(model)?;
        let farthest = self.receivers.iter().copied().fold(0.0, f64::max);
        let passage_time = self.passage_time.unwrap_or((train.length() + 2.0 * farthest) / self.speed);
        let (components, accurate) = match &self.roughness {
            Some(roughness) => self.components(roughness, model, train, observer)?,
            None => (Vec::new(), true),
        };
        let cells = self.cells();
        observer.begin("free field", cells.len() as u64);
        let densities: Vec<Density> = cells
            .par_iter()
            .map(|cell| {
                let density = self.density(*cell, &components, model, train);
                observer.advance();
                density
            })
            .collect::<Result<_, _>>()?;
        observer.end();

        let shape = (self.receivers.len(), self.bands.len());
        let widths: Vec<f64> = cells.iter().map(|c| c.1).collect();
        let energies = [
            Array2::from_shape_fn(shape, |(r, b)| self.quasi_static((b, r), &densities, &cells, train)),
            Array2::from_shape_fn(shape, |(r, b)| {
                let cells = b * PER_BAND..(b + 1) * PER_BAND;
                cells.map(|i| densities[i].dynamic[r] * widths[i]).sum()
            }),
        ];
        let velocity = |energy: &Array2<f64>| {
            let mut v = energy.clone();
            for slot in &mut v {
                *slot = rms(*slot, passage_time)?;
            }
            Ok::<_, StudyError>(v)
        };
        let (quasi_static, dynamic) = (velocity(&energies[0])?, velocity(&energies[1])?);
        let total = velocity(&(&energies[0] + &energies[1]))?;

        let centres: Vec<f64> = self.bands.iter().map(|band| band.centre()).collect();
        let mut group = Group::new("free_field")
            .coordinate("receiver", &self.receivers, "m", "distance from the centre line of the track")
            .coordinate("band", &centres, "Hz", "exact centre of the base-10 third-octave band")
            .attribute("speed", self.speed)
            .attribute("passage_time", passage_time)
            .attribute("direction", "vertical, surface of the ground")
            .attribute("weighting", "none");
        let parts = [
            ("v_rms_quasi_static", &quasi_static, "quasi-static part (moving axle loads)"),
            ("v_rms_dynamic", &dynamic, "dynamic part (rough rail), expected value"),
            ("v_rms_total", &total, "both"),
        ];
        for (name, values, what) in parts {
            group = group.variable(
                name,
                &["receiver", "band"],
                values.clone().into_dyn(),
                "m s-1",
                &format!("r.m.s. velocity over the passage time: {what}"),
            );
        }
        let (time, histories) = self.histories(model, train, observer)?;
        group = group
            .coordinate("time", &time, "s", "time after the leading axle was abreast of the receivers")
            .variable(
                "v_quasi_static",
                &["receiver", "time"],
                histories.clone().into_dyn(),
                "m s-1",
                "velocity of the quasi-static part, positive down",
            );
        if let Some(roughness) = &self.roughness {
            let driving: Vec<f64> = components.iter().map(|c| c.wavenumber * self.speed / TAU).collect();
            // one-sided in f̃ = Ωv/2π: S_P = |P|² S dΩ/df̃
            let density: Vec<f64> = components
                .iter()
                .map(|c| {
                    c.forces[0].norm_sqr() * roughness.spectrum.one_sided(c.wavenumber) * TAU / self.speed
                })
                .collect();
            group = group
                .coordinate("driving_frequency", &driving, "Hz", "speed over wavelength of the profile")
                .variable(
                    "contact_force",
                    &["driving_frequency"],
                    Array1::from(density).into_dyn(),
                    "N2 Hz-1",
                    "one-sided spectral density of the dynamic force of the leading wheelset",
                )
                .attribute("irregularity", roughness.spectrum.text())
                .attribute("shortest_wavelength", roughness.wavelengths.0)
                .attribute("longest_wavelength", roughness.wavelengths.1)
                .attribute(
                    "band_rms",
                    roughness.spectrum.band_rms(roughness.wavelengths.0, roughness.wavelengths.1),
                );
        }
        let answers = self.answers(passage_time, &quasi_static, &dynamic, &total)?;
        let mut figures =
            self.figures(passage_time, &centres, [&quasi_static, &dynamic, &total], &components);
        figures.push(self.history_figure(&time, &histories));
        let mut concerns = self.concerns(model);
        if !accurate || densities.iter().any(|d| !d.converged) {
            concerns.push(Concern::new(
                "quadrature",
                "some wavenumber integrals of the free field missed their accuracy (1e-3)",
                "poles lie too close to the real axis (more damping helps), or the track spreads the load too little",
            ));
        }
        Ok(Outcome { group, figures, answers, concerns })
    }

    /// Velocity of the quasi-static part at the receivers, and its times.
    fn histories(
        &self,
        model: &Model,
        train: &Train,
        observer: &dyn Observer,
    ) -> Result<(Vec<f64>, Array2<f64>), StudyError> {
        let (profile, solver) = model.ground("free_field")?;
        let strip = model.contact().strip().ok_or(StudyError::PointLoad)?;
        let solver = pointwise(solver);
        let soil = LayeredSoil::new(profile.clone(), solver, strip)?;
        let track = TrackOnFoundation::new(model.stack(), &soil, 0.0);
        let farthest = self.receivers.iter().copied().fold(0.0, f64::max);
        // eight samples of the shortest period
        let highest = self.bands.iter().map(|band| band.upper()).fold(0.0, f64::max);
        let step = 1.0 / (8.0 * highest);
        let before = (4.0 * farthest / self.speed).max(0.5);
        let count = ((train.length() / self.speed + 2.0 * before) / step).ceil() as usize;
        let time: Vec<f64> = (0..count).map(|i| step * i as f64 - before).collect();
        let reach = self.speed * before + train.length();
        let lead = train.axles()[0].position;
        observer.begin("passage", self.receivers.len() as u64);
        let rows: Vec<Vec<f64>> = self
            .receivers
            .par_iter()
            .map(|&y| {
                let passage = track.passage((profile, solver), strip, self.speed, y, reach)?;
                let one = |t: f64| {
                    let part = |a: &Axle| a.load * passage.velocity(t - (a.position - lead) / self.speed);
                    train.axles().iter().map(part).sum()
                };
                observer.advance();
                Ok(time.par_iter().map(|t| one(*t)).collect())
            })
            .collect::<Result<_, StudyError>>()?;
        observer.end();
        Ok((time, Array2::from_shape_fn((rows.len(), count), |(r, i)| rows[r][i])))
    }

    /// The axles, which are those of the bodies.
    fn train<'a>(&self, model: &'a Model) -> Result<&'a Train, StudyError> {
        let train = model.train("free_field")?;
        let Some(roughness) = &self.roughness else { return Ok(train) };
        let (axles, wheels) = (train.axles(), roughness.bodies.axles());
        let apart = axles.iter().zip(wheels).any(|(a, w)| (a.position - w.position).abs() > 1e-6);
        if apart || axles.len() != wheels.len() {
            return Err(StudyError::OtherWheels { axles: axles.len(), wheelsets: wheels.len() });
        }
        Ok(train)
    }

    /// Refuses what cannot be answered before anything is computed.
    ///
    /// # Errors
    /// As `run`.
    pub fn check(&self, model: &Model) -> Result<(), StudyError> {
        model.ground("free_field")?;
        self.train(model)?;
        model.receivers(&self.receivers)?;
        if !matches!(model.contact(), Contact::Strip(_)) {
            return Err(StudyError::NeedsTrack { study: "free_field" });
        }
        // wheels shed waves of every phase speed
        model.check_damping(std::iter::once(f64::INFINITY))
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
        let (up, down) = Passage::new(&axles, speed, cell).means(&forces);
        // midpoint rule: measured below 1e-7
        assert!((up / mean(&forces) - 1.0).abs() < 1e-6, "{up} {}", mean(&forces));
        assert!((down / mean(&conjugates) - 1.0).abs() < 1e-6, "{down} {}", mean(&conjugates));
    }
}
