//! The state of the ground at one place: fifteen numbers of displacement, strain and stress, from nine parts that are even or odd in y.
//!
//! From the motions and stresses of a unit traction wave at the surface, with cos θ = β/k, sin θ = q/k:
//!
//! ```text
//! u_x = u_r cos θ   u_y = u_r sin θ   ε_xx = iβ u_x   ε_yy = iq u_y   γ_xy = i(q u_x + β u_y)   τ_xz = τ cos θ   τ_yz = τ sin θ
//! ```
//!
//! the rest from Hooke's law: ε_zz = (σ_zz − λ*(ε_xx + ε_yy))/(λ* + 2μ*), γ_xz = τ_xz/μ*, …

use crate::math::complex::I;
use crate::soil::Material;
use crate::soil::at_depth::State;
use ndarray::{Array3, Array4, Axis};
use num_complex::Complex64;

/// What is integrated: all of it is even or odd in y.
pub(super) const PARTS: usize = 9;
/// How many of them are even; they come first.
pub(super) const EVEN: usize = 6;

/// One of the fifteen numbers of the state of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Component {
    /// Name of the dataset.
    pub name: &'static str,
    /// CF unit.
    pub unit: &'static str,
    /// What it is.
    pub long_name: &'static str,
}

const fn component(name: &'static str, unit: &'static str, long_name: &'static str) -> Component {
    Component { name, unit, long_name }
}

/// All of them, in the order of the arrays: displacements, strains, stresses.
pub const COMPONENTS: [Component; 15] = [
    component("u_x", "m", "displacement along the track, positive in the direction of travel"),
    component("u_y", "m", "displacement across the track, positive towards +y"),
    component("u_z", "m", "displacement, positive down"),
    component("epsilon_xx", "1", "strain along the track, extension positive"),
    component("epsilon_yy", "1", "strain across the track, extension positive"),
    component("epsilon_zz", "1", "vertical strain, extension positive"),
    component("gamma_xy", "1", "engineering shear strain, x and y"),
    component("gamma_xz", "1", "engineering shear strain, x and z"),
    component("gamma_yz", "1", "engineering shear strain, y and z"),
    component("sigma_xx", "Pa", "stress along the track, tension positive"),
    component("sigma_yy", "Pa", "stress across the track, tension positive"),
    component("sigma_zz", "Pa", "vertical stress, tension positive"),
    component("tau_xy", "Pa", "shear stress, x and y"),
    component("tau_xz", "Pa", "shear stress, x and z"),
    component("tau_yz", "Pa", "shear stress, y and z"),
];

/// γ_oct = ⅔ √((ε_xx − ε_yy)² + (ε_yy − ε_zz)² + (ε_zz − ε_xx)² + 3/2 (γ_xy² + γ_xz² + γ_yz²)), octahedral shear strain.
/// From the values of the [components](COMPONENTS), which come first in their shape.
pub fn octahedral_strain(values: &Array4<f64>) -> Array3<f64> {
    let of = |i: usize| values.index_axis(Axis(0), i);
    let [xx, yy, zz, xy, xz, yz] = [3, 4, 5, 6, 7, 8].map(of);
    Array3::from_shape_fn(xx.raw_dim(), |at| {
        let normal = (xx[at] - yy[at]).powi(2) + (yy[at] - zz[at]).powi(2) + (zz[at] - xx[at]).powi(2);
        let shear = xy[at].powi(2) + xz[at].powi(2) + yz[at].powi(2);
        2.0 / 3.0 * (normal + 1.5 * shear).sqrt()
    })
}

/// The nine parts of a state at (β, q): W, cU, ikc²U, iks²U, S, cT even in q; sU, 2ikcsU, sT odd.
pub(super) fn parts(state: &State, beta: f64, q: f64) -> [Complex64; PARTS] {
    let k = beta.hypot(q);
    let (c, s) = (beta / k, q / k);
    let State { u_r, u_z, tau, sigma } = *state;
    [
        u_z,
        c * u_r,
        I * (beta * c) * u_r,
        I * (q * s) * u_r,
        sigma,
        c * tau,
        s * u_r,
        I * (2.0 * beta * s) * u_r,
        s * tau,
    ]
}

/// The fifteen components from the nine parts in `material`, whose moduli know of ω but its sign.
pub(super) fn components(parts: &[Complex64], material: &Material, omega: f64) -> [f64; 15] {
    let [u_z, u_x, xx, yy, sigma, tau_xz, u_y, xy, tau_yz] = std::array::from_fn(|i| parts[i]);
    let (mu, modulus) = (material.complex_shear_modulus(omega), material.complex_p_modulus(omega));
    let lambda = modulus - 2.0 * mu;
    let zz = (sigma - lambda * (xx + yy)) / modulus;
    let pressure = lambda * (xx + yy + zz);
    [
        u_x,
        u_y,
        u_z,
        xx,
        yy,
        zz,
        xy,
        tau_xz / mu,
        tau_yz / mu,
        pressure + 2.0 * mu * xx,
        pressure + 2.0 * mu * yy,
        sigma,
        mu * xy,
        tau_xz,
        tau_yz,
    ]
    .map(|z| z.re)
}
