//! Shapes of one beam element: displacement w and rotation θ between the unknowns (w, θ) of its two nodes.
//!
//! φ = 12 EI/(κGA h²): φ = 0 is the cubic of Hermite, φ > 0 the locking-free Timoshenko element, whose shear strain is constant.
//! Source: Friedman & Kosmatka 1993, Computers & Structures 47.

use crate::track::Member;

/// Five points and weights of Gauss on 0 … 1: exact to the ninth power, all products here.
pub(super) const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// One element of length h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    h: f64,
    phi: f64,
}

impl Shape {
    /// Of length `h` [m] of a `beam`; of members that do not bend Hermite's.
    pub fn new(h: f64, beam: Option<&Member>) -> Self {
        let phi = beam.map_or(0.0, |beam| 12.0 * beam.bending_stiffness * beam.shear_compliance / (h * h));
        Self { h, phi }
    }

    /// N: w at ξ = `xi` of 0 … 1 per unknown [1, m, 1, m].
    pub fn displacement(&self, xi: f64) -> [f64; 4] {
        let (h, phi) = (self.h, self.phi);
        let q = 1.0 / (1.0 + phi);
        let (x2, x3) = (xi * xi, xi * xi * xi);
        [
            q * (2.0 * x3 - 3.0 * x2 - phi * xi + 1.0 + phi),
            q * h * (x3 - (2.0 + 0.5 * phi) * x2 + (1.0 + 0.5 * phi) * xi),
            q * (-2.0 * x3 + 3.0 * x2 + phi * xi),
            q * h * (x3 - (1.0 - 0.5 * phi) * x2 - 0.5 * phi * xi),
        ]
    }

    /// w′ at `xi` per unknown [1/m, 1, 1/m, 1].
    pub fn slope(&self, xi: f64) -> [f64; 4] {
        let (h, phi) = (self.h, self.phi);
        let q = 1.0 / (1.0 + phi);
        let first = q * (6.0 * xi * xi - 6.0 * xi - phi) / h;
        [
            first,
            q * (3.0 * xi * xi - (4.0 + phi) * xi + 1.0 + 0.5 * phi),
            -first,
            q * (3.0 * xi * xi - (2.0 - phi) * xi - 0.5 * phi),
        ]
    }

    /// θ at `xi` per unknown [1/m, 1, 1/m, 1].
    pub fn rotation(&self, xi: f64) -> [f64; 4] {
        let (h, phi) = (self.h, self.phi);
        let q = 1.0 / (1.0 + phi);
        let first = 6.0 * q * (xi * xi - xi) / h;
        [
            first,
            q * (3.0 * xi * xi - (4.0 + phi) * xi + 1.0 + phi),
            -first,
            q * (3.0 * xi * xi - (2.0 - phi) * xi),
        ]
    }

    /// θ′ at `xi` per unknown [1/m², 1/m, 1/m², 1/m].
    pub fn curvature(&self, xi: f64) -> [f64; 4] {
        let (h, phi) = (self.h, self.phi);
        let q = 1.0 / (1.0 + phi);
        let first = 6.0 * q * (2.0 * xi - 1.0) / (h * h);
        [first, q * (6.0 * xi - 4.0 - phi) / h, -first, q * (6.0 * xi - 2.0 + phi) / h]
    }

    /// EI times the flexibility [m³] at `xi` of the element with both nodes held, which nodal values miss under a point load:
    /// h³p(φ² + φ(1 + p) + 4p²)/(12(1 + φ)), p = ξ(1 − ξ); h³p³/3 of Euler–Bernoulli beams.
    pub fn held_flexibility(&self, xi: f64) -> f64 {
        let (h, phi, p) = (self.h, self.phi, xi * (1.0 - xi));
        h.powi(3) * p * (phi * phi + phi * (1.0 + p) + 4.0 * p * p) / (12.0 * (1.0 + phi))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rail(shear: bool) -> Member {
        if shear {
            Member::timoshenko(6.38e6, 60.23, 2.364e8, 0.239, 0.0).unwrap()
        } else {
            Member::beam(6.38e6, 60.23, 0.0).unwrap()
        }
    }

    #[test]
    fn slopes_are_those_of_the_shapes_and_shear_is_constant() {
        for shear in [false, true] {
            let shape = Shape::new(0.15, Some(&rail(shear)));
            let e = 1e-6;
            for xi in [0.1, 0.35, 0.5, 0.92] {
                let slope = |f: &dyn Fn(f64) -> f64| (f(xi + e) - f(xi - e)) / (2.0 * e * 0.15);
                for (i, curvature) in shape.curvature(xi).into_iter().enumerate() {
                    // central differences of cubics: e², and rounding of 1e-16/e
                    let found = slope(&|x| shape.displacement(x)[i]);
                    assert!((found - shape.slope(xi)[i]).abs() < 1e-8 / 0.15);
                    assert!((slope(&|x| shape.rotation(x)[i]) - curvature).abs() < 1e-7 / 0.15);
                    // γ = w′ − θ is the same everywhere, zero without shear
                    let gamma = |x: f64| shape.slope(x)[i] - shape.rotation(x)[i];
                    assert!((gamma(xi) - gamma(0.0)).abs() < 1e-13 && (shear || gamma(xi).abs() < 1e-14));
                }
            }
            // unit displacement and rotation move it as a rigid body
            let n = shape.displacement(0.3);
            assert!((n[0] + n[2] - 1.0).abs() < 1e-15);
            assert!((n[1] + n[3] + 0.15 * n[2] - 0.3 * 0.15).abs() < 1e-16);
        }
    }

    #[test]
    fn held_flexibility_is_that_of_a_clamped_beam() {
        // middle of a clamped beam: h³/192EI + h/4κGA, and φ = 12EI/κGAh²
        for shear in [false, true] {
            let (beam, h) = (rail(shear), 0.3);
            let got = Shape::new(h, Some(&beam)).held_flexibility(0.5) / beam.bending_stiffness;
            let exact = h.powi(3) / (192.0 * beam.bending_stiffness) + 0.25 * h * beam.shear_compliance;
            assert!((got / exact - 1.0).abs() < 1e-14, "{got} {exact}");
        }
    }
}
