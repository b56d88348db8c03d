//! Trains of different vehicles, tracks of the library with other keys, and what the library holds against what was published.

mod common;

use common::cli::{LAYERS, case, flat, groundwave};
use groundwave::case::{Case, CaseError};
use groundwave::study::TrackResponse;
use groundwave::{Railway, Silent, Train};
use miette::Diagnostic;
use std::path::Path;

/// A beam on springs.
const TRACK: &str = "title = \"x\"\n[track]\nkind = \"beam\"\nbeam.bending_stiffness = 1.3e7\nbeam.mass = 400.0\n\
                     [foundation]\nkind = \"winkler\"\nstiffness = 8e7\n\
                     [track_response]\nspeeds = [60.0]\n";

fn parsed(text: &str) -> Case {
    Case::parse(text, "case.toml", &|_| Err("there is no such file".into()))
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn train(text: &str) -> Train {
    parsed(&format!("{TRACK}{text}")).railway.train().unwrap().clone()
}

fn faults(text: &str) -> Vec<CaseError> {
    Case::parse(text, "case.toml", &|_| Err("there is no such file".into())).unwrap_err().each()
}

const MIXED: &str = "[[train.vehicle]]\nname = \"froseth2018_locomotive_coco\"\n\
                     [[train.vehicle]]\nname = \"froseth2018_freight_wagon_empty\"\ncount = 2\n\
                     [[train.vehicle]]\nname = \"goicolea2014_ice3_end\"\nreversed = true\n";

/// Made up: bodies of 40 t on bogies of 5 t, wheelsets of 2 t.
const BODIES: &str = "[train]\nmodel = \"ten\"\nbody = { mass = 40e3, pitch_inertia = 1e6, bogie_centres = 18.0EXTRA }\n\
                      bogie = { mass = 5e3, pitch_inertia = 2e3, wheelbase = 3.0BOGIE }\nwheelset.mass = 2e3\n\
                      primary = { stiffness = 2e6, damping = 2e4 }\nsecondary = { stiffness = 7e5, damping = 4e4 }\n";

#[test]
fn six_axles_and_bodies_that_share_their_bogies() {
    let of = |body: &str, bogie: &str| BODIES.replace("EXTRA", body).replace("BOGIE", bogie);
    let axles = |text: &str| -> Vec<(f64, f64)> {
        train(text).axles().iter().map(|a| (a.position, a.load / 9.81e3)).collect()
    };
    let near = |found: &[(f64, f64)], wanted: &[(f64, f64)]| {
        assert_eq!(found.len(), wanted.len());
        assert!(
            found.iter().zip(wanted).all(|(a, b)| (a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-9),
            "{found:?}"
        );
    };
    // 40 + 2 · 5 + 6 · 2 = 62 t on six axles
    let sixth = 62.0 / 6.0;
    let places = [0.0, 1.5, 3.0, 18.0, 19.5, 21.0];
    near(&axles(&of("", ", wheelsets = 3")), &places.map(|x| (x, sixth)));
    // two bodies on three bogies: (20 + 5)/2 + 2, (40 + 5)/2 + 2 t
    let (end, middle) = (14.5, 24.5);
    let wanted = [(0.0, end), (3.0, end), (18.0, middle), (21.0, middle), (36.0, end), (39.0, end)];
    near(&axles(&of(", count = 2", "")), &wanted);
    for (body, bogie, key, said) in [
        (", count = 0", "", "body.count", "between 1 and 100"),
        ("", ", wheelsets = 4", "bogie.wheelsets", "between 2 and 3"),
    ] {
        let faults = faults(&format!("{TRACK}{}", of(body, bogie)));
        assert!(
            faults.iter().any(|f| f.to_string().contains(key) && f.to_string().contains(said)),
            "{faults:?}"
        );
    }
}

#[test]
fn vehicles_stand_where_their_lengths_put_them() {
    let mixed = train(MIXED);
    let mut wanted = vec![0.0, 1.8, 3.9, 11.8, 13.9, 15.7];
    // the locomotive is 20.9 m long, 2.6 m of them ahead of its first axle, a wagon 15.7 m with 1.6 m
    for wagon in [20.9 + 1.6 - 2.6, 20.9 + 15.7 + 1.6 - 2.6] {
        wanted.extend([0.0, 1.8, 10.7, 12.5].map(|place| wagon + place));
    }
    // the car of 25.835 m reaches 3.51 m beyond its bogie in front, which is behind here: 2.45 m
    let car = 20.9 + 31.4 + 2.45 - 2.6;
    wanted.extend([0.0, 2.5, 17.375, 19.875].map(|place| car + place));
    let places: Vec<f64> = mixed.axles().iter().map(|axle| axle.position).collect();
    assert_eq!(places.len(), wanted.len());
    // sums of lengths in another order
    assert!(places.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{places:?}");
    // two tractions, and the whole train the other way
    let twice = train(&format!("[train]\ncount = 2\n{MIXED}"));
    let length = 20.9 + 31.4 + 25.835;
    assert!((twice.axles()[18].position - length).abs() < 1e-12);
    let back = train(&format!("[train]\nreversed = true\n{MIXED}"));
    let last = mixed.axles().last().unwrap();
    for (a, b) in back.axles().iter().zip(mixed.axles().iter().rev()) {
        assert!((a.position - (last.position - b.position)).abs() < 1e-12 && a.load == b.load);
    }
    // the old form still means the same: axles repeated at the length
    let old = train("[train]\nvehicle = \"goicolea2014_ice3\"\ncount = 3\n");
    let new = train("[[train.vehicle]]\nname = \"goicolea2014_ice3\"\ncount = 3\n");
    for (a, b) in old.axles().iter().zip(new.axles()) {
        assert!((a.position - b.position).abs() < 1e-12 && a.load == b.load);
    }
}

#[test]
fn a_mixed_train_is_the_sum_of_its_vehicles() {
    let railway = parsed(&format!("{TRACK}{MIXED}")).railway;
    let axles = railway.train().unwrap().axles().to_vec();
    let (from, count) = (-100.0, 241);
    let reach = 100.0 + axles[axles.len() - 1].position;
    // the integrals of all of them reach as far
    let shape = |axles: &[groundwave::Axle], from: f64| {
        let train = Train::new(axles.to_vec()).unwrap();
        let x = Some((from, reach - train.length()));
        let alone = Railway::new(railway.support().clone(), railway.layout().clone(), Some(train)).unwrap();
        let study = TrackResponse { speeds: vec![60.0], x, spacing: Some(0.5), ..TrackResponse::default() };
        study.solve(&alone, &Silent).unwrap().rail.row(0).to_vec()[..count].to_vec()
    };
    let whole = shape(&axles, from);
    let mut sum = vec![0.0; whole.len()];
    for vehicle in [&axles[..6], &axles[6..10], &axles[10..14], &axles[14..]] {
        // x′ is counted from the leading axle
        let alone = shape(vehicle, from + vehicle[0].position);
        sum.iter_mut().zip(alone).for_each(|(sum, part)| *sum += part);
    }
    let most = whole.iter().fold(0.0f64, |most, u| most.max(u.abs()));
    let gap = whole.iter().zip(&sum).fold(0.0f64, |gap, (a, b)| gap.max((a - b).abs()));
    println!("mixed train against the sum of its vehicles: {:.1e} of {most:.2e} m", gap / most);
    assert!(most > 1e-4 && gap < 1e-12 * most, "{gap} {most}");
}

#[test]
fn unknown_and_impossible_vehicles_are_refused_at_their_keys() {
    for (text, key, said, help) in [
        (
            MIXED.replace("wagon_empty", "wagon_emtpy"),
            "train.vehicle[1].name",
            "no entry",
            "did you mean `froseth2018_freight_wagon_empty`?",
        ),
        (
            MIXED.replace("count = 2", "cuont = 2"),
            "train.vehicle[1].cuont",
            "unknown key",
            "did you mean `count`?",
        ),
        (MIXED.replace("count = 2", "count = 0"), "train.vehicle[1].count", "found 0", ""),
        (
            MIXED.replace("froseth2018_locomotive_coco", "lamprea2022_axle"),
            "train.vehicle[0].name",
            "no `length`",
            "add length",
        ),
        (
            MIXED.replace("count = 2", "length = 5.0"),
            "train.vehicle[1].length",
            "the axles reach",
            "it must hold them",
        ),
        (format!("[train]\nlength = 3.0\n{MIXED}"), "train.length", "beside a list of vehicles", "remove it"),
        (
            format!("[train]\naxles = [{{ position = 0, load = 1e5 }}]\n{MIXED}"),
            "train.vehicle",
            "both given",
            "one of them",
        ),
        (
            format!("[train]\nmodel = \"ten\"\n{MIXED}"),
            "train.vehicle[0].name",
            "has no bodies",
            "leave model out",
        ),
        (
            format!("[train]\nwheel_rail.radius = 0.46\n{MIXED}"),
            "train.vehicle[0].name",
            "have no mass",
            "unsprung_mass",
        ),
        ("[train]\nvehicle = []\n".into(), "train.vehicle", "the list is empty", "at least one"),
        ("[train]\nvehicle = 3\n".into(), "train.vehicle", "found the number 3", ""),
    ] {
        let faults = faults(&format!("{TRACK}{text}"));
        assert_eq!(faults.iter().map(CaseError::key).collect::<Vec<_>>(), [key], "{text} {faults:?}");
        let advice = faults[0].help().map_or(String::new(), |help| help.to_string());
        assert!(faults[0].to_string().contains(said) && advice.contains(help), "{} {advice}", faults[0]);
    }
}

#[test]
fn wheels_of_different_vehicles_run_over_a_rough_rail() {
    // wheelsets of 1500 kg where a vehicle says nothing else, contact of each under its own load
    let text = format!(
        "{}[train]\nunsprung_mass = 1500.0\nwheel_rail.radius = 0.46\n{MIXED}\
         [irregularity]\nkind = \"sinusoidal\"\nwavelength = 2.0\namplitude = 1e-4\n\
         [passage]\nspeed = 60.0\nfrom = 0.0\nto = 5.0\n",
        TRACK.split("[track_response]").next().unwrap()
    );
    let case = parsed(&text);
    let said = format!("{:?}", case.studies);
    assert!(said.contains("ContactSpring"), "{said}");
    let stiffness = |load: f64| {
        groundwave::vehicle::Hertz::new(groundwave::vehicle::Tread::Worn, 0.46)
            .unwrap()
            .wheelset_stiffness(load)
            .unwrap()
    };
    for load in [20.0 * 9.81e3, 5.6 * 9.81e3] {
        let spring = format!("ContactSpring {{ stiffness: {:?}, load: ", stiffness(load));
        assert!(said.contains(&spring[..45]), "{spring}");
    }
}

/// EN 1991-2:2003, Table 6.3: N, D [m], d [m], P [kN].
const TABLE_6_3: [(usize, f64, f64, f64); 10] = [
    (18, 18.0, 2.0, 170.0),
    (17, 19.0, 3.5, 200.0),
    (16, 20.0, 2.0, 180.0),
    (15, 21.0, 3.0, 190.0),
    (14, 22.0, 2.0, 170.0),
    (13, 23.0, 2.0, 180.0),
    (13, 24.0, 2.0, 190.0),
    (12, 25.0, 2.5, 190.0),
    (11, 26.0, 2.0, 210.0),
    (11, 27.0, 2.0, 210.0),
];

#[test]
fn universal_trains_are_those_of_the_table() {
    for (i, (coaches, length, wheelbase, load)) in TABLE_6_3.into_iter().enumerate() {
        let train = train(&format!("[train]\nvehicle = \"en1991_hslm_a{}\"\n", i + 1));
        let axles = train.axles();
        // two power cars of four axles, two end coaches of three, N coaches of two
        assert_eq!(axles.len(), 8 + 6 + 2 * coaches);
        assert!(axles.iter().all(|axle| axle.load == 1e3 * load));
        let gaps: Vec<f64> = axles.windows(2).map(|pair| pair[1].position - pair[0].position).collect();
        // the end coaches' D counts from the middle of the coupling of 3.525 m
        let end = length - 0.5 * 3.525 - 1.5 * wheelbase;
        let mut wanted = vec![3.0, 11.0, 3.0, 3.525, wheelbase, end];
        for _ in 0..coaches {
            wanted.extend([wheelbase, length - wheelbase]);
        }
        wanted.extend([wheelbase, end, wheelbase, 3.525, 3.0, 11.0, 3.0]);
        // decimals of the file
        assert!(gaps.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-9), "A{}: {gaps:?}", i + 1);
        assert_eq!(gaps.len(), wanted.len());
        // about 400 m long: A9 375.5 m, A2 398.5 m
        assert!((375.0..=400.0).contains(&train.length()), "{}", train.length());
    }
}

/// EN 1991-2:2003, annex D.3, as remembered, not as read: type, ΣQ [kN], L [m], and what of it reaches beyond the axles in front and
/// behind.
const ANNEX_D: [(usize, f64, f64, f64, f64); 12] = [
    (1, 6630.0, 262.10, 1.4, 1.8),
    (2, 5300.0, 281.10, 1.4, 2.5),
    (3, 9400.0, 385.52, 4.7, 4.7),
    (4, 5100.0, 237.60, 3.5, 3.5),
    (5, 21_600.0, 270.30, 2.0, 2.0),
    (6, 14_310.0, 333.10, 2.0, 1.8),
    (7, 10_350.0, 196.50, 1.4, 1.6),
    (8, 10_350.0, 212.50, 1.4, 2.1),
    (9, 2960.0, 134.80, 2.15, 2.15),
    (10, 3600.0, 129.60, 1.75, 1.75),
    (11, 11_350.0, 198.50, 1.4, 1.5),
    (12, 11_350.0, 212.50, 1.4, 2.1),
];

#[test]
fn fatigue_trains_are_as_heavy_and_as_long_as_printed() {
    for (number, load, length, front, rear) in ANNEX_D {
        let train = train(&format!("[train]\nvehicle = \"en1991_d{number}_train\"\n"));
        assert!((train.total_load() - 1e3 * load).abs() < 1e-6, "{number}: {}", train.total_load());
        let whole = front + train.length() + rear;
        assert!((whole - length).abs() < 1e-9, "{number}: {whole}");
    }
}

#[test]
fn a_library_track_may_have_other_keys() {
    let on_ground = |track: &str| {
        let rest = "[train]\naxles = [{ position = 0.0, load = 150e3 }]\n[track_response]\nspeeds = [50.0]\n";
        case(LAYERS, &format!("[track]\n{track}{rest}"))
    };
    let stack = |text: &str| parsed(text).railway.stack().unwrap().clone();
    let library = stack(&on_ground("library = \"lamprea2022_ballasted\"\n"));
    assert_eq!(
        library,
        stack(&format!("track = \"lamprea2022_ballasted\"\n{}", on_ground("").replace("[track]\n", "")))
    );
    // softer pads, another contact; the rest is that of the library
    let softer = stack(&on_ground("library = \"lamprea2022_ballasted\"\npad.stiffness = \"100 MN/m²\"\n"));
    assert_eq!(softer.members(), library.members());
    assert_eq!((softer.links()[0].stiffness(0.0).upper.re, softer.links()[1]), (1e8, library.links()[1]));
    // pads, sleepers and mats by the piece: two pads of 60 kN/mm and a sleeper of 300 kg every 0.6 m
    let pieces = "library = \"lamprea2022_ballasted\"\npad.piece.stiffness = \"60 kN/mm\"\nsleeper.piece.mass = \"300 kg\"\n\
                  sleeper.spacing = \"600 mm\"\nmat = { bedding_modulus = \"0.1 N/mm³\", width = \"3 m\" }\nrails = 2\nrail.section = \"54E1\"\n";
    let pieces = stack(&on_ground(pieces));
    assert!((pieces.links()[0].stiffness(0.0).upper.re / 2e8 - 1.0).abs() < 1e-12);
    assert!((pieces.links()[2].stiffness(0.0).upper.re / 3e8 - 1.0).abs() < 1e-12);
    let inertia = pieces.members()[1].stiffness(0.0.into(), 1.0);
    assert!((inertia.re + 500.0).abs() < 1e-9);
    for (track, key, said) in [
        ("library = \"lamprea2022_balasted\"\n", "track.library", "no entry"),
        ("library = 3\n", "track.library", "found 3"),
        ("library = \"lamprea2022_ballasted\"\nkind = \"slab\"\n", "track.kind", "is of kind"),
        ("library = \"lamprea2022_ballasted\"\npad.stifness = 1e8\n", "track.pad.stifness", "unknown key"),
        (
            "library = \"lamprea2022_ballasted\"\npad.stiffness = \"60 kN/mm\"\n",
            "track.pad.stiffness",
            "wanted a stiffness per metre",
        ),
        (
            "library = \"lamprea2022_ballasted\"\npad.piece.stiffness = 6e7\n",
            "track",
            "The spacing is missing",
        ),
        (
            "library = \"lamprea2022_ballasted\"\nsub_ballast = { kind = \"bars\", young = -1.0, height = 0.3, alpha = 0.5, density = 1800.0 }\n",
            "track.sub_ballast.young",
            "-1",
        ),
    ] {
        let faults = faults(&on_ground(track));
        assert_eq!(faults.iter().map(CaseError::key).collect::<Vec<_>>(), [key], "{faults:?}");
        assert!(faults[0].to_string().contains(said), "{}", faults[0]);
    }
}

#[test]
fn entries_are_shown_with_their_units() {
    let folder = tempfile::tempdir().unwrap();
    let show = |name: &str| groundwave(&["show", name], folder.path());
    let text = String::from_utf8(show("goicolea2014_ice3").stdout).unwrap();
    assert!(text.contains("train = \"goicolea2014_ice3\"") && text.contains("source: Goicolea"), "{text}");
    assert!(
        text.contains("body.mass = 47800.0 kg") && text.contains("4 axles of 152.1 kN (15.50 t)"),
        "{text}"
    );
    let wrong = show("goicolea2014_ice");
    assert_eq!(wrong.status.code(), Some(2));
    assert!(flat(&wrong.stderr).contains("did you mean `goicolea2014_ice3`?"), "{}", flat(&wrong.stderr));
    assert!(Path::new(env!("CARGO_BIN_EXE_groundwave")).exists());
}
