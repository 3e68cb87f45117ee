//! The function `batch` of the module.

use crate::boundary::{self, Look};
use crate::simulation::{Matrix, matrix};
use crate::{Files, errors};
use kingpost::batch::{BatchError, Variant, check_count, run_within};
use kingpost::scenario;
use pyo3::prelude::*;

/// Rows of each run, its error or None, and, as JSON, the channels and each run's warnings and limits.
type Runs<'py> = (Vec<Matrix<'py>>, Vec<Option<PyErr>>, String);

/// Whether the processor has AVX2, which a build of this module may require.
#[pyfunction]
pub fn has_avx2() -> bool {
    #[cfg(target_arch = "x86_64")]
    return std::is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    return false;
}

/// Raises an error if the models of this number of runs take more than `most_bytes` of memory.
#[pyfunction]
pub fn check_batch(runs: usize, most_bytes: u64) -> PyResult<()> {
    check_count(runs, most_bytes).map_err(errors::input)
}

/// Runs all variants, a JSON list of lists of `[name, value]`; `most` holds the largest numbers of threads and bytes.
#[pyfunction]
#[pyo3(signature = (text, file, files, variants_json, most, progress=None))]
pub fn batch<'py>(
    py: Python<'py>,
    text: &str,
    file: &str,
    files: Files,
    variants_json: &str,
    most: (usize, u64),
    progress: Option<Py<PyAny>>,
) -> PyResult<Runs<'py>> {
    let variants: Vec<Variant> =
        serde_json::from_str(variants_json).map_err(|error| errors::input(format!("variants: {error}")))?;
    let files = scenario::Files::new(files);
    let found = boundary::guarded(|| {
        boundary::watched(py, &Look(progress), |go_on| run_within(text, file, &files, &variants, most.0, most.1, go_on))
    })?;
    let batch = found.map_err(|found| match found {
        BatchError::Variant { ref error, .. } => errors::variant(&found, error.clone()),
        found => errors::input(found),
    })?;
    let (warnings, limits): (Vec<_>, Vec<_>) = batch.runs.iter().map(|run| (&run.warnings, &run.limits)).unzip();
    let published = serde_json::to_string(&(&batch.channels, warnings, limits)).map_err(errors::input)?;
    let (mut rows, mut ends) = (Vec::new(), Vec::new());
    for run in batch.runs {
        let count = run.rows.len() / run.columns.max(1);
        rows.push(matrix(py, run.rows, count, run.columns)?);
        ends.push(run.status.err().map(errors::run));
    }
    Ok((rows, ends, published))
}
