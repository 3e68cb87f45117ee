//! The engine's typed errors as the exceptions of `kingpost.errors`.

use kingpost::scenario::ScenarioError as EngineScenarioError;
use kingpost::simulation::RunError as EngineRunError;
use pyo3::prelude::*;

pyo3::import_exception!(kingpost.errors, KingpostError);
pyo3::import_exception!(kingpost.errors, ScenarioError);
pyo3::import_exception!(kingpost.errors, RunError);

/// An argument that the engine refuses.
pub fn input(error: impl ToString) -> PyErr {
    KingpostError::new_err(error.to_string())
}

/// A defect of the engine, not of its input.
pub fn defect(what: &str) -> PyErr {
    KingpostError::new_err(format!(
        "the engine failed: {what}; this is a defect of Kingpost, please report it with the scenario"
    ))
}

pub fn scenario(error: EngineScenarioError) -> PyErr {
    variant(&error.clone(), error)
}

/// An error of a scenario with another message: in a batch it also names the run.
pub fn variant(message: &dyn ToString, error: EngineScenarioError) -> PyErr {
    let EngineScenarioError { file, line, column, field, found, allowed } = error;
    ScenarioError::new_err((message.to_string(), file, line, column, field, found, allowed))
}

pub fn run(error: EngineRunError) -> PyErr {
    let (message, time_s) = (error.to_string(), error.time_s());
    match error.place() {
        Some((name, part, value, limit)) => RunError::new_err((message, time_s, name, part, value, limit)),
        None => RunError::new_err((message, time_s)),
    }
}
