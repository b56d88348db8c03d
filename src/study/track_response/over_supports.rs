//! How does the rail at a place move while a train passes over supports?

use super::TrackResponse;
use crate::progress::Observer;
use crate::rail::periodic::{DiracComb, Passage};
use crate::rail::{Drive, Method, Moving};
use crate::railway::{Railway, RailwayError};
use crate::study::{StudyError, Verified};
use crate::track::Layout;
use crate::vehicle::Train;
use ndarray::{Array2, Array3};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Orders of the harmonics under a load that are told.
const ORDERS: i32 = 8;
/// How far before the leading axle and behind the last one a history begins and ends [m].
const REACH: f64 = 10.0;
/// Between samples of a history the train runs so far [m].
const STEP: f64 = 0.02;

/// Histories of the rail, harmonics under the load, spectra.
#[derive(Clone, Debug)]
pub struct OverSupports {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// Where the rail is watched [m] from a support.
    pub at: Vec<f64>,
    /// How far the leading axle is past the place [m].
    pub distance: Vec<f64>,
    /// Of the rail under the whole train [m], positive down; speeds × at × distance.
    pub rail: Array3<f64>,
    /// j of the harmonics under a unit load.
    pub orders: Vec<i32>,
    /// W_j [m/N], speeds × orders: u(vt, t) = e^{iω̃t} Σ_j W_j e^{2πijvt/L}.
    pub harmonics: Array2<Complex64>,
    /// f [Hz] of the spectra; may be empty.
    pub frequencies: Vec<f64>,
    /// |û| [m s] of the rail under the leading axle, speeds × at × frequencies.
    pub spectra: Array3<f64>,
    /// f̃ [Hz] of the loads; 0 where they are constant.
    pub harmonic: f64,
    /// L [m]
    pub spacing: f64,
    /// Error of the histories over their largest deflection, where it is largest.
    pub error: f64,
    /// What another method says to the rail under and beside a unit load.
    pub verified: Option<Verified>,
}

impl TrackResponse {
    /// Speeds that have no answer over supports: 0, and those of the rail's shear waves and above.
    pub(in crate::study) fn speeds_lack(&self, railway: &Railway) -> Option<RailwayError> {
        let Layout::Discrete(supports) = railway.layout() else { return None };
        if self.speeds.contains(&0.0) {
            return Some(RailwayError::AtRest);
        }
        let comb = railway.foundation().ok().and_then(|on| DiracComb::new(supports, on).ok())?;
        let omega = TAU * self.harmonic.unwrap_or(0.0);
        let fault = |speed: &f64| comb.spectrum(Drive { omega, speed: *speed }, 0.0, omega + TAU).err();
        self.speeds.iter().find_map(fault).map(RailwayError::from)
    }

    /// Histories of the rail at places of the bay, constant axle loads or such that oscillate, P cos ω̃t.
    ///
    /// Accuracy: 1e-8 of the largest deflection for Euler–Bernoulli rails on viscous supports (test `analytic::periodic_moving`).
    ///
    /// # Errors
    /// No train, a load at rest or faster than the rail's shear waves, ground that joins the supports.
    pub fn over_supports(
        &self,
        railway: &Railway,
        observer: &dyn Observer,
    ) -> Result<OverSupports, StudyError> {
        let Layout::Discrete(supports) = railway.layout() else { return Err(RailwayError::Apart.into()) };
        let train = railway.train()?;
        let comb = DiracComb::new(supports, railway.foundation()?)?;
        let spacing = supports.spacing;
        let at = if self.at.is_empty() { vec![0.0, 0.5 * spacing] } else { self.at.clone() };
        let (behind, ahead) = self.x.unwrap_or((-(train.length() + REACH), REACH));
        let step = self.spacing.unwrap_or(STEP);
        let count = ((ahead - behind) / step + 1e-9).floor() as usize + 1;
        // x′ = at − vt from `ahead` down to `behind`
        let distance: Vec<f64> = (0..count).map(|i| -ahead + step * i as f64).collect();
        observer.begin("track response", self.speeds.len() as u64);
        let one = |speed: &f64| -> Result<_, StudyError> {
            let drive = Drive { omega: TAU * self.harmonic.unwrap_or(0.0), speed: *speed };
            let reach = ahead.abs().max(behind.abs()) + train.length() + spacing;
            let histories = at.iter().map(|x| {
                let passage = comb.passage(drive, *x, reach)?;
                let rail = under_train(&passage, train, drive, (x - ahead, step, count));
                Ok((rail, passage.error))
            });
            let histories = histories.collect::<Result<Vec<_>, StudyError>>()?;
            let orders: Vec<i32> = (-ORDERS..=ORDERS).collect();
            let harmonics = comb.harmonics(drive, &orders)?;
            let spectra = self.spectra(&comb, drive, &at, train)?;
            observer.done()?;
            Ok((histories, harmonics, spectra))
        };
        let rows = self.speeds.par_iter().map(one).collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let total: f64 = train.axles().iter().map(|axle| axle.load.abs()).sum();
        let worst = rows.iter().flat_map(|row| &row.0).map(|(rail, error)| {
            let largest = rail.iter().fold(0.0f64, |m, u| m.max(u.abs()));
            error * total / largest
        });
        let shape = (self.speeds.len(), at.len());
        Ok(OverSupports {
            speeds: self.speeds.clone(),
            rail: Array3::from_shape_fn((shape.0, shape.1, count), |(v, x, i)| rows[v].0[x].0[i]),
            orders: (-ORDERS..=ORDERS).collect(),
            harmonics: Array2::from_shape_fn((shape.0, 2 * ORDERS as usize + 1), |(v, j)| rows[v].1[j].value),
            spectra: Array3::from_shape_fn((shape.0, shape.1, self.frequencies.len()), |(v, x, f)| {
                rows[v].2[x][f]
            }),
            frequencies: self.frequencies.clone(),
            harmonic: self.harmonic.unwrap_or(0.0),
            spacing,
            error: worst.fold(0.0, f64::max),
            verified: self.verify.map(|method| Verified::new(method, self.verified(&comb, railway, method))),
            at,
            distance,
        })
    }

    /// The rail under a unit load and 1 m behind it, at four places of the bay, by another `method`.
    fn verified(&self, comb: &DiracComb, railway: &Railway, method: Method) -> Result<f64, StudyError> {
        let moving = railway.moving(method)?;
        let (mut largest, mut gap) = (0.0f64, 0.0f64);
        for (speed, quarter) in
            self.speeds.iter().flat_map(|speed| [0.0, 0.25, 0.5, 0.75].map(|q| (speed, q)))
        {
            let drive = Drive { omega: TAU * self.harmonic.unwrap_or(0.0), speed: *speed };
            let (phase, x) = (quarter * comb.cell().spacing(), [0.0, -1.0]);
            for (one, other) in comb.under(drive, phase, &x)?.iter().zip(moving.under(drive, phase, &x)?) {
                (largest, gap) = (largest.max(one.value.norm()), gap.max((one.value - other.value).norm()));
            }
        }
        Ok(gap / largest)
    }

    /// |û(x, ω)| [m s] under the leading axle.
    fn spectra(
        &self,
        comb: &DiracComb,
        drive: Drive,
        at: &[f64],
        train: &Train,
    ) -> Result<Vec<Vec<f64>>, StudyError> {
        let load = train.axles()[0].load;
        let one = |x: f64, f: f64| Ok(load * comb.spectrum(drive, x, TAU * f)?.norm());
        at.iter().map(|x| self.frequencies.iter().map(|f| one(*x, *f)).collect()).collect()
    }
}

/// u(t) [m] under all axles at `count` times, at which the leading axle is `from` [m] past the support x = 0, then `step` [m] farther.
///
/// Σ P_j Re[e^{iω̃τ_j} u₁(t − τ_j)], τ_j = a_j/v: all loads oscillate together.
fn under_train(
    passage: &Passage,
    train: &Train,
    drive: Drive,
    (from, step, count): (f64, f64, usize),
) -> Vec<f64> {
    let mut rail = vec![0.0; count];
    let lead = train.axles()[0].position;
    for axle in train.axles() {
        let late = (axle.position - lead) / drive.speed;
        let start = from / drive.speed - late;
        if drive.omega == 0.0 || late == 0.0 {
            let history = passage.history(start, step / drive.speed, count);
            rail.iter_mut().zip(history).for_each(|(sum, u)| *sum += axle.load * u);
            continue;
        }
        let turn = Complex64::cis(drive.omega * late);
        for (i, sum) in rail.iter_mut().enumerate() {
            *sum += axle.load * (turn * passage.at(start + step * i as f64 / drive.speed)).re;
        }
    }
    rail
}

impl OverSupports {
    /// v/L [Hz] at the speed in `row`.
    pub fn passing_frequency(&self, row: usize) -> f64 {
        self.speeds[row] / self.spacing
    }
}
