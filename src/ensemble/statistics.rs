//! What many samples say: quantiles, probabilities with their error, rank correlations.

use crate::math::normal;

/// Probabilities that are told of everything.
pub const SHARES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// z of a two-sided 95 % interval.
const Z: f64 = 1.959_963_984_540_054;

/// The value below which the share `p` of `sorted` lies, between its neighbours by the chord (type 7 of Hyndman & Fan 1996, as NumPy).
/// NaN of nothing.
pub fn quantile(sorted: &[f64], p: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = p * last as f64;
    let i = (place as usize).min(last);
    let above = sorted[(i + 1).min(last)];
    sorted[i] + (place - i as f64) * (above - sorted[i])
}

/// The values without gaps, ascending.
pub fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Between which values the quantile `p` of the whole distribution lies, with 95 %: those of the ranks n p ± 1.96 √(n p (1 − p)).
///
/// Of independent samples; a Latin hypercube is mostly nearer.
pub fn quantile_interval(sorted: &[f64], p: f64) -> (f64, f64) {
    let n = sorted.len() as f64;
    let half = Z * (n * p * (1.0 - p)).sqrt();
    let at = |rank: f64| quantile(sorted, (rank / n).clamp(0.0, 1.0));
    (at(n * p - half), at(n * p + half))
}

/// Between which values a probability lies, with 95 %, of which `hits` of `n` independent samples have been seen.
///
/// Source: Wilson 1927, Probable inference, the law of succession, and statistical inference, J. Am. Stat. Assoc. 22:209–212.
pub fn share_interval(hits: usize, n: usize) -> (f64, f64) {
    if n == 0 {
        return (0.0, 1.0);
    }
    let (n, p) = (n as f64, hits as f64 / n as f64);
    let middle = p + Z * Z / (2.0 * n);
    let half = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    let whole = 1.0 + Z * Z / n;
    (((middle - half) / whole).max(0.0), ((middle + half) / whole).min(1.0))
}

/// Ranks from 1, equal values sharing theirs.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut from = 0;
    while from < order.len() {
        let to =
            (from..order.len()).find(|i| values[order[*i]] != values[order[from]]).unwrap_or(order.len());
        let shared = 0.5 * (from + 1 + to) as f64;
        order[from..to].iter().for_each(|i| ranks[*i] = shared);
        from = to;
    }
    ranks
}

/// Spearman's rank correlation; None where one of both does not vary.
pub fn rank_correlation(x: &[f64], y: &[f64]) -> Option<f64> {
    let (x, y) = (ranks(x), ranks(y));
    let mean = 0.5 * (x.len() as f64 + 1.0);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>();
    let r = product(&x, &y) / (product(&x, &x) * product(&y, &y)).sqrt();
    r.is_finite().then_some(r)
}

/// The size a rank correlation of `n` samples must have to be told from none, with 95 %: 1.96/√(n − 1).
pub fn least_correlation(n: usize) -> f64 {
    normal::quantile(0.975) / (n as f64 - 1.0).max(1.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_numpy() {
        let values = [1.0, 2.0, 4.0, 8.0];
        // numpy.quantile([1, 2, 4, 8], [0, 0.05, 0.5, 0.95, 1])
        for (p, expected) in [(0.0, 1.0), (0.05, 1.15), (0.5, 3.0), (0.95, 7.4), (1.0, 8.0)] {
            assert!((quantile(&values, p) - expected).abs() < 1e-14, "{p}");
        }
        assert!(quantile(&[], 0.5).is_nan());
        assert_eq!(sorted([2.0, f64::NAN, 1.0].into_iter()), [1.0, 2.0]);
    }

    #[test]
    fn shares_have_wilsons_interval() {
        // Newcombe 1998, Statistics in Medicine 17:857, table I: 81/263, 15/148, 0/20, 1/29
        for (hits, n, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let (a, b) = share_interval(hits, n);
            assert!((a - low).abs() < 6e-5 && (b - high).abs() < 6e-5, "{hits}/{n}: {a} {b}");
        }
        assert_eq!(share_interval(0, 0), (0.0, 1.0));
    }

    #[test]
    fn a_median_lies_in_its_interval() {
        let values: Vec<f64> = (1..=100).map(f64::from).collect();
        let (low, high) = quantile_interval(&values, 0.5);
        // ranks 50 ± 9.8
        assert!((low - 40.8).abs() < 0.3 && (high - 60.4).abs() < 0.3, "{low} {high}");
    }

    #[test]
    fn rank_correlations_are_spearmans() {
        // Spearman's own kind of example: 1 − 6 Σd²/(n(n² − 1)) with Σd² = 194, n = 10
        let iq = [106.0, 100.0, 86.0, 101.0, 99.0, 103.0, 97.0, 113.0, 112.0, 110.0];
        let tv = [7.0, 27.0, 2.0, 50.0, 28.0, 29.0, 20.0, 12.0, 6.0, 17.0];
        assert!((rank_correlation(&iq, &tv).unwrap() + 29.0 / 165.0).abs() < 1e-14);
        // ties share their ranks: scipy.stats.spearmanr([1, 2, 2, 3], [1, 3, 2, 4]) = 0.948683
        let tied = rank_correlation(&[1.0, 2.0, 2.0, 3.0], &[1.0, 3.0, 2.0, 4.0]).unwrap();
        assert!((tied - 0.948_683_298_050_513_8).abs() < 1e-14, "{tied}");
        assert_eq!(rank_correlation(&[1.0, 1.0], &[1.0, 2.0]), None);
    }
}
