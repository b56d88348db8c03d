//! Layered ground: material → profile → compliance G(k, ω) in the wavenumber domain.
//!
//! | symbol | meaning |
//! |---|---|
//! | k | radial wavenumber √(β_x² + β_y²) [rad/m] |
//! | p, s | vertical wavenumbers √(k² − k_p²), √(k² − k_s²), Re ≥ 0 |
//! | γ | μ/(λ + 2μ) = (c_s/c_p)² |
//! | u_zz … | displacement per unit traction wave e^{i(ωt + kx)} [m/Pa], z down |
//!
//! The file is long because what a ground may be asked, who answers and why one cannot stand together.

pub mod at_depth;
mod batch;
mod beside;
mod chain;
mod compliance;
pub mod direct_stiffness;
pub mod dispersion;
mod evanescent;
pub mod flexibility;
pub mod half_space;
pub mod haskell;
mod layer_stiffness;
mod lifted;
mod material;
mod minors;
mod mode_count;
pub mod mode_shape;
mod motion;
pub mod off_axis;
mod pole_sum;
pub mod poles;
mod profile;
mod real_secular;
pub mod sampled;
pub mod strip;
pub mod thin_layer;
pub mod transfer_matrix;
pub(crate) mod wave;
pub mod wave_amplitudes;

pub use at_depth::AtDepth;
pub use beside::Receivers;
pub use compliance::{Compliance, SurfaceCompliance};
pub use direct_stiffness::DirectStiffness;
pub use flexibility::Flexibility;
pub use material::{Elastic, Material};
pub use motion::Motion;
pub use poles::Poles;
pub use profile::{Base, Layer, Profile};
pub use sampled::Sampled;
pub use strip::{Compatibility, Strip};
pub use thin_layer::ThinLayer;
pub use transfer_matrix::TransferMatrix;

use crate::math::complex::I;
use crate::math::quadrature::Estimate;
use crate::quantity::OutOfRange;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use thiserror::Error;

/// A way to compute the compliance of a profile: settings only.
pub trait GroundSolver: Send + Sync {
    /// Does all that depends on `omega` [rad/s] alone, for loads and receivers at `depths` [m] (may be empty: surface only).
    ///
    /// # Errors
    /// A depth outside the ground.
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError>;
}

/// A profile at one ω, ready for any wavenumber.
pub trait PreparedGround: Send + Sync {
    /// Surface compliances at radial wavenumber `k` ≥ 0 [rad/m]; k > 0 where ω = 0 and the base is a half-space.
    fn surface(&self, k: f64) -> SurfaceCompliance;

    /// Vertical displacement per vertical traction at the surface [m/Pa].
    fn u_zz(&self, k: f64) -> Complex64 {
        self.surface(k).u_zz
    }

    /// Compliances at every prepared depth for a load at depth number `source`.
    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance>;

    /// Surface compliances of many wavenumbers.
    fn batch(&self, k: &[f64]) -> Vec<SurfaceCompliance> {
        k.iter().map(|&k| self.surface(k)).collect()
    }

    /// u_xz of many wavenumbers.
    fn u_xz_many(&self, k: &[f64]) -> Vec<Complex64> {
        k.iter().map(|&k| self.surface(k).u_xz).collect()
    }

    /// [`u_zz`](Self::u_zz) of many wavenumbers.
    fn u_zz_many(&self, k: &[f64]) -> Vec<Complex64> {
        k.iter().map(|&k| self.u_zz(k)).collect()
    }

    /// What the strip integral must know of the ground besides G: its static tail and where G changes.
    fn outline(&self) -> &strip::Outline;

    /// 1/k_eq(β, ω) [m²/N] of a loaded strip, by quadrature unless the solver knows better.
    fn strip(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        strip::quadrature(&|k| self.u_zz_many(k), self.outline(), beta, strip, relative)
    }

    /// Whether [`strip_lifted`](Self::strip_lifted) may be asked under `strip` at this ω, and is another way.
    fn lifts(&self, _strip: Strip) -> bool {
        false
    }

    /// As [`strip`](Self::strip) on a path lifted off the poles, a fifth of the evaluations: right where [`lifts`](Self::lifts).
    fn strip_lifted(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        self.strip(beta, strip, relative)
    }

    /// What answers for motions at distances [m] beyond a strip of `half_width` [m] to a `relative` accuracy of its
    /// largest value on such a path, at any β; None where it may not be taken at this ω or is not another way.
    fn receivers_lifted(
        &self,
        _half_width: f64,
        _receivers: &[(f64, Motion)],
        _relative: f64,
    ) -> Option<Receivers<'_>> {
        None
    }

    /// Displacement [m²/N] at distance `y` [m] from the centre line of a strip of `half_width` [m] under a unit force per
    /// metre; a line load where `half_width` is zero. By quadrature unless the solver knows better.
    fn receiver(&self, beta: f64, half_width: f64, y: f64, relative: f64) -> Estimate {
        strip::receiver_quadrature(&|k| self.u_zz_many(k), self.outline(), beta, half_width, y, relative)
    }

    /// Displacement [m²/N] of a motion at a distance [m] beyond such a strip where `beta` is slower than every wave; None where it is not, or
    /// the solver knows no better way than the others.
    fn evanescent(
        &self,
        _beta: f64,
        _half_width: f64,
        _receiver: (f64, Motion),
        _relative: f64,
    ) -> Option<Estimate> {
        None
    }

    /// The same in any direction of `motion`, by the better way of quadrature.
    fn beside(&self, beta: f64, half_width: f64, y: f64, motion: Motion, relative: f64) -> Estimate {
        if let Some(estimate) = self.evanescent(beta, half_width, (y, motion), relative) {
            return estimate;
        }
        if motion == Motion::Vertical {
            return self.receiver(beta, half_width, y, relative);
        }
        // g/k of G_xz = i g
        let horizontal =
            |k: &[f64]| k.iter().zip(self.u_xz_many(k)).map(|(k, u_xz)| -I * u_xz / *k).collect::<Vec<_>>();
        strip::horizontal_quadrature(&horizontal, self.outline(), beta, half_width, y, motion, relative)
    }

    /// [`receiver`](Self::receiver) at many distances `y` [m] at once, to `relative` of the largest. By one quadrature for all unless the solver
    /// knows better.
    fn receivers(&self, beta: f64, half_width: f64, y: &[f64], relative: f64) -> Vec<Estimate> {
        strip::receivers_quadrature(&|k| self.u_zz_many(k), self.outline(), beta, half_width, y, relative)
    }

    /// Wave modes: wavenumbers √κ_j and residues of G_zz = Σ r_j/(k² − κ_j), for solvers that have them.
    ///
    /// # Errors
    /// `NoModes`, naming a solver that has.
    fn modes(&self) -> Result<Vec<Pole>, SoilError> {
        Err(SoilError::NoModes)
    }
}

/// One term r/(k² − κ) of the vertical compliance at the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// κ = k² of the mode [rad²/m²].
    pub kappa: Complex64,
    /// r [m/Pa rad²/m²]
    pub residue: Complex64,
}

/// A solver by name, as a case file asks for it.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
#[schemars(tag = "kind")]
pub enum Solver {
    /// Exact layer stiffness matrices.
    #[default]
    DirectStiffness,
    /// Compound transfer matrices; surface only.
    TransferMatrix,
    /// Recursion on flexibilities; surface only.
    Flexibility,
    /// Thin layers and their modes.
    ThinLayer(ThinLayer),
}

impl Solver {
    /// Its name in case files, reports and attributes.
    pub fn name(&self) -> &'static str {
        match self {
            Self::DirectStiffness => "direct-stiffness",
            Self::TransferMatrix => "transfer-matrix",
            Self::Flexibility => "flexibility",
            Self::ThinLayer(_) => "thin-layer",
        }
    }

    /// What it does, in one sentence for a report.
    pub fn method(&self) -> String {
        match self {
            Self::DirectStiffness => {
                "Compliance of the ground by the direct stiffness method (exact layer matrices).".into()
            }
            Self::TransferMatrix => {
                "Compliance of the ground by compound transfer matrices (exact, free of cancellation).".into()
            }
            Self::Flexibility => {
                "Compliance of the ground by recursion on flexibilities (exact, waves up and down kept apart)."
                    .into()
            }
            Self::ThinLayer(settings) => {
                format!("Compliance of the ground by the thin-layer method ({}).", settings.text())
            }
        }
    }

    /// The same solver for wavenumbers from `k.0` to `k.1` [rad/m] to `accuracy` of G, and with one set of sublayers for
    /// frequencies from `band.0` to `band.1` [rad/s]; exact solvers serve them all.
    #[must_use]
    pub fn resolving(self, k: (f64, f64), accuracy: f64, band: Option<(f64, f64)>) -> Self {
        match self {
            Self::ThinLayer(settings) => {
                let settings = settings.resolving(k, accuracy);
                Self::ThinLayer(band.map_or(settings, |(low, high)| settings.for_frequencies(low, high)))
            }
            exact => exact,
        }
    }

    /// `profile` at `omega` ≠ 0, ready for many integrals over wavenumbers up to `highest` [rad/m] and beyond, to `accuracy` of G: by
    /// poles in closed form; where no few poles do that by quadrature of a table.
    ///
    /// # Errors
    /// As `prepare`.
    pub fn prepare_many(
        &self,
        profile: &Profile,
        omega: f64,
        highest: f64,
        accuracy: f64,
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        let ground = self.resolving((0.0, highest), accuracy, None).prepare(profile, omega, &[])?;
        if self.has_modes() {
            return Ok(ground);
        }
        Ok(match Poles::new(ground, accuracy) {
            Ok(poles) => Box::new(poles),
            Err(ground) => Box::new(Sampled::new(ground, highest)),
        })
    }

    /// True if modes at one frequency, dear to find, answer every wavenumber.
    pub fn has_modes(&self) -> bool {
        matches!(self, Self::ThinLayer(settings) if settings.has_modes())
    }
}

/// Refuses depths on behalf of a solver of the surface alone.
fn surface_only(solver: &'static str, depths: &[f64]) -> Result<(), SoilError> {
    match depths.iter().find(|z| **z != 0.0) {
        Some(&depth) => Err(SoilError::SurfaceOnly { solver, depth }),
        None => Ok(()),
    }
}

impl GroundSolver for Solver {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        match self {
            Self::DirectStiffness => DirectStiffness.prepare(profile, omega, depths),
            Self::TransferMatrix => TransferMatrix.prepare(profile, omega, depths),
            Self::Flexibility => Flexibility.prepare(profile, omega, depths),
            Self::ThinLayer(settings) => settings.prepare(profile, omega, depths),
        }
    }
}

/// Why a ground cannot be built or asked.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SoilError {
    /// A quantity out of its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// Poisson's ratio out of range.
    #[error("Poisson's ratio is {value}: it must lie above -1 and below 0.5 (use 0.499 for undrained clay)")]
    PoissonRatio {
        /// What was given.
        value: f64,
    },
    /// c_p too small for its c_s.
    #[error(
        "pressure wave speed {c_p} m/s is too low for a shear wave speed of {c_s} m/s: above {least:.1} m/s the bulk modulus is positive"
    )]
    PressureSpeed {
        /// c_p [m/s]
        c_p: f64,
        /// c_s [m/s]
        c_s: f64,
        /// Least c_p [m/s].
        least: f64,
    },
    /// The pair of loss factors makes compression feed energy in.
    #[error(
        "pressure loss factor {loss_pressure} is too small for the shear loss factor: compression would gain energy below {least:.4}"
    )]
    NotPassive {
        /// What was given.
        loss_pressure: f64,
        /// Least value.
        least: f64,
    },
    /// A rigid base with nothing on it.
    #[error("the ground has no layer on its rigid base: add a layer, or use a half-space")]
    NoGround,
    /// A solver that answers at the surface only.
    #[error(
        "the {solver} method answers at the surface only, not at a depth of {depth} m: use direct-stiffness or thin-layer"
    )]
    SurfaceOnly {
        /// Its name.
        solver: &'static str,
        /// What was asked [m].
        depth: f64,
    },
    /// A product of transfer matrices has cancelled.
    #[error(
        "the product of transfer matrices has lost the compliance at k = {k} rad/m, ω = {omega} rad/s: its rounding error may \
         be {error:.1e} of it, more than {allowed:.0e}; use the compound matrix (transfer-matrix), direct-stiffness or flexibility"
    )]
    DigitsLost {
        /// [rad/m]
        k: f64,
        /// [rad/s]
        omega: f64,
        /// Bound of the relative error.
        error: f64,
        /// Largest one accepted.
        allowed: f64,
    },
    /// Modes wanted of a solver that has none.
    #[error(
        "this solver has no modes: use thin-layer with half_space = \"matched\", at a frequency where its modes settle"
    )]
    NoModes,
    /// An accuracy thin layers are not made for.
    #[error("the accuracy of the thin-layer method is {value}: it must lie between 1e-9 and 0.1")]
    Accuracy {
        /// What was given.
        value: f64,
    },
    /// Too few sublayers.
    #[error("{given} sublayers to a wavelength cannot reach an accuracy of {accuracy:e}: {needed} would")]
    Sublayers {
        /// Per wavelength.
        given: f64,
        /// Per wavelength.
        needed: f64,
        /// What was asked.
        accuracy: f64,
    },
    /// An eigenproblem too large.
    #[error(
        "the thin-layer method needs {sublayers} sublayers at {frequency:.3} Hz, more than the {most} whose modes can be found: \
         ask for a lower accuracy or frequency, or look for single modes with dispersion"
    )]
    Unknowns {
        /// Needed.
        sublayers: usize,
        /// Largest number.
        most: usize,
        /// [Hz]
        frequency: f64,
    },
    /// A depth outside the ground.
    #[error("depth {depth} m is outside the ground (0 to {bottom} m{})", if *rigid { ", rigid below" } else { " and the half-space below" })]
    Depth {
        /// What was asked [m].
        depth: f64,
        /// Bottom of the layers [m].
        bottom: f64,
        /// True on a rigid base.
        rigid: bool,
    },
}
