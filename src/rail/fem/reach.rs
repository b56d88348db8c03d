//! How far from a moving load its track feels it, and so how long a track in elements must be.

use crate::foundation::Springs;
use crate::rail::Drive;
use crate::rail::continuous::along;
use crate::track::{Layout, Member, Stack, Supports, Tower};

/// Distance [m] from a constant load at `speed` [m/s] beyond which the rail of `layout` on `on` moves by less than `left` of what it does
/// under the load, supports spread over their bays; infinite where a wave that loses nothing carries as much.
///
/// Waves e^{iβⱼx′} of residues rⱼ, poles of ũ(β, −βv): max ln(|rⱼ|/(left Σ|r|))/|Im βⱼ|. What rings on in its place, as sleepers on
/// their pads, has next to no residue and needs no length.
///
/// Accuracy: the length after which a moving load on Table 3 of the paper is known to 1e-5 (test `elements::length`).
pub fn reach(layout: &Layout, on: &Springs, speed: f64, left: f64) -> f64 {
    let of = |stack: &Stack| {
        let drive = Drive { omega: 0.0, speed };
        let Some(ratio) = Tower::new(stack, on.stack()).and_then(|tower| along(&tower, drive)) else {
            return 0.0;
        };
        let waves: Vec<(f64, f64)> = (ratio.denominator.roots().into_iter())
            .map(|beta| {
                let residue = ratio.numerator.at(beta).0 / ratio.denominator.at(beta).1;
                (beta.im.abs(), residue.norm())
            })
            .collect();
        let all: f64 = waves.iter().map(|wave| wave.1).sum();
        let far = |(decay, residue): &(f64, f64)| (residue / (left * all)).ln().max(0.0) / decay;
        waves.iter().map(far).filter(|x| !x.is_nan()).fold(0.0, f64::max)
    };
    match layout {
        Layout::Continuous(stack) => of(stack),
        Layout::Discrete(supports) => of(&spread(supports)),
        Layout::Varying(sections) => sections.iter().map(|s| of(&spread(&s.supports))).fold(0.0, f64::max),
    }
}

/// The stack of `supports` per metre.
fn spread(supports: &Supports) -> Stack {
    let per_metre = |member: &Member| member.times(1.0 / supports.spacing);
    let below = supports.under.members().iter().skip(1).map(per_metre);
    let links = supports.under.links().iter().map(|link| link.times(1.0 / supports.spacing));
    Stack::new(std::iter::once(supports.rail).chain(below).collect(), links.collect())
}
