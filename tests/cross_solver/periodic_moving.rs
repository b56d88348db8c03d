//! Loads that move over equal supports: images in the wavenumber against one standing force after another.

use crate::common::sleepers::{Loss, Rock, SPACING, layers, rail};
use crate::drawn;
use groundwave::rail::periodic::{DiracComb, Floquet, MovingGreen};
use groundwave::rail::{Drive, Moving, Receptance};
use groundwave::track::{Link, Member, Stack, Supports};
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(drawn(100))]

    #[test]
    fn spectra_agree(
        f in prop::array::uniform8(-1.0..1.0f64),
        thick in any::<bool>(),
        x in -2.0..2.0f64,
        speed in 3.0..90.0f64,
        load in prop::sample::select(vec![0.0, 50.0, 400.0]),
        below in any::<bool>(),
    ) {
        let f = f.map(|f| 10f64.powf(f));
        let spacing = 0.6 * f[0].powf(0.3);
        let (ei, m) = (6.38e6 * f[1], 60.23 * f[2]);
        let rail = if thick {
            Member::timoshenko(ei, m, 2.364e8 * f[3], 0.239, 0.0).unwrap()
        } else {
            Member::beam(ei, m, 0.0).unwrap()
        };
        let spring = |k: f64, c: f64| Link::spring(spacing * k, spacing * c, 0.0).unwrap();
        let members = vec![Member::mass(0.0).unwrap(), Member::mass(spacing * 245.0 * f[4]).unwrap()];
        let links = vec![spring(3.5e8 * f[5], 1.92e4), spring(1.8e8 * f[6], 2.34e5 * f[7])];
        let supports = Supports { rail, spacing, under: Stack::new(members, links), width: None };
        let drive = Drive { omega: TAU * load, speed };
        let comb = DiracComb::new(&supports, &Rock).unwrap();
        let green = MovingGreen::new(&supports, &Rock).unwrap();
        let floquet = Floquet::new(&supports, &Rock).unwrap();
        for frequency in [3.0, 20.0, 70.0, 300.0] {
            let omega = TAU * frequency * if below { -1.0 } else { 1.0 };
            let a = comb.spectrum(drive, x, omega).unwrap();
            let b = green.spectrum(drive, x, omega).unwrap();
            // what the parts of the second are, that cancel where short waves are asked
            let parts = floquet.at(&[x], x, omega.abs()).unwrap()[0].value.norm() * spacing / speed;
            prop_assert!((a - b).norm() < 1e-8 * a.norm() + 1e-10 * parts, "{frequency}: {a} {b} {parts:e}");
        }
    }
}

#[test]
fn seen_from_the_load_they_agree() {
    let supports = layers(rail("EB", 0.0), 1, 1.8e8, Loss::Viscous);
    let comb = DiracComb::new(&supports, &Rock).unwrap();
    let green = MovingGreen::new(&supports, &Rock).unwrap();
    for drive in [Drive { omega: 0.0, speed: 60.0 }, Drive { omega: TAU * 80.0, speed: 60.0 }] {
        let x = [0.0, 1.3];
        let a = comb.under(drive, 0.2 * SPACING, &x).unwrap();
        let b = green.under(drive, 0.2 * SPACING, &x).unwrap();
        // a bay on everything is the same
        let c = comb.under(drive, 3.2 * SPACING, &x).unwrap();
        for i in 0..2 {
            // measured 2e-10
            println!("{:.1e}", (a[i].value - b[i].value).norm() / a[0].value.norm());
            assert!((a[i].value - b[i].value).norm() < 1e-8 * a[0].value.norm(), "{:?} {:?}", a[i], b[i]);
            assert!((a[i].value - c[i].value).norm() < 1e-10 * a[0].value.norm(), "{:?} {:?}", a[i], c[i]);
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let supports = layers(rail("T", 0.0), 1, 1.8e8, Loss::Viscous);
    let comb = DiracComb::new(&supports, &Rock).unwrap();
    let fast = comb.under(Drive { omega: 0.0, speed: 2000.0 }, 0.0, &[0.0]).unwrap_err().to_string();
    assert!(
        fast.contains("2000.0 m/s is at or above 1981.1 m/s, the speed of the rail's shear waves"),
        "{fast}"
    );
}
