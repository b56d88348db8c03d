//! What the wheels of a free field roll over.

use super::StudyError;
use crate::field::Pass;
use crate::irregularity::{Realisation, Spectrum};
use crate::vehicle::Multibody;
use std::f64::consts::TAU;

/// What carries a given profile.
#[derive(Clone, Debug, PartialEq)]
pub enum Carrier {
    /// The rail: each wheel meets what the one before it met.
    Rail,
    /// Every wheel, turned by an angle of its own from this seed.
    Wheels {
        /// Of the angles.
        seed: u64,
    },
}

/// What the wheels roll over.
#[derive(Clone, Debug, PartialEq)]
pub enum Irregularity {
    /// All profiles of a spectrum, and some of them.
    Random {
        /// S(Ω)
        spectrum: Spectrum,
        /// Shortest and longest wavelength [m].
        wavelengths: (f64, f64),
        /// Seed of the first profile; the next ones count up.
        seed: u64,
        /// How many profiles; at least one.
        count: usize,
    },
    /// One profile. x = 0 of a rail is abreast of the receivers.
    Given {
        /// The profile.
        profile: Realisation,
        /// What it is, in one line.
        text: String,
        /// Of the rail, or of each wheel by itself.
        carrier: Carrier,
    },
}

impl Irregularity {
    /// What it is, in one line.
    pub fn text(&self) -> String {
        match self {
            Self::Random { spectrum, .. } => spectrum.text(),
            Self::Given { text, .. } => text.clone(),
        }
    }

    /// Smallest and largest wavenumber [rad/m].
    pub(in crate::study) fn wavenumbers(&self) -> (f64, f64) {
        match self {
            Self::Random { wavelengths, .. } => (TAU / wavelengths.1, TAU / wavelengths.0),
            Self::Given { profile, .. } => profile
                .components()
                .iter()
                .fold((f64::INFINITY, 0.0), |(low, high), c| (c.wavenumber.min(low), c.wavenumber.max(high))),
        }
    }

    /// Standard deviation [m].
    pub(super) fn rms(&self) -> f64 {
        match self {
            Self::Random { spectrum, wavelengths, .. } => spectrum.band_rms(wavelengths.0, wavelengths.1),
            Self::Given { profile, .. } => profile.rms(),
        }
    }

    /// The profiles to make histories of, their wavelengths from `shortest` [m] on. They have their wavenumbers in common, and do not
    /// repeat while the train passes for `period` [s].
    pub(super) fn profiles(
        &self,
        pass: &Pass,
        shortest: f64,
        period: f64,
    ) -> Result<Vec<Realisation>, StudyError> {
        match self {
            Self::Given { profile, .. } => Ok(vec![profile.between(shortest, f64::INFINITY)]),
            Self::Random { spectrum, wavelengths, seed, count } => {
                // eight components at least below twice the lowest wavenumber
                let way = pass.speed * period + pass.train.length();
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
}

/// Wheels that follow a rough rail.
#[derive(Clone, Debug, PartialEq)]
pub struct Roughness {
    /// The whole train; its wheelsets stand where the axles of [`Train`] do, in their order.
    pub bodies: Multibody,
    /// k_H of each wheelset [N/m].
    pub contact: Vec<f64>,
    /// The profile, or what is known of it.
    pub irregularity: Irregularity,
}
