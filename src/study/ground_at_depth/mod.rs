//! What do displacements, strains and stresses of the ground under and beside a train come to, at depth?

mod shown;

use super::{Outcome, StudyError};
use crate::field::{GroundLoad, Underground, UndergroundField, octahedral_strain};
use crate::math::decimal::arithmetic;
use crate::progress::Observer;
use crate::railway::{Contact, Railway};
use crate::soil::Profile;
use crate::soil::strip::sinc;
use ndarray::{Array2, Array3, Axis};
use num_complex::Complex64;

/// Accuracy asked of the integrals.
const ACCURACY: f64 = 1e-5;
/// Depths nearer to the surface [m] are those of a contour.
pub const SHALLOWEST: f64 = 0.05;
/// The cyclic shear strain beyond which most soils change their volume and soften for good: 1e-4 in sands and silts, more in clays.
///
/// Source: Vucetic 1994, J. Geotech. Eng. 120(12):2208.
pub const THRESHOLD: f64 = 1e-4;

/// The state of the ground at some depths, at every speed and at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundAtDepth {
    /// v [m/s]; the train at rest comes by itself.
    pub speeds: Vec<f64>,
    /// z [m], ascending.
    pub depths: Vec<f64>,
    /// y [m], from the centre line.
    pub y: Vec<f64>,
    /// x′ from, to [m]; by default 10 m behind the last axle to 10 m ahead of the leading one.
    pub x: Option<(f64, f64)>,
    /// [m]; 0.25 m by default.
    pub spacing: Option<f64>,
    /// Shear strain that others are compared with; [`THRESHOLD`] by default.
    pub threshold: Option<f64>,
}

/// What there is at every speed: first at rest, speed 0.
#[derive(Clone, Debug)]
pub struct GroundStates {
    /// v [m/s], the first 0.
    pub speeds: Vec<f64>,
    /// x′ [m], positive ahead of the leading axle.
    pub x: Vec<f64>,
    /// y [m]
    pub y: Vec<f64>,
    /// z [m]
    pub depths: Vec<f64>,
    /// A field for each speed.
    pub fields: Vec<UndergroundField>,
    /// γ_oct (z, y, x′) for each speed.
    pub octahedral: Vec<Array3<f64>>,
    /// Depths [m] of the layers' lower faces.
    pub interfaces: Vec<f64>,
    /// Shear strain that others are compared with.
    pub threshold: f64,
    /// Speeds [m/s] at which the accuracy was missed, and by what factor.
    pub missed: Vec<(f64, f64)>,
}

impl GroundStates {
    /// Largest of `value` at each depth of each speed: (speed, z).
    fn largest(&self, value: impl Fn(usize) -> Array3<f64>) -> Array2<f64> {
        let mut all = Array2::zeros((self.speeds.len(), self.depths.len()));
        for (n, mut row) in all.outer_iter_mut().enumerate() {
            for (largest, plane) in row.iter_mut().zip(value(n).axis_iter(Axis(0))) {
                *largest = plane.iter().fold(f64::NEG_INFINITY, |m, v| m.max(*v));
            }
        }
        all
    }

    /// Largest octahedral shear strain (speed, z).
    pub fn largest_strain(&self) -> Array2<f64> {
        self.largest(|n| self.octahedral[n].clone())
    }

    /// Largest of component number `index` of [`crate::field::COMPONENTS`] times `sign` (speed, z).
    pub fn largest_of(&self, index: usize, sign: f64) -> Array2<f64> {
        self.largest(|n| self.fields[n].values.index_axis(Axis(0), index).mapv(|v| sign * v))
    }
}

/// Depths of the lower faces of the layers of `profile` [m].
fn interfaces(profile: &Profile) -> Vec<f64> {
    let mut depth = 0.0;
    let faces = profile.layers().iter().map(|layer| {
        depth += layer.thickness;
        depth
    });
    faces.collect()
}

impl GroundAtDepth {
    /// Refuses what lacks a ground, a contact or a train, and depths outside the ground.
    ///
    /// # Errors
    /// As `solve`, where it can be known beforehand.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        railway.ground()?.profile.split_at(&self.depths)?;
        Ok(())
    }

    /// The states at rest and at all speeds.
    ///
    /// Accuracy: 1e-5 of the largest value of each component at each depth, as estimated by the integrals; 1e-6 against Boussinesq
    /// where more is asked (test `cross_solver::underground`).
    ///
    /// # Errors
    /// No ground, no train, undamped waves.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<GroundStates, StudyError> {
        let profile = &railway.ground()?.profile;
        railway.check_damping(self.speeds.iter().copied())?;
        let length = railway.train()?.length();
        let (from, to) = self.x.unwrap_or((-length - 10.0, 10.0));
        let spacing = self.spacing.unwrap_or(0.25);
        let x = arithmetic(from, spacing, ((to - from) / spacing + 1e-9).floor() as usize + 1);
        let mut speeds = vec![0.0];
        speeds.extend(self.speeds.iter().filter(|v| **v != 0.0));
        observer.begin("ground at depth", speeds.len() as u64);
        let mut missed = Vec::new();
        let mut fields = Vec::new();
        for &speed in &speeds {
            let (field, worst) = self.field(railway, speed, &x)?;
            if worst > 1.0 {
                missed.push((speed, worst));
            }
            fields.push(field);
            observer.done()?;
        }
        observer.end();
        Ok(GroundStates {
            octahedral: fields.iter().map(|field| octahedral_strain(&field.values)).collect(),
            speeds,
            x,
            y: self.y.clone(),
            depths: self.depths.clone(),
            fields,
            interfaces: interfaces(profile),
            threshold: self.threshold.unwrap_or(THRESHOLD),
            missed,
        })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown(railway))
    }

    /// The state at one speed, and the error over what was allowed.
    fn field(&self, railway: &Railway, speed: f64, x: &[f64]) -> Result<(UndergroundField, f64), StudyError> {
        let ground = railway.ground()?;
        let (profile, train) = (&ground.profile, railway.train()?);
        let compute = |load: GroundLoad, worst: f64| -> Result<(UndergroundField, f64), StudyError> {
            let field = Underground { profile, speed, train, load };
            let field = field.compute((x, &self.y, &self.depths), ACCURACY)?;
            // the two integrals share what was allowed
            let own = if field.converged { 0.0 } else { field.error / ACCURACY };
            Ok((field, worst.max(own)))
        };
        match ground.contact()? {
            Contact::Strip(strip) => {
                let track = railway.track()?;
                let spectrum = track.spectrum(speed)?;
                let force = |beta: f64| spectrum.force(beta);
                let half_width = strip.half_width;
                compute(
                    GroundLoad::Strip { force: &force, beta_max: spectrum.beta_max, half_width },
                    spectrum.worst(),
                )
            }
            Contact::Patch { half_length, strip } => {
                let force = |beta: f64| Complex64::from(sinc(beta * half_length));
                compute(
                    GroundLoad::Strip {
                        force: &force,
                        beta_max: f64::INFINITY,
                        half_width: strip.half_width,
                    },
                    0.0,
                )
            }
            Contact::Point => compute(GroundLoad::Point, 0.0),
        }
    }
}
