//! Dictionaries, arrays and slices of Python as the TOML of a case file.

use ::toml::{Table, Value};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PySlice, PyString};

/// The text of a case file, or of tables of one, that says what `table` does.
///
/// None leaves a key out, ``slice(a, b, step)`` is the range ``{from, to, step}``, an underscore behind a key, as in ``from_``, is
/// no part of it; arrays are lists.
#[pyfunction]
pub fn toml(table: &Bound<'_, PyDict>) -> PyResult<String> {
    Ok(table_of(table, "")?.to_string())
}

fn table_of(dict: &Bound<'_, PyDict>, path: &str) -> PyResult<Table> {
    let mut table = Table::new();
    for (key, item) in dict.iter() {
        let key: String =
            key.extract().map_err(|_| PyTypeError::new_err(format!("{path}: the key {key} is no text")))?;
        let key = key.trim_end_matches('_').to_owned();
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        if !item.is_none() {
            table.insert(key, value(&item, &path)?);
        }
    }
    Ok(table)
}

fn value(object: &Bound<'_, PyAny>, path: &str) -> PyResult<Value> {
    let unfit = |e: PyErr| PyValueError::new_err(format!("{path}: {e}"));
    if object.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(object.extract()?));
    }
    if object.is_instance_of::<PyInt>() {
        return object.extract().map(Value::Integer).map_err(unfit);
    }
    if object.is_instance_of::<PyFloat>() {
        return Ok(Value::Float(object.extract()?));
    }
    if object.is_instance_of::<PyString>() {
        return object.extract().map(Value::String).map_err(unfit);
    }
    if let Ok(dict) = object.cast::<PyDict>() {
        return table_of(dict, path).map(Value::Table);
    }
    if object.is_instance_of::<PySlice>() {
        let range = PyDict::new(object.py());
        for (key, end) in [("from", "start"), ("to", "stop"), ("step", "step")] {
            range.set_item(key, object.getattr(end)?)?;
        }
        return table_of(&range, path).map(Value::Table);
    }
    // Soil, Track, Train, Springs; NumPy; xarray and pandas
    if let Ok(table) = object.getattr("table") {
        return value(&table, path);
    }
    for list in ["tolist", "to_numpy"] {
        if let Ok(method) = object.getattr(list) {
            return value(&method.call0()?, path);
        }
    }
    let Ok(items) = object.try_iter() else {
        let kind = object.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "{path}: a {kind} is neither a number, a text, a list nor a dictionary"
        )));
    };
    let items = items.enumerate().map(|(i, item)| value(&item?, &format!("{path}[{i}]")));
    Ok(Value::Array(items.collect::<PyResult<_>>()?))
}
