//! An inertial unit: accelerometers, gyroscopes and a filter that estimates the motion of a body.

pub(crate) mod assembly;
pub(crate) mod fields;
mod gains;
mod navigation;

pub use gains::{Assumed, Design, KalmanGains};
pub use navigation::{Increments, Moving, Navigation};

use super::hull::{HullFrame, HullMotion};
use super::motion_reference_unit::{KEPT, motion};
use super::sensing::{PositionAid, ReceiverSample, Sampler, SensorNoise, SignalErrors, with_errors};
use super::{Components, Context, Declaration, Element, ElementState, Occurrence, Output, VectorFrame};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, exp, roll_pitch_yaw};

/// Estimates attitude, angular velocity, displacement and velocity of a point of a body by an error-state Kalman
/// filter: strapdown integration of its accelerometers and gyroscopes, whose estimated errors are corrected at every
/// sample. The corrections use the heading from a gyrocompass, and either the assumption that the ship moves in waves
/// about a mean position, or positions from a satellite receiver on the same body. The gains are stationary
/// ([`Design`]): the filter starts with the estimate to which it converges at rest.
///
/// (Groves, *Principles of GNSS, Inertial, and Multisensor Integrated Navigation Systems*, 2nd ed., 2013, ch. 5 and 14.)
#[derive(Clone, Debug)]
pub struct InertialUnit<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the point.
    pub place: HullFrame<S>,
    /// The errors of its instruments.
    pub instruments: Instruments<S>,
    /// Sampling of its results, to which no further errors are added.
    pub sampler: Sampler<S>,
    /// The filter's constants.
    pub design: Design,
    /// Satellite receiver whose positions correct the estimate.
    pub receiver: Option<PositionAid<S>>,
}

/// Errors of an inertial unit's instruments; `None` for exact instruments.
#[derive(Clone, Copy, Debug, Default)]
pub struct Instruments<S = f64> {
    /// Errors of each component of the specific force, m/s^2.
    pub acceleration: Option<SignalErrors<S>>,
    /// Errors of each component of the angular velocity, rad/s.
    pub rate: Option<SignalErrors<S>>,
    /// Errors of the heading by the gyrocompass, rad.
    pub heading: Option<SignalErrors<S>>,
}

/// Signals: those of a motion, then the specific force.
const COUNT: usize = KEPT.len() + 3;
/// Index of the instruments' random numbers, after those of the signals.
const OF_INSTRUMENTS: usize = 32;
/// Numbers after the sampler's: the estimate; the exact motion at the last sample; the angular velocity estimated then;
/// the mean position; and the offset that is subtracted from the receiver's positions, so that the first one equals the
/// estimated displacement.
const EXACT: usize = navigation::NUMBERS;
const RATE: usize = EXACT + navigation::OF_MOVING;
const MEAN: usize = RATE + 3;
const FIRST_FIX: usize = MEAN + 3;
const NUMBERS: usize = FIRST_FIX + 3;
/// Modes after the sampler's: whether the unit has begun; with a receiver, the number of its next position and whether
/// it has dropped out.
const MODES: [&str; 3] = ["has_begun", "next_fix", "receiver_out"];
const HAS_BEGUN: usize = 0;
const NEXT_FIX: usize = 1;
const RECEIVER_OUT: usize = 2;
/// Number of wave periods over which the mean position is averaged.
const MEAN_OVER: f64 = 10.0;

impl<S: Scalar> Element<S> for InertialUnit<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let mut outputs = motion(&self.name, true);
        outputs.push(Output {
            components: Components::Axis,
            frame: VectorFrame::Body,
            ..Output::number(
                "measured_specific_force",
                "measured specific force: acceleration less that of gravity",
                "sensor",
                &self.name,
                &["m/s^2"],
            )
        });
        let names: Vec<&str> = KEPT.into_iter().chain(["force_x", "force_y", "force_z"]).collect();
        let mut declaration = self.sampler.declaration(&self.name, &names, outputs);
        declaration.numbers.extend((0..NUMBERS).map(|number| format!("filter_{number}")));
        declaration.modes.extend(MODES[..self.modes()].iter().map(ToString::to_string));
        declaration.reads = self.receiver.iter().flat_map(PositionAid::columns).collect();
        declaration
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let (now, gravity) = (self.place.motion(at), at.world.gravity);
        let exact = moving(&now);
        let up = Vector3([S::ZERO, S::ZERO, gravity]);
        let at_rest = Increments { specific_force: exact.rotation.transpose_times(up), rate: Vector3::zero() };
        let seen = self.instruments.with_bias(&at_rest);
        let heading = Vector3([S::ZERO, S::ZERO, self.instruments.heading.map_or(S::ZERO, |errors| errors.bias)]);
        let turned = Moving { rotation: exp(heading) * exact.rotation, ..exact };
        let estimate = Navigation::settled(turned, &seen, gravity);
        let kept = &mut own.numbers[self.sampler.numbers()..];
        estimate.write(kept);
        exact.write(&mut kept[EXACT..]);
        now.twist.angular.write_to(&mut kept[RATE..]);
        self.sampler.begin(own, &signals(&estimate, now.twist.angular, seen.specific_force));
    }

    /// Takes the receiver's position if there is a new one.
    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let Some(receiver) = &self.receiver else { return Ok(Vec::new()) };
        let modes = &mut own.modes[self.sampler.modes()..];
        let sample = receiver.sample(at.clock.time_s, read, &mut modes[NEXT_FIX]);
        let Some(ReceiverSample { is_first, delivers }) = sample else { return Ok(Vec::new()) };
        modes[RECEIVER_OUT] = i64::from(!delivers);
        if delivers {
            self.take(receiver, read, is_first, &mut own.numbers[self.sampler.numbers()..]);
        }
        Ok(Vec::new())
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        // The start is not the end of a sampling interval: the estimate is then that of the start.
        let modes = &mut own.modes[self.sampler.modes()..];
        if core::mem::replace(&mut modes[HAS_BEGUN], 1) == 0 {
            return;
        }
        let has_fixes = self.receiver.is_some() && modes[RECEIVER_OUT] == 0;
        let kept = &mut own.numbers[self.sampler.numbers()..];
        let exact = moving(&self.place.motion(at));
        let (sample, gravity) = (self.sampler.sample_at(at.clock.time_s), at.world.gravity);
        let increments = exact.since(&Moving::read(&kept[EXACT..]), gravity, self.sampler.period_s);
        let measured = self.instruments.measure(&increments, &self.sampler.noise, sample);
        let mut estimate = Navigation::read(kept);
        estimate.advance(&measured, gravity, &self.design);
        if !has_fixes {
            let from_mean = estimate.from_mean(Vector3::from_slice(&kept[MEAN..]));
            estimate.correct(from_mean, &self.design.mean);
        }
        let heading = self.instruments.heading(&exact, &self.sampler.noise, sample);
        estimate.correct_heading(heading, &self.design);
        estimate.write(kept);
        exact.write(&mut kept[EXACT..]);
        let rate = estimate.rate(&measured);
        rate.write_to(&mut kept[RATE..]);
        self.sampler.take(at.clock.time_s, own, &signals(&estimate, rate, measured.specific_force));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at, out, || {
            let now = self.place.motion(at);
            let (exact, up) = (moving(&now), Vector3([S::ZERO, S::ZERO, at.world.gravity]));
            let known = Navigation { displacement: now.frame.position, ..Navigation::without_errors(exact) };
            signals(&known, now.twist.angular, exact.rotation.transpose_times(up))
        });
    }
}

impl<S: Scalar> InertialUnit<S> {
    /// Number of its signals.
    pub const SIGNALS: usize = COUNT;

    fn modes(&self) -> usize {
        if self.receiver.is_some() { MODES.len() } else { NEXT_FIX }
    }

    /// Corrects the estimate by a position of the receiver, which also changes the mean position.
    fn take(&self, receiver: &PositionAid<S>, read: &[S], is_first: bool, kept: &mut [S]) {
        let mut estimate = Navigation::read(kept);
        let Moving { rotation, velocity } = estimate.moving;
        let rate = Vector3::from_slice(&kept[RATE..]);
        let fix = receiver.fix(read, (rotation, rate), velocity);
        if is_first {
            (fix - estimate.displacement).write_to(&mut kept[FIRST_FIX..]);
        }
        let place = fix - Vector3::from_slice(&kept[FIRST_FIX..]);
        if let Some(gains) = &self.design.fix {
            estimate.correct(place - estimate.displacement, gains);
        }
        estimate.write(kept);
        let share = (receiver.period_s / (MEAN_OVER * self.design.motion_period_s)).min(1.0);
        let mean = Vector3::from_slice(&kept[MEAN..]);
        (mean + (place - mean) * S::constant(share)).write_to(&mut kept[MEAN..]);
    }
}

impl<S: Scalar> Instruments<S> {
    /// Returns the increments with their biases only.
    fn with_bias(&self, of: &Increments<S>) -> Increments<S> {
        let bias = |errors: Option<SignalErrors<S>>| errors.map_or(Vector3::zero(), |errors| Vector3([errors.bias; 3]));
        Increments { specific_force: of.specific_force + bias(self.acceleration), rate: of.rate + bias(self.rate) }
    }

    /// Returns the increments with all errors of a sample.
    fn measure(&self, of: &Increments<S>, noise: &SensorNoise, sample: u64) -> Increments<S> {
        Increments {
            specific_force: with_errors(of.specific_force, self.acceleration, noise, OF_INSTRUMENTS, sample),
            rate: with_errors(of.rate, self.rate, noise, OF_INSTRUMENTS + 3, sample),
        }
    }

    /// Returns the heading measured by the gyrocompass, rad.
    fn heading(&self, exact: &Moving<S>, noise: &SensorNoise, sample: u64) -> S {
        let yaw = roll_pitch_yaw(&exact.rotation)[2];
        self.heading.map_or(yaw, |errors| errors.on(yaw, noise, OF_INSTRUMENTS + 6, sample))
    }
}

fn moving<S: Scalar>(now: &HullMotion<S>) -> Moving<S> {
    let rotation = now.frame.rotation;
    Moving { rotation, velocity: rotation * now.twist.linear }
}

/// Returns the signals of the unit, in the order of [`KEPT`]; then the specific force.
fn signals<S: Scalar>(found: &Navigation<S>, rate: Vector3<S>, specific_force: Vector3<S>) -> [S; COUNT] {
    let [roll, pitch, yaw] = roll_pitch_yaw(&found.moving.rotation).0;
    let ([x, y, z], [x_velocity, y_velocity, z_velocity]) = (found.displacement.0, found.moving.velocity.0);
    let ([p, q, r], [f_x, f_y, f_z]) = (rate.0, specific_force.0);
    [roll, pitch, z, z_velocity, p, q, r, x, x_velocity, y, y_velocity, yaw, f_x, f_y, f_z]
}
