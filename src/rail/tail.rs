//! What ũ(β) becomes at short waves, taken out of quadratures and put back in closed form.

use crate::math::expression::Polynomial;
use crate::track::{Ratio, Stack};
use num_complex::Complex64;

const ZERO: Complex64 = Complex64::ZERO;

/// Terms taken out.
const TERMS: usize = 4;

/// Σ c_k/(β² + s²)ᵏ, k = 1 … 4, that part of ũ(β) which falls more slowly than β⁻¹⁰.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tail {
    /// c_k [m^(1 − 2k)/N]
    terms: [Complex64; TERMS],
    /// s [rad/m]
    scale: f64,
}

impl Tail {
    /// Of ũ = n(X)/d(X), X = β², around the `scale` s [rad/m] of its poles: with X = y − s² the series of n/d in 1/y.
    pub fn new(ratio: &Ratio, scale: f64) -> Self {
        let shifted = |p: &[Complex64]| -> Vec<Complex64> {
            // Horner with y − s², the highest power first
            let mut shifted: Vec<Complex64> = Vec::new();
            for coefficient in p.iter().rev() {
                let lower: Vec<Complex64> = shifted.iter().map(|c| -scale * scale * c).collect();
                shifted.push(Complex64::ZERO);
                for (i, c) in lower.iter().enumerate() {
                    shifted[i + 1] += c;
                }
                if let Some(last) = shifted.last_mut() {
                    *last += coefficient;
                }
            }
            shifted
        };
        let (n, d) = (shifted(ratio.numerator.coefficients()), shifted(ratio.denominator.coefficients()));
        // n/d = Σ q_i y^(i₀ − i), by long division from the highest power
        let first = d.len() - n.len();
        let mut terms = [Complex64::ZERO; TERMS];
        for k in first..=TERMS {
            let i = k - first;
            let known: Complex64 = (1..=i).map(|j| at(&d, j) * terms[i - j + first - 1]).sum();
            terms[k - 1] = (at(&n, i) - known) / d[0];
        }
        Self { terms, scale }
    }

    /// c₁/(β² + s²) + c₂/(β² + s²)² with s = `scale` [rad/m].
    pub fn of_two(first: Complex64, second: Complex64, scale: f64) -> Self {
        let mut terms = [Complex64::ZERO; TERMS];
        (terms[0], terms[1]) = (first, second);
        Self { terms, scale }
    }

    /// Of the rail of `stack` alone under a point: of one that shears c₁ = 1/(κGA − mv²); of one that bends what it does on its first
    /// link at rest, which leaves β⁻⁷ of what damps the link; of others nothing. Where v ≠ 0 its loss stays.
    pub fn of_rail(stack: &Stack, omega: f64, speed: f64) -> Self {
        let Some(rail) = stack.members().first() else { return Self::of_two(ZERO, ZERO, 1.0) };
        if let Some((c, scale)) = rail.at_short_waves(omega, speed) {
            return Self::of_two(c, ZERO, scale);
        }
        let link = stack.links().first().map_or(0.0, |link| link.stiffness(0.0).upper.re);
        match rail.on_springs(link, omega, speed) {
            Some(d) if link > 0.0 => {
                let scale = (link / d[2].norm()).sqrt().sqrt();
                let (numerator, denominator) = (Polynomial::constant(1.0), Polynomial::new(d.to_vec()));
                Self::new(&Ratio { numerator, denominator }, scale)
            }
            _ => Self::of_two(ZERO, ZERO, 1.0),
        }
    }

    /// Whether nothing is taken out.
    pub fn is_none(&self) -> bool {
        self.terms.iter().all(|c| *c == Complex64::ZERO)
    }

    /// Distance [m] beyond which less than e⁻³⁶ z³ of it is left, 1e-11.
    pub fn reach(&self) -> f64 {
        36.0 / self.scale
    }

    /// At wavenumber `beta` [rad/m], [m per N/m].
    pub fn of(&self, beta: f64) -> Complex64 {
        let y = (beta * beta + self.scale * self.scale).recip();
        self.terms.iter().rev().fold(Complex64::ZERO, |sum, c| (sum + c) * y)
    }

    /// At `x` [m] from the force [m/N]: (1/2π)∫ e^{iβx}(β² + s²)⁻ᵏ dβ is e^{−z}/2s times 1, (1 + z)/2s², (3 + 3z + z²)/8s⁴,
    /// (15 + 15z + 6z² + z³)/48s⁶ with z = s|x|.
    pub fn at(&self, x: f64) -> Complex64 {
        let (s2, z) = (self.scale * self.scale, self.scale * x.abs());
        let polynomials = [
            1.0,
            (1.0 + z) / (2.0 * s2),
            (3.0 + z * (3.0 + z)) / (8.0 * s2 * s2),
            (15.0 + z * (15.0 + z * (6.0 + z))) / (48.0 * s2 * s2 * s2),
        ];
        let sum: Complex64 = self.terms.iter().zip(polynomials).map(|(c, p)| c * p).sum();
        sum * (-z).exp() / (2.0 * self.scale)
    }
}

fn at(p: &[Complex64], i: usize) -> Complex64 {
    p.get(i).copied().unwrap_or_default()
}

/// c₁/(β² + s²) + c₂/(β² + s²)² from the values of any ũ(β) at short waves, where no polynomial is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted(Tail);

impl Fitted {
    /// Of `u` = ũ(β), whose poles are of the `scale` s [rad/m]: c₁ = lim β²ũ by one step of Richardson, then c₂ of what is left.
    pub fn new(u: &impl Fn(f64) -> Complex64, scale: f64) -> Self {
        let mut terms = [Complex64::ZERO; TERMS];
        for k in 0..2 {
            // even part alone; short enough for the limit, long enough for its digits
            let far = scale * [1e3, 60.0][k];
            let rest = |beta: f64| {
                let tail = Self(Tail { terms, scale }).of(beta);
                let y = beta * beta + scale * scale;
                (0.5 * (u(beta) + u(-beta)) - tail) * y.powi(1 + k as i32)
            };
            terms[k] = (4.0 * rest(2.0 * far) - rest(far)) / 3.0;
        }
        Self(Tail { terms, scale })
    }

    /// As [`Tail::of`].
    pub fn of(&self, beta: f64) -> Complex64 {
        self.0.of(beta)
    }

    /// As [`Tail::at`].
    pub fn at(&self, x: f64) -> Complex64 {
        self.0.at(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foundation::{FoundationModel, Springs};
    use crate::math::expression::Polynomial;
    use crate::track::{Link, Member, Stack, Tower};

    #[test]
    fn nothing_is_left_at_short_waves() {
        let rail = Member::timoshenko(6.4e6, 60.0, 2.4e8, 0.24, 0.01).unwrap();
        let stack = Stack::new(vec![rail], vec![Link::spring(4.5e8, 3e4, 0.0).unwrap()]);
        let rock = Springs::new(FoundationModel::Rigid).unwrap();
        let tower = Tower::new(&stack, rock.stack()).unwrap();
        let omega = 3000.0;
        let ratio = tower.compliance(&Polynomial::variable(), &Polynomial::constant(omega)).unwrap();
        let u = |beta: f64| 1.0 / tower.stiffness((beta * beta).into(), omega)[0];
        let (tail, fitted) = (Tail::new(&ratio, 3.0), Fitted::new(&u, 3.0));
        let left = |beta: f64| (u(beta) - tail.of(beta)).norm();
        // ∝ β⁻¹⁰: 2⁻¹⁰ = 9.8e-4; measured 9.3e-4
        let order = left(60.0) / left(30.0);
        assert!(order > 5e-4 && order < 2e-3, "{order:e}");
        let order = (u(200.0) - fitted.of(200.0)).norm() / (u(100.0) - fitted.of(100.0)).norm();
        // ∝ β⁻⁶: 1.6e-2
        assert!(order < 3e-2, "{order:e}");
    }

    #[test]
    fn tails_are_transformed() {
        // (1/π)∫₀^∞ cos βx/(β² + s²)ᵏ dβ by the trapezoidal rule, which is exact to its images
        for k in 0..TERMS {
            let mut terms = [Complex64::ZERO; TERMS];
            terms[k] = Complex64::ONE;
            let tail = Tail { terms, scale: 1.7 };
            for x in [0.0, 0.8] {
                let sum: f64 =
                    (1..400_000).map(|i| 0.05 * f64::from(i)).map(|b| tail.of(b).re * (b * x).cos()).sum();
                let found = 0.05 * (0.5 * tail.of(0.0).re + sum) / std::f64::consts::PI;
                // measured 5.4e-5 of the first, cut off at β = 2e4, and 1e-12 of the others
                assert!(
                    (found - tail.at(x).re).abs() < 1e-4 * tail.at(0.0).re,
                    "{k} {x}: {found} {}",
                    tail.at(x)
                );
            }
        }
    }
}
