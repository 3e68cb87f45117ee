//! Parts common to all compensations: the lever that switches them on, the reference position from then on, and limits.

use crate::elements::{Context, Input, Output};
use crate::scalar::Scalar;

/// The lever at which a compensation is switched on.
const ON: f64 = 0.5;

/// Modes: the number of the next tick, from 1; whether the sensor has dropped out.
pub const NEXT_TICK: usize = 0;
pub const SENSOR_OUT: usize = 1;

/// Names of the modes.
pub fn modes() -> Vec<String> {
    ["next_tick", "sensor_out"].map(str::to_owned).to_vec()
}

/// Returns the lever of the controller with this name.
pub fn lever(name: &str, begins_on: bool) -> Input {
    Input::lever(name, 0.0, if begins_on { 1.0 } else { 0.0 })
}

/// Returns the input for a speed that an operator commands, m/s, up to `fastest` in both directions.
pub fn operator_speed(name: &str, what: &str, fastest: f64) -> Input {
    Input { name: format!("{name}.{what}"), unit: "m/s", lower: -fastest, upper: fastest, value: 0.0, signal: None }
}

/// Returns the output of every compensation with the utilisation of its drives.
pub fn utilisation(name: &str) -> Output {
    let what = "largest ratio of the speed that a compensation needs from a drive to the drive's limit; above 1 the drive does not reach it";
    Output::number("compensation_utilisation", what, "controller", name, &["1"])
}

/// Whether the controller has begun, 1 or 0.
pub fn begun<S: Scalar>(at: &Context<'_, S>) -> S {
    S::constant(if at.modes[NEXT_TICK] == 0 { 0.0 } else { 1.0 })
}

/// The state of the lever at a tick.
#[derive(Clone, Copy, Debug)]
pub struct Lever<S> {
    /// Whether it is on, 1 or 0.
    pub on: S,
    /// Whether the present position becomes the reference position, 1 or 0.
    resets: S,
}

impl<S: Scalar> Lever<S> {
    /// Returns the state of a lever at this position; `begins` is true at the first tick.
    pub fn at(position: S, begins: bool, was_on: S) -> Self {
        let on = position.select_below(ON, || S::ZERO, || S::ONE);
        Self { on, resets: if begins { S::ONE } else { on * (S::ONE - was_on) } }
    }

    /// Sets a stored reference to `value` at the tick at which the lever is switched on.
    pub fn renew(self, kept: &mut S, value: S) {
        let before = *kept;
        *kept = self.resets.select_below(ON, || before, || value);
    }
}

/// Returns the magnitude of a speed over its limit.
pub fn share<S: Scalar>(speed: S, limit: S) -> S {
    let share = speed / limit;
    share.select_below(0.0, || -share, || share)
}

/// Returns the part of an operator's speed that is reached if the drive does not reach `excess` of the total speed.
pub fn reached<S: Scalar>(operator: S, excess: S) -> S {
    let least = operator.select_below(0.0, || operator, || S::ZERO);
    let most = operator.select_below(0.0, || S::ZERO, || operator);
    operator - excess.clipped(least, most)
}
