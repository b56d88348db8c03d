//! Numbers that are probably in another unit: one table of what a key can mean and of what is usual.
//!
//! It is held against the TOML text itself, and needs no knowledge of the structures read from it. Ranges are of the order of
//! magnitude: they catch kilo- and mega-units, millimetres and per cent, and leave every real railway in peace.

use super::error::{CaseError, Finding};
use super::keys;
use super::units::{
    AREA, BEDDING, BENDING, DAMPER, DENSITY, HERTZ, INERTIA, KILOGRAM, LINE_DAMPER, LINE_MASS, LINE_SPRING,
    METRE, NEWTON, PRESSURE, RADIAN, RATIO, ROTARY, ROUGHNESS, SECOND, SPEED, SPRING, Unit,
};
use crate::concern::Concern;
use toml::Value;

/// What the absolute value of a key can be.
struct Row {
    /// Path of the key; `*` is any one step, `[]` any place of a list.
    key: &'static str,
    unit: Unit,
    /// Outside, it is refused.
    possible: (f64, f64),
    /// Outside, it is a concern.
    usual: (f64, f64),
}

const fn row(key: &'static str, unit: Unit, possible: (f64, f64), usual: (f64, f64)) -> Row {
    Row { key, unit, possible, usual }
}

/// Any size is possible.
const ANY: (f64, f64) = (0.0, f64::INFINITY);

/// The first row that fits a key counts. Zero always passes: it means "none" where it may stand at all.
const TABLE: &[Row] = &[
    row("soil.*.thickness", METRE, (0.0, 1e4), (0.02, 300.0)),
    row("soil.*.young", PRESSURE, ANY, (1e5, 2e11)),
    row("soil.*.shear_speed", SPEED, ANY, (15.0, 5000.0)),
    row("soil.*.pressure_speed", SPEED, ANY, (30.0, 9000.0)),
    row("soil.*.density", DENSITY, (5.0, 25e3), (700.0, 3500.0)),
    row("soil.*.damping_ratio", RATIO, (0.0, 1.0), (0.0, 0.3)),
    row("soil.*.damping_ratio_pressure", RATIO, (0.0, 1.0), (0.0, 0.3)),
    row("soil.*.loss_factor", RATIO, (0.0, 2.0), (0.0, 0.6)),
    row("soil.*.loss_factor_pressure", RATIO, (0.0, 2.0), (0.0, 0.6)),
    row("foundation.stiffness", LINE_SPRING, (1e3, 1e13), (1e6, 1e10)),
    row("foundation.damping", LINE_DAMPER, ANY, (1e2, 1e8)),
    row("foundation.loss_factor", RATIO, (0.0, 5.0), (0.0, 2.0)),
    row("foundation.shear", NEWTON, ANY, (1e4, 1e10)),
    row("foundation.tension", NEWTON, ANY, (1e4, 1e10)),
    row("foundation.bending_stiffness", BENDING, ANY, (1e3, 1e11)),
    row("foundation.upper_stiffness", LINE_SPRING, (1e3, f64::INFINITY), (1e6, 1e12)),
    row("foundation.element.stiffness", LINE_SPRING, (1e3, 1e13), (1e6, 1e10)),
    row("foundation.element.second_stiffness", LINE_SPRING, (1e3, 1e13), (1e6, 1e10)),
    row("foundation.element.damping", LINE_DAMPER, ANY, (1e2, 1e8)),
    row("foundation.element.second_damping", LINE_DAMPER, ANY, (1e2, 1e8)),
    row("track.*.element.stiffness", LINE_SPRING, (1e4, 1e14), (1e6, 2e10)),
    row("track.*.element.second_stiffness", LINE_SPRING, (1e4, 1e14), (1e6, 2e10)),
    row("track.*.element.damping", LINE_DAMPER, ANY, (3e2, 1e8)),
    row("track.*.element.second_damping", LINE_DAMPER, ANY, (3e2, 1e8)),
    row("*.element.loss_factor", RATIO, (0.0, 5.0), (0.0, 2.0)),
    row("*.*.element.loss_factor", RATIO, (0.0, 5.0), (0.0, 2.0)),
    row("*.element.reference_frequency", HERTZ, (1e-3, 1e6), (0.5, 1e4)),
    row("*.*.element.reference_frequency", HERTZ, (1e-3, 1e6), (0.5, 1e4)),
    row("track.rail.bending_stiffness", BENDING, (1e3, 1e10), (2e5, 1e8)),
    row("track.rail.mass", LINE_MASS, (1.0, 1e4), (15.0, 300.0)),
    row("track.rail.shear_stiffness", NEWTON, (1e5, 1e12), (3e7, 3e9)),
    row("track.rail.rotary_inertia", ROTARY, (1e-4, 1e4), (0.02, 10.0)),
    row("track.beam.shear_stiffness", NEWTON, (1e5, 1e14), (3e7, 1e12)),
    row("track.beam.rotary_inertia", ROTARY, (1e-4, 1e8), (0.02, 1e6)),
    row("track.slab.shear_stiffness", NEWTON, (1e5, 1e14), (3e7, 1e12)),
    row("track.slab.rotary_inertia", ROTARY, (1e-4, 1e8), (0.02, 1e6)),
    row("track.pad.stiffness", LINE_SPRING, (1e5, 1e14), (5e6, 2e10)),
    row("track.pad.damping", LINE_DAMPER, ANY, (3e2, 1e7)),
    row("track.sleeper.mass", LINE_MASS, (1.0, 1e5), (20.0, 3000.0)),
    row("track.ballast.young", PRESSURE, (1e4, 1e12), (5e6, 2e9)),
    row("track.ballast.height", METRE, (0.01, 50.0), (0.05, 3.0)),
    row("track.ballast.alpha", RATIO, (1e-3, 10.0), (0.02, 1.0)),
    row("track.ballast.wave_speed", SPEED, (5.0, 1e4), (50.0, 2000.0)),
    row("track.ballast.density", DENSITY, (5.0, 25e3), (700.0, 3500.0)),
    row("track.ballast.stiffness", LINE_SPRING, (1e4, 1e13), (5e6, 2e10)),
    row("track.ballast.damping", LINE_DAMPER, ANY, (3e2, 1e8)),
    row("track.ballast.mass", LINE_MASS, (5.0, 1e6), (100.0, 2e4)),
    row("track.ballast.link.stiffness", SPRING, (1e3, 1e12), (1e5, 1e10)),
    row("track.ballast.link.damping", DAMPER, ANY, (1e2, 1e8)),
    row("track.*.piece.stiffness", SPRING, (1e4, 1e12), (5e5, 1e10)),
    row("track.*.piece.damping", DAMPER, ANY, (1e2, 1e7)),
    row("track.*.piece.loss_factor", RATIO, (0.0, 5.0), (0.0, 2.0)),
    row("track.sleeper.piece.mass", KILOGRAM, (5.0, 1e4), (40.0, 1000.0)),
    row("track.*.spacing", METRE, (0.05, 100.0), (0.4, 5.0)),
    row("track.*.bedding_modulus", BEDDING, (1e5, 1e12), (3e6, 1e10)),
    row("track.mat.width", METRE, (0.01, 50.0), (0.1, 10.0)),
    row("track.*.area", AREA, (1e-4, 10.0), (0.01, 2.0)),
    row("track.under_sleeper_pad.stiffness", LINE_SPRING, (1e5, 1e14), (5e6, 2e10)),
    row("track.mat.stiffness", LINE_SPRING, (1e5, 1e14), (5e6, 2e10)),
    row("track.sub_ballast.young", PRESSURE, (1e4, 1e12), (5e6, 2e9)),
    row("track.sub_ballast.height", METRE, (0.01, 50.0), (0.05, 3.0)),
    row("track.sub_ballast.alpha", RATIO, (1e-3, 10.0), (0.02, 1.0)),
    row("track.sub_ballast.wave_speed", SPEED, (5.0, 1e4), (50.0, 2000.0)),
    row("track.sub_ballast.density", DENSITY, (5.0, 25e3), (700.0, 3500.0)),
    row("track.sub_ballast.stiffness", LINE_SPRING, (1e4, 1e13), (5e6, 2e10)),
    row("track.sub_ballast.damping", LINE_DAMPER, ANY, (3e2, 1e8)),
    row("track.sub_ballast.mass", LINE_MASS, (5.0, 1e6), (100.0, 2e4)),
    row("train.overhang", METRE, (0.0, 100.0), (0.1, 20.0)),
    row("train.vehicle[].length", METRE, (0.5, 5e3), (4.0, 500.0)),
    row("track.support.spacing", METRE, (0.05, 100.0), (0.4, 5.0)),
    row("track.support.width", METRE, (0.005, 100.0), (0.1, 3.0)),
    row("track.section[].length", METRE, (0.05, 1e6), (0.4, 1e4)),
    row("track.slab.bending_stiffness", BENDING, (1e3, 1e13), (1e6, 1e11)),
    row("track.slab.mass", LINE_MASS, (10.0, 1e6), (200.0, 3e4)),
    row("track.beam.bending_stiffness", BENDING, (1e3, 1e13), (2e5, 1e11)),
    row("track.beam.mass", LINE_MASS, (1.0, 1e7), (15.0, 1e5)),
    row("track.*.loss_factor", RATIO, (0.0, 5.0), (0.0, 2.0)),
    row("track.contact.half_width", METRE, (1e-3, 500.0), (0.1, 25.0)),
    row("track.load.half_width", METRE, (1e-4, 500.0), (0.01, 25.0)),
    row("track.load.half_length", METRE, (1e-4, 500.0), (0.01, 25.0)),
    row("train.axles[].load", NEWTON, ANY, (5e3, 6e5)),
    row("train.length", METRE, (0.5, 5e3), (4.0, 500.0)),
    row("train.unsprung_mass", KILOGRAM, (10.0, 1e5), (200.0, 6000.0)),
    row("train.body.mass", KILOGRAM, (200.0, 1e7), (4e3, 2e5)),
    row("train.body.pitch_inertia", INERTIA, (1e3, 1e9), (2e4, 2e7)),
    row("train.body.bogie_centres", METRE, (0.5, 200.0), (3.0, 40.0)),
    row("train.bogie.mass", KILOGRAM, (50.0, 1e6), (500.0, 3e4)),
    row("train.bogie.pitch_inertia", INERTIA, (1.0, 1e8), (100.0, 1e5)),
    row("train.bogie.wheelbase", METRE, (0.3, 50.0), (1.0, 6.0)),
    row("train.wheelset.mass", KILOGRAM, (10.0, 1e5), (200.0, 6000.0)),
    row("train.primary.stiffness", SPRING, (1e3, 1e11), (1e5, 1e8)),
    row("train.secondary.stiffness", SPRING, (1e3, 1e11), (5e4, 1e8)),
    row("train.primary.damping", DAMPER, ANY, (5e2, 2e6)),
    row("train.secondary.damping", DAMPER, ANY, (5e2, 2e6)),
    row("train.wheel_rail.stiffness", SPRING, (1e6, 1e13), (2e8, 2e10)),
    row("train.wheel_rail.radius", METRE, (0.05, 10.0), (0.15, 0.8)),
    row("irregularity.roughness", ROUGHNESS, (0.0, 1.0), (1e-13, 1e-2)),
    row("irregularity.amplitude", METRE, (0.0, 1.0), (1e-8, 0.03)),
    row("irregularity.orders[].amplitude", METRE, (0.0, 0.5), (1e-8, 5e-3)),
    row("irregularity.radius", METRE, (0.05, 10.0), (0.15, 0.8)),
    row("irregularity.wavelength", METRE, ANY, (0.01, 300.0)),
    row("passage.defect[].depth", METRE, (0.0, 0.1), (1e-6, 0.03)),
    row("passage.defect[].length", METRE, (0.0, 1e3), (0.005, 30.0)),
    row("passage.defect[].radius", METRE, (0.05, 10.0), (0.15, 0.8)),
    row("passage.defect[].angle", RADIAN, (0.0, 1.0), (1e-4, 0.03)),
    row("passage.hanging_sleeper[].gap", METRE, (0.0, 1.0), (1e-5, 0.02)),
    row("passage.step", SECOND, (1e-9, 1.0), (1e-7, 5e-3)),
    row("passage.step_length", METRE, (1e-7, 1.0), (1e-5, 0.05)),
    row("*.passage_time", SECOND, ANY, (0.1, 600.0)),
    row("*.speed", SPEED, ANY, (0.0, 200.0)),
    row("*.speeds[]", SPEED, ANY, (0.0, 200.0)),
    row("*.speeds.to", SPEED, ANY, (0.0, 200.0)),
    row("*.*.speed", SPEED, ANY, (0.0, 200.0)),
];

/// Whether `path`, such as `soil.layer[1].young`, fits `key`.
fn fits(key: &str, path: &str) -> bool {
    let (mut steps, mut wanted) = (path.split('.'), key.split('.'));
    loop {
        match (steps.next(), wanted.next()) {
            (None, None) => return true,
            (Some(_), Some("*")) => {}
            (Some(step), Some(wanted)) => {
                let list = step.split_once('[').map(|(name, _)| format!("{name}[]"));
                if list.as_deref().unwrap_or(step) != wanted {
                    return false;
                }
            }
            _ => return false,
        }
    }
}

/// A number with its path within the whole case and within its file, and whether it stands there with its unit.
struct Number {
    whole: String,
    path: String,
    value: f64,
    meant: bool,
}

/// Every number of `value` with its path, and whether it has a unit.
fn numbers(value: &Value, (root, path): (&str, &str), found: &mut Vec<Number>) {
    let whole = || match (root, path) {
        ("", path) => path.to_owned(),
        (root, path) => format!("{root}.{path}"),
    };
    let mut push = |value, meant| found.push(Number { whole: whole(), path: path.to_owned(), value, meant });
    match value {
        Value::Float(number) => push(*number, false),
        Value::Integer(number) => push(*number as f64, false),
        Value::String(text) => {
            if let Some(value) = keys::unit(&whole()).and_then(|unit| unit.read(text).ok()) {
                push(value, true);
            }
        }
        Value::Array(list) => {
            for (i, value) in list.iter().enumerate() {
                numbers(value, (root, &format!("{path}[{i}]")), found);
            }
        }
        Value::Table(table) => {
            for (key, value) in table {
                let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                numbers(value, (root, &path), found);
            }
        }
        _ => {}
    }
}

/// A number to four digits, with a power of ten where it is large or small.
fn shown(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if (1e-3..1e5).contains(&rounded.abs()) || rounded == 0.0 {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

impl Row {
    fn quantity(&self, value: f64) -> String {
        [shown(value).as_str(), self.unit.name].join(" ").trim_end().to_owned()
    }

    /// "did you mean 150 kN = 1.5e5 N?" for every unit that makes `value` usual.
    fn meant(&self, value: f64) -> String {
        let (low, high) = self.usual;
        let mut readings: Vec<(f64, String)> = Vec::new();
        for (name, size) in self.unit.others {
            let usual = (low..=high).contains(&(value.abs() * size));
            if usual && readings.iter().all(|(other, _)| other != size) {
                let reading = format!("{} {name} = {}", shown(value), self.quantity(value * size));
                readings.push((*size, reading));
            }
        }
        let unit = match self.unit.name {
            "" => "a plain ratio".to_owned(),
            unit => {
                format!("in {unit}; with its unit, as in \"{} {unit}\", it is taken as meant", shown(value))
            }
        };
        match readings.is_empty() {
            true => format!("the key is {unit}"),
            false => {
                let readings: Vec<String> = readings.into_iter().map(|(_, reading)| reading).collect();
                format!("did you mean {}? The key is {unit}", readings.join(", or "))
            }
        }
    }

    fn range(&self, (low, high): (f64, f64)) -> String {
        match (low > 0.0, high.is_finite()) {
            (true, true) => format!("{} to {}", shown(low), self.quantity(high)),
            (true, false) => format!("above {}", self.quantity(low)),
            _ => format!("up to {}", self.quantity(high)),
        }
    }
}

/// What is doubtful, and what cannot be, in the table `text` of a case.
///
/// `root` is the key the table stands for (empty for a whole case), `name` its file; a file of its own is named by the concern.
pub fn review(root: &str, name: &str, text: &str) -> (Vec<CaseError>, Vec<Concern>) {
    let (mut refused, mut concerns) = (Vec::new(), Vec::new());
    let Ok(table) = text.parse::<toml::Table>() else { return (refused, concerns) };
    let mut rest = Vec::new();
    numbers(&Value::Table(table), (root, ""), &mut rest);
    for number in &mut rest {
        // a section has the keys of its track
        let key = number.whole.strip_prefix("track.section[").and_then(|rest| rest.split_once("]."));
        if let Some((_, key)) = key.filter(|(_, key)| *key != "length") {
            number.whole = format!("track.{key}");
        }
    }
    for row in TABLE {
        let (here, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(|n| fits(row.key, &n.whole));
        rest = others;
        let outside = |(low, high): (f64, f64), value: f64| {
            value.is_finite() && value != 0.0 && !(low..=high).contains(&value.abs())
        };
        let impossible = |n: &&Number| outside(row.possible, n.value);
        // what has its unit is taken as meant, where it can be
        let doubtful: Vec<_> =
            here.iter().filter(|n| outside(row.usual, n.value) && (!n.meant || impossible(n))).collect();
        let first = doubtful.iter().copied().find(impossible).or(doubtful.first().copied());
        let Some(Number { path, value, .. }) = first else { continue };
        if outside(row.possible, *value) {
            let message = format!("found {}; possible is {}", row.quantity(*value), row.range(row.possible));
            refused.push(Finding::new(path, message).help(row.meant(*value)).at(name, text));
        } else {
            let file = if root.is_empty() { String::new() } else { format!(" in {name}") };
            let more = match doubtful.len() - 1 {
                0 => String::new(),
                more => format!(", and {more} more of its kind"),
            };
            concerns.push(Concern::new(
                "unusual-value",
                format!("{path}{file} is {}{more}; usual is {}", row.quantity(*value), row.range(row.usual)),
                row.meant(*value),
            ));
        }
    }
    (refused, concerns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::library::ENTRIES;

    #[test]
    fn keys_fit_their_rows() {
        assert!(
            fits("soil.*.young", "soil.layer[12].young") && fits("soil.*.young", "soil.half_space.young")
        );
        assert!(
            fits("train.axles[].load", "train.axles[3].load") && !fits("train.axles[].load", "train.axles")
        );
        assert!(!fits("*.speed", "track_response.measured[0].speed"));
    }

    #[test]
    fn the_usual_lies_within_the_possible() {
        for row in TABLE {
            assert!(row.possible.0 <= row.usual.0 && row.usual.1 <= row.possible.1, "{}", row.key);
        }
    }

    #[test]
    fn the_library_is_usual() {
        for entry in ENTRIES {
            let root = match entry.kind {
                "soils" => "soil",
                "tracks" => "track",
                _ => "train",
            };
            let (refused, concerns) = review(root, entry.name, entry.text);
            assert!(refused.is_empty() && concerns.is_empty(), "{}: {concerns:?}", entry.name);
        }
    }

    #[test]
    fn says_which_unit_was_meant() {
        let (_, concerns) =
            review("train", "t.toml", "axles = [{ position = 0, load = 15 }, { load = 15.0 }]");
        let said = concerns[0].to_string();
        assert!(said.contains("axles[0].load in t.toml is 15 N, and 1 more of its kind"), "{said}");
        assert!(said.contains("did you mean 15 kN = 15000 N, or 15 t = 1.472e5 N?"), "{said}");
    }
}
