//! The tracks of `reference/track_fe_*.json` in time.

use crate::common::sleepers::{self, Loss, SPACING, rail};
use groundwave::contact::{March, Rolling, Start};
use groundwave::foundation::{FoundationModel, Springs};
use groundwave::rail::fem::{Column, Ends, Fault, Form, Mesh, Model, Scheme, Station};
use groundwave::track::{Layout, Link, Member, Stack};
use groundwave::vehicle::{Axle, Hertz, Multibody, Tread};

pub const D: f64 = SPACING;

pub fn rock() -> Springs {
    Springs::new(FoundationModel::Rigid).unwrap()
}

/// Two layers per metre, ballast `factor` times that of Table 3.
pub fn layers(beam: Member, factor: f64) -> Stack {
    let springs = [(3.5e8, 1.92e4), (factor * 1.8e8, 2.34e5)].map(|(k, c)| Link::spring(k, c, 0.0).unwrap());
    Stack::new(vec![beam, Member::mass(245.0).unwrap()], springs.to_vec())
}

pub fn layout(support: &str, beam: &str) -> Layout {
    match support {
        "continuous" => Layout::Continuous(layers(rail(beam, 0.0), 1.0)),
        _ => Layout::Discrete(sleepers::layers(rail(beam, 0.0), 2, 1.8e8, Loss::Viscous)),
    }
}

/// `bays` of Table 3 from x = 0 on, pinned, `ne` elements each.
pub fn table(support: &str, beam: &str, bays: usize, ne: usize, faults: &[(i64, Fault)]) -> Model {
    let range = (0.0, D * bays as f64 - 1e-6);
    let mesh = Mesh::of(&layout(support, beam), &rock(), range, (D, ne), Form::Time, faults).unwrap();
    assert_eq!(mesh.x.len(), bays * ne + 1);
    Model::new(mesh, Ends::Pinned)
}

/// The rail of Table 3 with ballast that changes along the track: `factor(x)` of it, at once at `jump` where there is one.
pub fn changing(
    support: &str,
    bays: usize,
    ne: usize,
    jump: Option<f64>,
    stack: &dyn Fn(f64) -> Stack,
) -> Model {
    let on = Stack::default();
    let column = |x: f64| Column::new(&stack(x), &on).unwrap().in_time().unwrap();
    let mesh = if support == "continuous" {
        let x: Vec<f64> = (0..=bays * ne).map(|i| D * i as f64 / ne as f64).collect();
        let jumps: Vec<usize> = x
            .iter()
            .enumerate()
            .filter(|(_, x)| jump.is_some_and(|j| (*x - j).abs() < 1e-9))
            .map(|(i, _)| i)
            .collect();
        Mesh::continuous(x, &jumps, &|_, x| Ok(column(x))).unwrap()
    } else {
        let stations: Vec<Station> = (0..=bays)
            .map(|bay| {
                let x = D * bay as f64;
                let all = stack(x);
                let supports = groundwave::track::Supports::new(&all, D, None, None).unwrap();
                let under = Column::under(&supports, &rock()).unwrap().in_time().unwrap();
                Station { x, under: Some((under, None)), rail: Column::rail(all.members()[0]), elements: ne }
            })
            .collect();
        Mesh::supported(&stations).unwrap()
    };
    Model::new(mesh, Ends::Pinned)
}

/// A load of 75 kN at `speed`, from `start` [m] on, ramped over `ramp` [m].
pub fn load<'a>(
    model: &'a Model,
    axle: &'a [Axle],
    speed: f64,
    per_bay: usize,
    (start, ramp): (f64, f64),
) -> March<'a> {
    let scheme = Scheme::new(D / (speed * per_bay as f64), 0.0).unwrap();
    March::new(model, scheme, Rolling::Loads(axle), speed, start, &|_, _| 0.0, Start::Ramp(ramp / speed))
        .unwrap()
}

pub const LOAD: [Axle; 1] = [Axle { position: 0.0, load: 75e3 }];

/// Largest difference over the largest of `exact`.
pub fn off(found: &[f64], exact: &[f64]) -> f64 {
    assert_eq!(found.len(), exact.len());
    let most = exact.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    found.iter().zip(exact).fold(0.0f64, |worst, (a, b)| worst.max((a - b).abs())) / most
}

/// The contact of every file: worn, 0.46 m.
pub fn hertz() -> Hertz {
    Hertz::new(Tread::Worn, 0.46).unwrap()
}

/// A wheel of 600 kg under 75 kN.
pub fn wheel() -> Multibody {
    Multibody::unsprung(600.0, 75e3).unwrap()
}
