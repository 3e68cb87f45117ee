//! The class `Scenario` of the module.

use crate::boundary::{self, Look};
use crate::simulation::{Matrix, matrix};
use crate::{Files, errors, overrides};
use kingpost::hydrostatics::{HydrostaticReport, HydrostaticsError};
use kingpost::scenario::{self, BuiltScenario};
use pyo3::prelude::*;
use std::sync::Arc;

/// Rows, their derivatives with respect to each parameter, the channels as JSON, and the error of the run or None.
type Gradient<'py> = (Matrix<'py>, Vec<Matrix<'py>>, String, Option<PyErr>);

/// A scenario, read and built once, and immutable.
#[pyclass(module = "kingpost._engine", frozen)]
pub struct Scenario(pub Arc<BuiltScenario>);

/// Returns a hydrostatic report as JSON.
pub fn hydrostatics(report: Result<HydrostaticReport, HydrostaticsError>) -> PyResult<String> {
    let report = report.map_err(|error| match error {
        HydrostaticsError::Scenario(error) => errors::scenario(error),
        HydrostaticsError::Hull { .. } => errors::input(error),
    })?;
    serde_json::to_string(&report).map_err(errors::input)
}

#[pymethods]
impl Scenario {
    #[new]
    fn new(py: Python<'_>, text: &str, file: &str, overrides_json: &str, files: Files) -> PyResult<Self> {
        boundary::guarded(|| {
            let (pairs, files) = (overrides(overrides_json)?, scenario::Files::new(files));
            let built = py.detach(|| BuiltScenario::read(text, file, &pairs, &files)).map_err(errors::scenario)?;
            Ok(Self(Arc::new(built)))
        })
    }

    /// Returns the resolved scenario as JSON.
    fn json(&self) -> PyResult<String> {
        boundary::guarded(|| Ok(self.0.scenario().to_json()))
    }

    /// Returns the description of the model as JSON.
    fn model_json(&self, py: Python<'_>) -> PyResult<String> {
        boundary::guarded(|| serde_json::to_string(py.detach(|| self.0.describe())).map_err(errors::input))
    }

    /// Returns the hydrostatics of the hulls at rest, with the crane in its position at the start of a run, as JSON.
    fn hydrostatics_json(&self, py: Python<'_>) -> PyResult<String> {
        boundary::guarded(|| hydrostatics(py.detach(|| self.0.hydrostatic_report())))
    }

    #[pyo3(signature = (names, progress=None))]
    fn gradient<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Gradient<'py>> {
        let (look, mut stopped) = (Look(progress), None);
        let found = boundary::guarded(|| {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let go_on = |time_s| look.now(time_s).map_err(|error| stopped = Some(error)).is_ok();
            py.detach(|| self.0.gradient(&names, go_on)).map_err(errors::scenario)
        })?;
        let (columns, count) = (found.columns, found.rows.len() / found.columns.max(1));
        let derivatives = found.derivatives.into_iter().map(|rows| matrix(py, rows, count, columns));
        let channels = serde_json::to_string(&found.channels).map_err(errors::input)?;
        let rows = matrix(py, found.rows, count, columns)?;
        let error = stopped.or_else(|| found.status.err().map(errors::run));
        Ok((rows, derivatives.collect::<PyResult<_>>()?, channels, error))
    }
}
