//! The boundary between Python and the engine: a panic becomes an exception, and Ctrl-C interrupts a call.

use crate::errors;
use pyo3::prelude::*;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};
use std::thread;
use std::time::Duration;

/// Message and source position of the last panic, stored here because the threads of a batch do not pass them on.
static DEFECT: Mutex<String> = Mutex::new(String::new());

/// Time between two checks for Ctrl-C while other threads compute.
const LOOK_EVERY: Duration = Duration::from_millis(50);

/// Stores the message of a panic for [`guarded`] instead of printing it.
pub fn keep_defects() {
    panic::set_hook(Box::new(|info: &PanicHookInfo<'_>| {
        let place = info.location().map(|at| format!("{}:{}: ", at.file(), at.line())).unwrap_or_default();
        let what = info.payload_as_str().unwrap_or("no message");
        *DEFECT.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) = format!("{place}{what}");
    }));
}

/// Calls the engine and returns the result; a panic becomes an exception.
pub fn guarded<T>(call: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    panic::catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|_| {
        let what = DEFECT.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        Err(errors::defect(&what))
    })
}

/// Check for Ctrl-C, with a callback for the progress.
pub struct Look(pub Option<Py<PyAny>>);

impl Look {
    /// Checks for Ctrl-C and reports the progress. Call it from Python's main thread, which alone receives Ctrl-C.
    pub fn now(&self, done: f64) -> PyResult<()> {
        Python::attach(|py| {
            py.check_signals()?;
            self.0.as_ref().map_or(Ok(()), |callback| callback.call1(py, (done,)).map(drop))
        })
    }
}

/// Runs work on other threads. The calling thread checks for Ctrl-C and reports the progress that the work passes on.
pub fn watched<T: Send>(
    py: Python<'_>,
    look: &Look,
    work: impl FnOnce(&(dyn Fn(usize) -> bool + Sync)) -> T + Send,
) -> PyResult<T> {
    let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
    let go_on = |now: usize| {
        done.fetch_max(now, Ordering::Relaxed);
        !stop.load(Ordering::Relaxed)
    };
    py.detach(|| {
        thread::scope(|scope| {
            let (ended, end) = mpsc::channel::<()>();
            let worker = scope.spawn(|| {
                let _held = ended;
                work(&go_on)
            });
            let mut seen = Ok(());
            while end.recv_timeout(LOOK_EVERY) == Err(mpsc::RecvTimeoutError::Timeout) {
                if seen.is_ok() {
                    seen = look.now(done.load(Ordering::Relaxed) as f64);
                    stop.store(seen.is_err(), Ordering::Relaxed);
                }
            }
            let found = worker.join().unwrap_or_else(|defect| panic::resume_unwind(defect));
            seen.and_then(|()| look.now(done.load(Ordering::Relaxed) as f64)).map(|()| found)
        })
    })
}
