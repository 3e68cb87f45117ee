//! A swing estimator: gyroscopes on a load or a hook, and the filter that estimates the inclination.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::motion_reference_unit::inclination;
use crate::elements::sensing::{Oscillating, Process, Sampler, SignalErrors, with_errors};
use crate::elements::{Context, Declaration, Element, ElementState};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3, exp, log_of_part_turn};

/// Estimates roll, pitch and angular velocity of a hanging body from gyroscopes on it. Accelerometers do not help:
/// under a rope they measure along the rope at any angle. To correct the drift of the gyroscopes, an error-state Kalman
/// filter uses the swing of the body about the vertical with an approximately known period: the swing about two axes is
/// among its states. The gains are stationary ([`SwingFilter`]): the filter starts with the estimate to which it
/// converges at rest.
///
/// (Groves, *Principles of GNSS, Inertial, and Multisensor Integrated Navigation Systems*, 2nd ed., 2013, ch. 5 and 14;
/// gyroscopes in the hook: Neupert, Arnold, Schneider & Sawodny, *Control Engineering Practice* 18, 2010, p. 31.)
#[derive(Clone, Debug)]
pub struct SwingEstimator<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body.
    pub body: usize,
    /// The errors of each gyroscope, rad/s.
    pub rate_errors: Option<SignalErrors<S>>,
    /// Sampling of its results, to which no further errors are added.
    pub sampler: Sampler<S>,
    /// The filter's constants.
    pub filter: SwingFilter,
}

/// The constants of the filter of a swing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingFilter {
    /// Sampling period T, s.
    pub period_s: f64,
    /// Transition over T of the states of the swing about an axis: its integral and the swing.
    pub swing: Oscillating,
    /// Gains about an axis: angle, error of the rate, both states of the swing.
    pub gains: [f64; 4],
}

impl SwingFilter {
    /// Designs the filter for a sampling period, white noise of this standard deviation in a sample of a gyroscope
    /// (rad/s), and a swing of this standard deviation (rad) and peak period. The error of the angle about a level axis
    /// and that of the rate obey `dtheta' = -db + w`; the angle is an [oscillation](Process::oscillation) about zero.
    pub fn new(period_s: f64, rate_noise: f64, swing_rad: f64, swing_period_s: f64) -> Self {
        let swing = Process::oscillation(swing_period_s, swing_rad, period_s);
        let gain = Process::of_angle(rate_noise, period_s).gain_about_zero(&swing, swing_rad);
        Self { period_s, swing: Oscillating::of(&swing), gains: [0, 1, 2, 3].map(|state| gain[state]) }
    }

    /// Whether such a filter exists: its gains are finite.
    pub fn is_finite(&self) -> bool {
        self.gains.iter().all(|gain| gain.is_finite())
    }
}

/// Signals: roll, pitch, angular velocity.
const KEPT: [&str; 5] = ["roll", "pitch", "x_rate", "y_rate", "z_rate"];
/// Numbers after the sampler's: the estimate; then the exact attitude at the last sample.
const EXACT: usize = 10;
const NUMBERS: usize = EXACT + 9;

impl<S: Scalar> Element<S> for SwingEstimator<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let mut declaration = self.sampler.declaration(&self.name, &KEPT, inclination(&self.name).into());
        declaration.numbers.extend((0..NUMBERS).map(|number| format!("filter_{number}")));
        declaration.modes.push("has_begun".to_owned());
        declaration
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let (rotation, rate) = self.exact(at);
        let bias = self.rate_errors.map_or(S::ZERO, |errors| errors.bias);
        let estimate = VerticalEstimate::settled(rotation.row(2), Vector3([bias; 3]));
        let kept = &mut own.numbers[self.sampler.numbers()..];
        estimate.write(kept);
        kept[EXACT..NUMBERS].copy_from_slice(rotation.0.as_flattened());
        self.sampler.begin(own, &estimate.signals(rate));
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        // The start is not the end of a sampling interval: the estimate is then that of the start.
        if core::mem::replace(&mut own.modes[self.sampler.modes()], 1) == 0 {
            return;
        }
        let kept = &mut own.numbers[self.sampler.numbers()..];
        let (rotation, _) = self.exact(at);
        let before = Matrix3::from_fn(|i, j| kept[EXACT + 3 * i + j]);
        let turn = log_of_part_turn(&(before.transpose() * rotation));
        let exact = turn * S::constant(1.0 / self.sampler.period_s);
        let sample = self.sampler.sample_at(at.clock.time_s);
        let measured = with_errors(exact, self.rate_errors, &self.sampler.noise, KEPT.len(), sample);
        let mut estimate = VerticalEstimate::read(kept);
        let rate = estimate.advance(measured, &self.filter);
        estimate.write(kept);
        kept[EXACT..NUMBERS].copy_from_slice(rotation.0.as_flattened());
        self.sampler.take(at.clock.time_s, own, &estimate.signals(rate));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at, out, || {
            let (rotation, rate) = self.exact(at);
            VerticalEstimate::settled(rotation.row(2), Vector3::zero()).signals(rate)
        });
    }
}

impl<S: Scalar> SwingEstimator<S> {
    /// Number of its signals.
    pub const SIGNALS: usize = KEPT.len();

    /// Returns attitude, and angular velocity in body axes.
    fn exact(&self, at: &Context<'_, S>) -> (Matrix3<S>, Vector3<S>) {
        let rotation = at.links.body_frame(at.model, self.body).rotation;
        (rotation, at.links.body_twist(at.model, self.body).angular)
    }
}

/// Estimate of the filter: the vertical, the errors of the gyroscopes and the swing.
#[derive(Clone, Copy, Debug)]
struct VerticalEstimate<S> {
    /// The vertical, body axes.
    up: Vector3<S>,
    /// Errors of the gyroscopes, body axes, rad/s.
    rate_errors: Vector3<S>,
    /// The swing about the body's x and y: its integral (rad s) and the swing (rad).
    states: [[S; 2]; 2],
}

impl<S: Scalar> VerticalEstimate<S> {
    /// Returns the estimate after a long time at rest, for a body with this vertical.
    fn settled(up: Vector3<S>, rate_errors: Vector3<S>) -> Self {
        let mut settled = Self { up, rate_errors, states: [[S::ZERO; 2]; 2] };
        settled.states = settled.inclination().map(|angle| [S::ZERO, angle]);
        settled
    }

    /// Reads the estimate from numbers of an element.
    fn read(numbers: &[S]) -> Self {
        let states = [0, 1].map(|axis| [numbers[6 + 2 * axis], numbers[7 + 2 * axis]]);
        Self { up: Vector3::from_slice(numbers), rate_errors: Vector3::from_slice(&numbers[3..]), states }
    }

    /// Writes the estimate to numbers of an element.
    fn write(&self, numbers: &mut [S]) {
        self.up.write_to(numbers);
        self.rate_errors.write_to(&mut numbers[3..]);
        numbers[6..EXACT].copy_from_slice(self.states.as_flattened());
    }

    /// Returns roll and pitch, rad.
    fn inclination(&self) -> [S; 2] {
        let [x, y, z] = self.up.0;
        [y.atan2(z), (-x).atan2((y * y + z * z).sqrt())]
    }

    fn signals(&self, rate: Vector3<S>) -> [S; KEPT.len()] {
        let ([roll, pitch], [x, y, z]) = (self.inclination(), rate.0);
        [roll, pitch, x, y, z]
    }

    /// Advances the estimate by one sample and corrects it; returns the angular velocity less its estimated error. The
    /// axes of the swing turn with the body about the vertical.
    fn advance(&mut self, measured: Vector3<S>, filter: &SwingFilter) -> Vector3<S> {
        let turn = (measured - self.rate_errors) * S::constant(filter.period_s);
        self.up = exp(-turn) * self.up;
        let [about_x, about_y] = self.states.map(|states| filter.swing.onward(states));
        let (sine, cosine) = turn[2].sin_cos();
        self.states = [
            [0, 1].map(|state| cosine * about_x[state] + sine * about_y[state]),
            [0, 1].map(|state| cosine * about_y[state] - sine * about_x[state]),
        ];
        self.correct(filter);
        measured - self.rate_errors
    }

    /// Corrects the estimate by the difference between the swing and the estimated inclination, which should be equal.
    fn correct(&mut self, filter: &SwingFilter) {
        let [x, y] = [0, 1].map(|axis| self.states[axis][1] - self.inclination()[axis]);
        let [angle, rate, integral, swing] = filter.gains.map(S::constant);
        let about = |gain: S| Vector3([gain * x, gain * y, S::ZERO]);
        self.up = exp(-about(angle)) * self.up;
        self.rate_errors += about(rate);
        for (states, innovation) in self.states.iter_mut().zip([x, y]) {
            states[0] += integral * innovation;
            states[1] += swing * innovation;
        }
    }
}
