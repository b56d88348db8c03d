//! All that wheels roll over: what lies in the rail, and what turns with each wheel.

use super::pieces::Pieces;
use super::{Defect, Realisation};

/// A profile r(x), positive down.
#[derive(Clone, Debug, PartialEq)]
pub enum Profile {
    /// A sum of sinusoids.
    Waves(Realisation),
    /// A formula.
    Defect(Defect),
}

impl From<Realisation> for Profile {
    fn from(waves: Realisation) -> Self {
        Self::Waves(waves)
    }
}

impl From<Defect> for Profile {
    fn from(defect: Defect) -> Self {
        Self::Defect(defect)
    }
}

/// Components from which on a sum is worth polynomials.
const MANY: usize = 24;

/// A profile whose x = 0 lies at a place on the rail.
#[derive(Clone, Debug, PartialEq)]
struct Placed {
    profile: Profile,
    /// [m]
    at: f64,
    /// The profile where it was prepared, from its own x = 0.
    pieces: Option<Pieces>,
}

impl Placed {
    fn new(profile: Profile, at: f64) -> Self {
        Self { profile, at, pieces: None }
    }

    fn under(&self, x: f64) -> f64 {
        let x = x - self.at;
        match &self.profile {
            Profile::Waves(waves) => {
                self.pieces.as_ref().and_then(|pieces| pieces.at(x)).unwrap_or_else(|| waves.at(x))
            }
            Profile::Defect(defect) => defect.at(x),
        }
    }

    fn prepare(&mut self, (from, to): (f64, f64)) {
        if let Profile::Waves(waves) = &self.profile
            && waves.components().len() >= MANY
        {
            self.pieces = Some(Pieces::new(waves, (from - self.at, to - self.at)));
        }
    }
}

/// Profiles of a rail and of the wheels on it; empty, both are smooth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unevenness {
    rail: Vec<Placed>,
    /// By wheel.
    wheels: Vec<Vec<Placed>>,
}

impl Unevenness {
    /// The same with a `profile` in the rail, its x = 0 `at` [m]: every wheel comes to it in turn.
    #[must_use]
    pub fn in_rail(mut self, profile: impl Into<Profile>, at: f64) -> Self {
        self.rail.push(Placed::new(profile.into(), at));
        self
    }

    /// The same with a `profile` that turns with one `wheel`, counted from 0, which comes to its x = 0 `at` [m] on the rail.
    #[must_use]
    pub fn on_wheel(mut self, wheel: usize, profile: impl Into<Profile>, at: f64) -> Self {
        if self.wheels.len() <= wheel {
            self.wheels.resize(wheel + 1, Vec::new());
        }
        self.wheels[wheel].push(Placed::new(profile.into(), at));
        self
    }

    /// The same, prepared for wheels that stand between two places [m]: sums of many sinusoids are then polynomials piece by piece, a
    /// hundred times as quick, and the same to 4e-13 of the sum of their amplitudes (test `tests::prepared_it_is_the_same`).
    #[must_use]
    pub fn between(mut self, from: f64, to: f64) -> Self {
        self.rail
            .iter_mut()
            .chain(self.wheels.iter_mut().flatten())
            .for_each(|placed| placed.prepare((from, to)));
        self
    }

    /// r [m, positive down] under `wheel` that stands at `x` [m] on the rail: the sum of all profiles.
    ///
    /// Accuracy: that of the formulas (tests of each); places are added without loss (test `tests::profiles_add`).
    pub fn under(&self, wheel: usize, x: f64) -> f64 {
        self.rail
            .iter()
            .chain(self.wheels.get(wheel).into_iter().flatten())
            .map(|placed| placed.under(x))
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::{FreshFlat, German, Ramp, Spectrum, sinusoidal};

    #[test]
    fn prepared_it_is_the_same() {
        let spectrum = Spectrum::German { quality: German::Low };
        let waves = Realisation::of(&spectrum, (1.0, 30.0), 200, 3).unwrap();
        let plain = Unevenness::default().in_rail(waves.clone(), 2.0).on_wheel(1, waves.clone(), -7.0);
        let prepared = plain.clone().between(0.0, 20.0);
        let size: f64 = waves.components().iter().map(|c| c.amplitude).sum();
        // inside, measured 1e-14, and beyond, where it is the sum
        for (x, allowed) in [(3.3, 2.0 * 1e-12 * size), (20.0, 2.0 * 1e-12 * size), (25.0, 0.0), (-1.0, 0.0)]
        {
            for wheel in [0, 1] {
                assert!((prepared.under(wheel, x) - plain.under(wheel, x)).abs() <= allowed);
            }
        }
    }

    #[test]
    fn profiles_add() {
        let wave = sinusoidal(1.5, 1e-3, 0.3).unwrap();
        let (ramp, flat) = (
            Defect::Ramp(Ramp::new(2e-3, 0.6).unwrap()),
            Defect::FreshFlat(FreshFlat::new(0.46, 0.05).unwrap()),
        );
        assert_eq!(Unevenness::default().under(3, 1.0), 0.0);
        let all =
            Unevenness::default().in_rail(wave.clone(), -2.0).in_rail(ramp, 10.0).on_wheel(1, flat, 10.2);
        let rail = |x: f64| wave.at(x + 2.0) + ramp.at(x - 10.0);
        for x in [3.0, 10.21, 10.5] {
            assert_eq!([0, 2].map(|wheel| all.under(wheel, x)), [rail(x); 2]);
            assert_eq!(all.under(1, x), rail(x) + flat.at(x - 10.2));
        }
        assert!(flat.of_wheel() && !ramp.of_wheel());
    }
}
