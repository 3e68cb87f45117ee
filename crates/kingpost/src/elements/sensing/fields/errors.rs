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
    /// Standard deviation of its white noise in a sample, rad: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_rad: NonNegative<S>,
    /// Constant error, rad.
    #[serde(default)]
    pub bias_rad: S,
    /// Smallest step, rad; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_rad: NonNegative,
}

/// Errors of a measured length or height.
#[fields]
#[derive(Copy, Default)]
pub struct LengthErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_m: NonNegative<S>,
    /// Constant error, m.
    #[serde(default)]
    pub bias_m: S,
    /// Smallest step, m; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_m: NonNegative,
}

/// Errors of a measured speed.
#[fields]
#[derive(Copy, Default)]
pub struct SpeedErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m/s: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_m_s: NonNegative<S>,
    /// Constant error, m/s.
    #[serde(default)]
    pub bias_m_s: S,
    /// Smallest step, m/s; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_m_s: NonNegative,
}

/// Errors of a measured acceleration.
#[fields]
#[derive(Copy, Default)]
pub struct AccelerationErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, m/s^2: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_m_s2: NonNegative<S>,
    /// Constant error, m/s^2.
    #[serde(default)]
    pub bias_m_s2: S,
    /// Smallest step, m/s^2; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_m_s2: NonNegative,
}

/// Errors of a measured angular velocity.
#[fields]
#[derive(Copy, Default)]
pub struct RateErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, rad/s: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_rad_s: NonNegative<S>,
    /// Constant error, rad/s.
    #[serde(default)]
    pub bias_rad_s: S,
    /// Smallest step, rad/s; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_rad_s: NonNegative,
}

/// Errors of a measured force.
#[fields]
#[derive(Copy, Default)]
pub struct ForceErrors<S = f64> {
    /// Standard deviation of its white noise in a sample, N: the density per root hertz over the root of twice the
    /// period.
    #[serde(default)]
    pub noise_n: NonNegative<S>,
    /// Constant error, N.
    #[serde(default)]
    pub bias_n: S,
    /// Smallest step, N; 0 is none. Derivatives do not go through it.
    #[serde(default)]
    pub resolution_n: NonNegative,
}
