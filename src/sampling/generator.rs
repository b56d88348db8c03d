//! Random numbers that depend on what they are for, and on nothing else: not on order, shard or thread.

use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// What draws the numbers: stored with every result, as another one would draw others.
pub const GENERATOR: &str = "ChaCha12 keyed by seed and FNV-1a of the key, the sample its stream";

/// The number of (`seed`, `key`, `sample`), uniform above 0 and below 1: the middle of one of 2⁵² equal parts.
///
/// The first 64 bits of ChaCha with 12 rounds (Bernstein 2008), whose key is the seed and [`fingerprint`] of `key`, and whose
/// stream is `sample`.
pub fn uniform(seed: u64, key: &str, sample: u64) -> f64 {
    let mut secret = [0; 32];
    secret[..8].copy_from_slice(&seed.to_le_bytes());
    secret[8..16].copy_from_slice(&fingerprint(key.as_bytes()).to_le_bytes());
    let mut generator = ChaCha12Rng::from_seed(secret);
    generator.set_stream(sample);
    ((generator.next_u64() >> 12) as f64 + 0.5) * (-52f64).exp2()
}

/// FNV-1a of `bytes`, 64 bits (Fowler, Noll & Vo): tells texts apart, the same on every machine and in every version.
pub fn fingerprint(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fingerprints_are_the_published_ones() {
        // Fowler, Noll & Vo, test vectors of FNV-1a
        assert_eq!(fingerprint(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fingerprint(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fingerprint(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn a_seed_means_the_same_numbers_next_year() {
        let of = |(seed, key, i)| uniform(seed, key, i);
        let numbers = [(1, "a", 0), (1, "a", 1), (1, "b", 0), (2, "a", 0)].map(of);
        let fixed = [
            0.312_337_351_181_128_15,
            0.651_521_256_533_237_9,
            0.552_980_626_091_337_1,
            0.076_121_240_987_221_95,
        ];
        assert_eq!(numbers, fixed);
    }

    #[test]
    fn numbers_are_uniform_and_keys_independent() {
        const N: u64 = 20_000;
        let draw = |key: &str| (0..N).map(|i| uniform(7, key, i)).collect::<Vec<_>>();
        let (a, b) = (draw("soil.layer[0].shear_speed"), draw("soil.layer[1].shear_speed"));
        let n = N as f64;
        let mean = a.iter().sum::<f64>() / n;
        let var = a.iter().map(|u| (u - 0.5).powi(2)).sum::<f64>() / n;
        let cov = a.iter().zip(&b).map(|(u, v)| (u - 0.5) * (v - 0.5)).sum::<f64>() / n;
        // standard errors: 1/√(12n) = 2.0e-3, 1/√(180n) = 5.3e-4, 1/(12√n) = 5.9e-4; measured 2.2e-3, 3.4e-4, 2.4e-4
        assert!((mean - 0.5).abs() < 6.1e-3, "{mean}");
        assert!((var - 1.0 / 12.0).abs() < 1.6e-3, "{var}");
        assert!(cov.abs() < 1.8e-3, "{cov}");
    }
}
