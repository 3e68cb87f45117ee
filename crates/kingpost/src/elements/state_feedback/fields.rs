//! Fields of a state feedback.

use kingpost_derive::fields;

use crate::scenario::schema::{ColumnName, Positive, SetsInputs, SignalName, yes};

/// Sets inputs to `c - K e - K_I (integral of e)`, `e = x - reference`, within limits: c their commands, x the columns that it
/// reads, K and K_I the gains.
#[fields]
pub struct StateFeedback<S = f64> {
    /// Whether the controller acts; if not, its commands pass.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The columns that it reads.
    pub reads: Vec<FeedbackRead<S>>,
    /// The inputs that it sets. The command of a single one has the controller's name, of several `name.input`.
    pub steers: Vec<FeedbackSteer<S>>,
    /// Time between two samples, s: a whole number of steps; without it, one step.
    pub period_s: Option<Positive>,
}

/// A column that is fed back.
#[fields]
pub struct FeedbackRead<S = f64> {
    /// The column of the results, `slew.joint_position`, or a state of a drive as the linear analysis names it,
    /// `slewing.position`.
    pub column: ColumnName,
    /// Its value where nothing is corrected, in its SI unit.
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
    /// Its row of K: a gain for each column, the input's unit over the column's.
    pub gains: Vec<S>,
    /// Its row of K_I: a gain for the integral of each column over time, the input's unit over the column's and over s.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integral_gains: Vec<S>,
    /// The smallest value that it is set to, in its SI unit; without it, the smallest that it can have.
    pub lower: Option<S>,
    /// The largest.
    pub upper: Option<S>,
}

impl<S> SetsInputs for StateFeedback<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        self.steers.iter().enumerate().map(|(k, steer)| (format!("steers.{k}.to"), &*steer.to)).collect()
    }
}
