//! Active heave compensation: a winch pays out what the tip of the crane rises.

mod measurement;
mod predictor;

pub use measurement::{Measured, Measurement};
pub use predictor::{Dynamics, FilterBank, PeriodBand};

use super::lines::place;
use super::ropes::Drum;
use super::ticks::{Due, due};
use super::{Context, Declaration, Element, Input, Output, Own};
use crate::model::Attachment;
use crate::scalar::Scalar;

/// Steers the speed of a winch at every multiple of its period, so that the load keeps its height while the point from
/// which the rope hangs down moves. With the height z and the vertical velocity v of that point, the rope L paid out, n
/// falls of rope, and the lowering speed u that the operator asks for by its input and by the drive's own set-point,
///
/// ```text
/// e = (z - z_0) + integral of u - (L - L_0) / n
/// L'_wanted / n = f v + g e + u,     within the speed limit of the drive
/// ```
///
/// z_0 and L_0 are those when it was switched on. v and z are ideal or from a motion reference unit ([`Measurement`]).
/// With a prediction, v is ahead by the age of the measurement and half of the period for which the command is held,
/// the lag of the drive is inverted, and the high-pass filter of the sensor is undone ([`FilterBank`]). Without limits
/// and with a drive `e^(-s tau) / (1 + T s)`, the share of the motion that is left without prediction and feedback is
/// `|1 - e^(-i w (tau + T_s/2)) sin(w T_s/2) / (w T_s/2) / (1 + i w T)|`.
///
/// At the speed limit the operator's speed counts as far as it is reached, so that nothing is caught up afterwards
/// (back-calculation: Astrom & Hagglund, *Advanced PID Control*, 2006, sec. 3.5).
#[derive(Clone, Debug)]
pub struct HeaveCompensation<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Sampling period T_s, s.
    pub period_s: f64,
    /// Source of z and v.
    pub measurement: Measurement<S>,
    /// Prediction, if it predicts.
    pub prediction: Option<Prediction<S>>,
    /// The point from which the rope hangs down to the load.
    pub tip: Attachment<S>,
    /// n.
    pub falls: S,
    /// The drum of the winch.
    pub drum: Drum<S>,
    /// The drive of the winch, whose input it sets.
    pub drive: String,
    /// The speed that the drive has as its set-point already, rad/s.
    pub drive_speed: S,
    /// The speed limit of the drive, rad/s.
    pub drive_limit: S,
    /// f.
    pub feed_forward: S,
    /// g, 1/s.
    pub gain: S,
    /// Whether it is switched on at the start.
    pub begins_on: bool,
}

/// The weights of a filter bank for each result.
#[derive(Clone, Debug)]
pub struct Prediction<S = f64> {
    /// The bank.
    pub bank: FilterBank,
    /// Rate at which the measured position corrects the measured velocity, k, 1/s; 0 if both are exact. With the
    /// measured position x and velocity v, the complementary filter `s (v + k x) / (s + k)` takes v above k and the rate of x
    /// below, so that neither a bias nor the slow noise of v is integrated (Fossen, 2021, sec. 13.2).
    pub correction: f64,
    /// The velocity to command, from the linear and from the angular part of the measured velocity.
    pub velocity: [Vec<S>; 2],
    /// The position, from both.
    pub position: [Vec<S>; 2],
    /// Share of a velocity that is left at the next tick while the sensor is out: it fades at the middle frequency of the
    /// band.
    pub fades: f64,
}

/// Numbers: whether it was on; z_0, for the controller and in truth; L_0; the operator's length; what the crane's own
/// motion adds to a predicted z; the wanted speed of the rope over n; v; the wanted speed over its limit; then the
/// position that each part of the velocity has led to; then the states of both banks.
const WAS_ON: usize = 0;
const ZERO: usize = 1;
const TRUE_ZERO: usize = 2;
const PAID_OUT: usize = 3;
const OPERATED: usize = 4;
const BY_CRANE: usize = 5;
const WANTED: usize = 6;
const VELOCITY: usize = 7;
const UTILISATION: usize = 8;
const LED_TO: usize = 9;
const BANKS: usize = 11;
const NUMBERS: [&str; BANKS] = [
    "was_on",
    "zero_height",
    "true_zero_height",
    "zero_paid_out",
    "operated",
    "by_crane",
    "wanted_speed",
    "tip_velocity",
    "utilisation",
    "led_to_linear",
    "led_to_angular",
];
/// The modes: the number of the next tick, from 1; whether its sensor has dropped out.
const NEXT_TICK: usize = 0;
const SENSOR_OUT: usize = 1;
/// The lever at which it is switched on.
const ON: f64 = 0.5;

impl<S: Scalar> Element<S> for HeaveCompensation<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "controller", &self.name, unit);
        let fastest = (self.drive_limit * self.drum.radius / self.falls).value();
        let lowering = Input {
            name: format!("{}.lowering_speed", self.name),
            unit: "m/s",
            lower: -fastest,
            upper: fastest,
            value: 0.0,
            signal: None,
        };
        let states = |bank| (0..FilterBank::STATES).map(move |state| format!("bank_{bank}_{state}"));
        let banks = ["linear", "angular"].into_iter().flat_map(states).filter(|_| self.prediction.is_some());
        Declaration {
            numbers: NUMBERS.iter().map(ToString::to_string).chain(banks).collect(),
            modes: vec!["next_tick".to_owned(), "sensor_out".to_owned()],
            inputs: vec![Input::lever(&self.name, 0.0, if self.begins_on { 1.0 } else { 0.0 }), lowering],
            outputs: vec![
                number(
                    "compensation_residual",
                    "height that the end of a rope lacks to that which heave compensation keeps, with a rope that does not stretch; \
                     positive: too high",
                    &["m"],
                ),
                number(
                    "compensation_speed",
                    "speed at which heave compensation asks a winch to lower the load; negative: to hoist it",
                    &["m/s"],
                ),
                number(
                    "compensation_tip_velocity",
                    "vertical velocity of the crane's tip that heave compensation reckons with: measured, or predicted",
                    &["m/s"],
                ),
                number(
                    "compensation_utilisation",
                    "speed that heave compensation needs of a winch over the winch's limit; above 1 it is not given",
                    &["1"],
                ),
            ],
            reads: self.measurement.columns(),
            steers: vec![self.drive.clone()],
            ..Declaration::default()
        }
    }

    fn steer(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut Own<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<String>, String> {
        let Some(input) = inputs.first_mut() else { return Ok(Vec::new()) };
        let due = due(at.clock.time_s, self.period_s, &mut own.modes[NEXT_TICK]);
        let Some(Due { is_first: begins, .. }) = due else { return Ok(Vec::new()) };
        let measured = self.measurement.measure(at, &self.tip, read);
        let happened = sensor_changes(measured.delivers, own);
        let [velocity, height] = self.now(&measured, begins, own);
        *input = self.command(at, begins, [velocity, height, measured.by_crane], own);
        Ok(happened)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let paid_out = (self.drum.paid_out(at).length - at.numbers[PAID_OUT]) / self.falls;
        let begun = S::constant(if at.modes[NEXT_TICK] == 0 { 0.0 } else { 1.0 });
        let risen = self.height(at) - at.numbers[TRUE_ZERO];
        let residual = begun * (risen + at.numbers[OPERATED] - paid_out);
        out.extend([residual, at.numbers[WANTED], at.numbers[VELOCITY], at.numbers[UTILISATION]]);
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the commands of heave compensation, which it gives at its ticks")
    }
}

impl<S: Scalar> HeaveCompensation<S> {
    fn height(&self, at: &Context<'_, S>) -> S {
        place(&self.tip, at.model, at.links)[2]
    }

    /// v and z as the controller takes them: measured, or predicted.
    fn now(&self, measured: &Measured<S>, begins: bool, own: &mut Own<'_, S>) -> [S; 2] {
        let [linear, angular] = measured.velocities;
        let height = measured.heights[0] + measured.heights[1];
        let Some(prediction) = &self.prediction else {
            // A velocity that is held would move the load away: without a sensor the winch only keeps its position.
            let velocity = linear + angular + measured.by_crane;
            return [if measured.delivers { velocity } else { S::ZERO }, height];
        };
        let [mut velocity, mut predicted] = [measured.by_crane, own.numbers[BY_CRANE]];
        for bank in 0..2 {
            let sample = self.corrected(prediction, measured, (bank, begins), own);
            let states = &mut own.numbers[BANKS + bank * FilterBank::STATES..][..FilterBank::STATES];
            prediction.bank.take(states, sample);
            velocity += FilterBank::read(&prediction.velocity[bank], states);
            predicted += FilterBank::read(&prediction.position[bank], states);
        }
        let exact = matches!(self.measurement, Measurement::Ideal);
        [velocity, if exact { height } else { predicted }]
    }

    /// A measured velocity, corrected by the measured position; while the sensor is out, the last one, which fades.
    fn corrected(
        &self,
        prediction: &Prediction<S>,
        measured: &Measured<S>,
        (bank, begins): (usize, bool),
        own: &mut Own<'_, S>,
    ) -> S {
        let last = own.numbers[BANKS + (bank + 1) * FilterBank::STATES - 1];
        let (half, correction) = (S::constant(0.5 * self.period_s), S::constant(prediction.correction));
        // The crane's own motion changes the height by the rotation of the body, too.
        let by_crane = if bank == 1 { measured.by_crane } else { S::ZERO };
        let velocity = if measured.delivers { measured.velocities[bank] } else { last * S::constant(prediction.fades) };
        let led_to = &mut own.numbers[LED_TO + bank];
        if begins {
            *led_to = measured.heights[bank];
            return velocity;
        }
        *led_to += half * (last + velocity + by_crane + by_crane);
        if !measured.delivers {
            return velocity;
        }
        let pull = correction * (measured.heights[bank] - *led_to);
        *led_to += S::constant(self.period_s) * pull;
        velocity + pull
    }

    /// The speed for the drive's input, rad/s.
    fn command(
        &self,
        at: &Context<'_, S>,
        begins: bool,
        [velocity, height, by_crane]: [S; 3],
        own: &mut Own<'_, S>,
    ) -> S {
        let numbers = &mut *own.numbers;
        let paid_out = self.drum.paid_out(at);
        let per_speed = self.falls / paid_out.per_angle;
        let [lever, operator] = [at.inputs[0], at.inputs[1] + self.drive_speed / per_speed];
        let on = lever.select_below(ON, || S::ZERO, || S::ONE);
        let resets = if begins { S::ONE } else { on * (S::ONE - numbers[WAS_ON]) };
        let zeros = [height, self.height(at), paid_out.length, S::ZERO];
        for (place, zero) in [ZERO, TRUE_ZERO, PAID_OUT, OPERATED].into_iter().zip(zeros) {
            let kept = numbers[place];
            numbers[place] = resets.select_below(ON, || kept, || zero);
        }
        let error = height - numbers[ZERO] + numbers[OPERATED] - (paid_out.length - numbers[PAID_OUT]) / self.falls;
        let free = on * (self.feed_forward * velocity + self.gain * error) + operator;
        let given = (free * per_speed).clipped(-self.drive_limit, self.drive_limit);
        let excess = free - given / per_speed;
        let [least, most] =
            [operator.select_below(0.0, || operator, || S::ZERO), operator.select_below(0.0, || S::ZERO, || operator)];
        let period = S::constant(self.period_s);
        numbers[OPERATED] += period * (operator - excess.clipped(least, most));
        numbers[BY_CRANE] += period * by_crane;
        numbers[WAS_ON] = on;
        numbers[WANTED] = given / per_speed;
        numbers[VELOCITY] = velocity;
        let rate = free * per_speed / self.drive_limit;
        numbers[UTILISATION] = rate.select_below(0.0, || -rate, || rate);
        given - self.drive_speed
    }
}

/// What happened to the sensor.
fn sensor_changes<S>(delivers: bool, own: &mut Own<'_, S>) -> Vec<String> {
    let was_out = core::mem::replace(&mut own.modes[SENSOR_OUT], i64::from(!delivers)) == 1;
    match (was_out, delivers) {
        (false, false) => vec!["goes on without its sensor, which has dropped out".to_owned()],
        (true, true) => vec!["has its sensor again".to_owned()],
        _ => Vec::new(),
    }
}
