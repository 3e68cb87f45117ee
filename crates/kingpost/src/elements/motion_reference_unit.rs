//! A motion reference unit: a sensor of a body's motion, with its own sampling period.

use super::hull::HullFrame;
use super::sensing::Sampler;
use super::{Components, Context, Declaration, Element, ElementState, Output, Own, VectorFrame};
use crate::scalar::Scalar;
use crate::spatial::roll_pitch_yaw;

/// Measures the motion of a point of a body at every sample, and outputs it some samples later.
///
/// Heave is the height of the point relative to the start of the run; with a [`HeaveFilter`], its deviation from a slow
/// average. The outputs are constant between two samples; until the first delayed value arrives they are those measured
/// at the start.
#[derive(Clone, Debug)]
pub struct MotionReferenceUnit<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the point.
    pub place: HullFrame<S>,
    /// Whether it also measures its horizontal motion and its yaw.
    pub horizontal: bool,
    /// Its sampling of its signals.
    pub sampler: Sampler<S>,
    /// The filter of heave, of the horizontal motion and of their rates; without it they are the motion itself.
    pub heave_filter: Option<HeaveFilter<S>>,
}

/// Heave as a unit gives it that integrates its accelerations twice: the drift is removed by a high-pass filter,
///
/// ```text
/// y(s) / h(s) = s^2 / (s^2 + 2 zeta w s + w^2)
/// ```
///
/// with w = 2 pi over the cut-off period (Godhavn, "Adaptive tuning of heave filter in motion sensor", OCEANS '98, eqs.
/// 1-4). At the frequency omega it leads by atan2(2 zeta w omega, omega^2 - w^2). The states are the removed part a = h
/// - y and its rate: a'' + 2 zeta w a' + w^2 a = 2 zeta w h' + w^2 h.
#[derive(Clone, Copy, Debug)]
pub struct HeaveFilter<S = f64> {
    /// w, rad/s.
    pub cutoff: S,
    /// zeta.
    pub damping_ratio: S,
}

/// Roll, pitch, heave, heave rate, angular velocity; then what a unit with horizontal motion adds.
const COUNT: usize = 12;
const VERTICAL_ONLY: usize = 7;
const KEPT: [&str; COUNT] =
    ["roll", "pitch", "heave", "heave_rate", "x_rate", "y_rate", "z_rate", "x", "x_velocity", "y", "y_velocity", "yaw"];
/// The axes with a filter in the order of its states: z, then x and y.
const FILTERED: [&str; 3] = ["heave", "x", "y"];

impl<S: Scalar> Element<S> for MotionReferenceUnit<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "sensor", &self.name, unit);
        let angular_velocity = Output {
            components: Components::Axis,
            frame: VectorFrame::Body,
            ..number("measured_angular_velocity", "measured angular velocity of a sensor's body", &["rad/s"])
        };
        let removed = FILTERED[..self.filtered()].iter().flat_map(|axis| {
            let rate = format!("removed_{axis}_rate");
            [ElementState::memory(format!("removed_{axis}"), "m"), ElementState::memory(rate, "m/s")]
        });
        let mut outputs = vec![
            number("measured_roll", "measured roll of a sensor's body, positive port side up", &["rad"]),
            number("measured_pitch", "measured pitch of a sensor's body, positive bow down", &["rad"]),
            number("measured_heave", "measured height of a sensor above its height at the start", &["m"]),
            number("measured_heave_rate", "measured vertical velocity of a sensor", &["m/s"]),
            angular_velocity,
        ];
        if self.horizontal {
            outputs.extend([
                number("measured_x", "measured displacement of a sensor along x of the world from the start", &["m"]),
                number("measured_x_velocity", "measured velocity of a sensor along x of the world", &["m/s"]),
                number("measured_y", "measured displacement of a sensor along y of the world from the start", &["m"]),
                number("measured_y_velocity", "measured velocity of a sensor along y of the world", &["m/s"]),
                number("measured_yaw", "measured yaw of a sensor's body, positive bow to port", &["rad"]),
            ]);
        }
        let mut declaration = self.sampler.declaration(&self.name, &KEPT[..self.sampler.count()], outputs);
        declaration.numbers.extend(ZEROS[..self.filtered()].iter().map(ToString::to_string));
        Declaration { states: removed.filter(|_| self.heave_filter.is_some()).collect(), ..declaration }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        let (zeros, place) = (self.sampler.numbers(), self.place.frame(at.model, at.links).position.0);
        for axis in 0..self.filtered() {
            own.numbers[zeros + axis] = place[AXES[axis]];
        }
        let exact = self.measured(at, &own.numbers[zeros..], &[]);
        for (state, [_, rate]) in own.states.chunks_exact_mut(2).zip(PAIRS) {
            (state[0], state[1]) = (S::ZERO, exact[rate]);
        }
        let first = self.measured(at, &own.numbers[zeros..], own.states);
        self.sampler.begin(own, &first[..self.sampler.count()]);
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let Some(filter) = &self.heave_filter else { return };
        let exact = self.measured(at, &at.numbers[self.sampler.numbers()..], &[]);
        let two = S::constant(2.0);
        for ((rates, removed), [place, velocity]) in rates.chunks_exact_mut(2).zip(at.states.chunks_exact(2)).zip(PAIRS)
        {
            rates[0] = removed[1];
            rates[1] = two * filter.damping_ratio * filter.cutoff * (exact[velocity] - removed[1])
                + filter.cutoff * filter.cutoff * (exact[place] - removed[0]);
        }
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        let now = self.measured(at, &own.numbers[self.sampler.numbers()..], own.states);
        self.sampler.take(at.clock.time_s, own, &now[..self.sampler.count()]);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at.numbers, at.modes, out);
    }
}

/// The axes of the world in the order of the filter's states.
const AXES: [usize; 3] = [2, 0, 1];
/// The signals of each: displacement and velocity.
const PAIRS: [[usize; 2]; 3] = [[2, 3], [7, 8], [9, 10]];
const ZEROS: [&str; 3] = ["zero_height", "zero_x", "zero_y"];

impl<S: Scalar> MotionReferenceUnit<S> {
    /// Number of its signals, with and without horizontal motion.
    pub fn signals(horizontal: bool) -> usize {
        if horizontal { COUNT } else { VERTICAL_ONLY }
    }

    fn filtered(&self) -> usize {
        if self.horizontal { 3 } else { 1 }
    }

    /// The motion from its zeros, less the removed displacements and their rates if there are any.
    fn measured(&self, at: &Context<'_, S>, zeros: &[S], removed: &[S]) -> [S; COUNT] {
        let motion = self.place.motion(at);
        let [roll, pitch, yaw] = roll_pitch_yaw(&motion.frame.rotation).0;
        let [x, y, z] = motion.twist.angular.0;
        let mut all = [S::ZERO; COUNT];
        for axis in 0..self.filtered() {
            let ([place, velocity], along) = (PAIRS[axis], AXES[axis]);
            all[place] = motion.frame.position[along] - zeros[axis];
            all[velocity] = motion.frame.rotation.row(along).dot(motion.twist.linear);
        }
        for (state, [place, velocity]) in removed.chunks_exact(2).zip(PAIRS) {
            (all[place], all[velocity]) = (all[place] - state[0], all[velocity] - state[1]);
        }
        (all[0], all[1], all[COUNT - 1]) = (roll, pitch, yaw);
        [all[4], all[5], all[6]] = [x, y, z];
        all
    }
}
