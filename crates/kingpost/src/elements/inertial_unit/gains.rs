//! The stationary gains of the error-state Kalman filter of an inertial unit.

use super::super::sensing::{Oscillating, Process, RATE_WANDERS, first};
use nalgebra::DVector;

/// Assumptions of the filter about its unit and the sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assumed {
    /// Sampling period T of the unit, s.
    pub period_s: f64,
    /// Standard deviation of the white noise of an acceleration in a sample, m/s^2.
    pub acceleration_noise: f64,
    /// Standard deviation of the white noise of an angular velocity in a sample, rad/s.
    pub rate_noise: f64,
    /// Standard deviation of the white noise of the heading in a sample, rad.
    pub heading_noise: f64,
    /// Standard deviation of the motion in waves along each axis, m.
    pub motion_m: f64,
    /// Peak period of the motion in waves, s.
    pub motion_period_s: f64,
    /// Satellite receiver: its period (s) and the standard deviation of its noise (m).
    pub receiver: Option<[f64; 2]>,
}

/// The gains of one innovation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KalmanGains {
    /// Gains of a horizontal channel: displacement, velocity, tilt, error of the rate, both states of the motion in
    /// waves.
    pub level: [f64; 6],
    /// Gains of the vertical channel: displacement, velocity, error of the acceleration, both states of the motion in
    /// waves.
    pub vertical: [f64; 5],
}

/// The filter's constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design {
    /// T, s.
    pub period_s: f64,
    /// Peak period of the motion in waves, s.
    pub motion_period_s: f64,
    /// Transition of the states of the motion in waves over T.
    pub waves: Oscillating,
    /// Gains at every sample, if only the mean position is known.
    pub mean: KalmanGains,
    /// Gains at a position of the receiver.
    pub fix: Option<KalmanGains>,
    /// Gains of the heading: angle and error of the rate, at every sample.
    pub heading: [f64; 2],
}

/// Random walk of the error of an accelerometer, m/s^2 per root second.
const ACCELERATION_WANDERS: f64 = 1e-5;
const GRAVITY_M_S2: f64 = 9.80665;

impl Design {
    /// Designs the filter for these assumptions. The errors of a horizontal channel and of the vertical channel obey
    ///
    /// ```text
    /// dp' = dv,  dv' = g dtheta + a,  dtheta' = -db + w         horizontal
    /// dp' = dv,  dv' = -db + a                                  vertical
    /// ```
    ///
    /// with the white noises a and w of the accelerometers and gyroscopes, and the random walk b of the error of a
    /// gyroscope or an accelerometer (Groves, *Principles of GNSS, Inertial, and Multisensor Integrated Navigation
    /// Systems*, 2nd ed., 2013, ch. 14). The position of the ship is the mean position plus the motion in waves, an
    /// [oscillation](Process::oscillation). With this model the filter does not mistake waves for errors, and changes
    /// neither their phase nor their amplitude.
    pub fn new(of: &Assumed) -> Self {
        let (level, vertical) = (level(of), vertical(of));
        let waves = Process::oscillation(of.motion_period_s, of.motion_m, of.period_s);
        let mean = |chain: &Process| chain.gain_about_zero(&waves, of.motion_m);
        let fix = |chain: &Process, [period_s, deviation]: [f64; 2]| {
            let samples = libm::round(period_s / of.period_s).max(1.0);
            chain.after(samples).gain(&first(chain.size()), deviation)
        };
        Self {
            period_s: of.period_s,
            motion_period_s: of.motion_period_s,
            waves: Oscillating::of(&waves),
            mean: KalmanGains { level: padded(&mean(&level)), vertical: padded(&mean(&vertical)) },
            fix: of.receiver.map(|receiver| KalmanGains {
                level: padded(&fix(&level, receiver)),
                vertical: padded(&fix(&vertical, receiver)),
            }),
            heading: padded(&Process::of_angle(of.rate_noise, of.period_s).gain(&first(2), of.heading_noise)),
        }
    }

    /// Whether such a filter exists: its gains are finite.
    pub fn is_finite(&self) -> bool {
        let of = |gains: &KalmanGains| gains.level.iter().chain(&gains.vertical).all(|gain| gain.is_finite());
        of(&self.mean) && self.fix.as_ref().is_none_or(of) && self.heading.iter().all(|gain| gain.is_finite())
    }
}

/// Returns the process of a horizontal channel: displacement, velocity, tilt, error of the rate.
fn level(of: &Assumed) -> Process {
    let noises = [0.0, of.acceleration_noise * of.period_s, of.rate_noise * of.period_s, RATE_WANDERS * root(of)];
    Process::chain(&[1.0, GRAVITY_M_S2, -1.0], of.period_s, &noises)
}

/// Returns the process of the vertical channel: displacement, velocity, error of the acceleration.
fn vertical(of: &Assumed) -> Process {
    let noises = [0.0, of.acceleration_noise * of.period_s, ACCELERATION_WANDERS * root(of)];
    Process::chain(&[1.0, -1.0], of.period_s, &noises)
}

fn root(of: &Assumed) -> f64 {
    libm::sqrt(of.period_s)
}

fn padded<const N: usize>(gain: &DVector<f64>) -> [f64; N] {
    core::array::from_fn(|i| gain.get(i).copied().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    const ASSUMED: Assumed = Assumed {
        period_s: 0.02,
        acceleration_noise: 0.002,
        rate_noise: 4.4e-4,
        heading_noise: 2e-3,
        motion_m: 0.3,
        motion_period_s: 9.0,
        receiver: Some([0.1, 0.02]),
    };

    /// The filter attributes a motion of the assumed period to the waves, so its error in the estimate is small. A
    /// filter without a wave model has an error of the share 2 zeta w0 / w of the motion, 13 % at a cut-off of 100 s.
    #[test]
    fn the_estimate_keeps_phase_and_amplitude_of_a_regular_wave_of_the_assumed_period() {
        let design = Design::new(&ASSUMED);
        let frequency = core::f64::consts::TAU / ASSUMED.motion_period_s;
        let (gain, mut error, mut largest) = (design.mean.vertical, [0.0; 5], [0.0_f64; 2]);
        // The errors of the filter, with the wave as the deviation from the mean position.
        let transition = vertical(&ASSUMED).transition;
        for k in 0..200_000 {
            let moved = &transition * DVector::from_row_slice(&error[..3]);
            let waves = design.waves.onward([error[3], error[4]]);
            error = [moved[0], moved[1], moved[2], waves[0], waves[1]];
            let wave = libm::sin(frequency * ASSUMED.period_s * f64::from(k));
            let innovation = -wave - error[0] + error[4];
            (0..5).for_each(|i| error[i] += gain[i] * innovation);
            if k > 150_000 {
                largest = [0, 1].map(|i| largest[i].max(error[i].abs()));
            }
        }
        assert!(largest[0] < 0.03 && largest[1] < 0.01 * frequency, "{largest:?}");
    }

    /// After a long time without a position the next position has the gain 1, as far as the range of numbers allows.
    #[test]
    fn a_receiver_with_very_rare_positions_has_the_gain_1_and_takes_no_longer_to_compute() {
        for period_s in [1e5, 1e9, 1e300, f64::INFINITY] {
            let design = Design::new(&Assumed { receiver: Some([period_s, 0.02]), ..ASSUMED });
            let gain = design.fix.map_or(0.0, |fix| fix.vertical[0]);
            assert!(gain > 0.999 && gain <= 1.0 || !design.is_finite(), "{period_s}: {gain}");
        }
    }

    /// The filter follows a receiver with little noise faster than one with much noise, and its bandwidth never exceeds
    /// that of the receiver's samples.
    #[test]
    fn a_receiver_with_less_noise_has_larger_gains() {
        let gain = |noise: f64| {
            let design = Design::new(&Assumed { receiver: Some([0.1, noise]), ..ASSUMED });
            design.fix.map_or(0.0, |fix| fix.vertical[0])
        };
        assert!(gain(0.01) > gain(0.1) && gain(0.1) > gain(1.0) && gain(0.01) < 1.0 && gain(1.0) > 0.0);
    }
}
