//! Waves that travel along the ground by themselves: Rayleigh and Love modes.
//!
//! Modes of undamped ground are **counted before they are sought**. At wavenumber k the stiffness matrix of the whole stack
//! has as many negative pivots as there are modes of lower frequency (Wittrick & Williams 1971), once every layer is cut so
//! thin that it cannot vibrate between fixed faces: its lowest such frequency is at least c_s √(k² + π²/h²). The count
//! is a staircase in k whose steps bracket the roots one by one; a root of the compound matrix, which shares
//! nothing with the count, is then found in each bracket. Damped modes are followed from the undamped ones along their slope.
//!
//! Trapped modes only: slower than shear waves in the half-space. Faster, leaky ones lose energy downward and are left out.

use super::layer_stiffness::LayerStiffness;
use super::mode_count::RealWaves;
use super::real_secular;
use super::transfer_matrix::Waves;
use super::wave::Wave;
use super::{Profile, chain};
use crate::count::{self, Work};
use crate::math::root;
use nalgebra::SMatrix;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::PI;

/// Wavenumbers at which the modes are counted before the steps of the count are narrowed down. A step up and a step
/// down between two of them, as a wave with negative group velocity makes near its cut-off, is not seen.
const SCAN: usize = 96;
/// A mode that cannot be followed over this share of the damping is lost.
const LEAST_STEP: f64 = 1e-3;

/// Which waves.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceWave {
    /// P–SV: vertical and along the direction of travel.
    #[default]
    Rayleigh,
    /// SH: across the direction of travel.
    Love,
}

/// A wave e^{i(ωt + kx)} that needs no load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// k [rad/m], Re k > 0; Im k is zero without damping, else negative, or positive of a backward wave.
    pub k: Complex64,
    /// c = ω/Re k [m/s]
    pub phase_velocity: f64,
    /// c_g = 1/Re(dk/dω) [m/s]
    pub group_velocity: f64,
    /// |Im k| [1/m]: the amplitude decays as e^{−attenuation · distance}.
    pub attenuation: f64,
}

/// The modes at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// The slowest ones, by rising phase velocity of the undamped ground.
    pub modes: Vec<Option<Mode>>,
    /// Their wavenumbers without damping [rad/m].
    pub undamped: Vec<f64>,
    /// How many trapped modes there are at this frequency without damping, wanted or not.
    pub count: usize,
}

/// Number of modes of the undamped ground with wavenumber `k` [rad/m] and a frequency below `omega` [rad/s]: with forward
/// waves only, the number of modes at `omega` with larger wavenumbers, slower than ω/k.
///
/// `k` > ω/c_s of the half-space, above zero on rock. Exact.
/// Source: Wittrick & Williams 1971, Q. J. Mech. Appl. Math. 24:263.
pub fn count(profile: &Profile, wave: SurfaceWave, omega: f64, k: f64) -> usize {
    staircase(&Waves::new(&profile.with_loss_times(0.0), omega), wave, k)
}

fn staircase(waves: &Waves, wave: SurfaceWave, k: f64) -> usize {
    match wave {
        SurfaceWave::Rayleigh => negative_pivots(
            waves,
            k,
            |w, h| LayerStiffness::<2>::layer(w, h, k),
            waves.half_space.map(|w| LayerStiffness::<2>::half_space(&w, k)),
            |a| {
                let (a, b, c) = (a[(0, 0)].re, a[(0, 1)].re, a[(1, 1)].re);
                if a * c - b * b < 0.0 {
                    1
                } else if a + c < 0.0 {
                    2
                } else {
                    0
                }
            },
        ),
        SurfaceWave::Love => negative_pivots(
            waves,
            k,
            |w, h| LayerStiffness::<1>::layer(w, h, k),
            waves.half_space.map(|w| LayerStiffness::<1>::half_space(&w, k)),
            |a| usize::from(a[(0, 0)].re < 0.0),
        ),
    }
}

/// Negative eigenvalues of the pivots met while the stack is condensed from the base upward.
fn negative_pivots<const N: usize>(
    waves: &Waves,
    k: f64,
    layer: impl Fn(&Wave, f64) -> LayerStiffness<N>,
    base: Option<SMatrix<Complex64, N, N>>,
    negative: impl Fn(&SMatrix<Complex64, N, N>) -> usize,
) -> usize {
    let mut below = base;
    let mut sum = 0;
    for (wave, h) in waves.layers.iter().rev() {
        // ω² < c_s²(k² + π²/h²) for every part
        let parts = 1.0 + (h * (wave.ks2.re - k * k).max(0.0).sqrt() / PI).floor();
        let LayerStiffness { direct, cross } = layer(wave, h / parts);
        for _ in 0..parts as usize {
            below = Some(chain::upside_down(match below {
                Some(below) => {
                    let pivot = direct + below;
                    sum += negative(&pivot);
                    direct - cross * chain::inverse(pivot) * cross
                }
                None => direct,
            }));
        }
    }
    sum + below.map_or(0, |surface| negative(&surface))
}

/// Waves without load, with damping or without.
enum Free {
    Damped(Waves),
    Undamped(RealWaves),
}

impl Free {
    /// The Rayleigh or Love function at `k`, times e^{second}.
    fn secular(&self, wave: SurfaceWave, k: Complex64) -> (Complex64, f64) {
        count::add(Work::Secular, 1);
        let real = |(value, scale): (f64, f64)| (value.into(), scale);
        match (self, wave) {
            (Self::Damped(waves), SurfaceWave::Rayleigh) => waves.rayleigh(k),
            (Self::Damped(waves), SurfaceWave::Love) => waves.love(k),
            (Self::Undamped(waves), SurfaceWave::Rayleigh) => real(real_secular::rayleigh(waves, k.re)),
            (Self::Undamped(waves), SurfaceWave::Love) => real(real_secular::love(waves, k.re)),
        }
    }

    /// The same without its second part, as large as at the place whose second part is `reference`.
    fn relative(&self, wave: SurfaceWave, k: Complex64, reference: f64) -> Complex64 {
        let (value, scale) = self.secular(wave, k);
        value * (scale - reference).clamp(-600.0, 600.0).exp()
    }
}

/// Wavenumbers of the `wanted` slowest modes of undamped ground, descending, and the count of all of them.
fn undamped(
    waves: &RealWaves,
    profile: &Profile,
    wave: SurfaceWave,
    omega: f64,
    wanted: usize,
) -> (Vec<f64>, usize) {
    let slowest = match wave {
        SurfaceWave::Rayleigh => profile.slowest_rayleigh_speed(),
        SurfaceWave::Love => profile.materials().map(|m| m.c_s()).fold(f64::INFINITY, f64::min),
    };
    // a little beyond the slowest wave of any one material, to which modes of a soft top layer converge; a heavy layer on
    // light ground is slower still
    let mut highest = omega / slowest * (1.0 + 1e-6);
    for _ in 0..100 {
        if below(waves, wave, highest) == 0 {
            break;
        }
        highest *= 1.05;
    }
    let lowest = match waves.half_space {
        Some(half_space) => half_space.ks2.sqrt() * (1.0 + 1e-12),
        None => 1e-6 * highest,
    };
    if lowest >= highest {
        return (Vec::new(), 0);
    }
    // waves may run backward, and the count rises before it falls: every step is a mode
    let at = |i: usize| lowest + (highest - lowest) * i as f64 / SCAN as f64;
    let total = below(waves, wave, lowest);
    let mut roots = Vec::new();
    let mut count = 0;
    let (mut high, mut count_high) = (highest, 0_usize);
    for i in (0..SCAN).rev() {
        let (low, count_low) = (at(i), if i == 0 { total } else { below(waves, wave, at(i)) });
        isolate(waves, wave, (low, count_low), (high, count_high), &mut roots);
        count += count_low.abs_diff(count_high);
        (high, count_high) = (low, count_low);
        if roots.len() >= wanted {
            break;
        }
    }
    roots.truncate(wanted);
    (roots, count + total.abs_diff(count_high))
}

/// Modes with wavenumber `k` and a lower frequency.
fn below(waves: &RealWaves, wave: SurfaceWave, k: f64) -> usize {
    count::add(Work::ModeCounts, 1);
    match wave {
        SurfaceWave::Rayleigh => waves.in_plane(k),
        SurfaceWave::Love => waves.across(k),
    }
}

/// Pushes the root in every step of the count between `low` and `high`, from above.
fn isolate(
    waves: &RealWaves,
    wave: SurfaceWave,
    low: (f64, usize),
    high: (f64, usize),
    roots: &mut Vec<f64>,
) {
    let steps = low.1.abs_diff(high.1);
    if steps == 0 {
        return;
    }
    let narrow = high.0 - low.0 <= 1e-12 * high.0;
    if steps == 1 && !narrow {
        let mut reference = None;
        let f = |k: f64| {
            count::add(Work::Secular, 1);
            let (value, scale) = match wave {
                SurfaceWave::Rayleigh => real_secular::rayleigh(waves, k),
                SurfaceWave::Love => real_secular::love(waves, k),
            };
            value * (scale - *reference.get_or_insert(scale)).clamp(-600.0, 600.0).exp()
        };
        if let Some(k) = root::bracketed(f, low.0, high.0, 1e-14) {
            roots.push(k);
            return;
        }
    }
    if narrow {
        // modes closer together than digits
        roots.extend(std::iter::repeat_n(0.5 * (low.0 + high.0), steps));
        return;
    }
    let middle = 0.5 * (low.0 + high.0);
    let middle = (middle, below(waves, wave, middle));
    isolate(waves, wave, middle, high, roots);
    isolate(waves, wave, low, middle, roots);
}

/// dk/dω = −F_ω/F_k by five-point differences.
fn slowness(
    waves: &Waves,
    damped: bool,
    wave: SurfaceWave,
    omega: f64,
    depth: f64,
    k: Complex64,
) -> Complex64 {
    // F varies as e^{2kH} at most, and as √(k² − k_s²) near the cut-off, where modes escape into the half-space
    let mut step = 2e-3 / (1.0 + 2.0 * k.norm() * depth);
    if let Some(half_space) = &waves.half_space {
        step = step.min(0.02 * (1.0 - half_space.ks2.sqrt() / k).norm());
    }
    let free = |factor: f64| {
        let waves = waves.scaled(factor);
        if damped { Free::Damped(waves) } else { Free::Undamped(RealWaves::new(&waves)) }
    };
    let here = free(1.0);
    let (_, reference) = here.secular(wave, k);
    // f′ = (f₋₂ − 8f₋₁ + 8f₁ − f₂)/(12h)
    let weights = [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)];
    let (mut by_k, mut by_omega) = (Complex64::ZERO, Complex64::ZERO);
    for (at, weight) in weights {
        let factor = 1.0 + at * step;
        by_k += weight * here.relative(wave, k * factor, reference) / k;
        by_omega += weight * free(factor).relative(wave, k, reference) / omega;
    }
    -by_omega / by_k
}

/// The largest loss factor.
fn loss(profile: &Profile) -> f64 {
    profile.materials().map(|m| m.loss_factor().max(m.loss_factor_pressure())).fold(0.0, f64::max)
}

/// The `wanted` slowest trapped modes at `omega` > 0 [rad/s].
///
/// Damped modes continue the undamped ones as damping is turned on; one that cannot be followed or meets another is None.
/// A mode so close to its cut-off, within the loss factor, that damping makes it leaky is left out. Accuracy: 2e-9 of k against the papers' tables where they have the digits, 1e-14 against closed forms; group velocity
/// 7e-9 (tests `papers::dispersion`, `papers::mezher`, `analytic::dispersion`).
pub fn modes(profile: &Profile, wave: SurfaceWave, omega: f64, wanted: usize) -> Modes {
    let elastic = profile.with_loss_times(0.0);
    let real = RealWaves::new(&Waves::new(&elastic, omega));
    let (roots, count) = undamped(&real, &elastic, wave, omega, wanted);
    let mut found: Vec<Option<Complex64>> = roots.iter().map(|k| Some(Complex64::from(*k))).collect();
    let damped = !profile.is_undamped();
    if damped {
        for (i, slot) in found.iter_mut().enumerate() {
            let beside = [i.wrapping_sub(1), i + 1].into_iter().filter_map(|j| roots.get(j));
            let gap = beside.map(|other| (other - roots[i]).abs()).fold(f64::INFINITY, f64::min);
            *slot = slot.and_then(|k| follow(profile, wave, omega, (k, gap), (0.0, 1.0)));
        }
        for i in 0..found.len() {
            let Some(k) = found[i] else { continue };
            let twice = |other: &Option<Complex64>| other.is_some_and(|o| (o - k).norm() < 1e-9 * k.norm());
            // two that were apart have become one
            if found[..i].iter().any(twice) && roots[i] != roots[i - 1] {
                found[i] = None;
            }
        }
    }
    // damping blurs a cut-off by its loss factor: a mode that leaves the ground's grip there has become leaky
    if let Some(half_space) = &real.half_space {
        let blurred = half_space.ks2.sqrt() * (1.0 + loss(profile));
        while found.last().is_some_and(Option::is_none) && roots[found.len() - 1] < blurred {
            found.pop();
        }
    }
    let waves = Waves::new(profile, omega);
    // energy decays the way it travels, which a backward wave does against its crests
    let mode = |k: Complex64| {
        let group_velocity = 1.0 / slowness(&waves, damped, wave, omega, profile.depth(), k).re;
        let attenuation = 0.0 - k.im * group_velocity.signum();
        let mode = Mode { k, phase_velocity: omega / k.re, group_velocity, attenuation };
        (k.re > 0.0 && attenuation >= 0.0).then_some(mode)
    };
    let mut undamped = roots;
    undamped.truncate(found.len());
    Modes { modes: found.into_iter().map(|k| k.and_then(mode)).collect(), undamped, count }
}

/// The root that continues `k`, `gap` away from the next, while the damping grows from a share `from` of it to `to`: in
/// one step or, where the root is not where its slope leads, in two halves.
fn follow(
    profile: &Profile,
    wave: SurfaceWave,
    omega: f64,
    (k, gap): (Complex64, f64),
    (from, to): (f64, f64),
) -> Option<Complex64> {
    let free = |share: f64| {
        let waves = Waves::new(&profile.with_loss_times(share), omega);
        if share > 0.0 { Free::Damped(waves) } else { Free::Undamped(RealWaves::new(&waves)) }
    };
    // dk/dτ = −F_τ/F_k, with F(k) = 0 here
    let (dk, part) = (1e-6 * k, 1e-3);
    let (beside, reference) = free(from).secular(wave, k + dk);
    let by_share = free(from + part * (to - from)).relative(wave, k, reference) / part;
    let shift = -by_share * dk / beside;
    let there = free(to);
    let root = root::complex(|k| there.relative(wave, k, reference), k + shift, 1e-12);
    let allowed = (0.2 * shift.norm()).min(0.2 * gap) + 1e-9 * k.norm();
    let near = |root: &Complex64| (root - k - shift).norm() <= allowed;
    if let Some(root) = root.filter(near) {
        return Some(root);
    }
    if to - from < LEAST_STEP {
        return None;
    }
    let middle = 0.5 * (from + to);
    let half = follow(profile, wave, omega, (k, gap), (from, middle))?;
    follow(profile, wave, omega, (half, gap), (middle, to))
}
