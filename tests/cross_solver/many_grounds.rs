//! Critical speeds of random grounds by a search, 40 speeds to 1e-3, against the whole curve, 100 speeds to 1e-5.
//!
//! `GROUNDWAVE_GROUNDS=1000` makes it a thousand grounds instead of 24, and tells the time of the searches.

use crate::common::{STRIP, tracks};
use groundwave::progress::Silent;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{Base, Elastic, Layer, Material, Profile, Solver};
use groundwave::study::CriticalSpeed;
use groundwave::vehicle::{Axle, Train};
use rayon::prelude::*;
use std::time::Instant;

const FROM: f64 = 40.0;
const TO: f64 = 238.0;

/// Five layers of 0.5 to 3 m over a half-space: c_s 80 to 300 m/s, mostly stiffer with depth, ν 0.3 to 0.48, η 0.03 to 0.1.
fn random(seed: &mut u64) -> Profile {
    let mut uniform = |from: f64, to: f64| {
        // Knuth's MMIX generator: the same grounds in every run
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (*seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut shear = uniform(80.0, 160.0);
    let mut material = || {
        let loss = uniform(0.03, 0.1);
        let elastic = Elastic::ShearPoisson { shear, poisson: uniform(0.3, 0.48) };
        let material = Material::new(elastic, uniform(1500.0, 2000.0), loss, loss).unwrap();
        shear = (shear * uniform(0.85, 1.5)).min(300.0);
        (uniform(0.5, 3.0), material)
    };
    let layers = (0..5).map(|_| material()).map(|(thickness, material)| Layer { thickness, material });
    let layers: Vec<Layer> = layers.collect();
    Profile::new(layers, Base::HalfSpace(material().1)).unwrap()
}

/// One axle on the paper's track on the next random ground.
fn railway(seed: &mut u64) -> Railway {
    let ground = Ground::new(random(seed), Solver::DirectStiffness, Some(Contact::Strip(STRIP)));
    let train = Train::new(vec![Axle { position: 0.0, load: 150e3 }]).unwrap();
    Railway::new(Support::Ground(ground), tracks::ballasted(), Some(train)).unwrap()
}

/// Deflections to 1e-3 are known to 1e-3: nothing is taken for quiet that is not.
#[test]
fn a_search_keeps_its_accuracy() {
    let mut seed = 2;
    let speeds: Vec<f64> = (0..34).map(|i| FROM + 6.0 * f64::from(i)).collect();
    let curve = |accuracy: f64, railway: &Railway| {
        let study = CriticalSpeed { speeds: speeds.clone(), accuracy: Some(accuracy), line_speed: None };
        study.solve(railway, &Silent).unwrap().axle.down
    };
    let railways: Vec<Railway> = (0..30).map(|_| railway(&mut seed)).collect();
    let apart = |railway: &Railway| {
        let (rough, fine) = (curve(1e-3, railway), curve(1e-5, railway));
        rough.iter().zip(&fine).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
    };
    let worst: Vec<f64> = railways.par_iter().map(apart).collect();
    let worst = worst.into_iter().fold(0.0, f64::max);
    println!("largest difference {worst:.1e}");
    assert!(worst < 1e-3, "{worst:e}");
}

#[test]
fn a_search_finds_the_critical_speeds_of_whole_curves() {
    let count = std::env::var("GROUNDWAVE_GROUNDS").ok().and_then(|n| n.parse().ok()).unwrap_or(24);
    let mut seed = 1;
    let speeds = |n: u32| (0..n).map(|i| FROM + (TO - FROM) * f64::from(i) / f64::from(n - 1)).collect();
    let search = CriticalSpeed { speeds: speeds(40), accuracy: Some(1e-3), ..CriticalSpeed::default() };
    let whole = CriticalSpeed { speeds: speeds(100), ..CriticalSpeed::default() };
    let railways: Vec<Railway> = (0..count).map(|_| railway(&mut seed)).collect();
    let start = Instant::now();
    let found: Vec<f64> =
        railways.par_iter().map(|r| search.solve(r, &Silent).unwrap().axle.peak.speed).collect();
    println!("{count} searches: {:.1} s", start.elapsed().as_secs_f64());
    let mut worst = 0.0f64;
    for (railway, found) in railways.iter().zip(found) {
        let exact = whole.solve(railway, &Silent).unwrap().axle.peak;
        if !exact.at_end {
            let error = (found / exact.speed - 1.0).abs();
            worst = worst.max(error);
            assert!(error < 5e-3, "{found} instead of {}, {error:e}", exact.speed);
        }
    }
    println!("largest difference {worst:.1e}");
}
