//! Commands that are functions of time.

use kingpost_derive::fields;

use crate::scenario::schema::{NonNegative, Positive, SetsInputs, SignalName, yes};

/// Sets an input to its command plus a smooth curve through given commands at given times. `kingpost.drive_functions`
/// computes commands that hold a load in place.
#[fields]
pub struct DriveFunction<S = f64> {
    /// Whether the function is added; if not, the command passes unchanged.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The input that it sets: of a drive, or the command of another controller.
    pub to: SignalName,
    /// Times of the curve's points in increasing order, s.
    pub time_s: Vec<NonNegative>,
    /// The command at each time, in the SI unit of the input.
    pub command: Vec<S>,
    /// Period after which the curve repeats, s: all times are within one period. Without it, the first command holds
    /// before the first time, and the last command after the last time.
    pub period_s: Option<Positive>,
    /// Duration of the ramp at the start of a run, s, over which the curve grows from 0 to full size like waves over
    /// the `ramp_s` of the sea; 0: full size at once.
    #[serde(default)]
    pub ramp_s: NonNegative,
}

impl<S> SetsInputs for DriveFunction<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        vec![("to".to_owned(), &*self.to)]
    }
}
