//! What does the ground beside a rough track cost, by receivers, and what do the contact forces of a train?

#[path = "../tests/common/mod.rs"]
mod common;

use divan::Bencher;
use groundwave::assessment::Band;
use groundwave::contact::{ContactForces, WheelRail};
use groundwave::foundation::LayeredSoil;
use groundwave::irregularity::{FraBreakWavenumber, Spectrum};
use groundwave::progress::Silent;
use groundwave::rail::TrackOnFoundation;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{Compatibility, DirectStiffness, GroundSolver, Solver, Strip, ThinLayer};
use groundwave::study::{FreeField, Irregularity, Roughness};
use groundwave::track::{Ballast, Ballasted, Link, Member, Sleeper, Stack};
use groundwave::vehicle::{Axle, BogieVehicle, Multibody, Suspension, Train};
use std::f64::consts::TAU;

const SPEED: f64 = 67.5;
const STRIP: Strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };

fn main() {
    divan::main();
}

/// The track of application 3.
fn stack() -> Stack {
    let rail = Member::beam(12.76e6, 120.46, 0.0).unwrap();
    let pad = Link::spring(7e8, 0.0, 0.15).unwrap();
    let ballast = Ballast::ConsistentMass { stiffness: 3.6e8, damping: 0.0, loss_factor: 1.0, mass: 1695.8 };
    Ballasted::new(rail.into(), pad.into(), Sleeper::per_metre(490.0), ballast).stack(None).unwrap()
}

/// Baseline: a million evaluations of G, on one thread.
#[divan::bench(sample_count = 10)]
fn baseline_u_zz_1e6(bencher: Bencher) {
    let ground = DirectStiffness.prepare(&common::named("paper_layered"), 137.0, &[]).unwrap();
    bencher.bench(|| common::sum_u_zz(ground.as_ref(), 1_000_000));
}

/// Application 3: one wheel, 25 bands from 0.315 to 80 Hz, receivers evenly up to 20 m.
#[divan::bench(args = [1, 2, 4, 8], sample_count = 3)]
fn application3(bencher: Bencher, receivers: usize) {
    let train = Train::new(vec![Axle { position: 0.0, load: 150e3 }]).unwrap();
    let roughness = Roughness {
        bodies: Multibody::unsprung(2003.0, 150e3).unwrap(),
        contact: vec![1.94e9],
        irregularity: Irregularity::Random {
            spectrum: Spectrum::FraBreakWavenumber(FraBreakWavenumber::new(5).unwrap()),
            wavelengths: (0.45, 135.0),
            seed: 1,
            count: 10,
        },
    };
    let study = FreeField {
        speed: SPEED,
        receivers: (1..=receivers).map(|i| 20.0 * i as f64 / receivers as f64).collect(),
        passage_time: Some(1.0),
        components: Default::default(),
        bands: Band::range(0.315, 80.0).unwrap(),
        roughness: Some(roughness),
        sections: None,
        assessment: Default::default(),
        building: Default::default(),
    };
    let thin = Solver::ThinLayer(ThinLayer::default());
    let support =
        Support::Ground(Ground::new(common::named("paper_layered"), thin, Some(Contact::Strip(STRIP))));
    let model = Railway::new(support, stack(), Some(train)).unwrap();
    bencher.bench(|| study.run(&model, &Silent).unwrap());
}

/// Contact forces for wavelengths from 0.5 to 80 m: one wheel, and eight ICE 3.
#[divan::bench(args = [1, 32], sample_count = 3)]
fn contact_forces(bencher: Bencher, wheels: usize) {
    let vehicle = BogieVehicle {
        body: groundwave::vehicle::Body {
            mass: 47_800.0,
            pitch_inertia: 1.957888e6,
            bogie_centres: 17.375,
            count: 1,
        },
        bogie: groundwave::vehicle::Bogie {
            mass: 3500.0,
            pitch_inertia: 1715.0,
            wheelbase: 2.5,
            wheelsets: 2,
        },
        wheelset: groundwave::vehicle::Wheelset { mass: 1800.0 },
        primary: Suspension { stiffness: 2.4e6, damping: 20e3 },
        secondary: Suspension { stiffness: 0.7e6, damping: 40e3 },
    };
    let offsets: Vec<f64> = (0..8).map(|i| 24.775 * f64::from(i)).collect();
    let bodies = if wheels == 1 {
        Multibody::unsprung(2003.0, 150e3).unwrap()
    } else {
        Multibody::ten(&vehicle).unwrap().row(&offsets).unwrap()
    };
    let stack = stack();
    let soil = LayeredSoil::new(common::named("paper_layered"), Solver::DirectStiffness, STRIP).unwrap();
    let track = TrackOnFoundation::new(&stack, &soil, 0.0);
    let contact = vec![2.4e9; wheels];
    let wheels = WheelRail { track: &track, bodies: &bodies, contact: &contact, speed: SPEED };
    bencher.bench(|| ContactForces::new(&wheels, (TAU / 80.0, TAU / 0.5), &Silent).unwrap().worst);
}
