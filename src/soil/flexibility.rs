//! The flexibility method: the flexibility felt at the top of each layer from the one felt at its bottom.
//!
//! In a layer, motion is a wave going down from its top, displacements e^{−Nz}a, and one going up from its bottom,
//! M e^{−N(h−z)} M b with M = diag(1, −1). Tractions of a down-going wave are those of a half-space, K a, whence N; those of
//! an up-going one −M K M b. On ground of flexibility Q (u = Q p) below,
//!
//! ```text
//! b = −R E a,  R = (1 + Q K̂)⁻¹ (1 − Q K),  K̂ = M K M,  E = e^{−Nh}
//! Q′ = X (K + K̂ − K̂ X)⁻¹,   X = 1 − Ê R E = 1 − Ê E + Ê (1 + Q K̂)⁻¹ Q (K + K̂) E,   Ê = M E M
//! ```
//!
//! Every exponential decays, so any kh will do; K and E are regular where P and S waves merge, so ω = 0 will; 1 − Ê E comes
//! from 1 − E, free of cancellation where kh is small, and the off-diagonals of K + K̂ vanish.
//! Accuracy: 1e-12 of the largest component, 1e-10 where a thin layer is 10⁴ times stiffer than the ground under it
//! (tests `laws::agreement`, `cross_solver::surface_compliance`).
//! No stiffness of a layer is formed and nothing assembled. Source: Sheng, Jones & Petyt 1999, whose recursion on transfer
//! matrices this is, with the waves going each way kept apart. Surface only.

use super::chain::upside_down;
use super::layer_stiffness::LayerStiffness;
use super::strip::Outline;
use super::transfer_matrix::{Waves, surface_compliance};
use super::wave::Wave;
use super::{Compliance, GroundSolver, PreparedGround, Profile, SoilError, SurfaceCompliance};
use crate::math::complex::one_minus_exp_over;
use nalgebra::Matrix2;
use num_complex::Complex64;

/// The flexibility method; it has no settings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flexibility;

/// The flexibility method at one ω.
struct FlexibilityAt {
    waves: Waves,
    negative: bool,
    /// Prepared depths, all of them 0.
    depths: usize,
    outline: Outline,
}

type Block = Matrix2<Complex64>;

fn inverse(a: Block) -> Block {
    let scale = determinant(&a).inv();
    Block::new(a[(1, 1)] * scale, -a[(0, 1)] * scale, -a[(1, 0)] * scale, a[(0, 0)] * scale)
}

fn determinant(a: &Block) -> Complex64 {
    a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)]
}

/// (1 + Q K)⁻¹ Q = (Q + |Q| adj K)/(1 + tr QK + |Q||K|): of two terms of like size, whatever the contrast of Q and 1/K.
fn in_series(q: Block, k: Block) -> Block {
    let (of_q, of_k) = (determinant(&q), determinant(&k));
    let adjugate = Block::new(k[(1, 1)], -k[(0, 1)], -k[(1, 0)], k[(0, 0)]);
    (q + adjugate * of_q) * (Complex64::ONE + (q * k).trace() + of_q * of_k).inv()
}

/// K, E = e^{−Nh} and 1 − E of the down-going waves of a layer; k and ω not both 0.
///
/// u′ = −kw + τ/μ, w′ = (1 − 2γ)ku + γσ/μ with (τ, σ) = −K(u, w) make N, whose eigenvalues are p and s:
/// E = e^{−sh} − (N − s) (e^{−sh} − e^{−ph})/(p − s).
fn down_going(wave: &Wave, k: f64, thickness: f64) -> [Block; 3] {
    let stiffness = LayerStiffness::<2>::half_space(wave, k);
    let one = Complex64::ONE;
    let rest = (1.0 - 2.0 * wave.gamma) * k;
    let n = Block::new(Complex64::ZERO, k * one, -rest, Complex64::ZERO)
        + Block::from_diagonal(&[one, wave.gamma].into()) * stiffness / wave.mu;
    let (p, s) = wave.vertical(k);
    let sum = p + s;
    // (p − s)h from p² − s², free of cancellation
    let x = (wave.ks2 - wave.kp2) * thickness / sum;
    let (e_p, e_s) = ((-p * thickness).exp(), (-s * thickness).exp());
    let loss = s * thickness * one_minus_exp_over(s * thickness, e_s);
    // (e^{−sh} − e^{−ph})/(p − s) = h e^{−sh} (1 − e^{−x})/x; Re p ≥ Re s but for odd pairs of loss factors
    let quotient = if x.re >= 0.0 {
        thickness * e_s * one_minus_exp_over(x, (-x).exp())
    } else {
        thickness * e_p * one_minus_exp_over(-x, x.exp())
    };
    let turning = (n - Block::identity() * s) * quotient;
    [stiffness, Block::identity() * e_s - turning, Block::identity() * loss + turning]
}

/// In-plane flexibility at the surface of `layers`, top first, on `half_space`, or on rock where there is none.
pub(super) fn in_plane(layers: &[(Wave, f64)], half_space: Option<Wave>, k: f64) -> Block {
    // rock does not yield
    let mut q = half_space.map_or_else(Block::zeros, |w| inverse(LayerStiffness::<2>::half_space(&w, k)));
    for (wave, h) in layers.iter().rev() {
        if wave.vertical(k) == (Complex64::ZERO, Complex64::ZERO) {
            // k = ω = 0: a spring
            q += Block::from_diagonal(&[Complex64::ONE, wave.gamma].into()) * (*h / wave.mu);
            continue;
        }
        let [down, e, loss] = down_going(wave, k, *h);
        let (up, e_up) = (upside_down(down), upside_down(e));
        let twice = |a: Block| Block::from_diagonal(&(a.diagonal() * Complex64::from(2.0)));
        let x = twice(loss) - upside_down(loss) * loss + e_up * in_series(q, up) * twice(down) * e;
        q = x * inverse(twice(down) - up * x);
    }
    q
}

/// The same anti-plane: Q′ = (1 − r)/(μs(1 + r)), r = e^{−2sh} (1 − Qμs)/(1 + Qμs)
pub(super) fn anti_plane(layers: &[(Wave, f64)], half_space: Option<Wave>, k: f64) -> Complex64 {
    let mut q = half_space.map_or(Complex64::ZERO, |w| 1.0 / (w.mu * w.vertical(k).1));
    for (wave, h) in layers.iter().rev() {
        let s = wave.vertical(k).1;
        let stiffness = wave.mu * s;
        let e = (-2.0 * s * *h).exp();
        // 1 − r = (1 − e + Qμs(1 + e))/(1 + Qμs), likewise 1 + r: free of cancellation where sh is small
        let loss = 2.0 * *h * one_minus_exp_over(2.0 * s * *h, e);
        q = (loss / wave.mu + q * (1.0 + e)) / (1.0 + e + q * stiffness * s * loss);
    }
    q
}

impl GroundSolver for Flexibility {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        super::surface_only("flexibility", depths)?;
        Ok(Box::new(FlexibilityAt {
            waves: Waves::new(profile, omega.abs()),
            negative: omega < 0.0,
            depths: depths.len(),
            outline: Outline::new(profile, omega),
        }))
    }
}

impl PreparedGround for FlexibilityAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let Waves { layers, half_space, .. } = &self.waves;
        let anti_plane = anti_plane(layers, *half_space, k);
        surface_compliance(&in_plane(layers, *half_space, k), anti_plane, self.negative)
    }

    #[inline]
    fn u_zz(&self, k: f64) -> Complex64 {
        let g = in_plane(&self.waves.layers, self.waves.half_space, k)[(1, 1)];
        if self.negative { g.conj() } else { g }
    }

    fn at_depths(&self, k: f64, _source: usize) -> Vec<Compliance> {
        vec![self.surface(k).into(); self.depths]
    }

    fn outline(&self) -> &Outline {
        &self.outline
    }
}
