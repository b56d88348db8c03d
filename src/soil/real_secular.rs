//! The Rayleigh and the Love function of undamped ground in real numbers, as `transfer_matrix` has them in complex ones.
//!
//! p and s are real or imaginary, so that e^{±Bh} is a real polynomial of B with real coefficients. Where one is real and one
//! imaginary, d² = (p − s)² is complex and a² = (p + s)² its conjugate: the divided differences of `transfer_matrix` are then
//! taken about n = Re d² instead of d², which leaves their real parts.
//!
//! Source: Dunkin 1965; Buchen & Ben-Hador 1996.

use super::minors::{Exponential, Generator, Minors};
use super::mode_count::{Elastic, RealWaves};
use crate::math::scaling::power_of_two;
use num_complex::Complex64;

/// cosh x and sinh x / x of a real or an imaginary x, both times e^{−Re x}.
#[derive(Clone, Copy)]
struct Hyperbolic {
    /// x²
    square: f64,
    /// |x|
    root: f64,
    /// Half of x: its cosh and |sinh|, times e^{−Re x/2}.
    half: (f64, f64),
    cosh: f64,
    sinhc: f64,
}

impl Hyperbolic {
    fn new(square: f64) -> Self {
        let root = square.abs().sqrt();
        if square > 0.0 {
            // e^{−x} − 1
            let less = (-root).exp_m1();
            let (cosh, sinh) = (1.0 + 0.5 * less, -0.5 * less);
            return Self {
                square,
                root,
                half: (cosh, sinh),
                cosh: cosh * cosh + sinh * sinh,
                sinhc: 2.0 * cosh * sinh / root,
            };
        }
        let (sin, cos) = (0.5 * root).sin_cos();
        let sinhc = if root == 0.0 { 1.0 } else { 2.0 * sin * cos / root };
        Self { square, root, half: (cos, sin), cosh: cos * cos - sin * sin, sinhc }
    }

    /// Re x
    fn growth(&self) -> f64 {
        if self.square > 0.0 { self.root } else { 0.0 }
    }
}

impl Exponential<f64> {
    /// Of vertical wavenumbers whose squares are `p2` > `s2`, over a thickness `h`.
    fn new(p2: f64, s2: f64, h: f64) -> Self {
        let h2 = h * h;
        let (p, s) = (Hyperbolic::new(p2 * h2), Hyperbolic::new(s2 * h2));
        let difference = (p2 - s2) * h2;
        let scale = p.growth() + s.growth();
        let unit = (-scale).exp();
        // d², (cosh d − 1)/d² and sinh d / d, complex where one of p, s is; a²
        let (d2, even1, odd0, a2): (Complex64, Complex64, Complex64, Complex64);
        // (sinh a/a − sinh d/d)/(a² − d²) where a² and d² are well apart
        let odd1;
        if s.square > 0.0 {
            // with d = p − s > 0 and e^{−d} − 1
            let (a, d) = (p.root + s.root, difference / (p.root + s.root));
            let less = (-d).exp_m1();
            let rest = (1.0 - 2.0 * s.half.1).powi(2);
            let sinhc_d = -0.5 * less * (2.0 + less) / d * rest;
            (d2, a2) = ((d * d).into(), (a * a).into());
            (even1, odd0) = ((0.5 * less * less / (d * d) * rest).into(), sinhc_d.into());
            let sinhc_a = (p.root * p.sinhc * s.cosh + s.root * s.sinhc * p.cosh) / a;
            odd1 = (sinhc_a - sinhc_d) / (4.0 * p.root * s.root);
        } else if p.square > 0.0 {
            let half = 0.5 * Complex64::new(p.root, -s.root);
            let sinhc_half = Complex64::new(p.half.1 * s.half.0, -p.half.0 * s.half.1) / half;
            let cosh_half = Complex64::new(p.half.0 * s.half.0, -p.half.1 * s.half.1);
            d2 = 4.0 * half * half;
            a2 = d2.conj();
            (even1, odd0) = (0.5 * sinhc_half * sinhc_half, sinhc_half * cosh_half);
            odd1 = -0.5 * odd0.im / (p.root * s.root);
        } else {
            // i d/2 and its sine, p and s well apart
            let (half, a) = (0.5 * (s.root - p.root), s.root + p.root);
            let sinc = (s.half.1 * p.half.0 - s.half.0 * p.half.1) / half;
            let sinc_d = sinc * (s.half.0 * p.half.0 + s.half.1 * p.half.1);
            (d2, a2) = ((-4.0 * half * half).into(), (-a * a).into());
            (even1, odd0) = ((0.5 * sinc * sinc).into(), sinc_d.into());
            let sinc_a = (p.root * p.sinhc * s.cosh + s.root * s.sinhc * p.cosh) / a;
            odd1 = (sinc_d - sinc_a) / (4.0 * p.root * s.root);
        }
        let (even2, odd1) = if a2.norm_sqr() < 1.0 {
            let (even2, odd1) = series(2.0 * (p.square + s.square), difference * difference);
            (even2 * unit, odd1 * unit)
        } else {
            let even2 = ((0.5 * p.sinhc * s.sinhc - even1) / a2).re;
            // a² − d² = 4ps and a d = p² − s²: the larger of the two divides
            let apart = 16.0 * (p.square * s.square).abs() > difference * difference;
            (even2, if apart { odd1 } else { 0.5 * (p.cosh * s.sinhc - s.cosh * p.sinhc) / difference })
        };
        Self {
            node: d2.re / h2,
            unit,
            even: [even1.re * h2, even2 * (h2 * h2)],
            odd: [odd0.re * h, odd1 * (h2 * h)],
            scale,
        }
    }
}

/// Σ h_{n−2}/(2n)! and Σ h_{n−1}/(2n + 1)! of a², d² with the given sum and product; h_m = Σ a^{2i} d^{2(m−i)}.
fn series(sum: f64, product: f64) -> (f64, f64) {
    let (mut even, mut odd) = (0.0, 0.0);
    let (mut before, mut complete, mut factorial) = (0.0, 1.0, 1.0);
    for m in 0..10 {
        let n = f64::from(m);
        factorial *= if m == 0 { 6.0 } else { (2.0 * n + 2.0) * (2.0 * n + 3.0) };
        odd += complete / factorial;
        even += complete / (factorial * (2.0 * n + 4.0));
        (before, complete) = (complete, sum * complete - product * before);
    }
    (even, odd)
}

/// The Rayleigh function, of waves slower than shear waves in the half-space: zero where P–SV waves travel without load. Times
/// e^{second}.
pub(super) fn rayleigh(waves: &RealWaves, k: f64) -> (f64, f64) {
    let (mut minors, mut unit) = match &waves.half_space {
        Some(elastic) => {
            let base = elastic.half_space(k);
            (Minors([1.0, -base.1, -base.2, base.0, base.determinant()]), 1.0)
        }
        None => (Minors([0.0, 0.0, 0.0, 0.0, 1.0]), 1.0),
    };
    let mut scale = 0.0;
    for (elastic, h) in waves.layers.iter().rev() {
        let e = Exponential::<f64>::new(k * k - elastic.kp2, k * k - elastic.ks2, *h);
        let b = Generator { k, gamma: elastic.gamma, ks2: elastic.ks2 };
        (minors, unit) = (minors.in_unit(unit / elastic.mu).lifted(b, &e), elastic.mu);
        let (factor, log) = power_of_two(minors.0.iter().fold(0.0, |size, m| size.max(m.abs())));
        minors = minors.times(factor);
        scale += e.scale + log;
    }
    (minors.in_unit(unit).0[4], scale)
}

/// The Love function: zero where SH waves travel without load. Times e^{second}.
pub(super) fn love(waves: &RealWaves, k: f64) -> (f64, f64) {
    let base = waves.half_space.as_ref();
    let (mut v, mut t) = base.map_or((0.0, 1.0), |elastic| (1.0, elastic.half_space_across(k)));
    let mut scale = 0.0;
    for (Elastic { mu, ks2, .. }, h) in waves.layers.iter().rev() {
        let square = k * k - ks2;
        let s = Hyperbolic::new(square * h * h);
        // v′ = −t/μ, t′ = −μs²v
        let (below_v, below_t) = (v, t / mu);
        v = below_v * s.cosh + below_t * s.sinhc * h;
        t = mu * (below_t * s.cosh + below_v * square * s.sinhc * h);
        let (factor, log) = power_of_two(v.abs().max(t.abs() / mu));
        (v, t) = (v * factor, t * factor);
        scale += s.growth() + log;
    }
    (t, scale)
}

#[cfg(test)]
mod tests {
    use super::super::transfer_matrix::Waves;
    use super::super::{Base, Elastic as Given, Layer, Material, Profile};
    use super::*;

    #[test]
    fn functions_are_those_in_complex_numbers() {
        let material =
            |shear, poisson| Material::new(Given::ShearPoisson { shear, poisson }, 1800.0, 0.0, 0.0).unwrap();
        let mut worst = 0.0f64;
        for (speeds, poisson) in [([120.0, 200.0], 0.3), ([200.0, 90.0], 0.0), ([150.0, 151.0], 0.499)] {
            for h in [1e-3, 0.1, 1.3, 9.0] {
                let layers = speeds.map(|c| Layer { thickness: h, material: material(c, poisson) }).to_vec();
                for base in [Base::Rigid, Base::HalfSpace(material(260.0, poisson))] {
                    let profile = Profile::new(layers.clone(), base).unwrap();
                    for omega in [0.5, 30.0, 200.0, 2000.0] {
                        let waves = Waves::new(&profile, omega);
                        let real = RealWaves::new(&waves);
                        for slowness in [1.001, 1.2, 1.7, 2.3, 4.0] {
                            let k = slowness * omega / 260.0;
                            for (exact, got) in [
                                (waves.rayleigh(k.into()), rayleigh(&real, k)),
                                (waves.love(k.into()), love(&real, k)),
                            ] {
                                // what a step of 1e-6 in k changes: the size of the function near a zero
                                let near = |f: (Complex64, f64)| f.0 * (f.1 - exact.1).exp();
                                let size =
                                    near(waves.rayleigh((k * 1.001).into())).norm().max(exact.0.norm());
                                let got = got.0 * (got.1 - exact.1).exp();
                                worst = worst.max((got - exact.0.re).abs() / size);
                            }
                        }
                    }
                }
            }
        }
        // measured 2.5e-13
        assert!(worst < 1e-11, "{worst:e}");
    }
}
