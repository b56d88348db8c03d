//! How a wheel presses on the rail.

use crate::vehicle::Hertz;

/// P of the approach δ of one wheel and its rail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// P = K δ^{3/2} for δ > 0, else none. Source: Eqs (83), (84).
    Hertz(Hertz),
    /// P = P₀ + k(δ − δ₀), whether it presses or pulls.
    Linear {
        /// k [N/m]
        stiffness: f64,
        /// P₀ [N]
        load: f64,
        /// δ₀ [m]
        approach: f64,
    },
}

impl Law {
    /// Linear about the static `load` P₀ > 0 [N] of `hertz`.
    pub fn linear(hertz: Hertz, load: f64) -> Self {
        let approach = hertz.approach(load);
        Self::Linear { stiffness: hertz.slope(approach), load, approach }
    }

    /// P [N] at δ = `approach` [m].
    pub fn force(&self, approach: f64) -> f64 {
        match *self {
            Self::Hertz(hertz) => hertz.force(approach),
            Self::Linear { stiffness, load, approach: at } => load + stiffness * (approach - at),
        }
    }

    /// dP/dδ [N/m]
    pub fn slope(&self, approach: f64) -> f64 {
        match *self {
            Self::Hertz(hertz) => hertz.slope(approach),
            Self::Linear { stiffness, .. } => stiffness,
        }
    }

    /// δ [m] under `force` P [N], above zero with Hertz.
    pub fn approach(&self, force: f64) -> f64 {
        match *self {
            Self::Hertz(hertz) => hertz.approach(force),
            Self::Linear { stiffness, load, approach } => approach + (force - load) / stiffness,
        }
    }

    /// Energy ∫ P dδ [J] of δ = `approach`: 2/5 K δ^{5/2}.
    pub fn energy(&self, approach: f64) -> f64 {
        match *self {
            Self::Hertz(hertz) => 0.4 * hertz.force(approach) * approach.max(0.0),
            Self::Linear { stiffness, load, approach: at } => {
                let d = approach - at;
                load * d + 0.5 * stiffness * d * d
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::Tread;

    #[test]
    fn both_laws_are_tangent_at_the_static_load() {
        let hertz = Hertz::new(Tread::Worn, 0.46).unwrap();
        let laws = [Law::Hertz(hertz), Law::linear(hertz, 75e3)];
        let at = laws[0].approach(75e3);
        for law in laws {
            // measured 2e-16
            assert!(
                (law.force(at) / 75e3 - 1.0).abs() < 1e-14 && (law.approach(75e3) / at - 1.0).abs() < 1e-14
            );
            assert!((law.slope(at) / 1.49879e9 - 1.0).abs() < 1e-5);
            // the force is the slope of the energy: central differences, 1e-10 of third derivatives
            let e = 1e-5 * at;
            let slope = (law.energy(at + e) - law.energy(at - e)) / (2.0 * e);
            assert!((slope / 75e3 - 1.0).abs() < 1e-9);
        }
        assert_eq!(laws[0].force(-1e-5), 0.0);
        assert!(laws[1].force(-1e-4) < 0.0);
    }
}
