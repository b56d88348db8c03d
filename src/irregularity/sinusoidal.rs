//! One sinusoid: corrugation, or the probe of a linear model.

use super::{Component, IrregularityError, Realisation};
use crate::quantity::{finite, positive};
use std::f64::consts::TAU;

/// r(x) = `amplitude` cos(2πx/`wavelength` + `phase`), amplitude and wavelength [m], phase [rad].
///
/// # Errors
/// An amplitude or wavelength that is not positive, a phase that is not finite.
pub fn sinusoidal(wavelength: f64, amplitude: f64, phase: f64) -> Result<Realisation, IrregularityError> {
    let wave = Component {
        wavenumber: TAU / positive("wavelength", wavelength, "m")?,
        amplitude: positive("amplitude", amplitude, "m")?,
        phase: finite("phase", phase, "rad")?,
    };
    Realisation::new(vec![wave], wavelength)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repeats_after_its_wavelength() {
        let r = sinusoidal(1.5, 1e-3, 0.3).unwrap();
        assert_eq!(r.repeat_length(), 1.5);
        assert_eq!(r.at(0.0), 1e-3 * 0.3f64.cos());
        // rounding of the argument
        assert!((r.at(0.7 + 1.5) - r.at(0.7)).abs() < 1e-17);
        assert!(sinusoidal(0.0, 1e-3, 0.0).is_err());
    }
}
