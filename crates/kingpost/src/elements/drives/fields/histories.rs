//! Histories of strengths and rates over time, and motions given by angle, length or amplitude.

use kingpost_derive::fields;

use crate::scenario::schema::{NonNegative, Positive};

/// How a drive's strength varies over time.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum History {
    /// Full strength from the start on.
    #[default]
    Constant,
    /// Rise, hold and stop, or rise, hold, reverse and stop, at the times of `pulse`.
    Pulse,
    /// Linear between the shares of `list` at given times.
    List,
    /// Full strength times an input in [-1, 1] that has the drive's name.
    Lever,
}

/// Shares of the full strength at given times, linear between them: 0 before the first time, the last share after the
/// last.
#[fields]
pub struct HistoryList<S = f64> {
    /// Times in increasing order, s. A time given twice is a jump, which is allowed for a motor but not for a
    /// prescribed rate.
    pub time_s: Vec<NonNegative>,
    /// The share at each time: 1 is full strength, -1 full strength in the other direction.
    pub share: Vec<S>,
}

/// Times of a pulse of a prescribed rate R, which cannot jump: from 0 to R in `rise_s`, R for `hold_s`, back to 0 in
/// `rise_s`, and 0 from then on. With a `reverse_s`, after the hold: from R to -R in twice `rise_s`, -R for
/// `reverse_s`, and then back to 0. Without a reverse the distance is `R (rise_s + hold_s)`.
#[fields]
pub struct RatePulse {
    /// When it begins, s.
    #[serde(default)]
    pub start_s: NonNegative,
    /// Duration of the ramp from 0 to the full rate, s.
    pub rise_s: Positive,
    /// Time at the full rate, s.
    pub hold_s: NonNegative,
    /// Time at the full rate in the other direction, s; 0 is a pulse that does not reverse.
    #[serde(default)]
    pub reverse_s: NonNegative,
}

/// A turn by an angle, from rest to rest: the rate rises in `ramp_s`, is constant at `angle / (duration_s - ramp_s)`,
/// and falls to 0 in `ramp_s`.
#[fields]
pub struct AngleTravel<S = f64> {
    /// Angle of the turn, positive about the axis, rad.
    pub angle_rad: S,
    /// When it begins, s.
    #[serde(default)]
    pub start_s: NonNegative,
    /// Duration from rest to rest, both ramps included, s.
    pub duration_s: Positive,
    /// Duration of a ramp, s; at most half of the whole duration.
    pub ramp_s: Positive,
}

/// A travel by a length, from rest to rest: the speed rises in `ramp_s`, is constant at `length / (duration_s -
/// ramp_s)`, and falls to 0 in `ramp_s`.
#[fields]
pub struct LengthTravel<S = f64> {
    /// Length of the travel, positive along the axis, m.
    pub length_m: S,
    /// When it begins, s.
    #[serde(default)]
    pub start_s: NonNegative,
    /// Duration from rest to rest, both ramps included, s.
    pub duration_s: Positive,
    /// Duration of a ramp, s; at most half of the whole duration.
    pub ramp_s: Positive,
}

/// An oscillation about the initial angle, `A sin(2 pi t / T + phase)`. It grows smoothly from rest in `ramp_s`.
#[fields]
pub struct AngleOscillation<S = f64> {
    /// A, rad.
    pub amplitude_rad: S,
    /// T, s.
    pub period_s: Positive<S>,
    /// Its phase at time 0, rad.
    #[serde(default)]
    pub phase_rad: S,
    /// Duration of its growth, s.
    pub ramp_s: Positive,
}

/// An oscillation about the initial extension, `A sin(2 pi t / T + phase)`. It grows smoothly from rest in `ramp_s`.
#[fields]
pub struct LengthOscillation<S = f64> {
    /// A, m.
    pub amplitude_m: S,
    /// T, s.
    pub period_s: Positive<S>,
    /// Its phase at time 0, rad.
    #[serde(default)]
    pub phase_rad: S,
    /// Duration of its growth, s.
    pub ramp_s: Positive,
}
