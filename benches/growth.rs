//! How do costs grow with layers, speeds, axles, receivers and the size of a grid?

#[path = "../tests/common/mod.rs"]
mod common;

use common::STRIP;
use divan::Bencher;
use groundwave::field::{Quantity, Window};
use groundwave::progress::Silent;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{Layer, Profile, Solver};
use groundwave::study::{Contour, CriticalSpeed, FreeField};
use groundwave::vehicle::{Axle, Train};

fn main() {
    divan::main();
}

fn railway(profile: Profile, axles: usize) -> Railway {
    let ground = Ground::new(profile, Solver::DirectStiffness, Some(Contact::Strip(STRIP)));
    let axles = (0..axles).map(|i| Axle { position: 2.9 * i as f64, load: 150e3 }).collect();
    let train = Train::new(axles).unwrap();
    Railway::new(Support::Ground(ground), common::tracks::ballasted(), Some(train)).unwrap()
}

/// The paper's two metres over a half-space, cut into `count` layers.
fn cut(count: usize) -> Profile {
    let whole = common::named("paper_layered");
    let layer = whole.layers()[0];
    let thin = Layer { thickness: layer.thickness / count as f64, ..layer };
    Profile::new(vec![thin; count], whole.base()).unwrap()
}

fn curve(speeds: u32) -> CriticalSpeed {
    let speeds = (0..speeds).map(|i| 10.0 + 200.0 * f64::from(i) / f64::from(speeds)).collect();
    CriticalSpeed { speeds, ..CriticalSpeed::default() }
}

/// 100 speeds, one axle.
#[divan::bench(args = [1, 2, 5, 20, 50, 100], sample_count = 3)]
fn layers(bencher: Bencher, count: usize) {
    let model = railway(cut(count), 1);
    bencher.bench(|| curve(100).solve(&model, &Silent).unwrap());
}

/// One axle.
#[divan::bench(args = [10, 100, 200, 1000], sample_count = 3)]
fn speeds(bencher: Bencher, count: u32) {
    let model = railway(common::named("paper_layered"), 1);
    bencher.bench(|| curve(count).solve(&model, &Silent).unwrap());
}

/// 100 speeds, axles 2.9 m apart.
#[divan::bench(args = [1, 20, 50, 100, 200], sample_count = 3)]
fn axles(bencher: Bencher, count: usize) {
    let model = railway(common::named("paper_layered"), count);
    bencher.bench(|| curve(100).solve(&model, &Silent).unwrap());
}

/// A smooth rail, 137 m/s, receivers evenly from 4 to 64 m.
#[divan::bench(args = [1, 4, 8, 16, 32], sample_count = 3)]
fn receivers(bencher: Bencher, count: usize) {
    let model = railway(common::named("paper_layered"), 1);
    let study = FreeField {
        speed: 67.5,
        receivers: (0..count).map(|i| 4.0 + 60.0 * i as f64 / count as f64).collect(),
        passage_time: Some(1.0),
        components: Default::default(),
        bands: groundwave::assessment::Band::range(1.0, 80.0).unwrap(),
        roughness: None,
        sections: None,
        assessment: Default::default(),
        building: Default::default(),
    };
    bencher.bench(|| study.solve(&model, &Silent).unwrap());
}

/// `side` × `side` values 0.25 m apart at 137 m/s.
#[divan::bench(args = [256, 512, 1024, 2048, 4096], sample_count = 3)]
fn grid(bencher: Bencher, side: u32) {
    let model = railway(common::named("paper_layered"), 1);
    let half = 0.125 * f64::from(side);
    let study = Contour {
        speeds: vec![137.0],
        window: Window { x: (-1.5 * half, 0.5 * half - 0.25), y: (-half, half - 0.25), spacing: 0.25 },
        quantities: vec![Quantity::Vertical],
        clearance: None,
    };
    bencher.bench(|| study.solve(&model, &Silent).unwrap());
}
