//! A motion reference unit: a sensor of a body's motion, with its own sampling period.

pub mod assembly;
pub mod fields;

use super::hull::HullFrame;
use super::sensing::{PositionAid, ReceiverSample, Sampler};
use super::{
    Components, Context, Declaration, Element, ElementState, Occurrence, Output, StateDeclaration, VectorFrame,
};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, roll_pitch_yaw, rotation_from_roll_pitch_yaw};

/// Measures the motion of a point of a body at every sample, and outputs it with a delay of whole samples.
///
/// Heave is the height of the point relative to the start of the run; with a [`HeaveFilter`], its deviation from a slow
/// average. The outputs are constant between two samples; until the first delayed sample arrives, they have the values
/// measured at the start.
#[derive(Clone, Debug)]
pub struct MotionReferenceUnit<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the point.
    pub place: HullFrame<S>,
    /// Whether it also measures its horizontal motion and its yaw.
    pub horizontal: bool,
    /// Sampling of its signals.
    pub sampler: Sampler<S>,
    /// The filter of heave, of the horizontal motion and of their rates; without it they are unfiltered.
    pub heave_filter: Option<HeaveFilter<S>>,
    /// The satellite receiver that restores the slow motion removed by the filter.
    pub receiver: Option<PositionAid<S>>,
}

/// Heave filter of a unit that integrates its accelerations twice: a high-pass filter removes the drift,
///
/// ```text
/// y(s) / h(s) = s^2 / (s^2 + 2 zeta w s + w^2)
/// ```
///
/// with w = 2 pi over the cut-off period (Godhavn, "Adaptive tuning of heave filter in motion sensor", OCEANS '98, eqs.
/// 1-4). At the frequency omega it leads by atan2(2 zeta w omega, omega^2 - w^2). The states are the removed part a = h
/// - y and its rate: a'' + 2 zeta w a' + w^2 a = 2 zeta w h' + w^2 h.
///
/// A receiver on the same body restores the motion that the filter H removes. With the position g of the unit from the
/// receiver,
///
/// ```text
/// y = H h + (1 - H) g,    1 - H = (2 zeta w s + w^2) / (s^2 + 2 zeta w s + w^2)
/// ```
///
/// the complementary filter (Brown & Hwang, *Introduction to Random Signals and Applied Kalman Filtering*, 4th ed.,
/// 2012, sec. 8.10): with an exact g, y = h for any H, and the filter suppresses fast errors of g and slow errors of h.
/// Its states are the restored part b and c = b' - 2 zeta w g:
///
/// ```text
/// b' = c + 2 zeta w g,    c' = w^2 (g - b) - 2 zeta w b'
/// ```
#[derive(Clone, Copy, Debug)]
pub struct HeaveFilter<S = f64> {
    /// w, rad/s.
    pub cutoff: S,
    /// zeta.
    pub damping_ratio: S,
}

/// Roll, pitch, heave, heave rate, angular velocity; then the signals of horizontal motion.
const COUNT: usize = 12;
const VERTICAL_ONLY: usize = 7;
/// Names of the signals of a motion, in the order of its outputs.
pub(super) const KEPT: [&str; COUNT] =
    ["roll", "pitch", "heave", "heave_rate", "x_rate", "y_rate", "z_rate", "x", "x_velocity", "y", "y_velocity", "yaw"];
/// The axes with a filter in the order of its states: z, then x and y.
const FILTERED: [&str; 3] = ["heave", "x", "y"];

impl<S: Scalar> Element<S> for MotionReferenceUnit<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let parts = self.heave_filter.iter().map(|_| "removed").chain(self.receiver.iter().map(|_| "restored"));
        let states = parts.flat_map(|part| {
            FILTERED[..self.filtered()].iter().flat_map(move |axis| {
                let rate = format!("{part}_{axis}_rate");
                [StateDeclaration::memory(format!("{part}_{axis}"), "m"), StateDeclaration::memory(rate, "m/s")]
            })
        });
        let mut declaration =
            self.sampler.declaration(&self.name, &KEPT[..self.sampler.count()], motion(&self.name, self.horizontal));
        let kept = [&ZEROS].into_iter().chain(self.receiver.iter().flat_map(|_| [&FIXES, &FIX_RATES, &FIRST_FIXES]));
        declaration.numbers.extend(kept.flat_map(|names| &names[..self.filtered()]).map(ToString::to_string));
        declaration.modes.extend(self.receiver.iter().map(|_| "next_fix".to_owned()));
        let reads = self.receiver.iter().flat_map(PositionAid::columns).collect();
        Declaration { states: states.collect(), reads, ..declaration }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let (zeros, place) = (self.sampler.numbers(), self.place.frame(at.model, at.links).position.0);
        for axis in 0..self.filtered() {
            own.numbers[zeros + axis] = place[AXES[axis]];
        }
        let exact = self.exact(at, &own.numbers[zeros..]);
        for (state, velocity) in own.states.chunks_exact_mut(2).zip(PAIRS[..self.filtered()].iter().cycle()) {
            (state[0], state[1]) = (S::ZERO, exact[velocity[1]]);
        }
        let first = self.measured(at, &own.numbers[zeros..], own.states);
        self.sampler.begin(own, &first[..self.sampler.count()]);
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let (Some(filter), count) = (&self.heave_filter, self.filtered()) else { return };
        let numbers = &at.numbers[self.sampler.numbers()..];
        let exact = self.exact(at, numbers);
        let (damping, stiffness) = (filter.damping(), filter.cutoff * filter.cutoff);
        let (removed, restored) = at.states.split_at(2 * count);
        let (of_removed, of_restored) = rates.split_at_mut(2 * count);
        for (axis, [place, velocity]) in PAIRS[..count].iter().enumerate() {
            let (rates, state) = (&mut of_removed[2 * axis..], &removed[2 * axis..]);
            rates[0] = state[1];
            rates[1] = damping * (exact[*velocity] - state[1]) + stiffness * (exact[*place] - state[0]);
        }
        for axis in (0..count).filter(|_| self.receiver.is_some()) {
            let (rates, state, fix) =
                (&mut of_restored[2 * axis..], &restored[2 * axis..], self.given(at, numbers, axis));
            rates[0] = state[1] + damping * fix;
            rates[1] = stiffness * (fix - state[0]) - damping * rates[0];
        }
    }

    /// Takes the satellite receiver's position if there is a new one. During a drop-out of the receiver, the unit
    /// continues with its estimated motion.
    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let Some(receiver) = &self.receiver else { return Ok(Vec::new()) };
        let (next, count, kept) = (own.modes.len() - 1, self.filtered(), self.sampler.numbers());
        let sample = receiver.sample(at.clock.time_s, read, &mut own.modes[next]);
        let Some(ReceiverSample { is_first, delivers }) = sample else { return Ok(Vec::new()) };
        let found = self.measured(at, &own.numbers[kept..], own.states);
        let fix = self.fix(receiver, at.clock.time_s, read, &found);
        let numbers = &mut own.numbers[kept..];
        for axis in 0..count {
            let [place, velocity] = PAIRS[axis].map(|signal| found[signal]);
            if is_first {
                numbers[3 * count + axis] = fix[AXES[axis]] - place;
            }
            numbers[count + axis] = if delivers { fix[AXES[axis]] - numbers[3 * count + axis] } else { place };
            numbers[2 * count + axis] = velocity;
        }
        Ok(Vec::new())
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let now = self.measured(at, &own.numbers[self.sampler.numbers()..], own.states);
        self.sampler.take(at.clock.time_s, own, &now[..self.sampler.count()]);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at, out, || self.measured(at, &at.numbers[self.sampler.numbers()..], at.states));
    }
}

/// The axes of the world in the order of the filter's states.
const AXES: [usize; 3] = [2, 0, 1];
/// Signals of each filtered axis: displacement and velocity.
const PAIRS: [[usize; 2]; 3] = [[2, 3], [7, 8], [9, 10]];
/// Numbers after the sampler's, for each axis: the zero; with a receiver, the unit's position from the last received
/// one, relative to the start, the velocity of its extrapolation, and the position from the first received one.
const ZEROS: [&str; 3] = ["zero_height", "zero_x", "zero_y"];
const FIXES: [&str; 3] = ["fix_height", "fix_x", "fix_y"];
const FIX_RATES: [&str; 3] = ["fix_height_rate", "fix_x_rate", "fix_y_rate"];
const FIRST_FIXES: [&str; 3] = ["first_fix_height", "first_fix_x", "first_fix_y"];

/// Returns the outputs of a measured inclination and angular velocity, common to all sensors.
pub(super) fn inclination(sensor: &str) -> [Output; 3] {
    let number = |variable, description, unit| Output::number(variable, description, "sensor", sensor, unit);
    let angular_velocity = Output {
        components: Components::Axis,
        frame: VectorFrame::Body,
        ..number("measured_angular_velocity", "measured angular velocity of a sensor's body", &["rad/s"])
    };
    [
        number("measured_roll", "measured roll of a sensor's body, positive port side up", &["rad"]),
        number("measured_pitch", "measured pitch of a sensor's body, positive bow down", &["rad"]),
        angular_velocity,
    ]
}

/// Returns the outputs of a measured motion, common to all units.
pub(super) fn motion(sensor: &str, horizontal: bool) -> Vec<Output> {
    let number = |variable, description, unit| Output::number(variable, description, "sensor", sensor, unit);
    let [roll, pitch, angular_velocity] = inclination(sensor);
    let mut outputs = vec![
        roll,
        pitch,
        number("measured_heave", "measured height of a sensor above its height at the start", &["m"]),
        number("measured_heave_rate", "measured vertical velocity of a sensor", &["m/s"]),
        angular_velocity,
    ];
    if horizontal {
        outputs.extend([
            number("measured_x", "measured displacement of a sensor along x of the world from the start", &["m"]),
            number("measured_x_velocity", "measured velocity of a sensor along x of the world", &["m/s"]),
            number("measured_y", "measured displacement of a sensor along y of the world from the start", &["m"]),
            number("measured_y_velocity", "measured velocity of a sensor along y of the world", &["m/s"]),
            number("measured_yaw", "measured yaw of a sensor's body, positive bow to port", &["rad"]),
        ]);
    }
    outputs
}

impl<S: Scalar> HeaveFilter<S> {
    /// Returns 2 zeta w, 1/s.
    fn damping(&self) -> S {
        S::constant(2.0) * self.damping_ratio * self.cutoff
    }
}

impl<S: Scalar> MotionReferenceUnit<S> {
    /// Returns the number of its signals, with or without horizontal motion.
    pub fn signals(horizontal: bool) -> usize {
        if horizontal { COUNT } else { VERTICAL_ONLY }
    }

    fn filtered(&self) -> usize {
        if self.horizontal { 3 } else { 1 }
    }

    /// Returns the exact motion relative to its zeros.
    fn exact(&self, at: &Context<'_, S>, zeros: &[S]) -> [S; COUNT] {
        let motion = self.place.motion(at);
        let [roll, pitch, yaw] = roll_pitch_yaw(&motion.frame.rotation).0;
        let [x, y, z] = motion.twist.angular.0;
        let mut all = [S::ZERO; COUNT];
        for axis in 0..self.filtered() {
            let ([place, velocity], along) = (PAIRS[axis], AXES[axis]);
            all[place] = motion.frame.position[along] - zeros[axis];
            all[velocity] = motion.frame.rotation.row(along).dot(motion.twist.linear);
        }
        (all[0], all[1], all[COUNT - 1]) = (roll, pitch, yaw);
        [all[4], all[5], all[6]] = [x, y, z];
        all
    }

    /// Returns the measured motion: without the part removed by the filter, with the part restored by a receiver.
    fn measured(&self, at: &Context<'_, S>, numbers: &[S], states: &[S]) -> [S; COUNT] {
        let (mut all, count) = (self.exact(at, numbers), self.filtered());
        let Some(filter) = &self.heave_filter else { return all };
        for (axis, [place, velocity]) in PAIRS[..count].iter().enumerate() {
            all[*place] -= states[2 * axis];
            all[*velocity] -= states[2 * axis + 1];
            if self.receiver.is_some() {
                let restored = &states[2 * (count + axis)..];
                all[*place] += restored[0];
                all[*velocity] += restored[1] + filter.damping() * self.given(at, numbers, axis);
            }
        }
        all
    }

    /// Returns g of an axis, extrapolated from the last position of the receiver, m.
    fn given(&self, at: &Context<'_, S>, numbers: &[S], axis: usize) -> S {
        let (count, next) = (self.filtered(), at.modes.last().copied().unwrap_or_default());
        let since_s = self.receiver.as_ref().map_or(0.0, |receiver| receiver.since_fix_s(at.clock.time_s, next));
        numbers[count + axis] + S::constant(since_s) * numbers[2 * count + axis]
    }

    /// Returns the position of the unit from a receiver's, world axes, with the measured angles and their errors.
    fn fix(&self, receiver: &PositionAid<S>, time_s: f64, read: &[S], found: &[S; COUNT]) -> Vector3<S> {
        let with_errors = |signal: usize| self.sampler.now(time_s, signal, found[signal]);
        let yaw = if self.horizontal { with_errors(COUNT - 1) } else { S::ZERO };
        let rotation = rotation_from_roll_pitch_yaw(Vector3([with_errors(0), with_errors(1), yaw]));
        let velocity = Vector3([found[8], found[10], found[3]]);
        receiver.fix(read, (rotation, Vector3([4, 5, 6].map(with_errors))), velocity)
    }
}
