//! Laws of a stack of members and links on any foundation.

use crate::draw::log;
use crate::{Verdict, ask, report, within};
use groundwave::Track as Published;
use groundwave::track::{Ballast, Ballasted, Displacements, Link, Member, Slab, Sleeper, Stack};
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::PI;

/// A track with its mass [kg/m] and the compliance at rest of its links in series [m²/N].
#[derive(Clone, Debug)]
pub struct Track {
    pub stack: Stack,
    pub mass: f64,
    pub flexibility: f64,
}

/// A track, β, ω > 0 and two foundations of no negative damping.
type Input = (Track, f64, f64, Complex64, Complex64);
/// How a stack answers (β, ω, k): the law of the crate, or a wrong one.
type Respond = fn(&Stack, f64, f64, Complex64) -> Displacements;
type Law = fn(Respond, &Input) -> Verdict;

const LAWS: &[(&str, Law)] = &[
    ("stack reciprocity", reciprocity),
    ("stack passivity", passivity),
    ("stack conjugate", conjugate),
    ("stack even in β", even),
    ("stack at rest", at_rest),
    ("stack as a rigid mass", rigid_mass),
];

fn damping() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![1 => Just(0.0), 2 => log(1e-3, 0.5)]
}

/// Numbers of a track: of beams EI [N m²], m [kg/m], η; of springs k [N/m²], c [N s/m²], η.
#[derive(Clone, Debug)]
pub struct Numbers {
    rail: (f64, f64, f64),
    slab: (f64, f64, f64),
    pad: (f64, f64, f64),
    ballast: (f64, f64, f64),
    /// [kg/m]
    mass: f64,
    /// [m]
    height: f64,
    /// [m/s]
    wave_speed: f64,
}

impl Numbers {
    fn rail(&self) -> Member {
        Member::beam(self.rail.0, self.rail.1, self.rail.2).unwrap()
    }

    fn slab(&self) -> Member {
        Member::beam(self.slab.0, self.slab.1, self.slab.2).unwrap()
    }

    fn pad(&self) -> Link {
        Link::spring(self.pad.0, self.pad.1, self.pad.2).unwrap()
    }

    /// The springs of the ballast.
    fn bed(&self) -> Link {
        Link::spring(self.ballast.0, self.ballast.1, self.ballast.2).unwrap()
    }

    /// With the mass of the ballast [kg/m].
    fn ballasted(&self, ballast: Ballast, mass: f64) -> Track {
        let sleeper = Sleeper::per_metre(self.mass);
        let track = Ballasted::new(self.rail().into(), self.pad().into(), sleeper, ballast);
        let track = Published::Ballasted(track);
        Track {
            stack: track.stack(Some(2.0)).unwrap(),
            mass: self.rail.1 + self.mass + mass,
            flexibility: 1.0 / self.pad.0 + 1.0 / self.ballast.0,
        }
    }
}

/// Every registered track, and a rail on a shear layer.
const TRACKS: &[fn(&Numbers) -> Track] =
    &[beam, slab, floating_slab, consistent_mass, bars, padded, two_layers, shear_layer];

fn beam(n: &Numbers) -> Track {
    let track = Published::Beam { rails: None, beam: n.rail().into() };
    Track { stack: track.stack(None).unwrap(), mass: n.rail.1, flexibility: 0.0 }
}

fn slab(n: &Numbers) -> Track {
    let track = Published::Slab(Slab::new(n.rail().into(), n.pad().into(), n.slab()));
    Track { stack: track.stack(None).unwrap(), mass: n.rail.1 + n.slab.1, flexibility: 1.0 / n.pad.0 }
}

fn floating_slab(n: &Numbers) -> Track {
    let track = Slab { mat: Some(n.bed().into()), ..Slab::new(n.rail().into(), n.pad().into(), n.slab()) };
    let stack = Published::Slab(track).stack(None).unwrap();
    Track { stack, mass: n.rail.1 + n.slab.1, flexibility: 1.0 / n.pad.0 + 1.0 / n.ballast.0 }
}

/// With pads under the sleepers, and a mat under ballast that weighs nothing.
fn padded(n: &Numbers) -> Track {
    let sleeper = Sleeper::per_metre(n.mass);
    let ballast = Ballast::Spring { spring: n.bed() };
    let mut track = Ballasted::new(n.rail().into(), n.pad().into(), sleeper, ballast);
    (track.under_sleeper_pad, track.mat) = (Some(n.pad().into()), Some(n.bed().into()));
    let stack = Published::Ballasted(track).stack(None).unwrap();
    Track { stack, mass: n.rail.1 + n.mass, flexibility: 2.0 / n.pad.0 + 2.0 / n.ballast.0 }
}

/// Ballast as a mass on sub-ballast as a spring, on a mat.
fn two_layers(n: &Numbers) -> Track {
    let sleeper = Sleeper::per_metre(n.mass);
    let ballast = Ballast::Block { mass: 2.0 * n.mass, link: None, spring: n.bed() };
    let mut track = Ballasted::new(n.rail().into(), n.pad().into(), sleeper, ballast);
    (track.sub_ballast, track.mat) = (Some(Ballast::Spring { spring: n.bed() }), Some(n.pad().into()));
    let stack = Published::Ballasted(track).stack(None).unwrap();
    Track { stack, mass: n.rail.1 + 3.0 * n.mass, flexibility: 2.0 / n.pad.0 + 2.0 / n.ballast.0 }
}

fn consistent_mass(n: &Numbers) -> Track {
    let (stiffness, damping, loss_factor) = n.ballast;
    let mass = 2.0 * n.mass;
    n.ballasted(Ballast::ConsistentMass { stiffness, damping, loss_factor, mass }, mass)
}

fn bars(n: &Numbers) -> Track {
    let (stiffness, _, loss_factor) = n.ballast;
    let (height, alpha, wave_speed) = (n.height, 0.5, Some(n.wave_speed));
    // EA = 2αb E = k h with b = 2; m = EA h/C²
    let young = stiffness * height / 2.0;
    let bars = Ballast::Bars { young, height, alpha, wave_speed, density: None, poisson: None, loss_factor };
    n.ballasted(bars, stiffness * (height / n.wave_speed).powi(2))
}

fn shear_layer(n: &Numbers) -> Track {
    let layer = Member::string(n.slab.0, n.mass).unwrap();
    let stack = Stack::new(vec![n.rail(), layer], vec![n.pad()]);
    Track { stack, mass: n.rail.1 + n.mass, flexibility: 1.0 / n.pad.0 }
}

/// Rails, pads and what lies under them, from toy to heavy.
pub fn track() -> impl Strategy<Value = Track> {
    let beam = (log(1e6, 1e9), log(30.0, 5000.0), damping());
    let spring = (log(1e7, 1e10), prop_oneof![Just(0.0), log(1e2, 1e6)], damping());
    (
        beam.clone(),
        beam,
        spring.clone(),
        spring,
        log(50.0, 2000.0),
        0.2..0.6,
        log(100.0, 600.0),
        0..TRACKS.len(),
    )
        .prop_map(|(rail, slab, pad, ballast, mass, height, wave_speed, kind)| {
            TRACKS[kind](&Numbers { rail, slab, pad, ballast, mass, height, wave_speed })
        })
}

fn inputs() -> impl Strategy<Value = Input> {
    let foundation =
        || (log(1e5, 1e10), 0.0..PI).prop_map(|(k, angle): (f64, f64)| Complex64::from_polar(k, angle));
    (track(), log(1e-3, 20.0), log(1.0, 1e4), foundation(), foundation())
}

/// Betti between two foundations under one track: u_r(k₁) − u_r(k₂) = −(k₁ − k₂) u_b(k₁) u_b(k₂), which holds exactly
/// if and only if a load on the rail moves the base as much as a load on the base moves the rail.
fn reciprocity(respond: Respond, (track, beta, omega, k1, k2): &Input) -> Verdict {
    let (one, two) = (respond(&track.stack, *beta, *omega, *k1), respond(&track.stack, *beta, *omega, *k2));
    let work = (k1 - k2) * one.base * two.base;
    let gap = (one.rail - two.rail + work).norm() / (one.rail.norm() + two.rail.norm() + work.norm());
    // measured 2.1e-14: links up to 1e5 times stiffer than the foundation
    within(gap, 5e-13, || format!("{one:?} {two:?}"))
}

/// What goes in at the rail, −Im u_r, is at least what goes down into the foundation, Im k |u_b|².
fn passivity(respond: Respond, (track, beta, omega, k, _): &Input) -> Verdict {
    let u = respond(&track.stack, *beta, *omega, *k);
    let lost = (u.rail.im + k.im * u.base.norm_sqr()) / (u.rail.norm() + k.norm() * u.base.norm_sqr());
    // measured 1.7e-16
    within(lost, 1e-14, || format!("{u:?}"))
}

/// u(−ω, k̄) = ū(ω, k)
fn conjugate(respond: Respond, (track, beta, omega, k, _): &Input) -> Verdict {
    let plus = respond(&track.stack, *beta, *omega, *k);
    let minus = respond(&track.stack, *beta, -omega, k.conj());
    let gap = (plus.rail.conj() - minus.rail).norm() / plus.rail.norm()
        + (plus.base.conj() - minus.base).norm() / plus.base.norm();
    // measured 0
    within(gap, 1e-14, || format!("{plus:?} {minus:?}"))
}

fn even(respond: Respond, (track, beta, omega, k, _): &Input) -> Verdict {
    let gap = (respond(&track.stack, *beta, *omega, *k).rail - respond(&track.stack, -beta, *omega, *k).rail)
        .norm();
    // measured 0: only β² enters
    within(gap, 0.0, || "β".into())
}

/// At β = ω = 0 the links are springs in series over the foundation, and the foundation carries the whole load.
fn at_rest(respond: Respond, (track, _, _, k, _): &Input) -> Verdict {
    let stiffness = k.norm();
    let u = respond(&track.stack, 0.0, 0.0, stiffness.into());
    let rail = 1.0 / stiffness + track.flexibility;
    // damping sleeps at rest: no imaginary part
    let gap = (u.rail - rail).norm() / rail + (u.base * stiffness - 1.0).norm();
    // measured 7.9e-16, with links 1e5 times stiffer than the foundation
    within(gap, 1e-14, || format!("{u:?}"))
}

/// On nothing, slowly, all masses move together: −ω² m u = 1.
fn rigid_mass(respond: Respond, (track, ..): &Input) -> Verdict {
    // ω²m is a millionth of the softest link, 1e7 N/m²
    let omega = (1.0 / track.mass).sqrt();
    let u = respond(&track.stack, 0.0, omega, Complex64::ZERO);
    let gap = (u.rail * omega * omega * track.mass + 1.0).norm();
    // measured 3.9e-6: ω²m/k of the links
    within(gap, 5e-5, || format!("{u:?}"))
}

#[test]
fn stacks_obey_every_law() {
    for (name, law) in LAWS {
        report(name, ask(4000, &inputs(), |input| law(Stack::respond, input)));
    }
}

#[test]
fn wrong_stacks_are_caught() {
    let wrong: &[(&str, Respond)] = &[
        ("stack reciprocity", |s, b, w, k| {
            let u = s.respond(b, w, k);
            Displacements { base: u.base * 1.001, ..u }
        }),
        ("stack passivity", |s, b, w, k| {
            let u = s.respond(b, w, k);
            Displacements { rail: u.rail.conj(), ..u }
        }),
        ("stack conjugate", |s, b, w, k| s.respond(b, w.abs(), k)),
        ("stack even in β", |s, b, w, k| s.respond(if b < 0.0 { 1.000_001 * b } else { b }, w, k)),
        ("stack at rest", |s, b, w, k| s.respond(b, w, k * 1.000_001)),
        ("stack as a rigid mass", |s, b, w, k| s.respond(b, 1.001 * w, k)),
    ];
    for (name, law) in LAWS {
        let (_, respond) = wrong.iter().find(|(n, _)| n == name).expect("a wrong stack for every law");
        assert!(ask(200, &inputs(), |input| law(*respond, input)).is_err(), "{name}");
    }
}

/// A mat that does not give way leaves the track as it is without it, and so do pads under sleepers.
#[test]
fn stiff_mats_are_none() {
    let stiff = || Some(Link::spring(1e20, 0.0, 0.0).unwrap().into());
    let rail = || Member::beam(1.276e7, 120.46, 0.0).unwrap().into();
    let pad = || Link::spring(7e8, 3.84e4, 0.1).unwrap().into();
    let bed = Link::spring(3.6e8, 1e5, 0.2).unwrap();
    let ballast = Ballast::Block { mass: 1700.0, link: None, spring: bed };
    let plain = Ballasted::new(rail(), pad(), Sleeper::per_metre(490.0), ballast);
    let matted = Ballasted { under_sleeper_pad: stiff(), mat: stiff(), ..plain };
    let slab = Slab::new(rail(), pad(), Member::beam(9.77e7, 1250.0, 0.01).unwrap());
    let floating = Slab { mat: stiff(), ..slab };
    let stacks = [
        (plain.stack(None).unwrap(), matted.stack(None).unwrap()),
        (slab.stack().unwrap(), floating.stack().unwrap()),
    ];
    for (without, with) in stacks {
        for (beta, omega, k) in [(0.0, 0.0, 1e8), (0.8, 90.0, 8e7), (3.0, 2000.0, 5e9)] {
            let k = Complex64::new(k, 0.1 * k);
            let (a, b) = (without.respond(beta, omega, k), with.respond(beta, omega, k));
            let gap = (a.rail - b.rail).norm() / a.rail.norm() + (a.base - b.base).norm() / a.base.norm();
            println!("a stiff mat against none: {gap:.1e}");
            // 5e9/1e20 of the compliances, more where the base hardly moves
            assert!(gap < 1e-8, "{gap} {a:?} {b:?}");
        }
    }
}
