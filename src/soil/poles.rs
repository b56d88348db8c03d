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
const SHARE: f64 = 0.1;

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

    /// Poles, tail, κ₀ and the error.
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
        let waves = outline.wavenumbers.iter().copied().chain([kappa0, 3.0 * kappa0, 9.0 * kappa0]);
        let mut angles: Vec<f64> = waves.map(|k| (k / c.sqrt()).atan()).chain([0.0, FRAC_PI_2]).collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| *a - *b < 0.03);
        angles.pop();
        angles.push(FRAC_PI_2);
        let (rational, samples) = Rational::adaptive(samples, &angles, MOST)?;
        // ζ − p = −(p²/c)(κ − κ_p) near the pole
        // a pole beside its zero, of whom no sample feels a thousandth of what is allowed, stands for nothing
        let felt = |p: Complex64, residue: Complex64| {
            samples.iter().any(|s| residue.norm() > 1e-3 * s.allowed * (s.z - p).norm())
        };
        let poles = rational.poles()?.into_iter().filter(|(p, residue)| felt(*p, *residue));
        let (kappa, residue) = poles.map(|(p, residue)| (c / p - c, -residue * c / (p * p))).unzip();
        let sum = PoleSum { kappa, residue };
        let error = |s: &Sample| {
            let k = (c / s.z - c).max(0.0).sqrt();
            (sum.at(k) - s.value).norm() / s.allowed
        };
        // written so that NaN is refused
        let error =
            samples.iter().filter(|s| s.z > 0.0).map(error).fold(0.0, |a, b| if b <= a { a } else { b });
        error.is_finite().then_some((sum, tail, kappa0, error * accuracy))
    }

    /// By what the relative error grows where waves fade over a `distance` [m]: poles in place of branch cuts do not fade quite as these
    /// do, measured like e^{0.6 n} at n nepers.
    fn fading(&self, beta: f64, distance: f64) -> f64 {
        let slowest = self.ground.outline().wavenumbers.last().copied().unwrap_or(0.0);
        let nepers = (beta * beta - slowest * slowest).max(0.0).sqrt() * distance.max(0.0);
        (0.7 * nepers).exp()
    }

    /// A closed form as an estimate, `tail` the integrals of the tail's terms.
    fn estimate(&self, sum: Complex64, tail: (f64, f64), relative: f64) -> Estimate {
        let value = sum + strip::known(self.tail, tail);
        let converged = self.error <= relative && value.is_finite();
        Estimate { value, error: self.error * value.norm(), count: self.sum.kappa.len(), converged }
    }
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
        let sums = self.sum.receivers(beta, half_width, y);
        let one = |(y, sum): (&f64, Complex64)| {
            let tail = strip::receiver_tail_integrals(beta.hypot(self.kappa0), half_width, y.abs());
            let closed = self.estimate(sum, tail, relative);
            let error = closed.error * self.fading(beta, y.abs() - half_width);
            Estimate {
                error,
                converged: closed.converged && error <= relative * closed.value.norm(),
                ..closed
            }
        };
        y.iter().zip(sums).map(one).collect()
    }

    fn modes(&self) -> Result<Vec<Pole>, SoilError> {
        self.ground.modes()
    }
}
