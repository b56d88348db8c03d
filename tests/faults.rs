//! Everything wrong with a case is said at once, in plain words, at its file, line and key.

mod common;

use common::cli::{LAYERS, TRACK, case, flat, groundwave};
use groundwave::case::{Case, CaseError};
use miette::Diagnostic;
use std::path::Path;
use toml::{Table, Value};

const ASKED: &str = "[track_response]\nspeeds = [50.0]\n";

/// The faults of `text`, one by one, with no file beside it.
fn faults(text: &str) -> Vec<CaseError> {
    match Case::parse(text, "case.toml", &|_| Err("there is no such file".to_owned())) {
        Ok(_) => Vec::new(),
        Err(error) => error.each(),
    }
}

/// Their keys.
fn keys(text: &str) -> Vec<String> {
    faults(text).iter().map(|fault| fault.key().to_owned()).collect()
}

#[test]
fn all_faults_of_a_case_are_said_at_once_in_the_order_of_their_lines() {
    let text = r#"title = "many faults"
[soil]
solver.kind = "direct-stifness"
[[soil.layer]]
thickness = "2.0"
yuong = 60e6
poisson = 0.35
density = 1500.0
loss_factor = 0.06
[[soil.layer]]
thickness = 3
density = [1500.0]
los_factor = 0.06
[soil.half_space]
young = 200e6
poisson = 0.35
density = 1.8
loss_factor = 0.06
[trak]
kind = "ballasted"
[train]
axles = [{ position = 0.0, load = 15e3 }, { position = "3", lod = 2 }]
count = 2.5
[critical_speed]
speeds = { from = "10 mph", to = 200.0, step = 2.0 }
[track_response]
speeds = 68.5
[contour]
speeds = [137.0]
x = { from = -40.0, to = 20.0 }
y = { from = -30.0, to = -30.0 }
spacing = 0.25
"#;
    let wanted = [
        "soil.solver.kind",
        "soil.layer[0].thickness",
        "soil.layer[0].yuong",
        "soil.layer[1].density",
        "soil.layer[1].los_factor",
        "soil.half_space.density",
        "trak",
        "train.axles[1].position",
        "train.axles[1].lod",
        "train.count",
        "critical_speed.speeds.from",
        "track_response.speeds",
        "contour.y",
    ];
    assert_eq!(keys(text), wanted);
    let whole = Case::parse(text, "case.toml", &|_| Err(String::new())).unwrap_err().to_string();
    assert!(whole.starts_with("13 faults:") && whole.lines().count() == 14, "{whole}");
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let check = groundwave(&["check", "case.toml"], folder.path());
    let said = flat(&check.stderr);
    assert_eq!(check.status.code(), Some(2));
    assert!(said.contains("[case.toml:3:15]") && said.contains("[case.toml:31:5]"), "{said}");
    assert!(said.ends_with("13 faults"), "{said}");
}

#[test]
fn values_that_cannot_be_are_said_at_once() {
    let soil = LAYERS.replace("young = 60e6", "young = -60e6").replace("1800.0", "1.8");
    let track = TRACK.replace("mass = 2000.0", "mass = -1.0").replace("0.0, load", "nan, load");
    let rest = "[critical_speed]\nspeeds = [20.0, 10.0]\n[contour]\nspeeds = [10.0]\nx = { from = 0.0, to = 1.0 }\n\
                y = { from = 0.0, to = 1.0 }\nspacing = 0.0\n";
    let found = keys(&case(&soil, &format!("{track}{rest}")));
    let wanted = [
        "soil.layer[0].young",
        "soil.half_space.density",
        "track.beam.mass",
        "train.axles[0].position",
        "critical_speed.speeds[1]",
        "contour.spacing",
    ];
    assert_eq!(found, wanted);
}

#[test]
fn one_mistake_is_one_fault() {
    let good = case(LAYERS, &format!("{TRACK}{ASKED}"));
    assert_eq!(keys(&good), Vec::<String>::new());
    for (from, to, key) in [
        ("[track]", "[trakc]", "trakc"),
        ("[train]", "[trian]", "trian"),
        ("[track_response]", "[track_respons]", "track_respons"),
        ("density = 1500.0", "densty = 1500.0", "soil.layer[0].densty"),
        ("density = 1500.0", "density = 1.5", "soil.layer[0].density"),
        ("title = ", "titel = ", "titel"),
        ("\"beam\"", "\"bean\"", "track.kind"),
        ("load = 150e3", "load = \"150e3\"", "train.axles[0].load"),
        ("load = 150e3", "lod = 150e3", "train.axles[0].lod"),
        ("bending_stiffness = 1.0e8", "bending = 1.0e8", "track.beam.bending"),
        ("bending_stiffness = 1.0e8", "bending_stiffness = -1.0e8", "track.beam.bending_stiffness"),
        ("half_width = 1.25", "half_width = -1.25", "track.contact.half_width"),
        ("\"centre\"", "\"center\"", "track.contact.compatibility"),
        ("young = 60e6", "young = nan", "soil.layer[0].young"),
        ("poisson = 0.35\n", "", "soil.layer[0]"),
    ] {
        assert_eq!(keys(&good.replacen(from, to, 1)), [key], "{to}");
    }
    let none: Vec<String> = faults("").iter().map(ToString::to_string).collect();
    assert_eq!(
        none,
        [
            "case.toml: missing key `title`",
            "case.toml: the case has no ground",
            "case.toml: the case asks for nothing"
        ]
    );
}

/// Paths of every value under `value`, as steps.
fn places(value: &Value, at: &[Step], found: &mut Vec<Vec<Step>>) {
    let mut below = |value: &Value, step: Step| {
        let at = [at, &[step]].concat();
        found.push(at.clone());
        places(value, &at, found);
    };
    match value {
        Value::Table(table) => table.iter().for_each(|(key, value)| below(value, Step::Key(key.clone()))),
        Value::Array(list) => list.iter().enumerate().for_each(|(i, value)| below(value, Step::Place(i))),
        _ => {}
    }
}

#[derive(Clone)]
enum Step {
    Key(String),
    Place(usize),
}

/// `value` with `new` at the place `at`.
fn replaced(value: &Value, at: &[Step], new: &Value) -> Value {
    let Some((step, rest)) = at.split_first() else { return new.clone() };
    let mut value = value.clone();
    match (&mut value, step) {
        (Value::Table(table), Step::Key(key)) => {
            let inner = replaced(&table[key], rest, new);
            table.insert(key.clone(), inner);
        }
        (Value::Array(list), Step::Place(i)) => list[*i] = replaced(&list[*i], rest, new),
        _ => unreachable!(),
    }
    value
}

/// Words of the machine, which no engineer should have to read.
const JARGON: &[&str] = &[
    "f64",
    "f32",
    "usize",
    "u8",
    "u32",
    "u64",
    "i64",
    "integer",
    "float",
    "boolean",
    "sequence",
    "struct",
    "expected ",
    "invalid type",
    "invalid value",
    "variant",
    "unknown field",
    "missing field",
    "serde",
    "toml::",
    "None",
    "Some(",
    "os error",
];

#[test]
fn wrong_values_anywhere_are_said_in_plain_words() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("soil_cases");
    let mut texts: Vec<String> = [
        "lamprea2022_ballasted/case.toml",
        "library/tracks/lamprea2022_ballasted.toml",
        "library/soils/lamprea2022_layered.toml",
        "library/vehicles/goicolea2014_ice3.toml",
    ]
    .iter()
    .map(|name| std::fs::read_to_string(folder.join(name)).unwrap())
    .collect();
    // what stands for a table, in a case that names it
    let case_of = |text: &str, key: &str| {
        let table: Table = text.parse().unwrap();
        let mut whole: Table = case(LAYERS, &format!("{TRACK}{ASKED}")).parse().unwrap();
        whole.insert(key.to_owned(), table.into());
        toml::to_string(&whole).unwrap()
    };
    texts[1] = case_of(&texts[1], "track");
    texts[2] = case_of(&texts[2], "soil");
    texts[3] = case_of(&texts[3], "train");
    texts.push(groundwave::case::TEMPLATE.to_owned());
    texts.push(case(LAYERS, &format!("{TRACK}{ASKED}[irregularity]\nkind = \"german\"\nquality = \"low\"\nprofiles = 3\n[free_field]\nspeed = 50\nreceivers = [8]\npassage_time = 1\n")));
    let wrong =
        r#"v = ["nonsense", "1.0", -7, 3.25, inf, true, 1979-05-27, [], ["a"], [[1]], {}, { x = 1 }]"#;
    let wrong: Table = wrong.parse().unwrap();
    let mut count = 0;
    for text in texts {
        let whole = Value::Table(text.parse().unwrap());
        let mut at = Vec::new();
        places(&whole, &[], &mut at);
        for (place, new) in
            at.iter().flat_map(|at| wrong["v"].as_array().unwrap().iter().map(move |v| (at, v)))
        {
            let text = toml::to_string(&replaced(&whole, place, new)).unwrap();
            for fault in faults(&text) {
                let said =
                    format!("{fault}; {}", fault.help().map_or(String::new(), |help| help.to_string()));
                for word in JARGON {
                    assert!(!said.contains(word), "{said} ({word})\n{text}");
                }
                count += 1;
            }
        }
    }
    assert!(count > 1000, "{count}");
}

#[test]
fn a_file_beside_the_case_may_stand_for_a_table_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let load = || Case::load(&folder.path().join("case.toml"));
    let said = || load().unwrap_err().to_string();
    write("case.toml", format!("title = \"x\"\nsoil = \"clay\"\n{TRACK}{ASKED}").as_bytes());
    let missing = said();
    assert!(missing.contains("soil: the library has no entry \"clay\" among its soils"), "{missing}");
    assert!(missing.contains("clay.toml beside the case: there is no such file"), "{missing}");
    write("clay.toml", format!("title = \"Clay\"\n{}", LAYERS.replace("soil.", "")).as_bytes());
    assert_eq!(load().unwrap().files.keys().collect::<Vec<_>>(), ["clay.toml"]);
    write(
        "clay.toml",
        format!("title = \"Clay\"\n{}", LAYERS.replace("soil.", "").replace("poisson", "poison")).as_bytes(),
    );
    let both: Vec<String> = load().unwrap_err().each().iter().map(|f| f.key().to_owned()).collect();
    assert_eq!(both, ["layer[0].poison", "half_space.poison"]);
}

#[test]
fn files_that_are_not_utf_8_are_named_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let said = || Case::load(&path).unwrap_err().to_string();
    write("case.toml", b"# first\ntitle = \"Gel\xe4nde\"\n");
    assert!(said().contains("line 2 is not UTF-8 text (byte E4): save the file as UTF-8"), "{}", said());
    write("case.toml", b"\xff\xfet\0i\0");
    assert!(said().contains("it is UTF-16 text: save it as UTF-8"), "{}", said());
    write("case.toml", format!("title = \"x\"\nsoil = \"clay.toml\"\n{TRACK}{ASKED}").as_bytes());
    write("clay.toml", b"title = \"Ton, wei\xdf\"\n");
    assert!(said().contains("soil: cannot read \"clay.toml\": line 1 is not UTF-8 text"), "{}", said());
    let record = "[[track_response.measured]]\nspeed = 50.0\nfile = \"r.csv\"\nlabel = \"measured\"\n";
    write("case.toml", case(LAYERS, &format!("{TRACK}{ASKED}{record}")).as_bytes());
    write("r.csv", b"x [m];Durchbiegung [\xb5m]\n0;1\n");
    assert!(said().contains("measured[0].file: cannot read \"r.csv\": line 1 is not UTF-8"), "{}", said());
}

/// What a case holds, as far as it can be told from another.
fn held(text: &str) -> String {
    let case = Case::parse(text, "case.toml", &|_| Err(String::new()));
    let case = case.unwrap_or_else(|error| panic!("{error}\n{text}"));
    format!("{:?} {:?}", case.railway, case.studies)
}

#[test]
fn numbers_may_stand_with_their_units() {
    let plain = case(LAYERS, &format!("{TRACK}{ASKED}"));
    let mut with_units = plain.clone();
    for (from, to) in [
        ("thickness = 2.0", "thickness = \"200 cm\""),
        ("young = 60e6", "young = \"60 MPa\""),
        ("density = 1500.0", "density = \"1.5 t/m3\""),
        ("loss_factor = 0.06", "loss_factor = \"6 %\""),
        ("bending_stiffness = 1.0e8", "bending_stiffness = \"100 MN m²\""),
        ("mass = 2000.0", "mass = \"2 t/m\""),
        ("half_width = 1.25", "half_width = \"1250 mm\""),
        ("load = 150e3", "load = \"150 kN\""),
        ("speeds = [50.0]", "speeds = [\"180 km/h\"]"),
    ] {
        assert!(with_units.contains(from), "{from}");
        with_units = with_units.replace(from, to);
    }
    assert_eq!(held(&with_units), held(&plain));
    // in a range, in a section, in a file beside the case
    let range = |from, to, step| {
        format!("[critical_speed]\nspeeds = {{ from = {from}, to = {to}, step = {step} }}\n")
    };
    let asked = |text: String| held(&case(LAYERS, &format!("{TRACK}{text}")));
    assert_eq!(asked(range("\"36 km/h\"", "\"30 m/s\"", "\"18 km/h\"")), asked(range("10.0", "30.0", "5.0")));
    let soft = |k: &str, length: &str| {
        let sections = format!(
            "support.spacing = 0.6\n[[track.section]]\n[[track.section]]\npad.stiffness = {k}\nlength = {length}\n[[track.section]]"
        );
        held(&on_springs(&format!("{SECTION}{sections}"), ROCK))
    };
    assert_eq!(soft("\"100 MN/m²\"", "\"6000 mm\""), soft("1e8", "6.0"));
    let clay = format!("title = \"Clay\"\n{}", LAYERS.replace("soil.", "").replace("60e6", "\"60 MPa\""));
    let open = |_: &str| Ok(clay.clone());
    let named = format!("title = \"x\"\nsoil = \"clay.toml\"\n{TRACK}{ASKED}");
    assert!(Case::parse(&named, "case.toml", &open).is_ok());
}

#[test]
fn units_of_something_else_are_refused_at_their_key() {
    let good = case(LAYERS, &format!("{TRACK}{ASKED}"));
    for (from, to, key, said) in [
        ("load = 150e3", "load = \"150 km/h\"", "train.axles[0].load", "a speed, wanted a force in N"),
        ("young = 60e6", "young = \"60 kN\"", "soil.layer[0].young", "a force, wanted a modulus in Pa"),
        ("young = 60e6", "young = \"60 Mpa\"", "soil.layer[0].young", "unknown unit `Mpa`"),
        (
            "poisson = 0.35",
            "poisson = \"0.35 m\"",
            "soil.layer[0].poisson",
            "a length, wanted a plain number",
        ),
        ("[50.0]", "[50.0, \"30 m\"]", "track_response.speeds[1]", "a length, wanted a speed in m/s"),
        ("mass = 2000.0", "mass = \"2000 kg\"", "track.beam.mass", "a mass, wanted a mass per metre in kg/m"),
        // read, and out of its range
        ("half_width = 1.25", "half_width = \"-1 mm\"", "track.contact.half_width", "-0.001 m"),
        ("density = 1500.0", "density = \"1.5 kg/m³\"", "soil.layer[0].density", "did you mean 1.5 t/m³"),
    ] {
        let faults = faults(&good.replacen(from, to, 1));
        assert_eq!(faults.iter().map(CaseError::key).collect::<Vec<_>>(), [key], "{to}");
        let help = faults[0].help().map_or(String::new(), |help| help.to_string());
        assert!(format!("{} {help}", faults[0]).contains(said), "{} {help}", faults[0]);
    }
    let help = faults(&good.replace("load = 150e3", "load = \"150 m\""))[0].help().unwrap().to_string();
    assert_eq!(help, "allowed: N, kN, MN, t");
}

#[test]
fn water_is_not_modelled() {
    let sea = "[[soil.layer]]\nthickness = 5.0\nshear_speed = 0\npressure_speed = 1480.0\ndensity = 1000.0\nloss_factor = 0.01\n";
    let faults = faults(&case(&format!("{sea}{LAYERS}"), &format!("{TRACK}{ASKED}")));
    assert_eq!(faults.len(), 1);
    assert_eq!(faults[0].key(), "soil.layer[0].shear_speed");
    assert!(faults[0].help().unwrap().to_string().contains("water is not modelled"));
}

#[test]
fn decimal_commas_and_brackets_are_explained() {
    let help = |text: &str| faults(text)[0].help().unwrap().to_string();
    let good = case(LAYERS, &format!("{TRACK}{ASKED}"));
    assert!(help(&good.replace("poisson = 0.35", "poisson = 0,35")).contains("decimals have a point"));
    assert!(help(&good.replace("[[soil.layer]]", "[soil.layer]")).contains("with [[name]] above each"));
    assert!(
        help(&good.replace("[soil.half_space]", "[[soil.half_space]]"))
            .contains("[name], in single brackets")
    );
}

/// A track on a foundation, with `track` and `foundation` as their keys say.
fn on_springs(track: &str, foundation: &str) -> String {
    format!(
        "title = \"x\"\n[track]\n{track}\n[foundation]\n{foundation}\n[receptance]\nfrequencies = [10.0]\n"
    )
}

const SECTION: &str = "kind = \"ballasted\"\nrails = 1\nrail.section = \"60E1\"\npad.stiffness = 3.5e8\npad.loss_factor = 0.15\n\
                       sleeper.mass = 245.0\nballast.kind = \"spring\"\nballast.stiffness = 1.8e8\nballast.loss_factor = 1.0\n";
const ROCK: &str = "kind = \"rigid\"";
const ZENER: &str = "{ kind = \"zener\", stiffness = 3e8, second_stiffness = 2e8, damping = 3e5 }";

#[test]
fn elements_sections_and_rock_are_read() {
    use groundwave::track::{Element, Link, RailSection};
    let stack = |text: &str| {
        let case = Case::parse(text, "case.toml", &|_| Err(String::new()));
        let case = case.unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(case.concerns.is_empty(), "{:?}", case.concerns);
        case.railway.stack().unwrap().clone()
    };
    let one = stack(&on_springs(SECTION, ROCK));
    assert_eq!(one.members()[0], RailSection::E60.rail(0.0).unwrap());
    assert_eq!(one.links()[1], Link::spring(1.8e8, 0.0, 1.0).unwrap());
    let two = stack(&on_springs(&SECTION.replace("rails = 1", "rails = 2"), ROCK));
    assert_eq!(two.members()[0], RailSection::E60.rail(0.0).unwrap().times(2.0));
    let zener = Element::Zener { stiffness: 3e8, second_stiffness: 2e8, damping: 3e5 };
    let pads =
        SECTION.replace("pad.stiffness = 3.5e8\npad.loss_factor = 0.15", &format!("pad.element = {ZENER}"));
    assert_eq!(stack(&on_springs(&pads, ROCK)).links()[0], Link::Element(zener));
    // three layers, and an element under each foundation
    let block =
        SECTION.replace("\"spring\"", "\"block\"").replace("rails = 1", "rails = 1\nballast.mass = 848.0");
    for (kind, more) in [
        ("winkler", ""),
        ("filonenko-borodich", "tension = 2e7"),
        ("hetenyi", "bending_stiffness = 1.5e6"),
        ("pasternak", "shear = 3e7"),
        ("kerr", "shear = 3e7\nupper_stiffness = 9e8"),
    ] {
        let foundation = format!("kind = \"{kind}\"\nelement = {ZENER}\n{more}");
        assert_eq!(stack(&on_springs(&block, &foundation)).members().len(), 3, "{kind}");
    }
}

#[test]
fn elements_sections_and_rock_are_refused_at_their_keys() {
    let winkler = "kind = \"winkler\"\nstiffness = 1.2e8";
    let beam = "kind = \"beam\"\nbeam.section = \"54E1\"\nrails = 2";
    let element = |element: &str| on_springs(beam, &format!("kind = \"winkler\"\nelement = {element}"));
    let pad = |pad: &str| on_springs(&SECTION.replace("pad.stiffness = 3.5e8", pad), ROCK);
    for (text, key, said) in [
        (on_springs(beam, "kind = \"winkler\""), "foundation", "missing key `stiffness`"),
        (
            on_springs(beam, "kind = \"kerr\"\nshear = 1e7\nupper_stiffness = 1e9"),
            "foundation",
            "`stiffness`",
        ),
        (on_springs(beam, "kind = \"winkler\"\nstifness = 1e8"), "foundation.stifness", "unknown key"),
        (on_springs(beam, "kind = \"winkler\"\nstiffness = -1e8"), "foundation.stiffness", "-100000000 N/m²"),
        (element("{ kind = \"zenner\", stiffness = 1e8 }"), "foundation.element.kind", "unknown value"),
        (
            element("{ kind = \"zener\", stiffness = 1e8, damping = 1e5 }"),
            "foundation.element",
            "`second_stiffness`",
        ),
        (
            element("{ kind = \"maxwell\", stiffness = 1e8, damping = 0.0 }"),
            "foundation.element.damping",
            "above zero",
        ),
        (element(&format!("{ZENER}\ndamping = 1e5")), "foundation.element", "remove"),
        (pad(&format!("pad.element = {ZENER}")), "track.pad.element", "remove"),
        (on_springs(beam, ROCK), "foundation.kind", "lies on rock"),
        (
            on_springs(&SECTION.replace("\"spring\"", "\"block\"\nballast.mass = 9e2"), ROCK),
            "foundation.kind",
            "rock",
        ),
        (on_springs(&beam.replace("54E1", "54E9"), winkler), "track.beam.section", "54E1"),
        (on_springs(&beam.replace("rails = 2", ""), winkler), "track", "number of rails"),
        (on_springs(&beam.replace("rails = 2", "rails = 3"), winkler), "track.rails", "3 rails"),
        (on_springs(&format!("{beam}\nbeam.mass = 54.0"), winkler), "track.beam.section", "remove"),
        (on_springs("kind = \"beam\"\nbeam.mass = 54.0", winkler), "track.beam", "`bending_stiffness`"),
    ] {
        let found = faults(&text);
        assert_eq!(found.len(), 1, "{found:?}\n{text}");
        assert_eq!(found[0].key(), key, "{found:?}");
        let help = found[0].help().map_or(String::new(), |help| help.to_string());
        assert!(format!("{} {help}", found[0]).contains(said), "{found:?}");
    }
}

#[test]
fn an_element_that_creeps_bears_no_constant_load() {
    let maxwell = "kind = \"winkler\"\nelement = { kind = \"maxwell\", stiffness = 1e8, damping = 1e6 }";
    let text = on_springs("kind = \"beam\"\nbeam.section = \"54E1\"\nrails = 2", maxwell);
    // shaken it answers
    assert!(faults(&text).is_empty(), "{:?}", faults(&text));
    let moving =
        text + "[track_response]\nspeeds = [0.0, 50.0]\n[train]\naxles = [{ position = 0.0, load = 1e5 }]\n";
    let found = faults(&moving);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].key() == "track_response" && found[0].to_string().contains("\"maxwell\" gives way"),
        "{found:?}"
    );
}

/// Why supports, methods and springs that give way are refused before anything is computed.
#[test]
fn rails_are_asked_only_by_methods_that_know_them() {
    let rail = "[track]\nkind = \"ballasted\"\nrails = 1\nrail.bending_stiffness = 6.38e6\nrail.mass = 60.23\nsleeper.mass = 245.0\nballast.kind = \"spring\"\nballast.stiffness = 1.8e8\nballast.loss_factor = 1.0\n";
    let pad = "pad.stiffness = 3.5e8\npad.loss_factor = 0.15\n";
    let lasting = "pad.element = { kind = \"maxwell\", stiffness = 3.5e8, damping = 1.92e4 }\n";
    let head = format!("title = \"x\"\n[foundation]\nkind = \"rigid\"\n{rail}");
    let sleepers = format!("{head}{pad}support.spacing = 0.6\n");
    let train = "[train]\naxles = [{ position = 0.0, load = 150e3 }]\n";
    let rates = "[decay_rate]\nfrequencies = [100.0]\n";
    let asked = "[receptance]\nfrequencies = [100.0]\n";
    for (text, key, said) in [
        (format!("{sleepers}{asked}verify = \"fourier\"\n"), "receptance.verify", "floquet, dirac-comb"),
        (format!("{sleepers}{asked}verify = \"floquet\"\n"), "receptance.verify", "verify with another"),
        (format!("{sleepers}{rates}verify = \"fourier\"\n"), "decay_rate.verify", "floquet, dirac-comb"),
        (format!("{sleepers}{rates}verify = \"floquet\"\n"), "decay_rate.verify", "verify with another"),
        (
            format!("{sleepers}{rates}verify = \"dirac-comb\"\n"),
            "decay_rate.verify",
            "methods that do: floquet",
        ),
        (
            format!("{sleepers}{rates}method = \"en15461\"\nverify = \"filon\"\n"),
            "decay_rate.verify",
            "dirac-comb",
        ),
        (format!("{sleepers}{asked}method = \"filon\"\n"), "receptance.method", "floquet, dirac-comb"),
        (format!("{sleepers}{asked}from = 1e6\n"), "receptance.from", "within 10 km"),
        (
            format!("{sleepers}{train}[track_response]\nspeeds = [20.0]\nmethod = \"residues\"\n"),
            "track_response.method",
            "methods that do: dirac-comb",
        ),
        (
            format!("{sleepers}{train}[track_response]\nspeeds = [20.0]\nverify = \"fourier\"\n"),
            "track_response.verify",
            "moving-green",
        ),
        (format!("{sleepers}{train}[track_response]\nspeeds = [0.0]\n"), "track_response.speeds", "at rest"),
        (format!("{sleepers}[transition]\nfrequencies = [100.0]\n"), "transition", "[[track.section]]"),
        (
            format!("{head}{lasting}{train}[critical_speed]\nspeeds = [20.0, 40.0]\n"),
            "critical_speed",
            "maxwell",
        ),
        (format!("{head}{lasting}{train}[track_response]\nspeeds = [0.0]\n"), "track_response", "maxwell"),
    ] {
        let found = faults(&text);
        let [fault] = &found[..] else { panic!("{text}: {found:?}") };
        assert!(fault.key() == key && fault.to_string().contains(said), "{key}: {fault}");
    }
    // what is asked of them is answered
    for fine in [
        format!("{sleepers}{asked}verify = \"transfer-matrix\"\n"),
        format!("{sleepers}{rates}method = \"en15461\"\nverify = \"dirac-comb\"\n"),
    ] {
        let found = faults(&fine);
        assert!(found.is_empty(), "{fine}: {found:?}");
    }
}

#[test]
fn line_speeds_depths_shapes_and_heads_are_refused_at_their_keys() {
    let asked = "[critical_speed]\nspeeds = [50.0, 60.0]\n";
    let depth = |more: &str| format!("[ground_at_depth]\n{more}");
    let shapes = |more: &str| format!("[dispersion]\nfrequencies = [10.0]\n[dispersion.shapes]\n{more}");
    for (studies, key, said) in [
        (format!("{asked}line_speed = 0.0\n"), "critical_speed.line_speed", "above 0"),
        (format!("{asked}line_speed = 250.0e3\n"), "critical_speed.line_speed", "250 km/h"),
        (format!("{asked}line_sped = 60.0\n"), "critical_speed.line_sped", "did you mean `line_speed`?"),
        (format!("{ASKED}line_speed = -1.0\n"), "track_response.line_speed", "-1 m/s"),
        (depth("z = [0.0, 1.0]\n"), "ground_at_depth.z", "the surface itself"),
        (depth("z = [2.0, 1.0]\n"), "ground_at_depth.z[1]", "ascend"),
        (depth("z = [1.0, 1500.0]\n"), "ground_at_depth.z", "200 m"),
        (depth("speeds = [50.0]\n"), "ground_at_depth", "missing key `z`"),
        (depth("z = [1.0]\ny = [0.0, 900.0]\n"), "ground_at_depth.y[1]", "within 500 m"),
        (depth("z = [1.0]\nspacing = 0.0\n"), "ground_at_depth.spacing", "above zero"),
        (depth("z = [1.0]\nthreshold_strain = 2.0\n"), "ground_at_depth.threshold_strain", "1e-4"),
        (
            depth("z = [1.0]\nx = { from = -400.0, to = 400.0 }\nspacing = 1e-4\n"),
            "ground_at_depth",
            "larger spacing",
        ),
        (shapes("z = [0.0]\n"), "dispersion.shapes", "missing key `frequencies`"),
        (shapes("frequencies = [5.0, 5.0]\nz = [0.0]\n"), "dispersion.shapes.frequencies[1]", "5 follows 5"),
        (shapes("frequencies = [5.0]\nz = [-1.0]\n"), "dispersion.shapes.z[0]", "-1 m"),
        (format!("{asked}[report]\nclient = \" \"\n"), "report.client", "empty"),
        (format!("{asked}[report]\nauthor = \"a\\nb\"\n"), "report.author", "single line"),
        (format!("{asked}[report]\nauthour = \"a\"\n"), "report.authour", "did you mean `author`?"),
    ] {
        let found = faults(&case(LAYERS, &format!("{TRACK}{studies}")));
        assert_eq!(found.iter().map(CaseError::key).collect::<Vec<_>>(), [key], "{studies}{found:?}");
        let help = found[0].help().map_or(String::new(), |help| help.to_string());
        assert!(format!("{} {help}", found[0]).contains(said), "{said}: {} {help}", found[0]);
    }
}
