//! Fields over the ground for ParaView: VTK's XML files of regular (`.vti`) and of rectilinear grids (`.vtr`).

use super::markup::escape;
use super::{OutputError, save};
use crate::dataset::{Group, Variable};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::path::Path;

/// Writes `<group>_<variable>.vti` into the folder `dir`, which must exist, for every variable of `group` over (y, x) or (z, y, x).
///
/// What lies along further dimensions is an array each, called after its coordinates to four decimals (`u_z_speed_137`), of 64-bit floats in the
/// units of the variable; z is the depth, positive down. Where an axis has no equal steps the file is a `.vtr`.
///
/// # Errors
/// [`OutputError::Write`] if a file cannot be written.
///
/// Accuracy: values are stored bit for bit (`tests/python/check_vti.py` compares with VTK and h5py).
pub fn write(group: &Group, dir: &Path) -> Result<(), OutputError> {
    for variable in &group.variables {
        let spatial =
            variable.dims.iter().rev().zip(["x", "y", "z"]).take_while(|(own, axis)| own == axis).count();
        let axes: Vec<&Variable> =
            variable.dims.iter().rev().take(spatial).filter_map(|name| group.get(name)).collect();
        if axes.len() < 2 || axes.iter().any(|axis| axis.values.is_empty()) {
            continue;
        }
        let axes: Vec<Vec<f64>> = axes.into_iter().map(Variable::to_vec).chain([vec![0.0]]).take(3).collect();
        let steps: Option<Vec<f64>> = axes.iter().map(|axis| equal_step(axis)).collect();
        let kind = if steps.is_some() { "vti" } else { "vtr" };
        let text = grid(&axes, steps.as_deref(), &arrays(group, variable, spatial));
        save(&dir.join(format!("{}_{}.{kind}", group.name, variable.name)), text.as_bytes())?;
    }
    Ok(())
}

/// The step of an axis, if all are equal to rounding; 1 of a single value.
fn equal_step(axis: &[f64]) -> Option<f64> {
    let (first, last) = (axis[0], axis[axis.len() - 1]);
    let step = if axis.len() > 1 { (last - first) / (axis.len() - 1) as f64 } else { 1.0 };
    let even = axis.iter().enumerate().all(|(i, v)| (v - first - i as f64 * step).abs() <= 1e-9 * step.abs());
    (even && step > 0.0).then_some(step)
}

/// The fields of `variable` over its `spatial` last dimensions, as data arrays.
fn arrays(group: &Group, variable: &Variable, spatial: usize) -> String {
    let shape = variable.values.shape();
    let (outer, inner) = shape.split_at(shape.len() - spatial);
    let values = variable.to_vec();
    let fields = values.chunks(inner.iter().product::<usize>().max(1)).enumerate();
    let named = fields.map(|(index, field)| {
        // place along each further dimension, the last one fastest
        let mut rest = index;
        let mut names: Vec<String> = Vec::new();
        for (name, length) in variable.dims.iter().zip(outer).rev() {
            let at = group.get(name).map_or(f64::NAN, |along| along.values[[rest % length]]);
            names.push(format!("_{name}_{}", (1e4 * at).round() / 1e4));
            rest /= length;
        }
        names.push(variable.name.clone());
        array(&names.into_iter().rev().collect::<String>(), field)
    });
    named.collect()
}

/// Eight bytes with the length, then the values, little-endian, as base 64.
fn array(name: &str, values: &[f64]) -> String {
    let length = (8 * values.len() as u64).to_le_bytes();
    let bytes: Vec<u8> = length.into_iter().chain(values.iter().flat_map(|v| v.to_le_bytes())).collect();
    let (name, text) = (escape(name), BASE64_STANDARD.encode(bytes));
    format!("<DataArray type=\"Float64\" Name=\"{name}\" format=\"binary\">{text}</DataArray>\n")
}

fn grid(axes: &[Vec<f64>], steps: Option<&[f64]>, arrays: &str) -> String {
    let joined = |numbers: &mut dyn Iterator<Item = String>| numbers.collect::<Vec<_>>().join(" ");
    let extent = joined(&mut axes.iter().map(|axis| format!("0 {}", axis.len() - 1)));
    let (kind, place, coordinates) = match steps {
        Some(steps) => {
            let origin = joined(&mut axes.iter().map(|axis| axis[0].to_string()));
            let spacing = joined(&mut steps.iter().map(f64::to_string));
            ("ImageData", format!(" Origin=\"{origin}\" Spacing=\"{spacing}\""), String::new())
        }
        None => {
            let along: String =
                ["x", "y", "z"].iter().zip(axes).map(|(name, axis)| array(name, axis)).collect();
            ("RectilinearGrid", String::new(), format!("<Coordinates>\n{along}</Coordinates>\n"))
        }
    };
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <{kind} WholeExtent=\"{extent}\"{place}>\n<Piece Extent=\"{extent}\">\n<PointData>\n{arrays}</PointData>\n{coordinates}\
         </Piece>\n</{kind}>\n</VTKFile>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array;

    #[test]
    fn fields_over_the_ground_become_grids() {
        let dir = tempfile::tempdir().unwrap();
        let field = Array::from_shape_fn((2, 2, 3), |(v, j, i)| (100 * v + 10 * j + i) as f64).into_dyn();
        let group = |y: &[f64]| {
            Group::new("contour")
                .coordinate("speed", &[68.5, 137.0], "m s-1", "speed")
                .coordinate("y", y, "m", "across")
                .coordinate("x", &[-1.0, -0.5, 0.0], "m", "along")
                .variable("u_z", &["speed", "y", "x"], field.clone(), "m", "displacement")
                .variable("period", &["speed"], Array::zeros(2).into_dyn(), "m", "no field")
        };
        write(&group(&[0.0, 3.0]), dir.path()).unwrap();
        let text = std::fs::read_to_string(dir.path().join("contour_u_z.vti")).unwrap();
        for part in [
            "WholeExtent=\"0 2 0 1 0 0\" Origin=\"-1 0 0\" Spacing=\"0.5 3 1\"",
            "u_z_speed_68.5",
            "u_z_speed_137",
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
        let packed =
            text.split("u_z_speed_137\" format=\"binary\">").nth(1).unwrap().split('<').next().unwrap();
        let bytes = BASE64_STANDARD.decode(packed).unwrap();
        assert_eq!(bytes[..8], 48u64.to_le_bytes());
        assert_eq!(bytes[48..], 112.0f64.to_le_bytes());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
        assert_eq!(equal_step(&[0.0, 1.0, 3.0]), None);
    }
}
