//! Samples that an element takes at the start of the first step at or after each multiple of its period.

/// Share of the period by which a sampling time may be late: rounding.
const SLACK: f64 = 1e-9;

/// A sample that is due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Due {
    /// Its number, from 0: its time is this many periods.
    pub sample: i64,
    /// Whether it is the first that is taken.
    pub is_first: bool,
}

/// The sample that is due at a time, if it has not been taken; it counts as taken then. `next` is a mode of the element:
/// the number of the sample after the last, 0 before the first.
pub fn due(time_s: f64, period_s: f64, next: &mut i64) -> Option<Due> {
    let now = libm::floor(time_s / period_s + SLACK) as i64 + 1;
    let before = core::mem::replace(next, now);
    (before != now).then_some(Due { sample: now - 1, is_first: before == 0 })
}

/// Whether a time is a multiple of a period, to rounding: for a period of whole steps.
pub fn is_tick(time_s: f64, period_s: f64) -> bool {
    let ticks = time_s / period_s;
    (ticks - libm::round(ticks)).abs() <= SLACK * ticks.max(1.0)
}
