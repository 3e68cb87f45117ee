//! A motion reference unit: a sensor of a body's motion, with its own sampling period.

use super::hull::HullFrame;
use super::{Components, Context, Declaration, Delay, Element, Output, Own, VectorFrame};
use crate::scalar::Scalar;
use crate::spatial::roll_pitch_yaw;

/// Measures the motion of a point of a body every `period_s`, and outputs it some samples later.
///
/// Heave is the height of the point relative to the start of the run. The outputs are constant between two samples;
/// until the first delayed value arrives they are those measured at the start.
#[derive(Clone, Debug)]
pub struct MotionReferenceUnit<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the point.
    pub place: HullFrame<S>,
    /// Sampling period, s.
    pub period_s: f64,
    /// Delay of its outputs, in samples.
    pub delay_samples: usize,
}

/// Roll, pitch, heave, heave rate, angular velocity.
const COUNT: usize = 7;

/// Its outputs, then the reference height of heave, then a ring buffer for each number.
const ZERO_HEIGHT: usize = COUNT;
const RINGS: usize = COUNT + 1;

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
        let kept = ["roll", "pitch", "heave", "heave_rate", "x_rate", "y_rate", "z_rate"];
        let late = |name: &&str| (0..self.delay_samples).map(|tick| format!("{name}_{tick}")).collect::<Vec<_>>();
        let numbers = kept.iter().map(ToString::to_string).chain(["zero_height".to_owned()]);
        Declaration {
            numbers: numbers.chain(kept.iter().flat_map(late)).collect(),
            modes: if self.delay_samples > 0 { kept.map(|name| format!("{name}_oldest")).to_vec() } else { Vec::new() },
            outputs: vec![
                number("measured_roll", "measured roll of a sensor's body, positive port side up", &["rad"]),
                number("measured_pitch", "measured pitch of a sensor's body, positive bow down", &["rad"]),
                number("measured_heave", "measured height of a sensor above its height at the start", &["m"]),
                number("measured_heave_rate", "measured vertical velocity of a sensor", &["m/s"]),
                angular_velocity,
            ],
            period_s: Some(self.period_s),
            ..Declaration::default()
        }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        own.numbers[ZERO_HEIGHT] = self.height(at);
        let first = self.measured(at, own.numbers[ZERO_HEIGHT]);
        own.numbers[..COUNT].copy_from_slice(&first);
        for (k, value) in first.into_iter().enumerate() {
            own.numbers[RINGS + k * self.delay_samples..][..self.delay_samples].fill(value);
        }
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut Own<'_, S>) {
        let now = self.measured(at, own.numbers[ZERO_HEIGHT]);
        for (mode, value) in now.into_iter().enumerate() {
            let ring = Delay { first_number: RINGS + mode * self.delay_samples, mode, ticks: self.delay_samples };
            own.numbers[mode] = ring.pass(own, value);
        }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.extend_from_slice(&at.numbers[..COUNT]);
    }
}

impl<S: Scalar> MotionReferenceUnit<S> {
    fn height(&self, at: &Context<'_, S>) -> S {
        self.place.frame(at.model, at.links).position[2]
    }

    fn measured(&self, at: &Context<'_, S>, zero_height: S) -> [S; COUNT] {
        let motion = self.place.motion(at);
        let [roll, pitch, _] = roll_pitch_yaw(&motion.frame.rotation).0;
        let [x, y, z] = motion.twist.angular.0;
        let heave_rate = motion.frame.rotation.row(2).dot(motion.twist.linear);
        [roll, pitch, motion.frame.position[2] - zero_height, heave_rate, x, y, z]
    }
}
