//! The recomputed speed curves of the paper's two tracks.

use crate::common::named;
use groundwave::foundation::LayeredSoil;
use groundwave::interaction::TrackOnFoundation;
use groundwave::soil::{Compatibility, Solver, Strip};
use groundwave::track::{Ballast, Ballasted, Link, Member, Slab};

#[test]
fn reference() {
    let text: serde_json::Value =
        serde_json::from_str(include_str!("../reference/critical_speed.json")).unwrap();
    for case in text.as_array().unwrap() {
        let rail = Member::beam(12.76e6, 120.46, 0.0).unwrap();
        let pad = Link::spring(7e8, 3.84e4, 0.0).unwrap();
        let (stack, compatibility) = if case["name"] == "paper_slab" {
            let slab = Member::beam(9.77e7, 1250.0, 0.0).unwrap();
            (Slab { rail, pad, slab }.stack(), Compatibility::Mean)
        } else {
            let ballast = Ballast::Bars {
                young: 1.4e8,
                height: 0.35,
                alpha: 0.5,
                wave_speed: 333.0,
                half_width: 1.25,
                loss_factor: 0.0,
            };
            (Ballasted { rail, pad, sleeper_mass: 490.0, ballast }.stack().unwrap(), Compatibility::Centre)
        };
        let soil = LayeredSoil::new(
            named("paper_layered"),
            Solver::DirectStiffness,
            Strip { half_width: 1.25, compatibility },
            1e-8,
        )
        .unwrap();
        let track = TrackOnFoundation::new(&stack, &soil, 0.0);
        let list =
            |key: &str| case[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect::<Vec<_>>();
        for ((speed, down), up) in list("speed").iter().zip(list("max_down")).zip(list("max_up")) {
            let t = std::time::Instant::now();
            let response = track.moving(*speed, 60.0).unwrap();
            let t1 = t.elapsed();
            let shape = response.shape(-60.0, 0.05, 1601);
            let t2 = t.elapsed();
            let got_down = 150e3 * shape.rail.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let got_up = 150e3 * shape.rail.iter().map(|w| -w).fold(f64::NEG_INFINITY, f64::max);
            println!(
                "{speed:6} {:+.5}% {:+.5}%  {up:e} {got_up:e} {} {t1:?} {t2:?}",
                (got_down / down - 1.0) * 100.0,
                (got_up - up) / down * 100.0,
                response.converged
            );
        }
    }
}
