//! Active heave compensation: a winch or a cylinder pays out rope as the crane's tip rises.

use super::estimate::{Estimator, sensor_changes};
use super::hoist::Hoist;
use super::lever::{self, Lever, NEXT_TICK, SENSOR_OUT, reached, share};
use super::measurement::Measured;
use crate::elements::lines::place;
use crate::elements::ticks::{Due, due};
use crate::elements::{Context, Declaration, Element, ElementState, Occurrence, Output};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Steers the speed of a winch, or of a cylinder that moves sheaves of its rope, at every multiple of its period, so
/// that the load keeps its height while the point from which the rope hangs down moves. With the height z and the
/// vertical velocity v of that point, the rope L let out ([`Hoist`]), n falls of rope, and the operator's lowering
/// speed u (the sum of the controller's input and the drive's set-point),
///
/// ```text
/// e = (z - z_0) + integral of u - (L - L_0) / n
/// L'_wanted / n = f v + g e + u,     within the speed limit of the drive
/// ```
///
/// z_0 and L_0 are z and L when the compensation was switched on. v and z are ideal or from a motion reference unit
/// ([`Measurement`](super::Measurement)). With a prediction, v is predicted over the age of the measurement and half of
/// the period for which the command is held, and the lag of the drive and the high-pass filter of the sensor are
/// inverted ([`FilterBank`](super::FilterBank)). Without limits and with a drive `e^(-s tau) / (1 + T s)`, the ratio of
/// the residual to the motion of the tip, without prediction and feedback, is `|1 - e^(-i w (tau + T_s/2)) sin(w T_s/2)
/// / (w T_s/2) / (1 + i w T)|`.
///
/// At the speed limit, u is reduced to the part that the drive reaches, so that the drive does not catch up afterwards
/// (back-calculation: Astrom & Hagglund, *Advanced PID Control*, 2006, sec. 3.5).
#[derive(Clone, Debug)]
pub struct HeaveCompensation<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Estimator of z and v, with its sampling period T_s.
    pub estimator: Estimator<S>,
    /// The point from which the rope hangs down to the load.
    pub tip: Attachment<S>,
    /// n.
    pub falls: S,
    /// The drum of the winch, or the sheaves that a cylinder moves.
    pub hoist: Hoist<S>,
    /// The drive whose input it sets.
    pub drive: String,
    /// Set-point of the drive in the scenario, rad/s or m/s.
    pub drive_speed: S,
    /// The speed limit of the drive, rad/s or m/s.
    pub drive_limit: S,
    /// f.
    pub feed_forward: S,
    /// g, 1/s.
    pub gain: S,
    /// Whether it is switched on at the start.
    pub begins_on: bool,
}

/// Numbers: whether it was on; z_0, estimated and exact; L_0; the integral of the operator's speed; the wanted speed of
/// the rope over n; v; the wanted speed over its limit; then the numbers of the estimator.
const WAS_ON: usize = 0;
const ZERO: usize = 1;
const TRUE_ZERO: usize = 2;
const PAID_OUT: usize = 3;
const OPERATED: usize = 4;
const WANTED: usize = 5;
const VELOCITY: usize = 6;
const UTILISATION: usize = 7;
const ESTIMATE: usize = 8;
const NUMBERS: [&str; ESTIMATE] = [
    "was_on",
    "zero_height",
    "true_zero_height",
    "zero_paid_out",
    "operated",
    "wanted_speed",
    "tip_velocity",
    "utilisation",
];
/// z of the world.
const UPWARD: usize = 2;

impl<S: Scalar> Element<S> for HeaveCompensation<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "controller", &self.name, unit);
        let fastest = (self.hoist.fastest(self.drive_limit) / self.falls).value();
        let lowering = lever::operator_speed(&self.name, "lowering_speed", fastest);
        Declaration {
            numbers: NUMBERS.iter().map(ToString::to_string).chain(self.estimator.number_names("")).collect(),
            modes: lever::modes(),
            inputs: vec![lever::lever(&self.name, self.begins_on), lowering],
            outputs: vec![
                number(
                    "compensation_residual",
                    "height error of a rope's end under heave compensation, for a rope that does not stretch; \
                     positive: too high",
                    &["m"],
                ),
                number(
                    "compensation_speed",
                    "lowering speed of the load that heave compensation commands; negative: hoisting",
                    &["m/s"],
                ),
                number(
                    "compensation_tip_velocity",
                    "vertical velocity of the crane's tip that heave compensation uses: measured or predicted",
                    &["m/s"],
                ),
                lever::utilisation(&self.name),
            ],
            reads: self.estimator.measurement.columns(),
            steers: vec![self.drive.clone()],
            ..Declaration::default()
        }
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let Some(input) = inputs.first_mut() else { return Ok(Vec::new()) };
        let due = due(at.clock.time_s, self.estimator.period_s, &mut own.modes[NEXT_TICK]);
        let Some(Due { is_first: begins, .. }) = due else { return Ok(Vec::new()) };
        let measured = self.estimator.measurement.measure(at, &self.tip, Vector3::zero(), read);
        let happened = sensor_changes(measured.delivers, SENSOR_OUT, own);
        let [velocity, height] = self.now(&measured, begins, own);
        *input = self.command(at, begins, [velocity, height], own);
        Ok(happened)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let paid_out = (self.hoist.let_out(at).length - at.numbers[PAID_OUT]) / self.falls;
        let risen = self.height(at) - at.numbers[TRUE_ZERO];
        let residual = lever::begun(at) * (risen + at.numbers[OPERATED] - paid_out);
        out.extend([residual, at.numbers[WANTED], at.numbers[VELOCITY], at.numbers[UTILISATION]]);
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out the commands of heave compensation; a run contains them")
    }
}

impl<S: Scalar> HeaveCompensation<S> {
    fn height(&self, at: &Context<'_, S>) -> S {
        place(&self.tip, at.model, at.links)[2]
    }

    /// Returns v and z as the controller uses them: measured or predicted.
    fn now(&self, measured: &Measured<S>, begins: bool, own: &mut ElementState<'_, S>) -> [S; 2] {
        let found = self.estimator.take(measured, UPWARD, begins, &mut own.numbers[ESTIMATE..]);
        let lost = self.estimator.prediction.is_none() && !measured.delivers;
        let by_crane = if lost { S::ZERO } else { measured.by_crane[UPWARD] };
        [found.velocity_for(0) + by_crane, found.position]
    }

    /// Returns the speed for the drive's input, rad/s or m/s.
    fn command(
        &mut self,
        at: &Context<'_, S>,
        begins: bool,
        [velocity, height]: [S; 2],
        own: &mut ElementState<'_, S>,
    ) -> S {
        let numbers = &mut *own.numbers;
        let paid_out = self.hoist.let_out(at);
        let per_speed = self.falls / paid_out.per_position;
        let operator = at.inputs[1] + self.drive_speed / per_speed;
        let lever = Lever::at(at.inputs[0], begins, numbers[WAS_ON]);
        let zeros = [height, self.height(at), paid_out.length, S::ZERO];
        for (place, zero) in [ZERO, TRUE_ZERO, PAID_OUT, OPERATED].into_iter().zip(zeros) {
            lever.renew(&mut numbers[place], zero);
        }
        let error = height - numbers[ZERO] + numbers[OPERATED] - (paid_out.length - numbers[PAID_OUT]) / self.falls;
        let free = lever.on * (self.feed_forward * velocity + self.gain * error) + operator;
        let given = (free * per_speed).clipped(-self.drive_limit, self.drive_limit);
        let excess = free - given / per_speed;
        let period = S::constant(self.estimator.period_s);
        numbers[OPERATED] += period * reached(operator, excess);
        numbers[WAS_ON] = lever.on;
        numbers[WANTED] = given / per_speed;
        numbers[VELOCITY] = velocity;
        numbers[UTILISATION] = share(free * per_speed, self.drive_limit);
        given - self.drive_speed
    }
}
