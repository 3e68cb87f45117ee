//! Time at which a law is evaluated.

/// Time at which a law is evaluated, and the interval of the step. At an edge, the middle of the interval
/// decides which piece of a law applies, so that a step does not mix two pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Time, s.
    pub time_s: f64,
    /// Middle of the interval, s.
    pub middle_s: f64,
}
