//! The class `VectorEnsemble` of the module.

use crate::{Files, boundary, errors};
use kingpost::batch::{Asked, BatchError, CopyError, Status, Variant};
use kingpost::scenario;
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use std::sync::Mutex;

/// Copies of a scenario that step together, with the status of each.
#[pyclass(module = "kingpost._engine", frozen)]
pub struct VectorEnsemble(Mutex<(kingpost::batch::VectorEnsemble, Vec<Status>)>);

fn refused(found: CopyError) -> PyErr {
    match found {
        CopyError::Batch(BatchError::Variant { ref error, .. }) => errors::variant(&found, error.clone()),
        found => errors::input(found),
    }
}

impl VectorEnsemble {
    fn with<T>(
        &self,
        call: impl FnOnce(&mut kingpost::batch::VectorEnsemble, &mut Vec<Status>) -> PyResult<T>,
    ) -> PyResult<T> {
        boundary::guarded(|| {
            let refused = |_| errors::input("copies: found a call while they compute, allowed: one call at a time");
            let mut held = self.0.try_lock().map_err(refused)?;
            let (copies, status) = &mut *held;
            call(copies, status)
        })
    }
}

#[pymethods]
impl VectorEnsemble {
    /// Builds a copy for each variant; `asked`: names of inputs and of columns, whether limits are checked, threads.
    #[new]
    fn new(
        text: &str,
        file: &str,
        files: Files,
        variants_json: &str,
        asked: (Vec<String>, Vec<String>, bool, usize),
    ) -> PyResult<Self> {
        boundary::guarded(|| {
            let variants: Vec<Variant> = serde_json::from_str(variants_json).map_err(errors::input)?;
            let (files, count) = (scenario::Files::new(files), variants.len());
            let (inputs, columns, limits, threads) = asked;
            let asked = Asked { inputs, columns, limits };
            let copies =
                kingpost::batch::VectorEnsemble::new(text, file, files, variants, asked, threads).map_err(refused)?;
            Ok(Self(Mutex::new((copies, vec![Status::Running; count]))))
        })
    }

    /// Takes steps and writes the columns and the status of each copy: -1 failed, 0 running, 1 + i beyond limit i.
    fn advance(
        &self,
        py: Python<'_>,
        steps: usize,
        inputs: PyReadonlyArray1<'_, f64>,
        mut columns: PyReadwriteArray1<'_, f64>,
        mut status: PyReadwriteArray1<'_, i64>,
    ) -> PyResult<()> {
        self.with(|copies, now| {
            let (inputs, columns) = (inputs.as_slice()?, columns.as_slice_mut()?);
            py.detach(|| copies.advance(steps, inputs, columns, now)).map_err(refused)?;
            for (to, now) in status.as_slice_mut()?.iter_mut().zip(now) {
                *to = match now {
                    Status::Failed => -1,
                    Status::Running => 0,
                    Status::BeyondLimit(limit) => 1 + *limit as i64,
                };
            }
            Ok(())
        })
    }

    /// Restarts the copies of a JSON list of `[copy, variant or null]`.
    fn restart(&self, py: Python<'_>, which_json: &str) -> PyResult<()> {
        let which: Vec<(usize, Option<Variant>)> = serde_json::from_str(which_json).map_err(errors::input)?;
        self.with(|copies, _| py.detach(|| copies.restart(which)).map_err(refused))
    }

    /// Stores the state of a copy for [`resume`](Self::resume).
    fn mark(&self, copy: usize) -> PyResult<()> {
        self.with(|copies, _| copies.mark(copy).map_err(refused))
    }

    /// Sets all copies to the state stored last by [`mark`](Self::mark).
    fn resume(&self) -> PyResult<()> {
        self.with(|copies, _| copies.resume().map_err(refused))
    }

    /// Returns the error with which a copy failed, or None.
    fn failure(&self, copy: usize) -> PyResult<Option<PyErr>> {
        self.with(|copies, _| Ok(copies.failure(copy).cloned().map(errors::run)))
    }

    /// Returns the time of a copy, s.
    fn time_s(&self, copy: usize) -> PyResult<f64> {
        self.with(|copies, _| Ok(copies.time_s(copy)))
    }
}
