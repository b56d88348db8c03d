//! CSV tables of one study, for spreadsheets, pandas and MATLAB.
//!
//! Everything in the group is in some file, at full precision; maps, which are long as text, only where they are asked for:
//!
//! - variables along the same dimensions share one table with a column per dimension, so a field over (speed, x) is a
//!   long table with one row per pair. The file is `<group>.csv` if the group has one table, else
//!   `<group>_<dimensions>.csv`, e.g. `receptance_receiver_frequency.csv`;
//! - scalars go to `<group>_scalars.csv`: name, value, units, description;
//! - a 2-D field of more than 200 000 values would be a long table of tens of megabytes: it goes to
//!   `<group>_<name>_matrix.csv`, whose first row holds the fastest coordinate and whose first column the slowest.
//!
//! Lines beginning with `# ` come first and name the group, the attributes and the meaning of every column; then a
//! header row `name [units]`. Read it with `pandas.read_csv(path, comment="#")` (a matrix with `index_col=0`) or with
//! MATLAB's `readtable(path, CommentStyle="#", VariableNamingRule="preserve")`.

use super::{OutputError, save};
use crate::dataset::{Attribute, Group, Variable};
use ndarray::Dimension;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A 2-D field of more values than this becomes a matrix file.
const MATRIX_ABOVE: usize = 200_000;

/// Writes the tables of `group` into the folder `dir`, which must exist, and returns their paths; its
/// [maps](Group::maps) too if `maps`.
///
/// # Errors
/// [`OutputError::Write`] if a file cannot be written.
///
/// Accuracy: numbers are the shortest that read back to the same bits; NaN and infinities are `NaN`, `Inf`, `-Inf`.
pub fn write(group: &Group, dir: &Path, maps: bool) -> Result<Vec<PathBuf>, OutputError> {
    let mut files = Vec::new();
    let scalars: Vec<_> = group.variables.iter().filter(|v| v.dims.is_empty()).collect();
    if !scalars.is_empty() {
        files.push((format!("{}_scalars.csv", group.name), scalar_table(group, &scalars)));
    }
    let (fields, small): (Vec<_>, Vec<_>) = group
        .variables
        .iter()
        .filter(|v| !v.dims.is_empty() && (maps || !v.is_map()))
        .partition(|v| v.dims.len() == 2 && v.values.len() > MATRIX_ABOVE);
    let tables = share_dimensions(&small, group);
    for members in &tables {
        let name = if tables.len() == 1 {
            format!("{}.csv", group.name)
        } else {
            format!("{}_{}.csv", group.name, members[0].dims.join("_"))
        };
        files.push((name, long_table(group, members)));
    }
    for field in fields {
        files.push((format!("{}_{}_matrix.csv", group.name, field.name), matrix(group, field)));
    }
    files
        .into_iter()
        .map(|(name, text)| {
            let path = dir.join(name);
            save(&path, text.as_bytes())?;
            Ok(path)
        })
        .collect()
}

/// The variables gathered by their dimensions, in order of appearance. A coordinate that is a column (or an edge) of
/// another file, or of a map left out, gets no file of its own.
fn share_dimensions<'a>(small: &[&'a Variable], group: &Group) -> Vec<Vec<&'a Variable>> {
    let mut tables: Vec<Vec<&Variable>> = Vec::new();
    for &variable in small {
        match tables.iter_mut().find(|t| t[0].dims == variable.dims) {
            Some(table) => table.push(variable),
            None => tables.push(vec![variable]),
        }
    }
    let alone = |table: &[&Variable]| table.len() == 1 && table[0].is_coordinate();
    let elsewhere = |table: &[&Variable]| {
        let dimension = &table[0].name;
        let data = group.variables.iter();
        data.filter(|v| !v.is_coordinate() && !v.values.is_empty()).any(|v| v.dims.contains(dimension))
    };
    tables.retain(|t| !(alone(t) && elsewhere(t)));
    tables
}

/// The comment lines: group, attributes, then the meaning of each of `columns`.
fn comments(group: &Group, columns: &[&Variable]) -> String {
    let mut text = format!("# group: {}\n", group.name);
    for (name, value) in &group.attributes {
        let value = match value {
            Attribute::Text(text) => text.replace(['\n', '\r'], " "),
            Attribute::Number(value) => number(*value),
            Attribute::Integer(value) => value.to_string(),
        };
        let _ = writeln!(text, "# {name}: {value}");
    }
    for variable in columns {
        let _ = writeln!(text, "# {}: {}", heading(variable), variable.long_name);
    }
    text
}

fn heading(variable: &Variable) -> String {
    format!("{} [{}]", variable.name, variable.units)
}

fn scalar_table(group: &Group, scalars: &[&Variable]) -> String {
    let mut text = comments(group, &[]);
    text.push_str("name,value,units,description\n");
    for variable in scalars {
        let values: Vec<_> = variable.values.iter().map(|&v| number(v)).collect();
        let description = cell(&variable.long_name);
        let _ =
            writeln!(text, "{},{},{},{description}", variable.name, values.join(" "), cell(&variable.units));
    }
    text
}

/// One row per combination of the coordinates, slowest dimension first; one column per dimension, then per variable.
fn long_table(group: &Group, members: &[&Variable]) -> String {
    let shape = members[0].values.shape();
    let axes: Vec<Axis> = members[0]
        .dims
        .iter()
        .zip(shape)
        .map(|(dimension, &length)| Axis::new(group, dimension, length))
        .collect();
    let data: Vec<_> = members.iter().copied().filter(|v| !v.is_coordinate()).collect();
    let described = axes.iter().filter_map(|a| a.variable).chain(data.iter().copied());
    let mut text = comments(group, &described.collect::<Vec<_>>());
    let headings = axes.iter().map(|a| a.heading.clone()).chain(data.iter().map(|v| heading(v)));
    text.push_str(&headings.map(|h| cell(&h)).collect::<Vec<_>>().join(","));
    text.push('\n');
    // Iterators run in row-major order, whatever the memory order.
    let mut columns: Vec<_> = data.iter().map(|v| v.values.iter()).collect();
    for index in ndarray::indices(shape) {
        for (position, (axis, i)) in axes.iter().zip(index.slice()).enumerate() {
            let comma = if position == 0 { "" } else { "," };
            let _ = write!(text, "{comma}{}", number(axis.values[*i]));
        }
        for column in &mut columns {
            let _ = write!(text, ",{}", number(column.next().copied().unwrap_or(f64::NAN)));
        }
        text.push('\n');
    }
    text
}

fn matrix(group: &Group, field: &Variable) -> String {
    let shape = field.values.shape();
    let slow = Axis::new(group, &field.dims[0], shape[0]);
    let fast = Axis::new(group, &field.dims[1], shape[1]);
    let mut text = comments(group, &[field]);
    let _ = writeln!(text, "# first row: {}", fast.heading);
    let _ = writeln!(text, "# first column: {}", slow.heading);
    text.push_str(&cell(&format!("{} \\ {}", slow.heading, fast.heading)));
    let row = |text: &mut String, values: &mut dyn Iterator<Item = f64>| {
        for value in values {
            let _ = write!(text, ",{}", number(value));
        }
        text.push('\n');
    };
    row(&mut text, &mut fast.values.iter().copied());
    let mut values = field.values.iter().copied();
    for &coordinate in &slow.values {
        text.push_str(&number(coordinate));
        row(&mut text, &mut values.by_ref().take(shape[1]));
    }
    text
}

/// The values along one dimension: its coordinate, or 0, 1, 2 … where the group has none.
struct Axis<'a> {
    heading: String,
    values: Vec<f64>,
    variable: Option<&'a Variable>,
}

impl<'a> Axis<'a> {
    fn new(group: &'a Group, dimension: &str, length: usize) -> Self {
        let coordinate = group.get(dimension).filter(|v| v.is_coordinate() && v.values.len() == length);
        match coordinate {
            Some(variable) => {
                Self { heading: heading(variable), values: variable.to_vec(), variable: Some(variable) }
            }
            None => Self {
                heading: format!("{dimension} [index]"),
                values: (0..length).map(|i| i as f64).collect(),
                variable: None,
            },
        }
    }
}

/// The shortest decimal that reads back to the same bits, with an exponent where it is the shorter.
fn number(value: f64) -> String {
    let size = value.abs();
    if value.is_nan() {
        "NaN".to_owned()
    } else if value.is_infinite() {
        if value > 0.0 { "Inf" } else { "-Inf" }.to_owned()
    } else if size == 0.0 || (1e-4..1e15).contains(&size) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Quotes a cell that holds a comma, a quote or a line break.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array2, arr1};

    fn rows(path: &Path) -> Vec<Vec<String>> {
        let text = std::fs::read_to_string(path).unwrap();
        text.lines()
            .filter(|l| !l.starts_with('#'))
            .map(|l| l.split(',').map(str::to_owned).collect())
            .collect()
    }

    fn names(paths: &[PathBuf]) -> Vec<String> {
        let name = |p: &PathBuf| p.file_name().unwrap().to_str().unwrap().to_owned();
        paths.iter().map(name).collect()
    }

    #[test]
    fn a_curve_and_its_scalars_read_back_bit_for_bit() {
        let dir = tempfile::tempdir().unwrap();
        let speed = [0.1 + 0.2, 1e-9, 1.0 / 3.0];
        let down = [1e300, -4.9e-324, f64::INFINITY];
        let group = Group::new("critical_speed")
            .coordinate("speed", &speed, "m s-1", "Train speed")
            .variable("max_down", &["speed"], arr1(&down).into_dyn(), "m", "Largest deflection")
            .scalar("amplification", 3.5, "1", "Dynamic over static, of the rail");
        let paths = write(&group, dir.path(), true).unwrap();
        assert_eq!(names(&paths), ["critical_speed_scalars.csv", "critical_speed.csv"]);
        let table = rows(&paths[1]);
        assert_eq!(table[0], ["speed [m s-1]", "max_down [m]"]);
        for (row, (s, d)) in table[1..].iter().zip(speed.iter().zip(&down)) {
            assert_eq!(row[0].parse::<f64>().unwrap().to_bits(), s.to_bits());
            assert_eq!(row[1].parse::<f64>().unwrap().to_bits(), d.to_bits());
        }
        let scalars = std::fs::read_to_string(&paths[0]).unwrap();
        assert!(scalars.ends_with("amplification,3.5,1,\"Dynamic over static, of the rail\"\n"));
    }

    #[test]
    fn each_set_of_dimensions_has_its_table_and_no_coordinate_a_needless_one() {
        let dir = tempfile::tempdir().unwrap();
        let ground = Array2::from_shape_fn((2, 3), |(i, j)| (10 * i + j) as f64).into_dyn();
        let group = Group::new("receptance")
            .coordinate("frequency", &[1.0, 2.0, 3.0], "Hz", "Frequency")
            .variable("rail_re", &["frequency"], arr1(&[4.0, 5.0, 6.0]).into_dyn(), "m N-1", "Rail")
            .coordinate("receiver", &[8.0, 16.0], "m", "Distance")
            .variable("ground_re", &["receiver", "frequency"], ground, "m N-1", "Ground");
        let paths = write(&group, dir.path(), true).unwrap();
        assert_eq!(names(&paths), ["receptance_frequency.csv", "receptance_receiver_frequency.csv"]);
        let long = rows(&paths[1]);
        assert_eq!(long.len(), 7);
        assert_eq!(long[6], ["16", "3", "12"]);
    }

    #[test]
    fn a_coordinate_whose_fields_are_empty_is_not_lost() {
        let dir = tempfile::tempdir().unwrap();
        let group = Group::new("dispersion")
            .coordinate("frequency", &[3.0], "Hz", "Frequency")
            .coordinate("mode", &[], "1", "No mode found")
            .variable("c", &["frequency", "mode"], Array2::zeros((1, 0)).into_dyn(), "m s-1", "c");
        let paths = write(&group, dir.path(), true).unwrap();
        assert_eq!(names(&paths)[0], "dispersion_frequency.csv");
        assert_eq!(rows(&paths[0]), [["frequency [Hz]"], ["3"]]);
    }

    #[test]
    fn a_large_field_is_a_matrix() {
        let dir = tempfile::tempdir().unwrap();
        let (ny, nx) = (401, 500);
        let axis = |n: usize| (0..n).map(|i| 0.25 * i as f64).collect::<Vec<_>>();
        let field = Array2::from_shape_fn((ny, nx), |(i, j)| i as f64 / (j as f64 + 1.0));
        let group = Group::new("contour")
            .coordinate("x", &axis(nx), "m", "Along the track")
            .coordinate("y", &axis(ny), "m", "Across the track")
            .variable("u_z", &["y", "x"], field.clone().into_dyn(), "m", "Down");
        let paths = write(&group, dir.path(), true).unwrap();
        assert_eq!(names(&paths), ["contour_u_z_matrix.csv"]);
        let table = rows(&paths[0]);
        assert_eq!((table.len(), table[0].len()), (ny + 1, nx + 1));
        assert_eq!(table[0][0], "y [m] \\ x [m]");
        assert_eq!(table[5][0], "1");
        assert_eq!(table[5][7].parse::<f64>().unwrap(), field[[4, 6]]);
        // and none of its coordinates a table, where it is not asked for
        assert_eq!(write(&group, &dir.path().join("none"), false).unwrap(), Vec::<PathBuf>::new());
    }
}
