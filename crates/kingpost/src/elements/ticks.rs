//! Samples that an element takes at the start of the first step at or after each multiple of its period.

/// Share of the period by which a sampling time may be late: rounding.
const SLACK: f64 = 1e-9;

/// A sample that is due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Due {
    /// Number of the sample, from 0: its time is this number times the period.
    pub sample: i64,
    /// Whether it is the first sample taken.
    pub is_first: bool,
}

/// Returns the sample that is due at a time, if it has not been taken, and marks it as taken. `next` is a mode of the
/// element: the number of the sample after the last taken one, 0 before the first.
pub fn due(time_s: f64, period_s: f64, next: &mut i64) -> Option<Due> {
    let now = libm::floor(time_s / period_s + SLACK) as i64 + 1;
    let before = core::mem::replace(next, now);
    (before != now).then_some(Due { sample: now - 1, is_first: before == 0 })
}

/// Whether a time is a multiple of a period, to rounding; the period must be a whole number of steps.
pub fn is_tick(time_s: f64, period_s: f64) -> bool {
    let ticks = time_s / period_s;
    (ticks - libm::round(ticks)).abs() <= SLACK * ticks.max(1.0)
}
