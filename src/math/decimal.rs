//! Evenly spaced values at the decimals they stand for.

/// from + i·step for i = 0 … `count` − 1, each at the decimal of twelve digits beside it, if there is one within rounding.
///
/// Where both are decimals the sum misses its decimal by a few bits: 1 + 7 × 0.1 = 1.7000000000000002, which no one finds by
/// asking for 1.7. Other values, such as speeds from km/h, stay as they are.
///
/// Accuracy: changes a value by at most 2ε(|from| + i|step|), the rounding of the sum itself (`decimals_are_met`).
pub fn arithmetic(from: f64, step: f64, count: usize) -> Vec<f64> {
    let value = |i: usize| {
        let way = step * i as f64;
        nearest(from + way, from.abs() + way.abs())
    };
    (0..count).map(value).collect()
}

/// The decimal of twelve digits of `size` beside `value`, if within its rounding.
fn nearest(value: f64, size: f64) -> f64 {
    let decimals = (11.0 - size.log10().floor()).clamp(0.0, 300.0) as usize;
    let decimal = format!("{value:.decimals$}").parse().unwrap_or(value);
    // + 0.0: no negative zero
    if (decimal - value).abs() <= 2.0 * f64::EPSILON * size { decimal + 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_met() {
        for (from, step, decimals) in [
            (1.0, 0.1, 1),
            (-40.0, 0.1, 1),
            (-0.3, 0.1, 1),
            (0.07, 0.01, 2),
            (1e-9, 1e-10, 10),
            (2e6, 0.05, 2),
        ] {
            for (i, value) in arithmetic(from, step, 2000).into_iter().enumerate() {
                let sum = from + step * i as f64;
                let wanted: f64 = format!("{sum:.decimals$}").parse().unwrap();
                assert!(value == wanted, "{from} + {i} × {step}: {value:?}, not {wanted:?}");
                assert!(value != 0.0 || value.is_sign_positive());
            }
        }
    }

    #[test]
    fn what_is_no_decimal_stays() {
        let (from, step) = (50.0 / 3.6, 10.0 / 3.6);
        let values = arithmetic(from, step, 50);
        // every ninth is: 150 km/h and so on are 41.666…, but 90 km/h is 25
        assert!(values.iter().enumerate().all(|(i, v)| (v - (from + step * i as f64)).abs() <= 1e-14 * v));
        assert_eq!((values[1], values[4]), (from + step, 25.0));
        assert_eq!(arithmetic(0.0, 1.0, 2), [0.0, 1.0]);
    }
}
