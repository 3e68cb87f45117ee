//! The Python module `kingpost._engine`: conversions and exceptions, nothing else.
//!
//! Arrays cross as NumPy arrays, structured text as JSON. The labelled, documented face is the
//! Python package in `python/kingpost`.

mod batch;
mod errors;
mod gradient;
mod simulation;

use kingpost::scenario;
use pyo3::prelude::*;
use serde_json::Value;

/// Overrides as they come from Python: a JSON list of `[name, value]`, in order.
fn overrides(json: &str) -> PyResult<Vec<(String, Value)>> {
    serde_json::from_str(json).map_err(|error| errors::input(format!("overrides: {error}")))
}

/// The resolved scenario as JSON.
#[pyfunction]
fn read(text: &str, file: &str, overrides_json: &str) -> PyResult<String> {
    let pairs = overrides(overrides_json)?;
    scenario::read(text, file, &pairs).map(|scenario| scenario.to_json()).map_err(errors::scenario)
}

/// `name=value` as a name and the value in JSON.
#[pyfunction]
fn parse_assignment(text: &str) -> PyResult<(String, String)> {
    scenario::parse_assignment(text).map(|(name, value)| (name, value.to_string())).map_err(errors::scenario)
}

#[pymodule]
mod _engine {
    #[pymodule_export]
    use super::{parse_assignment, read};

    #[pymodule_export]
    use super::batch::{batch, has_avx2};

    #[pymodule_export]
    use super::gradient::gradient;

    #[pymodule_export]
    use super::simulation::Simulation;

    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
