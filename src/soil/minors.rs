//! The 2 × 2 minors of two P–SV solutions, carried upward layer by layer: in complex numbers by `transfer_matrix`, in real ones, which
//! undamped ground allows and which cost a quarter, by `real_secular`.

use nalgebra::ComplexField;

/// Coefficients of exp(±Bh), all times e^{−scale}, about the node n = d² of the divided differences or its real part:
///
/// ```text
/// cosh Bh = even₀ + even₁ B² + even₂ B²(B² − n)
/// sinh Bh = B (odd₀ + odd₁ (B² − n))
/// ```
pub(super) struct Exponential<T> {
    pub node: T,
    /// even₀
    pub unit: f64,
    /// even₁, even₂
    pub even: [T; 2],
    pub odd: [T; 2],
    /// Re(p + s)h, the logarithm of what was divided out.
    pub scale: f64,
}

/// What B is made of.
#[derive(Clone, Copy)]
pub(super) struct Generator<T> {
    /// k [rad/m]
    pub k: T,
    /// γ = (c_s/c_p)²
    pub gamma: T,
    /// k_s² [rad²/m²]
    pub ks2: T,
}

/// The minors m_uw, m_ut, m_ur, m_wt, m_tr of two solutions, tractions in the unit of a modulus.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minors<T>(pub [T; 5]);

impl<T: ComplexField<RealField = f64> + Copy> Minors<T> {
    /// B m
    #[inline]
    fn derivative(&self, b: Generator<T>) -> Self {
        let [uw, ut, ur, wt, tr] = self.0;
        let Generator { k, gamma, ks2 } = b;
        let one = T::one();
        let stiffness = ((one - gamma) * (k * k)).scale(4.0) - ks2;
        let rest = (one - gamma.scale(2.0)) * k;
        Self([
            gamma * ur - wt,
            -k * wt - rest * ur,
            k.scale(2.0) * ut + tr - ks2 * uw,
            rest.scale(2.0) * ut - gamma * tr - stiffness * uw,
            stiffness * ur + ks2 * wt,
        ])
    }

    #[inline]
    fn plus(self, other: Self, factor: T) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i] * factor))
    }

    /// Times a real number.
    #[inline]
    pub fn times(self, factor: f64) -> Self {
        Self(self.0.map(|m| m.scale(factor)))
    }

    /// Tractions in another unit, `ratio` of the old one to it.
    #[inline]
    pub fn in_unit(self, ratio: T) -> Self {
        let [uw, ut, ur, wt, tr] = self.0;
        Self([uw, ut * ratio, ur * ratio, wt * ratio, tr * (ratio * ratio)])
    }

    /// exp(−Bh) m, times e^{−scale}: the same solutions a layer higher.
    #[inline]
    pub fn lifted(self, b: Generator<T>, e: &Exponential<T>) -> Self {
        let first = self.derivative(b);
        let second = first.derivative(b);
        // (B² − n) B m and (B² − n) B² m
        let third = second.derivative(b).plus(first, -e.node);
        let fourth = third.derivative(b);
        self.times(e.unit)
            .plus(second, e.even[0])
            .plus(fourth, e.even[1])
            .plus(first, -e.odd[0])
            .plus(third, -e.odd[1])
    }
}
