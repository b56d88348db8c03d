//! Displacements, strains and stresses under and beside a train that moves or stands.
//!
//! ```text
//! f(x′, y, z) = (1/π) Re ∫₀^∞ q̃(β) Σ_j P_j e^{iβa_j} R(β; y, z) e^{iβx′} dβ
//! R(β; y, z)  = (1/2π) ∫_{−∞}^{∞} g(β, q; z) sinc(qb) e^{iqy} dq          k² = β² + q²,  ω = −βv
//! ```
//!
//! g are the [parts](super::ground_state) of the ground's state. Both integrals are done by adaptive panels, the outer one for a single
//! axle: its factors e^{iβ(a_j + x′)} oscillate faster the longer the train, and are [integrated as such](crate::math::oscillating).
//! There is no grid, no period and no wrap-around.

use super::ground_grid::GroundLoad;
use super::ground_state::{COMPONENTS, EVEN, PARTS, components, parts};
use crate::math::complex::I;
use crate::math::many::{self, Many};
use crate::math::oscillating::Oscillating;
use crate::math::quadrature::subdivided;
use crate::rail::{BETA_CAP, panels};
use crate::soil::at_depth::AtDepth;
use crate::soil::strip::{Outline, sinc};
use crate::soil::{Material, Profile, SoilError};
use crate::vehicle::Train;
use ndarray::Array4;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicU64, Ordering};

/// Evaluations of the ground allowed for one β, and of β for a field.
const MAX_ACROSS: usize = 60_000;
const MAX_ALONG: usize = 6_000;

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

    /// q̃(β), of a unit axle.
    fn force(&self, beta: f64) -> Complex64 {
        match self.load {
            GroundLoad::Strip { force, .. } => force(beta),
            GroundLoad::Point => Complex64::ONE,
        }
    }

    /// Σ_j P_j e^{iβa_j} [N], a_j from the leading axle.
    fn axles(&self, beta: f64) -> Complex64 {
        let lead = self.train.axles()[0].position;
        self.train.axles().iter().map(|a| a.load * Complex64::cis(beta * (a.position - lead))).sum()
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
        let far = y.iter().map(|y| y.abs()).fold(0.0, f64::max);
        let end = self.end(&reach);
        let worst = AtomicU64::new(0);
        let many = many::integrate(
            |beta| {
                let rows: Vec<Vec<Complex64>> = beta
                    .par_iter()
                    .map(|beta| match along(*beta) {
                        Ok((values, error)) => {
                            // numbers that are not negative are in the order of their bits
                            worst.fetch_max(error.to_bits(), Ordering::Relaxed);
                            values
                        }
                        // the depths were accepted above
                        Err(_) => vec![Complex64::from(f64::NAN)],
                    })
                    .collect();
                let mut rows = rows.into_iter();
                std::array::from_fn(|_| rows.next().unwrap_or_default())
            },
            &panels(end, far),
            relative,
            MAX_ALONG,
        );
        let within = f64::from_bits(worst.into_inner());
        let sums = self.over_axles(&many, end, x);
        let at = |(i, parts): (usize, &[Complex64])| components(parts, &materials[i / y.len()], -self.speed);
        let columns: Vec<Vec<[f64; 15]>> =
            sums.iter().map(|sums| sums.chunks(PARTS).enumerate().map(at).collect()).collect();
        let values =
            Array4::from_shape_fn((COMPONENTS.len(), depths.len(), y.len(), x.len()), |(c, d, j, i)| {
                columns[i][d * y.len() + j][c]
            });
        let error = many.error + within;
        Ok(UndergroundField { values, error, converged: many.converged && within <= relative })
    }

    /// (1/π) ∫₀^end Σ_j P_j e^{iβ(a_j + x′)} f(β) dβ of all f that `many` holds, for each x′.
    fn over_axles(&self, many: &Many, end: f64, x: &[f64]) -> Vec<Vec<Complex64>> {
        let length = self.train.length();
        let rate = x.iter().map(|x| x.abs().max((x + length).abs())).fold(0.0, f64::max);
        let ends = many.from.iter().skip(1).chain([&end]);
        let panels: Vec<(Oscillating, Vec<Complex64>)> = many
            .from
            .iter()
            .zip(ends)
            .map(|(from, to)| {
                let panel = Oscillating::new(*from..*to, rate);
                let axles = panel.nodes.iter().map(|beta| self.axles(*beta)).collect();
                (panel, axles)
            })
            .collect();
        x.par_iter()
            .map(|x| {
                let mut sums = vec![Complex64::ZERO; many.nodes.first().map_or(0, |node| node.2.len())];
                for ((panel, axles), nodes) in panels.iter().zip(many.nodes.chunks(15)) {
                    let turned = panel.nodes.iter().zip(axles).map(|(beta, a)| a * Complex64::cis(beta * x));
                    for (weight, (_, _, values)) in panel.weights(turned).iter().zip(nodes) {
                        let weight = weight / PI;
                        sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
                    }
                }
                sums
            })
            .collect()
    }
}
