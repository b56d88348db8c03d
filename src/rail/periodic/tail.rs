//! What a rail does at short waves, whatever carries it: the slow end of its spectrum in closed form.

use crate::rail::{Drive, RailError, tail};
use crate::track::Member;
use num_complex::Complex64;

/// Where the spectrum is compared with its two terms [rad/m].
const SHORT: f64 = 2e3;

/// t/(β² + s²) + e/(β² + s²)² beside 1/D_r(β, ω̃ − βv), leaving β⁻⁶: t = 1/(κGA − mv²) [1/N], 0 for Euler–Bernoulli, and e [m²/N], which
/// is 1/EI there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tail {
    terms: tail::Tail,
    bends: bool,
}

impl Tail {
    /// That of `rail` under a load that moves as `drive`, over bays of `spacing` [m].
    ///
    /// # Errors
    /// A load as fast as the shear waves of the rail.
    pub fn new(rail: &Member, drive: Drive, spacing: f64) -> Result<Self, RailError> {
        // n₁/d₂ = 1/κGA, and −m at β = 0, ω = 1
        let (n, d) = rail.rational(0.0, Complex64::ZERO);
        let shear = (n[1] / d[2]).re;
        let mass = -rail.stiffness(Complex64::ZERO, 1.0).re;
        let inertia = mass * drive.speed * drive.speed;
        if shear * inertia >= 1.0 {
            let (speed, limit) = (drive.speed, (shear * mass).sqrt().recip());
            let what = "the speed of the rail's shear waves";
            return Err(RailError::TooFast { speed, limit, what, method: "dirac-comb" });
        }
        let t = shear / (1.0 - shear * inertia);
        let s = 2.0 / spacing;
        let square = SHORT * SHORT + s * s;
        let rest = |beta: f64| {
            let ground = rail.stiffness((beta * beta).into(), drive.at(beta));
            (1.0 / ground - t / square) * square * square
        };
        let e = 0.5 * (rest(SHORT) + rest(-SHORT));
        Ok(Self { terms: tail::Tail::of_two(t.into(), e, s), bends: t > 0.0 })
    }

    /// Whether the rail bends under the load, as Timoshenko's does.
    pub fn bends(&self) -> bool {
        self.bends
    }

    /// At `beta` [rad/m].
    pub fn at(&self, beta: f64) -> Complex64 {
        self.terms.of(beta)
    }

    /// At `x` [m] from the load.
    pub fn field(&self, x: f64) -> Complex64 {
        self.terms.at(x)
    }
}
