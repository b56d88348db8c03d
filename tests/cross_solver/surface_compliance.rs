//! Every component of the 60-digit reference.

use crate::common::{named, rows};
use groundwave::soil::haskell::haskell;
use groundwave::soil::{GroundSolver, Profile, SoilError, Solver, SurfaceCompliance};
use num_complex::Complex64;
use std::f64::consts::TAU;

fn check(
    name: &str,
    tolerance: f64,
    answer: impl Fn(&Profile, f64, f64) -> Option<SurfaceCompliance>,
) -> usize {
    let (mut worst, mut answered) = (0.0f64, 0);
    for row in rows(include_str!("../reference/surface_compliance.csv")) {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let (k, frequency) = (number(1), number(2));
        let pair = |i: usize| Complex64::new(number(i), number(i + 1));
        let expected = [pair(3), pair(5), pair(7), pair(9)];
        let largest = expected.iter().map(|z| z.norm()).fold(0.0, f64::max);
        for sign in [1.0, -1.0] {
            let Some(g) = answer(&named(row[0]), sign * TAU * frequency, k) else { continue };
            answered += 1;
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
    println!("{name}: worst {worst:e} of {answered}");
    assert!(worst < tolerance, "{name} {worst:e}");
    answered
}

#[test]
fn exact_solvers() {
    // measured 5.4e-12, at k = 1e-4 where the layers are thinnest against 1/k
    for (solver, tolerance) in
        [(Solver::DirectStiffness, 1e-10), (Solver::TransferMatrix, 1e-10), (Solver::Flexibility, 1e-10)]
    {
        let answer = |p: &Profile, omega, k| Some(solver.prepare(p, omega, &[]).unwrap().surface(k));
        assert_eq!(check(&format!("{solver:?}"), tolerance, answer), 900);
    }
}

#[test]
fn haskells_product_is_right_or_refuses() {
    let answered = check("Haskell", 1e-9, |p, omega, k| match haskell(p, omega, k) {
        Ok(g) => Some(g),
        Err(SoilError::DigitsLost { error, .. }) => {
            assert!(error.is_nan() || error > 1e-9);
            None
        }
        Err(other) => panic!("{other}"),
    });
    assert!(answered > 300, "{answered}");
}
