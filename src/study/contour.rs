//! What does the ground's surface around the train do?

use super::critical_speed::missed_accuracy;
use super::track_response::tag;
use super::{Answer, Contact, Model, Outcome, StudyError, speed_text};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::{Field, GroundField, GroundLoad, Quantity, Window};
use crate::figure::{Figure, MapFigure};
use crate::memory;
use crate::progress::Observer;
use crate::soil::Profile;
use crate::soil::strip::sinc;
use ndarray::{Array2, Array3};
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
    let available = memory::available();
    if needed > available {
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
    pub fn check(&self, model: &Model) -> Result<(), StudyError> {
        let (profile, solver) = model.ground("contour")?;
        let train = model.train("contour")?;
        // the finest grid: the strip's edges and the longest fading distance
        let force = |_: f64| Complex64::ONE;
        let load = match model.contact().strip() {
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
        check_memory("contour", samples, grid.bytes(self.quantities.len()))
    }

    /// Fields of all speeds in the moving frame.
    ///
    /// Accuracy: 0.2 % of the largest value (test `cross_solver::contour`).
    ///
    /// # Errors
    /// No ground, no train, undamped waves, too large a grid.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        observer.begin("ground contours", self.speeds.len() as u64);
        let fields = self
            .speeds
            .iter()
            .map(|&speed| {
                let field = self.field(model, speed);
                observer.advance();
                field
            })
            .collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let (fields, converged): (Vec<Field>, Vec<bool>) = fields.into_iter().unzip();
        let mut outcome = self.outcome(&fields);
        let missed = self.speeds.iter().zip(converged).filter(|(_, ok)| !ok).map(|(v, _)| *v);
        outcome.concerns.extend(missed_accuracy(missed));
        outcome.concerns.extend(self.speeds.iter().filter_map(|v| model.outruns_waves(*v)));
        Ok(outcome)
    }

    /// The field at one speed, and whether the track's spectrum met its accuracy.
    fn field(&self, model: &Model, speed: f64) -> Result<(Field, bool), StudyError> {
        let (profile, solver) = model.ground("contour")?;
        let train = model.train("contour")?;
        model.check_damping(std::iter::once(speed))?;
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
                let result = field.compute(&self.window, &grid, &self.quantities)?;
                let samples = grid.x.period_count * grid.y.period_count;
                let faded = result.wrap_around <= TOLERABLE || self.clearance.is_some();
                if faded || samples > MOST_SAMPLES {
                    return Ok(result);
                }
                last = Some(result);
                clearance *= 2.0;
            }
        };
        match *model.contact() {
            Contact::Strip(strip) => {
                let track = model.track()?;
                let spectrum = track.spectrum(speed)?;
                let force = |beta: f64| spectrum.force(beta);
                let load = GroundLoad::Strip {
                    force: &force,
                    beta_max: spectrum.force_extent(),
                    half_width: strip.half_width,
                };
                let field = compute(load, spectrum.dominant_wavenumber())?;
                Ok((field, spectrum.converged()))
            }
            Contact::Patch { half_length, strip } => {
                let force = |beta: f64| Complex64::from(sinc(beta * half_length));
                // sixteen radians over the half-length: the rest of sinc is 0.3 % of the peak
                let load = GroundLoad::Strip {
                    force: &force,
                    beta_max: 16.0 / half_length,
                    half_width: strip.half_width,
                };
                Ok((compute(load, 1.0 / half_length)?, true))
            }
            Contact::Point => Ok((compute(GroundLoad::Point, 1.0)?, true)),
        }
    }

    fn outcome(&self, fields: &[Field]) -> Outcome {
        let (x, y) = (self.window.x_positions(), self.window.y_positions());
        let mut group = Group::new("contour")
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .coordinate("y", &y, "m", "position across the track, from its centre line")
            .coordinate("x", &x, "m", "position relative to the leading axle, positive ahead (moving frame)");
        let mut outcome = Outcome::default();
        for (i, &quantity) in self.quantities.iter().enumerate() {
            let (unit, factor, label, long) = match quantity {
                Quantity::Vertical => {
                    ("m", 1e3, "u_z [mm], positive down", "vertical ground displacement, positive down")
                }
                Quantity::VerticalVelocity => {
                    ("m s-1", 1e3, "v_z [mm/s], positive down", "vertical ground velocity, positive down")
                }
                Quantity::Along => (
                    "m",
                    1e3,
                    "u_x [mm]",
                    "ground displacement along the track, positive in the direction of travel",
                ),
                Quantity::Across => {
                    ("m", 1e3, "u_y [mm]", "ground displacement across the track, positive towards +y")
                }
            };
            let mut all = Array3::zeros((fields.len(), y.len(), x.len()));
            for (n, (field, &speed)) in fields.iter().zip(&self.speeds).enumerate() {
                all.index_axis_mut(ndarray::Axis(0), n).assign(&field.values[i]);
                let at = speed_text(speed);
                let map = MapFigure {
                    name: format!("contour_{}_{}", quantity.name(), tag(speed)),
                    title: format!("Ground surface at {at}"),
                    x_label: "x′ [m], travel to the right".into(),
                    y_label: "y [m]".into(),
                    value_label: label.into(),
                    x: x.clone(),
                    y: y.clone(),
                    values: field.values[i].mapv(|v| factor * v),
                    symmetric: true,
                    equal_axes: true,
                    overlay: Vec::new(),
                };
                outcome
                    .figures
                    .push((Figure::Map(map), format!("At {at}, seen from the leading axle: {long}.")));
                outcome.answers.push(self.largest(quantity, &field.values[i], speed, long, unit));
            }
            group = group.variable(quantity.name(), &["speed", "y", "x"], all.into_dyn(), unit, long);
        }
        let number = |f: fn(&Field) -> f64| ndarray::Array1::from_iter(fields.iter().map(f)).into_dyn();
        outcome.group = group
            .variable(
                "wrap_around",
                &["speed"],
                number(|f| f.wrap_around),
                "1",
                "remainder at the border of the period over the largest value",
            )
            .variable(
                "aliasing",
                &["speed"],
                number(|f| f.aliasing),
                "1",
                "estimate of the part beyond the largest wavenumber over the largest value",
            )
            .variable(
                "period_x",
                &["speed"],
                number(|f| f.period.0),
                "m",
                "period of the transform along the track",
            )
            .variable(
                "period_y",
                &["speed"],
                number(|f| f.period.1),
                "m",
                "period of the transform across the track",
            );
        for (field, &speed) in fields.iter().zip(&self.speeds) {
            let at = speed_text(speed);
            if field.wrap_around > TOLERABLE {
                outcome.concerns.push(Concern::new(
                    "wrap-around",
                    format!("at {at} {:.2} % of the largest value is left at the border of the {:.0} m × {:.0} m period", 100.0 * field.wrap_around, field.period.0, field.period.1),
                    "set contour.clearance to a larger distance [m]",
                ));
            }
            if field.aliasing > TOLERABLE {
                outcome.concerns.push(Concern::new(
                    "aliasing",
                    format!(
                        "at {at} about {:.2} % of the largest value lies beyond the largest wavenumber",
                        100.0 * field.aliasing
                    ),
                    "use a contour.spacing below a tenth of the contact half-width, or half of the present one",
                ));
            }
        }
        outcome
    }

    fn largest(
        &self,
        quantity: Quantity,
        values: &Array2<f64>,
        speed: f64,
        long: &str,
        unit: &'static str,
    ) -> Answer {
        let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let shown = if quantity == Quantity::VerticalVelocity { "mm/s" } else { "mm" };
        let unit = if unit == "m s-1" { "m/s" } else { unit };
        Answer::new(
            &format!("max_{}_{}", quantity.name(), tag(speed)),
            format!(
                "Largest {} in the window at {}",
                long.split(',').next().unwrap_or(long),
                speed_text(speed)
            ),
            largest,
            unit,
            format!("{:.3} {shown}", 1e3 * largest),
        )
    }
}
