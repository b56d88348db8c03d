//! What does a train do that passes in time: contact that lets go, defects, hanging sleepers?

mod doubts;
mod plan;
mod run;
mod settings;
mod shown;

pub use run::Run;
pub use settings::{ContactLaw, Passage, Running, Start, Step};

use super::{Outcome, StudyError};
use crate::concern::Concern;
use crate::contact::{Law, March, MarchError, Rolling, Start as Beginning};
use crate::irregularity::{Defect, JenkinsWheel, LumpedTrack, Unevenness};
use crate::progress::{Cancelled, Observer};
use crate::rail::fem::{Fault, FemError, Form, Mesh, Model, Scheme};
use crate::railway::Railway;
use crate::vehicle::{Axle, ContactSpring, Hertz, Multibody};
use doubts::BAY;
use plan::Plan;
use rayon::prelude::*;
use run::{Moment, Recorder};

/// Signs of progress a speed gives.
const SIGNS: usize = 100;

/// Passages at all speeds.
#[derive(Clone, Debug)]
pub struct Passed {
    /// How wheels press, or that loads are constant.
    law: &'static str,
    /// How it began.
    start: &'static str,
    /// Whether wheels roll, or constant loads move.
    rolls: bool,
    /// Where defects lie [m], named.
    marks: Vec<(f64, String)>,
    /// One by one.
    runs: Vec<Run>,
    /// What they may be doubted for.
    concerns: Vec<Concern>,
}

/// What rolls on as many rails as the numbers of the track stand for.
struct OnRails {
    axles: Vec<Axle>,
    wheels: Option<(Multibody, Vec<Law>)>,
    /// Irregularity and defects.
    waves: Unevenness,
    defects: Unevenness,
}

impl Passage {
    /// Marches the train of `railway` over its track at every speed.
    ///
    /// Accuracy: that of the march (tests `elements`); histories, envelopes and extremes hold what it says, extremes of all steps.
    ///
    /// # Errors
    /// A track without finite elements in time; a march that finds no equilibrium or diverges; cancellation.
    pub fn solve(&self, railway: &Railway, observer: &dyn Observer) -> Result<Passed, StudyError> {
        let length = railway.train()?.length();
        observer.begin("passage", (SIGNS * self.speeds.len()) as u64);
        let runs = self.speeds.par_iter().map(|speed| self.pass(*speed, railway, observer));
        let runs = runs.collect::<Result<Vec<_>, _>>()?;
        observer.end();
        let mut concerns = self.doubts(railway);
        // the speed that wants the longest track
        let (mut longest, mut wanted) = (0.0, self.speeds[0]);
        for &speed in &self.speeds {
            let margin = self.margin(railway, speed)?;
            if margin > longest {
                (longest, wanted) = (margin, speed);
            }
            concerns.extend(self.long_steps(speed, &self.plan(railway, speed)?));
        }
        let mesh = self.mesh(railway, &self.plan(railway, wanted)?, true)?;
        concerns.extend(self.short(&mesh, length, longest));
        let defects = self.running.iter().flat_map(|running| &running.defects);
        let passed = Passed {
            law: self.running.as_ref().map_or("constant loads", |running| running.law.name()),
            start: self.begins().name(),
            rolls: self.running.is_some(),
            marks: defects.map(|(defect, at, _)| (*at, defect.name().to_owned())).collect(),
            runs,
            concerns,
        };
        let pulled = self.running.as_ref().and_then(|running| passed.pulled(running.law));
        Ok(Passed { concerns: passed.concerns.iter().cloned().chain(pulled).collect(), ..passed })
    }

    /// As [`Self::solve`], shown.
    ///
    /// # Errors
    /// As `solve`.
    pub fn run(&self, railway: &Railway, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        Ok(self.solve(railway, observer)?.shown())
    }

    /// Refuses tracks without finite elements in time, places and sleepers that are not on the track.
    ///
    /// # Errors
    /// As said.
    pub fn check(&self, railway: &Railway) -> Result<(), StudyError> {
        let plan = self.plan(railway, self.speeds[0])?;
        let (whole, mesh) = (self.mesh(railway, &plan, false)?, self.mesh(railway, &plan, true)?);
        let (from, to) = (mesh.x[0], mesh.x[mesh.x.len() - 1]);
        if let Some(&x) = self.at.iter().find(|x| !(from..=to).contains(*x)) {
            return Err(StudyError::OffTrack { x, from, to });
        }
        for (key, found, wanted) in [
            ("missing_sleepers", whole.supports.len() - mesh.supports.len(), self.missing.len()),
            ("hanging_sleeper", mesh.gaps.len(), self.hanging.len()),
        ] {
            if found != wanted {
                return Err(StudyError::NoSleeper { key, found, wanted, from, to });
            }
        }
        self.model(mesh).map(drop)
    }

    /// The track in time.
    fn model(&self, mesh: Mesh) -> Result<Model, StudyError> {
        let model = Model::new(mesh, self.ends);
        match &self.damping {
            Some(damping) => Ok(model.damped(damping).map_err(MarchError::from)?),
            None => Ok(model),
        }
    }

    /// How it begins.
    fn begins(&self) -> Start {
        self.start.unwrap_or(if self.running.is_some() { Start::Static } else { Start::Ramp })
    }

    /// Whether the irregularity grows from nothing under wheels that start at rest.
    fn fades(&self) -> bool {
        let rough = self.running.as_ref().is_some_and(|running| running.irregularity.is_some());
        rough && self.begins() == Start::Static
    }

    /// What each wheel rolls over at its place: the irregularity times s = t³(10 − 15t + 6t²), t growing from 0 to 1 over the ramp,
    /// where it fades in; defects as they are.
    fn rough(&self, rolls: &OnRails, wheel: usize, x: f64) -> f64 {
        let begin = self.run.0 + rolls.axles[0].position - rolls.axles[wheel].position;
        let t = if self.fades() { ((x - begin) / self.ramp).clamp(0.0, 1.0) } else { 1.0 };
        let s = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
        s * rolls.waves.under(wheel, x) + rolls.defects.under(wheel, x)
    }

    /// The track of `plan` in elements, with or without what is wrong with its sleepers.
    fn mesh(&self, railway: &Railway, plan: &Plan, faulty: bool) -> Result<Mesh, StudyError> {
        let (from, to) = plan.track;
        // a continuous track ends where it is said to
        let bay = (to - from) / ((to - from) / BAY).ceil();
        let mut faults: Vec<(i64, Fault)> = Vec::new();
        if faulty {
            faults.extend(self.missing.iter().map(|&n| (n, Fault::Missing)));
            faults.extend(self.hanging.iter().map(|&(n, gap)| (n, Fault::Hanging(gap))));
        }
        let cut = (bay, self.elements_per_bay);
        Mesh::of(railway.layout(), railway.springs()?, plan.track, cut, Form::Time, &faults)
            .map_err(|error| MarchError::from(error).into())
    }

    /// What rolls, and over what.
    fn on_rails(&self, railway: &Railway) -> Result<OnRails, StudyError> {
        let train = railway.train()?;
        // of each wheelset, its load and its contact
        let share = 0.5 * self.rails.count();
        let load = |axle: &Axle| Axle { load: share * axle.load, ..*axle };
        let axles: Vec<Axle> = train.axles().iter().map(load).collect();
        let Some(running) = &self.running else {
            let smooth = Unevenness::default();
            return Ok(OnRails { axles, wheels: None, waves: smooth.clone(), defects: smooth });
        };
        let bodies = if share < 1.0 { running.bodies.per_rail() } else { running.bodies.clone() };
        let law = |(axle, spring): (&Axle, &ContactSpring)| {
            let stiffness = share * spring.stiffness;
            let hertz = Hertz::through(stiffness, share * spring.load)?;
            Ok(match running.law {
                ContactLaw::NonLinear => Law::Hertz(hertz),
                ContactLaw::Linear => {
                    Law::Linear { stiffness, load: axle.load, approach: hertz.approach(axle.load) }
                }
            })
        };
        let laws = bodies.axles().iter().zip(&running.contact).map(law);
        let laws = laws.collect::<Result<_, StudyError>>()?;
        let way = self.run.1 - self.run.0 + train.length();
        let waves = running.waves(way)?.between(self.run.0 - train.length(), self.run.1);
        let axles = bodies.axles().to_vec();
        Ok(OnRails { axles, wheels: Some((bodies, laws)), waves, defects: running.dents() })
    }

    /// The passage at one `speed` [m/s].
    fn pass(&self, speed: f64, railway: &Railway, observer: &dyn Observer) -> Result<Run, StudyError> {
        let train = railway.train()?;
        let plan = self.plan(railway, speed)?;
        let model = self.model(self.mesh(railway, &plan, true)?)?;
        let rolls = self.on_rails(railway)?;
        let scheme = Scheme::new(plan.step, self.alpha).map_err(|e| MarchError::from(FemError::from(e)))?;
        let start = match self.begins() {
            Start::Static => Beginning::Static,
            Start::Ramp => Beginning::Ramp(self.ramp / speed),
        };
        let rolling = match &rolls.wheels {
            Some((bodies, laws)) => Rolling::Bodies(bodies, laws.clone()),
            None => Rolling::Loads(&rolls.axles),
        };
        let from = self.run.0 + train.axles()[0].position;
        let rough = |wheel: usize, x: f64| self.rough(&rolls, wheel, x);
        let mut march = March::new(&model, scheme, rolling, speed, from, &rough, start)?;
        let rails = self.rails.count();
        let first = rolls.axles[0].position;
        let loads = rolls.axles.iter().map(|axle| (axle.load / rails, axle.position - first)).collect();
        let names = rolls.wheels.as_ref().map_or(Vec::new(), |(bodies, _)| names(bodies));
        let joints = self.joints(&model, &rolls, speed)?;
        // as they stand along the track
        let mut hanging: Vec<i64> = self.hanging.iter().map(|sleeper| sleeper.0).collect();
        hanging.sort_unstable();
        let mut recorder = Recorder::new(
            (speed, self.run.0),
            &plan,
            &model.mesh,
            (loads, names),
            (&self.at, &hanging, &joints),
        );
        let copies = rolls.wheels.as_ref().map_or(0, |(bodies, _)| bodies.copies());
        for step in 0..=plan.count {
            if observer.cancelled() {
                return Err(Cancelled.into());
            }
            if step > 0 {
                march.step()?;
            }
            recorder.take(&moment(&march, rolls.axles.len(), copies, rails));
            if (step * SIGNS) / plan.count != (step + 1) * SIGNS / plan.count {
                observer.advance();
            }
        }
        recorder.finish(self.frequencies)
    }

    /// Where dipped joints lie [m], and P₂ of the leading wheel there by the formula of Jenkins [N].
    fn joints(&self, model: &Model, rolls: &OnRails, speed: f64) -> Result<Vec<(f64, f64)>, StudyError> {
        let (Some(running), Some((bodies, _))) = (&self.running, &rolls.wheels) else {
            return Ok(Vec::new());
        };
        let rails = self.rails.count();
        let first = bodies.wheels()[0];
        let wheel = JenkinsWheel {
            load: rolls.axles[0].load / rails,
            unsprung_mass: bodies.mass()[(first, first)] / rails,
            speed,
        };
        let mut found = Vec::new();
        for (defect, at, _) in &running.defects {
            if let Defect::DippedJoint(joint) = defect {
                let track = lumped(model, *at, rails)?;
                found.push((*at, wheel.p2(joint.angle(), &track)));
            }
        }
        Ok(found)
    }
}

/// How everything stands now, of one of `rails` rails.
fn moment<'a>(march: &'a March, wheels: usize, copies: usize, rails: f64) -> Moment<'a> {
    let states = (0..copies).filter_map(|copy| march.vehicle(copy));
    Moment {
        time: march.time(),
        track: &march.track().u,
        wheels: (0..wheels).map(|i| (march.x(i), march.forces()[i] / rails, march.rail_under(i))).collect(),
        hanging: march.hanging().iter().map(|force| force / rails).collect(),
        vehicle: states.flat_map(|state| state.u.iter().copied().zip(state.a.iter().copied())).collect(),
    }
}

/// Names of all degrees of freedom, copy by copy.
fn names(bodies: &Multibody) -> Vec<String> {
    let of = |copy: usize| {
        bodies.freedoms().iter().map(move |freedom| match bodies.copies() {
            1 => freedom.to_string(),
            _ => format!("vehicle {}, {freedom}", copy + 1),
        })
    };
    (0..bodies.copies()).flat_map(of).collect()
}

/// One of `rails` of the track as one mass, by its deflection u under a force at `at` [m]: uᵀKu/u₀², uᵀMu/u₀², uᵀCu/u₀².
fn lumped(model: &Model, at: f64, rails: f64) -> Result<LumpedTrack, StudyError> {
    let place = model.mesh.rail_at(at).0;
    let u = model.at_rest(&place).map_err(MarchError::from)?;
    let under: f64 = place.iter().map(|&(i, n)| n * u[i]).sum();
    let of = |matrix: &crate::math::banded::Banded<f64>| {
        let mut product = vec![0.0; u.len()];
        matrix.multiply(&u, &mut product);
        product.iter().zip(&u).map(|(a, b)| a * b).sum::<f64>() / (under * under * rails)
    };
    Ok(LumpedTrack { stiffness: of(&model.stiffness), mass: of(&model.mass), damping: of(&model.damping) })
}
