//! The class `Simulation` of the module.

use crate::{Files, errors, read_with};
use kingpost::analysis::Linearizer;
use kingpost::dynamics::moving_frame::{Naming, Symbols};
use kingpost::hydrostatics::HydrostaticsError;
use kingpost::scenario::Scenario;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

pub type Vector<'py> = Bound<'py, PyArray1<f64>>;
pub type Matrix<'py> = Bound<'py, PyArray2<f64>>;
/// A matrix's name, entries, and for rows and columns their labels and their units.
type Block<'py> = (String, Matrix<'py>, [Vec<String>; 2], [Vec<&'static str>; 2]);
/// Steps between two looks for Ctrl-C.
const STEPS_BETWEEN_SIGNALS: usize = 10_000;

type Linear<'py> = (Matrix<'py>, Matrix<'py>, Vector<'py>, String);
type Input = (String, String, f64, f64, f64);

/// A row-major matrix as an array of two dimensions.
pub fn matrix(py: Python<'_>, data: Vec<f64>, rows: usize, columns: usize) -> PyResult<Matrix<'_>> {
    data.into_pyarray(py).reshape([rows, columns])
}

#[pyclass(module = "kingpost._engine")]
pub struct Simulation {
    inner: kingpost::Simulation,
    scenario: Scenario,
}

#[pymethods]
impl Simulation {
    #[new]
    fn new(text: &str, file: &str, overrides_json: &str, files: Files) -> PyResult<Self> {
        let scenario = read_with(text, file, overrides_json, files)?;
        Ok(Self { inner: scenario.simulation().map_err(errors::scenario)?, scenario })
    }

    fn step(&mut self, py: Python<'_>, n: usize) -> PyResult<()> {
        let mut left = n;
        while left > 0 {
            let now = left.min(STEPS_BETWEEN_SIGNALS);
            py.detach(|| self.inner.step(now)).map_err(errors::run)?;
            py.check_signals()?;
            left -= now;
        }
        Ok(())
    }

    /// Rows recorded from now to the end, and the error that ended the run or None: divergence, Ctrl-C
    /// or what the progress callback raised.
    #[pyo3(signature = (progress=None))]
    fn run<'py>(&mut self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<(Matrix<'py>, Option<PyErr>)> {
        let mut stopped = None;
        let run = py.detach(|| {
            self.inner.run(|time_s| match report(time_s, progress.as_ref()) {
                Ok(()) => true,
                Err(error) => {
                    stopped = Some(error);
                    false
                }
            })
        });
        let rows = run.rows.len() / run.columns.max(1);
        let rows = matrix(py, run.rows, rows, run.columns)?;
        Ok((rows, stopped.or_else(|| run.status.err().map(errors::run))))
    }

    fn reset(&mut self) {
        self.inner.reset();
    }

    fn time_s(&self) -> f64 {
        self.inner.time_s()
    }

    fn step_s(&self) -> f64 {
        self.inner.settings().step_s
    }

    fn evaluations(&self) -> u64 {
        self.inner.evaluations()
    }

    /// q, v and s.
    fn motion<'py>(&self, py: Python<'py>) -> [Vector<'py>; 3] {
        let state = self.inner.state();
        [&state.q, &state.v, &state.s].map(|part| PyArray1::from_slice(py, part))
    }

    #[pyo3(signature = (q, v, s=None))]
    fn set_state(
        &mut self,
        q: PyReadonlyArray1<'_, f64>,
        v: PyReadonlyArray1<'_, f64>,
        s: Option<PyReadonlyArray1<'_, f64>>,
    ) -> PyResult<()> {
        let s = s.as_ref().map(|s| s.as_slice()).transpose()?;
        self.inner.set_state(q.as_slice()?, v.as_slice()?, s).map_err(errors::input)
    }

    fn snapshot<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.inner.snapshot())
    }

    fn restore(&mut self, snapshot: &[u8]) -> PyResult<()> {
        self.inner.restore(snapshot).map_err(errors::input)
    }

    fn inputs(&self) -> Vec<Input> {
        self.inner.inputs().into_iter().map(|i| (i.name, i.unit.to_owned(), i.lower, i.upper, i.value)).collect()
    }

    fn set_input(&mut self, name: &str, value: f64) -> PyResult<()> {
        self.inner.set_input(name, value).map_err(errors::input)
    }

    fn set_parameter(&mut self, name: &str, value_json: &str) -> PyResult<()> {
        let value = serde_json::from_str(value_json).map_err(errors::input)?;
        self.scenario.set_parameter(&mut self.inner, name, &value).map_err(errors::input)
    }

    /// Names and units.
    fn coordinates(&self) -> Vec<(String, &'static str)> {
        self.inner.coordinates().into_iter().zip(self.inner.coordinate_units()).collect()
    }

    fn channels_json(&self) -> PyResult<String> {
        serde_json::to_string(self.inner.channels()).map_err(errors::input)
    }

    fn row<'py>(&mut self, py: Python<'py>) -> Vector<'py> {
        let mut row = Vec::with_capacity(self.inner.columns());
        self.inner.write_row(&mut row);
        row.into_pyarray(py)
    }

    fn poses<'py>(&mut self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        let bodies = self.inner.model().bodies.len();
        matrix(py, self.inner.poses(), bodies, 7)
    }

    /// What has happened so far: time, element, what.
    fn events(&self) -> Vec<(f64, String, String)> {
        self.inner.events().iter().map(|event| (event.time_s, event.element.clone(), event.what.to_string())).collect()
    }

    /// What a person should know of the rows so far: time, name and text of each, as JSON.
    fn warnings_json(&self) -> PyResult<String> {
        serde_json::to_string(&self.inner.warnings()).map_err(errors::input)
    }

    /// How the limits held in the rows so far, as JSON.
    fn limits_json(&self) -> PyResult<String> {
        serde_json::to_string(&self.inner.limits()).map_err(errors::input)
    }

    /// What a hand has set so far: time, input, value.
    fn lever_moves(&self) -> Vec<(f64, String, f64)> {
        self.inner.lever_moves().into_iter().map(|one| (one.time_s, one.input, one.value)).collect()
    }

    /// What a hand has set so far as an operation, as JSON.
    fn operation_json(&self) -> PyResult<String> {
        let operation = self.scenario.operation_by_hand(&self.inner).map_err(errors::input)?;
        serde_json::to_string(&operation).map_err(errors::input)
    }

    fn lines_json(&self) -> PyResult<String> {
        serde_json::to_string(&self.inner.lines()).map_err(errors::input)
    }

    fn line_points<'py>(&mut self, py: Python<'py>) -> Vector<'py> {
        self.inner.line_points().into_pyarray(py)
    }

    #[pyo3(signature = (tau=None))]
    fn acceleration<'py>(&mut self, py: Python<'py>, tau: Option<PyReadonlyArray1<'_, f64>>) -> PyResult<Vector<'py>> {
        let tau = tau.as_ref().map(|tau| tau.as_slice()).transpose()?;
        Ok(self.inner.acceleration(tau).map_err(errors::input)?.into_pyarray(py))
    }

    fn mass_matrix<'py>(&mut self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        let n = self.inner.coordinates().len();
        matrix(py, self.inner.mass_matrix(), n, n)
    }

    /// J of the closed loops over the free coordinates, by rows.
    fn constraint_matrix<'py>(&mut self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        let j = self.inner.moving_frame().j;
        matrix(py, j.transpose().as_slice().to_vec(), j.nrows(), j.ncols())
    }

    fn bias_force<'py>(&mut self, py: Python<'py>) -> Vector<'py> {
        self.inner.bias_force().into_pyarray(py)
    }

    /// The matrices now, with the labels and the units of rows and columns.
    fn moving_frame<'py>(&mut self, py: Python<'py>) -> PyResult<Vec<Block<'py>>> {
        let blocks = self.inner.moving_frame().named(self.inner.model());
        blocks
            .into_iter()
            .map(|block| {
                let (rows, columns) = (block.row_labels.len(), block.column_labels.len());
                let data = matrix(py, block.data, rows, columns)?;
                let labels = [block.row_labels, block.column_labels];
                Ok((block.name, data, labels, [block.row_units, block.column_units]))
            })
            .collect()
    }

    /// A and B by rows, the rates, and as JSON the names and units of states and inputs.
    fn linearize<'py>(&self, py: Python<'py>) -> PyResult<Linear<'py>> {
        let linear = Linearizer::new(&self.scenario).map_err(errors::scenario)?.at(&self.inner);
        let (n, m) = (linear.states.len(), linear.inputs.len());
        let a = matrix(py, linear.a.transpose().as_slice().to_vec(), n, n)?;
        let b = matrix(py, linear.b.transpose().as_slice().to_vec(), n, m)?;
        let names = serde_json::to_string(&linear.names()).map_err(errors::input)?;
        Ok((a, b, linear.rates.into_pyarray(py), names))
    }

    /// Moves to an equilibrium: Newton's iterations, and the largest acceleration that is left.
    fn settle(&mut self, py: Python<'_>) -> PyResult<(usize, f64)> {
        let found = py.detach(|| self.inner.settle()).map_err(errors::input)?;
        Ok((found.iterations, found.residual))
    }

    /// The matrices as formulas, as JSON; bodies by number or by name.
    fn symbols_json(&self, names: bool) -> PyResult<String> {
        let naming = if names { Naming::Names } else { Naming::Numbers };
        serde_json::to_string(&Symbols::new(self.inner.model(), naming).matrices()).map_err(errors::input)
    }

    /// The response to regular waves about rest, as JSON; of directions and frequencies as JSON.
    fn wave_response_json(&self, py: Python<'_>, waves_json: &str) -> PyResult<String> {
        let waves = serde_json::from_str(waves_json).map_err(errors::input)?;
        let found = py.detach(|| self.scenario.wave_response(&self.inner, &waves)).map_err(errors::input)?;
        serde_json::to_string(&found).map_err(errors::input)
    }

    /// How the hulls float at rest with the crane as it stands, as JSON.
    fn hydrostatics_json(&self, py: Python<'_>) -> PyResult<String> {
        let report = py.detach(|| self.scenario.hydrostatic_report_at(&self.inner));
        let report = report.map_err(|error| match error {
            HydrostaticsError::Scenario(error) => errors::scenario(error),
            HydrostaticsError::Hull { .. } => errors::input(error),
        })?;
        serde_json::to_string(&report).map_err(errors::input)
    }

    fn model_json(&self) -> PyResult<String> {
        serde_json::to_string(&self.scenario.describe().map_err(errors::scenario)?).map_err(errors::input)
    }
}

/// Let Python see Ctrl-C and tell the progress callback where the run is.
pub fn report(time_s: f64, progress: Option<&Py<PyAny>>) -> PyResult<()> {
    Python::attach(|py| {
        py.check_signals()?;
        progress.map_or(Ok(()), |callback| callback.call1(py, (time_s,)).map(drop))
    })
}
