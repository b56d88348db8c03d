//! The direct stiffness method: exact layer matrices condensed from the base upward.
//!
//! Source: Kausel & Roësset 1981, in the form of `layer_stiffness`. A layer much thinner than 1/k costs (its μ/h)/(the ground's μk)
//! in units of rounding, as in any stiffness method; at the surface that product is watched, and where it is too large the
//! flexibility method answers. Accuracy at the surface: 1e-9 of the largest entry, whatever the contrast, from crusts of a
//! millimetre to waves of 600 km; measured 5.5e-10 of 2 000 000 grounds (test `laws::agreement`), 1e-11 for kh → ∞ and any
//! ω/(k c_s), ω = 0 included (test `cross_solver::surface_compliance`). At depths the cost stays (tests `laws`).

use super::batch::{Batch, XZ, ZZ};
use super::beside::Receivers;
use super::chain::{self, inverse_symmetric, upside_down};
use super::evanescent;
use super::flexibility;
use super::layer_stiffness::LayerStiffness;
use super::lifted;
use super::strip::{Outline, Strip};
use super::wave::Wave;
use super::{Base, Compliance, GroundSolver, Motion, PreparedGround, Profile, SoilError, SurfaceCompliance};
use crate::count::{self, Work};
use crate::math::complex::I;
use crate::math::quadrature::Estimate;
use nalgebra::{Matrix2, SMatrix};
use num_complex::Complex64;

/// The direct stiffness method; it has no settings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DirectStiffness;

impl GroundSolver for DirectStiffness {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        Ok(Box::new(DirectStiffnessAt::new(profile, omega, depths)?))
    }
}

/// The direct stiffness method at one ω.
#[derive(Clone, Debug)]
pub struct DirectStiffnessAt {
    /// Waves and thickness of each layer, top first.
    layers: Vec<(Wave, f64)>,
    /// None for a rigid base.
    half_space: Option<Wave>,
    /// Interface of each prepared depth.
    interfaces: Vec<usize>,
    /// G(−ω) = conj G(ω): all is computed for |ω|.
    negative: bool,
    outline: Outline,
}

/// Largest stiffness of a layer times the compliance it is felt with at the surface, both of which are rounded, that leaves 1e-9 of G.
const MOST: f64 = 3e3;

type Block = Matrix2<Complex64>;

impl DirectStiffnessAt {
    /// Prepares `profile` at `omega` [rad/s] for loads and receivers at `depths` [m].
    ///
    /// # Errors
    /// A depth outside the ground.
    pub fn new(profile: &Profile, omega: f64, depths: &[f64]) -> Result<Self, SoilError> {
        let (split, interfaces) = profile.split_at(depths)?;
        let magnitude = omega.abs();
        let half_space = match split.base() {
            Base::HalfSpace(material) => Some(Wave::new(&material, magnitude)),
            Base::Rigid => None,
        };
        Ok(Self {
            layers: split.layers().iter().map(|l| (Wave::new(&l.material, magnitude), l.thickness)).collect(),
            half_space,
            interfaces,
            negative: omega < 0.0,
            outline: Outline::new(profile, omega),
        })
    }

    /// In-plane compliance at the surface: S ← M(B − C (B + S)⁻¹ C)M from the base upward, inverted; by the flexibility method where
    /// a layer's stiffness has cost more digits than `MOST` allows.
    fn in_plane(&self, k: f64) -> Block {
        count::add(Work::Compliances, 1);
        let mut below = self.half_space.map(|wave| LayerStiffness::<2>::half_space(&wave, k));
        let mut largest = 0.0f64;
        for (wave, thickness) in self.layers.iter().rev() {
            let LayerStiffness { direct, cross } = LayerStiffness::<2>::layer(wave, *thickness, k);
            largest = largest.max(direct[(0, 0)].l1_norm()).max(direct[(1, 1)].l1_norm());
            below = Some(upside_down(match below {
                Some(below) => direct - cross * inverse_symmetric(&(direct + below)) * cross,
                None => direct,
            }));
        }
        let g = inverse_symmetric(&below.unwrap_or_else(Block::zeros));
        let size = g[(0, 0)].l1_norm().max(g[(1, 1)].l1_norm());
        // written so that NaN is asked again
        if size * largest < MOST { g } else { flexibility::in_plane(&self.layers, self.half_space, k) }
    }

    /// Anti-plane compliance at the surface, likewise.
    fn anti_plane(&self, k: f64) -> Complex64 {
        let mut below = self.half_space.map(|wave| LayerStiffness::<1>::half_space(&wave, k)[0]);
        let mut largest = 0.0f64;
        for (wave, thickness) in self.layers.iter().rev() {
            let layer = LayerStiffness::<1>::layer(wave, *thickness, k);
            let (direct, cross) = (layer.direct[0], layer.cross[0]);
            largest = largest.max(direct.l1_norm());
            below = Some(match below {
                Some(below) => direct - cross * cross / (direct + below),
                None => direct,
            });
        }
        let g = below.unwrap_or_default().inv();
        if g.l1_norm() * largest < MOST {
            g
        } else {
            flexibility::anti_plane(&self.layers, self.half_space, k)
        }
    }

    /// The same in lanes, at |ω|.
    fn lanes(&self) -> Batch<'_> {
        Batch { layers: &self.layers, half_space: self.half_space.as_ref() }
    }

    fn lifted(&self) -> lifted::Integral<'_> {
        lifted::Integral { batch: self.lanes(), outline: &self.outline, negative: self.negative, most: MOST }
    }

    /// conj for ω < 0.
    #[inline]
    fn signed(&self, z: Complex64) -> Complex64 {
        if self.negative { z.conj() } else { z }
    }

    /// Displacement matrices at all interfaces for unit tractions at interface `source`.
    fn chain<const N: usize>(
        &self,
        layer: impl Fn(&Wave, f64) -> LayerStiffness<N>,
        base: Option<SMatrix<Complex64, N, N>>,
        source: usize,
    ) -> Vec<SMatrix<Complex64, N, N>> {
        let layers: Vec<_> = self.layers.iter().map(|(wave, h)| layer(wave, *h)).collect();
        chain::displacements(&layers, base, source)
    }
}

impl PreparedGround for DirectStiffnessAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let g = self.in_plane(k);
        SurfaceCompliance {
            u_zz: self.signed(g[(1, 1)]),
            u_xx: self.signed(g[(0, 0)]),
            // u_x = i u
            u_xz: I * self.signed(g[(0, 1)]),
            u_yy: self.signed(self.anti_plane(k)),
        }
    }

    #[inline]
    fn u_zz(&self, k: f64) -> Complex64 {
        self.signed(self.in_plane(k)[(1, 1)])
    }

    /// Eight at a time.
    fn u_zz_many(&self, k: &[f64]) -> Vec<Complex64> {
        let lanes = self.lanes().element::<ZZ>(k, MOST);
        k.iter().zip(lanes).map(|(&k, g)| g.map_or_else(|| self.u_zz(k), |g| self.signed(g))).collect()
    }

    /// Eight at a time.
    fn u_xz_many(&self, k: &[f64]) -> Vec<Complex64> {
        let lanes = self.lanes().element::<XZ>(k, MOST);
        let alone = |k: f64| self.in_plane(k)[(0, 1)];
        k.iter().zip(lanes).map(|(&k, g)| I * self.signed(g.unwrap_or_else(|| alone(k)))).collect()
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        let source = self.interfaces[source];
        let in_plane = self.chain(
            |wave, h| LayerStiffness::<2>::layer(wave, h, k),
            self.half_space.map(|wave| LayerStiffness::<2>::half_space(&wave, k)),
            source,
        );
        let anti_plane = self.chain(
            |wave, h| LayerStiffness::<1>::layer(wave, h, k),
            self.half_space.map(|wave| LayerStiffness::<1>::half_space(&wave, k)),
            source,
        );
        self.interfaces
            .iter()
            .map(|&receiver| {
                let g = in_plane[receiver];
                Compliance {
                    u_zz: self.signed(g[(1, 1)]),
                    u_xx: self.signed(g[(0, 0)]),
                    u_xz: I * self.signed(g[(0, 1)]),
                    u_zx: -I * self.signed(g[(1, 0)]),
                    u_yy: self.signed(anti_plane[receiver][0]),
                }
            })
            .collect()
    }

    fn outline(&self) -> &Outline {
        &self.outline
    }

    fn lifts(&self, strip: Strip) -> bool {
        self.lifted().is_clear(&|k| self.u_zz_many(k), strip)
    }

    fn receivers_lifted(
        &self,
        half_width: f64,
        receivers: &[(f64, Motion)],
        relative: f64,
    ) -> Option<Receivers<'_>> {
        let receivers = Receivers::new(self.lifted(), half_width, receivers, relative)?;
        receivers.are_clear(&|k| self.u_zz_many(k)).then_some(receivers)
    }

    fn evanescent(
        &self,
        beta: f64,
        half_width: f64,
        receiver: (f64, Motion),
        relative: f64,
    ) -> Option<Estimate> {
        evanescent::receiver(&self.lifted(), beta, half_width, receiver, relative)
    }

    /// On the real axis where the path does not settle.
    fn strip_lifted(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        self.lifted().compliance(beta, strip, relative).unwrap_or_else(|| self.strip(beta, strip, relative))
    }
}
