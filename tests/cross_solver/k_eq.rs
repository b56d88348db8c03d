//! Nine-digit equivalent stiffness.

use crate::common::{named, rows};
use groundwave::soil::{Compatibility, DirectStiffness, GroundSolver, Strip};
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
