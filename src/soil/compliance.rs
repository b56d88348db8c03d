//! Compliances in the plane of propagation and their rotation to the track's axes.

use nalgebra::Matrix3;
use num_complex::Complex64;

/// Surface displacement per unit surface traction wave e^{i(ωt + kx)} [m/Pa]; z down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceCompliance {
    /// u_z due to a vertical traction.
    pub u_zz: Complex64,
    /// u_x due to a traction along x, the direction of propagation.
    pub u_xx: Complex64,
    /// u_x due to a vertical traction; u_z due to a traction along x is its negative.
    pub u_xz: Complex64,
    /// u_y due to a traction along y (SH).
    pub u_yy: Complex64,
}

/// Displacement at one depth per unit traction wave at another [m/Pa]; first index displacement, second traction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compliance {
    /// u_z due to a vertical traction.
    pub u_zz: Complex64,
    /// u_x due to a traction along the direction of propagation x.
    pub u_xx: Complex64,
    /// u_x due to a vertical traction.
    pub u_xz: Complex64,
    /// u_z due to a traction along x.
    pub u_zx: Complex64,
    /// u_y due to a traction along y (SH).
    pub u_yy: Complex64,
}

impl Compliance {
    /// The 3 × 3 tensor in track axes (x, y, z) for the plane wave e^{i(β_x x + β_y y)}; rows displacement, columns traction.
    ///
    /// G = G_rr r̂r̂ᵀ + G_tt t̂t̂ᵀ + …, r̂ = (β_x, β_y)/k, t̂ = (−β_y, β_x)/k. At k = 0 the direction is x.
    pub fn tensor(&self, beta_x: f64, beta_y: f64) -> Matrix3<Complex64> {
        let k = beta_x.hypot(beta_y);
        let (c, s) = if k == 0.0 { (1.0, 0.0) } else { (beta_x / k, beta_y / k) };
        let mixed = (self.u_xx - self.u_yy) * (c * s);
        Matrix3::new(
            self.u_xx * (c * c) + self.u_yy * (s * s),
            mixed,
            self.u_xz * c,
            mixed,
            self.u_xx * (s * s) + self.u_yy * (c * c),
            self.u_xz * s,
            self.u_zx * c,
            self.u_zx * s,
            self.u_zz,
        )
    }
}

impl From<SurfaceCompliance> for Compliance {
    fn from(g: SurfaceCompliance) -> Self {
        Self { u_zz: g.u_zz, u_xx: g.u_xx, u_xz: g.u_xz, u_zx: -g.u_xz, u_yy: g.u_yy }
    }
}
