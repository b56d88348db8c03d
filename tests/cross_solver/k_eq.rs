//! Nine-digit equivalent stiffness.

use crate::common::{named, rows};
use groundwave::soil::{Compatibility, DirectStiffness, GroundSolver, Layer, Profile, Strip};
use num_complex::Complex64;

#[test]
fn reference() {
    let (mut worst, mut count, mut n) = (0.0f64, 0, 0);
    for row in rows(include_str!("../reference/k_eq.csv")) {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let strip = Strip {
            half_width: number(1),
            compatibility: if row[2] == "mean" { Compatibility::Mean } else { Compatibility::Centre },
        };
        let expected = Complex64::new(number(5), number(6));
        let ground = DirectStiffness.prepare(&named(row[0]), number(4), &[]).unwrap();
        let estimate = ground.strip(number(3), strip, 1e-9);
        let error = (1.0 / estimate.value - expected).norm() / expected.norm();
        assert!(estimate.converged, "{row:?}");
        worst = worst.max(error);
        count += estimate.count;
        n += 1;
    }
    println!("worst {worst:e}, {} evaluations each", count / n);
    // measured 4.6e-10, the ninth digit of the table
    assert!(worst < 1e-7, "{worst:e}");
}

#[test]
fn a_layer_cut_in_pieces_is_asked_no_more_often() {
    let whole = named("paper_layered");
    let top = whole.layers()[0];
    let piece = Layer { thickness: top.thickness / 100.0, ..top };
    let cut = Profile::new(vec![piece; 100], whole.base()).unwrap();
    let strip = Strip { half_width: 1.25, compatibility: Compatibility::Mean };
    for (beta, omega) in [(0.1, 30.0), (1.0, 120.0), (3.0, 300.0)] {
        let ask = |profile| DirectStiffness.prepare(profile, omega, &[]).unwrap().strip(beta, strip, 1e-6);
        let (one, many) = (ask(&whole), ask(&cut));
        assert_eq!(one.count, many.count);
        // measured 1e-13
        assert!((one.value - many.value).norm() < 1e-10 * one.value.norm());
    }
}
