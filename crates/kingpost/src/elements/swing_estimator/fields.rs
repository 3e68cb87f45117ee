//! A swing estimator and its filter.

use kingpost_derive::fields;

use crate::scenario::schema::{DropOuts, Name, Positive, RateErrors, yes};

/// Estimates the swing of a load or a hook from its gyroscopes, by an error-state Kalman filter with a model of the
/// swing about the vertical: `measured_roll`, `measured_pitch` (rad) and `measured_angular_velocity.x`, `.y`, `.z`
/// (rad/s, body axes). A constant inclination decays in the estimate. The run starts with the estimate to which the
/// filter converges at rest.
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

/// Assumptions of a swing estimator's filter about its gyroscopes and the swing. Derivatives with respect to these
/// numbers are not available.
#[fields(default)]
#[derive(Copy)]
pub struct SwingFilter {
    /// Standard deviation of the noise of a gyroscope in a sample, rad/s.
    pub rate_noise_rad_s: Positive,
    /// Standard deviation of the swing, rad: a smaller value gives the vertical more weight relative to the gyroscopes.
    pub swing_rad: Positive,
    /// Peak period of the swing, s: an error by a factor of two has little effect.
    pub swing_period_s: Positive,
}

impl Default for SwingFilter {
    /// Defaults for an angle random walk of 0.15 deg/sqrt(h), sampled at 50 Hz, and a load on 25 m of rope.
    fn default() -> Self {
        Self {
            rate_noise_rad_s: Positive::literal(3e-4),
            swing_rad: Positive::literal(0.05),
            swing_period_s: Positive::literal(10.0),
        }
    }
}
