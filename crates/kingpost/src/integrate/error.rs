//! Errors of a step.

use thiserror::Error;

/// An error of a scheme in a step. The state does not change.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// Newton's method does not converge in an implicit step.
    #[error(
        "the implicit step that ends at {} s did not converge: after {iterations} iterations the rates \
         still change by {residual:.3e} of their size, allowed: {allowed:e}; a smaller step may help",
        shown(*time_s)
    )]
    NotConverged {
        /// End of the step, s.
        time_s: f64,
        /// Last relative change of the rates.
        residual: f64,
        /// Largest allowed change.
        allowed: f64,
        /// Number of iterations.
        iterations: usize,
    },
    /// The motion of a line between its ends does not converge.
    #[error(
        "{name}: the motion of its nodes in the step that ends at {} s did not converge: after {iterations} iterations they still          move by {move_m:.3e} m, allowed: {allowed_m:.3e} m; a smaller step may help",
        shown(*time_s)
    )]
    LineNotConverged {
        /// Line.
        name: String,
        /// End of the step, s.
        time_s: f64,
        /// Last move of a node, m.
        move_m: f64,
        /// Largest allowed move, m.
        allowed_m: f64,
        /// Number of iterations.
        iterations: usize,
    },
    /// Error control would reduce the step below the smallest allowed one.
    #[error(
        "the step size collapsed at {} s: the tolerances need steps of less than {step_s:.3e} s, allowed: at least {least_s:.3e} s",
        shown(*time_s)
    )]
    Collapsed {
        /// Start of the step, s.
        time_s: f64,
        /// Step that error control needs, s.
        step_s: f64,
        /// Smallest allowed step, s.
        least_s: f64,
    },
}

/// Rounds a time, so that the rounding error of its sum of steps is not shown.
pub(crate) fn shown(time_s: f64) -> f64 {
    libm::round(time_s * 1e9) / 1e9
}
