//! What a passage may be doubted for.

use super::Passed;
use super::plan::Plan;
use super::settings::{ContactLaw, Passage, Start};
use crate::concern::Concern;
use crate::irregularity::Defect;
use crate::rail::fem::Mesh;
use crate::railway::Railway;
use crate::study::{speed_text, trimmed};
use crate::track::{Layout, Member};

/// Metres of a bay of a track without supports.
pub(super) const BAY: f64 = 0.6;

/// The rails of `layout`, each over its bay [m].
fn rails(layout: &Layout) -> Vec<(Member, f64)> {
    match layout {
        Layout::Continuous(stack) => stack.members().first().map(|rail| (*rail, BAY)).into_iter().collect(),
        Layout::Discrete(supports) => vec![(supports.rail, supports.spacing)],
        Layout::Varying(sections) => {
            sections.iter().map(|section| (section.supports.rail, section.supports.spacing)).collect()
        }
    }
}

impl Passage {
    /// What can be doubted before a step is taken, of elements, profiles and the rail.
    pub(super) fn doubts(&self, railway: &Railway) -> Vec<Concern> {
        let rails = rails(railway.layout());
        let wanted =
            |(rail, bay): &(Member, f64)| self.wanted_elements(*bay, rail.bending_stiffness / rail.mass);
        let wanted = rails.iter().map(wanted).max().unwrap_or(1);
        let coarse = (self.elements_per_bay < wanted).then(|| {
            Concern::new(
                "coarse-elements",
                format!(
                    "passage.elements_per_bay is {}: wheels that roll, and bending waves of {} Hz, need {wanted}",
                    self.elements_per_bay, self.frequencies.1
                ),
                "use more elements, or a lower passage.frequencies.to",
            )
        });
        let shears = rails.iter().any(|(rail, _)| rail.shears()).then(|| {
            Concern::new(
                "shearing-rail",
                "the rail shears: a force on it makes a kink that elements cannot show as it moves through them, and the contact force ripples by up to 1 % of the static load",
                "give the rail without shear_stiffness (rail.section brings one) where wheels roll on it",
            )
        });
        coarse.into_iter().chain(shears).chain(self.long_ramp()).chain(self.deep_flats()).collect()
    }

    /// A start that is not over where the way is.
    fn long_ramp(&self) -> Option<Concern> {
        let way = self.run.1 - self.run.0;
        ((self.begins() == Start::Ramp || self.fades()) && self.ramp >= way).then(|| {
            Concern::new(
                "long-ramp",
                format!(
                    "the start takes hold over {} m, the way of the leading axle is {way} m long",
                    self.ramp
                ),
                "move passage.from back, or use a shorter passage.ramp",
            )
        })
    }

    /// A `mesh` from whose ends waves return under a train `length` [m] long: it wants `margin` [m] beyond the axles.
    pub(super) fn short(&self, mesh: &Mesh, length: f64, margin: f64) -> Option<Concern> {
        let (first, last) = (mesh.x[0], mesh.x[mesh.x.len() - 1]);
        let beyond = (self.run.0 - length - first).min(last - self.run.1);
        // decimals of the file
        (beyond < margin - 1e-9).then(|| {
            Concern::new(
                "short-track",
                format!(
                    "the track ends {beyond:.1} m beyond the axles, and waves return from its ends: {} m are wanted",
                    trimmed((10.0 * margin).ceil() / 10.0)
                ),
                "make passage.track longer, or leave it out",
            )
        })
    }

    /// Flats deeper than a fresh one.
    fn deep_flats(&self) -> impl Iterator<Item = Concern> {
        let defects = self.running.iter().flat_map(|running| running.defects.iter().enumerate());
        defects.filter_map(|(i, (defect, ..))| {
            let Defect::RoundedFlat(flat) = defect else { return None };
            let (depth, fresh) = flat.depths();
            // rounding of an l²/(8R) from the file
            (depth > fresh * (1.0 + 1e-6)).then(|| {
                Concern::new(
                    "deep-flat",
                    format!(
                        "passage.defect[{i}] is {:.3} mm deep, a fresh flat as long l²/(8R) = {:.3} mm",
                        1e3 * depth,
                        1e3 * fresh
                    ),
                    "check depth and length [m]: rolling makes a flat longer, not deeper",
                )
            })
        })
    }

    /// What can be doubted of the steps of `plan` at `speed` [m/s].
    pub(super) fn long_steps(&self, speed: f64, plan: &Plan) -> Option<Concern> {
        let wanted = self.wanted_step(speed);
        // steps chosen are as long as wanted, to rounding
        (plan.step > wanted * (1.0 + 1e-9)).then(|| {
            Concern::new(
                "long-steps",
                format!(
                    "at {} the step is {:.3e} s ({:.3} mm of way): profiles and frequencies up to {} Hz need {wanted:.3e} s",
                    speed_text(speed),
                    plan.step,
                    1e3 * plan.step * speed,
                    self.frequencies.1
                ),
                format!(
                    "use passage.step = {wanted:.2e} or passage.step_length = {:.2e}, or leave both out",
                    wanted * speed
                ),
            )
        })
    }
}

impl Passed {
    /// Wheels that a linear contact pulls.
    pub(super) fn pulled(&self, law: ContactLaw) -> Option<Concern> {
        let pulled = self
            .runs
            .iter()
            .filter(|run| law == ContactLaw::Linear && run.wheels.iter().any(|w| w.min.1 < 0.0));
        let speeds: Vec<String> = pulled.map(|run| speed_text(run.speed)).collect();
        (!speeds.is_empty()).then(|| {
            Concern::new(
                "pulling-contact",
                format!(
                    "at {} the linear contact pulls where wheels would leave the rail",
                    speeds.join(", ")
                ),
                "use passage.contact = \"non-linear\"",
            )
        })
    }
}
