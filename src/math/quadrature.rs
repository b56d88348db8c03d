//! Adaptive Gauss–Kronrod quadrature of complex functions of a real variable: value, error, count.

use num_complex::Complex64;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Positive Kronrod abscissae of the 7–15 pair on [−1, 1], largest first; odd places are Gauss points (QUADPACK `qk15`).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
/// Kronrod weights of `NODES`.
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_83,
];
/// Gauss weights of the odd places of `NODES`.
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// An integral with its error estimate and its price.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The integral.
    pub value: Complex64,
    /// Estimated absolute error.
    pub error: f64,
    /// Evaluations of the integrand.
    pub count: usize,
    /// True if the error met the tolerance within the allowed evaluations.
    pub converged: bool,
}

/// `error` over what was `allowed`: at most 1 where it was met, infinite where nothing is known.
pub fn miss(error: f64, allowed: f64) -> f64 {
    let factor = error / allowed;
    // written so that NaN is missed
    if error <= allowed {
        factor.min(1.0)
    } else if factor.is_nan() {
        f64::INFINITY
    } else {
        factor
    }
}

impl Estimate {
    /// Error over what was allowed, `relative` of the value: at most 1 where that was met, or what was asked for, as it is by those
    /// who ask for more.
    pub fn miss(&self, relative: f64) -> f64 {
        let factor = miss(self.error, relative * self.value.norm());
        if self.converged { factor.min(1.0) } else { factor }
    }
}

/// Fifteen samples of one panel: abscissae, Kronrod weights scaled to the panel, and values.
#[derive(Clone, Debug)]
struct Panel {
    /// Abscissae, ascending.
    x: [f64; 15],
    /// Weights, so that Σ w f(x) is the integral over the panel.
    w: [f64; 15],
    /// Values of the integrand.
    f: [Complex64; 15],
    from: f64,
    to: f64,
    value: Complex64,
    error: f64,
}

/// Kronrod's fifteen abscissae between `from` and `to`, ascending, and their weights.
pub fn kronrod(from: f64, to: f64) -> ([f64; 15], [f64; 15]) {
    let (centre, half) = (0.5 * (from + to), 0.5 * (to - from));
    let x = std::array::from_fn(|i| centre + half * if i < 8 { -NODES[i] } else { NODES[14 - i] });
    let w = std::array::from_fn(|i| half * KRONROD[if i < 8 { i } else { 14 - i }]);
    (x, w)
}

impl Panel {
    fn new(f: &mut impl Integrand, from: f64, to: f64) -> Self {
        let half = 0.5 * (to - from);
        let (x, w) = kronrod(from, to);
        let mut panel = Self { x, w, f: f.values(&x), from, to, value: Complex64::ZERO, error: 0.0 };
        let mut gauss = Complex64::ZERO;
        for i in 0..15 {
            let j = if i < 8 { i } else { 14 - i };
            panel.value += panel.f[i] * panel.w[i];
            if j % 2 == 1 {
                gauss += panel.f[i] * (half * GAUSS[j / 2]);
            }
        }
        // QUADPACK's sharpening: (200 |K − G| / ∫|f − mean|)^{3/2}, since K is far better than G
        let mean = panel.value / (to - from);
        let spread: f64 = (0..15).map(|i| (panel.f[i] - mean).norm_sqr().sqrt() * panel.w[i]).sum();
        let difference = (panel.value - gauss).norm();
        panel.error = if spread > 0.0 && difference > 0.0 {
            spread * (200.0 * difference / spread).powf(1.5).min(1.0)
        } else {
            difference
        };
        if !panel.error.is_finite() {
            panel.error = f64::INFINITY;
        }
        panel
    }
}

impl PartialEq for Panel {
    fn eq(&self, other: &Self) -> bool {
        self.error == other.error
    }
}
impl Eq for Panel {}
impl PartialOrd for Panel {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Panel {
    fn cmp(&self, other: &Self) -> Ordering {
        self.error.total_cmp(&other.error)
    }
}

/// What is integrated, asked for all nodes of a panel at once.
pub trait Integrand {
    /// f at every `x`.
    fn values(&mut self, x: &[f64; 15]) -> [Complex64; 15];
}

impl<F: FnMut(f64) -> Complex64> Integrand for F {
    fn values(&mut self, x: &[f64; 15]) -> [Complex64; 15] {
        x.map(self)
    }
}

/// A function of all nodes of a panel.
pub struct Together<F>(pub F);

impl<F: FnMut(&[f64; 15]) -> [Complex64; 15]> Integrand for Together<F> {
    fn values(&mut self, x: &[f64; 15]) -> [Complex64; 15] {
        (self.0)(x)
    }
}

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Wanted error relative to the modulus of the integral.
    pub relative: f64,
    /// Wanted absolute error; the larger of the two counts.
    pub absolute: f64,
    /// Evaluations allowed.
    pub max_count: usize,
}

/// An integral under refinement: panels may be added until the caller knows where to stop.
pub struct Adaptive {
    panels: BinaryHeap<Panel>,
    value: Complex64,
    count: usize,
}

impl Default for Adaptive {
    fn default() -> Self {
        Self::new()
    }
}

impl Adaptive {
    /// An integral over nothing yet.
    pub fn new() -> Self {
        Self { panels: BinaryHeap::new(), value: Complex64::ZERO, count: 0 }
    }

    /// Adds the panels between consecutive `breakpoints` (ascending).
    pub fn add(&mut self, f: &mut impl Integrand, breakpoints: &[f64]) {
        for pair in breakpoints.windows(2) {
            if pair[1] > pair[0] {
                let panel = Panel::new(f, pair[0], pair[1]);
                self.value += panel.value;
                self.count += 15;
                self.panels.push(panel);
            }
        }
    }

    /// The integral over the panels so far.
    pub fn value(&self) -> Complex64 {
        self.value
    }

    /// Halves the panel of largest error until the sum of errors meets `tolerance`, counting the added
    /// constant `offset` to the integral when judging the relative error.
    pub fn refine(&mut self, f: &mut impl Integrand, offset: Complex64, tolerance: Tolerance) -> Estimate {
        let mut error: f64 = self.panels.iter().map(|p| p.error).sum();
        loop {
            let goal = tolerance.absolute.max(tolerance.relative * (self.value + offset).norm());
            let converged = error <= goal;
            let Some(worst) = self.panels.peek() else {
                break;
            };
            // below the rounding of the panel's own ends nothing can be gained by halving
            let exhausted = worst.to - worst.from <= 1e-13 * worst.to.abs();
            if converged || self.count + 30 > tolerance.max_count || exhausted {
                break;
            }
            let Some(worst) = self.panels.pop() else { break };
            let middle = 0.5 * (worst.from + worst.to);
            let left = Panel::new(f, worst.from, middle);
            let right = Panel::new(f, middle, worst.to);
            self.value += left.value + right.value - worst.value;
            error += left.error + right.error - worst.error;
            self.count += 30;
            self.panels.push(left);
            self.panels.push(right);
        }
        // a fresh sum: the running one carries the rounding of every difference
        self.value = self.panels.iter().map(|p| p.value).sum();
        let error: f64 = self.panels.iter().map(|p| p.error).sum();
        let goal = tolerance.absolute.max(tolerance.relative * (self.value + offset).norm());
        Estimate { value: self.value, error, count: self.count, converged: error <= 1.0001 * goal }
    }

    /// Where its panels begin, in ascending order.
    pub fn starts(&self) -> Vec<f64> {
        let mut starts: Vec<f64> = self.panels.iter().map(|p| p.from).collect();
        starts.sort_by(f64::total_cmp);
        starts
    }

    /// Its nodes, in ascending order: a rule for related integrands.
    pub fn into_rule(self) -> Rule {
        let mut panels = self.panels.into_vec();
        panels.sort_by(|a, b| a.from.total_cmp(&b.from));
        let nodes =
            panels.iter().flat_map(|p| (0..15).map(|i| Node { x: p.x[i], weight: p.w[i], value: p.f[i] }));
        Rule(nodes.collect())
    }
}

/// `points` with others between them, so that none are farther apart than `widest`.
pub fn subdivided(points: &[f64], widest: f64) -> Vec<f64> {
    let mut fine = points[..1].to_vec();
    for pair in points.windows(2) {
        let parts = ((pair[1] - pair[0]) / widest).ceil().max(1.0);
        fine.extend((1..=parts as usize).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / parts));
    }
    fine
}

/// A settled integral: Σ `weight` · `value` is ∫ f dx.
#[derive(Clone, Debug, Default)]
pub struct Rule(pub Vec<Node>);

/// One node of a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// x
    pub x: f64,
    /// What f(x) counts.
    pub weight: f64,
    /// f(x)
    pub value: Complex64,
}

/// ∫ f over consecutive `breakpoints` by global adaptive Gauss–Kronrod 7–15 (QUADPACK `qag`).
///
/// Accuracy: `Estimate::error`, usually far too large; `converged` is false where it could not be met.
/// Source: Piessens et al. 1983, QUADPACK.
pub fn integrate(mut f: impl FnMut(f64) -> Complex64, breakpoints: &[f64], tolerance: Tolerance) -> Estimate {
    let mut integral = Adaptive::new();
    integral.add(&mut f, breakpoints);
    integral.refine(&mut f, Complex64::ZERO, tolerance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIGHT: Tolerance = Tolerance { relative: 1e-12, absolute: 0.0, max_count: 100_000 };

    #[test]
    fn finds_a_pole_close_to_the_path() {
        // ∫_0^3 dx/(x − z) = ln((3 − z)/(−z)), z = 1.234 − 1e-6 i; measured 2e-15
        let z = Complex64::new(1.234, -1e-6);
        let got = integrate(|x| 1.0 / (x - z), &[0.0, 3.0], TIGHT);
        let exact = (3.0 - z).ln() - (-z).ln();
        assert!(got.converged);
        assert!((got.value - exact).norm() < 1e-11 * exact.norm(), "{got:?} {exact}");
    }

    #[test]
    fn reports_when_it_cannot() {
        let got =
            integrate(|x| Complex64::new(1.0 / x, 0.0), &[0.0, 1.0], Tolerance { max_count: 600, ..TIGHT });
        assert!(!got.converged);
        assert!(got.count <= 600);
    }

    #[test]
    fn a_miss_is_error_over_allowed() {
        assert_eq!((miss(3.0, 2.0), miss(1.0, 2.0), miss(0.0, 0.0)), (1.5, 0.5, 1.0));
        assert_eq!(
            (miss(1.0, 0.0), miss(f64::NAN, 1.0), miss(1.0, f64::NAN)),
            (f64::INFINITY, f64::INFINITY, f64::INFINITY)
        );
        let estimate =
            |converged| Estimate { value: Complex64::new(0.0, 2.0), error: 3e-3, count: 15, converged };
        assert!(
            (estimate(false).miss(1e-3) - 1.5).abs() < 1e-12
                && (estimate(false).miss(1e-2) - 0.15).abs() < 1e-12
        );
        // who asked for another measure and got it has missed nothing
        assert_eq!(estimate(true).miss(1e-3), 1.0);
    }

    #[test]
    fn weights_integrate_polynomials_exactly() {
        let mut integral = Adaptive::new();
        integral.add(&mut |x: f64| Complex64::new(x.powi(22), 0.0), &[0.0, 0.5, 2.0]);
        assert!((integral.value().re / (2f64.powi(23) / 23.0) - 1.0).abs() < 1e-14);
    }
}
