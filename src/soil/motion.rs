//! Which way the ground's surface moves beside a strip that presses on it.
//!
//! ```text
//! u_z = (1/π) ∫₀^∞ G_zz sinc(qb) cos(qy) dq
//! u_x = iβ (1/π) ∫₀^∞ (g/k) sinc(qb) cos(qy) dq,   G_xz = i g,   k² = β² + q²
//! u_y = −(1/π) ∫₀^∞ (g/k) q sinc(qb) sin(qy) dq
//! ```
//!
//! of a unit force per metre e^{i(ωt + βx)}: the plane wave (β, q) carries the ground along itself, (β/k, q/k) G_xz.

use crate::math::complex::I;
use num_complex::Complex64;

/// A direction of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// u_z, down.
    Vertical,
    /// u_x, along the track in the direction of travel; odd in β.
    Along,
    /// u_y, across the track, away from it where y > 0.
    Across,
}

impl Motion {
    /// The three of them.
    pub const ALL: [Self; 3] = [Self::Vertical, Self::Along, Self::Across];

    /// Displacement of the `integral` (1/π) ∫₀^∞ … dq.
    pub(super) fn displacement(self, beta: f64, integral: Complex64) -> Complex64 {
        match self {
            Self::Vertical => integral,
            Self::Along => I * beta * integral,
            Self::Across => -integral,
        }
    }

    /// The displacement at −β from the one at β > 0.
    pub fn mirrored(self, displacement: Complex64) -> Complex64 {
        if self == Self::Along { -displacement } else { displacement }
    }
}
