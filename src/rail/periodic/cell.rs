//! One bay of a track on equal supports: what stands under the rail at each of them, on its ground.

use crate::foundation::{Foundation, FoundationError};
use crate::math::interpolation::{Interpolant, NODES};
use crate::math::polynomial::value;
use crate::rail::RailError;
use crate::rail::track_on_foundation::BETA_MIN;
use crate::soil::strip::sinc;
use crate::track::{Member, Supports};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Accuracy of 1/k of ground that couples supports, where a support feels it.
const ACCURACY: f64 = 1e-7;
/// Radians of β w/2 after which the images under a sleeper are summed as an integral.
const ENOUGH: f64 = 40.0;

/// A rail on equal supports on their ground.
#[derive(Clone, Copy)]
pub struct Cell<'a> {
    supports: &'a Supports,
    on: &'a dyn Foundation,
    /// The ground of one support feels that of its neighbours, over the width [m] of a sleeper.
    width: Option<f64>,
}

impl<'a> Cell<'a> {
    /// `supports` on `on`, whose k is per metre of track. A support has springs of its own, Z = L k(ω), where k does not depend on β
    /// (the paper's Table 3); other ground joins the supports and asks for the width of their sleepers.
    ///
    /// # Errors
    /// Ground that joins the supports, without a width; a foundation that cannot answer.
    pub fn new(supports: &'a Supports, on: &'a dyn Foundation) -> Result<Self, RailError> {
        let ask = |beta| on.stiffness_to(beta, 100.0, 1e-6);
        let local = ask(0.5)?.value == ask(5.0)?.value;
        let width = supports.width.filter(|_| !local);
        if !local && width.is_none() {
            return Err(RailError::Width);
        }
        Ok(Self { supports, on, width })
    }

    /// The rail.
    pub fn rail(&self) -> &'a Member {
        &self.supports.rail
    }

    /// L [m]
    pub fn spacing(&self) -> f64 {
        self.supports.spacing
    }

    /// Whether the ground joins the supports, so that a bay says nothing for itself.
    pub fn coupled(&self) -> bool {
        self.width.is_some()
    }

    /// Whether links or the ground join neighbouring supports: D depends on the wave.
    pub fn joined(&self) -> bool {
        self.coupled() || self.supports.joined()
    }

    /// Refuses `omega` [rad/s] at which an element of the supports or of their ground is no spring; a constant load asks at 0.
    ///
    /// # Errors
    /// As `Stack::check`.
    pub fn check(&self, omega: f64) -> Result<(), FoundationError> {
        self.supports.under.check(omega)?;
        self.on.check(omega)
    }

    /// The same supports without dissipation, on the real part of their ground.
    pub fn undamped(&self) -> Supports {
        let Supports { rail, under, .. } = self.supports;
        Supports { rail: rail.undamped(), under: under.undamped(), ..*self.supports }
    }

    /// Z = L k(ω) [N/m] of one support on ground of its own, infinite on rock.
    pub(super) fn ground(&self, omega: f64) -> Result<Complex64, FoundationError> {
        let k = self.on.stiffness(1.0, omega)?.value;
        Ok(if k.re == f64::INFINITY { k } else { self.spacing() * k })
    }

    /// What a support does at `omega` [rad/s], for every wave.
    ///
    /// # Errors
    /// A foundation that cannot answer.
    pub fn support(&self, omega: f64) -> Result<Support<'a>, FoundationError> {
        match self.width {
            Some(width) => {
                let ground = Ground::new(self, width, omega)?;
                Ok(Support::Coupled { supports: self.supports, omega, ground })
            }
            None => {
                let (p, q) = self.supports.rational(omega, self.ground(omega)?);
                Ok(Support::Local { p, q })
            }
        }
    }
}

/// A support under the rail at one frequency.
#[derive(Clone, Debug)]
pub enum Support<'a> {
    /// D = P(y)/Q(y), y = 2(1 − cos βL), lowest power first.
    Local {
        /// P
        p: Vec<Complex64>,
        /// Q
        q: Vec<Complex64>,
    },
    /// On ground that joins it to the others.
    Coupled {
        /// The supports.
        supports: &'a Supports,
        /// ω [rad/s]
        omega: f64,
        /// What they stand on.
        ground: Ground,
    },
}

impl Support<'_> {
    /// D = P/Q [N/m] in the wave of phase `theta` = βL a bay, as the pair (P, Q).
    pub fn at(&self, theta: f64) -> (Complex64, Complex64) {
        match self {
            Self::Local { p, q } => {
                let y = Complex64::from(4.0 * (0.5 * theta).sin().powi(2));
                (value(p, y), value(q, y))
            }
            Self::Coupled { supports, omega, ground } => {
                let z = 1.0 / ground.compliance(theta / supports.spacing);
                (supports.stiffness(theta.cos().into(), *omega, z), Complex64::ONE)
            }
        }
    }

    /// 1/D [m/N] in the wave of phase `theta` = βL a bay.
    pub fn compliance(&self, theta: f64) -> Complex64 {
        let (p, q) = self.at(theta);
        q / p
    }
}

/// Ground under sleepers at one frequency: 1/k(β) tabulated as far as they feel it.
#[derive(Clone, Debug)]
pub struct Ground {
    /// 1/k [m²/N] over x = asinh(β/unit).
    table: Interpolant,
    unit: f64,
    spacing: f64,
    width: f64,
    /// The end of the table [rad/m], from where on k ∝ β.
    end: f64,
}

impl Ground {
    fn new(cell: &Cell, width: f64, omega: f64) -> Result<Self, FoundationError> {
        let end = 2.0 * ENOUGH / width;
        // waves of soils run at 50 to 1000 m/s
        let unit = (omega / 220.0).abs().max(1e-3);
        let meeting = [1000.0, 450.0, 300.0, 220.0, 150.0, 100.0, 50.0].map(|c| omega.abs() / c);
        let inner = meeting.into_iter().filter(|beta| *beta < 0.5 * end && *beta > 0.0).chain([1.0, 10.0]);
        let mut points: Vec<f64> = inner.chain([0.0, end]).collect();
        points.sort_by(f64::total_cmp);
        points.dedup_by(|a, b| *a - *b < 1e-3 * unit);
        let points: Vec<f64> = points.iter().map(|beta| (beta / unit).asinh()).collect();
        let compliances = |nodes: &[f64; NODES]| {
            let mut values = [Complex64::ZERO; NODES];
            for (x, value) in nodes.iter().zip(&mut values) {
                // at β = 0 a strip on a half-space has no static stiffness
                let beta = (unit * x.sinh()).max(BETA_MIN);
                *value = 1.0 / cell.on.stiffness_to(beta, omega, 0.1 * ACCURACY)?.value;
            }
            Ok::<_, FoundationError>(values)
        };
        let allowed = |x: f64, value: Complex64| {
            // the share of an image in the sum falls as sinc²/β
            let felt = 0.5 * width * unit * x.sinh();
            ACCURACY * value.norm() * (1.0 + felt * felt)
        };
        let table = Interpolant::bounded(compliances, &points, allowed, || true)?;
        Ok(Self { table, unit, spacing: cell.spacing(), width, end })
    }

    /// 1/Z(β) = (1/L) Σ_j sinc²(β_j w/2)/k(β_j) [m/N], β_j = β + 2πj/L: the ground under one sleeper in a wave of `beta` [rad/m].
    ///
    /// The images beyond β w/2 = 40 as an integral, sinc² = ½(2/βw)², k ∝ β: w⁻²/(2πk(B)B) at either end.
    ///
    /// Accuracy: 2e-6, that of the tail (test `tests::springs_of_a_sleeper_are_those_of_its_width`). Source: Eq. (58) with the width.
    pub fn compliance(&self, beta: f64) -> Complex64 {
        let step = TAU / self.spacing;
        let at = |beta: f64| self.table.at((beta.abs() / self.unit).asinh());
        let first = ((-self.end - beta) / step).ceil() as i64;
        let last = ((self.end - beta) / step).floor() as i64;
        let sum: Complex64 = (first..=last)
            .map(|j| {
                let beta = beta + j as f64 * step;
                at(beta) * sinc(0.5 * beta * self.width).powi(2)
            })
            .sum();
        // where the sum stops, half a step before the first image left out
        let tail = |from: f64| 1.0 / (TAU * self.width.powi(2)) * self.end / (from * from);
        let (low, high) = (beta + (first as f64 - 0.5) * step, beta + (last as f64 + 0.5) * step);
        sum / self.spacing + at(self.end) * (tail(low) + tail(high))
    }
}

/// The phase of a bay, between −π and π, for `count` equal steps from the middle of the first.
pub(super) fn phases(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| PI * ((2 * i + 1) as f64 / count as f64 - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foundation::{FoundationModel, Pasternak, Springs};
    use crate::track::{Link, Stack};

    #[test]
    fn springs_of_a_sleeper_are_those_of_its_width() {
        // k + Gβ²: of a triangle of width w on e^{−s|x|}/2sG, s² = k/G, and its neighbours at nL
        let (k, shear, spacing, width): (f64, f64, f64, f64) = (4e8, 3e7, 0.6, 0.25);
        let model = Pasternak { springs: Link::spring(k, 0.0, 0.0).unwrap(), shear };
        let on = Springs::new(FoundationModel::Pasternak(model)).unwrap();
        let rail = Member::beam(6.38e6, 60.23, 0.0).unwrap();
        let supports = Supports { rail, spacing, under: Stack::default(), width: Some(width) };
        let cell = Cell::new(&supports, &on).unwrap();
        let ground = Ground::new(&cell, width, 100.0).unwrap();
        let s = (k / shear).sqrt();
        let own = (1.0 / s - (1.0 - (-s * width).exp()) / (s * s * width)) / (s * shear * width);
        let spread = ((0.5 * s * width).sinh() / (0.5 * s * width)).powi(2) / (2.0 * s * shear);
        for theta in [0.0, 0.7, 2.0, 3.1] {
            let ring = Complex64::cis(theta) * (-s * spacing).exp();
            let exact = own + spread * 2.0 * (ring / (1.0 - ring)).re;
            let found = ground.compliance(theta / spacing);
            println!("{:.1e}", (found / exact - 1.0).norm());
            // measured 7e-7
            assert!((found / exact - 1.0).norm() < 2e-6, "{theta}: {found} {exact}");
        }
    }
}
