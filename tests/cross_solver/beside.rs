//! Receivers beside a strip on the lifted path against the adaptive quadrature of the same ground on the real axis.

use crate::poles::grounds;
use groundwave::soil::{DirectStiffness, GroundSolver, Motion, strip};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Asked, of the largest value of each receiver.
const RELATIVE: f64 = 1e-4;
const HALF_WIDTH: f64 = 1.25;

#[test]
fn receivers_on_the_path_are_those_of_the_axis() {
    let (mut refused, mut asked) = (0, 0);
    for (name, profile) in grounds() {
        let mut worst = 0.0f64;
        for (y, f) in
            [(&[5.0, 20.0][..], 1.0), (&[8.0, 16.0, 32.0], 7.0), (&[5.0, 20.0], 25.0), (&[8.0, 32.0], 80.0)]
        {
            let ground = DirectStiffness.prepare(&profile, TAU * f, &[]).unwrap();
            let slowest = *ground.outline().wavenumbers.last().unwrap();
            let shares = [0.0, 0.2, 0.5, 0.8, 0.95, 1.0, 1.03, 1.3, 2.5];
            asked += 1;
            let wanted: Vec<(f64, Motion)> =
                Motion::ALL.iter().flat_map(|motion| y.iter().map(|y| (*y, *motion))).collect();
            let Some(receivers) = ground.receivers_lifted(HALF_WIDTH, &wanted, RELATIVE) else {
                refused += 1;
                continue;
            };
            let got: Vec<_> = shares.iter().map(|share| receivers.at(share * slowest)).collect();
            for (r, &(y, motion)) in wanted.iter().enumerate() {
                let exact = |share: f64| {
                    let nepers = (share * share - 1.0).max(0.0).sqrt() * slowest * (y - HALF_WIDTH);
                    let relative = (0.03 * RELATIVE * nepers.exp()).min(0.1);
                    // what has faded by twelve nepers is nothing beside the largest
                    if nepers > 12.0 {
                        None
                    } else {
                        Some(ground.beside(share * slowest, HALF_WIDTH, y, motion, relative).value)
                    }
                };
                let exact: Vec<_> = shares.iter().map(|share| exact(*share)).collect();
                let largest = exact.iter().flatten().map(|z| z.norm()).fold(0.0, f64::max);
                // where the path does not settle the axis answers
                for (exact, got) in
                    exact.iter().zip(&got).filter_map(|(exact, got)| Some((exact, got.as_ref()?)))
                {
                    worst = worst.max((got[r].value - exact.unwrap_or_default()).norm() / largest);
                }
            }
        }
        println!("{name}: {worst:.1e} of the largest");
        assert!(worst < 1e-3, "{name}: {worst:e}");
    }
    println!("refused {refused} of {asked}");
    assert!(refused < 10, "{refused} of {asked}");
}

/// Slower than every wave each motion is known to an accuracy of itself, down to e^{−20} and far closer than the damping would let it.
#[test]
fn what_fades_is_known_as_well() {
    let (mut asked, mut answered, mut most, mut worst) = (0, 0, 0, 0.0f64);
    for (name, profile) in grounds() {
        for omega in [TAU * 3.0, TAU * 25.0, -TAU * 25.0] {
            let ground = DirectStiffness.prepare(&profile, omega, &[]).unwrap();
            let outline = ground.outline();
            let slowest = *outline.wavenumbers.last().unwrap();
            for share in [1.05, 1.3, 1.7, 3.0] {
                let beta = share * slowest;
                let fades = |y: f64| (share * share - 1.0).sqrt() * slowest * (y - HALF_WIDTH) < 20.0;
                let y: Vec<f64> = [4.0, 8.0, 32.0].into_iter().filter(|y| fades(*y)).collect();
                for (y, motion) in y.iter().flat_map(|y| Motion::ALL.map(|motion| (*y, motion))) {
                    asked += 1;
                    let Some(got) = ground.evanescent(beta, HALF_WIDTH, (y, motion), 1e-5) else {
                        println!("{name}, {omega:.0} rad/s, {share}, {y} m {motion:?}: not answered");
                        continue;
                    };
                    answered += 1;
                    most = most.max(got.count);
                    let exact = match motion {
                        Motion::Vertical => {
                            let u_zz = |k: &[f64]| ground.u_zz_many(k);
                            strip::receiver_quadrature(&u_zz, outline, beta, HALF_WIDTH, y, 1e-6)
                        }
                        _ => {
                            let horizontal = |k: &[f64]| -> Vec<Complex64> {
                                k.iter()
                                    .zip(ground.u_xz_many(k))
                                    .map(|(k, u)| u / (Complex64::I * *k))
                                    .collect()
                            };
                            strip::horizontal_quadrature(
                                &horizontal,
                                outline,
                                beta,
                                HALF_WIDTH,
                                y,
                                motion,
                                1e-6,
                            )
                        }
                    };
                    // what the axis does not know is no witness
                    if exact.converged {
                        let apart = (got.value - exact.value).norm() / exact.value.norm();
                        worst = worst.max(apart);
                        assert!(
                            apart < 1e-5,
                            "{name}, {omega:.0} rad/s, {share}, {y} m {motion:?}: {apart:e}"
                        );
                    }
                }
            }
        }
    }
    println!("{worst:.1e} apart, {answered} of {asked} answered, by {most} points at most");
    assert!(answered > 9 * asked / 10);
}

#[test]
fn undamped_ground_stays_on_the_axis() {
    // waves that do not fade: the integral on the axis, with which the path is compared, does not settle
    let undamped = grounds()[0].1.with_loss(0.0);
    let ground = DirectStiffness.prepare(&undamped, 120.0, &[]).unwrap();
    assert!(
        ground.receivers_lifted(HALF_WIDTH, &[5.0, 20.0].map(|y| (y, Motion::Vertical)), RELATIVE).is_none()
    );
}
