//! What goes into `report.html`: answers, pictures, every input, the assumptions.

use super::track_table::track_table;
use super::verification::Verification;
use super::{Case, answers};
use crate::concern::Concern;
use crate::output::plot::Picture;
use crate::output::{Report, ReportTable};
use crate::rail::DecayRate;
use crate::railway::{Contact, Ground, Railway, Support};
use crate::soil::{Base, Material};
use crate::study::{ContactLaw, Irregularity, Outcome, Passage, Study};
use crate::track::{Layout, Section, Supports};

/// At most three decimals, no trailing zeros.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Layers, with damping ratios in per cent: half of the loss factors.
fn ground_table(railway: &Railway) -> Option<ReportTable> {
    let Ground { profile, names, .. } = railway.ground().ok()?;
    let named = |i: usize, otherwise: String| names.get(i).cloned().flatten().unwrap_or(otherwise);
    let mut depth = 0.0;
    let mut row = |name: String, thickness: Option<f64>, m: &Material| {
        let from = depth;
        depth += thickness.unwrap_or(0.0);
        vec![
            name,
            trimmed(from),
            thickness.map_or("∞".into(), trimmed),
            format!("{:.1}", m.c_s()),
            format!("{:.1}", m.c_p()),
            format!("{:.1}", m.rayleigh_speed()),
            format!("{:.3}", m.poisson()),
            format!("{:.0}", m.density()),
            // ξ = η/2
            format!("{:.2}", 50.0 * m.loss_factor()),
            format!("{:.2}", 50.0 * m.loss_factor_pressure()),
        ]
    };
    let mut rows: Vec<Vec<String>> = profile
        .layers()
        .iter()
        .enumerate()
        .map(|(i, l)| row(named(i, format!("layer {}", i + 1)), Some(l.thickness), &l.material))
        .collect();
    match profile.base() {
        Base::HalfSpace(material) => {
            rows.push(row(named(profile.layers().len(), "half-space".into()), None, &material));
        }
        Base::Rigid => {
            let mut cells = vec!["rigid base".to_owned()];
            cells.resize(10, String::new());
            rows.push(cells);
        }
    }
    Some(ReportTable {
        title: "Ground".into(),
        header: [
            "",
            "from [m]",
            "h [m]",
            "c_s [m/s]",
            "c_p [m/s]",
            "c_R [m/s]",
            "ν [-]",
            "ρ [kg/m³]",
            "ξ_s [%]",
            "ξ_p [%]",
        ]
        .map(str::to_owned)
        .to_vec(),
        rows,
    })
}

fn train_table(railway: &Railway) -> Option<ReportTable> {
    let train = railway.train().ok()?;
    Some(ReportTable {
        title: format!("Axle loads, {:.0} kN in all", 1e-3 * train.total_load()),
        header: ["axle", "behind the leading axle [m]", "load [kN]"].map(str::to_owned).to_vec(),
        rows: train
            .axles()
            .iter()
            .enumerate()
            .map(|(i, a)| {
                vec![
                    format!("{}", i + 1),
                    format!("{:.2}", a.position - train.axles()[0].position),
                    format!("{:.1}", 1e-3 * a.load),
                ]
            })
            .collect(),
    })
}

/// Where the fields are that are too long for a table.
fn maps_table(outcomes: &[(&'static str, Outcome)]) -> Option<ReportTable> {
    let mut rows = Vec::new();
    for (_, Outcome { group, .. }) in outcomes {
        rows.extend(group.maps().map(|map| {
            let over =
                map.dims.iter().zip(map.values.shape()).map(|(dimension, n)| format!("{dimension} ({n})"));
            let over = over.collect::<Vec<_>>().join(" × ");
            vec![format!("{}/{}", group.name, map.name), over, map.units.clone(), map.long_name.clone()]
        }));
    }
    let header = ["dataset", "over", "unit", "what"].map(str::to_owned).to_vec();
    (!rows.is_empty()).then_some(ReportTable { title: "Maps in results.h5".into(), header, rows })
}

/// What excites the railway: axle loads, a standing force, the roughness of the rail.
fn excitation(studies: &[Study]) -> Vec<String> {
    let mut list = Vec::new();
    let moving = |s: &Study| match s {
        Study::CriticalSpeed(_) | Study::Contour(_) | Study::GroundAtDepth(_) => true,
        Study::TrackResponse(study) => study.harmonic.is_none(),
        _ => false,
    };
    if studies.iter().any(moving) {
        list.push("Loads are constant axle loads moving at constant speed (quasi-static excitation); rail roughness and vehicle dynamics are not in critical speed, track response, contour and ground at depth.".to_owned());
    }
    for study in studies {
        match study {
            Study::CriticalSpeed(study) => list.extend(study.accuracy.map(|accuracy| {
                format!("Deflections of the speed curve are computed to {accuracy:e} of that under an axle, as asked.")
            })),
            Study::GroundAtDepth(_) => list.push("Stresses and strains at depth are those that the train adds, by exact layer matrices whatever the solver of the surface; tension and extension positive, shear strains as engineers count them (γ = 2ε). At an interface they are those just below it.".into()),
            Study::Receptance(_) => list.push("Receptances are per unit harmonic force e^{iωt} standing on the rail, on both rails alike unless the case says rails = 1.".into()),
            Study::TrackResponse(study) => list.extend(study.harmonic.map(|frequency| {
                format!("In the track response every axle load P moves at constant speed and oscillates, P cos ω̃t at {frequency} Hz, all of them together.")
            })),
            Study::DecayRate(study) => list.push(match study.definition {
                DecayRate::Floquet => "Decay rates are those of the free wave along the rail that decays least.".into(),
                DecayRate::ExactReceptance => "Decay rates are 4.343 |α(0)|²/∫|α|² dx of the rail's receptance ahead of the force.".into(),
                DecayRate::En15461 => "Decay rates are the sum over the grid of EN 15461, from receptances: not those of a free wave.".into(),
            }),
            Study::Transition(_) => list.push("Power at changes of track is that of the wave along the first section that decays least, over what it brings; what is lost in rail and supports comes nowhere.".into()),
            Study::Passage(study) => list.extend(passing(study)),
            Study::FreeField(study) => {
                list.push("The free field is vertical, unweighted, at the surface of the open ground: no building, no coupling loss. Third octaves are exact base-10 bands; the r.m.s. is over the passage time.".into());
                list.push(match &study.roughness {
                    Some(roughness) => format!(
                        "Quasi-static part: constant moving axle loads. Dynamic part: wheels and rails in linear contact ({} per wheelset), {} wheelsets with the bodies the case gives them; both rails have the same profile: {}.",
                        stiffnesses(&roughness.contact),
                        roughness.bodies.wheelset_count(),
                        roughness.irregularity.text(),
                    ),
                    None => "The rail is smooth: the quasi-static part of constant moving axle loads alone.".into(),
                });
                if let Some(solver) = study.sections {
                    list.push(format!(
                        "Across the track the ground of the free field is integrated on paths lifted off its poles; at frequencies at which they may not be taken it is solved by {}, as the case names no solver.",
                        solver.name()
                    ));
                }
                if let Some(Irregularity::Random { wavelengths: (from, to), seed, count, .. }) =
                    study.roughness.as_ref().map(|r| &r.irregularity)
                {
                    list.push(format!(
                        "Third octaves are the expected value over all profiles of the spectrum, wavelengths {from} to {to} m. Histories, KB, PPV, running r.m.s. and doses belong to {count} of these profiles (seeds from {seed}), each a sum of cosines with random phases; histories hold frequencies up to the end of the highest band."
                    ));
                }
            }
            _ => {}
        }
    }
    list
}

/// "k_H = 2.1e9 N/m", or from the least to the largest of different ones.
fn stiffnesses(contact: &[f64]) -> String {
    let least = contact.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = contact.iter().copied().fold(0.0, f64::max);
    match least == largest {
        true => format!("k_H = {least:.3e} N/m"),
        false => format!("k_H = {least:.3e} to {largest:.3e} N/m"),
    }
}

/// What a train meets that passes in time.
fn passing(study: &Passage) -> Vec<String> {
    let mut list = vec![format!(
        "The passage is marched in time over finite elements of one rail ({} in a bay), forces are those of one wheel; displacements are taken where wheels stand, what an element gives way under its wheel included.",
        study.elements_per_bay
    )];
    list.push(match &study.running {
        None => "Axle loads are constant.".to_owned(),
        Some(running) => {
            let law = match running.law {
                ContactLaw::NonLinear => "Hertz contact that lets go",
                ContactLaw::Linear => "linear contact that pulls where wheels would leave the rail",
            };
            let contact: Vec<f64> = running.contact.iter().map(|spring| spring.stiffness).collect();
            format!("{law}, {} per wheelset under the mean axle load of its vehicle.", stiffnesses(&contact))
        }
    });
    if let Some(irregularity) = study.running.as_ref().and_then(|running| running.irregularity.as_ref()) {
        list.push(format!("Wheels roll over: {}; its x = 0 is that of the track.", irregularity.text()));
    }
    list
}

/// What lies along the track.
fn along(layout: &Layout) -> String {
    match layout {
        Layout::Continuous(_) => {
            "Linear and uniform along the track: one profile, one track, no structures, no transition."
                .to_owned()
        }
        Layout::Discrete(Supports { spacing, width, .. }) => {
            let ground = match width {
                Some(width) => {
                    format!("sleepers press on {width} m of ground along the track each, which joins them")
                }
                None => "every support stands on springs of its own".to_owned(),
            };
            format!(
                "Linear; the rail on equal supports every {spacing} m, without end, each with {spacing} × the values per metre of track; {ground}. One profile, one track, no structures, no transition. x is measured from a support."
            )
        }
        Layout::Varying(sections) => {
            let one = |section: &Section| {
                let bays = section.bays.map_or("endless".to_owned(), |bays| format!("{bays} bays"));
                format!("{bays} of {} m", section.supports.spacing)
            };
            format!(
                "Linear; sections one after another ({}), every support with spacing × the values per metre of track, on springs of its own. Sections change in the middle between supports; x = 0 is where the first one ends.",
                sections.iter().map(one).collect::<Vec<_>>().join(", ")
            )
        }
    }
}

fn assumptions(railway: &Railway, studies: &[Study]) -> Vec<String> {
    let mut list = vec![
        along(railway.layout()),
        "Displacements are positive down, and measured from the unloaded state; x′ is the position relative to the leading axle, positive ahead.".to_owned(),
        "Track values are for the whole track, both rails, unless the case says rails = 1.".to_owned(),
    ];
    list.extend(excitation(studies));
    match railway.support() {
        Support::Ground(Ground { profile, solver, contact, .. }) => {
            list.push("Horizontally layered, isotropic ground with hysteretic damping M* = M (1 + iη sgn ω); small strains: if the computed strains are large, use strain-reduced moduli.".into());
            list.push(solver.method());
            if profile.is_undamped() {
                list.push("The ground is undamped.".into());
            }
            list.extend(contact.map(|contact| touching(contact, !railway.is_bare())));
        }
        Support::Springs(springs) => {
            list.push(format!("The track stands on {}: no waves in the ground.", springs.model().name()));
        }
    }
    list
}

/// How `contact` loads the ground, under a track or without one.
fn touching(contact: Contact, track: bool) -> String {
    match contact {
        Contact::Strip(strip) => format!(
            "{} presses on the ground evenly over 2b = {} m and follows the ground's {}.",
            if track { "The track" } else { "A load along the track, without one," },
            2.0 * strip.half_width,
            if contact.compatibility() == "mean" {
                "mean displacement over that width"
            } else {
                "displacement under the centre line"
            }
        ),
        Contact::Patch { half_length, strip } => format!(
            "Each axle presses evenly on {} m × {} m of ground, without a track.",
            2.0 * half_length,
            2.0 * strip.half_width
        ),
        Contact::Point => {
            "Each axle is a point load on the ground; the value under it is the mean over one grid cell."
                .into()
        }
    }
}

/// Every input: the case file, then each parameter set it names.
fn inputs(case: &Case) -> String {
    let mut text = case.text.trim_end().to_owned();
    for (name, set) in case.files.iter().filter(|(name, _)| name.ends_with(".toml")) {
        text += &format!("\n\n# ======== {name} ========\n\n{}", set.trim_end());
    }
    text
}

/// The report of a finished run.
pub fn report(
    case: &Case,
    outcomes: &[(&'static str, Outcome)],
    verification: Option<&Verification>,
    concerns: &[Concern],
    figures: Vec<(String, String, Picture)>,
) -> Report {
    Report {
        title: case.title.clone(),
        about: case.about.rows(),
        source: case.source.clone(),
        version: env!("CARGO_PKG_VERSION").into(),
        answers: answers::list(outcomes.iter().flat_map(|(_, o)| &o.answers)),
        figures,
        answer_tables: answers::tables(outcomes.iter().flat_map(|(_, o)| &o.answers)),
        tables: [
            ground_table(&case.railway),
            track_table(&case.railway),
            train_table(&case.railway),
            verification.map(Verification::table),
            maps_table(outcomes),
        ]
        .into_iter()
        .flatten()
        .collect(),
        case_text: inputs(case),
        assumptions: assumptions(&case.railway, &case.studies),
        concerns: concerns.to_vec(),
        references: case.references.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAIL: &str = "title = \"x\"\n[foundation]\nkind = \"rigid\"\n[receptance]\nfrequencies = [100.0]\n[track]\nkind = \"ballasted\"\nrails = 1\nrail.bending_stiffness = 6.38e6\nrail.mass = 60.23\npad.stiffness = 3.5e8\nsleeper.mass = 245.0\nballast.kind = \"spring\"\nballast.stiffness = 1.8e8\n";

    #[test]
    fn assumptions_are_those_of_the_track() {
        let supports = "support.spacing = 0.6\n";
        let sections = "[[track.section]]\n[[track.section]]\nlength = 3.0\n[[track.section]]\nballast.stiffness = 9e7\n";
        for (more, said, unsaid) in [
            (String::new(), "uniform along the track", "supports"),
            (supports.to_owned(), "equal supports every 0.6 m", "uniform"),
            (
                format!("{supports}{sections}"),
                "(endless of 0.6 m, 5 bays of 0.6 m, endless of 0.6 m)",
                "no transition",
            ),
        ] {
            let case = Case::parse(&format!("{RAIL}{more}"), "x", &|_| Err(String::new())).unwrap();
            let found = assumptions(&case.railway, &case.studies);
            assert!(found[0].contains(said) && !found[0].contains(unsaid), "{found:?}");
            assert!(found.iter().any(|line| line.contains("rails = 1")), "{found:?}");
        }
    }
}
