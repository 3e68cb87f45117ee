//! Errors of sensors: noise, bias, resolution, drop-outs.

use kingpost_derive::fields;

use crate::scenario::schema::{NonNegative, Positive};

/// Random drop-outs of a sensor, from the run's seed. During a drop-out its outputs keep their last values and its
/// `sensor_status` is 0; the table of events has the beginning and the end of each drop-out.
#[fields]
#[derive(Copy)]
pub struct DropOuts {
    /// Mean time from the end of one drop-out to the next drop-out, s; at least the sensor's period.
    pub mean_interval_s: Positive,
    /// Mean duration of a drop-out, s; at least the sensor's period.
    pub mean_duration_s: Positive,
}

/// Errors of a measured angle.
#[fields]
#[derive(Copy, Default)]
pub struct AngleErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, rad: the noise density, rad/sqrt(Hz), over the square root of
    /// twice the period.
    #[serde(default)]
    pub noise_rad: NonNegative<S>,
    /// Constant error, rad.
    #[serde(default)]
    pub bias_rad: S,
    /// Resolution, rad; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_rad: NonNegative,
}

/// Errors of a measured length or height.
#[fields]
#[derive(Copy, Default)]
pub struct LengthErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m: the noise density, m/sqrt(Hz), over the square root of
    /// twice the period.
    #[serde(default)]
    pub noise_m: NonNegative<S>,
    /// Constant error, m.
    #[serde(default)]
    pub bias_m: S,
    /// Resolution, m; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_m: NonNegative,
}

/// Errors of a measured speed.
#[fields]
#[derive(Copy, Default)]
pub struct SpeedErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m/s: the noise density, m/s/sqrt(Hz), over the square root of
    /// twice the period.
    #[serde(default)]
    pub noise_m_s: NonNegative<S>,
    /// Constant error, m/s.
    #[serde(default)]
    pub bias_m_s: S,
    /// Resolution, m/s; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_m_s: NonNegative,
}

/// Errors of a measured acceleration.
#[fields]
#[derive(Copy, Default)]
pub struct AccelerationErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m/s^2: the noise density, m/s^2/sqrt(Hz), over the square
    /// root of twice the period.
    #[serde(default)]
    pub noise_m_s2: NonNegative<S>,
    /// Constant error, m/s^2.
    #[serde(default)]
    pub bias_m_s2: S,
    /// Resolution, m/s^2; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_m_s2: NonNegative,
}

/// Errors of a measured angular velocity.
#[fields]
#[derive(Copy, Default)]
pub struct RateErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, rad/s: the noise density, rad/s/sqrt(Hz), over the square
    /// root of twice the period.
    #[serde(default)]
    pub noise_rad_s: NonNegative<S>,
    /// Constant error, rad/s.
    #[serde(default)]
    pub bias_rad_s: S,
    /// Resolution, rad/s; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_rad_s: NonNegative,
}

/// Errors of a measured force.
#[fields]
#[derive(Copy, Default)]
pub struct ForceErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, N: the noise density, N/sqrt(Hz), over the square root of
    /// twice the period.
    #[serde(default)]
    pub noise_n: NonNegative<S>,
    /// Constant error, N.
    #[serde(default)]
    pub bias_n: S,
    /// Resolution, N; 0 for none. With a resolution the derivative of the measured value is 0.
    #[serde(default)]
    pub resolution_n: NonNegative,
}
