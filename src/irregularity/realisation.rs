//! One profile out of the many a spectrum allows, as a sum of sinusoids.

use super::{IrregularityError, Spectrum};
use crate::math::gridding::sum_of_waves;
use crate::quantity::{finite, positive};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// amplitude · cos(Ωx + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// Ω [rad/m]
    pub wavenumber: f64,
    /// [m]
    pub amplitude: f64,
    /// [rad]
    pub phase: f64,
}

impl Component {
    /// 2π/Ω [m]
    pub fn wavelength(&self) -> f64 {
        TAU / self.wavenumber
    }
}

/// A profile r(x) = Σ a_j cos(Ω_j x + θ_j) [m], positive down.
#[derive(Clone, Debug, PartialEq)]
pub struct Realisation {
    components: Vec<Component>,
    repeat_length: f64,
    from: f64,
}

impl Realisation {
    /// The sum of `components`, which comes back after `repeat_length` [m].
    ///
    /// # Errors
    /// No component; a wavenumber or length that is not positive; an amplitude or phase that is not finite.
    pub fn new(components: Vec<Component>, repeat_length: f64) -> Result<Self, IrregularityError> {
        positive("repeat_length", repeat_length, "m")?;
        if components.is_empty() {
            return Err(IrregularityError::NoComponent);
        }
        for c in &components {
            positive("wavenumber", c.wavenumber, "rad/m")?;
            finite("amplitude", c.amplitude, "m")?;
            finite("phase", c.phase, "rad")?;
        }
        Ok(Self { components, repeat_length, from: 0.0 })
    }

    pub(super) fn starting(self, from: f64) -> Self {
        Self { from, ..self }
    }

    /// A profile with `spectrum` between `wavelengths` (shortest, longest) [m]: r(x) = Σ √(2 S(Ω_j) ΔΩ) cos(Ω_j x + θ_j),
    /// with `count` wavenumbers in the middle of equal steps ΔΩ = 2π(1/shortest − 1/longest)/`count`.
    ///
    /// The phases θ_j, equally likely between 0 and 2π, come from `seed`: output number j of SplitMix64 (Steele, Lea & Flood
    /// 2014) divided by 2⁶⁴ to 53 bits. The generator is six lines of integer arithmetic, written here so that no release of
    /// a library can change a profile; phases are the same bits on every machine. The profile comes back after 2π/ΔΩ with all
    /// phases shifted alike ([`Realisation::repeat_length`]): choose `count` above (evaluated length)/(shortest wavelength).
    ///
    /// # Errors
    /// Wavelengths that are not positive or not in order; no component.
    ///
    /// Accuracy: the spectrum at Ω_j is that asked for, to 2e-12 (test `periodogram_is_the_spectrum`). The variance is the
    /// midpoint rule for ∫ S dΩ, short of it where ΔΩ is not small beside the smallest Ω: FRA class 5 over 0.45 to 135 m
    /// (break wavenumbers) with 300, 1000 and 3000 components lacks 25, 3.4 and 0.41 % of it (test `variance_converges`); compare
    /// [`Realisation::rms`] with [`Spectrum::band_rms`]. It is the same for every seed over the repeat length; over
    /// shorter lengths it scatters.
    /// Source: Shinozuka & Deodatis 1991, Appl. Mech. Rev. 44; the amplitude is fixed, the phase random.
    pub fn of(
        spectrum: &Spectrum,
        wavelengths: (f64, f64),
        count: usize,
        seed: u64,
    ) -> Result<Self, IrregularityError> {
        let shortest = positive("wavelengths.from", wavelengths.0, "m")?;
        let longest = positive("wavelengths.to", wavelengths.1, "m")?;
        if shortest >= longest {
            return Err(IrregularityError::Wavelengths { shortest, longest });
        }
        if count == 0 {
            return Err(IrregularityError::NoComponent);
        }
        let low = TAU / longest;
        let step = (TAU / shortest - low) / count as f64;
        let mut random = SplitMix64(seed);
        let components = (0..count)
            .map(|j| {
                let wavenumber = low + (j as f64 + 0.5) * step;
                let amplitude = (2.0 * spectrum.one_sided(wavenumber) * step).sqrt();
                Component { wavenumber, amplitude, phase: TAU * random.unit() }
            })
            .collect();
        Self::new(components, TAU / step)
    }

    /// The sinusoids, in order of wavenumber unless they were given otherwise.
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// Length [m] after which the profile comes back, for a spectrum with all phases shifted alike.
    pub fn repeat_length(&self) -> f64 {
        self.repeat_length
    }

    /// The same with its origin at x = `x` [m]: r(x + x′).
    pub fn shifted(&self, x: f64) -> Self {
        let shift = |c: &Component| Component { phase: c.phase + c.wavenumber * x, ..*c };
        Self { components: self.components.iter().map(shift).collect(), from: self.from - x, ..*self }
    }

    /// What of it has wavelengths between `shortest` and `longest` [m].
    pub fn between(&self, shortest: f64, longest: f64) -> Self {
        // limits that are wavelengths of components are meant to include them, however they round
        let (least, most) = (shortest * (1.0 - 1e-9), longest * (1.0 + 1e-9));
        let inside = |c: &&Component| (least..=most).contains(&c.wavelength());
        Self { components: self.components.iter().filter(inside).copied().collect(), ..*self }
    }

    /// Where it begins [m]: the first point of a measured profile, 0 for the others, which have no beginning.
    pub fn from(&self) -> f64 {
        self.from
    }

    /// √(Σ a_j²/2) [m]: the r.m.s. over a long length.
    pub fn rms(&self) -> f64 {
        self.components.iter().map(|c| 0.5 * c.amplitude * c.amplitude).sum::<f64>().sqrt()
    }

    /// r(x) [m] at `x` [m].
    pub fn at(&self, x: f64) -> f64 {
        self.components.iter().map(|c| c.amplitude * (c.wavenumber * x + c.phase).cos()).sum()
    }

    /// r(x) [m] at `count` positions from `from` in steps of `step` [m], by one fast transform.
    ///
    /// Accuracy: 1e-10 of Σ a_j.
    pub fn stretch(&self, from: f64, step: f64, count: usize) -> Vec<f64> {
        let waves =
            self.components.iter().map(|c| (c.wavenumber, Complex64::from_polar(c.amplitude, c.phase)));
        sum_of_waves(waves, from, step, count)
    }
}

/// Steele, Lea & Flood 2014, Fast splittable pseudorandom number generators, OOPSLA.
pub(super) struct SplitMix64(pub(super) u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1), in steps of 2⁻⁵³.
    pub(super) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (-53f64).exp2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::irregularity::{FraBreakWavenumber, German};

    fn class_5() -> Spectrum {
        Spectrum::FraBreakWavenumber(FraBreakWavenumber::new(5).unwrap())
    }

    #[test]
    fn generator_is_the_published_one() {
        // numbers of the reference implementation (Vigna, splitmix64.c) with seed 1234567
        let mut random = SplitMix64(1_234_567);
        let got = [(); 5].map(|()| random.next());
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(got, expected);
    }

    #[test]
    fn shifted_and_narrowed() {
        let r = Realisation::of(&class_5(), (1.0, 100.0), 50, 3).unwrap();
        // rounding of the phases
        assert!((r.shifted(12.5).at(1.5) - r.at(14.0)).abs() < 1e-15);
        let (short, long) = (r.between(1.0, 5.0), r.between(5.0, 100.0));
        assert!(!short.components().is_empty() && long.components().iter().all(|c| c.wavelength() >= 5.0));
        assert!((short.at(3.0) + long.at(3.0) - r.at(3.0)).abs() < 1e-15);
    }

    #[test]
    fn a_stretch_is_its_points() {
        let r = Realisation::of(&class_5(), (1.0, 100.0), 50, 3).unwrap();
        let most = 1e-10 * r.components().iter().map(|c| c.amplitude).sum::<f64>();
        let stretch = r.stretch(-20.0, 0.03, 1500);
        assert!(stretch.iter().zip(0..).all(|(y, i)| (y - r.at(0.03 * f64::from(i) - 20.0)).abs() < most));
    }

    #[test]
    fn seeds_tell_profiles_apart() {
        let of = |seed| Realisation::of(&class_5(), (1.0, 100.0), 50, seed).unwrap();
        assert_eq!(of(7), of(7));
        assert_ne!(of(7).at(3.0), of(8).at(3.0));
    }

    #[test]
    fn variance_converges() {
        let lacks = [300, 1000, 3000, 9000, 90_000].map(|count| {
            let r = Realisation::of(&class_5(), (0.45, 135.0), count, 1).unwrap();
            1.0 - (r.rms() / class_5().band_rms(0.45, 135.0)).powi(2)
        });
        for (got, measured) in lacks.into_iter().zip([0.247, 0.0345, 4.07e-3, 4.56e-4, 4.56e-6]) {
            // measured, and from 3000 on falling with the square of ΔΩ; the last place of the numbers here
            assert!((got / measured - 1.0).abs() < 0.005, "{lacks:?}");
        }
    }

    #[test]
    fn ensemble_has_the_variance_asked_for() {
        // r² at one place over 4000 seeds: E r² = σ², var r² = 2σ⁴ − (3/8)Σ a⁴ ≈ 2σ⁴, so that the mean is off by √(2/4000) = 2.2 %
        // (one standard deviation); measured −2.4 %, and the mean 1.1 % of σ where 1.6 % are expected
        let spectrum = Spectrum::German { quality: German::Low };
        let (mut sum, mut square, mut fourth) = (0.0, 0.0, 0.0);
        let mut sigma2 = 0.0;
        for seed in 0..4000 {
            let r = Realisation::of(&spectrum, (3.0, 150.0), 400, seed).unwrap();
            sigma2 = r.rms().powi(2);
            let value = r.at(17.3);
            sum += value;
            square += value * value;
            fourth += value.powi(4);
        }
        let n = 4000.0;
        assert!((square / n / sigma2 - 1.0).abs() < 3.0 * 0.022, "{}", square / n / sigma2);
        assert!((sum / n / sigma2.sqrt()).abs() < 3.0 * 0.016, "{}", sum / n / sigma2.sqrt());
        // close to Gaussian: kurtosis 3 − (3/2)Σa⁴/(Σa²)² = 2.936, ± √(24/4000) = 0.08; measured 2.84
        let kurtosis = fourth / n / (square / n).powi(2);
        assert!((kurtosis - 2.936).abs() < 0.24, "{kurtosis}");
        // the midpoint rule with 400 components; measured −0.095 %
        assert!((sigma2 / spectrum.band_rms(3.0, 150.0).powi(2) - 1.0).abs() < 0.001);
    }

    #[test]
    fn periodogram_is_the_spectrum() {
        // N samples over the length L = 2π/ΔΩ, on which all Ω_j differ by whole periods: 2|1/N Σ r e^{−iΩ_j x}|²/ΔΩ = S(Ω_j),
        // but for the images at −Ω_j, which stay out if 2Ω_j is a multiple of ΔΩ: here Ω_low is
        let (count, step) = (200usize, 0.02);
        let low = 0.2;
        let wavelengths = (TAU / (low + step * count as f64), TAU / low);
        let r = Realisation::of(&class_5(), wavelengths, count, 42).unwrap();
        assert!((r.repeat_length() - TAU / step).abs() < 1e-9);
        let n = 1000;
        let samples: Vec<(f64, f64)> = (0..n)
            .map(|i| {
                let x = r.repeat_length() * f64::from(i) / f64::from(n);
                (x, r.at(x))
            })
            .collect();
        for c in r.components() {
            let sum: Complex64 = samples.iter().map(|&(x, r)| r * Complex64::cis(-c.wavenumber * x)).sum();
            let s = 2.0 * (sum / f64::from(n)).norm_sqr() / step;
            // measured 2e-12: rounding against the largest line, 1.5e4 times the smallest in power
            assert!((s / class_5().one_sided(c.wavenumber) - 1.0).abs() < 2e-11, "{}", c.wavenumber);
        }
    }

    #[test]
    fn refuses_what_it_cannot_build() {
        let of =
            |wavelengths, count| Realisation::of(&class_5(), wavelengths, count, 0).unwrap_err().to_string();
        assert_eq!(of((0.0, 3.0), 9), "wavelengths.from is 0 m: it must be finite and above zero");
        assert!(of((30.0, 3.0), 9).contains("from 30 m to 3 m"));
        assert!(of((3.0, 30.0), 0).contains("at least 1"));
    }
}
