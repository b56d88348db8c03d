//! The layers of the track as a reader of a report knows them.

use crate::output::ReportTable;
use crate::railway::Railway;
use crate::track::{Layout, Link, Member, Stack};
use std::f64::consts::TAU;

/// At which the loss of a spring is told [Hz].
const FREQUENCY: f64 = 30.0;

/// What a member is, by its place and by whether it bends.
pub(super) fn member_name(stack: &Stack, index: usize) -> &'static str {
    let bends = |i: usize| stack.members()[i].bends();
    match index {
        0 => "rail",
        i if bends(i) => "slab or beam",
        1 => "sleepers",
        _ => "mass",
    }
}

/// What the link under member `index` is.
pub(super) fn link_name(stack: &Stack, index: usize) -> &'static str {
    match (index, stack.members()[index].bends()) {
        (0, _) if stack.members().len() > 1 => "pads",
        (0, _) => "bed",
        (_, true) => "mat",
        (_, false) => "ballast",
    }
}

/// Four digits, or a dash.
fn number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "–".into();
    }
    let digits = (3 - value.abs().log10().floor() as i32).clamp(0, 4) as usize;
    format!("{value:.digits$}")
}

fn member(name: &str, member: &Member) -> Vec<String> {
    vec![
        name.to_owned(),
        number(member.mass),
        number(1e-6 * member.bending_stiffness),
        number(1.0 / member.shear_compliance * 1e-6),
        String::new(),
        number(member.loss_factor),
    ]
}

fn link(name: &str, link: &Link) -> Vec<String> {
    let mass = if let Link::ConsistentMass { mass, .. } = link { *mass } else { 0.0 };
    let at = link.stiffness(TAU * FREQUENCY).cross;
    vec![
        name.to_owned(),
        number(mass),
        String::new(),
        String::new(),
        number(-1e-6 * link.stiffness(0.0).cross.re),
        number(at.im / at.re),
    ]
}

/// What lies under the rail, per metre of track, and on what supports.
pub(super) fn layers(railway: &Railway) -> (Stack, String) {
    let (supports, more) = match railway.layout() {
        Layout::Continuous(stack) => return (stack.clone(), String::new()),
        Layout::Discrete(supports) => (supports, ""),
        Layout::Varying(sections) => (&sections[0].supports, "; the first of several sections"),
    };
    let mut members = vec![supports.rail];
    // the first one is the massless seat of the rail
    members.extend(supports.under.members().iter().skip(1).map(|m| m.times(1.0 / supports.spacing)));
    let links = supports.under.links().iter().map(|l| l.times(1.0 / supports.spacing)).collect();
    (Stack::new(members, links), format!(", on supports every {} m{more}", supports.spacing))
}

/// Members and links from the rail downward, per metre of track.
pub fn track_table(railway: &Railway) -> Option<ReportTable> {
    let (stack, supports) = layers(railway);
    let mut rows = Vec::new();
    for (i, one) in stack.members().iter().enumerate() {
        rows.push(member(member_name(&stack, i), one));
        rows.extend(stack.links().get(i).map(|one| link(link_name(&stack, i), one)));
    }
    let loss = format!("loss factor at {FREQUENCY} Hz [-]");
    let header = ["", "mass [kg/m]", "EI [MN m²]", "κGA [MN]", "static stiffness [MN/m²]", &loss];
    (!rows.is_empty()).then(|| ReportTable {
        title: format!("Track, per metre{supports}"),
        header: header.map(str::to_owned).to_vec(),
        rows,
    })
}
