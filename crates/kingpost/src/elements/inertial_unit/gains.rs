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
    /// That of an angular velocity, rad/s.
    pub rate_noise: f64,
    /// That of the heading, rad.
    pub heading_noise: f64,
    /// Standard deviation of the motion in waves along each axis, m.
    pub motion_m: f64,
    /// Its middle period, s.
    pub motion_period_s: f64,
    /// A receiver of positions: its period (s) and the standard deviation of its noise, m.
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
    /// Middle period of the motion in waves, s.
    pub motion_period_s: f64,
    /// How the states of the motion in waves change in T.
    pub waves: Oscillating,
    /// Where nothing but the mean place is known, at every sample.
    pub mean: KalmanGains,
    /// At a position of the receiver.
    pub fix: Option<KalmanGains>,
    /// Gains of the heading: angle and error of the rate, at every sample.
    pub heading: [f64; 2],
}

/// How fast the error of an accelerometer wanders: m/s^2 in the root of a second.
const ACCELERATION_WANDERS: f64 = 1e-5;
const GRAVITY_M_S2: f64 = 9.80665;

impl Design {
    /// The filter for these assumptions. The errors of a horizontal channel and of the vertical one obey
    ///
    /// ```text
    /// dp' = dv,  dv' = g dtheta + a,  dtheta' = -db + w         horizontal
    /// dp' = dv,  dv' = -db + a                                  vertical
    /// ```
    ///
    /// with the white noises a and w of the accelerometers and gyroscopes and the wandering error b of a gyroscope or
    /// an accelerometer (Groves, *Principles of GNSS, Inertial, and Multisensor Integrated Navigation Systems*, 2nd ed.,
    /// 2013, ch. 14). The ship stays about its mean place but for the motion in waves, an
    /// [oscillation](Process::oscillation): a filter that knows it does not take waves for errors, and shifts neither their
    /// phase nor their size.
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

    /// Whether such a filter exists: its gains are numbers.
    pub fn is_finite(&self) -> bool {
        let of = |gains: &KalmanGains| gains.level.iter().chain(&gains.vertical).all(|gain| gain.is_finite());
        of(&self.mean) && self.fix.as_ref().is_none_or(of) && self.heading.iter().all(|gain| gain.is_finite())
    }
}

/// Displacement, velocity, tilt, error of the rate.
fn level(of: &Assumed) -> Process {
    let noises = [0.0, of.acceleration_noise * of.period_s, of.rate_noise * of.period_s, RATE_WANDERS * root(of)];
    Process::chain(&[1.0, GRAVITY_M_S2, -1.0], of.period_s, &noises)
}

/// Displacement, velocity, error of the acceleration.
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

    /// The model of the waves explains a motion of its own period: little of it is left in the estimate. A filter without such
    /// a model takes over the share 2 zeta w0 / w of it, 13 % at a cut-off of 100 s.
    #[test]
    fn a_regular_wave_of_the_assumed_period_passes_with_its_phase_and_size() {
        let design = Design::new(&ASSUMED);
        let frequency = core::f64::consts::TAU / ASSUMED.motion_period_s;
        let (gain, mut error, mut largest) = (design.mean.vertical, [0.0; 5], [0.0_f64; 2]);
        // The errors of the filter, driven by the wave as the distance from the mean place.
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

    /// After a long time without a position the next counts fully, as far as numbers reach.
    #[test]
    fn a_receiver_that_is_hardly_ever_heard_counts_fully_and_takes_no_longer() {
        for period_s in [1e5, 1e9, 1e300, f64::INFINITY] {
            let design = Design::new(&Assumed { receiver: Some([period_s, 0.02]), ..ASSUMED });
            let gain = design.fix.map_or(0.0, |fix| fix.vertical[0]);
            assert!(gain > 0.999 && gain <= 1.0 || !design.is_finite(), "{period_s}: {gain}");
        }
    }

    /// A receiver with little noise is followed faster than one with much, and the bandwidth is never above its samples'.
    #[test]
    fn less_noise_of_the_receiver_gives_it_more_weight() {
        let gain = |noise: f64| {
            let design = Design::new(&Assumed { receiver: Some([0.1, noise]), ..ASSUMED });
            design.fix.map_or(0.0, |fix| fix.vertical[0])
        };
        assert!(gain(0.01) > gain(0.1) && gain(0.1) > gain(1.0) && gain(0.01) < 1.0 && gain(1.0) > 0.0);
    }
}
