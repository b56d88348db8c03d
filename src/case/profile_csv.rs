//! A soil as a CSV file: a header, then a line for each layer, the last one the half-space.

use super::error::{Finding, spelling};
use crate::columns::{self, Table};
use std::fmt::Write;

/// Columns a profile may have, besides `depth`: keys of `[[soil.layer]]`.
const KEYS: [&str; 11] = [
    "thickness",
    "depth",
    "young",
    "poisson",
    "shear_speed",
    "pressure_speed",
    "density",
    "loss_factor",
    "damping_ratio",
    "loss_factor_pressure",
    "damping_ratio_pressure",
];
const HELP: &str = "a profile has the columns thickness, or depth of upper faces, then density, shear_speed with poisson or pressure_speed, and damping_ratio; \
                    units in brackets; the last line is the half-space, its thickness 0";

/// The key of a column, and the unit its name gives.
fn key(name: &str) -> Result<(&'static str, String), Finding> {
    let (word, unit) = name.split_once(['[', '(']).unwrap_or((name, ""));
    let (word, unit) = (word.trim(), unit.trim_end_matches([']', ')']).trim());
    let known = KEYS.into_iter().find(|known| *known == word);
    let unknown = || {
        Finding::new("", format!("unknown column `{word}`"))
            .help(format!("{}; {HELP}", spelling(word, &KEYS)))
    };
    Ok((known.ok_or_else(unknown)?, unit.to_owned()))
}

/// Thicknesses from the depths of upper faces, the last one 0.
fn thicknesses(depths: &[f64], lines: &[usize]) -> Result<Vec<f64>, Finding> {
    if depths.first().is_some_and(|first| *first != 0.0) {
        let message = format!("line {}: depth is {}: the first layer begins at 0", lines[0], depths[0]);
        return Err(Finding::new("", message).help("depth is that of the upper face of each layer"));
    }
    let steps = depths.windows(2).map(|pair| pair[1] - pair[0]);
    Ok(steps.chain([0.0]).collect())
}

/// The table `[soil]` that the profile `csv` stands for, each layer in the line it has there.
///
/// # Errors
/// No table of numbers, unknown columns, a last line that is no half-space.
pub fn toml(csv: &str) -> Result<String, Finding> {
    let Table { names, mut columns, lines, header } =
        columns::table(csv).map_err(|error| Finding::new("", error).help(HELP))?;
    let mut keys = names.iter().map(|name| key(name)).collect::<Result<Vec<_>, _>>()?;
    if let Some(at) = keys.iter().position(|(key, _)| *key == "depth") {
        columns[at] = thicknesses(&columns[at], &lines)?;
        keys[at].0 = "thickness";
    }
    let thickness = keys.iter().position(|(key, _)| *key == "thickness");
    let Some((last, thickness)) = lines.len().checked_sub(1).zip(thickness) else {
        return Err(Finding::new("", "the profile has no layers, or no thicknesses").help(HELP));
    };
    if columns[thickness][last] != 0.0 {
        let message = format!("line {}: the last line is no half-space: its thickness is not 0", lines[last]);
        return Err(Finding::new("", message).help(HELP));
    }
    let mut text = "\n".repeat(header - 1);
    if last > 0 {
        text += "layer = [";
    }
    for (row, line) in lines.iter().enumerate() {
        text += &"\n".repeat(line - 1 - text.matches('\n').count());
        text += if row == last { "half_space = {" } else { "  {" };
        let mut comma = "";
        for ((key, unit), column) in keys.iter().zip(&columns) {
            if row == last && *key == "thickness" {
                continue;
            }
            let value = column[row];
            let _ = match unit.as_str() {
                "" => write!(text, "{comma} {key} = {value:?}"),
                unit => write!(text, "{comma} {key} = \"{value:?} {unit}\""),
            };
            comma = ",";
        }
        text += match last - row {
            0 => " }\n",
            1 => " }]",
            _ => " },",
        };
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::super::{CaseError, Tables};
    use super::toml;

    fn soil(csv: &str) -> Result<Tables, CaseError> {
        let csv = csv.to_owned();
        Tables::parse("soil = \"site.csv\"", "tables", &move |_| Ok(csv.clone()))
    }

    const CSV: &str = "# borehole 7\ndepth [m]; density [t/m3]; shear_speed; poisson; damping_ratio [%]\n\
                       0; 1,5; 120; 0,35; 3\n\n2,5; 1,7; 150; 0,4; 3\n6; 2; 300; 0,4; 2\n";

    #[test]
    fn layers_stand_in_their_lines() {
        let text = toml(CSV).unwrap();
        assert!(text.lines().nth(4).unwrap().contains("thickness = \"3.5 m\""), "{text}");
        let ground = soil(CSV).unwrap().ground.unwrap();
        let layers = ground.profile.layers();
        assert_eq!(layers.iter().map(|layer| layer.thickness).collect::<Vec<_>>(), [2.5, 3.5]);
        let first = &layers[0].material;
        assert_eq!((first.c_s(), first.density(), first.loss_factor()), (120.0, 1500.0, 0.06));
        let by_thickness = CSV
            .replace("depth", "thickness")
            .replace("0; 1,5", "2,5; 1,5")
            .replace("2,5; 1,7", "3,5; 1,7")
            .replace("6; 2;", "0; 2;");
        assert_eq!(soil(&by_thickness).unwrap().ground.unwrap().profile, ground.profile);
        let half_space = "thickness,young,poisson,density,loss_factor\n0,5e7,0.3,1800,0.04\n";
        assert!(soil(half_space).unwrap().ground.unwrap().profile.layers().is_empty());
    }

    #[test]
    fn faults_are_told_by_line_or_column() {
        let told = |csv: &str| soil(csv).map(drop).unwrap_err().to_string();
        assert!(told(&CSV.replace("density", "densty")).contains("unknown column `densty`"));
        assert!(told(&CSV.replace("6; 2; 300", "6; 2; -300")).contains("shear_speed"));
        assert!(told(&CSV.replace("0; 1,5", "1; 1,5")).contains("line 3: depth is 1"));
        assert!(told(&CSV.replace("depth", "thickness")).contains("line 6: the last line is no half-space"));
        assert!(told(&CSV.replace("1,7", "")).contains("line 5 reads"));
        assert!(told("depth [m]\n").contains("no layers"));
    }
}
