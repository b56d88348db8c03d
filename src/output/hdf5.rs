//! `results.h5`: one group per study, coordinates as HDF5 dimension scales, as h5py, xarray and MATLAB expect them.
//!
//! The only file that knows the HDF5 library.

use super::OutputError;
use crate::dataset::{Attribute, Dataset, Group, Variable};
use ::hdf5::format::messages::filter::apply_filters;
use ::hdf5::types::VarLenUnicode;
use ::hdf5::{FilterPipeline, H5Dataset, H5File, H5Group, Hdf5Error};
use ndarray::ArrayD;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

/// Arrays above this size are chunked and deflated [values]: 64 kB; below, the index costs more than it saves.
const COMPRESS_ABOVE: usize = 8192;
/// Of deflation.
const LEVEL: u32 = 1;
/// Largest chunk [values]: 512 kB, so that a reader of one row need not inflate the whole field.
const CHUNK: usize = 65_536;

/// Writes `dataset` to `path`, replacing an existing file.
///
/// Every [`Group`] becomes an HDF5 group and every variable a dataset of 64-bit floats with the attributes `units` and
/// `long_name`. A coordinate is a dimension scale (`CLASS`, `NAME`) and is attached to each axis that bears its name
/// (`DIMENSION_LIST`), so that `xarray.open_dataset(path, group = "critical_speed", engine = "h5netcdf")` finds the
/// coordinates by itself; x, y and z say their `axis`, z that it is `positive` down, as the CF conventions want. The file is a
/// NetCDF-4 file. Where a variable has gaps, NaN stands there and is its `_FillValue`. The order of creation is
/// tracked, without which netCDF4 does not open a file to append. Arrays above 64 kB are chunked, shuffled and deflated at level 1.
///
/// # Errors
/// [`OutputError::Dimension`] for a dimension without a coordinate of the same length; [`OutputError::Hdf5`] and
/// [`OutputError::Write`] if the file cannot be written.
///
/// Accuracy: values are stored bit for bit (`values_and_units_read_back_bit_for_bit`; `tests/python/check_hdf5.py`
/// compares with h5py and xarray).
pub fn write(dataset: &Dataset, path: &Path) -> Result<(), OutputError> {
    for group in &dataset.groups {
        check_dimensions(group, path)?;
    }
    let failed = |object: &str| {
        let object = object.to_owned();
        move |source: Hdf5Error| OutputError::Hdf5 { path: path.to_owned(), object, source: Box::new(source) }
    };
    // netCDF appends only to files that know the order in which things were created
    let file = H5File::options().track_order(true).create(path).map_err(failed("the file"))?;
    write_attributes(&file.root_group(), &dataset.attributes).map_err(failed("the root attributes"))?;
    for group in &dataset.groups {
        write_group(&file, group).map_err(failed(&format!("the group {}", group.name)))?;
    }
    file.close().map_err(failed("the file"))
}

/// The text attribute `name` of the file at `path`.
///
/// # Errors
/// What the library says if the file or the attribute cannot be read.
pub fn read_text_attribute(path: &Path, name: &str) -> Result<String, String> {
    let file = H5File::open(path).map_err(|e| e.to_string())?;
    file.attr_string(name).map_err(|e| format!("no attribute {name}: {e}"))
}

/// The groups of the file at `path`, which [`write`] wrote, without their attributes.
///
/// # Errors
/// What the library says if the file cannot be read; a variable that does not say its dimensions, as files before this version.
pub fn read(path: &Path) -> Result<Vec<Group>, String> {
    let file = H5File::open(path).map_err(|e| e.to_string())?;
    let told = |e: Hdf5Error| e.to_string();
    let mut groups = Vec::new();
    for name in file.root_group().group_names().map_err(told)? {
        let place = file.root_group().group(&name).map_err(told)?;
        let mut group = Group::new(&name);
        for variable in place.dataset_names().map_err(told)? {
            let short = variable.rsplit('/').next().unwrap_or(&variable);
            let stored = file.dataset(&format!("{name}/{short}")).map_err(told)?;
            let text = |key: &str| {
                stored.attr(key).and_then(|a| a.read_string()).map_err(|e| {
                    format!("{name}/{short}: no {key} ({e}): an earlier version wrote it, run the case again")
                })
            };
            let dims: Vec<String> = text("dimensions")?.split_whitespace().map(str::to_owned).collect();
            let values = stored.read_raw::<f64>().map_err(told)?;
            let values = ArrayD::from_shape_vec(stored.shape(), values).map_err(|e| e.to_string())?;
            group.variables.push(Variable {
                name: short.to_owned(),
                dims,
                values,
                units: text("units")?,
                long_name: text("long_name")?,
            });
        }
        groups.push(group);
    }
    Ok(groups)
}

fn check_dimensions(group: &Group, path: &Path) -> Result<(), OutputError> {
    for variable in &group.variables {
        for (dimension, &found) in variable.dims.iter().zip(variable.values.shape()) {
            let expected = group.get(dimension).filter(|v| v.is_coordinate()).map(|v| v.values.len());
            if expected != Some(found) {
                return Err(OutputError::Dimension {
                    path: path.to_owned(),
                    group: group.name.clone(),
                    variable: variable.name.clone(),
                    dimension: dimension.clone(),
                    found,
                    expected,
                });
            }
        }
    }
    Ok(())
}

fn write_group(file: &H5File, group: &Group) -> Result<(), Hdf5Error> {
    let place = file.create_group(&group.name)?;
    write_attributes(&place, &group.attributes)?;
    let mut scales = BTreeMap::new();
    let (coordinates, data): (Vec<_>, Vec<_>) = group.variables.iter().partition(|v| v.is_coordinate());
    for coordinate in coordinates {
        let stored = write_variable(&place, coordinate)?;
        stored.set_scale(Some(&coordinate.name))?;
        scales.insert(coordinate.name.as_str(), stored);
    }
    for variable in data {
        let stored = write_variable(&place, variable)?;
        for (axis, dimension) in variable.dims.iter().enumerate() {
            // `check_dimensions` has seen to it that the scale exists.
            if let Some(scale) = scales.get(dimension.as_str()) {
                stored.attach_scale(axis, scale)?;
            }
        }
    }
    Ok(())
}

fn write_variable(place: &H5Group, variable: &Variable) -> Result<H5Dataset, Hdf5Error> {
    let shape = variable.values.shape();
    let builder = place.new_dataset::<f64>();
    let builder = if shape.is_empty() {
        builder.scalar()
    } else if variable.values.len() > COMPRESS_ABOVE {
        builder.shape(shape).chunk(&chunk_of(shape)).shuffle_deflate(LEVEL)
    } else {
        builder.shape(shape)
    };
    let values = variable.values.as_standard_layout();
    let values = values.as_slice().unwrap_or_default();
    let gaps = values.iter().any(|v| v.is_nan());
    let builder = if gaps { builder.fill_value(f64::NAN) } else { builder };
    let stored = builder.create(&variable.name)?;
    // An empty array owns no storage that could be written to.
    if values.len() > COMPRESS_ABOVE {
        write_chunks(&stored, values, shape)?;
    } else if !values.is_empty() {
        stored.write_raw(values)?;
    }
    let dimensions = variable.dims.join(" ");
    let mut texts = vec![
        ("units", variable.units.as_str()),
        ("long_name", &variable.long_name),
        ("dimensions", &dimensions),
    ];
    if variable.is_coordinate() {
        match variable.name.as_str() {
            "x" => texts.push(("axis", "X")),
            "y" => texts.push(("axis", "Y")),
            "z" => texts.extend([("axis", "Z"), ("positive", "down")]),
            _ => {}
        }
    }
    for (name, text) in texts {
        let attribute = stored.new_attr::<VarLenUnicode>().shape(()).create(name)?;
        attribute.write_string(text)?;
    }
    if gaps {
        stored.new_attr::<f64>().shape(()).create("_FillValue")?.write_numeric(&f64::NAN)?;
    }
    Ok(stored)
}

/// Writes `values` of `shape` in chunks, a few at a time deflated on all threads: what is not yet written takes no second place.
fn write_chunks(stored: &H5Dataset, values: &[f64], shape: &[usize]) -> Result<(), Hdf5Error> {
    const AT_ONCE: usize = 16;
    let chunk = chunk_of(shape);
    // a chunk is whole along the axes behind the one that is cut, single along those before: a run of values
    let cut = chunk.iter().position(|part| *part > 1).unwrap_or(shape.len() - 1);
    let (run, size): (usize, usize) = (shape[cut..].iter().product(), chunk.iter().product());
    let chunks: Vec<&[f64]> = values.chunks(run).flat_map(|run| run.chunks(size)).collect();
    let pipeline = FilterPipeline::shuffle_deflate(size_of::<f64>() as u32, LEVEL);
    for (block, chunks) in chunks.chunks(AT_ONCE).enumerate() {
        let filter = |values: &&[f64]| {
            let mut bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
            // the last of a run is stored whole too
            bytes.resize(size_of::<f64>() * size, 0);
            apply_filters(&pipeline, &bytes)
        };
        let filtered: Vec<Vec<u8>> = chunks.par_iter().map(filter).collect::<Result<_, _>>()?;
        for (i, bytes) in filtered.iter().enumerate() {
            stored.write_chunk_raw(AT_ONCE * block + i, bytes, 0)?;
        }
    }
    Ok(())
}

/// Whole fastest axes as long as they fit into [`CHUNK`] values, then a part of the next, then single rows.
fn chunk_of(shape: &[usize]) -> Vec<usize> {
    let mut room = CHUNK;
    let mut chunk: Vec<usize> = shape
        .iter()
        .rev()
        .map(|&length| {
            let part = length.min(room).max(1);
            room /= part;
            part
        })
        .collect();
    chunk.reverse();
    chunk
}

fn write_attributes(place: &H5Group, attributes: &[(String, Attribute)]) -> Result<(), Hdf5Error> {
    for (name, value) in attributes {
        match value {
            Attribute::Text(text) => place.set_attr_string(name, text)?,
            Attribute::Number(number) => place.set_attr_numeric(name, number)?,
            Attribute::Integer(integer) => place.set_attr_numeric(name, integer)?,
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array2, Array3};

    fn sample() -> Vec<Group> {
        let speed = [10.0, 20.0, 30.0];
        let x: Vec<f64> = (0..5000).map(|i| 0.1 * f64::from(i)).collect();
        let rail = Array2::from_shape_fn((3, 5000), |(i, j)| (i as f64 + 0.3) / (j as f64 + 7.0));
        // of every speed two chunks, of which the second is not full
        let wide = Array3::from_shape_fn((3, 70, 1000), |(n, i, j)| {
            (n as f64 - 1.7) * (i as f64 + 0.1) / (j as f64 + 0.3)
        });
        vec![
            Group::new("track_response")
                .coordinate("speed", &speed, "m s-1", "Train speed")
                .coordinate("x", &x, "m", "Distance ahead of the load")
                .variable("rail", &["speed", "x"], rail.into_dyn(), "m", "Rail, positive down")
                .scalar("critical_speed", 136.7, "m s-1", "Critical speed")
                .attribute("damping", 0.03),
            Group::new("dispersion").coordinate("mode", &[], "1", "No mode found"),
            Group::new("contour")
                .coordinate("speed", &speed, "m s-1", "Train speed")
                .coordinate("y", &x[..70], "m", "Distance beside the track")
                .coordinate("x", &x[..1000], "m", "Distance ahead of the load")
                .variable("u_z", &["speed", "y", "x"], wide.into_dyn(), "m", "Ground"),
        ]
    }

    fn dataset(groups: &[Group]) -> Dataset<'_> {
        let attributes = vec![
            ("version".into(), "0.1.0".into()),
            ("case".into(), "β, ω\n".repeat(20_000).into()),
            ("seed".into(), Attribute::Integer(-7)),
        ];
        Dataset { attributes, groups: groups.iter().collect() }
    }

    #[test]
    fn values_and_units_read_back_bit_for_bit() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("results.h5");
        let groups = sample();
        write(&dataset(&groups), &path).unwrap();
        let file = H5File::open(&path).unwrap();
        assert_eq!(file.attr_string("version").unwrap(), "0.1.0");
        assert_eq!(file.attr_string("case").unwrap().len(), 7 * 20_000);
        for group in &groups {
            for variable in &group.variables {
                let stored = file.dataset(&format!("{}/{}", group.name, variable.name)).unwrap();
                assert_eq!(stored.shape(), variable.values.shape());
                assert_eq!(stored.read_raw::<f64>().unwrap(), variable.to_vec());
                let units = stored.attr("units").unwrap().read_string().unwrap();
                assert_eq!(units, variable.units);
            }
        }
        let rail = file.dataset("track_response/rail").unwrap();
        assert!(rail.is_chunked());
        assert!(rail.attr("DIMENSION_LIST").is_ok());
        let x = file.dataset("track_response/x").unwrap();
        assert_eq!(x.attr("CLASS").unwrap().read_string().unwrap(), "DIMENSION_SCALE");
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn what_was_written_is_read_again() {
        let dir = tempfile::tempdir().unwrap();
        let (path, groups) = (dir.path().join("a.h5"), sample());
        write(&dataset(&groups), &path).unwrap();
        let mut read = read(&path).unwrap();
        assert_eq!(read.len(), groups.len());
        read.sort_by(|a, b| a.name.cmp(&b.name));
        for group in &groups {
            let found = read.iter().find(|g| g.name == group.name).unwrap();
            assert_eq!(found.variables.len(), group.variables.len());
            assert!(group.variables.iter().all(|v| found.get(&v.name) == Some(v)));
        }
    }

    #[test]
    fn gaps_are_fill_values() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("results.h5");
        let group = Group::new("dispersion")
            .coordinate("mode", &[0.0, 1.0], "1", "number")
            .variable("c", &["mode"], ndarray::arr1(&[80.0, f64::NAN]).into_dyn(), "m s-1", "phase velocity")
            .variable("found", &["mode"], ndarray::arr1(&[1.0, 0.0]).into_dyn(), "1", "found");
        write(&Dataset { groups: vec![&group], ..Dataset::default() }, &path).unwrap();
        let file = H5File::open(&path).unwrap();
        let fill = |name: &str| {
            let stored = file.dataset(&format!("dispersion/{name}")).unwrap();
            stored.attr("_FillValue").and_then(|a| a.read_numeric::<f64>())
        };
        assert!(fill("c").unwrap().is_nan());
        assert!(fill("found").is_err());
        // tracked, without which netCDF4 does not append
        let place = file.root_group().group("dispersion").unwrap();
        assert!(
            place.link_creation_order().unwrap().is_indexed()
                && place.attr_creation_order().unwrap().is_indexed()
        );
    }

    #[test]
    fn a_dimension_without_coordinate_is_refused() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("results.h5");
        let values = ndarray::arr1(&[1.0, 2.0]).into_dyn();
        let group = Group::new("g").coordinate("x", &[0.0], "m", "x").variable("u", &["x"], values, "m", "u");
        let dataset = Dataset { groups: vec![&group], ..Dataset::default() };
        let error = write(&dataset, &path).unwrap_err();
        assert!(error.to_string().contains("`x` has 2 values, the coordinate has 1"), "{error}");
        assert!(!path.exists());
    }

    #[test]
    fn chunks_stay_below_half_a_megabyte() {
        assert_eq!(chunk_of(&[1024, 1024]), [64, 1024]);
        assert_eq!(chunk_of(&[200_000]), [65_536]);
        assert_eq!(chunk_of(&[3, 0]), [3, 1]);
    }
}
