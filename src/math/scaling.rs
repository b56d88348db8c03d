//! Powers of two taken out of numbers that grow or shrink along a product: every digit is kept.

/// 2⁻ⁿ and n ln 2 with 2ⁿ ≤ `size` < 2ⁿ⁺¹; 1 and 0 for zero and for what is not a normal number.
pub fn power_of_two(size: f64) -> (f64, f64) {
    if !size.is_normal() {
        return (1.0, 0.0);
    }
    // the exponent as IEEE 754 stores it; 2⁻¹⁰²³ is no normal number
    let power = ((size.to_bits() >> 52 & 0x7ff) as i64 - 1023).min(1022);
    (f64::from_bits(((1023 - power) as u64) << 52), power as f64 * std::f64::consts::LN_2)
}

#[cfg(test)]
mod tests {
    use super::power_of_two;

    #[test]
    fn what_is_left_lies_between_one_and_two() {
        for size in [f64::MIN_POSITIVE, 3e-200, 0.7, 1.0, 1.9999, 2.0, 5e123, 8e307] {
            let (factor, log) = power_of_two(size);
            assert!((1.0..2.0).contains(&(size * factor)), "{size:e}");
            assert!(((1.0 / factor).ln() - log).abs() < 1e-12 * log.abs().max(1.0), "{size:e}");
        }
        for none in [0.0, f64::INFINITY, f64::NAN, 1e-310] {
            assert_eq!(power_of_two(none), (1.0, 0.0));
        }
    }
}
