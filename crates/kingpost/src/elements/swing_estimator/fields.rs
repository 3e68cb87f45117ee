//! A swing estimator and its filter.

use kingpost_derive::fields;

use crate::scenario::schema::{DropOuts, Name, Positive, RateErrors, yes};

/// Finds how a load or a hook swings from gyroscopes on it, by an error-state Kalman filter which knows that it swings about
/// the vertical: `measured_roll`, `measured_pitch` (rad) and `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes). A
/// constant inclination fades from its results. It begins as after a long time at rest.
#[fields]
pub struct SwingEstimator<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body with the gyroscopes.
    pub body: Name,
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its outputs, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Errors of each gyroscope; without them all are exact.
    pub rate_errors: Option<RateErrors<S>>,
    /// Assumptions of the filter.
    #[serde(default)]
    pub filter: SwingFilter,
    /// Failures of the connection to the sensor; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// Assumptions of a swing estimator's filter about its gyroscopes and the swing. Derivatives do not go through these
/// numbers.
#[fields(default)]
#[derive(Copy)]
pub struct SwingFilter {
    /// Standard deviation of the noise of a gyroscope in a sample, rad/s.
    pub rate_noise_rad_s: Positive,
    /// Standard deviation of the swing, rad: the smaller, the more the vertical counts against the gyroscopes.
    pub swing_rad: Positive,
    /// Middle period of the swing, s: half or twice that does little harm.
    pub swing_period_s: Positive,
}

impl Default for SwingFilter {
    /// For gyroscopes of 0.15 degrees in the root of an hour at 50 Hz, and a load on 25 m of rope.
    fn default() -> Self {
        Self {
            rate_noise_rad_s: Positive::literal(3e-4),
            swing_rad: Positive::literal(0.05),
            swing_period_s: Positive::literal(10.0),
        }
    }
}
