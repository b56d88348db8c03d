//! Every component of the 60-digit reference.

use crate::common::{named, rows};
use groundwave::soil::{DirectStiffness, GroundSolver};
use num_complex::Complex64;
use std::f64::consts::TAU;

#[test]
fn reference() {
    let mut worst = 0.0f64;
    for row in rows(include_str!("../reference/surface_compliance.csv")) {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let (k, frequency) = (number(1), number(2));
        let pair = |i: usize| Complex64::new(number(i), number(i + 1));
        let expected = [pair(3), pair(5), pair(7), pair(9)];
        let largest = expected.iter().map(|z| z.norm()).fold(0.0, f64::max);
        for sign in [1.0, -1.0] {
            let ground = DirectStiffness.prepare(&named(row[0]), sign * TAU * frequency, &[]).unwrap();
            let g = ground.surface(k);
            // G(−ω) = conj G(ω), and u_xz = i × real at ω = 0
            let got = if sign > 0.0 {
                [g.u_zz, g.u_xx, g.u_xz, g.u_yy]
            } else {
                [g.u_zz.conj(), g.u_xx.conj(), -g.u_xz.conj(), g.u_yy.conj()]
            };
            for (got, expected) in got.iter().zip(expected) {
                let error = (got - expected).norm() / largest;
                worst = worst.max(error);
            }
        }
    }
    println!("worst {worst:e}");
    // measured 5.4e-12, at k = 1e-4 where the layers are thinnest against 1/k
    assert!(worst < 1e-10, "{worst:e}");
}
