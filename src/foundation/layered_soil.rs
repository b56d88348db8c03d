//! Layered ground under a strip: k_eq(β, ω) of Eq. 80, corrected.

use super::{Foundation, FoundationError, Moving, Stiffness};
use crate::math::interpolation::{Interpolant, NODES};
use crate::quantity::positive;
use crate::soil::{GroundSolver, PreparedGround, Profile, SoilError, Solver, Strip};
use num_complex::Complex64;
use std::cell::Cell;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Accuracy of G from thin layers under a moving load; speed curves then agree with those of exact solvers to 1.4e-4 (test
/// `cross_solver::critical_speed`).
const MOVING_ACCURACY: f64 = 2e-3;
/// Ends, as ln(ω b/c_s), of the pieces on which one set of thin layers serves; one unit wide from there on.
const ENDS: [f64; 4] = [-19.0, -8.0, -4.5, -2.5];

/// Evaluations of G after which a line is refined no further: ground that hardly damps asks for ever more of them as the load outruns its
/// waves. A line of the paper's ground takes 5e4, one of the four layers of `laws::light_damping` at 109.6 m/s 1e7.
const MOST: usize = 3_000_000;

/// Grounds that were dear to prepare, by frequency, wavenumbers and accuracy.
type Prepared = HashMap<(u64, u64, u64, u64), Arc<Kept>>;

/// A ground for all threads.
#[derive(Default)]
struct Kept {
    /// Some thread prepares it or has done so.
    begun: AtomicBool,
    ground: OnceLock<Result<Arc<dyn PreparedGround>, SoilError>>,
}

/// A profile loaded over a strip.
pub struct LayeredSoil {
    profile: Profile,
    solver: Solver,
    strip: Strip,
    /// Modes at one ω answer every β: they are kept. Empty for solvers without modes.
    prepared: Mutex<Prepared>,
}

impl std::fmt::Debug for LayeredSoil {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { profile, solver, strip, .. } = self;
        f.debug_struct("LayeredSoil")
            .field("profile", profile)
            .field("solver", solver)
            .field("strip", strip)
            .finish_non_exhaustive()
    }
}

impl LayeredSoil {
    /// `profile` under a `strip`.
    ///
    /// # Errors
    /// A half-width that is not finite and positive.
    pub fn new(profile: Profile, solver: Solver, strip: Strip) -> Result<Self, FoundationError> {
        positive("half_width", strip.half_width, "m")?;
        Ok(Self { profile, solver, strip, prepared: Mutex::default() })
    }

    /// The ground.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The loaded strip.
    pub fn strip(&self) -> Strip {
        self.strip
    }

    /// The solver of the ground.
    pub fn solver(&self) -> Solver {
        self.solver
    }

    /// The ground at `omega` for wavenumbers from `k.0` to `k.1` to `accuracy`, the sublayers of thin layers those of all
    /// frequencies in `band`. Every thread gets the same one, whichever of them prepared it.
    fn prepare(
        &self,
        omega: f64,
        k: (f64, f64),
        accuracy: f64,
        band: Option<(f64, f64)>,
    ) -> Result<Arc<dyn PreparedGround>, SoilError> {
        let prepare = || {
            let solver = self.solver.resolving(k, accuracy, band);
            solver.prepare(&self.profile, omega, &[]).map(Arc::from)
        };
        if !self.solver.has_modes() {
            return prepare();
        }
        let kept = self.kept(omega, k, accuracy);
        kept.begun.store(true, Ordering::Relaxed);
        kept.ground.get_or_init(prepare).clone()
    }

    /// Prepares a ground with its modes, unless another thread is at it: so that threads at different speeds share the work
    /// instead of waiting for one another.
    fn begin(&self, omega: f64, k: (f64, f64), accuracy: f64, band: Option<(f64, f64)>) {
        if !self.kept(omega, k, accuracy).begun.swap(true, Ordering::Relaxed)
            && let Ok(ground) = self.prepare(omega, k, accuracy, band)
        {
            // found now, and kept; a ground without them is answered all the same
            let _ = ground.modes();
        }
    }

    fn kept(&self, omega: f64, k: (f64, f64), accuracy: f64) -> Arc<Kept> {
        let key = (omega.to_bits(), k.0.to_bits(), k.1.to_bits(), accuracy.to_bits());
        // a panic elsewhere leaves nothing half-made
        self.prepared.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default().clone()
    }

    /// Ends in ln ω of the pieces that cover ln ω from `low` to `high`: the same ones whatever the speed.
    fn pieces(&self, low: f64, high: f64) -> Vec<f64> {
        let unit = (self.profile.top().c_s() / self.strip.half_width).ln();
        let finer = (1..).map(|i| ENDS[ENDS.len() - 1] + f64::from(i));
        let mut ends: Vec<f64> = Vec::new();
        for end in ENDS.into_iter().chain(finer).map(|end| end + unit) {
            if end <= low {
                ends.clear();
            }
            ends.push(end);
            if end >= high {
                break;
            }
        }
        ends
    }

    /// Wavenumbers thin layers must resolve [rad/m] where β is at most `beta`. What lies above changes the mean over the
    /// strip by (k b)⁻² of it (tests `cross_solver::thin_layer`).
    fn wavenumbers(&self, beta: f64, accuracy: f64) -> (f64, f64) {
        let highest = (0.3 / accuracy.sqrt() / self.strip.half_width).max(2.0 * beta);
        // few different ones
        (0.0, (0.25 * highest.log2()).ceil().exp2().powi(4))
    }

    /// Refuses phase speeds at which undamped ground has a real pole.
    fn check(&self, phase_speed: f64) -> Result<(), FoundationError> {
        if !self.profile.is_undamped() {
            return Ok(());
        }
        let slowest = self.profile.slowest_rayleigh_speed();
        if phase_speed >= slowest {
            return Err(FoundationError::Undamped { phase_speed, slowest });
        }
        Ok(())
    }
}

impl Foundation for LayeredSoil {
    fn stiffness_to(&self, beta: f64, omega: f64, relative: f64) -> Result<Stiffness, FoundationError> {
        self.check(if omega == 0.0 { 0.0 } else { (omega / beta).abs() })?;
        let accuracy = relative.clamp(1e-6, 1e-2);
        let ground = self.prepare(omega, self.wavenumbers(beta.abs(), accuracy), accuracy, None)?;
        let estimate = ground.strip(beta, self.strip, relative);
        Ok(Stiffness {
            value: 1.0 / estimate.value,
            relative_error: estimate.error / estimate.value.norm(),
            converged: estimate.converged,
            count: estimate.count,
        })
    }

    /// Interpolates 1/k_eq piecewise in ln β, on which wave and layer features have even widths; its logarithmic
    /// growth as β → 0 is nearly a straight line there. With modes the pieces are the same in ln ω at all speeds, so
    /// that modes found for one speed serve the others.
    fn moving(
        &self,
        speed: f64,
        from: f64,
        to: f64,
        allowed: &dyn Fn(f64, Complex64) -> f64,
    ) -> Result<Moving<'_>, FoundationError> {
        self.check(speed.abs())?;
        // no more is asked of thin layers than their own accuracy is worth, and nothing where the rail does not feel it
        let (first, looser, loosest) =
            if self.solver.has_modes() { (1e-2, 1000.0, 1.0) } else { (1e-6, 1.0, 1e-3) };
        // x = ln β + shift, ln |ω| where modes are shared
        let shared = self.solver.has_modes() && speed != 0.0;
        let shift = if shared { speed.abs().ln() } else { 0.0 };
        let (low, high) = (from.ln() + shift, to.ln() + shift);
        let points = if shared { self.pieces(low, high) } else { four_pieces(low, high) };
        let (mut missed, count, mut known) = (0.0f64, Cell::new(0), Known::default());
        let (mut highest_asked, mut last) = (f64::NEG_INFINITY, Complex64::ONE);
        let compliances = |nodes: &[f64; NODES]| -> Result<[Complex64; NODES], SoilError> {
            let (band, highest) = if shared {
                let above = points.partition_point(|end| *end < nodes[0]).clamp(1, points.len() - 1);
                let (low, high) = (points[above - 1], points[above]);
                (Some((low.exp(), high.exp())), (high - shift).exp())
            } else {
                (None, to)
            };
            if shared && allowed((nodes[0] - shift).exp(), 1.0 / last).is_infinite() {
                // any error is borne: the last one will do
                return Ok([last; NODES]);
            }
            let wavenumbers = self.wavenumbers(highest, MOVING_ACCURACY);
            let omega = |x: f64| if shared { -speed.signum() * x.exp() } else { -x.exp() * speed };
            if shared {
                nodes.iter().for_each(|x| self.begin(omega(*x), wavenumbers, MOVING_ACCURACY, band));
            }
            let mut values = [Complex64::ONE; NODES];
            for (x, value) in nodes.iter().zip(&mut values) {
                let ground = self.prepare(omega(*x), wavenumbers, MOVING_ACCURACY, band)?;
                let beta = (x - shift).exp();
                // as well as its neighbours needed it
                let relative = known.near(*x).unwrap_or(first);
                let felt = as_felt(ground.as_ref(), (beta, self.strip), relative, |value| {
                    (0.1 * allowed(beta, 1.0 / value) / value.norm()).clamp(1e-8, loosest)
                });
                *value = felt.value;
                missed = missed.max(felt.missed);
                count.set(count.get() + felt.count);
                known.insert(*x, felt.wanted);
            }
            if nodes[NODES - 1] > highest_asked {
                (highest_asked, last) = (nodes[NODES - 1], values[NODES - 1]);
            }
            Ok(values)
        };
        let bearable = |x: f64, value| looser * allowed((x - shift).exp(), 1.0 / value);
        let table = Interpolant::bounded(compliances, &points, bearable, || count.get() < MOST)?;
        let (worst, count) = (table.worst.max(missed), count.get());
        let stiffness = move |beta: f64| -> Complex64 { 1.0 / table.at(beta.ln() + shift) };
        Ok(Moving { stiffness: Box::new(stiffness), worst, count })
    }
}

/// Pieces to start with, in ln β: static far field, layers, contact width, beyond.
fn four_pieces(low: f64, high: f64) -> Vec<f64> {
    let middle = [0.01f64, 0.1, 1.0].iter().map(|b| b.ln());
    let middle = middle.filter(|b| *b > low + 0.5 && *b < high - 0.5);
    std::iter::once(low).chain(middle).chain([high]).collect()
}

/// 1/k_eq as exactly as it is felt.
struct Felt {
    /// [m²/N]
    value: Complex64,
    /// The relative accuracy wanted.
    wanted: f64,
    /// Its error over that, if it missed it; else 0.
    missed: f64,
    /// Evaluations of the ground.
    count: usize,
}

/// 1/k_eq to `relative`, and once more where less is `wanted` of its value: a tenth of the error allowed there.
fn as_felt(
    ground: &dyn PreparedGround,
    (beta, strip): (f64, Strip),
    mut relative: f64,
    wanted: impl Fn(Complex64) -> f64,
) -> Felt {
    let mut count = 0;
    loop {
        let estimate = ground.strip(beta, strip, relative);
        count += estimate.count;
        let wanted = wanted(estimate.value);
        if wanted >= 0.1 * relative || !estimate.converged {
            let error = estimate.error / (relative * estimate.value.norm());
            let missed = if estimate.converged { 0.0 } else { error };
            return Felt { value: estimate.value, wanted, missed, count };
        }
        relative = wanted;
    }
}

/// What relative accuracy was wanted where.
#[derive(Default)]
struct Known(Vec<(f64, f64)>);

impl Known {
    /// The finer of the neighbours of `x`; None where there are none.
    fn near(&self, x: f64) -> Option<f64> {
        let above = self.0.partition_point(|known| known.0 < x);
        let below = above.checked_sub(1).and_then(|i| self.0.get(i));
        below.into_iter().chain(self.0.get(above)).map(|known| known.1).min_by(f64::total_cmp)
    }

    fn insert(&mut self, x: f64, wanted: f64) {
        let above = self.0.partition_point(|known| known.0 < x);
        self.0.insert(above, (x, wanted));
    }
}
