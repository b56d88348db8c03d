//! Complex stiffnesses k*(ω) of what joins two degrees of freedom: springs and dashpots by their arrangement.

use crate::math::complex::sign;
use crate::quantity::{not_negative, positive};
use crate::track::TrackError;
use num_complex::Complex64;

/// A massless element, per metre of track or per support as what it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Element {
    /// Spring and dashpot abreast (Kelvin–Voigt), with hysteretic loss: k(1 + iη sgn ω) + iωc. Source: Eqs (19), (24).
    Spring {
        /// k [N/m²]
        stiffness: f64,
        /// c [N s/m²]
        damping: f64,
        /// η
        loss_factor: f64,
    },
}

impl Element {
    /// A spring of `stiffness` [N/m²], viscous `damping` [N s/m²] and `loss_factor`.
    ///
    /// # Errors
    /// A stiffness that is not positive, negative damping.
    pub fn spring(stiffness: f64, damping: f64, loss_factor: f64) -> Result<Self, TrackError> {
        Ok(Self::Spring {
            stiffness: positive("stiffness", stiffness, "N/m²")?,
            damping: not_negative("damping", damping, "N s/m²")?,
            loss_factor: not_negative("loss_factor", loss_factor, "")?,
        })
    }

    /// The same element without dissipation.
    pub fn undamped(self) -> Self {
        let Self::Spring { stiffness, .. } = self;
        Self::Spring { stiffness, damping: 0.0, loss_factor: 0.0 }
    }

    /// k*(ω) [N/m²] at `omega` [rad/s].
    #[inline]
    pub fn stiffness(&self, omega: f64) -> Complex64 {
        match *self {
            Self::Spring { stiffness, damping, loss_factor } => {
                Complex64::new(stiffness, stiffness * loss_factor * sign(omega) + omega * damping)
            }
        }
    }
}
