//! The Python module `kingpost._engine`: conversions and exceptions only.
//!
//! Arrays are passed as NumPy arrays, structured data as JSON. The documented interface is in `python/kingpost`.

mod batch;
mod boundary;
mod copies;
mod errors;
mod scenario;
mod simulation;

use kingpost::scenario as engine;
use pyo3::prelude::*;
use serde_json::Value;
use std::collections::HashMap;

/// Reads overrides from Python: a JSON list of `[name, value]`, in order.
fn overrides(json: &str) -> PyResult<Vec<(String, Value)>> {
    serde_json::from_str(json).map_err(|error| errors::input(format!("overrides: {error}")))
}

/// Texts of the files that a scenario names, by name.
type Files = HashMap<String, String>;

/// Returns the resolved scenario as JSON.
#[pyfunction]
fn read(text: &str, file: &str, overrides_json: &str, files: Files) -> PyResult<String> {
    boundary::guarded(|| {
        let read = engine::read_with(text, file, &overrides(overrides_json)?, &engine::Files::new(files));
        Ok(read.map_err(errors::scenario)?.to_json())
    })
}

/// Returns the names of the files that a scenario needs, as far as the given files contain them.
#[pyfunction]
fn file_names(text: &str, file: &str, overrides_json: &str, files: Files) -> PyResult<Vec<String>> {
    boundary::guarded(|| {
        let files = engine::Files::new(files);
        engine::file_names(text, file, &overrides(overrides_json)?, &files).map_err(errors::scenario)
    })
}

/// Parses `name=value` into the name and the value as JSON.
#[pyfunction]
fn parse_assignment(text: &str) -> PyResult<(String, String)> {
    boundary::guarded(|| {
        engine::parse_assignment(text).map(|(name, value)| (name, value.to_string())).map_err(errors::scenario)
    })
}

/// Returns a study as JSON with all defaults, and the source positions of its values as JSON.
#[pyfunction]
fn read_study(text: &str, file: &str) -> PyResult<(String, String)> {
    boundary::guarded(|| {
        let (study, places) = engine::study::read(text, file).map_err(errors::scenario)?;
        let json = |value: serde_json::Result<String>| value.map_err(errors::input);
        Ok((json(serde_json::to_string(&study))?, json(serde_json::to_string(&places))?))
    })
}

#[pymodule]
mod _engine {
    #[pymodule_export]
    use super::{file_names, parse_assignment, read, read_study};

    #[pymodule_export]
    use super::batch::{batch, check_batch, has_avx2};

    #[pymodule_export]
    use super::copies::VectorEnsemble;

    #[pymodule_export]
    use super::scenario::Scenario;

    #[pymodule_export]
    use super::simulation::Simulation;

    #[pymodule_init]
    fn begin(_module: &pyo3::Bound<'_, pyo3::types::PyModule>) -> pyo3::PyResult<()> {
        crate::boundary::keep_defects();
        Ok(())
    }

    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __source_digest__: &str = env!("KINGPOST_SOURCE_DIGEST");
}
