//! Conversion of the engine's typed errors to the exceptions of `kingpost.errors`.

use kingpost::scenario::ScenarioError as EngineScenarioError;
use kingpost::simulation::RunError as EngineRunError;
use pyo3::prelude::*;

pyo3::import_exception!(kingpost.errors, KingpostError);
pyo3::import_exception!(kingpost.errors, ScenarioError);
pyo3::import_exception!(kingpost.errors, RunError);

/// Returns the exception for an argument that the engine refuses.
pub fn input(error: impl ToString) -> PyErr {
    KingpostError::new_err(error.to_string())
}

/// Returns the exception for a defect of the engine.
pub fn defect(what: &str) -> PyErr {
    KingpostError::new_err(format!(
        "the engine failed: {what}; this is a defect of Kingpost, please report it with the scenario"
    ))
}

pub fn scenario(error: EngineScenarioError) -> PyErr {
    variant(&error.clone(), error)
}

/// Returns a scenario's error with another message, which in a batch also names the run.
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
