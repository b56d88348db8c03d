//! The paper's tracks.

use groundwave::soil::Compatibility;
use groundwave::track::{Ballast, Ballasted, Link, Member, Slab, Sleeper, Stack};

/// Application 2's ballasted track, C_b = 333 m/s.
pub fn ballasted() -> Stack {
    let rail = Member::beam(12.76e6, 120.46, 0.0).unwrap();
    let pad = Link::spring(7e8, 3.84e4, 0.0).unwrap();
    let ballast = Ballast::Bars {
        young: 1.4e8,
        height: 0.35,
        alpha: 0.5,
        wave_speed: Some(333.0),
        density: None,
        poisson: None,
        loss_factor: 0.0,
    };
    Ballasted::new(rail.into(), pad.into(), Sleeper::per_metre(490.0), ballast).stack(Some(1.25)).unwrap()
}

/// Application 2's slab track.
pub fn slab() -> Stack {
    let rail = Member::beam(12.76e6, 120.46, 0.0).unwrap();
    let pad = Link::spring(7e8, 3.84e4, 0.0).unwrap();
    let slab = Member::beam(9.77e7, 1250.0, 0.0).unwrap();
    Slab::new(rail.into(), pad.into(), slab).stack().unwrap()
}

/// Stack and compatibility by the name in `critical_speed.json`.
pub fn named(name: &str) -> (Stack, Compatibility) {
    match name {
        "paper_slab" => (slab(), Compatibility::Mean),
        _ => (ballasted(), Compatibility::Centre),
    }
}

/// One rail on sleepers in the words of a case, as Table 3 of Lamprea-Pineda et al. has it, but viscous.
pub const TRACK_IN_TIME: &str = r#"
[foundation]
kind = "rigid"
[track]
kind = "ballasted"
rails = 1
rail.bending_stiffness = 6.38e6
rail.mass = 60.23
pad.stiffness = 3.5e8
pad.damping = 1.92e4
sleeper.mass = 245.0
ballast.kind = "spring"
ballast.stiffness = 1.8e8
ballast.damping = 2.34e5
support.spacing = 0.6
"#;
