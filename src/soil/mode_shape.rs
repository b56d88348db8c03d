//! How the ground moves over depth in a wave that travels by itself, and how its surface turns.
//!
//! Beside a pole the response to any load is the mode: the undamped ground is asked at k(1 + ε) for loads at the interface where it
//! answers loudest, so that modes caught between deep layers are found as well as those of the surface.

use super::chain::displacements;
use super::dispersion::SurfaceWave;
use super::layer_stiffness::LayerStiffness;
use super::wave::Wave;
use super::{Base, Profile, SoilError};
use nalgebra::SMatrix;
use num_complex::Complex64;

/// How far beside the pole, relative.
const BESIDE: f64 = 1e-9;

/// Motion over depth, of the largest value 1: u_x = i `along` e^{i(ωt + kx)}, u_z = `down` e^{…}; of Love waves u_y = `across` e^{…}.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeShape {
    /// Along the direction of travel, a quarter of a period apart from `down`.
    pub along: Vec<f64>,
    /// Downward.
    pub down: Vec<f64>,
    /// Across the direction of travel (Love).
    pub across: Vec<f64>,
}

/// Responses at all interfaces to the loads at the interface that answers loudest.
fn loudest<const N: usize>(
    layers: &[LayerStiffness<N>],
    base: Option<SMatrix<Complex64, N, N>>,
) -> Vec<SMatrix<Complex64, N, N>> {
    let all = (0..=layers.len()).map(|source| (source, displacements(layers, base, source)));
    let size = |(source, u): &(usize, Vec<SMatrix<Complex64, N, N>>)| u[*source].norm();
    all.max_by(|a, b| size(a).total_cmp(&size(b))).map(|best| best.1).unwrap_or_default()
}

/// The shape at `depths` [m] of the mode of the undamped `profile` with wavenumber `k` [rad/m] at `omega` > 0 [rad/s].
///
/// Accuracy: 1e-7 (tests `analytic::dispersion`, and of the ellipticity against disba, `papers::dispersion`).
///
/// # Errors
/// A depth outside the ground.
pub fn mode_shape(
    profile: &Profile,
    wave: SurfaceWave,
    omega: f64,
    k: f64,
    depths: &[f64],
) -> Result<ModeShape, SoilError> {
    let (split, interfaces) = profile.with_loss_times(0.0).split_at(depths)?;
    let waves: Vec<_> = split.layers().iter().map(|l| (Wave::new(&l.material, omega), l.thickness)).collect();
    let base = match split.base() {
        Base::HalfSpace(material) => Some(Wave::new(&material, omega)),
        Base::Rigid => None,
    };
    let k = k * (1.0 + BESIDE);
    let column = |values: Vec<f64>, largest: f64| -> Vec<f64> {
        interfaces.iter().map(|i| values[*i] / largest).collect()
    };
    Ok(match wave {
        SurfaceWave::Rayleigh => {
            let layers: Vec<_> = waves.iter().map(|(w, h)| LayerStiffness::<2>::layer(w, *h, k)).collect();
            let u = loudest(&layers, base.map(|w| LayerStiffness::<2>::half_space(&w, k)));
            let size = |load: usize| u.iter().map(|u| u.column(load).norm()).fold(0.0, f64::max);
            let load = usize::from(size(1) > size(0));
            let (along, down): (Vec<f64>, Vec<f64>) =
                u.iter().map(|u| (u[(0, load)].re, u[(1, load)].re)).unzip();
            let largest = along.iter().chain(&down).fold(0.0f64, |m, v| m.max(v.abs()));
            // the surface moves down first
            let largest = if down[0] < 0.0 { -largest } else { largest };
            ModeShape { along: column(along, largest), down: column(down, largest), across: Vec::new() }
        }
        SurfaceWave::Love => {
            let layers: Vec<_> = waves.iter().map(|(w, h)| LayerStiffness::<1>::layer(w, *h, k)).collect();
            let u = loudest(&layers, base.map(|w| LayerStiffness::<1>::half_space(&w, k)));
            let across: Vec<f64> = u.iter().map(|u| u[0].re).collect();
            let largest = across.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let largest = if across[0] < 0.0 { -largest } else { largest };
            ModeShape { across: column(across, largest), along: Vec::new(), down: Vec::new() }
        }
    })
}

/// Ellipticity H/V of the surface in a Rayleigh mode: the horizontal over the vertical axis, positive where the particles turn
/// backward at the crest (retrograde), as they do on a half-space, negative where they roll forward.
///
/// # Errors
/// None at depth 0; as [`mode_shape`].
pub fn ellipticity(profile: &Profile, omega: f64, k: f64) -> Result<f64, SoilError> {
    let ModeShape { along, down, .. } = mode_shape(profile, SurfaceWave::Rayleigh, omega, k, &[0.0])?;
    Ok(along[0] / down[0])
}
