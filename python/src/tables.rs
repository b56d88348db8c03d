//! `[soil]`, `[foundation]`, `[track]`, `[train]` by themselves.

use crate::case::beside;
use crate::error;
use crate::outcome::concerns;
use groundwave::case::Tables;
use groundwave::soil::{Base, Material};
use groundwave::track::Layout;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// `{thickness, shear_speed, pressure_speed, rayleigh_speed, density, poisson, loss_factor}`
fn layer<'py>(py: Python<'py>, thickness: f64, material: &Material) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("thickness", thickness)?;
    dict.set_item("shear_speed", material.c_s())?;
    dict.set_item("pressure_speed", material.c_p())?;
    dict.set_item("rayleigh_speed", material.rayleigh_speed())?;
    dict.set_item("density", material.density())?;
    dict.set_item("poisson", material.poisson())?;
    dict.set_item("loss_factor", material.loss_factor())?;
    Ok(dict)
}

/// What the tables in `text` stand for, checked: ``layers`` and ``rigid`` of the soil, ``layout`` of the track, ``positions`` and
/// ``loads`` of the train's axles.
#[pyfunction]
#[pyo3(signature = (text, folder, files))]
pub fn tables<'py>(
    py: Python<'py>,
    text: &str,
    folder: PathBuf,
    files: BTreeMap<String, String>,
) -> PyResult<Bound<'py, PyDict>> {
    let tables = Tables::parse(text, "tables", &beside(&folder, &files)).map_err(error::of_case)?;
    let dict = PyDict::new(py);
    if let Some(ground) = &tables.ground {
        let profile = &ground.profile;
        let mut layers = Vec::new();
        for l in profile.layers() {
            layers.push(layer(py, l.thickness, &l.material)?);
        }
        if let Base::HalfSpace(material) = profile.base() {
            layers.push(layer(py, f64::INFINITY, &material)?);
        }
        dict.set_item("layers", layers)?;
        dict.set_item("rigid", matches!(profile.base(), Base::Rigid))?;
        dict.set_item("solver", ground.solver.name())?;
    }
    if let Some(layout) = &tables.layout {
        let name = match layout {
            Layout::Continuous(_) => "continuous",
            Layout::Discrete(_) => "discrete",
            Layout::Varying(_) => "varying",
        };
        dict.set_item("layout", name)?;
    }
    if let Some(train) = &tables.train {
        dict.set_item("positions", train.axles().iter().map(|axle| axle.position).collect::<Vec<_>>())?;
        dict.set_item("loads", train.axles().iter().map(|axle| axle.load).collect::<Vec<_>>())?;
    }
    dict.set_item("concerns", concerns(&tables.concerns))?;
    Ok(dict)
}
