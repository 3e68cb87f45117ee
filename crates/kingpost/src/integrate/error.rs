//! Why a scheme cannot make a step.

use thiserror::Error;

/// A step that a scheme cannot make. The state is as it was.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// Newton's method does not find the end of an implicit step.
    #[error(
        "the implicit step that ends at {} s did not converge: after {iterations} iterations the rates \
         still change by {residual:.3e} of their size, allowed: {allowed:e}; a smaller step may help",
        shown(*time_s)
    )]
    NotConverged {
        /// End of the step, s.
        time_s: f64,
        /// The last change of the rates, over their size.
        residual: f64,
        /// What it may be.
        allowed: f64,
        /// Iterations made.
        iterations: usize,
    },
    /// Error control asks for steps that are too small to get anywhere.
    #[error(
        "the step size collapsed at {} s: the tolerances ask for less than {step_s:.3e} s, allowed: at least {least_s:.3e} s",
        shown(*time_s)
    )]
    Collapsed {
        /// Begin of the step, s.
        time_s: f64,
        /// The step that was refused, s.
        step_s: f64,
        /// The smallest that is allowed, s.
        least_s: f64,
    },
}

/// A time without the last digits of its sum of steps, s.
pub(crate) fn shown(time_s: f64) -> f64 {
    libm::round(time_s * 1e9) / 1e9
}
