//! The function `gradient` of the module.

use crate::boundary::{self, Look};
use crate::simulation::{Matrix, matrix};
use crate::{Files, errors, read_with};
use kingpost::analysis;
use pyo3::prelude::*;

/// Rows, the derivatives of the rows along each name, the channels as JSON, and the error that
/// ended the run or None.
type Gradient<'py> = (Matrix<'py>, Vec<Matrix<'py>>, String, Option<PyErr>);

#[pyfunction]
#[pyo3(signature = (text, file, overrides_json, files, names, progress=None))]
pub fn gradient<'py>(
    py: Python<'py>,
    text: &str,
    file: &str,
    overrides_json: &str,
    files: Files,
    names: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Gradient<'py>> {
    let (look, mut stopped) = (Look(progress), None);
    let found = boundary::guarded(|| {
        let scenario = read_with(text, file, overrides_json, files)?;
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        py.detach(|| {
            analysis::gradient(&scenario, &names, |time_s| {
                look.now(time_s).map_err(|error| stopped = Some(error)).is_ok()
            })
        })
        .map_err(errors::scenario)
    })?;
    let (columns, count) = (found.columns, found.rows.len() / found.columns.max(1));
    let derivatives = found.derivatives.into_iter().map(|rows| matrix(py, rows, count, columns));
    let channels = serde_json::to_string(&found.channels).map_err(errors::input)?;
    let rows = matrix(py, found.rows, count, columns)?;
    let error = stopped.or_else(|| found.status.err().map(errors::run));
    Ok((rows, derivatives.collect::<PyResult<_>>()?, channels, error))
}
