//! The contact of wheel and rail as a spring.

use super::BodyError;
use crate::quantity::positive;
use schemars::JsonSchema;
use serde::Deserialize;

/// Shape of the running surface of a wheel.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Tread {
    /// Worn profile.
    #[default]
    Worn,
    /// New, conical profile.
    Coned,
}

/// The contact of a wheelset and the rails as a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSpring {
    /// k_H = dP/dδ [N/m], both wheels together.
    pub stiffness: f64,
    /// P₀ [N] of the wheelset under which it is taken.
    pub load: f64,
}

/// The Hertzian contact of one wheel: P = (δ/G)^{3/2}, P [N] the force, δ [m] the approach.
///
/// G = 3.86e-8 R^−0.115 of worn, 4.57e-8 R^−0.149 of coned wheels [m/N^{2/3}], R [m] the radius of the wheel.
/// Source: Jenkins, Stephenson, Clayton, Morland & Lyon 1974, Railway Eng. J. 3(1), as quoted by Zhai, Wang & Cai 2009, Veh.
/// Syst. Dyn. 47. No measured accuracy: fits to Hertz's theory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hertz {
    /// G [m/N^{2/3}]
    g: f64,
}

impl Hertz {
    /// A wheel of `radius` R [m] with a `tread`.
    ///
    /// # Errors
    /// A radius that is not positive.
    pub fn new(tread: Tread, radius: f64) -> Result<Self, BodyError> {
        let r = positive("radius", radius, "m")?;
        let g = match tread {
            Tread::Worn => 3.86e-8 * r.powf(-0.115),
            Tread::Coned => 4.57e-8 * r.powf(-0.149),
        };
        Ok(Self { g })
    }

    /// The contact whose slope is `stiffness` k_H [N/m] under the static `load` P₀ [N] of one wheel: G = 1.5 P₀^{1/3}/k_H.
    ///
    /// # Errors
    /// A stiffness or a load that is not positive.
    pub fn through(stiffness: f64, load: f64) -> Result<Self, BodyError> {
        let (stiffness, load) = (positive("stiffness", stiffness, "N/m")?, positive("load", load, "N")?);
        Ok(Self { g: 1.5 * load.cbrt() / stiffness })
    }

    /// G [m/N^{2/3}] of one wheel. Two wheels of a wheelset together are as stiff as one of G/2^{2/3}: K, k_H and P₀ double, δ₀ stays.
    pub fn g(&self) -> f64 {
        self.g
    }

    /// K = G^{−3/2} [N/m^{3/2}] of one wheel: P = K δ^{3/2}.
    pub fn constant(&self) -> f64 {
        self.g.powf(-1.5)
    }

    /// δ₀ = G P₀^{2/3} [m] under a `load` P₀ ≥ 0 [N] of one wheel.
    pub fn approach(&self, load: f64) -> f64 {
        self.g * load.cbrt().powi(2)
    }

    /// dP/dδ = 1.5 G^{−3/2} δ^{1/2} [N/m] at `approach` δ [m], zero where wheel and rail are apart.
    pub fn slope(&self, approach: f64) -> f64 {
        1.5 * self.constant() * approach.max(0.0).sqrt()
    }

    /// P = (δ/G)^{3/2} [N] at `approach` δ [m], zero where wheel and rail are apart.
    pub fn force(&self, approach: f64) -> f64 {
        (approach.max(0.0) / self.g).powf(1.5)
    }

    /// k_H = dP/dδ = 1.5 P₀^{1/3}/G [N/m] of one wheel under its static `load` P₀ [N], half an axle load.
    ///
    /// # Errors
    /// A load that is not positive: an unloaded contact has no stiffness.
    pub fn stiffness(&self, load: f64) -> Result<f64, BodyError> {
        Ok(1.5 * positive("load", load, "N")?.cbrt() / self.g)
    }

    /// k_H [N/m] of a wheelset, two wheels that share the `axle_load` [N].
    ///
    /// # Errors
    /// A load that is not positive.
    pub fn wheelset_stiffness(&self, axle_load: f64) -> Result<f64, BodyError> {
        Ok(2.0 * self.stiffness(0.5 * axle_load)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stiffness_is_the_slope_of_the_force() {
        for tread in [Tread::Worn, Tread::Coned] {
            let hertz = Hertz::new(tread, 0.46).unwrap();
            let approach = hertz.approach(75e3);
            let h = 1e-5 * approach;
            let slope = (hertz.force(approach + h) - hertz.force(approach - h)) / (2.0 * h);
            // central difference: h²/24 of relative third derivative
            assert!((slope / hertz.stiffness(75e3).unwrap() - 1.0).abs() < 1e-9);
            assert!((hertz.slope(approach) / hertz.stiffness(75e3).unwrap() - 1.0).abs() < 1e-14);
            assert!((hertz.constant() * approach.powf(1.5) / 75e3 - 1.0).abs() < 1e-14);
            assert_eq!((hertz.force(-1e-6), hertz.slope(-1e-6)), (0.0, 0.0));
            // the same contact from its slope under a load
            let again = Hertz::through(hertz.stiffness(75e3).unwrap(), 75e3).unwrap();
            assert!((again.g() / hertz.g() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn of_the_size_codes_use() {
        // worn, R = 0.46 m, 75 kN: G = 3.86e-8 · 1.09340 = 4.2205e-8, k = 1.5 · 42.1716/G = 1.4988e9 N/m; its five digits
        let hertz = Hertz::new(Tread::Worn, 0.46).unwrap();
        assert!((hertz.stiffness(75e3).unwrap() / 1.4988e9 - 1.0).abs() < 1e-4);
        assert_eq!(hertz.wheelset_stiffness(150e3).unwrap(), 2.0 * hertz.stiffness(75e3).unwrap());
        // THEORY-TIME 4, to its six and seven digits
        assert!(
            (hertz.g() / 4.22056e-8 - 1.0).abs() < 1e-6
                && (hertz.constant() / 1.153307e11 - 1.0).abs() < 1e-6
        );
    }

    #[test]
    fn refuses_nonsense() {
        assert!(Hertz::new(Tread::Worn, 0.0).is_err() && Hertz::through(0.0, 1.0).is_err());
        let error = Hertz::new(Tread::Coned, 0.46).unwrap().stiffness(0.0).unwrap_err();
        assert_eq!(error.to_string(), "load is 0 N: it must be finite and above zero");
    }
}
