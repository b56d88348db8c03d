//! A settled integral over β as a sum of waves along the track: Σ u e^{iβx}.

use crate::count::{self, Work};
use crate::math::gridding::{SPREAD, sum_of_waves};
use crate::math::lanes::{LANES, sin_cos};
use crate::math::quadrature::{Node, Rule};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch, f64x8};
use num_complex::Complex64;

/// Positions up to which they are cheaper one by one.
const FEW: usize = 64;

/// Waves of wavenumber β and amplitude u.
#[derive(Clone, Debug, Default)]
pub struct Waves {
    /// β [rad/m]
    pub beta: Vec<f64>,
    /// u, the weight of its node in it.
    pub u: Vec<Complex64>,
}

impl Waves {
    /// One wave for every node of `rule`: its weight times `share` of the integrand's `amplitude` at (β, value).
    pub fn new(rule: &Rule, share: f64, amplitude: impl Fn(f64, Complex64) -> Complex64) -> Self {
        let wave = |node: &Node| (node.x, amplitude(node.x, node.value) * (node.weight * share));
        let (beta, u) = rule.0.iter().map(wave).unzip();
        Self { beta, u }
    }

    /// β and u of every wave.
    pub fn iter(&self) -> impl Iterator<Item = (f64, Complex64)> + Clone {
        self.beta.iter().copied().zip(self.u.iter().copied())
    }

    /// The same waves, each times `factor` of its β.
    pub fn times(&self, factor: impl Fn(f64) -> Complex64) -> Self {
        Self { beta: self.beta.clone(), u: self.iter().map(|(beta, u)| u * factor(beta)).collect() }
    }

    /// Those of an integrand even in β, from those of β ≥ 0.
    pub fn mirrored(self) -> Self {
        let beta = self.beta.iter().rev().map(|beta| -beta).chain(self.beta.iter().copied()).collect();
        let u = self.u.iter().rev().chain(&self.u).copied().collect();
        Self { beta, u }
    }

    /// Σ u e^{iβx} at `x` [m].
    pub fn at(&self, x: f64) -> Complex64 {
        count::add(Work::NodePositions, self.beta.len());
        dispatch!(Level::new(), simd => self.at_in_lanes(simd, x))
    }

    #[inline(always)]
    fn at_in_lanes<S: Simd>(&self, simd: S, x: f64) -> Complex64 {
        let (mut sum_re, mut sum_im) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 0.0));
        for (beta, u) in self.beta.chunks(LANES).zip(self.u.chunks(LANES)) {
            let phase = f64x8::from_fn(simd, |i| beta.get(i).map_or(0.0, |beta| beta * x));
            let re = f64x8::from_fn(simd, |i| u.get(i).map_or(0.0, |u| u.re));
            let im = f64x8::from_fn(simd, |i| u.get(i).map_or(0.0, |u| u.im));
            let (sin, cos) = sin_cos(phase);
            (sum_re, sum_im) = (sum_re + re * cos - im * sin, sum_im + re * sin + im * cos);
        }
        Complex64::new(sum_re.reduce_sum(), sum_im.reduce_sum())
    }

    /// The waves of many loads, Σ P_j e^{iβa_j} for each: `loads` P_j [N] at a_j [m] behind the first.
    pub fn under(&self, loads: &[(f64, f64)]) -> Self {
        count::add(Work::NodePositions, self.beta.len() * loads.len());
        dispatch!(Level::new(), simd => self.under_in_lanes(simd, loads))
    }

    #[inline(always)]
    fn under_in_lanes<S: Simd>(&self, simd: S, loads: &[(f64, f64)]) -> Self {
        let mut u = self.u.clone();
        for (beta, u) in self.beta.chunks(LANES).zip(u.chunks_mut(LANES)) {
            let beta = f64x8::from_fn(simd, |i| beta.get(i).copied().unwrap_or_default());
            let zero = f64x8::splat(simd, 0.0);
            let (re, im) = loads.iter().fold((zero, zero), |(re, im), (behind, load)| {
                let (sin, cos) = sin_cos(beta * *behind);
                (re + cos * *load, im + sin * *load)
            });
            u.iter_mut().enumerate().for_each(|(i, u)| *u *= Complex64::new(re[i], im[i]));
        }
        Self { beta: self.beta.clone(), u }
    }

    /// Re Σ u e^{iβx} at `count` positions from `from` in steps of `step` [m]: few of them one by one, many at the price of one fast
    /// transform, to 1e-10 of Σ |u|.
    pub fn shape(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        if count <= FEW {
            return self.shape_at_few(from, step, count);
        }
        count::add(Work::NodePositions, self.beta.len() * SPREAD);
        sum_of_waves(self.iter(), from, step, count)
    }

    /// The same, eight positions at a time; e^{iβx} by rotation, restarted every 2048 positions so that its rounding stays below 1e-13.
    fn shape_at_few(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        count::add(Work::NodePositions, self.beta.len() * count);
        dispatch!(Level::new(), simd => self.shape_in_lanes(simd, from, step, count))
    }

    #[inline(always)]
    fn shape_in_lanes<S: Simd>(&self, simd: S, from: f64, step: f64, count: usize) -> Vec<f64> {
        const RESTART: usize = 256;
        let mut sum = vec![f64x8::splat(simd, 0.0); count.div_ceil(LANES)];
        for (beta, u) in self.iter() {
            let (sin, cos) = sin_cos(f64x8::splat(simd, beta * step * LANES as f64));
            for (block, part) in sum.chunks_mut(RESTART).enumerate() {
                let first = block * RESTART * LANES;
                let phase = f64x8::from_fn(simd, |i| beta * (from + step * (first + i) as f64));
                let (s, c) = sin_cos(phase);
                let (mut re, mut im) = (c * u.re - s * u.im, c * u.im + s * u.re);
                for slot in part {
                    *slot += re;
                    (re, im) = (re.mul_sub(cos, im * sin), re.mul_add(sin, im * cos));
                }
            }
        }
        let mut positions: Vec<f64> = sum.iter().flat_map(|eight| eight.as_slice().iter().copied()).collect();
        positions.truncate(count);
        positions
    }
}
