//! Errors of a step.

use thiserror::Error;

/// An error of a scheme in a step. The state is unchanged.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// Newton's method did not converge in an implicit step.
    #[error(
        "the implicit step that ends at {} s did not converge: after {iterations} iterations the rates \
         still change by {residual:.3e} of their size, allowed: {allowed:e}; a smaller step may help",
        shown(*time_s)
    )]
    NotConverged {
        /// End of the step, s.
        time_s: f64,
        /// The last relative change of the rates.
        residual: f64,
        /// Largest change that is allowed.
        allowed: f64,
        /// Iterations made.
        iterations: usize,
    },
    /// Error control reduced the step below the smallest one.
    #[error(
        "the step size collapsed at {} s: the tolerances ask for less than {step_s:.3e} s, allowed: at least {least_s:.3e} s",
        shown(*time_s)
    )]
    Collapsed {
        /// Start of the step, s.
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
