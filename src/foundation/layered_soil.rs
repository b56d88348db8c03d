//! Layered ground under a strip: k_eq(β, ω) of Eq. 80, corrected.

use super::{Among, Asked, Foundation, FoundationError, Grain, Stiffness};
use crate::count::{self, Work};
use crate::quantity::positive;
use crate::soil::{GroundSolver, PreparedGround, Profile, SoilError, Solver, Strip};
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Ends, as ln(ω b/c_s), of the pieces on which one set of thin layers serves; one unit wide from there on.
const ENDS: [f64; 4] = [-19.0, -8.0, -4.5, -2.5];
/// Pieces one unit wide: more than any load can ask for.
const MORE: usize = 30;

/// Steps of ln ω at which the lifted path is compared with the real axis, and how many; the lowest frequency of them, below which
/// layers answer as at rest, over c_s/(depth + b) of the slowest.
const STEP: f64 = 0.1;
const STEPS: usize = 160;
const SLOW: f64 = 0.05;
/// Loss factor with which undamped ground is compared, whose integral on the real axis has no value.
const COMPARED_LOSS: f64 = 0.01;

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
    /// Whether integrals may leave the real axis, at steps of ln ω; found when asked.
    clear: Vec<OnceLock<bool>>,
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
    /// Accuracy of G from thin layers under a moving load; speed curves then agree with those of exact solvers to 1.4e-4 (test
    /// `cross_solver::critical_speed`).
    pub const MOVING_ACCURACY: f64 = 2e-3;

    /// `profile` under a `strip`.
    ///
    /// # Errors
    /// A half-width that is not finite and positive.
    pub fn new(profile: Profile, solver: Solver, strip: Strip) -> Result<Self, FoundationError> {
        positive("half_width", strip.half_width, "m")?;
        let clear = std::iter::repeat_with(OnceLock::new).take(STEPS).collect();
        Ok(Self { profile, solver, strip, prepared: Mutex::default(), clear })
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

    fn kept(&self, omega: f64, k: (f64, f64), accuracy: f64) -> Arc<Kept> {
        let key = (omega.to_bits(), k.0.to_bits(), k.1.to_bits(), accuracy.to_bits());
        // a panic elsewhere leaves nothing half-made
        self.prepared.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default().clone()
    }

    /// The ground for a question: at ω for its own wavenumbers, or among others for all of theirs.
    fn ground(&self, asked: Asked) -> Result<Arc<dyn PreparedGround>, SoilError> {
        let Asked { beta, omega, relative, among } = asked;
        match among {
            Some(Among { omega: band, beta }) => {
                let band = (band.1 > 0.0).then_some(band);
                self.prepare(
                    omega,
                    self.wavenumbers(beta, Self::MOVING_ACCURACY),
                    Self::MOVING_ACCURACY,
                    band,
                )
            }
            None => {
                let accuracy = relative.clamp(1e-6, 1e-2);
                self.prepare(omega, self.wavenumbers(beta.abs(), accuracy), accuracy, None)
            }
        }
    }

    /// Wavenumbers thin layers must resolve [rad/m] where β is at most `beta`. What lies above changes the mean over the
    /// strip by (k b)⁻² of it (tests `cross_solver::thin_layer`).
    fn wavenumbers(&self, beta: f64, accuracy: f64) -> (f64, f64) {
        let highest = (0.3 / accuracy.sqrt() / self.strip.half_width).max(2.0 * beta);
        // few different ones
        (0.0, (0.25 * highest.log2()).ceil().exp2().powi(4))
    }

    /// Whether the integral at `omega` may leave the real axis for the lifted path: both agreed at the frequencies around it.
    fn lifts(&self, omega: f64) -> bool {
        let lowest = self.profile.slowest_rayleigh_speed() / (self.profile.depth() + self.strip.half_width);
        let step = ((omega.abs() / (SLOW * lowest)).ln() / STEP).max(0.0).floor();
        // the compound matrices and flexibilities stay on the axis: they are witnesses
        if self.solver != Solver::DirectStiffness || step + 2.0 > STEPS as f64 {
            return false;
        }
        let clear = |i: usize| {
            let compare = || {
                let omega = SLOW * lowest * (STEP * i as f64).exp();
                let damped = self.profile.is_undamped().then(|| self.profile.with_loss(COMPARED_LOSS));
                let ground = self.solver.prepare(damped.as_ref().unwrap_or(&self.profile), omega, &[]);
                ground.is_ok_and(|ground| ground.lifts(self.strip))
            };
            *self.clear[i].get_or_init(compare)
        };
        clear(step as usize) && clear(step as usize + 1)
    }

    /// Refuses what has no value: undamped ground at phase speeds at which it has a real pole, unless a lifted path gave a value.
    fn check(&self, phase_speed: f64) -> Result<(), FoundationError> {
        let slowest = self.profile.slowest_rayleigh_speed();
        if self.profile.is_undamped() && phase_speed >= slowest {
            return Err(FoundationError::Undamped { phase_speed, slowest });
        }
        Ok(())
    }
}

impl Foundation for LayeredSoil {
    fn answer(&self, asked: Asked) -> Result<Stiffness, FoundationError> {
        count::add(Work::Stiffnesses, 1);
        let Asked { beta, omega, relative, .. } = asked;
        let phase_speed = if omega == 0.0 { 0.0 } else { (omega / beta).abs() };
        // what has no waves is real and stays so: at rest, and undamped below its slowest wave
        let quiet =
            omega == 0.0 || self.profile.is_undamped() && phase_speed < self.profile.slowest_rayleigh_speed();
        let lifts = !quiet && self.lifts(omega);
        if !lifts {
            self.check(phase_speed)?;
        }
        let ground = self.ground(asked)?;
        let estimate = match lifts {
            true => ground.strip_lifted(beta, self.strip, relative),
            false => ground.strip(beta, self.strip, relative),
        };
        Ok(Stiffness {
            value: 1.0 / estimate.value,
            relative_error: estimate.error / estimate.value.norm(),
            converged: estimate.converged,
            count: estimate.count,
        })
    }

    /// With modes the pieces are the same in ln ω at all speeds, so that modes found for one speed serve the others.
    fn grain(&self) -> Grain {
        if !self.solver.has_modes() {
            return Grain::Smooth;
        }
        let unit = (self.profile.top().c_s() / self.strip.half_width).ln();
        let finer = (1..=MORE).map(|i| ENDS[ENDS.len() - 1] + i as f64);
        Grain::Pieces(ENDS.into_iter().chain(finer).map(|end| end + unit).collect())
    }

    /// Prepares grounds with their modes, unless another thread is at them.
    fn begin(&self, next: &[Asked]) {
        let accuracy = Self::MOVING_ACCURACY;
        for asked in next {
            let Some(Among { beta, .. }) = asked.among else { continue };
            let kept = self.kept(asked.omega, self.wavenumbers(beta, accuracy), accuracy);
            if !kept.begun.swap(true, Ordering::Relaxed)
                && let Ok(ground) = self.ground(*asked)
            {
                // found now, and kept; a ground without them is answered all the same
                let _ = ground.modes();
            }
        }
    }
}
