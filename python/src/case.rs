//! A case: read, checked, run.

use crate::{error, outcome, pool};
use groundwave::case::{RunOptions, Solved, check_output, keep};
use groundwave::ensemble::{self, Rows, Shard};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Reads files beside a case: those at hand in `files`, others in `folder`.
pub fn beside<'a>(
    folder: &'a Path,
    files: &'a BTreeMap<String, String>,
) -> impl Fn(&str) -> Result<String, String> + 'a {
    |name| match files.get(name) {
        Some(text) => Ok(text.clone()),
        None => groundwave::case::read_beside(&folder.join(name)),
    }
}

/// A case ready to run.
#[pyclass(frozen, module = "groundwave._core")]
pub struct Case {
    case: Arc<groundwave::Case>,
}

#[pymethods]
impl Case {
    /// Reads the case `text`, called `name` in messages; it finds files in `files`, by name, or in `folder`.
    #[staticmethod]
    #[pyo3(signature = (text, name, folder, files))]
    fn parse(text: &str, name: &str, folder: PathBuf, files: BTreeMap<String, String>) -> PyResult<Self> {
        let case = groundwave::Case::parse(text, name, &beside(&folder, &files)).map_err(error::of_case)?;
        Ok(Self { case: Arc::new(case) })
    }

    /// Reads the case file at `path`, or the case stored in a results.h5.
    #[staticmethod]
    #[pyo3(signature = (path))]
    fn load(path: PathBuf) -> PyResult<Self> {
        let case = groundwave::Case::load(&path).map_err(error::of_case)?;
        Ok(Self { case: Arc::new(case) })
    }

    /// Title of the case.
    #[getter]
    fn title(&self) -> &str {
        &self.case.title
    }

    /// The case file as it was read.
    #[getter]
    fn text(&self) -> &str {
        &self.case.text
    }

    /// Contents of every other file the case uses, by the name it uses.
    #[getter]
    fn files(&self) -> BTreeMap<String, String> {
        self.case.files.clone()
    }

    /// Names of its studies.
    #[getter]
    fn studies(&self) -> Vec<&'static str> {
        self.case.studies.iter().map(|study| study.name()).collect()
    }

    /// What its numbers may be doubted for: (code, message, remedy) of each.
    #[getter]
    fn concerns(&self) -> Vec<(&'static str, String, String)> {
        outcome::concerns(&self.case.concerns)
    }

    /// Computes every study: ``attributes``, ``groups`` and ``concerns``; leaves in ``out`` what the command does.
    #[pyo3(signature = (progress, out, overwrite))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        out: Option<PathBuf>,
        overwrite: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let case = self.case.clone();
        let options =
            out.map(|out| RunOptions { out, overwrite, pictures: true, csv_maps: false, vti: false });
        let solved = pool::run(py, progress.as_ref(), error::of_run, move |observer| {
            let check = |options: &RunOptions| check_output(&options.out, overwrite).map(drop);
            options.as_ref().map_or(Ok(()), check)?;
            let solved = Solved::of(&case, observer)?;
            if let Some(options) = &options {
                keep(&case, solved.clone(), options, observer)?;
            }
            Ok(solved)
        })?;
        let concerns = solved.concerns(&self.case);
        let dict = PyDict::new(py);
        dict.set_item("attributes", outcome::attributes(py, &solved.attributes(&self.case, &concerns))?)?;
        dict.set_item("groups", outcome::groups(py, solved.outcomes)?)?;
        dict.set_item("concerns", outcome::concerns(&concerns))?;
        Ok(dict)
    }

    /// About how long each study takes [s]: each is tried for a second.
    fn estimate(&self, py: Python<'_>) -> PyResult<BTreeMap<&'static str, f64>> {
        let case = self.case.clone();
        let times = pool::run(py, None, error::of_run, move |_| Ok(case.estimate(Duration::from_secs(1))?))?;
        let mut all = BTreeMap::new();
        for time in times {
            *all.entry(time.study).or_insert(0.0) += time.time.as_secs_f64();
        }
        Ok(all)
    }

    /// How many chunks its samples fill; none without ``[study]``.
    #[getter]
    fn chunks(&self) -> Option<usize> {
        self.case.study.as_ref().map(|study| Rows::of(study).chunks())
    }

    /// Runs the samples of shard ``number`` of ``of`` that are not yet in the folder ``out``: how many were run, and were there.
    #[pyo3(signature = (out, number, of, progress))]
    fn sample(
        &self,
        py: Python<'_>,
        out: PathBuf,
        number: usize,
        of: usize,
        progress: Option<Bound<'_, PyAny>>,
    ) -> PyResult<(usize, usize)> {
        let case = self.case.clone();
        let done = pool::run(py, progress.as_ref(), error::of_ensemble, move |observer| {
            ensemble::run(&case, &out, Shard::new(number, of)?, observer)
        })?;
        Ok((done.rows, done.found))
    }
}

/// What the samples in the folder ``out`` say: groups of arrays; with ``report`` it leaves in ``out/gathered`` what the command does.
#[pyfunction]
#[pyo3(signature = (out, report, progress))]
pub fn gather<'py>(
    py: Python<'py>,
    out: PathBuf,
    report: bool,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    let outcomes = pool::run(py, progress.as_ref(), error::of_ensemble, move |observer| {
        if report {
            ensemble::gather(&out, true, observer)?;
        }
        ensemble::outcomes(&out, observer)
    })?;
    outcome::groups(py, outcomes)
}
