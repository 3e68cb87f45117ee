//! Fields of a state feedback.

use kingpost_derive::fields;

use crate::scenario::schema::{ColumnName, Positive, SetsInputs, SignalName, yes};

/// Sets inputs to `c - K e - K_I (integral of e)` within limits, with `e = x - reference`, the commands c of the
/// inputs, the columns x that it reads, and the gains K and K_I.
#[fields]
pub struct StateFeedback<S = f64> {
    /// Whether the controller acts; if not, its commands pass unchanged.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The columns that it reads.
    pub reads: Vec<FeedbackRead<S>>,
    /// The inputs that it sets. The command of a single input has the controller's name; with several inputs, each
    /// command is named `name.input`.
    pub steers: Vec<FeedbackSteer<S>>,
    /// Time between two samples, s: a whole number of steps; without it, one step.
    pub period_s: Option<Positive>,
}

/// A column that is fed back.
#[fields]
pub struct FeedbackRead<S = f64> {
    /// The column of the results, such as `slew.joint_position`, or a state of a drive by its name in the linear
    /// analysis, such as `slewing.position`.
    pub column: ColumnName,
    /// Value of the column at which there is no correction, in its SI unit.
    #[serde(default)]
    pub reference: S,
    /// The input in `steers` whose command is added to the reference; both have the same unit.
    pub follows: Option<SignalName>,
}

/// An input that a feedback sets.
#[fields]
pub struct FeedbackSteer<S = f64> {
    /// The input.
    pub to: SignalName,
    /// Row of K: a gain for each column, in the input's unit over the column's.
    pub gains: Vec<S>,
    /// Row of K_I: a gain for the time integral of each column, in the input's unit over the column's and over s.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integral_gains: Vec<S>,
    /// Lower limit of the input's value, in its SI unit; without it, the smallest allowed value.
    pub lower: Option<S>,
    /// Upper limit of the input's value, in its SI unit; without it, the largest allowed value.
    pub upper: Option<S>,
}

impl<S> SetsInputs for StateFeedback<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        self.steers.iter().enumerate().map(|(k, steer)| (format!("steers.{k}.to"), &*steer.to)).collect()
    }
}
