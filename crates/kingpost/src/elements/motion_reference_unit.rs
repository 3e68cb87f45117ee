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
    /// Its sampling of the seven signals.
    pub sampler: Sampler<S>,
    /// The filter of heave and its rate; without it they are the motion itself.
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

/// Roll, pitch, heave, heave rate, angular velocity.
const COUNT: usize = 7;
const KEPT: [&str; COUNT] = ["roll", "pitch", "heave", "heave_rate", "x_rate", "y_rate", "z_rate"];

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
        let removed = [ElementState::memory("removed_heave", "m"), ElementState::memory("removed_heave_rate", "m/s")];
        let outputs = vec![
            number("measured_roll", "measured roll of a sensor's body, positive port side up", &["rad"]),
            number("measured_pitch", "measured pitch of a sensor's body, positive bow down", &["rad"]),
            number("measured_heave", "measured height of a sensor above its height at the start", &["m"]),
            number("measured_heave_rate", "measured vertical velocity of a sensor", &["m/s"]),
            angular_velocity,
        ];
        let mut declaration = self.sampler.declaration(&self.name, &KEPT, outputs);
        declaration.numbers.push("zero_height".to_owned());
        Declaration { states: removed.into_iter().filter(|_| self.heave_filter.is_some()).collect(), ..declaration }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        let zero_height = self.height(at);
        own.numbers[self.sampler.numbers()] = zero_height;
        if let [removed, rate] = own.states {
            (*removed, *rate) = (S::ZERO, self.measured(at, zero_height, &[])[3]);
        }
        let first = self.measured(at, zero_height, own.states);
        self.sampler.begin(own, &first);
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        if let (Some(filter), [removed, rate]) = (&self.heave_filter, at.states) {
            let [_, _, heave, heave_rate, ..] = self.measured(at, at.numbers[self.sampler.numbers()], &[]);
            let two = S::constant(2.0);
            rates[0] = *rate;
            rates[1] = two * filter.damping_ratio * filter.cutoff * (heave_rate - *rate)
                + filter.cutoff * filter.cutoff * (heave - *removed);
        }
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        let now = self.measured(at, own.numbers[self.sampler.numbers()], own.states);
        self.sampler.take(at.clock.time_s, own, &now);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.sampler.outputs(at.numbers, at.modes, out);
    }
}

impl<S: Scalar> MotionReferenceUnit<S> {
    fn height(&self, at: &Context<'_, S>) -> S {
        self.place.frame(at.model, at.links).position[2]
    }

    /// The motion, less the removed heave and its rate if there are any.
    fn measured(&self, at: &Context<'_, S>, zero_height: S, removed: &[S]) -> [S; COUNT] {
        let motion = self.place.motion(at);
        let [roll, pitch, _] = roll_pitch_yaw(&motion.frame.rotation).0;
        let [x, y, z] = motion.twist.angular.0;
        let mut heave = motion.frame.position[2] - zero_height;
        let mut heave_rate = motion.frame.rotation.row(2).dot(motion.twist.linear);
        if let [removed, rate] = removed {
            (heave, heave_rate) = (heave - *removed, heave_rate - *rate);
        }
        [roll, pitch, heave, heave_rate, x, y, z]
    }
}
