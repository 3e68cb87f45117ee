//! Active heave compensation.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Fraction, Name, NonNegative, Positive, SetsInputs, yes};

/// Active heave compensation of a rope. Its inputs are a lever with its name, from 0 (off) to 1 (on), and
/// `NAME.lowering_speed` (m/s at the load, positive: down), which is added to its command. Its outputs are
/// `compensation_residual` (m), `compensation_speed` (m/s), `compensation_tip_velocity` (m/s) and
/// `compensation_utilisation`.
#[fields]
pub struct HeaveCompensation<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Whether it is switched on at the start.
    #[serde(default = "yes")]
    pub begins_on: bool,
    /// The rope. The place before its last end is the crane's tip.
    pub rope: Name,
    /// The controlled drive of the rope's drum, or of a joint that moves sheaves between drum and tip: the slide of a
    /// compensation cylinder. Its set-point is a speed, which is added to the operator's speed.
    pub drive: Name,
    /// The motion reference unit or inertial unit that measures the tip's motion; without it, the compensation uses the
    /// exact motion without delay.
    pub sensor: Option<Name>,
    /// Time between two commands, s; at least simulation.step_s.
    pub period_s: Positive,
    /// Feed-forward gain: share of the tip's velocity that is commanded.
    #[serde(default = "whole::<S>")]
    pub feed_forward: Fraction<S>,
    /// Commanded speed per height error of the load, 1/s.
    #[serde(default = "gain::<S>")]
    pub position_gain_per_s: NonNegative<S>,
    /// Prediction over all delays; without it, the measured velocity is commanded.
    pub prediction: Option<HeavePrediction<S>>,
}

/// Prediction of the ship's motion over the delay of the sensor, the time for which a command is held, and the response
/// of the drive. It also inverts the sensor's high-pass filter, for waves of these periods.
#[fields]
pub struct HeavePrediction<S = f64> {
    /// Shortest period of the tip's motion, s; at least four times period_s.
    #[serde(default = "shortest")]
    pub shortest_period_s: Positive,
    /// Longest period, s; longer than the shortest.
    #[serde(default = "longest")]
    pub longest_period_s: Positive,
    /// Standard deviation of the noise in a measured velocity over that of the velocity. A larger value makes the
    /// prediction smoother and less exact.
    #[serde(default = "noise_share")]
    pub noise_share: Positive,
    /// Prediction time in addition to the delay of its sensor and half of period_s, s.
    #[serde(default)]
    pub extra_delay_s: NonNegative<S>,
    /// Time constant of the drive's response that the prediction inverts, s; without it, the response_time_s of each
    /// drive.
    pub drive_response_s: Option<NonNegative<S>>,
}

fn whole<S: Leaf>() -> Fraction<S> {
    Fraction::literal(1.0)
}

fn gain<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(0.1)
}

pub(super) fn shortest() -> Positive {
    Positive::literal(4.0)
}

pub(super) fn longest() -> Positive {
    Positive::literal(16.0)
}

pub(super) fn noise_share() -> Positive {
    Positive::literal(0.03)
}

impl<S> SetsInputs for HeaveCompensation<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        self.enabled.then(|| ("drive".to_owned(), &*self.drive)).into_iter().collect()
    }

    fn sets_drives(&self) -> bool {
        true
    }
}
