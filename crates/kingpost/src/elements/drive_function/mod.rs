//! A drive function: a command that is a function of time.

pub(crate) mod assembly;
mod cubic_spline;
pub(crate) mod fields;

pub use cubic_spline::CubicSpline;

use super::commanded::one_command;
use super::{Context, Declaration, Element, ElementState, Input, Occurrence};
use crate::scalar::Scalar;
use crate::sea::waves::ramp;

/// Adds a function of time to its command c and sets another input to the sum,
///
/// ```text
/// u = c + s(t) f(t),    within the limits of the input
/// ```
///
/// f is a cubic spline through given commands at given times, s the same ramp function as that of waves. An input is
/// constant over a step: its value is that of the function at the middle of the step, so that it has no delay. A row of
/// results has the value at its time.
///
/// Drive functions that hold a load in place on a moving base are found as the commands with the smallest deviation of the load
/// (Maczyński & Wojciech, "Stabilization of load's position in offshore cranes", *J. Offshore Mech. Arct. Eng.* 134(2), 2012,
/// 021101).
#[derive(Clone, Debug)]
pub struct DriveFunction<S = f64> {
    /// Name in the results, and of its command.
    pub name: String,
    /// The input that it sets.
    pub to: Input,
    /// f; without it, the command passes unchanged.
    pub function: Option<CubicSpline<S>>,
    /// Length of the ramp, s; 0 without one.
    pub ramp_s: f64,
    /// Length of a step, s.
    pub step_s: f64,
}

impl<S: Scalar> Element<S> for DriveFunction<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        one_command(&self.name, &self.to)
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        _read: &[S],
        _own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        inputs.fill(self.action(at.inputs[0], at.clock.time_s + 0.5 * self.step_s));
        Ok(Vec::new())
    }

    fn at_end(&self, at: &Context<'_, S>, inputs: &mut [S]) {
        inputs.fill(self.action(at.inputs_at_end[0], at.clock.time_s + self.step_s));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.push(self.action(at.inputs[0], at.clock.time_s));
    }

    fn passes_to(&self, command: usize) -> Option<usize> {
        Some(command)
    }
}

impl<S: Scalar> DriveFunction<S> {
    /// Returns u at a time, s.
    fn action(&self, command: S, time_s: f64) -> S {
        let Some(function) = &self.function else { return command };
        let [share, ..] = ramp(time_s, self.ramp_s);
        let action = command + S::constant(share) * function.at(time_s);
        action.clipped(S::constant(self.to.lower), S::constant(self.to.upper))
    }
}
