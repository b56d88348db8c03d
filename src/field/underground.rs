//! Displacements, strains and stresses under and beside a train that moves or stands.
//!
//! ```text
//! f(x′, y, z) = (1/π) Re ∫₀^∞ q̃(β) Σ_j P_j e^{iβa_j} R(β; y, z) e^{iβx′} dβ
//! R(β; y, z)  = (1/2π) ∫_{−∞}^{∞} g(β, q; z) sinc(qb) e^{iqy} dq          k² = β² + q²,  ω = −βv
//! ```
//!
//! g are the motions and stresses of a unit traction wave at the surface and what follows from them, with cos θ = β/k, sin θ = q/k:
//!
//! ```text
//! u_x = u_r cos θ   u_y = u_r sin θ   ε_xx = iβ u_x   ε_yy = iq u_y   γ_xy = i(q u_x + β u_y)   τ_xz = τ cos θ   τ_yz = τ sin θ
//! ```
//!
//! the rest from Hooke's law: ε_zz = (σ_zz − λ*(ε_xx + ε_yy))/(λ* + 2μ*), γ_xz = τ_xz/μ*, … Both integrals are done by adaptive panels;
//! there is no grid, no period and no wrap-around.

use super::ground_grid::GroundLoad;
use crate::math::complex::I;
use crate::math::many;
use crate::math::quadrature::subdivided;
use crate::rail::{BETA_CAP, panels};
use crate::soil::at_depth::{AtDepth, State};
use crate::soil::strip::{Outline, sinc};
use crate::soil::{Material, Profile, SoilError};
use crate::vehicle::Train;
use ndarray::Array4;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Evaluations of the ground allowed for one β, and of β for a field.
const MAX_ACROSS: usize = 60_000;
const MAX_ALONG: usize = 6_000;

/// What is integrated: all of it is even or odd in y.
const PARTS: usize = 9;
/// How many of them are even; they come first.
const EVEN: usize = 6;
/// Every load reaches as far [rad/m].
const LEAST_END: f64 = 0.1;
/// Nothing is integrated worse, however little of it arrives.
const LOOSEST: f64 = 1e-2;

/// Where a train is asked about the ground below the surface.
pub struct Underground<'a> {
    /// The ground.
    pub profile: &'a Profile,
    /// v [m/s]; 0 for a train that stands.
    pub speed: f64,
    /// The train.
    pub train: &'a Train,
    /// How its loads reach the ground.
    pub load: GroundLoad<'a>,
}

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

/// The state of the ground around a train.
#[derive(Clone, Debug)]
pub struct UndergroundField {
    /// One value for each ([component](COMPONENTS), z, y, x′).
    pub values: Array4<f64>,
    /// Estimated error of the integrals over those of their moduli.
    pub error: f64,
    /// Whether that is what was wanted.
    pub converged: bool,
}

/// γ_oct = ⅔ √((ε_xx − ε_yy)² + (ε_yy − ε_zz)² + (ε_zz − ε_xx)² + 3/2 (γ_xy² + γ_xz² + γ_yz²)), octahedral shear strain.
pub fn octahedral_strain(field: &UndergroundField) -> ndarray::Array3<f64> {
    let of = |i: usize| field.values.index_axis(ndarray::Axis(0), i);
    let [xx, yy, zz, xy, xz, yz] = [3, 4, 5, 6, 7, 8].map(of);
    ndarray::Array3::from_shape_fn(xx.raw_dim(), |at| {
        let normal = (xx[at] - yy[at]).powi(2) + (yy[at] - zz[at]).powi(2) + (zz[at] - xx[at]).powi(2);
        let shear = xy[at].powi(2) + xz[at].powi(2) + yz[at].powi(2);
        2.0 / 3.0 * (normal + 1.5 * shear).sqrt()
    })
}

/// The nine parts of a state at (β, q): W, cU, ikc²U, iks²U, S, cT even in q; sU, 2ikcsU, sT odd.
fn parts(state: &State, beta: f64, q: f64) -> [Complex64; PARTS] {
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
fn components(parts: &[Complex64], material: &Material, omega: f64) -> [f64; 15] {
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

/// Ends of the track's and the ground's answer.
struct Reach {
    /// Nearest depth [m].
    shallowest: f64,
    /// Nepers after which nothing counts.
    nepers: f64,
    /// Nepers down to the shallowest depth over β [m].
    decay: f64,
}

impl Underground<'_> {
    fn half_width(&self) -> f64 {
        match self.load {
            GroundLoad::Strip { half_width, .. } => half_width,
            GroundLoad::Point => 0.0,
        }
    }

    /// q̃(β) Σ_j P_j e^{iβa_j} [N], a_j from the leading axle.
    fn force(&self, beta: f64) -> Complex64 {
        let lead = self.train.axles()[0].position;
        let phases: Complex64 =
            self.train.axles().iter().map(|a| a.load * Complex64::cis(beta * (a.position - lead))).sum();
        match self.load {
            GroundLoad::Strip { force, .. } => force(beta) * phases,
            GroundLoad::Point => phases,
        }
    }

    /// Nepers by which waves of phase speed v decay down to the shallowest depth, over β [m]: z Re √(1 − (v/c_s*)²) of the material where
    /// that is least.
    fn decay(&self, shallowest: f64) -> f64 {
        let rate = |m: &Material| {
            let c2 = m.complex_shear_modulus(-self.speed) / m.density();
            (1.0 - self.speed * self.speed / c2).sqrt().re.abs()
        };
        shallowest * self.profile.materials().map(rate).fold(f64::INFINITY, f64::min)
    }

    /// Where the integral over β ends [rad/m]: where no load is left or nothing of it arrives at depth.
    fn end(&self, reach: &Reach) -> f64 {
        let loaded = match self.load {
            GroundLoad::Strip { beta_max, .. } => beta_max,
            GroundLoad::Point => f64::INFINITY,
        };
        let felt = (reach.nepers / reach.decay).min(BETA_CAP.max(reach.nepers / reach.shallowest));
        let mut end = felt.min(loaded);
        // a track spreads its load: beyond, less than the accuracy is left of it, of an envelope that falls
        if let GroundLoad::Strip { force, .. } = self.load {
            let least = (-reach.nepers).exp() * force(1e-3 * end).norm();
            while end > LEAST_END && force(end).norm() < least && force(0.97 * end).norm() < least {
                end *= 0.95;
            }
        }
        end
    }

    /// R(β; y, z) of all parts, z by z and y by y within each, and the share of error in them: to `relative` of what there is where the
    /// waves have not decayed.
    fn across(
        &self,
        (ground, outline): (&AtDepth, &Outline),
        beta: f64,
        y: &[f64],
        reach: &Reach,
        relative: f64,
    ) -> (Vec<Complex64>, f64) {
        let b = self.half_width();
        let far = y.iter().map(|y| y.abs()).fold(0.0, f64::max);
        let slowest = outline.wavenumbers.last().copied().unwrap_or(0.0);
        // √(β² + q² − k_s²) z = nepers, a few at least
        let left = (reach.nepers / reach.shallowest).powi(2) + slowest * slowest - beta * beta;
        let top = left.max((8.0 / reach.shallowest).powi(2)).sqrt();
        let widest = 1.5 * TAU / (b + far).max(0.1 * reach.shallowest);
        let points = subdivided(&outline.breakpoints(beta, top), widest);
        // of what has decayed by n nepers e^{n/2} times as much is borne: the sum over all β stays small
        // long waves count in proportion to β, and layers thin beside them cost digits
        let long = 1.0 + 0.01 / (beta * reach.shallowest);
        let wanted = (relative * long * (0.5 * beta * reach.decay).exp()).min(LOOSEST);
        // under the centre line and at the farthest y: all others lie between
        let all = |q: &[f64; 15]| {
            q.map(|q| {
                let load = sinc(q * b);
                let (sin, cos) = (q * far).sin_cos();
                let states = ground.states(beta.hypot(q));
                let mut values: Vec<Complex64> =
                    states.iter().flat_map(|state| parts(state, beta, q)).map(|part| part * load).collect();
                let turned =
                    |(i, value): (usize, &Complex64)| value * if i % PARTS < EVEN { cos } else { sin };
                values.extend(values.iter().enumerate().map(turned).collect::<Vec<_>>());
                values
            })
        };
        let many = many::integrate(all, &points, wanted, MAX_ACROSS);
        // as a share of what there is without decay
        let error = many.error * relative / wanted;
        let depths = ground.materials().len();
        let mut sums = vec![Complex64::ZERO; depths * y.len() * PARTS];
        for (q, weight, values) in &many.nodes {
            for (j, distance) in y.iter().enumerate() {
                let (sin, cos) = (q * distance).sin_cos();
                let even = Complex64::from(cos * weight / PI);
                let odd = I * (sin * weight / PI);
                for d in 0..depths {
                    let from = (d * y.len() + j) * PARTS;
                    let sums = &mut sums[from..from + PARTS];
                    for (i, (sum, value)) in sums.iter_mut().zip(&values[d * PARTS..]).enumerate() {
                        *sum += value * if i < EVEN { even } else { odd };
                    }
                }
            }
        }
        (sums, error)
    }

    /// The state of the ground at `x` × `y` × `depths` [m], x′ from the leading axle, y from the centre line, depths above zero; to
    /// `relative` of the largest value of each component at each depth.
    ///
    /// Accuracy: 1e-6 against Boussinesq and against differences of its own displacements at `relative` = 1e-8 (test
    /// `cross_solver::underground`).
    ///
    /// # Errors
    /// A depth outside the ground.
    pub fn compute(
        &self,
        (x, y, depths): (&[f64], &[f64], &[f64]),
        relative: f64,
    ) -> Result<UndergroundField, SoilError> {
        let shallowest = depths.iter().copied().fold(f64::INFINITY, f64::min);
        let nepers = (1.0 / relative).ln() + 4.0;
        let reach = Reach { shallowest, nepers, decay: self.decay(shallowest) };
        let materials = AtDepth::new(self.profile, 0.0, depths)?.materials().to_vec();
        let along = |beta: f64| -> Result<(Vec<Complex64>, f64), SoilError> {
            let omega = -beta * self.speed;
            let ground = AtDepth::new(self.profile, omega, depths)?;
            let outline = Outline::new(self.profile, omega);
            let (mut values, error) = self.across((&ground, &outline), beta, y, &reach, 0.1 * relative);
            let force = self.force(beta);
            values.iter_mut().for_each(|v| *v *= force);
            Ok((values, error))
        };
        let length = self.train.length();
        let farthest = x.iter().map(|x| x.abs()).fold(0.0, f64::max) + length;
        let far = y.iter().map(|y| y.abs()).fold(0.0, f64::max);
        let ends = panels(self.end(&reach), farthest + far);
        let worst = std::sync::Mutex::new(0.0f64);
        let many = many::integrate(
            |beta| {
                let rows: Vec<Vec<Complex64>> = beta
                    .par_iter()
                    .map(|beta| match along(*beta) {
                        Ok((values, error)) => {
                            if let Ok(mut worst) = worst.lock() {
                                *worst = worst.max(error);
                            }
                            values
                        }
                        // the depths were accepted above
                        Err(_) => vec![Complex64::from(f64::NAN)],
                    })
                    .collect();
                let mut rows = rows.into_iter();
                std::array::from_fn(|_| rows.next().unwrap_or_default())
            },
            &ends,
            relative,
            MAX_ALONG,
        );
        let size = depths.len() * y.len();
        let columns: Vec<Vec<[f64; 15]>> = x
            .par_iter()
            .map(|x| {
                let mut sums = vec![Complex64::ZERO; size * PARTS];
                for (beta, weight, values) in &many.nodes {
                    let turn = Complex64::cis(beta * x) * (weight / PI);
                    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += turn * value);
                }
                let at = |(i, parts): (usize, &[Complex64])| {
                    components(parts, &materials[i / y.len()], -self.speed)
                };
                sums.chunks(PARTS).enumerate().map(at).collect()
            })
            .collect();
        let values =
            Array4::from_shape_fn((COMPONENTS.len(), depths.len(), y.len(), x.len()), |(c, d, j, i)| {
                columns[i][d * y.len() + j][c]
            });
        let within = worst.into_inner().unwrap_or(f64::INFINITY);
        let error = many.error + within;
        Ok(UndergroundField { values, error, converged: many.converged && within <= relative })
    }
}
