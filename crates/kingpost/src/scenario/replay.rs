//! Replay: the user's changes of inputs in a run, as a scenario that repeats them.

use super::error::FieldError;
use super::schema::{InputMove, NonNegative, Operation, OperationStep, Positive, Scenario, SignalName};
use crate::simulation::{LeverMove, Simulation};

/// Name of the operation's step that contains the user's changes of inputs.
const STEP: &str = "by hand";

impl Scenario {
    /// Returns the user's changes of inputs in a simulation of this scenario, as an operation: a run with
    /// this operation is bitwise identical.
    ///
    /// It contains the changes since the start or the last reset. Parameters that were set during the run are
    /// not included: see [`Simulation::parameters_set`].
    ///
    /// # Errors
    /// The scenario has an enabled operation: there can be only one.
    pub fn operation_by_hand(&self, simulation: &Simulation) -> Result<Operation, FieldError> {
        if self.operation.as_ref().is_some_and(|operation| operation.enabled) {
            return Err(FieldError::new("operation", "one in the scenario", "operation.enabled: false"));
        }
        let set = simulation.lever_moves().into_iter().filter_map(input_move).collect();
        Ok(Operation {
            enabled: true,
            steps: vec![OperationStep { name: STEP.to_owned(), set, until: None, time_out_s: None }],
        })
    }

    /// Returns this scenario with the user's changes of inputs as its operation; its duration is at least the
    /// present time of the run. If the user has changed nothing, the scenario's own operation is kept.
    ///
    /// Parameters have their present values from the start, even if they were set during the run.
    ///
    /// # Errors
    /// As [`operation_by_hand`](Self::operation_by_hand), if the user has changed an input.
    pub fn replay(&self, simulation: &Simulation) -> Result<Scenario, FieldError> {
        let mut replay = self.clone();
        if !simulation.lever_moves().is_empty() {
            replay.operation = Some(self.operation_by_hand(simulation)?);
            // The operation's steps to which parameters wrote no longer exist.
            let stays = |path: &String| path == "operation.enabled" || !path.starts_with("operation.");
            replay.parameters.iter_mut().for_each(|parameter| parameter.writes.retain(stays));
            replay.parameters.retain(|parameter| !parameter.writes.is_empty());
        }
        if let Some(ran_s) = Positive::new(simulation.time_s()).filter(|ran_s| **ran_s > *self.simulation.duration_s) {
            replay.simulation.duration_s = ran_s;
        }
        Ok(replay)
    }
}

/// The names of levers are valid and times increase, so no change is lost.
fn input_move(LeverMove { time_s, input, value }: LeverMove) -> Option<InputMove> {
    let (input, at_s) = (SignalName::new(input)?, NonNegative::new(time_s)?);
    Some(InputMove { input, to: value, unit: None, at_s, in_s: NonNegative::new(0.0)? })
}
