//! Sleepers that stand apart on layered ground: images in the wavenumber against support forces, and against the continuous track as
//! they come together.

use crate::common::{STRIP, named};
use groundwave::foundation::LayeredSoil;
use groundwave::rail::periodic::{DiracComb, Floquet, PointSource};
use groundwave::rail::{Receptance, TrackOnFoundation};
use groundwave::soil::Solver;
use groundwave::track::{Link, Member, Stack, Supports};
use std::f64::consts::TAU;

/// Rails, pads and sleepers of the paper's ballasted track, per metre.
fn track() -> Stack {
    let members = [Member::beam(12.76e6, 120.46, 0.0), Member::mass(490.0)].map(Result::unwrap);
    Stack::new(members.to_vec(), vec![Link::spring(7e8, 3.84e4, 0.0).unwrap()])
}

fn soil() -> LayeredSoil {
    LayeredSoil::new(named("paper_layered"), Solver::DirectStiffness, STRIP).unwrap()
}

fn sleepers(spacing: f64, width: f64) -> Supports {
    Supports::new(&track(), spacing, Some(width), None).unwrap()
}

#[test]
fn images_are_support_forces() {
    let (supports, soil) = (sleepers(0.6, 0.25), soil());
    let comb = DiracComb::new(&supports, &soil).unwrap();
    let forces = PointSource::new(&supports, &soil).unwrap();
    for frequency in [12.0, 45.0, 150.0] {
        for from in [0.0, 0.35] {
            let x = [0.0, 0.3, 0.6, 1.7, -2.4, 6.0].map(|x| x + from);
            let a = comb.at(&x, from, TAU * frequency).unwrap();
            let b = forces.at(&x, from, TAU * frequency).unwrap();
            let own = a[0].value.norm();
            for (x, (a, b)) in x.iter().zip(a.iter().zip(&b)) {
                println!("{frequency} {x}: {:.1e}", (a.value - b.value).norm() / own);
                // measured 2e-10
                assert!((a.value - b.value).norm() < 1e-8 * own, "{frequency} {x}: {a:?} {b:?}");
            }
            assert!(a[0].value.im < 0.0);
            // reciprocity
            let back = comb.at(&[from], x[3], TAU * frequency).unwrap()[0].value;
            assert!((back - a[3].value).norm() < 1e-9 * own);
        }
    }
}

#[test]
fn sleepers_side_by_side_are_the_continuous_track() {
    let (stack, soil) = (track(), soil());
    let continuous = TrackOnFoundation::new(&stack, &soil, 0.0);
    for frequency in [12.0, 45.0, 100.0] {
        let exact = continuous.harmonic(TAU * frequency, 0.0, 3.0).unwrap();
        let x = [0.0, 1.2];
        let fields = [0.6, 0.3, 0.15].map(|spacing| {
            // no gaps between them
            let supports = sleepers(spacing, spacing);
            let found = DiracComb::new(&supports, &soil).unwrap().at(&x, 0.0, TAU * frequency).unwrap();
            [found[0].value, found[1].value]
        });
        let own = exact.rail(0.0).norm();
        for (i, x) in x.iter().enumerate() {
            let apart = fields.map(|field| (field[i] - exact.rail(*x)).norm() / own);
            let limit = (4.0 * fields[2][i] - fields[1][i]) / 3.0;
            let rest = (limit - exact.rail(*x)).norm() / own;
            println!("{frequency} {x}: {apart:?}, {rest:.1e}");
            // measured 1e-3, 2e-3, 4e-3 at a spacing of 0.15 m, falling as its square
            assert!(apart[2] < 1e-2 && apart[2] < 0.4 * apart[1] && apart[1] < 0.4 * apart[0], "{apart:?}");
            // the integral of the continuous track allows itself 1e-4
            assert!(rest < 3e-4, "{frequency} {x}: {rest:e}");
        }
    }
}

#[test]
fn ground_that_joins_supports_is_refused_by_name() {
    let soil = soil();
    let mut supports = sleepers(0.6, 0.25);
    let error = Floquet::new(&supports, &soil).err().unwrap().to_string();
    assert!(
        error.contains("method \"floquet\" does not know supports that the ground joins")
            && error.contains("dirac-comb, point-source"),
        "{error}"
    );
    supports.width = None;
    let error = DiracComb::new(&supports, &soil).err().unwrap().to_string();
    assert!(error.contains("the width of the sleepers"), "{error}");
}
