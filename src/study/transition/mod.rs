//! What does a change of track do to waves along the rail, and to its receptance?

mod shown;

use super::{Outcome, StudyError, Verified};
use crate::math::decimal::arithmetic;
use crate::progress::Observer;
use crate::rail::periodic::Coupled;
use crate::rail::{Answer, Method, Receptance};
use crate::railway::{Railway, RailwayError};
use crate::track::{Layout, Stack};
use ndarray::Array2;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Waves at the changes between sections of track.
#[derive(Clone, Debug, PartialEq)]
pub struct Transition {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// f [Hz] at which the receptance is wanted along the rail; may be empty.
    pub along: Vec<f64>,
    /// Where the force of these receptances stands [m] from the first change.
    pub from: f64,
    /// From, to [m] from the first change.
    pub x: (f64, f64),
    /// Spacing of x [m].
    pub spacing: f64,
    /// How the rail is asked: by coupled sections, or None.
    pub method: Option<Method>,
    /// Another method for the receptances along the rail, to be compared.
    pub verify: Option<Method>,
}

/// What waves and receptances do at the changes.
#[derive(Clone, Debug)]
pub struct Scattered {
    /// f [Hz]
    pub frequencies: Vec<f64>,
    /// Share of the power of the wave that comes along the first section and decays least, in all waves that return; NaN where that wave
    /// carries none.
    pub reflected: Vec<f64>,
    /// The same, in all waves along the last section.
    pub transmitted: Vec<f64>,
    /// Decay of that wave along the first section [dB per bay].
    pub decay: Vec<f64>,
    /// Where the sections change [m].
    pub changes: Vec<f64>,
    /// f [Hz] of the receptances along the rail.
    pub along: Vec<f64>,
    /// Where the force stands [m].
    pub from: f64,
    /// x [m]
    pub x: Vec<f64>,
    /// α(x, from) [m/N], along × x.
    pub rail: Array2<Complex64>,
    /// What another method says to it.
    pub verified: Option<Verified>,
}

impl Transition {
    /// Reflected and transmitted power of the wave that comes along the first section, and receptances.
    ///
    /// Accuracy: 1e-10 (test `analytic::transition`).
    ///
    /// # Errors
    /// A track of one section; ground or links that join the supports.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<Scattered, StudyError> {
        let Layout::Varying(sections) = railway.layout() else { return Err(RailwayError::OneSection.into()) };
        let coupled = Coupled::new(sections, railway.foundation()?).map_err(RailwayError::from)?;
        let first = &sections[0].supports;
        let keeps = |stack: &Stack| *stack == stack.undamped();
        let lossless =
            !first.rail.loses() && keeps(&first.under) && railway.springs().is_ok_and(|s| keeps(s.stack()));
        observer.begin("transition", (self.frequencies.len() + self.along.len()) as u64);
        let powers = self.frequencies.par_iter().map(|frequency| -> Result<_, StudyError> {
            let wave = coupled.scattering(TAU * frequency, 0, true)?;
            observer.done()?;
            // without loss a wave that decays carries nothing, and rounding divided by rounding is no share
            let carries = !lossless || (wave.lambda.norm() - 1.0).abs() < 1e-9;
            let share = |powers: [f64; 2]| if carries { powers.iter().sum::<f64>() } else { f64::NAN };
            let decay = -20.0 * wave.lambda.norm().log10();
            Ok((share(wave.reflected_power), share(wave.transmitted_power), decay))
        });
        let powers = powers.collect::<Result<Vec<_>, _>>()?;
        let (from, to) = self.x;
        let x = arithmetic(from, self.spacing, ((to - from) / self.spacing + 1e-9).floor() as usize + 1);
        let receptances = self.along.par_iter().map(|frequency| -> Result<_, StudyError> {
            let answers = coupled.at(&x, self.from, TAU * frequency)?;
            observer.done()?;
            Ok(answers)
        });
        let receptances = receptances.collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let verified =
            self.verify.map(|method| Verified::new(method, self.verified(&receptances, &x, railway, method)));
        let mut changes = vec![0.0];
        for section in &sections[1..sections.len() - 1] {
            let length = section.bays.unwrap_or(0) as f64 * section.supports.spacing;
            changes.push(changes[changes.len() - 1] + length);
        }
        Ok(Scattered {
            frequencies: self.frequencies.clone(),
            reflected: powers.iter().map(|p| p.0).collect(),
            transmitted: powers.iter().map(|p| p.1).collect(),
            decay: powers.iter().map(|p| p.2).collect(),
            changes,
            along: self.along.clone(),
            from: self.from,
            rail: Array2::from_shape_fn((receptances.len(), x.len()), |(f, i)| receptances[f][i].value),
            x,
            verified,
        })
    }

    /// The receptances along the rail by another `method`, relative to the largest at each frequency.
    fn verified(
        &self,
        receptances: &[Vec<Answer>],
        x: &[f64],
        railway: &Railway,
        method: Method,
    ) -> Result<f64, StudyError> {
        let other = railway.receptance(method)?;
        let mut difference = 0.0f64;
        for (frequency, one) in self.along.iter().zip(receptances) {
            let two = other.at(x, self.from, TAU * frequency)?;
            let largest = one.iter().map(|a| a.value.norm()).fold(0.0, f64::max);
            let gap = one.iter().zip(&two).map(|(a, b)| (a.value - b.value).norm()).fold(0.0, f64::max);
            difference = difference.max(gap / largest);
        }
        Ok(difference)
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown())
    }
}
