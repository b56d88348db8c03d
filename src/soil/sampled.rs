//! A prepared ground whose G_zz(k) is interpolated: many integrals at one ω for the price of one table.

use super::strip::{self, Outline, Strip};
use super::{Compliance, Pole, PreparedGround, SoilError, SurfaceCompliance};
use crate::math::interpolation::Interpolant;
use crate::math::quadrature::Estimate;
use num_complex::Complex64;

/// Error of the interpolated G_zz relative to its modulus.
const ACCURACY: f64 = 1e-8;

/// Interpolated up to the wavenumbers beyond which integrals seldom look; everything else is asked of the ground itself.
pub struct Sampled {
    ground: Box<dyn PreparedGround>,
    table: Interpolant,
    highest: f64,
}

impl Sampled {
    /// `ground` at ω ≠ 0, tabulated up to `highest` [rad/m] and four times its slowest wave.
    ///
    /// Accuracy: 1e-8 of G_zz (test `tests::agrees`); where the table misses it no integral over it counts as converged.
    pub fn new(ground: Box<dyn PreparedGround>, highest: f64) -> Self {
        let waves = &ground.outline().wavenumbers;
        let slowest = waves.last().copied().unwrap_or(0.0);
        let highest = highest.max(4.0 * slowest);
        // where G changes, then doubling
        let mut points = vec![0.0];
        points.extend(waves.iter().copied().filter(|k| *k > 0.0));
        points.dedup_by(|a, b| *a - *b < 1e-6 * *a);
        let mut k = points[points.len() - 1].max(0.01 * highest);
        while k < highest {
            k = (2.0 * k).min(highest);
            points.push(k);
        }
        let table =
            Interpolant::new(|nodes| nodes.map(|k| ground.u_zz(k)), &points, |_, g| ACCURACY * g.norm());
        Self { ground, table, highest }
    }
}

impl Sampled {
    /// An integral is no better than the table: of unknown error where that missed its accuracy.
    fn of_table(&self, estimate: Estimate) -> Estimate {
        if self.table.converged() {
            estimate
        } else {
            Estimate { error: f64::INFINITY, converged: false, ..estimate }
        }
    }
}

impl PreparedGround for Sampled {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        self.ground.surface(k)
    }

    fn u_zz(&self, k: f64) -> Complex64 {
        if k <= self.highest { self.table.at(k) } else { self.ground.u_zz(k) }
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        self.ground.at_depths(k, source)
    }

    fn outline(&self) -> &Outline {
        self.ground.outline()
    }

    fn strip(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        self.of_table(strip::quadrature(&|k| self.u_zz_many(k), self.outline(), beta, strip, relative))
    }

    fn receiver(&self, beta: f64, half_width: f64, y: f64, relative: f64) -> Estimate {
        let g = |k: &[f64]| self.u_zz_many(k);
        self.of_table(strip::receiver_quadrature(&g, self.outline(), beta, half_width, y, relative))
    }

    fn receivers(&self, beta: f64, half_width: f64, y: &[f64], relative: f64) -> Vec<Estimate> {
        let g = |k: &[f64]| self.u_zz_many(k);
        let all = strip::receivers_quadrature(&g, self.outline(), beta, half_width, y, relative);
        all.into_iter().map(|estimate| self.of_table(estimate)).collect()
    }

    fn modes(&self) -> Result<Vec<Pole>, SoilError> {
        self.ground.modes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soil::{Base, DirectStiffness, Elastic, GroundSolver, Layer, Material, Profile};

    #[test]
    fn agrees() {
        // measured 4e-9 of G
        let material = |young, density| {
            Material::new(Elastic::YoungPoisson { young, poisson: 0.35 }, density, 0.06, 0.06).unwrap()
        };
        let layer = Layer { thickness: 2.0, material: material(60e6, 1500.0) };
        let profile = Profile::new(vec![layer], Base::HalfSpace(material(200e6, 1800.0))).unwrap();
        for omega in [1.0, 120.0, 800.0] {
            let prepare = || DirectStiffness.prepare(&profile, omega, &[]).unwrap();
            let (exact, sampled) = (prepare(), Sampled::new(prepare(), 50.0));
            for i in 0..2000 {
                let k = 1e-3 * 1.0055f64.powi(i);
                let error = (sampled.u_zz(k) - exact.u_zz(k)).norm() / exact.u_zz(k).norm();
                assert!(error < 3e-8, "{omega} {k}: {error:e}");
            }
        }
    }

    #[test]
    fn what_its_table_missed_no_integral_hides() {
        // on rock, all but undamped: a resonance in k that 2¹⁴ pieces do not resolve
        let elastic = Elastic::ShearPoisson { shear: 100.0, poisson: 0.3 };
        let material = Material::new(elastic, 1800.0, 1e-13, 1e-13).unwrap();
        let profile = Profile::new(vec![Layer { thickness: 5.0, material }], Base::Rigid).unwrap();
        let ground = Sampled::new(DirectStiffness.prepare(&profile, 300.0, &[]).unwrap(), 30.0);
        assert!(!ground.table.converged());
        let strip = Strip { half_width: 1.25, compatibility: strip::Compatibility::Mean };
        let one = [ground.strip(0.5, strip, 1e-3), ground.receiver(0.5, 1.25, 8.0, 1e-3)];
        let many = ground.receivers(0.5, 1.25, &[8.0, 16.0], 1e-3);
        assert!(one.iter().chain(&many).all(|e| !e.converged && e.error == f64::INFINITY));
    }
}
