//! The thin-layer method: finite elements in depth, exact along the ground, and modes that answer in closed form.
//!
//! G is right to a few times the accuracy asked, relative to its largest component. Near a resonance of lightly damped
//! layers, an error ε of the wave speed counts ε/η: worst of random grounds with η from 0.2 %, up to twelve wavelengths
//! thick, at 1e-6 asked: 3e-5 at the surface and in depth, 3e-6 in k_eq of a strip (test `laws::thin_layer`); 6.5e-5 was
//! the worst of two thousand values drawn once.
//!
//! Source: Waas 1972; Kausel & Peek 1982; Kausel 1986, 1994; linear in k² by the similarity of THEORY 2.

mod element;
mod mesh;
mod modes;
mod settings;

pub use element::Element;
pub use settings::{BelowLayers, ThinLayer};

use super::layer_stiffness::LayerStiffness;
use super::strip::{Outline, Strip, quadrature, receiver_quadrature, receivers_quadrature};
use super::transfer_matrix::surface_compliance;
use super::wave::Wave;
use super::{Compliance, GroundSolver, Pole, PreparedGround, Profile, SoilError, SurfaceCompliance, chain};
use crate::math::complex::I;
use crate::math::quadrature::Estimate;
use mesh::Mesh;
use modes::Modes;
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// Most unknowns of an in-plane eigenproblem. It takes 0.15 s, as long as a thousand wavenumbers of as many sublayers
/// without modes: beyond that, and for want of modes, every wavenumber is answered by itself.
const MOST_UNKNOWNS: usize = 400;

/// The thin-layer method at one ω.
struct ThinLayerAt {
    settings: ThinLayer,
    profile: Profile,
    /// |ω|
    omega: f64,
    depths: Vec<f64>,
    /// With matched layers; empty where only the exact half-space serves.
    mesh: Mesh,
    in_plane: OnceLock<Option<InPlane>>,
    anti_plane: OnceLock<Option<Modes>>,
    negative: bool,
    outline: Outline,
}

/// Modes and the wavenumbers between which they answer.
struct InPlane {
    modes: Modes,
    band: (f64, f64),
}

impl GroundSolver for ThinLayer {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        let (split, _) = profile.split_at(depths)?;
        // the surface is always wanted
        let mut all = vec![0.0];
        all.extend(depths);
        let omega_abs = omega.abs();
        let resolution = self.resolution(omega_abs, self.k.1);
        let mesh = match self.half_space {
            BelowLayers::Matched => {
                let mesh = Mesh::new(&split, omega_abs, &all, &resolution, self.k.0);
                mesh.matched(omega_abs, &all, &resolution)
            }
            BelowLayers::Exact => {
                let slowest = f64::INFINITY;
                Mesh {
                    sublayers: Vec::new(),
                    nodes: Vec::new(),
                    interfaces: Vec::new(),
                    half_space: None,
                    slowest,
                }
            }
        };
        Ok(Box::new(ThinLayerAt {
            settings: *self,
            profile: split,
            omega: omega_abs,
            depths: all,
            mesh,
            in_plane: OnceLock::new(),
            anti_plane: OnceLock::new(),
            negative: omega < 0.0,
            outline: Outline::new(profile, omega),
        }))
    }
}

impl ThinLayerAt {
    /// The in-plane modes, if there are any: with the wavenumbers above which they agree with the equations they come from.
    fn modes(&self) -> Option<&InPlane> {
        let found = self.in_plane.get_or_init(|| {
            if self.mesh.sublayers.is_empty() || 2 * self.mesh.size() > MOST_UNKNOWNS {
                return None;
            }
            let modes = Modes::in_plane(&self.mesh.sublayers, &self.mesh.nodes, self.middle())?;
            let (k_min, k_max) = self.settings.k;
            // downward from k_max to where the sum has lost its digits, if anywhere: towards rest, where P and S modes merge
            let mut lowest = f64::INFINITY;
            const CHECKS: i32 = 4;
            for check in 0..CHECKS {
                let least = (k_min / k_max).max(1e-8);
                let k = k_max * least.powf(f64::from(check) / f64::from(CHECKS - 1));
                let layers: Vec<_> = self.mesh.sublayers.iter().map(|s| s.in_plane(k)).collect();
                let direct = chain::displacements(&layers, None, 0)[0][(1, 1)];
                // written so that NaN is refused
                let agrees = (modes.surface.at(k) - direct).norm() <= self.settings.accuracy * direct.norm();
                if !agrees {
                    break;
                }
                lowest = if check == CHECKS - 1 { k_min } else { k };
            }
            (lowest <= k_max).then_some(InPlane { modes, band: (lowest, k_max) })
        });
        found.as_ref()
    }

    /// κ₀ in the middle of the wavenumbers that matter, above those of every wave.
    fn middle(&self) -> f64 {
        let k_s = self.profile.materials().map(|m| self.omega / m.rayleigh_speed()).fold(0.0, f64::max);
        (self.settings.k.1 * k_s.max(self.settings.k.0).max(1e-6 * self.settings.k.1)).max(4.0 * k_s * k_s)
    }

    fn anti_plane_modes(&self) -> Option<&Modes> {
        let found = self
            .anti_plane
            .get_or_init(|| Modes::anti_plane(&self.mesh.sublayers, &self.mesh.nodes, self.middle()));
        found.as_ref()
    }

    /// Without modes: sublayers cut for this very k, on the exact half-space. In-plane and anti-plane displacements
    /// [receiver] for loads at depth number `source`.
    fn direct(&self, k: f64, source: usize) -> (Vec<nalgebra::Matrix2<Complex64>>, Vec<Complex64>) {
        let to = self.settings.resolution(self.omega, k.max(1e-9));
        let mesh = Mesh::new(&self.profile, self.omega, &self.depths, &to, k);
        let base = mesh.half_space.map(|m| Wave::new(&m, self.omega));
        let layers: Vec<_> = mesh.sublayers.iter().map(|s| s.in_plane(k)).collect();
        let half_space = base.map(|w| LayerStiffness::<2>::half_space(&w, k));
        let in_plane = chain::displacements(&layers, half_space, mesh.interfaces[source]);
        let layers: Vec<_> = mesh.sublayers.iter().map(|s| s.anti_plane(k)).collect();
        let half_space = base.map(|w| LayerStiffness::<1>::half_space(&w, k));
        let anti_plane = chain::displacements(&layers, half_space, mesh.interfaces[source]);
        (
            mesh.interfaces.iter().map(|&i| in_plane[i]).collect(),
            mesh.interfaces.iter().map(|&i| anti_plane[i][0]).collect(),
        )
    }

    /// The modes, where they answer at `k`.
    fn modes_at(&self, k: f64) -> Option<&Modes> {
        self.modes().filter(|m| m.band.0 <= k && k <= m.band.1).map(|m| &m.modes)
    }

    /// In-plane (u, w) per traction and anti-plane displacements at every depth, loads at depth number `source`.
    fn displacements(&self, k: f64, source: usize) -> (Vec<nalgebra::Matrix2<Complex64>>, Vec<Complex64>) {
        let Some(modes) = self.modes_at(k) else { return self.direct(k, source) };
        let Some(anti_plane) = self.anti_plane_modes() else { return self.direct(k, source) };
        let in_plane = (0..self.depths.len())
            .map(|receiver| {
                let (r, s) = (2 * receiver, 2 * source);
                // u and k w on the left, f_u and k f_w on the right; w from f_u by reciprocity
                nalgebra::Matrix2::new(
                    modes.sum(r, s, k),
                    k * modes.sum(r, s + 1, k),
                    k * modes.sum(s, r + 1, k),
                    modes.sum(r + 1, s + 1, k),
                )
            })
            .collect();
        (in_plane, (0..self.depths.len()).map(|receiver| anti_plane.sum(receiver, source, k)).collect())
    }

    /// A closed form as an estimate; its error is that of the sublayers.
    fn estimate(&self, value: Complex64, modes: &Modes) -> Estimate {
        let error = self.settings.accuracy * value.norm();
        Estimate {
            value: self.signed(value),
            error,
            count: modes.surface.kappa.len(),
            converged: value.is_finite(),
        }
    }

    fn signed(&self, z: Complex64) -> Complex64 {
        if self.negative { z.conj() } else { z }
    }
}

impl PreparedGround for ThinLayerAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let (in_plane, anti_plane) = self.displacements(k, 0);
        surface_compliance(&in_plane[0], anti_plane[0], self.negative)
    }

    fn u_zz(&self, k: f64) -> Complex64 {
        self.signed(match self.modes_at(k) {
            Some(modes) => modes.surface.at(k),
            None => self.direct(k, 0).0[0][(1, 1)],
        })
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        // the surface comes first
        let (in_plane, anti_plane) = self.displacements(k, source + 1);
        in_plane[1..]
            .iter()
            .zip(&anti_plane[1..])
            .map(|(g, u_yy)| Compliance {
                u_zz: self.signed(g[(1, 1)]),
                u_xx: self.signed(g[(0, 0)]),
                u_xz: I * self.signed(g[(0, 1)]),
                u_zx: -I * self.signed(g[(1, 0)]),
                u_yy: self.signed(*u_yy),
            })
            .collect()
    }

    fn outline(&self) -> &Outline {
        &self.outline
    }

    /// In closed form where the modes answer at β.
    fn strip(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        match self.modes_at(beta.abs()) {
            Some(modes) => self.estimate(modes.surface.strip(beta, strip), modes),
            None => quadrature(&|k| self.u_zz_many(k), &self.outline, beta, strip, relative),
        }
    }

    /// In closed form where the modes answer at β.
    fn receiver(&self, beta: f64, half_width: f64, y: f64, relative: f64) -> Estimate {
        match self.modes_at(beta.abs()) {
            Some(modes) => self.estimate(modes.surface.receivers(beta, half_width, &[y])[0], modes),
            None => receiver_quadrature(&|k| self.u_zz_many(k), &self.outline, beta, half_width, y, relative),
        }
    }

    fn receivers(&self, beta: f64, half_width: f64, y: &[f64], relative: f64) -> Vec<Estimate> {
        match self.modes_at(beta.abs()) {
            Some(modes) => {
                let values = modes.surface.receivers(beta, half_width, y);
                values.into_iter().map(|value| self.estimate(value, modes)).collect()
            }
            None => {
                receivers_quadrature(&|k| self.u_zz_many(k), &self.outline, beta, half_width, y, relative)
            }
        }
    }

    fn modes(&self) -> Result<Vec<Pole>, SoilError> {
        let InPlane { modes, .. } = self.modes().ok_or_else(|| match 2 * self.mesh.size() {
            unknowns if unknowns > MOST_UNKNOWNS => SoilError::Unknowns {
                sublayers: self.mesh.sublayers.len(),
                most: self.mesh.sublayers.len() * MOST_UNKNOWNS / unknowns,
                frequency: self.omega / TAU,
            },
            _ => SoilError::NoModes,
        })?;
        let signed = |z: &Complex64| self.signed(*z);
        let poles = modes.surface.kappa.iter().zip(&modes.surface.residue);
        Ok(poles.map(|(kappa, residue)| Pole { kappa: signed(kappa), residue: signed(residue) }).collect())
    }
}
