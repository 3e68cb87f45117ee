//! Fields of a learned policy.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{ColumnName, Positive, SetsInputs, SignalName, yes};

/// Sets inputs by a multilayer perceptron with tanh: `o = (columns - reference) / scale`, clipped to 10 on either side,
/// `a = tanh(W_n ... tanh(W_1 o + b_1) + b_n)`, and the input is its command plus the value between lower (at a = -1)
/// and upper (at a = 1).
#[fields]
pub struct Policy<S = f64> {
    /// Whether the controller acts; if not, its commands pass unchanged.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// Columns that it reads, in the order of the columns of the first layer's weights.
    pub reads: Vec<PolicyRead<S>>,
    /// The inputs that it sets. The command of a single input has the controller's name; with several inputs, each
    /// command is named `name.input`.
    pub steers: Vec<PolicySteer<S>>,
    /// The layers, from the first to the last.
    pub layers: Vec<PolicyLayer<S>>,
    /// Time between two samples, s: a whole number of steps; without it, one step.
    pub period_s: Option<Positive>,
}

/// An observation of a policy.
#[fields]
pub struct PolicyRead<S = f64> {
    /// The column of the results, or a state of a drive by its name in the linear analysis.
    pub column: ColumnName,
    /// Columns of the same unit that are added to it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<AlsoRead>,
    /// Value of the column at which the observation is 0, in the column's SI unit.
    #[serde(default)]
    pub reference: S,
    /// Difference from the reference at which the observation is 1, in the column's SI unit.
    #[serde(default = "one::<S>")]
    pub scale: Positive<S>,
}

/// A column that is added to another.
#[fields]
pub struct AlsoRead {
    /// The column.
    pub column: ColumnName,
}

/// An input that a policy sets.
#[fields]
pub struct PolicySteer<S = f64> {
    /// The input.
    pub to: SignalName,
    /// Value of the input at the action -1, in its SI unit; without it, the smallest allowed value.
    pub lower: Option<S>,
    /// Value of the input at the action 1, in its SI unit; without it, the largest allowed value.
    pub upper: Option<S>,
}

/// A layer of a policy: tanh(W x + b).
#[fields]
pub struct PolicyLayer<S = f64> {
    /// W: a row for each output, a number for each input.
    pub weights: Vec<Vec<S>>,
    /// b: a number for each output.
    pub biases: Vec<S>,
}

fn one<S: Leaf>() -> Positive<S> {
    Positive::literal(1.0)
}

impl<S> SetsInputs for Policy<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        self.steers.iter().enumerate().map(|(k, steer)| (format!("steers.{k}.to"), &*steer.to)).collect()
    }
}
