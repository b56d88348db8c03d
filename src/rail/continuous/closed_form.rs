//! The closed form: two waves of a beam on springs that are the same at every β.
//!
//! Source: Eqs (30)–(32), (90)–(93).

use super::uniform::Uniform;
use crate::rail::{Answer, BeamWaves, Drive, RailError, Receptance};

const NAME: &str = "closed-form";

/// A rail on springs, and masses on springs, that answers in closed form.
pub struct ClosedForm<'a>(pub(super) Uniform<'a>);

impl ClosedForm<'_> {
    /// The waves at `omega` [rad/s].
    pub(super) fn waves(&self, omega: f64) -> Result<BeamWaves, RailError> {
        let tower = self.0.tower(NAME)?;
        let support = tower.under_rail(omega).ok_or(RailError::Method {
            method: NAME,
            track: "layers that bend or shear under the rail",
            able: "residues, boundary-values, fourier, filon, adaptive",
        })?;
        Ok(BeamWaves::new(&tower.floors()[0][0], omega, support))
    }

    /// Refuses what is not such a track.
    ///
    /// # Errors
    /// `RailError::Method`.
    pub(super) fn known(self) -> Result<Self, RailError> {
        self.waves(1.0).map(|_| self)
    }
}

impl Receptance for ClosedForm<'_> {
    fn at(&self, x: &[f64], from: f64, omega: f64) -> Result<Vec<Answer>, RailError> {
        self.0.check(Drive { omega, speed: 0.0 })?;
        let waves = self.waves(omega)?;
        Ok(x.iter().map(|x| Answer::exact(waves.at(x - from))).collect())
    }

    fn period(&self) -> Option<f64> {
        Some(0.0)
    }
}
