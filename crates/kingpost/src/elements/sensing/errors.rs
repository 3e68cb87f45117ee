//! Errors that a sensor adds to the truth: bias, white noise, a resolution, and drop-outs.

use crate::scalar::Scalar;
use crate::sea::waves::Noise;
use crate::spatial::Vector3;
use crate::state::digest;

/// The errors of one signal. Of a value x, sample k gives
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
    /// q; 0 is none.
    pub resolution: f64,
}

/// Failures of a sensor: at each sample one that works fails with the probability T / `mean_interval_s`, and one that
/// has failed works again with T / `mean_duration_s`, with the sampling period T. Both times are then geometrically
/// distributed with these means (Gilbert, *Bell System Technical Journal* 39, 1960, p. 1253).
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
/// Signals of one sensor, at most; the last channel is that of its drop-outs.
const SIGNALS: u64 = 64;

impl SensorNoise {
    /// The numbers of the sensor of this name in a run with this seed. A name has the same numbers whatever other
    /// sensors there are.
    pub fn new(seed: u64, name: &str) -> Self {
        Self { noise: Noise::new(seed), channel: CHANNELS_OF_SENSORS | (digest(name.as_bytes()) & !(SIGNALS - 1)) }
    }

    /// n_k of a signal.
    pub fn normal(&self, signal: usize, sample: u64) -> f64 {
        self.noise.normal(self.channel + signal as u64, sample)
    }

    /// A number from (0, 1) that decides whether the sensor works at a sample.
    pub fn uniform(&self, sample: u64) -> f64 {
        self.noise.uniform(self.channel + SIGNALS - 1, sample)
    }
}

impl<S: Scalar> SignalErrors<S> {
    /// The value with its errors at a sample. Its derivative is that of a staircase where there is a resolution: 0.
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

/// Three components with the same errors each, as the signals from `first` on; without errors, themselves.
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
