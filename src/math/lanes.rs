//! Eight complex numbers at once: roots and exponentials in the vector instructions the machine has.
//!
//! Everything here is inlined into whoever called `fearless_simd::dispatch!`, once for every instruction set. The scalar functions of
//! `math::complex` are its witness.

use fearless_simd::prelude::*;
use fearless_simd::{f64x8, mask64x8, u64x8};
use num_complex::Complex64;
use std::ops::{Add, Mul, Neg, Sub};

/// How many.
pub(crate) const LANES: usize = 8;

/// Rounds to an integer, which stands in the lowest bits of the sum: 1.5 · 2⁵².
const MAGIC: f64 = 6_755_399_441_055_744.0;

/// Eight complex numbers, real parts and imaginary parts apart.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd> {
    pub re: f64x8<S>,
    pub im: f64x8<S>,
}

impl<S: Simd> Lanes<S> {
    /// The same in every lane.
    #[inline(always)]
    pub fn all(simd: S, z: Complex64) -> Self {
        Self { re: f64x8::splat(simd, z.re), im: f64x8::splat(simd, z.im) }
    }

    /// A real number in every lane.
    #[inline(always)]
    pub fn real(simd: S, x: f64) -> Self {
        Self { re: f64x8::splat(simd, x), im: f64x8::splat(simd, 0.0) }
    }

    /// One of them.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Complex64 {
        Complex64::new(self.re[i], self.im[i])
    }

    /// a z
    #[inline(always)]
    pub fn times(self, a: f64) -> Self {
        Self { re: self.re * a, im: self.im * a }
    }

    /// 1 + z
    #[inline(always)]
    pub fn one_plus(self) -> Self {
        Self { re: self.re + 1.0, im: self.im }
    }

    /// 1 − z
    #[inline(always)]
    pub fn one_minus(self) -> Self {
        Self { re: 1.0 - self.re, im: -self.im }
    }

    /// |z|²
    #[inline(always)]
    pub fn norm_sqr(self) -> f64x8<S> {
        self.re.mul_add(self.re, self.im * self.im)
    }

    /// |Re z| + |Im z|
    #[inline(always)]
    pub fn l1_norm(self) -> f64x8<S> {
        self.re.abs() + self.im.abs()
    }

    /// 1/z
    #[inline(always)]
    pub fn inv(self) -> Self {
        let inverse = 1.0 / self.norm_sqr();
        Self { re: self.re * inverse, im: -self.im * inverse }
    }

    /// These where `mask`, else `other`.
    #[inline(always)]
    pub fn or(self, other: Self, mask: mask64x8<S>) -> Self {
        Self { re: mask.select(self.re, other.re), im: mask.select(self.im, other.im) }
    }

    /// As [`sqrt_decaying`](super::complex::sqrt_decaying).
    #[inline(always)]
    pub fn sqrt_decaying(self) -> Self {
        let modulus = self.norm_sqr().sqrt();
        let large = ((modulus + self.re.abs()) * 0.5).sqrt();
        let small = self.im.abs() * 0.5 / large.max(f64::MIN_POSITIVE);
        let right = self.re.simd_ge(0.0);
        let re = right.select(large, small);
        let im = right.select(small, large);
        Self { re, im: im.copysign(self.im) }
    }

    /// e^{−z}
    #[inline(always)]
    pub fn exp_minus(self) -> Self {
        let modulus = exp(-self.re);
        let (sin, cos) = sin_cos(self.im);
        Self { re: modulus * cos, im: -modulus * sin }
    }

    /// (1 − e^{−z})/z given e^{−z}, as [`one_minus_exp_over`](super::complex::one_minus_exp_over).
    #[inline(always)]
    pub fn one_minus_exp_over(self, exp_minus_z: Self) -> Self {
        let plain = exp_minus_z.one_minus() * self.inv();
        let small = self.norm_sqr().simd_le(0.04);
        if small.any_true() { self.one_minus_exp_series().or(plain, small) } else { plain }
    }

    /// The same for |z| ≤ 0.2, as [`one_minus_exp_series`](super::complex::one_minus_exp_series).
    #[inline(always)]
    pub fn one_minus_exp_series(self) -> Self {
        let mut sum = Self::real(self.re.simd, 1.0);
        for n in (2..=10).rev() {
            sum = (sum * self).times(1.0 / f64::from(n)).one_minus();
        }
        sum
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re.mul_sub(other.re, self.im * other.im),
            im: self.re.mul_add(other.im, self.im * other.re),
        }
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

/// eˣ for x ≤ 700; below −700 it stays at e⁻⁷⁰⁰.
///
/// x = n ln 2 + r, ln 2 in two parts; eʳ by its series to r¹²/12!, of which (ln 2/2)¹³/13! = 2e-16 is left.
#[inline(always)]
pub(crate) fn exp<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    const SERIES: [f64; 12] = [
        1.0 / 39_916_800.0,
        1.0 / 3_628_800.0,
        1.0 / 362_880.0,
        1.0 / 40_320.0,
        1.0 / 5_040.0,
        1.0 / 720.0,
        1.0 / 120.0,
        1.0 / 24.0,
        1.0 / 6.0,
        0.5,
        1.0,
        1.0,
    ];
    let x = x.max(-700.0);
    let whole = x.mul_add(std::f64::consts::LOG2_E, MAGIC);
    let n = whole - MAGIC;
    let r = n.mul_add(-6.931_471_803_691_238e-1, x);
    let r = n.mul_add(-1.908_214_929_270_587_7e-10, r);
    let mut sum = f64x8::splat(x.simd, 1.0 / 479_001_600.0);
    for term in SERIES {
        sum = sum.mul_add(r, term);
    }
    // 2ⁿ into the exponent
    let bits: u64x8<S> = sum.to_bits();
    let power: u64x8<S> = whole.to_bits();
    f64x8::from_bits(bits + (power << 52))
}

/// sin x and cos x for |x| up to 1e6.
///
/// x = n π/2 + r, π/2 in two parts; polynomials of fdlibm on |r| ≤ π/4, 2⁻⁵⁸.
#[inline(always)]
pub(crate) fn sin_cos<S: Simd>(x: f64x8<S>) -> (f64x8<S>, f64x8<S>) {
    const SIN: [f64; 5] = [
        -2.505_076_025_340_686_3e-8,
        2.755_731_370_707_007e-6,
        -1.984_126_982_985_795e-4,
        8.333_333_333_322_49e-3,
        -1.666_666_666_666_663_2e-1,
    ];
    const COS: [f64; 5] = [
        2.087_572_321_298_175e-9,
        -2.755_731_435_139_066_3e-7,
        2.480_158_728_947_673e-5,
        -1.388_888_888_887_411e-3,
        4.166_666_666_666_66e-2,
    ];
    let whole = x.mul_add(std::f64::consts::FRAC_2_PI, MAGIC);
    let n = whole - MAGIC;
    // 33 bits, so that n times the first part is exact without fused arithmetic
    let r = n.mul_add(-1.570_796_326_734_125_6, x);
    let r = n.mul_add(-6.077_100_506_506_192e-11, r);
    let z = r * r;
    let mut s = f64x8::splat(x.simd, 1.589_690_995_211_55e-10);
    for term in SIN {
        s = s.mul_add(z, term);
    }
    let s = (s * z).mul_add(r, r);
    let mut c = f64x8::splat(x.simd, -1.135_964_755_778_819_5e-11);
    for term in COS {
        c = c.mul_add(z, term);
    }
    let c = (c * z).mul_add(z, z.mul_add(-0.5, 1.0));
    let quadrant: u64x8<S> = whole.to_bits();
    let odd = (quadrant & 1).simd_eq(1);
    let (sin, cos) = (odd.select(c, s), odd.select(s, c));
    let sign = |of: u64x8<S>| (of & 2) << 62;
    (f64x8::from_bits(sin.to_bits() ^ sign(quadrant)), f64x8::from_bits(cos.to_bits() ^ sign(quadrant + 1)))
}

#[cfg(test)]
mod tests {
    use super::super::complex::{one_minus_exp_over, sqrt_decaying};
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// Whatever the machine has, against the functions of one number.
    #[test]
    fn lanes_agree_with_their_witness() {
        // measured: root 4e-16, exponential 4e-16 and 8e-16 of arguments up to 300 rad, (1 − e^{−z})/z 3e-15
        let worst = dispatch!(Level::new(), simd => errors(simd));
        assert!(worst[0] < 1e-15 && worst[1] < 3e-15 && worst[2] < 2e-14, "{worst:?}");
    }

    fn errors<S: Simd>(simd: S) -> [f64; 3] {
        let mut worst = [0.0f64; 3];
        let mut seed = 1u64;
        let mut uniform = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for _ in 0..20_000 {
            let z: [Complex64; LANES] = std::array::from_fn(|_| {
                let size = 10f64.powf(8.0 * uniform() - 5.5);
                Complex64::from_polar(size, std::f64::consts::TAU * uniform())
            });
            // as vertical wavenumbers are: they decay
            let decaying = z.map(|z| Complex64::new(z.re.abs(), z.im));
            let load = |z: &[Complex64; LANES]| Lanes {
                re: f64x8::from_fn(simd, |i| z[i].re),
                im: f64x8::from_fn(simd, |i| z[i].im),
            };
            let lanes = load(&z);
            let root = lanes.sqrt_decaying();
            let down = load(&decaying);
            let exponential = down.exp_minus();
            let over = down.one_minus_exp_over(exponential);
            for i in 0..LANES {
                let error = |got: Complex64, exact: Complex64| (got - exact).norm() / exact.norm();
                let exact = [
                    sqrt_decaying(z[i]),
                    (-decaying[i]).exp(),
                    one_minus_exp_over(decaying[i], (-decaying[i]).exp()),
                ];
                let got = [root.lane(i), exponential.lane(i), over.lane(i)];
                for ((worst, got), exact) in worst.iter_mut().zip(got).zip(exact) {
                    *worst = worst.max(error(got, exact));
                }
            }
        }
        worst
    }
}
