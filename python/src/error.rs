//! Errors of the library as Python exceptions.

use groundwave::case::{CaseError as Fault, FolderError, RunError, StudyFailed};
use groundwave::ensemble::EnsembleError;
use pyo3::exceptions::{PyFileExistsError, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;

pyo3::create_exception!(
    groundwave,
    CaseError,
    PyValueError,
    "A case, or a table of one, that cannot be right: nothing was computed.\n\n\
     Attributes\n----------\n\
     key : str\n    Path of the first faulty key, such as ``soil.layer[1].poisson``.\n\
     line : int or None\n    Its line in the text of the case, counted from 1.\n\
     found : str or None\n    What stands there.\n\
     help : str or None\n    What is allowed, and the nearest spelling.\n\
     faults : list of dict\n    Every fault, each with `file`, `message` and the above."
);
pyo3::create_exception!(
    groundwave,
    ComputationError,
    PyRuntimeError,
    "A study that has no answer: the message says why, and what to change.\n\n\
     Attributes\n----------\n\
     study : str\n    Its name."
);

/// One fault in parts.
struct Parts {
    file: String,
    key: String,
    line: Option<usize>,
    found: Option<String>,
    message: String,
    help: Option<String>,
}

impl From<Fault> for Parts {
    fn from(fault: Fault) -> Self {
        let message = fault.to_string();
        match fault {
            Fault::Invalid { key, text, span, help, .. } => {
                let place = span.map(|span| (span.offset(), span.len()));
                let line = place.map(|(start, _)| 1 + text.inner()[..start].matches('\n').count());
                let found = place.and_then(|(start, length)| text.inner().get(start..start + length));
                let first = found.and_then(|found| found.lines().next()).map(str::to_owned);
                Self { file: text.name().to_owned(), key, line, found: first, message, help }
            }
            Fault::Read { path, help, .. } => Self {
                file: path.display().to_string(),
                key: String::new(),
                line: None,
                found: None,
                message,
                help: Some(help),
            },
            Fault::Several { .. } => {
                Self { file: String::new(), key: String::new(), line: None, found: None, message, help: None }
            }
        }
    }
}

impl Parts {
    /// "case.toml:4: soil.layer[1].poisson: … (help)"
    fn told(&self) -> String {
        let line = self.line.map_or(String::new(), |line| format!(":{line}"));
        let help = self.help.as_ref().map_or(String::new(), |help| format!(" ({help})"));
        format!("{}{line}: {}{help}", self.file, self.message)
    }

    /// As attributes of `object`, or entries of a dictionary.
    fn each(&self, py: Python<'_>) -> PyResult<[(&'static str, Py<PyAny>); 6]> {
        let object = |text: &Option<String>| -> PyResult<Py<PyAny>> { Ok(text.into_pyobject(py)?.unbind()) };
        Ok([
            ("file", object(&Some(self.file.clone()))?),
            ("key", object(&Some(self.key.clone()))?),
            ("line", self.line.into_pyobject(py)?.unbind()),
            ("found", object(&self.found)?),
            ("message", object(&Some(self.message.clone()))?),
            ("help", object(&self.help)?),
        ])
    }
}

/// All faults of a case as one exception.
pub fn of_case(error: Fault) -> PyErr {
    let parts: Vec<Parts> = error.each().into_iter().map(Parts::from).collect();
    let told: Vec<String> = parts.iter().map(Parts::told).collect();
    let exception = CaseError::new_err(told.join("\n"));
    let attributes = |py: Python<'_>| -> PyResult<()> {
        let value = exception.value(py);
        let faults = PyList::empty(py);
        for part in &parts {
            let fault = pyo3::types::PyDict::new(py);
            for (key, object) in part.each(py)? {
                fault.set_item(key, object)?;
            }
            faults.append(fault)?;
        }
        for key in ["key", "line", "found", "help"] {
            let first = faults.get_item(0)?.get_item(key)?;
            value.setattr(key, first)?;
        }
        value.setattr("faults", faults)
    };
    Python::attach(attributes).map_or_else(|failed| failed, |()| exception)
}

/// A study that failed.
pub fn of_study(py: Python<'_>, error: &StudyFailed) -> PyErr {
    let exception = ComputationError::new_err(error.to_string());
    match exception.value(py).setattr("study", error.study) {
        Ok(()) => exception,
        Err(failed) => failed,
    }
}

/// A run that left no results.
pub fn of_run(py: Python<'_>, error: RunError) -> PyErr {
    match error {
        RunError::Study(error) => of_study(py, &error),
        RunError::Folder(error @ FolderError::Exists { .. }) => PyFileExistsError::new_err(error.to_string()),
        error => PyOSError::new_err(error.to_string()),
    }
}

/// Samples that could not be run or gathered.
pub fn of_ensemble(py: Python<'_>, error: EnsembleError) -> PyErr {
    match error {
        EnsembleError::Case(error) => of_case(error),
        EnsembleError::Run(error) => of_run(py, error),
        error @ (EnsembleError::Write { .. } | EnsembleError::Output(_) | EnsembleError::Foreign { .. }) => {
            PyOSError::new_err(error.to_string())
        }
        error => PyValueError::new_err(error.to_string()),
    }
}
