//! groundwave for Python: cases, tables and results as Python objects and NumPy arrays. No physics.

mod case;
mod error;
mod outcome;
mod pool;
mod tables;
mod text;

use groundwave::case::library::ENTRIES;
use pyo3::prelude::*;

/// Names of the library: `(kind, name, title, source)` of each.
#[pyfunction]
fn library() -> Vec<(&'static str, &'static str, String, String)> {
    let said = |entry: &groundwave::case::library::Entry, key| entry.text_of(key).unwrap_or_default();
    ENTRIES
        .iter()
        .map(|entry| (entry.kind, entry.name, said(entry, "title"), said(entry, "source")))
        .collect()
}

/// What an entry of the library holds, and what follows from it, in lines.
#[pyfunction]
fn show(name: &str) -> PyResult<String> {
    groundwave::case::show(name).map_err(error::of_case)
}

/// The JSON schema of case files.
#[pyfunction]
fn schema() -> String {
    serde_json::json!(groundwave::case::json_schema()).to_string()
}

/// Bindings of groundwave; the package `groundwave` is what to use.
#[pymodule]
#[pyo3(name = "_core")]
fn core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("CaseError", module.py().get_type::<error::CaseError>())?;
    module.add("ComputationError", module.py().get_type::<error::ComputationError>())?;
    module.add_class::<case::Case>()?;
    module.add_function(wrap_pyfunction!(case::gather, module)?)?;
    module.add_function(wrap_pyfunction!(text::toml, module)?)?;
    module.add_function(wrap_pyfunction!(tables::tables, module)?)?;
    module.add_function(wrap_pyfunction!(library, module)?)?;
    module.add_function(wrap_pyfunction!(show, module)?)?;
    module.add_function(wrap_pyfunction!(schema, module)?)
}
