//! Sections of supports by the waves of their bays, and by the forces of all supports on the bare rail.

use crate::common::sleepers::Rock;
use groundwave::rail::Receptance;
use groundwave::rail::periodic::{Coupled, SectionForces};
use groundwave::track::{Link, Member, Section, Stack, Supports};
use std::f64::consts::TAU;

fn section(bays: Option<usize>, ballast: f64, spacing: f64) -> Section {
    let rail = Member::timoshenko(6.38e6, 60.23, 2.364e8, 0.239, 0.02).unwrap();
    let spring = |k: f64, eta| Link::spring(k, 0.0, eta).unwrap();
    let track =
        Stack::new(vec![rail, Member::mass(245.0).unwrap()], vec![spring(3.5e8, 0.25), spring(ballast, 1.0)]);
    Section { bays, supports: Supports::new(&track, spacing, None, None).unwrap() }
}

#[test]
fn forces_of_supports_are_waves_from_bay_to_bay() {
    // the last section has another spacing
    let sections = [section(None, 9e7, 0.6), section(Some(7), 1.8e8, 0.6), section(None, 3.6e8, 0.65)];
    let (waves, forces) =
        (Coupled::new(&sections, &Rock).unwrap(), SectionForces::new(&sections, &Rock).unwrap());
    let x = [-3.1, -0.6, 0.0, 2.05, 4.2, 9.9];
    let mut worst = 0.0f64;
    for frequency in [40.0, 110.0, 300.0, 600.0] {
        for from in [-0.9, 1.7, 6.0] {
            let one = waves.at(&x, from, TAU * frequency).unwrap();
            let two = forces.at(&x, from, TAU * frequency).unwrap();
            let own = waves.at(&[from], from, TAU * frequency).unwrap()[0].value.norm();
            let gap = one.iter().zip(&two).map(|(a, b)| (a.value - b.value).norm() / own);
            worst = gap.fold(worst, f64::max);
        }
    }
    println!("sections: {worst:.1e}");
    // measured 2.1e-14
    assert!(worst < 1e-8, "{worst:e}");
    // waves run farther there than 240 supports on a side
    assert!(forces.at(&x, -0.9, TAU * 1250.0).is_err_and(|error| error.to_string().contains("coupled")));
}
