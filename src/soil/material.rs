//! Isotropic soil with hysteretic damping, valid once built.

use super::SoilError;
use crate::math::complex::sign;
use crate::quantity::{not_negative, positive};
use num_complex::Complex64;

/// A linear elastic isotropic material with hysteretic damping.
///
/// M* = M (1 + iη sgn ω) with its own η for μ and for the P-wave modulus λ + 2μ (THEORY 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    density: f64,
    shear_modulus: f64,
    p_modulus: f64,
    loss_shear: f64,
    loss_pressure: f64,
    /// c_R [m/s], found once.
    rayleigh_speed: f64,
}

/// Elastic constants in one of the three customary pairs, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elastic {
    /// Young's modulus E [Pa] and Poisson's ratio ν.
    YoungPoisson {
        /// E [Pa]
        young: f64,
        /// ν
        poisson: f64,
    },
    /// Wave speeds c_s, c_p [m/s].
    Speeds {
        /// c_s [m/s]
        shear: f64,
        /// c_p [m/s]
        pressure: f64,
    },
    /// Shear wave speed c_s [m/s] and Poisson's ratio ν.
    ShearPoisson {
        /// c_s [m/s]
        shear: f64,
        /// ν
        poisson: f64,
    },
}

impl Material {
    /// A material from elastic constants, `density` ρ [kg/m³] and the loss factors η of shear and pressure waves.
    ///
    /// # Errors
    /// Non-finite or non-positive density, moduli or speeds; ν outside (−1, 0.5); c_p ≤ (2/√3) c_s (negative bulk
    /// modulus); η < 0; a pair of loss factors whose bulk modulus would feed energy in.
    pub fn new(
        elastic: Elastic,
        density: f64,
        loss_shear: f64,
        loss_pressure: f64,
    ) -> Result<Self, SoilError> {
        // written so that NaN is refused
        let ratio = |nu: f64| {
            if nu > -1.0 && nu < 0.5 { Ok(nu) } else { Err(SoilError::PoissonRatio { value: nu }) }
        };
        let rho = positive("density", density, "kg/m³")?;
        // (λ + 2μ)/μ = 2(1 − ν)/(1 − 2ν)
        let (mu, modulus_ratio) = match elastic {
            Elastic::YoungPoisson { young, poisson } => {
                let nu = ratio(poisson)?;
                let young = positive("young", young, "Pa")?;
                (0.5 * young / (1.0 + nu), 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu))
            }
            Elastic::ShearPoisson { shear, poisson } => {
                let nu = ratio(poisson)?;
                let c_s = positive("shear_speed", shear, "m/s")?;
                (rho * c_s * c_s, 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu))
            }
            Elastic::Speeds { shear, pressure } => {
                let c_s = positive("shear_speed", shear, "m/s")?;
                let c_p = positive("pressure_speed", pressure, "m/s")?;
                let least = c_s * (4.0f64 / 3.0).sqrt();
                if c_p <= least {
                    return Err(SoilError::PressureSpeed { c_p, c_s, least });
                }
                (rho * c_s * c_s, (c_p / c_s).powi(2))
            }
        };
        not_negative("loss_factor", loss_shear, "")?;
        not_negative("loss_factor_pressure", loss_pressure, "")?;
        // Im K* = η_p (λ + 2μ) − (4/3) η_s μ ≥ 0, K the bulk modulus
        let least = 4.0 / 3.0 * loss_shear / modulus_ratio;
        if loss_pressure < least * (1.0 - 1e-12) {
            return Err(SoilError::NotPassive { loss_pressure, least });
        }
        let p_modulus = mu * modulus_ratio;
        let rayleigh_speed = rayleigh_speed((mu / rho).sqrt(), mu / p_modulus);
        Ok(Self { density: rho, shear_modulus: mu, p_modulus, loss_shear, loss_pressure, rayleigh_speed })
    }

    /// ρ [kg/m³]
    pub fn density(&self) -> f64 {
        self.density
    }
    /// μ [Pa], without damping.
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }
    /// c_s [m/s], without damping.
    pub fn c_s(&self) -> f64 {
        (self.shear_modulus / self.density).sqrt()
    }
    /// c_p [m/s], without damping.
    pub fn c_p(&self) -> f64 {
        (self.p_modulus / self.density).sqrt()
    }
    /// Poisson's ratio ν.
    pub fn poisson(&self) -> f64 {
        let ratio = self.p_modulus / self.shear_modulus;
        0.5 * (ratio - 2.0) / (ratio - 1.0)
    }
    /// η of shear waves.
    pub fn loss_factor(&self) -> f64 {
        self.loss_shear
    }
    /// η of pressure waves, acting on λ + 2μ.
    pub fn loss_factor_pressure(&self) -> f64 {
        self.loss_pressure
    }

    /// The same material with both loss factors × `factor`, 0 to 1.
    pub fn with_loss_times(&self, factor: f64) -> Self {
        Self { loss_shear: factor * self.loss_shear, loss_pressure: factor * self.loss_pressure, ..*self }
    }

    /// The same material with both loss factors `loss` ≥ 0.
    pub fn with_loss(&self, loss: f64) -> Self {
        Self { loss_shear: loss, loss_pressure: loss, ..*self }
    }

    /// μ* = μ(1 + iη_s sgn ω) [Pa]
    pub fn complex_shear_modulus(&self, omega: f64) -> Complex64 {
        self.shear_modulus * Complex64::new(1.0, self.loss_shear * sign(omega))
    }

    /// (λ + 2μ)* = (λ + 2μ)(1 + iη_p sgn ω) [Pa]
    pub fn complex_p_modulus(&self, omega: f64) -> Complex64 {
        self.p_modulus * Complex64::new(1.0, self.loss_pressure * sign(omega))
    }

    /// Rayleigh wave speed c_R [m/s] of a half-space of this material without damping.
    ///
    /// Source: Rayleigh 1885; test `analytic::rayleigh`.
    pub fn rayleigh_speed(&self) -> f64 {
        self.rayleigh_speed
    }
}

/// c_R [m/s] from `c_s` and κ² = (c_s/c_p)².
///
/// Root of R(ξ) = ξ³ − 8ξ² + (24 − 16κ²)ξ − 16(1 − κ²), ξ = (c_R/c_s)², by bisection; 1e-15.
fn rayleigh_speed(c_s: f64, kappa2: f64) -> f64 {
    let cubic = |xi: f64| ((xi - 8.0) * xi + 24.0 - 16.0 * kappa2) * xi - 16.0 * (1.0 - kappa2);
    // R(0) < 0 < R(1) = 1 and one root between
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if cubic(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    c_s * (0.5f64 * (low + high)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_ways_to_the_same_material() {
        let a =
            Material::new(Elastic::YoungPoisson { young: 60e6, poisson: 0.35 }, 1500.0, 0.06, 0.06).unwrap();
        let b =
            Material::new(Elastic::Speeds { shear: a.c_s(), pressure: a.c_p() }, 1500.0, 0.06, 0.06).unwrap();
        let c = Material::new(Elastic::ShearPoisson { shear: a.c_s(), poisson: 0.35 }, 1500.0, 0.06, 0.06)
            .unwrap();
        for other in [b, c] {
            assert!((other.shear_modulus() / a.shear_modulus() - 1.0).abs() < 1e-14);
            assert!((other.poisson() - 0.35).abs() < 1e-14);
        }
    }

    #[test]
    fn refuses_the_impossible() {
        let new = |nu, rho, eta, eta_p| {
            Material::new(Elastic::YoungPoisson { young: 1e7, poisson: nu }, rho, eta, eta_p)
        };
        for (nu, rho, eta, eta_p) in [
            (0.5, 1800.0, 0.0, 0.0),
            (-1.0, 1800.0, 0.0, 0.0),
            (f64::NAN, 1800.0, 0.0, 0.0),
            (0.3, 0.0, 0.0, 0.0),
            (0.3, f64::INFINITY, 0.0, 0.0),
            (0.3, 1800.0, -0.01, 0.0),
            (0.3, 1800.0, 0.1, 0.0),
        ] {
            assert!(new(nu, rho, eta, eta_p).is_err(), "{nu} {rho} {eta} {eta_p}");
        }
        assert!(Material::new(Elastic::Speeds { shear: 100.0, pressure: 110.0 }, 1800.0, 0.0, 0.0).is_err());
    }
}
