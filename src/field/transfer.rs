//! What a force on the rail does to the ground's surface beside the track, at one ω.
//!
//! ```text
//! h(β, ω; y) = k_eq ũ_base R(β, ω; y)
//! ```
//!
//! is the displacement at y [m per N/m] of a unit force per metre e^{i(ωt + βx)} on the rail, R the receiver integral, of any direction of
//! motion. It is even in β, along the track odd.
//! A force P e^{iω̃t} moving at v passes a receiver at x = 0 as the spectrum û(ω) = (P/v) h((ω̃ − ω)/v, ω).

use super::Channel;
use crate::math::quadrature::Estimate;
use crate::rail::{NEGLIGIBLE, decay};
use crate::soil::{Motion, PreparedGround, Strip};
use crate::track::Stack;
use num_complex::Complex64;
use std::cell::LazyCell;

/// h of a track on a strip of ground.
pub struct Transfer<'a> {
    stack: &'a Stack,
    ground: &'a dyn PreparedGround,
    strip: Strip,
    omega: f64,
    /// Wavenumber of the slowest wave [rad/m].
    pub slowest: f64,
}

impl<'a> Transfer<'a> {
    /// `stack` on `strip` of `ground`, prepared at `omega` [rad/s].
    pub fn new(stack: &'a Stack, ground: &'a dyn PreparedGround, strip: Strip, omega: f64) -> Self {
        let slowest = ground.outline().wavenumbers.last().copied().unwrap_or(0.0);
        Self { stack, ground, strip, omega, slowest }
    }

    /// 1/k_eq [m²/N] at `beta` [rad/m] to a `relative` accuracy.
    pub fn compliance(&self, beta: f64, relative: f64) -> Estimate {
        self.ground.strip(beta, self.strip, relative)
    }

    /// k_eq ũ_base: what of a unit force per metre reaches the ground [1], its `compliance` 1/k_eq known.
    pub fn force(&self, beta: f64, compliance: Complex64) -> Complex64 {
        let stiffness = 1.0 / compliance;
        self.stack.respond(beta, self.omega, stiffness).base * stiffness
    }

    /// √(β² − k²)(y − b): nepers by which what is slower than every wave decays between the strip and `y` [m].
    pub fn nepers(&self, beta: f64, y: f64) -> f64 {
        decay(beta, self.slowest, y - self.strip.half_width)
    }

    /// R(β; y) [m²/N] of a `channel` to `relative` of the waves beside which it decays, not of itself, and its error over ten times that; 0
    /// where nothing arrives.
    pub fn receiver(&self, beta: f64, channel: Channel, relative: f64) -> (Complex64, f64) {
        let Channel { y, motion } = channel;
        let wanted = (relative * self.nepers(beta, y).exp()).min(0.1);
        let estimate = self.ground.beside(beta, self.strip.half_width, y, motion, wanted);
        (estimate.value, self.miss(beta, y, relative, &estimate))
    }

    /// Error of such an `estimate` over ten times what was wanted.
    pub fn miss(&self, beta: f64, y: f64, relative: f64, estimate: &Estimate) -> f64 {
        let nepers = self.nepers(beta, y);
        if nepers > NEGLIGIBLE { 0.0 } else { estimate.miss(10.0 * (relative * nepers.exp()).min(0.1)) }
    }

    /// Largest β that reaches `y` [rad/m].
    pub fn reach(&self, y: f64) -> f64 {
        // waves decay from the edge of the strip; nearer to it than its half-width the track's own bending fades them first
        let distance = (y - self.strip.half_width).max(0.5 * self.strip.half_width);
        self.slowest.hypot((1e4f64.ln() + 2.0) / distance)
    }

    /// Wavenumbers of all waves [rad/m], ascending.
    pub fn waves(&self) -> &[f64] {
        &self.ground.outline().wavenumbers
    }

    /// R(β; y) [m²/N] for many `y`, nearest first, to a `relative` accuracy.
    pub fn receivers(&self, beta: f64, y: &[f64], relative: f64) -> Vec<Estimate> {
        self.ground.receivers(beta, self.strip.half_width, y, relative)
    }

    /// h(β) of each of the `channels` itself [m per N/m] to a `relative` accuracy, and its error over `least` of it. None where waves decay by
    /// more than 25 Np on the way: what little arrives is rounding of the integral, and no number is made of it.
    pub fn exact(
        &self,
        beta: f64,
        channels: &[Channel],
        relative: f64,
        least: f64,
    ) -> Vec<Option<(Complex64, f64)>> {
        let arrives = |channel: &Channel| self.nepers(beta, channel.y) <= NEGLIGIBLE;
        if !channels.iter().any(arrives) {
            return vec![None; channels.len()];
        }
        let under = self.compliance(beta, relative);
        let force = self.force(beta, under.value);
        let vertical = |channel: &Channel| channel.motion == Motion::Vertical && arrives(channel);
        let heard: Vec<f64> = channels.iter().filter(|c| vertical(c)).map(|channel| channel.y).collect();
        // one integral for all that move vertically; those so much quieter than the nearest that they are not known by it have one of their own
        let shared = LazyCell::new(|| self.receivers(beta, &heard, relative));
        let h = |&Channel { y, motion }: &Channel| {
            let half_width = self.strip.half_width;
            let fading = self.ground.evanescent(beta, half_width, (y, motion), relative);
            let known = fading.or_else(|| {
                let place = heard.iter().position(|other| *other == y && motion == Motion::Vertical)?;
                Some(shared[place]).filter(|beside| beside.error <= relative * beside.value.norm())
            });
            let alone = || self.ground.beside(beta, half_width, y, motion, relative);
            let beside = known.unwrap_or_else(alone);
            (force * beside.value, under.miss(least).max(beside.miss(least)))
        };
        channels.iter().map(|channel| arrives(channel).then(|| h(channel))).collect()
    }
}
