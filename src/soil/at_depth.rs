//! Displacements and stresses at depth under a vertical traction wave at the surface, by exact layer matrices.
//!
//! The stiffness B of all that lies below an interface is condensed from the base upward; the motion is then followed down, and what
//! the lower part is pressed with is B u there:
//!
//! ```text
//! u₀ = B₀⁻¹ (0, 1)ᵀ      u_{j+1} = −(D_j + B_{j+1})⁻¹ C_j M u_j      (−τ_rz, −σ_zz) = B_j u_j
//! ```
//!
//! Every step multiplies, none subtracts: what has decayed over many layers keeps its digits.

use super::chain::{condensed, inverse_symmetric, turned_vector};
use super::layer_stiffness::LayerStiffness;
use super::wave::Wave;
use super::{Base, Material, Profile, SoilError};
use crate::math::complex::I;
use nalgebra::Vector2;
use num_complex::Complex64;

/// What a unit vertical traction wave e^{i(ωt + kx)} [Pa] at the surface does at one depth, z down, tension positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Displacement along the direction of propagation [m].
    pub u_r: Complex64,
    /// Displacement downward [m].
    pub u_z: Complex64,
    /// Shear stress τ_rz [Pa].
    pub tau: Complex64,
    /// Vertical stress σ_zz [Pa].
    pub sigma: Complex64,
}

/// A profile at one ω, ready to answer at some depths.
#[derive(Clone, Debug)]
pub struct AtDepth {
    layers: Vec<(Wave, f64)>,
    half_space: Option<Wave>,
    interfaces: Vec<usize>,
    /// G(−ω) = conj G(ω)
    negative: bool,
    /// Material just below each depth.
    materials: Vec<Material>,
}

impl AtDepth {
    /// `profile` at `omega` [rad/s], to be asked at `depths` [m].
    ///
    /// # Errors
    /// A depth outside the ground.
    pub fn new(profile: &Profile, omega: f64, depths: &[f64]) -> Result<Self, SoilError> {
        let (split, interfaces) = profile.split_at(depths)?;
        let layers: Vec<_> =
            split.layers().iter().map(|l| (Wave::new(&l.material, omega.abs()), l.thickness)).collect();
        let materials: Vec<Material> = split.materials().copied().collect();
        let below = |interface: &usize| materials[(*interface).min(materials.len() - 1)];
        let half_space = match split.base() {
            Base::HalfSpace(material) => Some(Wave::new(&material, omega.abs())),
            Base::Rigid => None,
        };
        let materials = interfaces.iter().map(below).collect();
        Ok(Self { layers, half_space, interfaces, negative: omega < 0.0, materials })
    }

    /// The material just below each depth; above it where that is rigid.
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// The state at every depth, at `k` [rad/m]; k > 0 where ω = 0 and the base is a half-space.
    ///
    /// Accuracy: 1e-12 against the closed forms of a half-space at rest, 1e-9 of the surface's motion in layers (tests here).
    pub fn states(&self, k: f64) -> Vec<State> {
        let layers: Vec<_> =
            self.layers.iter().map(|(wave, h)| LayerStiffness::<2>::layer(wave, *h, k)).collect();
        let base = self.half_space.map(|wave| LayerStiffness::<2>::half_space(&wave, k));
        let below = condensed(&layers, base);
        let zero = Vector2::new(Complex64::ZERO, Complex64::ZERO);
        let load = Vector2::new(Complex64::ZERO, Complex64::ONE);
        let mut motion = vec![(zero, zero); layers.len() + 1];
        motion[0] = (below[0].map_or(zero, |stiffness| inverse_symmetric(&stiffness) * load), load);
        for (j, LayerStiffness { direct, cross }) in layers.iter().enumerate() {
            let pressed = cross * turned_vector(motion[j].0);
            motion[j + 1] = match below[j + 1] {
                Some(stiffness) => {
                    let u = -(inverse_symmetric(&(direct + stiffness)) * pressed);
                    (u, stiffness * u)
                }
                // on rock: what the layer's lower face presses with
                None => (zero, -pressed),
            };
        }
        let signed = |z: Complex64| if self.negative { z.conj() } else { z };
        let state = |&interface: &usize| {
            let (u, load) = motion[interface];
            State {
                u_r: I * signed(u[0]),
                u_z: signed(u[1]),
                tau: -I * signed(load[0]),
                sigma: -signed(load[1]),
            }
        };
        self.interfaces.iter().map(state).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{DirectStiffness, Elastic, GroundSolver, Layer};
    use super::*;

    fn material(young: f64, loss: f64) -> Material {
        Material::new(Elastic::YoungPoisson { young, poisson: 0.3 }, 1800.0, loss, loss).unwrap()
    }

    /// A half-space at rest: σ_zz = −(1 + kz) e^{−kz}, τ_rz = ikz e^{−kz}, u_z = ((1 − ν) + kz/2) e^{−kz}/(μk),
    /// u_r = i((1 − 2ν) − kz) e^{−kz}/(2μk).
    #[test]
    fn half_space_at_rest() {
        let m = material(5e7, 0.0);
        let profile = Profile::new(vec![], Base::HalfSpace(m)).unwrap();
        let depths = [0.0, 0.2, 1.0, 6.0];
        let ground = AtDepth::new(&profile, 0.0, &depths).unwrap();
        let mu = m.shear_modulus();
        for k in [0.05, 1.0, 20.0] {
            for (state, z) in ground.states(k).iter().zip(depths) {
                let (kz, e) = (k * z, (-k * z).exp());
                let pairs = [
                    (state.sigma, Complex64::from(-(1.0 + kz) * e), e),
                    (state.tau, I * kz * e, e),
                    (state.u_z, Complex64::from((0.7 + 0.5 * kz) * e / (mu * k)), e / (mu * k)),
                    (state.u_r, I * (0.4 - kz) * e / (2.0 * mu * k), e / (mu * k)),
                ];
                for (found, exact, scale) in pairs {
                    // measured 2e-13 at most
                    assert!((found - exact).norm() < 1e-12 * scale * (1.0 + kz), "{k} {z} {found} {exact}");
                }
            }
        }
    }

    /// In layers: the displacements of the other way to get them, stresses from their differences, equilibrium with inertia.
    #[test]
    fn layers_in_motion() {
        let layers = vec![
            Layer { thickness: 2.0, material: material(3e7, 0.06) },
            Layer { thickness: 3.0, material: material(8e7, 0.04) },
        ];
        let ground = Profile::new(layers.clone(), Base::HalfSpace(material(2e8, 0.04))).unwrap();
        let rigid = Profile::new(layers, Base::Rigid).unwrap();
        let (z, h) = (1.2, 1e-3);
        for profile in [ground, rigid] {
            for omega in [60.0, -60.0] {
                let depths = [0.0, z - h, z, z + h, 5.0];
                let at = AtDepth::new(&profile, omega, &depths).unwrap();
                let witness = DirectStiffness.prepare(&profile, omega, &depths).unwrap();
                for k in [0.02, 0.4, 3.0] {
                    let states = at.states(k);
                    let displacements = witness.at_depths(k, 0);
                    let scale = displacements[0].u_zz.norm();
                    for (state, u) in states.iter().zip(&displacements) {
                        // measured 1e-11: layers of a millimetre cost digits
                        assert!((state.u_z - u.u_zz).norm() < 1e-9 * scale, "{k} {omega}");
                        assert!((state.u_r - u.u_xz).norm() < 1e-9 * scale, "{k} {omega}");
                    }
                    // ∂u/∂z by central differences, whose error is (kh)²/6 and rounding/h
                    let m = at.materials()[2];
                    let (mu, p) = (m.complex_shear_modulus(omega), m.complex_p_modulus(omega));
                    let dz = |f: fn(&State) -> Complex64| (f(&states[3]) - f(&states[1])) / (2.0 * h);
                    let ik = I * k;
                    let sigma = p * dz(|s| s.u_z) + (p - 2.0 * mu) * ik * states[2].u_r;
                    let tau = mu * (dz(|s| s.u_r) + ik * states[2].u_z);
                    // measured 2e-6 of the load
                    assert!(
                        (sigma - states[2].sigma).norm() < 1e-5,
                        "{k} {omega} {sigma} {}",
                        states[2].sigma
                    );
                    assert!((tau - states[2].tau).norm() < 1e-5, "{k} {omega} {tau} {}", states[2].tau);
                    // ∂σ/∂z + ik τ = −ρω² u_z
                    let inertia = -1800.0 * omega * omega * states[2].u_z;
                    let balance = dz(|s| s.sigma) + ik * states[2].tau - inertia;
                    assert!(balance.norm() < 1e-5, "{k} {omega} {balance}");
                }
            }
        }
    }
}
