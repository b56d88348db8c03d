//! A case file as the page holds it: layers by their wave speeds; track and train by name, or word for word.

use crate::reply::failed;
use groundwave::case::{Case, Tables};
use groundwave::study::Study;
use groundwave::{Base, Ground, Material};
use serde_json::{Value, json};

/// Keys of a case that the page takes; of studies it takes the speeds.
const TAKEN: [&str; 9] = [
    "title",
    "source",
    "soil",
    "track",
    "train",
    "critical_speed",
    "dispersion",
    "track_response",
    "contour",
];

/// What stands in `case`, and which of its tables the page has no place for.
pub fn told(case: &Case) -> Value {
    let Ok(file) = case.text.parse::<toml::Table>() else { return failed("the file is no TOML") };
    let ground = match case.railway.ground() {
        Ok(ground) => ground,
        Err(_) => {
            return failed(
                "the page knows layered ground, [soil], not [foundation]: run this case with the command",
            );
        }
    };
    let part = |key: &str| match file.get(key) {
        Some(toml::Value::String(name)) => json!({ "name": name }),
        Some(table) => {
            json!({ "toml": toml::Table::from_iter([(key.to_owned(), table.clone())]).to_string() })
        }
        None => Value::Null,
    };
    for key in ["track", "train"] {
        if !file.contains_key(key) {
            return failed(&format!("the page needs a {key}, and this case has none: add [{key}]"));
        }
    }
    let left = file.keys().filter(|key| !TAKEN.contains(&key.as_str())).cloned();
    let solver = file["soil"].as_table().filter(|soil| soil.contains_key("solver"));
    let left = left.chain(solver.map(|_| "soil.solver".to_owned()));
    let apart = ground.profile.materials().any(|m| m.loss_factor_pressure() != m.loss_factor());
    let left: Vec<String> =
        left.chain(apart.then(|| "the loss factors of pressure waves".to_owned())).collect();
    let (speeds, speed) = speeds(case);
    json!({
        "title": case.title, "source": case.source,
        "soil": ground_of(ground), "track": part("track"), "train": part("train"),
        "speeds": speeds, "speed": speed, "left": left,
    })
}

/// First and last speed [m/s] of the speed curve, and the speed [m/s] of rail shapes or contours.
fn speeds(case: &Case) -> (Option<[f64; 2]>, Option<f64>) {
    let (mut range, mut speed) = (None, None);
    for study in &case.studies {
        match study {
            Study::CriticalSpeed(study) => {
                range = study.speeds.first().copied().zip(study.speeds.last().copied());
                speed = study.line_speed.or(speed);
            }
            Study::TrackResponse(study) => {
                speed = speed.or(study.line_speed).or(study.speeds.last().copied())
            }
            Study::Contour(study) => speed = speed.or(study.speeds.last().copied()),
            _ => {}
        }
    }
    (range.map(|(from, to)| [from, to]), speed)
}

/// The layers of the library soil `name`; null if it cannot be read.
pub fn library_soil(name: &str) -> Value {
    let none = |_: &str| Err("a soil of the library names no file".to_owned());
    let tables = Tables::parse(&format!("soil = \"{name}\""), name, &none);
    tables.ok().and_then(|tables| tables.ground).map_or(Value::Null, |ground| ground_of(&ground))
}

/// Layers and base, with their names.
fn ground_of(ground: &Ground) -> Value {
    let names = ground.names.iter().cloned().chain(std::iter::repeat(None));
    let mut told: Vec<Value> = ground.profile.materials().zip(names).map(material).collect();
    let half_space = match ground.profile.base() {
        Base::HalfSpace(_) => told.pop(),
        Base::Rigid => None,
    };
    for (told, layer) in told.iter_mut().zip(ground.profile.layers()) {
        told["thickness"] = layer.thickness.into();
    }
    json!({ "layers": told, "half_space": half_space })
}

fn material((material, name): (&Material, Option<String>)) -> Value {
    json!({
        "name": name, "shear_speed": material.c_s(), "poisson": material.poisson(), "density": material.density(),
        "damping_ratio": 0.5 * material.loss_factor(),
    })
}
