//! Transfer matrices: the compound (fast delta) matrix, right for every kh. Haskell's product stands in [`super::haskell`].
//!
//! The state y = (u, w, t, r) with u_x = i u, τ_xz = iμt, σ_zz = μr obeys y′ = A y, with
//!
//! ```text
//!     |  0            −k      1           0 |
//! A = | (1 − 2γ)k      0      0           γ |        eigenvalues ±p, ±s,  γ = (c_s/c_p)²
//!     | 4(1−γ)k² − k_s²  0    0   −(1 − 2γ)k |
//!     |  0           −k_s²    k           0 |
//! ```
//!
//! Haskell (1953) multiplies exp(Ah) layer by layer; of the two solutions carried along, the faster growing one swamps
//! the other, and their difference is the answer. The compound matrix carries instead the 2 × 2 minors of the pair,
//! which obey m′ = B m with eigenvalues ±(p + s), ±(p − s), 0; of the six, m_wr = −m_ut, so five remain. Both exponentials
//! are polynomials in A and B (Cayley–Hamilton) whose coefficients are divided differences of cosh and sinh, regular
//! where P and S waves merge: ω = 0 is no exception. The popular fast delta matrix divides by k_s⁴ instead.
//!
//! Source: Haskell 1953; Dunkin 1965; Buchen & Ben-Hador 1996. Surface only.

use super::layer_stiffness::LayerStiffness;
use super::minors::{Exponential, Generator, Minors};
use super::strip::Outline;
use super::wave::Wave;
use super::{Base, Compliance, GroundSolver, PreparedGround, Profile, SoilError, SurfaceCompliance};
use crate::math::complex::{I, sqrt_decaying};
use crate::math::scaling::power_of_two;
use nalgebra::Matrix2;
use num_complex::Complex64;

/// The compound matrix method; it has no settings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TransferMatrix;

/// cosh z and sinh z / z, both times e^{−Re z}, for Re z ≥ 0.
#[inline]
fn hyperbolic(z: Complex64) -> (Complex64, Complex64) {
    let up = Complex64::cis(z.im);
    let down = up.conj() * (-2.0 * z.re).exp();
    let sinhc = if z.norm_sqr() < 0.01 {
        // Σ z²ⁿ/(2n + 1)!, to 0.1¹⁰/11! = 3e-18
        let x = z * z;
        let series = 1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0 * (1.0 + x / 72.0)));
        series * (-z.re).exp()
    } else {
        0.5 * (up - down) / z
    };
    (0.5 * (up + down), sinhc)
}

impl Exponential<Complex64> {
    /// For vertical wavenumbers p, s and thickness h, with divided differences of cosh √x h over 0, d², a² and of sinh(√x h)/√x over d²,
    /// a², where a = p + s, d = p − s.
    fn new(p: Complex64, s: Complex64, difference: Complex64, h: f64) -> Self {
        let (p, s) = (p * h, s * h);
        let a = p + s;
        // p − s from p² − s², free of cancellation; both vanish at k = ω = 0
        let d = if a == Complex64::ZERO { a } else { difference * (h * h) / a };
        let unit = (-a.re).exp();
        let (a2, d2) = (a * a, d * d);
        let half = if d.re < 0.0 { -0.5 * d } else { 0.5 * d };
        // sinh²(d/2)/(d/2)² and sinh d / d, decaying by e^{−|Re d|} already; the rest of the scale
        let rest = (2.0 * half.re - a.re).exp();
        let (cosh_half, sinhc_half) = hyperbolic(half);
        let half_square = 0.5 * sinhc_half * sinhc_half * rest;
        let sinhc_d = sinhc_half * cosh_half * rest;
        let (even2, odd1);
        if a.norm_sqr() < 1.0 {
            // Σ h_{n−2}(a², d²)/(2n)! and Σ h_{n−1}(a², d²)/(2n + 1)!, h_m = Σ a^{2i} d^{2(m−i)}
            let (mut even, mut odd) = (Complex64::ZERO, Complex64::ZERO);
            let (mut power, mut complete, mut factorial) = (Complex64::ONE, Complex64::ONE, 1.0);
            for m in 0..10 {
                let n = f64::from(m);
                factorial *= if m == 0 { 6.0 } else { (2.0 * n + 2.0) * (2.0 * n + 3.0) };
                odd += complete / factorial;
                even += complete / (factorial * (2.0 * n + 4.0));
                power *= a2;
                complete = complete * d2 + power;
            }
            (even2, odd1) = (even * unit, odd * unit);
        } else {
            let (cosh_p, sinhc_p) = hyperbolic(p);
            let (cosh_s, sinhc_s) = hyperbolic(s);
            even2 = (0.5 * sinhc_p * sinhc_s - half_square) / a2;
            // a² − d² = 4ps and a d = p² − s²: the larger of the two divides
            let ps = p * s;
            odd1 = if 4.0 * ps.norm_sqr() > (a * d).norm_sqr() {
                // of the same exponentials as even₂: where they turn often, even and odd must turn alike
                let sinhc_a = (p * sinhc_p * cosh_s + s * sinhc_s * cosh_p) / a;
                (sinhc_a - sinhc_d) / (4.0 * ps)
            } else {
                0.5 * (cosh_p * sinhc_s - cosh_s * sinhc_p) / (a * d)
            };
        }
        let h2 = h * h;
        Self {
            node: d2 / h2,
            unit,
            even: [half_square * h2, even2 * (h2 * h2)],
            odd: [sinhc_d * h, odd1 * (h2 * h)],
            scale: a.re,
        }
    }
}

/// The larger part of z: what scales are taken from, at most √2 less than |z|.
fn larger(z: &Complex64) -> f64 {
    z.re.abs().max(z.im.abs())
}

/// Layers and base at one ω ≥ 0, for any real or complex wavenumber.
#[derive(Clone, Debug)]
pub(super) struct Waves {
    /// Waves and thickness, top first.
    pub layers: Vec<(Wave, f64)>,
    /// None for a rigid base.
    pub half_space: Option<Wave>,
}

impl Waves {
    pub fn new(profile: &Profile, omega: f64) -> Self {
        Self {
            layers: profile.layers().iter().map(|l| (Wave::new(&l.material, omega), l.thickness)).collect(),
            half_space: match profile.base() {
                Base::HalfSpace(material) => Some(Wave::new(&material, omega)),
                Base::Rigid => None,
            },
        }
    }

    /// The same where ω is `factor` times as large.
    pub fn scaled(&self, factor: f64) -> Self {
        let square = factor * factor;
        let scaled = |wave: &Wave| Wave {
            ks2: wave.ks2 * square,
            kp2: wave.kp2 * square,
            inv_difference: wave.inv_difference / square,
            ..*wave
        };
        Self {
            layers: self.layers.iter().map(|(wave, h)| (scaled(wave), *h)).collect(),
            half_space: self.half_space.as_ref().map(scaled),
        }
    }

    /// Minors at the surface, tractions in units of the top layer's μ, and the logarithm of the factor divided out.
    fn in_plane(&self, k: Complex64) -> (Minors<Complex64>, f64) {
        let (o, one) = (Complex64::ZERO, Complex64::ONE);
        // downward solutions: displacements I, tractions −K; on rock no displacement, tractions I
        let (mut minors, mut unit) = match &self.half_space {
            Some(wave) => {
                let stiffness = LayerStiffness::<2>::half_space_at(wave, k);
                let (a, b, c) = (stiffness[(0, 0)], stiffness[(0, 1)], stiffness[(1, 1)]);
                (Minors([one, -b, -c, a, a * c - b * b]), one)
            }
            None => (Minors([o, o, o, o, one]), one),
        };
        let mut scale = 0.0;
        for (wave, h) in self.layers.iter().rev() {
            let (p, s) = (sqrt_decaying(k * k - wave.kp2), sqrt_decaying(k * k - wave.ks2));
            let e = Exponential::<Complex64>::new(p, s, wave.ks2 - wave.kp2, *h);
            let b = Generator { k, gamma: wave.gamma, ks2: wave.ks2 };
            (minors, unit) = (minors.in_unit(unit / wave.mu).lifted(b, &e), wave.mu);
            let (factor, log) = power_of_two(minors.0.iter().map(larger).fold(0.0, f64::max));
            minors = minors.times(factor);
            scale += e.scale + log;
        }
        (minors.in_unit(unit), scale)
    }

    /// Anti-plane: displacement and −traction at the surface, and the logarithm of the factor divided out.
    pub fn anti_plane(&self, k: Complex64) -> (Complex64, Complex64, f64) {
        let k2 = k * k;
        let (mut v, mut t) = match &self.half_space {
            Some(wave) => (Complex64::ONE, wave.mu * sqrt_decaying(k2 - wave.ks2)),
            None => (Complex64::ZERO, Complex64::ONE),
        };
        let mut scale = 0.0;
        for (wave, h) in self.layers.iter().rev() {
            let s = sqrt_decaying(k2 - wave.ks2);
            let (cosh, sinhc) = hyperbolic(s * *h);
            // v′ = −t/μ, t′ = −μs²v, t positive as a traction on the layer
            let (below_v, below_t) = (v, t / wave.mu);
            v = below_v * cosh + below_t * sinhc * *h;
            t = wave.mu * (below_t * cosh + below_v * s * s * sinhc * *h);
            let (factor, log) = power_of_two(larger(&v).max(larger(&t) / wave.mu.re));
            v *= factor;
            t *= factor;
            scale += s.re * h + log;
        }
        (v, t, scale)
    }

    /// The Rayleigh function: zero where P–SV waves travel without load. Times e^{second}.
    pub fn rayleigh(&self, k: Complex64) -> (Complex64, f64) {
        let (minors, scale) = self.in_plane(k);
        (minors.0[4], scale)
    }

    /// The Love function: zero where SH waves travel without load. Times e^{second}.
    pub fn love(&self, k: Complex64) -> (Complex64, f64) {
        let (_, t, scale) = self.anti_plane(k);
        (t, scale)
    }

    /// G_zz = m_wt/m_tr
    #[inline]
    pub fn u_zz(&self, k: Complex64) -> Complex64 {
        let (minors, _) = self.in_plane(k);
        minors.0[3] / minors.0[4]
    }

    /// G_zz and its like.
    fn surface(&self, k: f64) -> (Matrix2<Complex64>, Complex64) {
        let (minors, _) = self.in_plane(Complex64::from(k));
        let [_, ut, ur, wt, tr] = minors.0;
        let (v, t, _) = self.anti_plane(Complex64::from(k));
        (Matrix2::new(-ur / tr, ut / tr, ut / tr, wt / tr), v / t)
    }
}

/// The compound matrix method at one ω.
struct TransferMatrixAt {
    waves: Waves,
    negative: bool,
    /// Prepared depths, all of them 0.
    depths: usize,
    outline: Outline,
}

impl GroundSolver for TransferMatrix {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        super::surface_only("transfer-matrix", depths)?;
        Ok(Box::new(TransferMatrixAt {
            waves: Waves::new(profile, omega.abs()),
            negative: omega < 0.0,
            depths: depths.len(),
            outline: Outline::new(profile, omega),
        }))
    }
}

/// Surface compliances from the scaled real form, for a negative frequency conjugated.
pub(super) fn surface_compliance(
    g: &Matrix2<Complex64>,
    u_yy: Complex64,
    negative: bool,
) -> SurfaceCompliance {
    let signed = |z: Complex64| if negative { z.conj() } else { z };
    // u_x = i u
    SurfaceCompliance {
        u_zz: signed(g[(1, 1)]),
        u_xx: signed(g[(0, 0)]),
        u_xz: I * signed(g[(0, 1)]),
        u_yy: signed(u_yy),
    }
}

impl PreparedGround for TransferMatrixAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let (g, u_yy) = self.waves.surface(k);
        surface_compliance(&g, u_yy, self.negative)
    }

    #[inline]
    fn u_zz(&self, k: f64) -> Complex64 {
        let g = self.waves.u_zz(Complex64::from(k));
        if self.negative { g.conj() } else { g }
    }

    fn at_depths(&self, k: f64, _source: usize) -> Vec<Compliance> {
        vec![self.surface(k).into(); self.depths]
    }

    fn outline(&self) -> &Outline {
        &self.outline
    }
}
