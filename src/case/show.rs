//! An entry of the library in words: title, source, its keys with their units, and what an engineer would work out from them.

use super::error::{CaseError, Finding, spelling};
use super::library::{ENTRIES, Entry};
use super::loader::{Loader, root};
use super::schema::{SoilInput, TrackInput, TrainInput};
use super::values::Named;
use super::{ground, keys, train};
use crate::soil::{Base, Material};
use crate::vehicle::{Axle, GRAVITY, Train};
use num_complex::Complex64;
use std::fmt::Write;
use toml::Value;

/// The entry called `name` on any shelf, in lines.
///
/// # Errors
/// No such entry, with the nearest spelling.
pub fn show(name: &str) -> Result<String, CaseError> {
    let names: Vec<&str> = ENTRIES.iter().map(|entry| entry.name).collect();
    let Some(entry) = ENTRIES.iter().find(|entry| entry.name == name) else {
        let finding = Finding::new("", format!("the library has no entry \"{name}\""));
        return Err(finding.help(spelling(name, &names)).at("the library", ""));
    };
    let mut lines = String::new();
    let title = entry.text_of("title").unwrap_or_default();
    let shelf = root(entry.kind);
    let _ = writeln!(
        lines,
        "{title}\n{shelf} = \"{name}\"\nsource: {}\n",
        entry.text_of("source").unwrap_or_default()
    );
    if let Ok(table) = entry.text.parse::<toml::Table>() {
        for (key, value) in table.iter().filter(|(key, _)| !["title", "source"].contains(&key.as_str())) {
            written(value, key, shelf, &mut lines);
        }
    }
    let derived = match entry.kind {
        "soils" => soil(entry),
        "tracks" => track(entry),
        _ => vehicle(entry),
    }?;
    let _ = writeln!(lines, "\n{}", derived.join("\n"));
    Ok(lines)
}

/// Every number below `value` with its key and its unit.
fn written(value: &Value, key: &str, shelf: &str, lines: &mut String) {
    match value {
        Value::Table(table) => {
            table.iter().for_each(|(below, value)| written(value, &format!("{key}.{below}"), shelf, lines));
        }
        Value::Array(list) => {
            for (i, value) in list.iter().enumerate() {
                written(value, &format!("{key}[{i}]"), shelf, lines);
            }
        }
        value => {
            let unit = match value {
                Value::Float(_) | Value::Integer(_) => {
                    keys::unit(&format!("{shelf}.{key}")).map_or("", |unit| unit.name)
                }
                _ => "",
            };
            let _ = writeln!(lines, "{}", format!("  {key} = {value} {unit}").trim_end());
        }
    }
}

/// The table that `entry` stands for, read; `of` takes a loader of nothing else.
fn loaded<T>(entry: &Entry, of: impl FnOnce(&Loader) -> Result<T, CaseError>) -> Result<T, CaseError> {
    let nothing = |_: &str| Err("the library stands for itself".to_owned());
    of(&Loader::of(entry.name, entry.text, &nothing))
}

/// Speeds of the waves in every layer.
fn soil(entry: &Entry) -> Result<Vec<String>, CaseError> {
    let named = Named::<SoilInput>::Name(entry.name.to_owned());
    let resolved = loaded(entry, |loader| loader.resolve(&named, "soil", entry.kind))?;
    let fault = |faults: Vec<Finding>| {
        CaseError::all(faults.into_iter().map(|f| f.at(entry.name, entry.text)), entry.name)
    };
    let profile = ground::profile(&resolved.table, "").map_err(fault)?;
    let of = |material: &Material| {
        format!(
            "c_s {:.1} m/s, c_p {:.1} m/s, Rayleigh {:.1} m/s, density {:.0} kg/m³, shear modulus {:.1} MPa",
            material.c_s(),
            material.c_p(),
            material.rayleigh_speed(),
            material.density(),
            1e-6 * material.density() * material.c_s().powi(2)
        )
    };
    let mut depth = 0.0;
    let mut lines = Vec::new();
    for layer in profile.layers() {
        let below = depth + layer.thickness;
        lines.push(format!("{depth:.2} to {below:.2} m: {}", of(&layer.material)));
        depth = below;
    }
    lines.push(match profile.base() {
        Base::HalfSpace(material) => format!("below {depth:.2} m: {}", of(&material)),
        Base::Rigid => format!("rigid rock below {depth:.2} m"),
    });
    Ok(lines)
}

/// What the track weighs and how far it gives way.
fn track(entry: &Entry) -> Result<Vec<String>, CaseError> {
    let named = Named::<TrackInput>::Name(entry.name.to_owned());
    let resolved = loaded(entry, |loader| loader.resolve(&named, "track", entry.kind))?;
    let half_width = resolved.table.contact.map(|strip| strip.half_width);
    let stack = resolved.table.track.stack(half_width).map_err(|error| resolved.fault("", error))?;
    let mass: f64 = stack.members().iter().map(|member| member.mass).sum();
    let bending: f64 = stack.members().iter().map(|member| member.bending_stiffness).sum();
    let mut lines = vec![
        format!("mass of its members {mass:.1} kg per metre of track"),
        format!("bending stiffness of its beams {:.3} MN m²", 1e-6 * bending),
    ];
    if !stack.links().is_empty() {
        let at_rest = |k: Complex64| 1e-6 * k.re;
        for (i, link) in stack.links().iter().enumerate() {
            let k = at_rest(link.stiffness(0.0).upper);
            lines.push(format!("stiffness of link {} from the rail down, at rest {k:.1} MN/m²", i + 1));
        }
        let flexibility: f64 = stack.links().iter().map(|link| 1.0 / link.stiffness(0.0).upper.re).sum();
        let k = 1.0 / flexibility;
        lines.push(format!("all of them in series {:.1} MN/m²", 1e-6 * k));
        // a beam on springs: k_t = 2√2 (EI)^¼ k^¾
        let rail = stack.members()[0].bending_stiffness;
        let seen = 8f64.sqrt() * rail.powf(0.25) * k.powf(0.75);
        lines.push(format!(
            "track stiffness on rigid ground {:.1} kN/mm of the whole track, load over deflection",
            1e-6 * seen
        ));
    }
    Ok(lines)
}

/// Axles, loads and lengths.
fn vehicle(entry: &Entry) -> Result<Vec<String>, CaseError> {
    let named = Named::<TrainInput>::Name(entry.name.to_owned());
    let (train, wheels) = loaded(entry, |loader| train::train(loader, &named))?;
    let axles = train.axles();
    let least = axles.iter().map(|a| a.load).fold(f64::INFINITY, f64::min);
    let most = axles.iter().map(|a| a.load).fold(0.0, f64::max);
    let loads = match least == most {
        true => format!("{:.1} kN ({:.2} t)", 1e-3 * most, 1e-3 * most / GRAVITY),
        false => format!("{:.1} to {:.1} kN", 1e-3 * least, 1e-3 * most),
    };
    let mut lines = vec![
        format!(
            "{} axles of {loads}, together {:.1} kN ({:.1} t)",
            axles.len(),
            1e-3 * train.total_load(),
            1e-3 * train.total_load() / GRAVITY
        ),
        format!("{:.3} m over axles", train.length()),
        format!("axles behind the first at {} m", places(&train, axles)),
    ];
    lines.extend(
        wheels
            .bodies
            .map(|bodies| format!("{} degrees of freedom", bodies.freedoms().len() * bodies.copies())),
    );
    Ok(lines)
}

/// Places of the axles [m], the first dozen of them.
fn places(train: &Train, axles: &[Axle]) -> String {
    const MOST: usize = 12;
    let first = train.axles()[0].position;
    let shown: Vec<String> = axles.iter().take(MOST).map(|a| format!("{:.2}", a.position - first)).collect();
    let more = if axles.len() > MOST { ", …" } else { "" };
    shown.join(", ") + more
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_can_be_shown() {
        for entry in ENTRIES {
            let lines = show(entry.name).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
            assert!(lines.contains("source: ") && lines.lines().count() > 5, "{lines}");
        }
        let error = show("manchester").unwrap_err().to_string();
        assert!(error.contains("no entry \"manchester\""), "{error}");
    }

    #[test]
    fn what_is_worked_out_is_right() {
        let axle = show("lamprea2022_axle").unwrap();
        assert!(
            axle.contains("axles[0].load = 150000.0 N") && axle.contains("1 axles of 150.0 kN (15.29 t)"),
            "{axle}"
        );
        // 1/(1/7e8 + 1/(2 · 0.5 · 1.25 · 1.4e8/0.35)); 2√2 (1.276e7)^¼ k^¾
        let track = show("lamprea2022_ballasted").unwrap();
        let k = 1.0 / (1.0 / 700.0 + 1.0 / 500.0);
        assert!(track.contains(&format!("all of them in series {k:.1} MN/m²")), "{track}");
        let seen = 1e-6 * 8f64.sqrt() * 1.276e7f64.powf(0.25) * (1e6f64 * k).powf(0.75);
        assert!(track.contains(&format!("track stiffness on rigid ground {seen:.1} kN/mm")), "{track}");
        let soil = show("lamprea2022_half_space").unwrap();
        // √(75e6/(2 · 1.35 · 1800))
        assert!(soil.contains("c_s 124.2 m/s"), "{soil}");
    }
}
