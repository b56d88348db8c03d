//! Wheels that are not round.

use super::realisation::SplitMix64;
use super::{Component, IrregularityError, Realisation};
use crate::quantity::{finite, positive};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};

/// One harmonic of the radius of a wheel: amplitude · cos(order · angle + phase), positive outward.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Order {
    /// Waves around the wheel: 1 is eccentricity.
    pub order: u32,
    /// Of the radius [m].
    pub amplitude: f64,
    /// [rad], 0 by default.
    #[serde(default)]
    pub phase: f64,
}

/// The profile that acts like a wheel of `radius` R [m] with harmonics `orders`: wavelengths 2πR/order, r = −(deviation of
/// the radius), since a larger radius presses like a bump.
///
/// It belongs to one wheel: it does not come to the next wheel later, as the profile of a rail does. Linear contact; small
/// deviations (no flats).
///
/// # Errors
/// No order; order 0; a radius or amplitude that is not positive; a phase that is not finite.
pub fn out_of_round(radius: f64, orders: &[Order]) -> Result<Realisation, IrregularityError> {
    positive("radius", radius, "m")?;
    if orders.is_empty() {
        return Err(IrregularityError::NoComponent);
    }
    let component = |o: &Order| {
        if o.order == 0 {
            return Err(IrregularityError::Order { order: o.order });
        }
        Ok(Component {
            wavenumber: f64::from(o.order) / radius,
            amplitude: positive("amplitude", o.amplitude, "m")?,
            phase: finite("phase", o.phase, "rad")? + PI,
        })
    };
    Realisation::new(orders.iter().map(component).collect::<Result<_, _>>()?, TAU * radius)
}

/// Where on its profile of `length` [m] each of `count` wheels stands at x = 0 [m]: anywhere with equal likelihood, from `seed`
/// as the phases of [`Realisation::of`].
pub fn random_starts(count: usize, length: f64, seed: u64) -> Vec<f64> {
    let mut random = SplitMix64(seed);
    (0..count).map(|_| length * random.unit()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_eccentric_wheel_lifts_once_a_turn() {
        let order = |order, amplitude| Order { order, amplitude, phase: 0.0 };
        let r = out_of_round(0.46, &[order(1, 0.3e-3), order(3, 0.1e-3)]).unwrap();
        let turn = TAU * 0.46;
        assert_eq!(r.repeat_length(), turn);
        // largest radius at x = 0: a bump of 0.4 mm; half a turn on, a dip of it; rounding of the phases
        assert!((r.at(0.0) + 0.4e-3).abs() < 1e-18);
        assert!((r.at(turn / 2.0) - 0.4e-3).abs() < 1e-18);
        assert!((r.components()[1].wavelength() - turn / 3.0).abs() < 1e-15);
        assert_eq!(out_of_round(0.46, &[order(0, 1e-3)]).unwrap_err(), IrregularityError::Order { order: 0 });
        assert_eq!(out_of_round(0.46, &[]).unwrap_err(), IrregularityError::NoComponent);
    }
}
