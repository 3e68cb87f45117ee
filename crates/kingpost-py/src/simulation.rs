//! The class `Simulation` of the module.

use crate::boundary::{self, Look};
use crate::errors;
use crate::scenario::{Scenario, hydrostatics};
use kingpost::analysis::{self, Linearizer};
use kingpost::dynamics::moving_frame::{Naming, Symbols};
use kingpost::scenario::BuiltScenario;
use kingpost::scenario::assembly::read_sea_waves;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::{Arc, Mutex, TryLockError};

pub type Vector<'py> = Bound<'py, PyArray1<f64>>;
pub type Matrix<'py> = Bound<'py, PyArray2<f64>>;
/// Name and entries of a matrix, with the labels and the units of its rows and columns.
type Block<'py> = (String, Matrix<'py>, [Vec<String>; 2], [Vec<&'static str>; 2]);
/// Steps between two checks for Ctrl-C.
const STEPS_BETWEEN_SIGNALS: usize = 1_000;

type Linear<'py> = (Matrix<'py>, Matrix<'py>, Vector<'py>, String);
type Input = (String, String, f64, f64, f64, Option<String>);

/// Returns a row-major matrix as an array of two dimensions.
pub fn matrix(py: Python<'_>, data: Vec<f64>, rows: usize, columns: usize) -> PyResult<Matrix<'_>> {
    data.into_pyarray(py).reshape([rows, columns])
}

/// A simulation that allows one call at a time: a call from a run's callback or from another thread raises an error.
#[pyclass(module = "kingpost._engine", frozen)]
pub struct Simulation {
    held: Mutex<Held>,
}

struct Held {
    inner: kingpost::Simulation,
    /// The built scenario, shared by all its simulations until a parameter is set in one of them.
    built: Arc<BuiltScenario>,
}

impl Simulation {
    /// Runs a call on the simulation. A panic poisons the lock, because the simulation may be inconsistent.
    fn with<T>(&self, call: impl FnOnce(&mut Held) -> PyResult<T>) -> PyResult<T> {
        boundary::guarded(|| {
            let mut held = self.held.try_lock().map_err(|refused| match refused {
                TryLockError::WouldBlock => {
                    errors::input("simulation: found a call while it computes, allowed: one call at a time")
                }
                TryLockError::Poisoned(_) => {
                    errors::input("simulation: found a defect in an earlier call, allowed: a new simulation")
                }
            })?;
            call(&mut held)
        })
    }
}

#[pymethods]
impl Simulation {
    #[new]
    fn new(py: Python<'_>, scenario: &Scenario) -> PyResult<Self> {
        boundary::guarded(|| {
            let built = Arc::clone(&scenario.0);
            let inner = py.detach(|| built.simulation()).map_err(errors::scenario)?;
            Ok(Self { held: Mutex::new(Held { inner, built }) })
        })
    }

    fn step(&self, py: Python<'_>, n: usize) -> PyResult<()> {
        self.with(|held| {
            let mut left = n;
            while left > 0 {
                let now = left.min(STEPS_BETWEEN_SIGNALS);
                py.detach(|| held.inner.step(now)).map_err(errors::run)?;
                py.check_signals()?;
                left -= now;
            }
            Ok(())
        })
    }

    /// Runs to the end; returns the rows, and the error or None: divergence, Ctrl-C, an exception of the callback.
    #[pyo3(signature = (progress=None))]
    fn run<'py>(&self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<(Matrix<'py>, Option<PyErr>)> {
        self.with(|held| {
            let (look, mut stopped) = (Look(progress), None);
            let run = py.detach(|| {
                held.inner.run(|time_s| match look.now(time_s) {
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
        })
    }

    fn reset(&self) -> PyResult<()> {
        self.with(|held| {
            held.inner.reset();
            Ok(())
        })
    }

    /// Returns the time, the step and the number of evaluations so far.
    fn clock(&self) -> PyResult<(f64, f64, u64)> {
        self.with(|held| Ok((held.inner.time_s(), held.inner.settings().step_s, held.inner.evaluations())))
    }

    /// Returns q, v and s.
    fn motion<'py>(&self, py: Python<'py>) -> PyResult<[Vector<'py>; 3]> {
        self.with(|held| {
            let state = held.inner.state();
            Ok([&state.q, &state.v, &state.s].map(|part| PyArray1::from_slice(py, part)))
        })
    }

    #[pyo3(signature = (q, v, s=None))]
    fn set_state(
        &self,
        q: PyReadonlyArray1<'_, f64>,
        v: PyReadonlyArray1<'_, f64>,
        s: Option<PyReadonlyArray1<'_, f64>>,
    ) -> PyResult<()> {
        self.with(|held| {
            let s = s.as_ref().map(|s| s.as_slice()).transpose()?;
            held.inner.set_state(q.as_slice()?, v.as_slice()?, s).map_err(errors::input)
        })
    }

    fn snapshot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.with(|held| Ok(PyBytes::new(py, &held.inner.snapshot())))
    }

    fn restore(&self, snapshot: &[u8]) -> PyResult<()> {
        self.with(|held| held.inner.restore(snapshot).map_err(errors::input))
    }

    fn inputs(&self) -> PyResult<Vec<Input>> {
        self.with(|held| {
            let inputs = held.inner.inputs().into_iter();
            Ok(inputs.map(|i| (i.name, i.unit.to_owned(), i.lower, i.upper, i.value, i.signal)).collect())
        })
    }

    fn set_input(&self, name: &str, value: f64) -> PyResult<()> {
        self.with(|held| held.inner.set_input(name, value).map_err(errors::input))
    }

    fn set_parameter(&self, name: &str, value_json: &str) -> PyResult<()> {
        self.with(|held| {
            let value = serde_json::from_str(value_json).map_err(errors::input)?;
            let changed = held.built.set_parameter(&mut held.inner, name, &value).map_err(errors::input)?;
            held.built = Arc::new(changed);
            Ok(())
        })
    }

    /// Returns the names and units of the coordinates.
    fn coordinates(&self) -> PyResult<Vec<(String, &'static str)>> {
        self.with(|held| Ok(held.inner.coordinates().into_iter().zip(held.inner.coordinate_units()).collect()))
    }

    fn channels_json(&self) -> PyResult<String> {
        self.with(|held| serde_json::to_string(held.inner.channels()).map_err(errors::input))
    }

    fn row<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.with(|held| {
            let mut row = Vec::with_capacity(held.inner.columns());
            held.inner.write_row(&mut row);
            Ok(row.into_pyarray(py))
        })
    }

    fn poses<'py>(&self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        self.with(|held| matrix(py, held.inner.poses(), held.inner.model().bodies.len(), 7))
    }

    /// Returns the events so far as JSON: time, code, element and text of each.
    fn events_json(&self) -> PyResult<String> {
        self.with(|held| serde_json::to_string(held.inner.events()).map_err(errors::input))
    }

    /// Returns the warnings of the rows so far as JSON: time, code, name, numbers and text of each.
    fn warnings_json(&self) -> PyResult<String> {
        self.with(|held| serde_json::to_string(&held.inner.warnings()).map_err(errors::input))
    }

    /// Returns the state of the limits over the rows so far, as JSON.
    fn limits_json(&self) -> PyResult<String> {
        self.with(|held| serde_json::to_string(&held.inner.limits()).map_err(errors::input))
    }

    /// Returns the user's moves so far: time, input and value of each.
    fn lever_moves(&self) -> PyResult<Vec<(f64, String, f64)>> {
        self.with(|held| {
            Ok(held.inner.lever_moves().into_iter().map(|one| (one.time_s, one.input, one.value)).collect())
        })
    }

    /// Returns the user's moves so far as an operation, as JSON.
    fn operation_json(&self) -> PyResult<String> {
        self.with(|held| {
            let operation = held.built.scenario().operation_by_hand(&held.inner).map_err(errors::input)?;
            serde_json::to_string(&operation).map_err(errors::input)
        })
    }

    fn lines_json(&self) -> PyResult<String> {
        self.with(|held| serde_json::to_string(&held.inner.lines()).map_err(errors::input))
    }

    fn line_points<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.with(|held| Ok(held.inner.line_points().into_pyarray(py)))
    }

    #[pyo3(signature = (tau=None))]
    fn acceleration<'py>(&self, py: Python<'py>, tau: Option<PyReadonlyArray1<'_, f64>>) -> PyResult<Vector<'py>> {
        self.with(|held| {
            let tau = tau.as_ref().map(|tau| tau.as_slice()).transpose()?;
            Ok(held.inner.acceleration(tau).map_err(errors::input)?.into_pyarray(py))
        })
    }

    fn mass_matrix<'py>(&self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        self.with(|held| {
            let n = held.inner.coordinates().len();
            matrix(py, held.inner.mass_matrix(), n, n)
        })
    }

    /// J of closed loops and of taut inextensible ropes, over the free coordinates, by rows.
    fn constraint_matrix<'py>(&self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        self.with(|held| {
            let j = held.inner.moving_frame().j;
            matrix(py, j.transpose().as_slice().to_vec(), j.nrows(), j.ncols())
        })
    }

    fn bias_force<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        self.with(|held| Ok(held.inner.bias_force().into_pyarray(py)))
    }

    /// Returns the present matrices of the moving frame method, with the labels and the units of rows and columns.
    fn moving_frame<'py>(&self, py: Python<'py>) -> PyResult<Vec<Block<'py>>> {
        self.with(|held| {
            let blocks = held.inner.moving_frame().named(held.inner.model()).into_iter();
            let labelled = blocks.map(|block| {
                let (rows, columns) = (block.row_labels.len(), block.column_labels.len());
                let data = matrix(py, block.data, rows, columns)?;
                Ok((block.name, data, [block.row_labels, block.column_labels], [block.row_units, block.column_units]))
            });
            labelled.collect()
        })
    }

    /// Returns A and B by rows, the rates, and, as JSON, the names and units of states and inputs; waves can be left out.
    fn linearize<'py>(&self, py: Python<'py>, in_waves: bool) -> PyResult<Linear<'py>> {
        self.with(|held| {
            let linearizer = Linearizer::of_built(&held.built).map_err(errors::scenario)?;
            let linear = if in_waves { linearizer } else { linearizer.in_calm_water() }.at(&held.inner);
            let (n, m) = (linear.states.len(), linear.inputs.len());
            let a = matrix(py, linear.a.transpose().as_slice().to_vec(), n, n)?;
            let b = matrix(py, linear.b.transpose().as_slice().to_vec(), n, m)?;
            let names = serde_json::to_string(&linear.names()).map_err(errors::input)?;
            Ok((a, b, linear.rates.into_pyarray(py), names))
        })
    }

    /// Returns the natural modes of the bodies about the nearest equilibrium as JSON, in the format of the browser.
    fn natural_modes_json(&self, py: Python<'_>) -> PyResult<String> {
        self.with(|held| {
            let found = py.detach(|| analysis::natural_modes(&held.inner)).map_err(errors::input)?;
            serde_json::to_string(&found).map_err(errors::input)
        })
    }

    /// Moves to an equilibrium; returns the number of Newton iterations and the largest remaining acceleration.
    fn settle(&self, py: Python<'_>) -> PyResult<(usize, f64)> {
        self.with(|held| {
            let found = py.detach(|| held.inner.settle()).map_err(errors::input)?;
            Ok((found.iterations, found.residual))
        })
    }

    /// Returns the matrices as formulas, as JSON, with bodies by number or by name.
    fn symbols_json(&self, names: bool) -> PyResult<String> {
        self.with(|held| {
            let naming = if names { Naming::Names } else { Naming::Numbers };
            serde_json::to_string(&Symbols::new(held.inner.model(), naming).matrices()).map_err(errors::input)
        })
    }

    /// Returns the response to regular waves about rest, as JSON; `waves_json` holds directions and frequencies.
    fn wave_response_json(&self, py: Python<'_>, waves_json: &str) -> PyResult<String> {
        self.with(|held| {
            let waves = serde_json::from_str(waves_json).map_err(errors::input)?;
            let found = py.detach(|| held.built.wave_response(&held.inner, &waves)).map_err(errors::input)?;
            serde_json::to_string(&found).map_err(errors::input)
        })
    }

    /// Returns the response of columns to waves; `asked_json`: waves, columns, whether resonances are refined, the random sea for
    /// which drag is linearised.
    fn column_response<'py>(&self, py: Python<'py>, asked_json: &str) -> PyResult<(Matrix<'py>, String)> {
        self.with(|held| {
            let (waves, names, near, sea): (_, Vec<_>, _, Option<_>) =
                serde_json::from_str(asked_json).map_err(errors::input)?;
            let found = py.detach(|| held.built.column_response(&held.inner, &waves, &names, near, sea.as_ref()));
            let found = found.map_err(errors::input)?;
            let about = serde_json::to_string(&found).map_err(errors::input)?;
            Ok((matrix(py, found.amplitudes.as_flattened().to_vec(), found.amplitudes.len(), 2)?, about))
        })
    }

    /// Returns wave spectra as JSON; `asked_json`: a list of `sea.waves`, frequencies in rad/s, a number of directions.
    fn sea_spectra_json(&self, asked_json: &str) -> PyResult<String> {
        self.with(|held| {
            let (seas, frequencies, directions): (Vec<serde_json::Value>, Vec<f64>, usize) =
                serde_json::from_str(asked_json).map_err(errors::input)?;
            let of = |waves| held.built.scenario().sea_spectra(&read_sea_waves(waves)?, &frequencies, directions);
            let found = seas.iter().map(of).collect::<Result<Vec<_>, _>>().map_err(errors::scenario)?;
            serde_json::to_string(&found).map_err(errors::input)
        })
    }

    /// Returns the hydrostatics of the hulls at rest with the crane in its present position, as JSON.
    fn hydrostatics_json(&self, py: Python<'_>) -> PyResult<String> {
        self.with(|held| hydrostatics(py.detach(|| held.built.hydrostatic_report_at(&held.inner))))
    }
}
