//! Controllers: each stands before an input, takes its command and sets it.

use kingpost_derive::fields;

use crate::scenario::schema::{
    DriveFunction, HeaveCompensation, HeaveForecast, InputShaper, PlatformCompensation, Policy, Selector,
    StateFeedback, ThreeAxisCompensation,
};

/// Controller between a command, of a user or of the operation, and an input. Its own command is an input with its
/// name. A controller may stand before another.
// `assembled`: each kind assembles its elements in its room, by `Assemble` in `elements/KIND/assembly.rs`.
#[fields(assembled, sets_inputs)]
pub enum Controller<S = f64> {
    /// Shapes a command so that it leaves no swing.
    InputShaper(InputShaper<S>),
    /// Adds a function of time to a command.
    DriveFunction(DriveFunction<S>),
    /// Feeds columns of the results back to inputs.
    StateFeedback(StateFeedback<S>),
    /// A small neural network reads columns of the results and sets inputs.
    Policy(Policy<S>),
    /// Passes one of several commands for the same inputs.
    Selector(Selector),
    /// A winch pays out what the crane's tip rises, so that the load keeps its height.
    HeaveCompensation(HeaveCompensation<S>),
    /// Slewing and luffing hold the crane's tip over a point of the world, the winch the load's height.
    ThreeAxisCompensation(ThreeAxisCompensation<S>),
    /// Driven joints below the pedestal keep it level and at its height.
    PlatformCompensation(PlatformCompensation<S>),
    /// Predicts the heave of a point, for operations that wait for a lull; it sets no input.
    HeaveForecast(HeaveForecast<S>),
}
