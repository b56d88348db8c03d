//! Groups of arrays, answers and concerns as Python objects.

use groundwave::Concern;
use groundwave::dataset::{Attribute, Group, Variable};
use groundwave::study::{Answer, Outcome};
use numpy::PyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Attributes by name.
pub fn attributes<'py>(py: Python<'py>, all: &[(String, Attribute)]) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (name, attribute) in all {
        match attribute {
            Attribute::Text(text) => dict.set_item(name, text)?,
            Attribute::Number(number) => dict.set_item(name, number)?,
            Attribute::Integer(number) => dict.set_item(name, number)?,
        }
    }
    Ok(dict)
}

/// `{name, dims, values, units, long_name}`, the values without a copy.
fn variable<'py>(py: Python<'py>, variable: Variable) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("name", variable.name)?;
    dict.set_item("dims", variable.dims)?;
    dict.set_item("values", PyArray::from_owned_array(py, variable.values))?;
    dict.set_item("units", variable.units)?;
    dict.set_item("long_name", variable.long_name)?;
    Ok(dict)
}

fn answer<'py>(py: Python<'py>, answer: Answer) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("key", answer.key)?;
    dict.set_item("what", answer.what)?;
    dict.set_item("value", answer.value)?;
    dict.set_item("unit", answer.unit)?;
    dict.set_item("shown", answer.shown)?;
    Ok(dict)
}

/// `(code, message, remedy)` of each.
pub fn concerns(all: &[Concern]) -> Vec<(&'static str, String, String)> {
    all.iter().map(|c| (c.code, c.message.clone(), c.remedy.clone())).collect()
}

/// `{name, variables, attributes, answers, concerns}`
fn outcome(py: Python<'_>, outcome: Outcome) -> PyResult<Bound<'_, PyDict>> {
    let Outcome { group: Group { name, variables, attributes: said }, answers, concerns: doubts, .. } =
        outcome;
    let dict = PyDict::new(py);
    dict.set_item("name", name)?;
    let variables = variables.into_iter().map(|v| variable(py, v)).collect::<PyResult<Vec<_>>>()?;
    dict.set_item("variables", PyList::new(py, variables)?)?;
    dict.set_item("attributes", attributes(py, &said)?)?;
    let answers = answers.into_iter().map(|a| answer(py, a)).collect::<PyResult<Vec<_>>>()?;
    dict.set_item("answers", PyList::new(py, answers)?)?;
    dict.set_item("concerns", concerns(&doubts))?;
    Ok(dict)
}

/// The groups of all `outcomes`.
pub fn groups<'py>(py: Python<'py>, outcomes: Vec<(&'static str, Outcome)>) -> PyResult<Bound<'py, PyList>> {
    let groups = outcomes.into_iter().map(|(_, one)| outcome(py, one)).collect::<PyResult<Vec<_>>>()?;
    PyList::new(py, groups)
}
