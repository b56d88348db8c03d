//! The direct stiffness method for eight wavenumbers at once, real or complex: what integrals over k spend their time on.
//!
//! The formulas are those of `layer_stiffness`, its scalar code their witness; series and limits are computed only where one of the
//! eight needs them. Accuracy: as `direct_stiffness`, with which it agrees to 1e-11 of G (test `laws::batch`).

use super::wave::Wave;
use crate::count::{self, Work};
use crate::math::lanes::{LANES, Lanes};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;

/// A symmetric matrix of two rows: (1,1), (1,2), (2,2).
type Symmetric<S> = [Lanes<S>; 3];

/// Layers on their base at one ω ≥ 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Batch<'a> {
    /// Waves and thickness [m], top first.
    pub layers: &'a [(Wave, f64)],
    /// None for a rigid base.
    pub half_space: Option<&'a Wave>,
}

/// Compliance of the surface and what it may have cost.
#[derive(Clone, Copy)]
pub(super) struct InPlane<S: Simd> {
    /// u_xx, u_xz (real where nothing is damped), u_zz [m/Pa].
    pub compliance: Symmetric<S>,
    /// Largest stiffness of a layer times the largest compliance: digits of G are lost in proportion.
    pub cost: f64x8<S>,
}

/// Places of u_xz and u_zz among these.
pub(super) const XZ: usize = 1;
pub(super) const ZZ: usize = 2;

impl Batch<'_> {
    /// The element at one place [m/Pa] at `k` [rad/m]; None where one has lost too many digits, its cost above `most`. The place is known
    /// when this is compiled: the others are then not computed.
    pub fn element<const PLACE: usize>(&self, k: &[f64], most: f64) -> Vec<Option<Complex64>> {
        dispatch!(Level::new(), simd => self.all::<_, PLACE>(simd, k, most))
    }

    #[inline(always)]
    fn all<S: Simd, const PLACE: usize>(&self, simd: S, k: &[f64], most: f64) -> Vec<Option<Complex64>> {
        let mut all = Vec::with_capacity(k.len());
        for eight in k.chunks(LANES) {
            let k = f64x8::from_fn(simd, |i| eight[i.min(eight.len() - 1)]);
            let none = f64x8::splat(simd, 0.0);
            let found = self.in_plane(simd, Lanes { re: k, im: none }, Lanes { re: k * k, im: none });
            let lane = |i: usize| (found.cost[i] < most).then(|| found.compliance[PLACE].lane(i));
            all.extend((0..eight.len()).map(lane));
        }
        all
    }

    /// u_xz/k and u_zz at squares of k, complex; None where one has lost too many digits, its cost above `most`.
    pub fn at_squares(&self, k2: &[Complex64], most: f64) -> Option<Vec<(Complex64, Complex64)>> {
        dispatch!(Level::new(), simd => self.all_at_squares(simd, k2, most))
    }

    #[inline(always)]
    fn all_at_squares<S: Simd>(
        &self,
        simd: S,
        k2: &[Complex64],
        most: f64,
    ) -> Option<Vec<(Complex64, Complex64)>> {
        let mut all = Vec::with_capacity(k2.len());
        for eight in k2.chunks(LANES) {
            let of = |i: usize| eight[i.min(eight.len() - 1)];
            let k2 = Lanes { re: f64x8::from_fn(simd, |i| of(i).re), im: f64x8::from_fn(simd, |i| of(i).im) };
            let k = k2.sqrt_decaying();
            let found = self.in_plane(simd, k, k2);
            if !found.cost.simd_lt(most).all_true() {
                return None;
            }
            let horizontal = found.compliance[XZ] * k.inv();
            all.extend((0..eight.len()).map(|i| (horizontal.lane(i), found.compliance[ZZ].lane(i))));
        }
        Some(all)
    }

    /// In-plane compliance at the surface at `k` and its square: S ← M(B − C (B + S)⁻¹ C)M from the base upward, inverted.
    #[inline(always)]
    pub fn in_plane<S: Simd>(&self, simd: S, k: Lanes<S>, k2: Lanes<S>) -> InPlane<S> {
        count::add(Work::Compliances, LANES);
        let mut below = None;
        // no closure: called from several places it would be a function of its own, and know nothing of the instruction set
        if let Some(wave) = self.half_space {
            below = Some(half_space(simd, wave, k, k2));
        }
        let mut largest = f64x8::splat(simd, 0.0);
        for (wave, thickness) in self.layers.iter().rev() {
            let (direct, cross) = layer(simd, wave, *thickness, k, k2);
            largest = largest.max(direct[0].l1_norm()).max(direct[2].l1_norm());
            let [xx, xz, zz] = match below {
                Some(below) => condensed(direct, cross, below),
                None => direct,
            };
            below = Some([xx, -xz, zz]);
        }
        let compliance = inverse(below.unwrap_or([Lanes::real(simd, 0.0); 3]));
        let size = compliance[0].l1_norm().max(compliance[2].l1_norm());
        InPlane { compliance, cost: size * largest }
    }
}

#[inline(always)]
fn inverse<S: Simd>([a, b, c]: Symmetric<S>) -> Symmetric<S> {
    let determinant = (a * c - b * b).inv();
    [c * determinant, -(b * determinant), a * determinant]
}

/// B − C (B + S)⁻¹ C, whatever it is symmetric.
#[inline(always)]
fn condensed<S: Simd>(b: Symmetric<S>, c: Symmetric<S>, s: Symmetric<S>) -> Symmetric<S> {
    let [i, j, k] = inverse([b[0] + s[0], b[1] + s[1], b[2] + s[2]]);
    let (t00, t01) = (i * c[0] + j * c[1], i * c[1] + j * c[2]);
    let (t10, t11) = (j * c[0] + k * c[1], j * c[1] + k * c[2]);
    [b[0] - (c[0] * t00 + c[1] * t10), b[1] - (c[0] * t01 + c[1] * t11), b[2] - (c[1] * t01 + c[2] * t11)]
}

/// As [`LayerStiffness::half_space`](super::layer_stiffness::LayerStiffness).
#[inline(always)]
fn half_space<S: Simd>(simd: S, wave: &Wave, k: Lanes<S>, k2: Lanes<S>) -> Symmetric<S> {
    let all = |z: Complex64| Lanes::all(simd, z);
    let (p, s) = ((k2 - all(wave.kp2)).sqrt_decaying(), (k2 - all(wave.ks2)).sqrt_decaying());
    let inv_r = (p + s) * (p + all(wave.gamma) * s).inv();
    let mu = all(wave.mu);
    [mu * p * inv_r, mu * k * (inv_r - Lanes::real(simd, 2.0)), mu * s * inv_r]
}

/// `direct` and `cross` of [`LayerStiffness::layer`](super::layer_stiffness::LayerStiffness), term by term, and as long for the same reason.
#[inline(always)]
fn layer<S: Simd>(simd: S, wave: &Wave, h: f64, k: Lanes<S>, k2: Lanes<S>) -> (Symmetric<S>, Symmetric<S>) {
    let all = |z: Complex64| Lanes::all(simd, z);
    let (difference, inv_difference) = (wave.ks2 - wave.kp2, all(wave.inv_difference));
    let (p2, s2) = (k2 - all(wave.kp2), k2 - all(wave.ks2));
    let (p, s) = (p2.sqrt_decaying(), s2.sqrt_decaying());
    let (ph, sh) = (p.times(h), s.times(h));
    let (e_p, e_s) = (ph.exp_minus(), sh.exp_minus());
    let (inv_p, inv_s) = (e_p.one_plus().inv(), e_s.one_plus().inv());
    let f_p = (ph.one_minus_exp_over(e_p) * inv_p).times(h);
    let f_s = (sh.one_minus_exp_over(e_s) * inv_s).times(h);
    let sech_p = (e_p * inv_p * inv_p).times(4.0);
    let sech_s = (e_s * inv_s * inv_s).times(4.0);

    let sum = p + s;
    let inv_sum = sum.inv();
    let x = (all(difference) * inv_sum).times(h);
    let mut q = (e_s - e_p) * sum * inv_difference;
    let small = x.norm_sqr().simd_le(0.04);
    if small.any_true() {
        q = (e_s * x.one_minus_exp_series()).times(h).or(q, small);
    }
    let inv_w = inv_p * inv_s;
    let mut f = (f_p - f_s) * inv_difference;
    let close = (p2.norm_sqr() * 0.0625).simd_ge(difference.norm_sqr());
    if close.any_true() {
        f = (((s * q * inv_w).times(2.0) - s * f_s) * (p * s * sum).inv()).or(f, close);
    }
    let both = sum.times(h);
    let mut ratio = (e_p * e_s).one_minus() * inv_sum;
    let small = both.norm_sqr().simd_le(0.04);
    if small.any_true() {
        ratio = both.one_minus_exp_series().times(h).or(ratio, small);
    }
    let sech = (q * inv_w * inv_w * ratio).times(-4.0);

    let gamma = all(wave.gamma);
    let rest = all(1.0 - wave.gamma) * k2;
    let d_even = gamma * f_p - rest * f;
    let d_odd = f_s + rest * f;
    let inv_both = (d_even * d_odd).inv();
    let (inv_even, inv_odd) = (d_odd * inv_both, d_even * inv_both);
    let ff = f_p * f_s;
    let half = all(0.5 * wave.mu);
    let off = half * k * (Lanes::real(simd, 4.0) - f_s * inv_even - f_p * inv_odd);
    let direct = [half * (p2 * ff * inv_even + inv_odd), off, half * (inv_even + s2 * ff * inv_odd)];
    let scale = half * inv_both;
    let g = rest * (sech_p * f - f_p * sech);
    let off = scale * k * all(1.0 - wave.gamma) * sech;
    (direct, [scale * (g - gamma * f_p * sech_s), off, scale * (g + f_s * sech_p)])
}
