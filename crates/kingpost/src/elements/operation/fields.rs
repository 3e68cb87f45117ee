//! An operation as a timeline, and limits on the results.

use kingpost_derive::fields;

use crate::scenario::schema::{ColumnName, Name, NonNegative, Positive, SignalName, yes};

/// Named steps, one after another: each step moves levers and set-points, and lasts until its condition holds. A user
/// cannot move the inputs that the operation sets.
#[fields]
pub struct Operation<S = f64> {
    /// Whether the operation runs; if not, the user sets the inputs.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The steps.
    pub steps: Vec<OperationStep<S>>,
}

/// A step of an operation.
#[fields]
pub struct OperationStep<S = f64> {
    /// Name of the step, which describes it: "lift off".
    pub name: String,
    /// The inputs that it moves. An input that is not named keeps its value.
    #[serde(default = "none::<S>", skip_serializing_if = "Vec::is_empty")]
    pub set: Vec<InputMove<S>>,
    /// The condition that ends the step; without it, the step ends with its last move.
    pub until: Option<Condition>,
    /// Largest duration of the step, s. After it the run ends and reports the condition that does not hold.
    pub time_out_s: Option<Positive>,
}

/// Moves an input: a lever, a brake, or the offset of a drive's set-point.
#[fields]
pub struct InputMove<S = f64> {
    /// Name of the input, mostly the name of its drive.
    pub input: SignalName,
    /// The new value, in `unit`.
    pub to: S,
    /// Unit of `to`: the input's SI unit (rad, m, rad/s, m/s, N m, N, 1), or deg, deg/s, kN m, kN instead; without it,
    /// the SI unit.
    pub unit: Option<String>,
    /// When the move begins, s after the start of the step.
    #[serde(default)]
    pub at_s: NonNegative,
    /// Duration of the linear move from the input's present value, s; 0 for a jump.
    #[serde(default)]
    pub in_s: NonNegative,
}

/// The condition that ends a step of an operation.
#[fields]
pub enum Condition {
    /// The step has lasted this long, s.
    AfterS(NonNegative),
    /// A column of the results is in a range.
    Value(ColumnRange),
    /// All of these hold at once.
    All(Vec<Condition>),
    /// One of these holds.
    Any(Vec<Condition>),
    /// A condition has held without a break for a time.
    Holds(Box<HoldingCondition>),
    /// A condition has begun to hold a number of times: at the third touch.
    Count(Box<CountedCondition>),
    /// The heave stays below a bound for the next seconds, by a forecast.
    Lull(Lull),
}

/// A lull: the bound of a forecast of the heave is low. Its error counts: no lull before the forecast is ready.
#[fields]
pub struct Lull {
    /// The controller of the kind `heave_forecast`. Its `horizon_s` is the length of the lull.
    pub forecast: Name,
    /// The heave, m: `predicted_heave_bound` is below it.
    pub below_m: Positive,
}

/// A condition that holds without a break for a time.
#[fields]
pub struct HoldingCondition {
    /// The time, s.
    pub for_s: Positive,
    /// The condition.
    pub condition: Condition,
}

/// A condition that begins to hold a number of times since the start of the step.
#[fields]
pub struct CountedCondition {
    /// The number; a condition that holds at the start of the step has begun once.
    pub times: u32,
    /// The condition.
    pub condition: Condition,
}

/// A range of a column of the results: above a bound, below one, or both. A bound is a number or another column.
#[fields]
pub struct ColumnRange {
    /// The column by its name in the table of results: `hook.position.z`, `hoist_rope.rope_tension`.
    pub column: ColumnName,
    /// The value is above this.
    pub above: Option<f64>,
    /// The value is below this.
    pub below: Option<f64>,
    /// The value is above that of this column, which has the same unit.
    pub above_column: Option<ColumnName>,
    /// The value is below that of this column, which has the same unit.
    pub below_column: Option<ColumnName>,
    /// Unit of the bounds: the column's SI unit, or deg, deg/s, kN, kN m, t and so on instead; without it, the SI unit.
    pub unit: Option<String>,
}

/// A task for whoever moves the levers: stages, one after another. It is done when the last stage ends, and failed when a
/// limit of the scenario is exceeded before.
#[fields]
pub struct Task<S = f64> {
    /// Whether the task is set.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The task in one sentence: "Set the box down on the mark, softer than 0.3 m/s."
    pub text: String,
    /// The stages.
    pub stages: Vec<TaskStage>,
    /// The mark that views draw at the place to reach.
    pub mark: Option<Mark<S>>,
}

/// A stage of a task.
#[fields]
pub struct TaskStage {
    /// Name of the stage, which describes it: "over the quay".
    pub name: String,
    /// The condition that ends it.
    pub until: Condition,
}

/// A circle on a level surface of a body, or of the world.
#[fields]
pub struct Mark<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// Its centre in the body's drawing frame, m.
    pub position_m: [S; 3],
    /// Its radius, m.
    pub radius_m: Positive<S>,
}

/// A limit on a column of the results. A run reports for each limit whether it held, and the worst value with its time.
#[fields]
pub struct Limit {
    /// Whether the limit is checked.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The column by its name in the table of results: `hull.roll`, `hoist_rope.rope_tension`.
    pub column: ColumnName,
    /// The largest value that is allowed.
    pub at_most: Option<f64>,
    /// The smallest value that is allowed.
    pub at_least: Option<f64>,
    /// The largest absolute value that is allowed.
    pub within: Option<NonNegative>,
    /// Unit of the bounds: the column's SI unit, or deg, deg/s, kN, kN m, t and so on instead; without it, the SI unit.
    pub unit: Option<String>,
    /// Time from which the limit applies, s; without it, from the start.
    #[serde(default)]
    pub from_s: NonNegative,
    /// Time until which the limit applies, s; without it, to the end.
    pub until_s: Option<Positive>,
    /// Names of the steps of the operation in which the limit applies; without them, in all and without an operation.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<String>,
    /// Percentage of the rows of the results that must be within the bounds, above 0 and at most 100: 95 allows values beyond a
    /// bound for 5 % of the time. Without it, all rows.
    pub percentile: Option<Positive>,
}

/// No moves.
const fn none<S>() -> Vec<InputMove<S>> {
    Vec::new()
}
