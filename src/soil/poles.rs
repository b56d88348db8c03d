//! A prepared ground whose G_zz, less its static tail, is a sum over poles in κ = k²: strips and receivers at any β in closed form, for
//! the price of a few hundred values of G.
//!
//! ```text
//! G_zz(k) ≈ A/√(k² + κ₀²) + B/(k² + κ₀²)^{3/2} + Σ r_j/(k² − κ_j)
//! ```
//!
//! The poles are those of a rational approximation in ζ = c/(c + κ), which maps all wavenumbers to 0 … 1: the ground's wave modes, and
//! others that stand for its branch cuts. Those that stand for nothing, and any fault of theirs, show in the error: it is that of the
//! sum itself, on samples twice as fine as the approximation needed.

use super::pole_sum::PoleSum;
use super::strip::{self, Outline, Strip};
use super::{Compliance, Pole, PreparedGround, SoilError, SurfaceCompliance};
use crate::math::quadrature::Estimate;
use crate::math::rational::{Rational, Sample};
use num_complex::Complex64;
use std::f64::consts::FRAC_PI_2;

/// Support points after which poles are given up: damped grounds take 10 to 35.
const MOST: usize = 48;
/// What the approximation is made to, of the accuracy asked.
const SHARE: f64 = 0.02;

/// G_zz of a ground by its poles; everything but strips and receivers is asked of the ground itself.
pub struct Poles {
    ground: Box<dyn PreparedGround>,
    sum: PoleSum,
    tail: (Complex64, Complex64),
    kappa0: f64,
    /// Largest error of G_zz relative to its modulus.
    error: f64,
}

impl Poles {
    /// `ground` at ω ≠ 0 with G_zz to `accuracy` of its modulus at all wavenumbers; the ground itself where no few poles do that, as
    /// those of undamped ground.
    ///
    /// Accuracy: of strips and receivers, measured against quadrature, that of G_zz (test `cross_solver::poles`).
    ///
    /// # Errors
    /// The ground, unchanged.
    pub fn new(ground: Box<dyn PreparedGround>, accuracy: f64) -> Result<Self, Box<dyn PreparedGround>> {
        match Self::found(ground.as_ref(), SHARE * accuracy) {
            Some((sum, tail, kappa0, error)) if error <= accuracy => {
                Ok(Self { ground, sum, tail, kappa0, error })
            }
            _ => Err(ground),
        }
    }

    /// Poles, tail, κ₀ and the error over the samples; None where it is no number.
    fn found(
        ground: &dyn PreparedGround,
        accuracy: f64,
    ) -> Option<(PoleSum, (Complex64, Complex64), f64, f64)> {
        let outline = ground.outline();
        let slowest = outline.wavenumbers.last().copied().filter(|k| *k > 0.0)?;
        let kappa0 = outline.top_thickness.map_or(0.0, f64::recip).max(slowest);
        let tail = strip::tail(outline, kappa0);
        // between the waves and the layer
        let c = kappa0 * slowest;
        let samples = |angles: &[f64]| {
            // k = √c tan θ, ζ = cos² θ
            let k: Vec<f64> = angles.iter().map(|t| c.sqrt() * t.tan()).collect();
            let g = ground.u_zz_many(&k);
            let sample = |(k, g): (&f64, Complex64)| Sample {
                z: c / (c + k * k),
                value: g - strip::tail_at(tail, kappa0, *k),
                allowed: accuracy * g.norm(),
            };
            let mut samples: Vec<Sample> = k.iter().zip(g).map(sample).collect();
            // nothing but the tail is left of the shortest waves
            for (sample, _) in samples.iter_mut().zip(angles).filter(|(_, t)| **t >= FRAC_PI_2) {
                *sample = Sample { z: 0.0, value: Complex64::ZERO, allowed: f64::INFINITY };
            }
            samples
        };
        let angles = first_angles(outline, kappa0, c);
        let (rational, samples) = Rational::adaptive(samples, &angles, MOST)?;
        // a pole beside its zero, of whom no sample feels a thousandth of what is allowed, stands for nothing
        let felt = |p: Complex64, residue: Complex64| {
            samples.iter().any(|s| residue.norm() > 1e-3 * s.allowed * (s.z - p).norm())
        };
        let poles = rational.poles()?.into_iter().filter(|(p, residue)| felt(*p, *residue));
        // ζ − p = −(p²/c)(κ − κ_p) near the pole
        let (kappa, residue) = poles.map(|(p, residue)| (c / p - c, -residue * c / (p * p))).unzip();
        let sum = PoleSum { kappa, residue };
        let error = |s: &Sample| {
            let k = (c / s.z - c).max(0.0).sqrt();
            (sum.at(k) - s.value).norm() / s.allowed
        };
        let errors: Vec<f64> = samples.iter().filter(|s| s.z > 0.0).map(error).collect();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        errors.iter().all(|e| e.is_finite()).then_some((sum, tail, kappa0, worst * accuracy))
    }

    /// What fades of an error over a `distance` [m]: poles in place of branch cuts fade like e^{−0.4 n} where the waves do like e^{−n}.
    fn fading(&self, beta: f64, distance: f64) -> f64 {
        let slowest = self.ground.outline().wavenumbers.last().copied().unwrap_or(0.0);
        let nepers = (beta * beta - slowest * slowest).max(0.0).sqrt() * distance.max(0.0);
        (-0.3 * nepers).exp()
    }

    /// A closed form as an estimate, `tail` the integrals of the tail's terms.
    fn estimate(&self, sum: Complex64, tail: (f64, f64), relative: f64) -> Estimate {
        let value = sum + strip::known(self.tail, tail);
        let converged = self.error <= relative && value.is_finite();
        Estimate { value, error: self.error * value.norm(), count: self.sum.kappa.len(), converged }
    }
}

/// θ, k = √c tan θ, of the first support points: at rest, at the waves, where layers end to be felt, at infinity.
fn first_angles(outline: &Outline, kappa0: f64, c: f64) -> Vec<f64> {
    // apart enough for samples between them
    const APART: f64 = 0.03;
    let felt = outline.wavenumbers.iter().copied().chain([kappa0, 3.0 * kappa0, 9.0 * kappa0]);
    let mut angles: Vec<f64> = felt.map(|k| (k / c.sqrt()).atan()).chain([0.0]).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup_by(|a, b| *a - *b < APART);
    angles.retain(|theta| FRAC_PI_2 - theta > APART);
    angles.push(FRAC_PI_2);
    angles
}

impl PreparedGround for Poles {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        self.ground.surface(k)
    }

    fn u_zz(&self, k: f64) -> Complex64 {
        self.ground.u_zz(k)
    }

    fn u_zz_many(&self, k: &[f64]) -> Vec<Complex64> {
        self.ground.u_zz_many(k)
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        self.ground.at_depths(k, source)
    }

    fn outline(&self) -> &Outline {
        self.ground.outline()
    }

    /// In closed form.
    fn strip(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        let tail = strip::tail_integrals(beta.hypot(self.kappa0), strip);
        self.estimate(self.sum.strip(beta, strip), tail, relative)
    }

    /// In closed form; by quadrature where so little arrives that the error may be more than `relative` of it.
    fn receiver(&self, beta: f64, half_width: f64, y: f64, relative: f64) -> Estimate {
        let closed = self.receivers(beta, half_width, &[y], relative)[0];
        if closed.converged { closed } else { self.ground.receiver(beta, half_width, y, relative) }
    }

    /// In closed form.
    fn receivers(&self, beta: f64, half_width: f64, y: &[f64], relative: f64) -> Vec<Estimate> {
        // G is wrong by its error everywhere, and R by that of what it is right under the load, less what fades on the way
        let nearest = y.iter().map(|y| y.abs()).fold(f64::INFINITY, f64::min);
        let under = if half_width > 0.0 { 0.0 } else { 0.1 * nearest };
        let places: Vec<f64> = y.iter().copied().chain([under]).collect();
        let sums = self.sum.receivers(beta, half_width, &places);
        let one = |(y, sum): (&f64, Complex64)| {
            let tail = strip::receiver_tail_integrals(beta.hypot(self.kappa0), half_width, y.abs());
            self.estimate(sum, tail, relative)
        };
        let mut all: Vec<Estimate> = places.iter().zip(sums).map(one).collect();
        let whole = all.pop().map_or(0.0, |under| under.error);
        for (closed, y) in all.iter_mut().zip(y) {
            closed.error = closed.error.max(whole * self.fading(beta, y.abs() - half_width));
            closed.converged = closed.error <= relative * closed.value.norm();
        }
        all
    }

    fn modes(&self) -> Result<Vec<Pole>, SoilError> {
        self.ground.modes()
    }
}
