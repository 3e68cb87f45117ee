//! Errors of a sensor: bias, white noise, resolution and drop-outs.

use crate::scalar::Scalar;
use crate::sea::waves::Noise;
use crate::spatial::Vector3;
use crate::state::digest;

/// Errors of one signal. Sample k of a value x is
///
/// ```text
/// y_k = q round((x + b + sigma n_k) / q),    or without a resolution q    y_k = x + b + sigma n_k
/// ```
///
/// with the bias b and independent numbers n_k of the normal distribution. White noise of the one-sided density N^2
/// (unit squared per Hz) has the standard deviation sigma = N / sqrt(2 T) at the sampling period T (IEEE Std 952-1997,
/// annex C).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SignalErrors<S = f64> {
    /// sigma, in the signal's unit.
    pub noise: S,
    /// b.
    pub bias: S,
    /// q; 0 for no resolution.
    pub resolution: f64,
}

/// Drop-outs of a sensor: at each sample, a working sensor drops out with the probability T / `mean_interval_s`, and a
/// sensor that has dropped out works again with the probability T / `mean_duration_s`, with the sampling period T. Both
/// times are then geometrically distributed with these means (Gilbert, *Bell System Technical Journal* 39, 1960, p.
/// 1253).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropOuts {
    /// Mean time from the end of a drop-out to the next, s.
    pub mean_interval_s: f64,
    /// Mean duration, s.
    pub mean_duration_s: f64,
}

/// The random numbers of one sensor: a function of the run's seed, the sensor's name, the signal and the sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SensorNoise {
    noise: Noise,
    channel: u64,
}

/// The channels of sensors have this bit; waves and gusts use small numbers.
const CHANNELS_OF_SENSORS: u64 = 1 << 63;
/// Largest number of signals of one sensor; the last channel is used for its drop-outs.
const SIGNALS: u64 = 64;

impl SensorNoise {
    /// Returns the random numbers of the sensor with this name in a run with this seed. They do not depend on other
    /// sensors.
    pub fn new(seed: u64, name: &str) -> Self {
        Self { noise: Noise::new(seed), channel: CHANNELS_OF_SENSORS | (digest(name.as_bytes()) & !(SIGNALS - 1)) }
    }

    /// Returns n_k of a signal.
    pub fn normal(&self, signal: usize, sample: u64) -> f64 {
        self.noise.normal(self.channel + signal as u64, sample)
    }

    /// Returns a number from (0, 1) that determines whether the sensor works at a sample.
    pub fn uniform(&self, sample: u64) -> f64 {
        self.noise.uniform(self.channel + SIGNALS - 1, sample)
    }
}

impl<S: Scalar> SignalErrors<S> {
    /// Returns the value with its errors at a sample. With a resolution the value is a staircase, whose derivative is
    /// 0.
    pub fn on(&self, value: S, noise: &SensorNoise, signal: usize, sample: u64) -> S {
        let noisy = value + self.bias;
        let noisy = if S::HAS_DERIVATIVES || !self.noise.all(|sigma| sigma == 0.0) {
            noisy + self.noise * S::constant(noise.normal(signal, sample))
        } else {
            noisy
        };
        if self.resolution == 0.0 {
            return noisy;
        }
        let [steps] = S::from_values([noisy * S::constant(1.0 / self.resolution)], &|[steps]| [libm::round(steps)]);
        steps * S::constant(self.resolution)
    }
}

/// Returns three components with the same errors each, as the signals from `first` on; without errors, the components
/// unchanged.
pub fn with_errors<S: Scalar>(
    values: Vector3<S>,
    errors: Option<SignalErrors<S>>,
    noise: &SensorNoise,
    first: usize,
    sample: u64,
) -> Vector3<S> {
    let Some(errors) = errors else { return values };
    Vector3([0, 1, 2].map(|axis| errors.on(values[axis], noise, first + axis, sample)))
}
