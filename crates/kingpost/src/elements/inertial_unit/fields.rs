//! An inertial unit and its filter.

use kingpost_derive::fields;

use crate::scenario::schema::{AccelerationErrors, AngleErrors, DropOuts, Name, Positive, RateErrors, yes};

/// Estimates the motion of a point of a body from accelerometers, gyroscopes and a gyrocompass, by an error-state
/// Kalman filter. Its outputs are those of a motion reference unit with horizontal motion, and
/// `measured_specific_force.x`, `.y`, `.z` (m/s^2, body axes): the acceleration less that of gravity. Without a
/// satellite receiver, it estimates the motion relative to the mean position. The run starts with the estimate to which
/// the filter converges at rest.
#[fields]
pub struct InertialUnit<S = f64> {
    /// Whether the sensor measures.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// The point, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Time between two samples, s.
    pub period_s: Positive,
    /// Delay of its outputs, in samples: 0 to 1000.
    #[serde(default)]
    pub delay_samples: usize,
    /// Errors of each accelerometer; without them all are exact.
    pub acceleration_errors: Option<AccelerationErrors<S>>,
    /// Errors of each gyroscope; without them all are exact.
    pub rate_errors: Option<RateErrors<S>>,
    /// Errors of the gyrocompass; without them it is exact.
    pub heading_errors: Option<AngleErrors<S>>,
    /// Name of a satellite receiver on the same body. With it, the displacement is relative to the start and includes
    /// slow motion.
    pub receiver: Option<Name>,
    /// Assumptions of the filter.
    #[serde(default)]
    pub filter: InertialFilter,
    /// Failures of the connection to the unit; without them it always works.
    pub drop_outs: Option<DropOuts>,
}

/// Assumptions of an inertial unit's filter about its instruments and the motion. The assumed noise may differ from
/// that of the instruments. Derivatives with respect to these numbers are not available.
#[fields(default)]
#[derive(Copy)]
pub struct InertialFilter {
    /// Standard deviation of the noise of an accelerometer in a sample, m/s^2.
    pub acceleration_noise_m_s2: Positive,
    /// Standard deviation of the noise of a gyroscope in a sample, rad/s.
    pub rate_noise_rad_s: Positive,
    /// Standard deviation of the noise of the heading in a sample, rad.
    pub heading_noise_rad: Positive,
    /// Standard deviation of the noise of the receiver's positions, m.
    pub position_noise_m: Positive,
    /// Standard deviation of the motion of the unit in waves, m: a smaller value gives the mean position more weight
    /// relative to the accelerometers.
    pub wave_motion_m: Positive,
    /// Peak period of the waves, s: an error by a factor of two has little effect.
    pub wave_period_s: Positive,
}

impl Default for InertialFilter {
    /// Defaults for a velocity random walk of 0.015 m/s/sqrt(h) and an angle random walk of 0.15 deg/sqrt(h), sampled
    /// at 50 Hz.
    fn default() -> Self {
        Self {
            acceleration_noise_m_s2: Positive::literal(0.002),
            rate_noise_rad_s: Positive::literal(3e-4),
            heading_noise_rad: Positive::literal(0.002),
            position_noise_m: Positive::literal(0.02),
            wave_motion_m: Positive::literal(0.15),
            wave_period_s: Positive::literal(10.0),
        }
    }
}
