//! When a law is evaluated.

/// When a law is evaluated: the time, and the interval that is being stepped. At an edge the middle
/// decides which piece of a law holds, so that no step mixes two pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Time, s.
    pub time_s: f64,
    /// Middle of the interval, s.
    pub middle_s: f64,
}
