//! What does the ground's surface around the train do?

mod shown;

use super::{Outcome, StudyError};
use crate::field::{Field, GroundField, GroundLoad, Quantity, Window};
use crate::memory;
use crate::progress::Observer;
use crate::railway::{Contact, Railway};
use crate::soil::Profile;
use crate::soil::strip::sinc;
use num_complex::Complex64;

/// Wrap-around and aliasing relative to the peak above which they are a concern.
const TOLERABLE: f64 = 5e-3;

/// Samples of a transform beyond which the clearance is not widened any more.
const MOST_SAMPLES: usize = 12_000_000;

/// Maps of the ground's surface in the moving frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// What to map, and where.
    pub window: Window,
    /// Displacements and velocities wanted.
    pub quantities: Vec<Quantity>,
    /// Distance left between the window and its periodic images [m]; by default from damping and wavelength.
    pub clearance: Option<f64>,
}

/// The ground's surface in the moving frame, at every speed.
#[derive(Clone, Debug)]
pub struct GroundMaps {
    /// v [m/s]
    pub speeds: Vec<f64>,
    /// x′ [m], positive ahead of the leading axle.
    pub x: Vec<f64>,
    /// y [m], from the centre line.
    pub y: Vec<f64>,
    /// What the arrays of a field are of.
    pub quantities: Vec<Quantity>,
    /// A field for each speed.
    pub fields: Vec<Field>,
    /// Speeds [m/s] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
}

/// Distance over which a wave of wavenumber `k` fades to e^{−7} = 1e-3 in the least damped layer: e^{−ηkr/2}.
fn fading_distance(profile: &Profile, k: f64) -> f64 {
    let eta = profile.materials().map(|m| m.loss_factor()).fold(f64::INFINITY, f64::min);
    (14.0 / (eta * k)).clamp(100.0, 600.0)
}

/// Refuses a grid, of `what` with `columns` × `rows` samples, that needs more than the free memory [bytes].
pub(super) fn check_memory(
    what: &'static str,
    (columns, rows): (usize, usize),
    needed: u64,
) -> Result<(), StudyError> {
    if let Some(available) = memory::available().filter(|available| needed > *available) {
        let [needed_gb, available_gb] = [needed, available].map(|bytes| bytes as f64 / 1e9);
        return Err(StudyError::Memory { what, columns, rows, needed_gb, available_gb });
    }
    Ok(())
}

impl Contour {
    /// Refuses a point in a window without extent and grids beyond the free memory.
    ///
    /// # Errors
    /// No ground, no train, too large a grid.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        let ground = railway.ground()?;
        let (profile, solver) = (&ground.profile, ground.solver);
        let train = railway.train()?;
        // the finest grid: the strip's edges and the longest fading distance
        let force = |_: f64| Complex64::ONE;
        let load = match ground.contact()?.strip() {
            Some(strip) => GroundLoad::Strip {
                force: &force,
                beta_max: 10.0 / strip.half_width,
                half_width: strip.half_width,
            },
            None => GroundLoad::Point,
        };
        let field = GroundField { profile, solver, speed: 0.0, train, load };
        self.check_memory(&field, self.clearance.unwrap_or(200.0))
    }

    fn check_memory(&self, field: &GroundField, clearance: f64) -> Result<(), StudyError> {
        let grid = field.grid(&self.window, clearance);
        let samples = (grid.x.period_count, grid.y.period_count);
        let needed = grid.bytes(self.quantities.len(), self.window.counts(), self.speeds.len());
        check_memory("contour", samples, needed)
    }

    /// Fields of all speeds in the moving frame.
    ///
    /// Accuracy: 0.2 % of the largest value (test `cross_solver::contour`).
    ///
    /// # Errors
    /// No ground, no train, undamped waves, too large a grid.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<GroundMaps, StudyError> {
        let fields = self
            .speeds
            .iter()
            .map(|&speed| self.field(railway, speed, observer))
            .collect::<Result<Vec<_>, StudyError>>()?;
        let missed =
            self.speeds.iter().zip(&fields).map(|(v, field)| (*v, field.1)).filter(|(_, worst)| *worst > 1.0);
        Ok(GroundMaps {
            speeds: self.speeds.clone(),
            x: self.window.x_positions(),
            y: self.window.y_positions(),
            quantities: self.quantities.clone(),
            missed: missed.collect(),
            fields: fields.into_iter().map(|field| field.0).collect(),
        })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown(railway))
    }

    /// The field at one speed, and the error of the track's spectrum over what was allowed.
    fn field(
        &self,
        railway: &Railway,
        speed: f64,
        observer: &dyn Observer,
    ) -> Result<(Field, f64), StudyError> {
        let ground = railway.ground()?;
        let (profile, solver) = (&ground.profile, ground.solver);
        let train = railway.train()?;
        railway.check_damping(std::iter::once(speed))?;
        // the distance at which waves have faded is estimated first, then measured
        let compute = |load: GroundLoad, k: f64| -> Result<Field, StudyError> {
            let mut last = None;
            let field = GroundField { profile, solver, speed, train, load };
            let mut clearance = self.clearance.unwrap_or_else(|| fading_distance(profile, k));
            loop {
                match (self.check_memory(&field, clearance), last) {
                    (Ok(()), _) => {}
                    (Err(_), Some(result)) => return Ok(result),
                    (Err(error), None) => return Err(error),
                }
                let grid = field.grid(&self.window, clearance);
                let result = field.compute(&self.window, &grid, &self.quantities, observer)?;
                let samples = grid.x.period_count * grid.y.period_count;
                let faded = result.wrap_around <= TOLERABLE || self.clearance.is_some();
                if faded || samples > MOST_SAMPLES {
                    return Ok(result);
                }
                last = Some(result);
                clearance *= 2.0;
            }
        };
        match ground.contact()? {
            Contact::Strip(strip) => {
                let track = railway.track()?;
                let spectrum = track.spectrum(speed)?;
                let force = |beta: f64| spectrum.force(beta);
                let load = GroundLoad::Strip {
                    force: &force,
                    beta_max: spectrum.force_extent(),
                    half_width: strip.half_width,
                };
                let field = compute(load, spectrum.dominant_wavenumber())?;
                Ok((field, spectrum.worst()))
            }
            Contact::Patch { half_length, strip } => {
                let force = |beta: f64| Complex64::from(sinc(beta * half_length));
                // sixteen radians over the half-length: the rest of sinc is 0.3 % of the peak
                let load = GroundLoad::Strip {
                    force: &force,
                    beta_max: 16.0 / half_length,
                    half_width: strip.half_width,
                };
                Ok((compute(load, 1.0 / half_length)?, 0.0))
            }
            Contact::Point => Ok((compute(GroundLoad::Point, 1.0)?, 0.0)),
        }
    }
}
